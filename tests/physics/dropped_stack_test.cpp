// A falling stack stops where it lands: the impact is solved for all of its contacts simultaneously.
#include "support.h"

#include "validation/random_starts.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace cairn_test {
namespace {

struct Fall {
    double rise = 0;  // greatest upward speed of the mean of all boxes, as a fraction of the landing speed
    double aside = 0; // greatest horizontal displacement of the topmost box, in edge lengths
};

// Drops a stack of boxes with edges of 0.1 to 1 m from 0.2 to 3 m, without restitution. Each box is displaced by up to
// 2 % of the edge.
Fall drop_stack(int boxes, RandomStart& random) {
    World world(without_sleep());
    add_ground(world, surface(0.6f));
    const double edge = random.uniform(0.1, 1), height = random.uniform(0.2, 3);
    std::vector<BodyId> ids;
    const auto beside = [&] { return edge * random.uniform(-0.02, 0.02); };
    for (int i = 0; i < boxes; ++i) {
        BodyDef def;
        def.position = {beside(), height + edge * (i + 0.5), beside()};
        ids.push_back(add_body(world, Box{Vec3(float(edge / 2))}, def, surface(0.6f)));
    }
    const double speed = std::sqrt(2 * 9.80665 * height);
    Fall fall;
    for (int i = 0; i < int(60 * speed / 9.80665) + 60; ++i) {
        world.step(1.0f / 60);
        double sum = 0;
        for (const BodyId id : ids) sum += double(world.body(id).linear_velocity().y);
        fall.rise = std::max(fall.rise, sum / boxes / speed);
    }
    const Position top = world.body(ids.back()).position();
    fall.aside = std::hypot(top.x, top.z) / edge;
    return fall;
}

// Checks mean and greatest rebound speed, as fractions of the landing speed, and the sideways displacement over 24
// drops.
void expect_stops(int boxes, RandomStart& random, double mean_rise, double greatest_rise, double aside) {
    double sum = 0;
    for (int i = 0; i < 24; ++i) {
        const Fall fall = drop_stack(boxes, random);
        EXPECT_LT(fall.rise, greatest_rise) << boxes;
        EXPECT_LT(fall.aside, aside) << boxes;
        sum += fall.rise / 24;
    }
    EXPECT_LT(sum, mean_rise) << boxes;
}

TEST(DroppedStack, StopsWhereItLands) {
    RandomStart random(7);
    for (const int boxes : {2, 3, 5, 10}) expect_stops(boxes, random, 0.004, 0.05, 0.05);
}

TEST(DroppedStack, OfTwentyHardlyRises) {
    RandomStart random(8);
    expect_stops(20, random, 0.02, 0.1, 0.1);
}

TEST(DroppedStack, OfFortyHardlyRises) {
    RandomStart random(9);
    expect_stops(40, random, 0.06, 0.15, 0.1);
}

// The initial contact impulses are estimated from the weights, so that a stack that is created at once does not sink
// into itself until the solver has converged, and then spring back.
TEST(DroppedStack, ThatIsMadeAtOnceDoesNotSpringBack) {
    RandomStart random(10);
    for (const int boxes : {10, 20, 40})
        for (int i = 0; i < 8; ++i) {
            World world(without_sleep());
            add_ground(world, surface(0.6f));
            const double edge = random.uniform(0.1, 1);
            const auto beside = [&] { return edge * random.uniform(-0.02, 0.02); };
            std::vector<BodyId> ids;
            for (int k = 0; k < boxes; ++k) {
                BodyDef def;
                def.position = {beside(), edge * (k + 0.5), beside()};
                ids.push_back(add_body(world, Box{Vec3(float(edge / 2))}, def, surface(0.6f)));
            }
            double rise = 0;
            for (int step = 0; step < 60; ++step) {
                world.step(1.0f / 60);
                double sum = 0;
                for (const BodyId id : ids) sum += double(world.body(id).linear_velocity().y);
                rise = std::max(rise, sum / boxes);
            }
            EXPECT_LT(rise, 0.015) << boxes;
        }
}

// Stacks of cylinders, half of them with rounded edges, released with a small gap between each two. The four contact
// points of each pair must span a wide area: when only the deepest ones were chosen, all four lay on the side that was
// pressed in, and columns fell.
TEST(DroppedStack, OfCylindersStands) {
    RandomStart random(2411);
    for (int i = 0; i < 40; ++i) {
        World world(without_sleep());
        add_ground(world, surface(0.6f));
        const int count = 3 + i % 4;
        const double radius = random.uniform(0.1, 0.4), height = radius * random.uniform(1, 2),
                     gap = random.uniform(0.01, 0.06), rounding = i % 2 == 0 ? 0 : 0.05 * radius;
        std::vector<BodyId> ids;
        for (int k = 0; k < count; ++k) {
            BodyDef def;
            const auto beside = [&] { return radius * random.uniform(-0.02, 0.02); };
            def.position = {beside(), 0.5 * height + gap + (height + gap) * k, beside()};
            def.rotation = glm::angleAxis(float(random.uniform(0, 6)), Vec3(0, 1, 0));
            const Cylinder shape{.half_height = float(0.5 * height - rounding),
                                 .radius = float(radius - rounding),
                                 .rounding = float(rounding)};
            ids.push_back(add_body(world, shape, def, surface(0.6f)));
        }
        double least = 1e30, rise = 0;
        for (int step = 0; step < 300; ++step) {
            world.step(1.0f / 60);
            const double energy = world.kinetic_energy() + world.potential_energy();
            if (step > 60) least = std::min(least, energy), rise = std::max(rise, energy - least);
        }
        const double mass = world.body(ids.front()).mass();
        EXPECT_LT(rise, 1e-2 * mass * 9.80665 * height) << i << ": " << count;
        const Position top = world.body(ids.back()).position();
        EXPECT_NEAR(top.y, height * (count - 0.5), 0.01 * height) << i << ": " << count;
        EXPECT_LT(std::hypot(top.x, top.z), 0.8 * radius) << i << ": " << count;
    }
}

} // namespace
} // namespace cairn_test
