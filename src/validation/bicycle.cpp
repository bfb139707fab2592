// An uncontrolled bicycle (row 33): four bodies on three hinges, whose wheels touch the ground with their rims.
#include "validation/cases.h"
#include "validation/measures.h"
#include "validation/random_starts.h"
#include "validation/text.h"
#include "validation/worlds.h"

#include <array>
#include <string>

namespace cairn::validation {
namespace {

// Lean and steer angles, rad, positive to the right, and their rates, rad/s.
using Attitude = std::array<double, 4>;

// Tilt of the steering axis, rad; it meets the ground 8 cm in front of the front wheel's contact.
constexpr double tilt = pi / 10;
constexpr double trail_point = 1.1, rear_radius = 0.3, front_radius = 0.35, wheelbase = 1.02; // m
const glm::dvec3 steering_axis = {std::sin(tilt), -std::cos(tilt), 0};

// M q'' + v C q' + (g K0 + v^2 K2) q = 0: the linearized equations of motion, with the numbers of the benchmark.
Attitude rates(const Attitude& q, double speed) {
    constexpr double m[2][2] = {{80.81722, 2.31941332208709}, {2.31941332208709, 0.29784188199686}},
                     k0[2][2] = {{-80.95, -2.59951685249872}, {-2.59951685249872, -0.80329488458618}},
                     k2[2][2] = {{0, 76.59734589573222}, {0, 2.65431523794604}},
                     c[2][2] = {{0, 33.86641391492494}, {-0.85035641456978, 1.68540397397560}};
    double force[2] = {};
    for (int i = 0; i < 2; ++i)
        for (int k = 0; k < 2; ++k)
            force[i] -= speed * c[i][k] * q[std::size_t(2 + k)] +
                        (gravity * k0[i][k] + speed * speed * k2[i][k]) * q[std::size_t(k)];
    const double determinant = m[0][0] * m[1][1] - m[0][1] * m[1][0];
    return {q[2], q[3], (m[1][1] * force[0] - m[0][1] * force[1]) / determinant,
            (m[0][0] * force[1] - m[1][0] * force[0]) / determinant};
}
Attitude ahead(const Attitude& q, double h, const Attitude& rate) {
    Attitude later = q;
    for (std::size_t i = 0; i < q.size(); ++i) later[i] += h * rate[i];
    return later;
}
// Integrates by Runge-Kutta with a step that is much shorter than necessary.
void advance(Attitude& q, double speed, double time) {
    constexpr int steps = 50;
    const double h = time / steps;
    for (int i = 0; i < steps; ++i) {
        const Attitude a = rates(q, speed), b = rates(ahead(q, h / 2, a), speed), c = rates(ahead(q, h / 2, b), speed),
                       d = rates(ahead(q, h, c), speed);
        for (std::size_t k = 0; k < q.size(); ++k) q[k] += h / 6 * (a[k] + 2 * b[k] + 2 * c[k] + d[k]);
    }
}

// Converts moments of inertia about the axes of the bicycle, x ahead and y up, kg m^2.
MassProperties mass_of(double mass, double xx, double yy, double zz, double xy) {
    const double turn = 0.5 * std::atan2(2 * xy, xx - yy), c = std::cos(turn), s = std::sin(turn);
    MassProperties result;
    result.mass = float(mass);
    result.inertia_diagonal = {float(xx * c * c + 2 * xy * c * s + yy * s * s),
                               float(xx * s * s - 2 * xy * c * s + yy * c * c), float(zz)};
    result.inertia_orientation = glm::angleAxis(float(turn), Vec3(0, 0, 1));
    return result;
}

class Bicycle {
  public:
    Bicycle(double speed, double heading, const glm::dvec3& place)
        : world_(without_sleep()), turn_(glm::angleAxis(heading, glm::dvec3(0, 1, 0))), place_(place), speed_(speed) {
        add_ground(world_, rough());
        rear_ = add({0, rear_radius, 0}, mass_of(2, 0.0603, 0.0603, 0.12, 0), speed / rear_radius);
        frame_ = add({0.3, 0.9, 0}, mass_of(85, 9.2, 2.8, 11, -2.4), 0);
        fork_ = add({0.9, 0.7, 0}, mass_of(4, 0.05892, 0.00708, 0.06, 0.00756), 0);
        front_ = add({wheelbase, front_radius, 0}, mass_of(3, 0.1405, 0.1405, 0.28, 0), speed / front_radius);
        add_wheel(rear_, rear_radius);
        add_wheel(front_, front_radius);
        join(frame_, rear_, {0, rear_radius, 0}, {0, 0, 1});
        join(fork_, front_, {wheelbase, front_radius, 0}, {0, 0, 1});
        steering_ = join(frame_, fork_, {trail_point - 0.9 * std::tan(tilt), 0.9, 0}, steering_axis);
    }

    World& world() { return world_; }
    double speed() { return double(glm::length(world_.body(frame_).linear_velocity())); }
    // Adds an angular velocity in lean, rad/s, to the whole bicycle, about the line that it rides on.
    void push(double rate) {
        const glm::dvec3 way = ahead_of(), base = glm::dvec3(1, 0, 1) * world_.body(rear_).position();
        for (const BodyId id : {rear_, frame_, fork_, front_}) {
            Body body = world_.body(id);
            body.set_linear_velocity(body.linear_velocity() + Vec3(glm::cross(rate * way, body.position() - base)));
            body.set_angular_velocity(body.angular_velocity() + Vec3(rate * way));
        }
    }
    Attitude attitude() {
        const glm::dquat turn(world_.body(frame_).rotation());
        const glm::dvec3 spin(world_.body(frame_).angular_velocity()), fork(world_.body(fork_).angular_velocity());
        return {-std::asin((turn * glm::dvec3(0, 0, 1)).y), double(world_.joint_state(steering_).positions[0]),
                glm::dot(spin, ahead_of()), glm::dot(fork - spin, turn * steering_axis)};
    }

