// Torque-free rotation of bodies with three different moments of inertia.
#include "validation/cases.h"
#include "validation/integrators.h"
#include "validation/measures.h"
#include "validation/text.h"
#include "validation/worlds.h"

#include <algorithm>
#include <cmath>

namespace cairn::validation {

namespace {

// The reference solution: Euler's equations, I w' = I w x w in the body's frame and q' = q w / 2, by Runge-Kutta in
// double with a step that is much shorter than necessary.
class Reference {
  public:
    Reference(const glm::dvec3& moments, const glm::dvec3& spin) : moments_(moments), w_(spin) {}

    const glm::dvec3& spin() const { return w_; } // about the body's axes, rad/s
    const glm::dquat& rotation() const { return q_; }
    void advance_to(double time) {
        const int steps = std::max(1, int(std::ceil((time - time_) / 1e-3)));
        for (int i = 0; i < steps; ++i) advance((time - time_) / (steps - i));
    }

  private:
    struct Rate {
        glm::dvec3 w;
        glm::dquat q;
    };
    Rate rate(const glm::dvec3& w, const glm::dquat& q) const {
        return {glm::cross(moments_ * w, w) / moments_, 0.5 * (q * glm::dquat(0, w.x, w.y, w.z))};
    }
    void advance(double h) {
        const Rate a = rate(w_, q_), b = rate(w_ + h / 2 * a.w, q_ + h / 2 * a.q),
                   c = rate(w_ + h / 2 * b.w, q_ + h / 2 * b.q), d = rate(w_ + h * c.w, q_ + h * c.q);
        w_ += h / 6 * (a.w + 2.0 * b.w + 2.0 * c.w + d.w);
        q_ = glm::normalize(q_ + h / 6 * (a.q + 2.0 * b.q + 2.0 * c.q + d.q));
        time_ += h;
    }

