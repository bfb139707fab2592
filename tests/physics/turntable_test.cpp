// Bodies that ride at rest on a table that rotates about the vertical. Rolling is covered by the case `turntable` of
// `cairn validate`.
#include "starts.h"
#include "support.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdio>

namespace cairn_test {
namespace {

// Positions in a plan view: x and -z, so that a rotation about +y turns the first axis toward the second.
using Place = std::complex<double>;
Place place_of(const glm::dvec3& p) { return {p.x, -p.z}; }
glm::dvec3 above(Place p, double y) { return {p.real(), y, -p.imag()}; }

void add_table(World& world, const Shape& shape, double rate, float friction) {
    BodyDef def;
    def.type = BodyType::kinematic;
    def.position = {0, -0.1, 0};
    def.angular_velocity = {0, float(rate), 0};
    add_body(world, shape, def, surface(friction));
}

// How far, m, a body on the table has moved toward the axis or away from it in ten seconds.
double creep(const Shape& table, const Shape& rider, double rate, double radius, double angle, int hertz) {
    World world;
    add_table(world, table, rate, 0.6f);
    const Place start = std::polar(radius, angle);
    BodyDef def;
    def.position = above(start, 0.1);
    def.rotation = glm::angleAxis(float(angle), Vec3(0, 1, 0));
    def.linear_velocity = Vec3(above(Place(0, rate) * start, 0));
    def.angular_velocity = {0, float(rate), 0};
    const BodyId body = add_body(world, rider, def, surface(0.6f));
    run(world, 1.0f / float(hertz), 10 * hertz);
    return std::abs(std::abs(place_of(world.body(body).position())) - radius);
}

// When friction matched velocities to those of the table at the end of each substep, by which bodies then moved in the
// next one, riding bodies came up to 6 cm closer to the axis in 10 s.
TEST(Turntable, WhatRidesOnItStaysWhereItIs) {
    Starts starts(5);
    const Shape tables[] = {Cylinder{0.1f, 2}, Box{{2, 0.1f, 2}}};
    const Shape riders[] = {Box{{0.1f, 0.1f, 0.1f}}, Cylinder{0.1f, 0.1f}, Hull(box_corners({0.1f, 0.1f, 0.1f}))};
    double worst = 0;
    for (const Shape& table : tables)
        for (const Shape& rider : riders)
            for (int i = 0; i < 6; ++i) {
                const double rate = starts.between(0.5, 3);
                const double radius = std::min(1.5, 0.8 * 0.6 * 9.81 / (rate * rate)); // 0.8 of the limit of friction
                worst =
                    std::max(worst, creep(table, rider, rate, radius, starts.between(0, 6.2), i % 2 == 0 ? 60 : 240));
            }
    std::printf("crept by %.2g m\n", worst);
    EXPECT_LT(worst, 5e-4);
}

} // namespace
} // namespace cairn_test
