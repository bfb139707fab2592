// A plank on two rollers that spin toward each other slides back and forth (row 37).
#include "validation/cases.h"
#include "validation/measures.h"
#include "validation/random_starts.h"
#include "validation/worlds.h"

#include <string>

namespace cairn::validation {
namespace {

enum class Carriers { rollers, balls, belts };

std::string name_of(Carriers carriers) {
    switch (carriers) {
    case Carriers::rollers:
        return "spinning cylinders";
    case Carriers::balls:
        return "spinning balls";
    case Carriers::belts:
        return "belts over cylinders";
    }
    return {};
}

struct Stand {
    Stand(Carriers kind, RandomStart& random)
        : carriers(kind), half_distance(random.uniform(0.2, 0.6)), friction(random.uniform(0.1, 0.4)),
          radius(random.uniform(0.05, 0.2)), half_height(random.uniform(0.01, 0.04)),
          offset(half_distance * random.uniform(0.1, 0.4)), speed(random.uniform(1.5, 4)),
          heading(glm::angleAxis(random.uniform(0, 2 * pi), glm::dvec3(0, 1, 0))) {}

    Carriers carriers;
    double half_distance, friction, radius, half_height, offset, speed; // m, -, m, m, m, m/s
    glm::dquat heading;

    // Angular frequency, rad/s. The loads on the rollers differ by the offset of the plank, and by the moment of
    // friction, which acts half of the plank's height below its center.
    double frequency() const { return std::sqrt(friction * gravity / (half_distance - friction * half_height)); }
    double half_length() const { return 1.8 * half_distance; }
};

constexpr double plank_half_width = 0.1; // m

void add_carrier(World& world, const Stand& stand, double side) {
    BodyDef def;
    const bool spins = stand.carriers != Carriers::belts;
    def.type = spins ? BodyType::kinematic : BodyType::static_;
    def.position = stand.heading * glm::dvec3(side * stand.half_distance, -stand.radius, 0);
    def.rotation = Quat(stand.heading);
    if (spins) def.angular_velocity = Vec3(stand.heading * glm::dvec3(0, 0, side * stand.speed / stand.radius));
    const BodyId body = world.create_body(def);
    ShapeDef shape;
    shape.material = surface(float(stand.friction));
    shape.material.torsional_friction = 0;
    shape.rotation = glm::angleAxis(float(pi / 2), Vec3(1, 0, 0));
    if (!spins) shape.surface_velocity = {float(-side * stand.speed), 0, 0};
    if (stand.carriers != Carriers::balls) {
        world.add_shape(body, Cylinder{float(2 * plank_half_width), float(stand.radius)}, shape);
        return;
    }
    for (const double z : {-0.8, 0.8}) {
        shape.position = {0, 0, float(z * plank_half_width)};
        world.add_shape(body, Sphere{float(stand.radius)}, shape);
    }
}

// A guide prevents the plank from rotating across the rollers, which friction would cause.
BodyId add_plank(World& world, const Stand& stand) {
    Material material = surface(float(stand.friction));
    material.torsional_friction = 0;
    BodyDef def;
    def.position = stand.heading * glm::dvec3(stand.offset, stand.half_height, 0);
    def.rotation = Quat(stand.heading);
    const BodyId plank = add_body(
        world, Box{{float(stand.half_length()), float(stand.half_height), float(plank_half_width)}}, def, material);
    GeneralJoint guide;
    guide.limits = {{JointAxis::linear, {false, false, true}, 0.0f, 0.0f, {}},
                    {JointAxis::angular, {true, true, false}, 0.0f, 0.0f, {}}};
    JointDef joint;
    joint.body_b = plank;
    joint.frame_a.rotation = Quat(stand.heading);
    joint.joint = guide;
    world.create_joint(joint);
    return plank;
}

struct Swing {
    double period = 0, growth = 0; // s; logarithmic growth of the amplitude per period
    Curve place{"measured", {}, {}, true};
};
Swing swing(const Stand& stand, double dt, int rounds) {
    World world(without_sleep());
    for (const double side : {-1.0, 1.0}) add_carrier(world, stand, side);
    const BodyId plank = add_plank(world, stand);
    Swing run;
    std::vector<double> crossings, greatest(std::size_t(rounds), 0);
    const double round = 2 * pi / stand.frequency();
    double x = stand.offset;
    const int steps = steps_in(rounds * round, dt), shown = std::max(1, steps / 150);
    for (int i = 0; i < steps; ++i) {
        world.step(float(dt));
        const double now = (glm::conjugate(stand.heading) * world.body(plank).position()).x, time = (i + 1) * dt;
        if (x > 0 && now <= 0) crossings.push_back(time + dt * now / (x - now));
        const std::size_t half_on = std::size_t(time / round + 0.5); // intervals from one trough to the next
        if (half_on > 0 && half_on <= greatest.size())
            greatest[half_on - 1] = std::max(greatest[half_on - 1], std::abs(now));
        x = now;
        if (i % shown == 0) run.place.x.push_back(time), run.place.y.push_back(now);
    }
    if (crossings.size() > 1) run.period = (crossings.back() - crossings.front()) / double(crossings.size() - 1);
    run.growth = std::log(greatest[greatest.size() - 2] / greatest[0]) / double(rounds - 2);
    return run;
}

} // namespace

Result measure_rollers() {
    Result result;
    Plot plot{"A plank on two rollers", "time, s", "position, m", false, false, {}};
    for (const double dt : time_steps) {
        for (const Carriers carriers : {Carriers::rollers, Carriers::balls, Carriers::belts}) {
            RandomStart random(37);
            Farthest period{1}, growth;
            for (int i = 0; i < 4; ++i) {
                const Stand stand(carriers, random);
                const Swing run = swing(stand, dt, 6);
                period.add(run.period * stand.frequency() / (2 * pi));
                growth.add(run.growth);
                if (i > 0 || carriers != Carriers::rollers || dt != time_steps[0]) continue;
                Curve expected{"expected (Timoshenko)", {}, {}};
                for (int k = 0; k <= 400; ++k) {
                    expected.x.push_back(run.place.x.back() * k / 400);
                    expected.y.push_back(stand.offset * std::cos(stand.frequency() * expected.x.back()));
                }
                plot.curves = {expected, run.place};
            }
            const std::string on = "on " + name_of(carriers) + ": ";
            result.rows.push_back({on + "period over the expected period", dt, 1, period.value, 0.005});
            result.rows.push_back(
                {on + "relative growth of the amplitude per period", dt, 0, growth.value, 0.02, Bar::absolute});
        }
    }
    result.plots.push_back(plot);
    return result;
}

} // namespace cairn::validation