    glm::dvec3 moments_, w_;
    glm::dquat q_{1, 0, 0, 0};
    double time_ = 0;
};

// The angle between two rotations, rad.
double angle_between(const glm::dquat& a, const glm::dquat& b) {
    const glm::dquat between = glm::conjugate(a) * b;
    const double sine = std::sqrt(between.x * between.x + between.y * between.y + between.z * between.z);
    return 2 * std::asin(std::min(1.0, sine));
}

// A freely rotating body that starts at the origin with the identity rotation.
struct Thrown {
    BodyDef def;
    Shape shape;
    bool falls;
};

Thrown free_top() {
    BodyDef def;
    def.mass_properties = MassProperties{};
    def.mass_properties->inertia_diagonal = {1, 2, 3};
    def.angular_velocity = {0.01f, 1.0f, 0.01f};
    return {def, Sphere{}, false};
}

Thrown tumbling_box() {
    BodyDef def;
    def.mass = 10.0f;
    def.linear_velocity = {-2, 2, 8};
    def.angular_velocity = {0.1f, 5.0f, 0.1f};
    return {def, Box{{0.05f, 0.2f, 0.45f}}, true};
}

struct Watched {
    double energy = 0, momentum = 0;               // at the start: J, kg m^2/s
    double energy_error = 0, momentum_error = 0;   // greatest, relative to the start
    double position_error = 0, rotation_error = 0; // at the end: m, rad
    std::vector<double> flips;                     // times, s, at which the spin about the middle axis changes its sign
    std::vector<double> times, spins;              // that spin, at 400 times
};

double spin_about_middle_axis(const Body& body) {
    return double((glm::conjugate(body.rotation()) * body.angular_velocity()).y);
}

// The energy of a body in free motion; for a falling body its rotational part only, as free fall has a case of its own.
double rotational_energy(const Body& body) {
    return 0.5 * glm::dot(glm::dvec3(body.angular_momentum()), glm::dvec3(body.angular_velocity()));
}

Reference reference_of(const Body& body) {
    // The body's axes coincide with those of the world and with the principal axes.
    const glm::dmat3 inertia(body.world_inertia());
    return {{inertia[0][0], inertia[1][1], inertia[2][2]}, glm::dvec3(body.angular_velocity())};
}

Watched watch(const Thrown& thrown, Integrator integrator, double step, double seconds) {
    WorldDef settings = thrown.falls ? WorldDef{} : without_gravity();
    settings.integrator = integrator;
    World world{settings};
    const BodyId id = add_body(world, thrown.shape, thrown.def);
    const double dt = double(float(step));
    Reference reference = reference_of(world.body(id));
    Watched result;
    const glm::dvec3 momentum(world.body(id).angular_momentum());
    const double turning = rotational_energy(world.body(id));
    result.energy = world.kinetic_energy();
    result.momentum = glm::length(momentum);
    const int steps = steps_in(seconds, dt);
    for (int i = 1; i <= steps; ++i) {
        const double before = spin_about_middle_axis(world.body(id));
        world.step(float(step));
        const double after = spin_about_middle_axis(world.body(id));
        if (before * after < 0) result.flips.push_back(dt * (i - 1 + before / (before - after)));
        const glm::dvec3 change = glm::dvec3(world.body(id).angular_momentum()) - momentum;
        result.momentum_error = std::max(result.momentum_error, glm::length(change) / result.momentum);
        result.energy_error = std::max(result.energy_error, std::fabs(rotational_energy(world.body(id)) / turning - 1));
        if (i % std::max(1, steps / 400) != 0) continue;
        result.times.push_back(i * dt);
        result.spins.push_back(after);
    }
    const double end = steps * dt;
    reference.advance_to(end);
    result.rotation_error = angle_between(reference.rotation(), glm::dquat(world.body(id).rotation()));
    glm::dvec3 path = end * glm::dvec3(thrown.def.linear_velocity);
    if (thrown.falls) path.y -= 0.5 * gravity * end * end;
    result.position_error = glm::length(world.body(id).position() - path);
    return result;
}

// NaN if there were fewer flips, so that the row fails.
double flip(const Watched& watched, std::size_t index) {
    return index < watched.flips.size() ? watched.flips[index] : std::nan("");
}

Curve reference_curve(const Thrown& thrown, double seconds) {
    World world;
    Reference reference = reference_of(world.body(add_body(world, thrown.shape, thrown.def)));
    Curve curve{"expected: Euler's equations in double", {}, {}, false};
    for (int i = 0; i <= 400; ++i) {
        const double time = seconds * i / 400;
        if (i > 0) reference.advance_to(time);
        curve.x.push_back(time);
        curve.y.push_back(reference.spin().y);
    }
    return curve;
}

Curve spin_curve(const Watched& watched, const char* label, bool as_points) {
    Curve curve{label, {}, {}, as_points};
    for (std::size_t i = 0; i < watched.times.size(); i += as_points ? 8 : 1) {
        curve.x.push_back(watched.times[i]);
        curve.y.push_back(watched.spins[i]);
    }
    return curve;
}

// Plots how well the three integrators keep the conserved quantities, by time step.
void add_plots(Result& result, const Thrown& thrown, double seconds, double error_seconds, const std::string& name) {
    Plot spin{name + ": spin about the intermediate axis, steps of 1/60 s", "time, s", "rad/s", false, false, {}};
    const std::string within = " in " + text(error_seconds) + " s", after = " after " + text(error_seconds) + " s";
    auto error_plot = [&](const std::string& title, const char* y_label) {
        return Plot{title, "time step, s", y_label, true, true, {}};
    };
    Plot energy = error_plot(name + ": rotational energy" + within, "greatest relative error");
    Plot momentum = error_plot(name + ": angular momentum" + within, "greatest relative error");
    Plot rotation = error_plot(name + ": orientation" + after, "error, rad");
    Plot position = error_plot(name + ": position" + after, "error, m");
    spin.curves.push_back(reference_curve(thrown, seconds));
    for (const NamedIntegrator& integrator : integrators) {
        spin.curves.push_back(spin_curve(watch(thrown, integrator.kind, 1.0 / 60, seconds), integrator.name,
                                         integrator.kind != Integrator::explicit_euler));
        Curve energies{integrator.name, {}, {}, true};
        Curve momenta = energies, rotations = energies, positions = energies;
        for (const double step : sweep) {
            const Watched watched = watch(thrown, integrator.kind, step, error_seconds);
            for (Curve* curve : {&energies, &momenta, &rotations, &positions}) curve->x.push_back(step);
            energies.y.push_back(watched.energy_error);
            momenta.y.push_back(watched.momentum_error);
            rotations.y.push_back(watched.rotation_error);
            positions.y.push_back(watched.position_error);
        }
        energy.curves.push_back(energies);
        momentum.curves.push_back(momenta);
        rotation.curves.push_back(rotations);
        position.curves.push_back(positions);
    }
    result.plots = {spin, energy, momentum, rotation};
    if (thrown.falls) result.plots.push_back(position);
}

} // namespace

Result measure_free_top() {
    Result result;
    for (const double step : time_steps) {
        const Watched watched = watch(free_top(), Integrator::semi_implicit_euler, step, 51);
        auto add = [&](const char* quantity, double expected, double measured) {
            result.rows.push_back({quantity, step, expected, measured, 0.01, Bar::relative, ""});
        };
        add("first flip, s", 10.917, flip(watched, 0));
        add("second flip, s", 30.470, flip(watched, 1));
        add("period, s", 39.1057, flip(watched, 2) - flip(watched, 0));
        result.rows.push_back(
            {"relative change of angular momentum in 51 s", step, 0, watched.momentum_error, 1e-4, Bar::at_most, ""});
        result.rows.push_back(
            {"relative change of energy in 51 s", step, 0, watched.energy_error, 1e-4, Bar::at_most, ""});
    }
    add_plots(result, free_top(), 51, 10, "Top");
    return result;
}

Result measure_tumbling_box() {
    Result result;
    for (const double step : time_steps) {
        const Watched watched = watch(tumbling_box(), Integrator::semi_implicit_euler, step, 10);
        if (step == time_steps[0]) {
            result.rows.push_back(
                {"kinetic energy at the start, J", step, 368.54641, watched.energy, 1e-6, Bar::relative, ""});
            result.rows.push_back(
                {"angular momentum at the start, kg m^2/s", step, 3.41765, watched.momentum, 1e-5, Bar::absolute, ""});
        }
        const double flips[] = {1.16596, 4.19438, 7.22280};
        const char* names[] = {"first flip, s", "second flip, s", "third flip, s"};
        for (std::size_t i = 0; i < 3; ++i)
            result.rows.push_back({names[i], step, flips[i], flip(watched, i), 0.01, Bar::relative, ""});
        result.rows.push_back(
            {"relative change of angular momentum in 10 s", step, 0, watched.momentum_error, 1e-4, Bar::at_most, ""});
    }
    add_plots(result, tumbling_box(), 10, 1, "Box");
    return result;
}

} // namespace cairn::validation
