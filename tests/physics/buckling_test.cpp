// Contacts must be stiff enough that standing structures do not buckle under their own weight, however small the boxes
// are.
#include "structure.h"

#include <cmath>

namespace cairn_test {
namespace {

// Adds the boxes of a structure of `layers` layers, each displaced sideways by up to 1e-4 of its size.
void build(Structure& made, RandomStart& start, int kind, int layers, double size) {
    const auto put = [&](double x, double y, const glm::dvec3& extents) {
        const double off = 1e-4 * size;
        made.add({size * x + start.uniform(-off, off), size * y, start.uniform(-off, off)}, Vec3(extents * (size / 2)));
    };
    for (int row = 0; row < layers; ++row) {
        if (kind == 0) put(0, row + 0.5, {1, 1, 1});
        if (kind == 1) { // bricks, with half bricks at the ends of every other row
            for (int i = 0; i < 6 - row % 2; ++i) put(2 * i + row % 2, 0.5 * row + 0.25, {2, 0.5, 1});
            if (row % 2 == 1)
                for (const double x : {-0.5, 10.5}) put(x, 0.5 * row + 0.25, {1, 0.5, 1});
        }
        if (kind == 2)
            for (int i = 0; i < layers - row; ++i) put(1.01 * (i + 0.5 * row), row + 0.5, {1, 1, 1});
    }
}

// With softer contacts, a pyramid of 20 rows of 10 cm cubes leaned out of its plane and one of 30 rows fell over, as
// did walls of 10 cm bricks and towers of 20 cubes of 2.5 cm, unless they fell asleep first.
TEST(Buckling, ColumnsWallsAndPyramidsOfAnySizeStandAwake) {
    for (unsigned seed = 0; seed < 12; ++seed) {
        RandomStart start(400 + seed);
        Structure made(start);
        WorldDef settings = made.world.settings();
        settings.enable_sleep = false;
        made.world.set_settings(settings);
        const double size = std::pow(10.0, start.uniform(-1.6, 0));
        const int kind = int(seed % 3), layers = int(start.uniform(14, kind == 0 ? 30 : 22));
        build(made, start, kind, layers, size);
        run(made.world, 1.0f / 60, 600);
        EXPECT_LT(made.way(), 0.1 * size) << "kind " << kind << ", " << layers << " layers of " << size << " m";
    }
}

// A column of n cubes of side a buckles under its own weight if its contacts are softer than Greenhill's formula
// allows. A contact between two cubes of mass m is a spring of stiffness m omega^2 / 2, with omega = 2 pi 7.5 Hz per
// substep of a step of 1/60 s (from 8 substeps on), distributed over four corners at a / 2 from the middle: E I = m
// omega^2 a^3 / 8. The column stands if q H^3 < 7.84 E I, where q = m g / a is the weight per meter.
TEST(Buckling, BeginsWhereTheTheoryOfColumnsHasIt) {
    for (const auto& [count, side] : {std::pair{20, 0.05}, {20, 0.025}, {30, 0.1}, {40, 0.2}}) {
        const double omega = std::sqrt(8 * 9.81 * count * count * count / (7.84 * side)), exact = omega / (15 * pi);
        for (unsigned seed = 0; seed < 3; ++seed)
            for (const double part : {0.75, 1.3}) {
                RandomStart start(500 + seed);
                Structure made(start);
                WorldDef settings = made.world.settings();
                settings.enable_sleep = settings.adaptive_substeps = false;
                settings.substeps = int(std::lround(part * exact));
                made.world.set_settings(settings);
                build(made, start, 0, count, side);
                run(made.world, 1.0f / 60, 1200);
                if (part < 1)
                    EXPECT_GT(made.way(), side) << count << " of " << side << " m, " << settings.substeps;
                else
                    EXPECT_LT(made.way(), 0.1 * count * side) << count << " of " << side << " m, " << settings.substeps;
            }
    }
}

} // namespace
} // namespace cairn_test
