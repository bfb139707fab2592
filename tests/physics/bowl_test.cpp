// Balls that roll and slide in concave meshes (half pipes).
#include "starts.h"
#include "support.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <numbers>
#include <vector>

namespace cairn_test {
namespace {

constexpr double pipe = 2, ball = 0.2; // m, radii

// The lower half of a pipe along z, approximated by `facets` facets. `is_welded`: whether neighboring facets share
// vertices.
Mesh half_pipe(int facets, bool is_welded) {
    std::vector<Vec3> corners;
    std::vector<std::uint32_t> indices;
    const auto add_line = [&](int k) {
        const double angle = std::numbers::pi * (double(k) / facets - 0.5);
        for (const float z : {5.0f, -5.0f})
            corners.push_back({float(pipe * std::sin(angle)), float(pipe * (1 - std::cos(angle))), z});
    };
    for (int k = 0; k < facets; ++k) {
        if (k == 0 || !is_welded) add_line(k);
        add_line(k + 1);
        const auto q = std::uint32_t(corners.size()) - 4;
        for (const std::uint32_t i : {0u, 2u, 3u, 0u, 3u, 1u}) indices.push_back(q + i);
    }
    return Mesh(corners, indices);
}

// The fraction of its energy that a ball retains after two seconds, in which it crosses the pipe and returns.
double energy_left(int facets, bool is_welded, double angle, double friction, int hertz, double heading) {
    const glm::dquat turn = glm::angleAxis(heading, glm::dvec3(0, 1, 0));
    World world;
    BodyDef def;
    def.type = BodyType::static_;
    def.rotation = Quat(turn);
    add_body(world, half_pipe(facets, is_welded), def, surface(friction));
    def.type = BodyType::dynamic;
    def.position = turn * glm::dvec3((pipe - ball) * std::sin(angle), pipe - (pipe - ball) * std::cos(angle), 0.3);
    const Body body = world.body(add_body(world, Sphere{float(ball)}, def, surface(friction)));
    const double lowest = double(body.mass()) * 9.81 * ball; // J
    const double before = world.potential_energy() - lowest;
    run(world, 1.0f / float(hertz), 2 * hertz);
    return (world.kinetic_energy() + world.potential_energy() - lowest) / before;
}

// At a concave edge between two facets no shape can touch the edge itself. Without a check for this, the closest point
// of the facet after next lay on such an edge, which threw the oncoming ball back: it lost half of its energy or more
// in two seconds in pipes of 64 and 256 facets. With contacts found at the start of the step for all of it, the ball
// gained 5 % at 60 Hz. The loss that remains comes from the kinks between facets, each of which costs a fraction equal
// to the square of its angle.
TEST(Bowl, ABallGoesToAndFroInAHalfPipe) {
    Starts starts(9);
    double least = 1, greatest = 1;
    for (const int facets : {64, 128, 256})
        for (const double friction : {0.0, 2.0})
            for (const int hertz : {60, 240})
                for (int i = 0; i < 6; ++i) {
                    const double angle = (i % 2 == 0 ? 1 : -1) * starts.between(0.4, 1.2);
                    const double left =
                        energy_left(facets, i % 3 == 0, angle, friction, hertz, starts.between(0, 6.28));
                    least = std::min(least, left), greatest = std::max(greatest, left);
                }
    std::printf("left %.3f to %.3f\n", least, greatest);
    EXPECT_GT(least, 0.9);
    EXPECT_LT(greatest, 1.002);
}

} // namespace
} // namespace cairn_test
