#include "viewer/palette.h"

#include <gtest/gtest.h>

#include <limits>

namespace {

using namespace cairn;
using namespace cairn::viewer;

float lightness(const Vec3& linear) { return 0.2126f * linear.x + 0.7152f * linear.y + 0.0722f * linear.z; }

TEST(Palette, LightBodiesAreBlueAndHeavyOnesRed) {
    const Vec3 light = mass_ramp(0.0f), heavy = mass_ramp(1.0f);
    EXPECT_GT(light.z, 2.0f * light.x);
    EXPECT_GT(heavy.x, 2.0f * heavy.z);
}

TEST(Palette, MassesLieOnALogarithmicScale) {
    EXPECT_FLOAT_EQ(mass_fraction(1.0f, 1.0f, 100.0f), 0.0f);
    EXPECT_NEAR(mass_fraction(10.0f, 1.0f, 100.0f), 0.5f, 1e-5f);
    EXPECT_FLOAT_EQ(mass_fraction(100.0f, 1.0f, 100.0f), 1.0f);
    EXPECT_FLOAT_EQ(mass_fraction(std::numeric_limits<float>::infinity(), 1.0f, 100.0f), 1.0f);
    EXPECT_FLOAT_EQ(mass_fraction(3.0f, 3.0f, 3.0f), 0.5f); // all masses are equal
}

TEST(Palette, SpeedRampGetsLighterThroughout) {
    for (int i = 0; i < 20; ++i)
        EXPECT_LT(lightness(speed_ramp(float(i) / 20.0f)), lightness(speed_ramp(float(i + 1) / 20.0f)));
}

TEST(Palette, RampsClampWhatLiesOutside) {
    EXPECT_EQ(mass_ramp(-1.0f), mass_ramp(0.0f));
    EXPECT_EQ(speed_ramp(7.0f), speed_ramp(1.0f));
}

TEST(Palette, DisplayColorsComeBack) {
    const Vec3 back = srgb(linear_color(0x4080c0));
    EXPECT_NEAR(back.x, 64.0f / 255.0f, 1e-5f);
    EXPECT_NEAR(back.y, 128.0f / 255.0f, 1e-5f);
    EXPECT_NEAR(back.z, 192.0f / 255.0f, 1e-5f);
}

TEST(Palette, NeighboringCategoriesDiffer) {
    for (std::uint32_t i = 0; i < 50; ++i) {
        const Vec3 difference = category_color(i) - category_color(i + 1);
        EXPECT_GT(difference.x * difference.x + difference.y * difference.y + difference.z * difference.z, 0.01f);
    }
}

} // namespace
