// A box that rides on a rotating table, and a ball that rolls on it (row 31).
#include "validation/cases.h"
#include "validation/measures.h"
#include "validation/random_starts.h"
#include "validation/text.h"
#include "validation/worlds.h"

#include <complex>
#include <string>

namespace cairn::validation {
namespace {

// Positions seen from above: x and -z, so that a rotation about +y goes from the first axis to the second.
using Place = std::complex<double>;
Place place_of(const Position& p) { return {p.x, -p.z}; }
glm::dvec3 above(Place p, double y) { return {p.real(), y, -p.imag()}; }

constexpr double half = 0.1;         // m: half width of the box, radius of the ball
constexpr double starts_per_row = 8; // random positions and orientations

BodyId add_table(World& world, double rate, double friction) {
    BodyDef def;
    def.type = BodyType::kinematic;
    def.position = {0, -half, 0};
    def.angular_velocity = {0, float(rate), 0};
    return add_body(world, Box{{20, float(half), 20}}, def, surface(float(friction)));
}

// The radial displacement of a box in ten seconds, m.
double creep(double rate, double radius, double angle, double dt) {
    World world;
    add_table(world, rate, 0.6);
    const Place start = std::polar(radius, angle);
    BodyDef def;
    def.position = above(start, half);
    def.rotation = glm::angleAxis(float(angle), Vec3(0, 1, 0));
    def.linear_velocity = Vec3(above(Place(0, rate) * start, 0));
    def.angular_velocity = {0, float(rate), 0};
    const BodyId box = add_body(world, Box{{float(half), float(half), float(half)}}, def, surface(0.6f));
    run(world, float(dt), steps_in(10, dt));
    return std::abs(place_of(world.body(box).position())) - radius;
}

struct Roll {
    double radius = 0, rate = 0; // relative to the closed form
    Curve path{"measured", {}, {}, true};
};
// The ball rolls once around.
Roll roll_around(double rate, Place start, Place velocity, double dt) {
    World world;
    add_table(world, rate, 1);
    const Place center = start - velocity / Place(0, rate * 2 / 7);
    const glm::dvec3 slip = above(velocity - Place(0, rate) * start, 0); // the slip of a ball without rotation
    BodyDef def;
    def.position = above(start, half);
    def.linear_velocity = Vec3(above(velocity, 0));
    def.angular_velocity = Vec3(glm::cross(glm::dvec3(0, 1, 0), slip) / half);
    const BodyId ball = add_body(world, Sphere{float(half)}, def, surface(1));
    const int steps = steps_in(2 * pi / (rate * 2 / 7), dt);
    Roll roll;
    double turned = 0;
    Place before = start - center;
    for (int i = 0; i < steps; ++i) {
        world.step(float(dt));
        const Place now = place_of(world.body(ball).position()) - center;
        turned += std::arg(now / before);
        before = now;
        if (i % std::max(1, steps / 40) == 0) {
            roll.path.x.push_back((center + now).real());
            roll.path.y.push_back((center + now).imag());
        }
    }
    roll.radius = std::abs(before) / std::abs(start - center);
    roll.rate = turned / (rate * 2 / 7 * steps * dt);
    return roll;
}

} // namespace

Result measure_turntable() {
    Result result;
    Plot plot{"A ball rolls on a turntable at 3 rad/s", "x, m", "-z, m", false, false, {}};
    for (const double dt : time_steps) {
        RandomStart random(31);
        Farthest creeps{0}, radius{1}, rate{1};
        for (int i = 0; i < int(starts_per_row); ++i) {
            const double table = random.uniform(0.5, 3), angle = random.uniform(0, 2 * pi);
            // At most at 0.8 of the radius at which friction holds the box.
            creeps.add(creep(table, std::min(1.5, 0.8 * 0.6 * gravity / (table * table)), angle, dt));
            const Place start(random.uniform(-1, 1), random.uniform(-1, 1));
            const Place velocity = std::polar(random.uniform(0.2, 1), random.uniform(0, 2 * pi));
            const double turning = i == 0 ? 3 : random.uniform(1, 6);
            const Roll roll = roll_around(turning, start, velocity, dt);
            radius.add(roll.radius), rate.add(roll.rate);
            if (i > 0 || dt != time_steps[0]) continue;
            Curve circle{"closed form", {}, {}};
            const Place center = start - velocity / Place(0, turning * 2 / 7);
            for (int k = 0; k <= 60; ++k) {
                const Place p = center + (start - center) * std::polar(1.0, 2 * pi * k / 60);
                circle.x.push_back(p.real()), circle.y.push_back(p.imag());
            }
            plot.curves.push_back(circle);
            plot.curves.push_back(roll.path);
        }
        result.rows.push_back(
            {"a box rides at 0.5 to 3 rad/s: radial creep in 10 s, m", dt, 0, creeps.value, 5e-4, Bar::absolute});
        result.rows.push_back(
            {"a ball rolls at 1 to 6 rad/s: radius of its circle after one revolution over the expected radius", dt, 1,
             radius.value, 0.002});
        result.rows.push_back(
            {"a ball rolls at 1 to 6 rad/s: rate over 2/7 of the table's rate", dt, 1, rate.value, 0.002});
    }
    result.plots.push_back(plot);
    return result;
}

} // namespace cairn::validation