  private:
    glm::dvec3 ahead_of() {
        const glm::dvec3 x = glm::dquat(world_.body(frame_).rotation()) * glm::dvec3(1, 0, 0);
        return glm::normalize(glm::dvec3(x.x, 0, x.z));
    }
    BodyId add(const glm::dvec3& at, const MassProperties& mass, double spin) {
        BodyDef def;
        def.position = place_ + turn_ * at;
        def.rotation = Quat(turn_);
        def.mass_properties = mass;
        def.linear_velocity = Vec3(turn_ * glm::dvec3(speed_, 0, 0));
        def.angular_velocity = Vec3(turn_ * glm::dvec3(0, 0, -spin));
        return world_.create_body(def);
    }
    // Adds a sharp rim in the middle of the wheel: the larger end of a cone.
    void add_wheel(BodyId body, double radius) {
        constexpr float half = 0.02f; // m
        ShapeDef def;
        def.material = rough();
        def.position = {0, 0, half};
        def.rotation = glm::angleAxis(float(pi / 2), Vec3(1, 0, 0));
        world_.add_shape(body, Cylinder{half, float(radius), float(0.9 * radius)}, def);
    }
    JointId join(BodyId a, BodyId b, const glm::dvec3& at, const glm::dvec3& axis) {
        return world_.create_joint(world_.joint_at(a, b, place_ + turn_ * at, Vec3(turn_ * axis), HingeJoint{}));
    }

    World world_;
    glm::dquat turn_;
    glm::dvec3 place_;
    double speed_;
    BodyId rear_, frame_, fork_, front_;
    JointId steering_;
};

struct Ride {
    double lean = 0, steer = 0; // root mean square of the deviation from the equations, relative to theirs
    double energy = 1;          // final energy over the initial one
    Curve measured_lean{"lean", {}, {}, true}, measured_steer{"steer", {}, {}, true};
    Curve expected_lean{"lean, expected", {}, {}}, expected_steer{"steer, expected", {}, {}};
};
// The bicycle rides upright for a second, while its wheels settle, is pushed, and rides on for three seconds.
Ride ride(double speed, double push, RandomStart& random, double dt) {
    Bicycle bicycle(speed, random.uniform(0, 2 * pi), {random.uniform(-50, 50), 0, random.uniform(-50, 50)});
    World& world = bicycle.world();
    run(world, float(dt), steps_in(1, dt));
    bicycle.push(push);
    const double start = world.kinetic_energy() + world.potential_energy(), rides_at = bicycle.speed();
    Attitude expected = bicycle.attitude();
    double squares[4] = {};
    Ride ride;
    const int steps = steps_in(3, dt), shown = std::max(1, steps_in(0.05, dt));
    for (int i = 1; i <= steps; ++i) {
        world.step(float(dt));
        advance(expected, rides_at, dt);
        const Attitude now = bicycle.attitude();
        for (std::size_t k = 0; k < 2; ++k) {
            squares[k] += (now[k] - expected[k]) * (now[k] - expected[k]);
            squares[2 + k] += expected[k] * expected[k];
        }
        if (i % shown != 0) continue;
        const double time = i * dt;
        for (Curve* curve : {&ride.measured_lean, &ride.measured_steer, &ride.expected_lean, &ride.expected_steer})
            curve->x.push_back(time);
        ride.measured_lean.y.push_back(now[0]), ride.measured_steer.y.push_back(now[1]);
        ride.expected_lean.y.push_back(expected[0]), ride.expected_steer.y.push_back(expected[1]);
    }
    ride.lean = std::sqrt(squares[0] / squares[2]), ride.steer = std::sqrt(squares[1] / squares[3]);
    ride.energy = (world.kinetic_energy() + world.potential_energy()) / start;
    return ride;
}

} // namespace

Result measure_bicycle() {
    constexpr int starts = 6;
    Result result;
    Plot plot{"A bicycle at 5 m/s is pushed, and rights itself", "time, s", "rad", false, false, {}};
    for (const double dt : time_steps) {
        RandomStart random(33);
        Farthest lean{0}, steer{0}, energy{1};
        for (int i = 0; i < starts; ++i) {
            const double speed = i == 0 ? 5 : random.uniform(4.5, 6);
            const double push = (i % 2 == 0 ? 1 : -1) * random.uniform(0.02, 0.06);
            const Ride seen = ride(speed, push, random, dt);
            lean.add(seen.lean), steer.add(seen.steer), energy.add(seen.energy);
            if (i > 0 || dt != time_steps[0]) continue;
            plot.curves = {seen.expected_lean, seen.measured_lean, seen.expected_steer, seen.measured_steer};
        }
        result.rows.push_back(
            {"lean, pushed at 4.5 to 6 m/s: root mean square error, relative", dt, 0, lean.value, 0.02, Bar::absolute});
        result.rows.push_back({"steer: root mean square error, relative", dt, 0, steer.value, 0.02, Bar::absolute});
        result.rows.push_back({"energy after 3 s over the initial energy", dt, 1, energy.value, 0.002});
    }
    result.plots.push_back(plot);
    return result;
}

} // namespace cairn::validation
