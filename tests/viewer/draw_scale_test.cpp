// The rendering resolution as a share of the window's, adapted to the time that frames take.
#include "viewer/draw_scale.h"

#include <gtest/gtest.h>

namespace cairn::viewer {
namespace {

// Simulates a machine that takes `whole` seconds for a frame at full resolution, `fixed` of which do not depend on the
// number of pixels. Returns the final scale.
float after_frames(DrawScale& scale, double whole, double fixed, int count = 100) {
    for (int i = 0; i < count; ++i) {
        const double share = static_cast<double>(scale.value()) * static_cast<double>(scale.value());
        scale.count_frame(fixed + (whole - fixed) * share);
    }
    return scale.value();
}

TEST(DrawScale, FastMachinesDrawAllPixels) {
    DrawScale scale;
    EXPECT_EQ(after_frames(scale, 0.03, 0.0), 1.0f);
}

TEST(DrawScale, SlowOnesDrawAsFewAsTheyMust) {
    DrawScale slow, slower, slowest;
    EXPECT_EQ(after_frames(slow, 0.045, 0.01), 0.75f);
    EXPECT_EQ(after_frames(slower, 0.09, 0.01), 0.5f);
    EXPECT_EQ(after_frames(slowest, 1.0, 0.5), 0.5f);
}

TEST(DrawScale, ItSettles) {
    for (double whole = 0.01; whole < 0.3; whole *= 1.05) {
        DrawScale scale;
        const float settled = after_frames(scale, whole, 0.3 * whole);
        for (int i = 0; i < 100; ++i) EXPECT_EQ(after_frames(scale, whole, 0.3 * whole, 1), settled) << whole;
    }
}

TEST(DrawScale, OneSlowFrameChangesNothing) {
    DrawScale scale;
    after_frames(scale, 0.02, 0.0, 50);
    scale.count_frame(0.1);
    EXPECT_EQ(after_frames(scale, 0.02, 0.0, 50), 1.0f);
}

TEST(DrawScale, AllPixelsComeBackWithAnEasierScene) {
    DrawScale scale;
    EXPECT_EQ(after_frames(scale, 0.09, 0.01), 0.5f);
    EXPECT_EQ(after_frames(scale, 0.02, 0.01), 1.0f);
}

} // namespace
} // namespace cairn::viewer
