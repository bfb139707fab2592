// Structures that are created at once stand where they were created: the impulses of their contacts are estimated from
// the weights in the first step.
#include "structure.h"

#include <cmath>

namespace cairn_test {
namespace {

// Planks of 12 x 2.4 x 0.8 cm, alternately on edge and flat, two per layer. Without that estimate, loads propagated by
// six layers per step: the upper part was in free fall for five steps, and three of eight towers collapsed.
TEST(MadeAtOnce, TowersOfPlanksStand) {
    for (const float hz : {60.0f, 240.0f})
        for (unsigned seed = 0; seed < 12; ++seed) {
            const RandomStart start(seed);
            Structure tower(start);
            double height = 0;
            for (int layer = 0; layer < 25; ++layer) {
                const bool is_on_edge = layer % 2 == 0;
                const double h = is_on_edge ? 0.024 : 0.008, aside = is_on_edge ? 0.056 : 0.048;
                const Vec3 half(0.06f, float(h / 2), is_on_edge ? 0.004f : 0.012f);
                for (const double side : {-aside, aside})
                    tower.add(layer % 2 == 0 ? glm::dvec3(0, height + h / 2, side)
                                             : glm::dvec3(side, height + h / 2, 0),
                              half, layer % 2 == 0 ? 0 : pi / 2);
                height += h;
            }
            run(tower.world, 1 / hz, int(6 * hz));
            EXPECT_LT(tower.way(), 0.01) << seed << ", " << hz << " Hz"; // height of the tower: 41 cm
        }
}

// Columns, cribs and frames, in which each part stands on one other or on two, come to rest where they were created.
// (When the number of substeps followed loads measured while it swung, a crib of 30 layers swung forever.)
TEST(MadeAtOnce, SlenderStructuresStand) {
    for (unsigned seed = 0; seed < 12; ++seed) {
        RandomStart start(200 + seed);
        Structure made(start);
        const double size = std::pow(10.0, start.uniform(-1.3, 0.5));
        const auto half = [&](double x, double y, double z) { return Vec3(glm::dvec3(x, y, z) * (size / 2)); };
        const int kind = int(seed % 3), count = int(start.uniform(8, 30));
        for (int i = 0; i < count; ++i) {
            if (kind == 0) made.add({0, size * (i + 0.5), 0}, half(1, 1, 1));
            if (kind == 1)
                for (const double side : {-1.0, 1.0})
                    made.add(i % 2 == 0 ? glm::dvec3(0, size * 0.2 * (i + 0.5), size * side)
                                        : glm::dvec3(size * side, size * 0.2 * (i + 0.5), 0),
                             i % 2 == 0 ? half(3, 0.2, 0.5) : half(0.5, 0.2, 3));
            if (kind == 2) {
                for (const double side : {-0.8, 0.8})
                    made.add({size * side, size * (1.2 * i + 0.5), 0}, half(0.4, 1, 0.6));
                made.add({0, size * (1.2 * i + 1.1), 0}, half(2.2, 0.2, 0.6));
            }
        }
        run(made.world, 1.0f / 60, 360);
        EXPECT_LT(made.way(), 0.2 * size) << seed;
        EXPECT_TRUE(made.is_asleep()) << seed;
    }
}

} // namespace
} // namespace cairn_test
