// Motion without contacts, and impulses on free bodies.
#include "validation/cases.h"
#include "validation/integrators.h"
#include "validation/measures.h"
#include "validation/text.h"
#include "validation/worlds.h"

#include <algorithm>
#include <cmath>

namespace cairn::validation {

namespace {

// Relative error bound: velocities are float, with a rounding error of 6e-8 per step.
constexpr double round_off = 1e-5;

WorldDef settings_with(Integrator integrator) {
    WorldDef def;
    def.integrator = integrator;
    def.substeps = 6; // a fixed number, so that substeps are proportional to the step
    return def;
}

// --- free fall

struct Fall {
    double seconds = 0, substep = 0;
    double way = 0, speed = 0;
    double energy_error = 0;           // J/kg, at the end
    std::vector<double> times, errors; // of energy, at 50 times
};

Fall fall(Integrator integrator, double step, double seconds) {
    World world{settings_with(integrator)};
    constexpr double height = 100;
    BodyDef def;
    def.position = {0, height, 0};
    const BodyId ball = add_body(world, Sphere{}, def);
    Fall result;
    const int steps = steps_in(seconds, step);
    for (int i = 1; i <= steps; ++i) {
        world.step(float(step));
        result.way = height - world.body(ball).position().y;
        result.speed = -double(world.body(ball).linear_velocity().y);
        result.energy_error = 0.5 * result.speed * result.speed - gravity * result.way;
        if (i % std::max(1, steps / 50) != 0) continue;
        result.times.push_back(i * step);
        result.errors.push_back(result.energy_error);
    }
    result.seconds = steps * double(float(step));
    result.substep = double(float(step)) / world.usual_substeps(float(step));
    return result;
}

Plot error_plot(const char* title, const char* y_label) { return {title, "time step, s", y_label, true, true, {}}; }

} // namespace

Result measure_free_fall() {
    constexpr double seconds = 2;
    Result result;
    Plot energy{"Free fall: energy, steps of 1/60 s", "time, s", "energy gained, J/kg", false, false, {}};
    Plot position = error_plot("Free fall: position after 2 s", "error of the position, m");
    Plot final_energy = error_plot("Free fall: energy after 2 s", "error of the energy, J/kg");
    for (const NamedIntegrator& integrator : integrators) {
        for (const double step : time_steps) {
            const Fall f = fall(integrator.kind, step, seconds);
            const double t = f.seconds;
            const double way = 0.5 * gravity * t * t - integrator.offset * gravity * f.substep * t;
            const std::string with = std::string(", ") + integrator.name;
            result.rows.push_back({"distance fallen in 2 s, m" + with, step, way, f.way, round_off, Bar::relative, ""});
            result.rows.push_back(
                {"speed after 2 s, m/s" + with, step, gravity * t, f.speed, round_off, Bar::relative, ""});
        }
        Curve positions{integrator.name, {}, {}, true}, energies = positions;
        for (const double step : sweep) {
            const Fall f = fall(integrator.kind, step, seconds);
            positions.x.push_back(step);
            positions.y.push_back(std::fabs(f.way - 0.5 * gravity * f.seconds * f.seconds));
            energies.x.push_back(step);
            energies.y.push_back(std::fabs(f.energy_error));
        }
        position.curves.push_back(positions);
        final_energy.curves.push_back(energies);
        const Fall f = fall(integrator.kind, 1.0 / 60, seconds);
        energy.curves.push_back({integrator.name, f.times, f.errors, false});
    }
    result.plots = {energy, final_energy, position};
    return result;
}

// --- projectile

namespace {

struct Flight {
    double range = 0, height = 0, time = 0, substep = 0;
    std::vector<double> x, y;
};

constexpr double launch_speed = 20; // m/s, at 45 degrees

Flight throw_ball(const NamedIntegrator& integrator, double step) {
    const double v = double(float(launch_speed * std::sqrt(0.5)));
    World world{settings_with(integrator.kind)};
    BodyDef def;
    def.linear_velocity = {float(v), float(v), 0};
    const BodyId ball = add_body(world, Sphere{}, def);
    Flight flight;
    flight.substep = double(float(step)) / world.usual_substeps(float(step));
    while (flight.time == 0 && world.time() < 4) {
        flight.x.push_back(world.body(ball).position().x);
        flight.y.push_back(world.body(ball).position().y);
        world.step(float(step));
        const Position p = world.body(ball).position();
        // The velocity on the parabola through the discrete points.
        const double v_y = double(world.body(ball).linear_velocity().y) + integrator.offset * gravity * flight.substep;
        flight.height = std::max(flight.height, p.y + (v_y > 0 ? v_y * v_y / (2 * gravity) : 0));
        if (p.y >= 0) continue;
        // Back to where the parabola through the last point meets the ground.
        const double back = (-v_y - std::sqrt(v_y * v_y + 2 * gravity * p.y)) / gravity;
        flight.time = double(world.step_count()) * double(float(step)) - back;
        flight.range = p.x - v * back;
    }
    return flight;
}

} // namespace

Result measure_projectile() {
    const double v = launch_speed * std::sqrt(0.5);
    Result result;
    Plot path{"Projectile: path, steps of 1/60 s", "x, m", "height, m", false, false, {}};
    Plot error = error_plot("Projectile: where it lands", "error of the range, m");
    Curve exact{"expected: y = x - g x^2 / (2 v_x^2)", {}, {}, false};
    for (double x = 0; x <= 2 * v * v / gravity; x += 0.5) {
        exact.x.push_back(x);
        exact.y.push_back(x - gravity * x * x / (2 * v * v));
    }
    path.curves.push_back(exact);
    for (const NamedIntegrator& integrator : integrators) {
        for (const double step : time_steps) {
            const Flight flight = throw_ball(integrator, step);
            // Upward speed of the parabola at the start.
            const double rise = v + integrator.offset * gravity * flight.substep;
            auto add = [&](const char* quantity, double expected, double measured) {
                result.rows.push_back({std::string(quantity) + ", " + integrator.name, step, expected, measured,
                                       round_off, Bar::relative, ""});
            };
            add("range, m", 2 * rise * v / gravity, flight.range);
            add("height, m", rise * rise / (2 * gravity), flight.height);
            add("time of flight, s", 2 * rise / gravity, flight.time);
        }
        Curve ranges{integrator.name, {}, {}, true};
        for (const double step : sweep) {
            ranges.x.push_back(step);
            ranges.y.push_back(std::fabs(throw_ball(integrator, step).range - 2 * v * v / gravity));
        }
        error.curves.push_back(ranges);
    }
    const Flight flight = throw_ball(integrators[0], 1.0 / 60);
    Curve points{"measured, semi-implicit Euler", {}, {}, true};
    for (std::size_t i = 0; i < flight.x.size(); i += 6) {
        points.x.push_back(flight.x[i]);
        points.y.push_back(flight.y[i]);
    }
    path.curves.push_back(points);
    result.plots = {path, error};
    return result;
}

// --- oscillator

namespace {

// A ball of 1 kg on a spring of 1 Hz, which is a force field that attracts in proportion to the distance.
struct Oscillator {
    static constexpr double omega = 2 * pi;
    static constexpr double moment = 1.125; // s, a time when neither position nor velocity is 0
    World world;
    BodyId ball;
    double spring = double(float(omega * omega)); // N/m

    explicit Oscillator(Integrator integrator) : world(settings(integrator)) {
        ForceField field;
        field.kind = ForceField::Kind::radial;
        field.strength = float(spring);
        field.exponent = 1;
        world.add_force_field(field);
        BodyDef def;
        def.mass = 1.0f;
        def.position = {1, 0, 0};
        ball = add_body(world, Sphere{}, def);
    }
    // One substep per step, so that the step is the h of the formulas.
    static WorldDef settings(Integrator integrator) {
        WorldDef def = without_gravity();
        def.integrator = integrator;
        def.substeps = 1;
        def.adaptive_substeps = false;
        def.enable_sleep = false;
        return def;
    }
    double energy() const {
        const double x = world.body(ball).position().x, v = double(world.body(ball).linear_velocity().x);
        return 0.5 * v * v + 0.5 * spring * x * x;
    }
    // Returns the greatest relative change of energy in the given time.
    double energy_error(double step, double seconds) {
        const double start = energy();
        double most = 0;
        for (int i = 0; i < steps_in(seconds, step); ++i) {
            world.step(float(step));
            most = std::max(most, std::fabs(energy() / start - 1));
        }
        return most;
    }
    double position_error(double step, double seconds) {
        run(world, float(step), steps_in(seconds, step));
        const double t = steps_in(seconds, step) * double(float(step));
        return std::fabs(world.body(ball).position().x - std::cos(std::sqrt(spring) * t));
    }
};

void add_explicit_growth(Result& result, double step) {
    Oscillator oscillator(Integrator::explicit_euler);
    const double start = oscillator.energy();
    const int steps = steps_in(2, step);
    run(oscillator.world, float(step), steps);
    result.rows.push_back({"logarithm of the energy growth per step, explicit Euler", step,
                           std::log(1 + oscillator.spring * step * step), std::log(oscillator.energy() / start) / steps,
                           0.01, Bar::relative, ""});
}

// The energy stays in a band of +- omega h / 2 about its mean, regardless of where in the band it starts.
void add_semi_implicit_band(Result& result, double step) {
    Oscillator oscillator(Integrator::semi_implicit_euler);
    double least = oscillator.energy(), most = least;
    for (int i = 0; i < 60000; ++i) {
        oscillator.world.step(float(step));
        const double energy = oscillator.energy();
        least = std::min(least, energy), most = std::max(most, energy);
    }
    result.rows.push_back({"half width of the energy band over 60,000 steps, semi-implicit Euler", step,
                           std::sqrt(oscillator.spring) * step / 2, (most - least) / (most + least), 0.01,
                           Bar::relative, ""});
}

// Measured at 1/60 s only: with 4 times as many steps the loss is 1,000 times smaller, which is below the rounding of
// velocities.
void add_runge_kutta_loss(Result& result) {
    constexpr double step = 1.0 / 60, seconds = 2000;
    Oscillator oscillator(Integrator::rk4);
    const double start = oscillator.energy(), wh = std::sqrt(oscillator.spring) * step;
    run(oscillator.world, float(step), steps_in(seconds, step));
    result.rows.push_back({"relative rate of change of energy, 1/s, Runge-Kutta 4", step, -std::pow(wh, 6) / 72 / step,
                           std::log(oscillator.energy() / start) / seconds, 0.01, Bar::relative, ""});
}

void add_orders(Result& result) {
    auto energy = [](Integrator integrator, double step) { return Oscillator(integrator).energy_error(step, 1); };
    auto position = [](double step) { return Oscillator(Integrator::rk4).position_error(step, Oscillator::moment); };
    constexpr double fine = 1.0 / 8000, coarse = 1.0 / 4000;
    for (int i = 0; i < 2; ++i) {
        const double order = std::log2(energy(integrators[i].kind, coarse) / energy(integrators[i].kind, fine));
        result.rows.push_back({std::string("order of the energy error, ") + integrators[i].name, fine, 1, order, 0.01,
                               Bar::relative, "from 1/4000 to 1/8000 s"});
    }
    result.rows.push_back({"order of the position error, Runge-Kutta 4", 1.0 / 512, 4,
                           std::log2(position(1.0 / 256) / position(1.0 / 512)), 0.01, Bar::relative,
                           "from 1/256 to 1/512 s"});
}

} // namespace

Result measure_oscillator() {
    Result result;
    for (const double step : time_steps) add_explicit_growth(result, step);
    for (const double step : time_steps) add_semi_implicit_band(result, step);
    add_runge_kutta_loss(result);
    add_orders(result);
    Plot history{
        "Oscillator of 1 Hz: energy, steps of 1/60 s", "time, s", "energy / energy at the start", false, true, {}};
    Plot energy = error_plot("Oscillator: energy, greatest error in 1 s", "relative error of the energy");
    Plot position = error_plot("Oscillator: position after 1.125 s", "error of the position, m");
    constexpr double steps[] = {1.0 / 32, 1.0 / 64, 1.0 / 128, 1.0 / 256, 1.0 / 512, 1.0 / 1024, 1.0 / 2048};
    for (const NamedIntegrator& integrator : integrators) {
        Oscillator oscillator(integrator.kind);
        const double start = oscillator.energy();
        Curve line{integrator.name, {0}, {1}, false};
        for (int i = 1; i <= 240; ++i) {
            oscillator.world.step(1.0f / 60);
            line.x.push_back(i / 60.0);
            line.y.push_back(oscillator.energy() / start);
        }
        history.curves.push_back(line);
        Curve energies{integrator.name, {}, {}, true}, positions = energies;
        for (const double step : steps) {
            energies.x.push_back(step);
            energies.y.push_back(Oscillator(integrator.kind).energy_error(step, 1));
            positions.x.push_back(step);
            positions.y.push_back(Oscillator(integrator.kind).position_error(step, Oscillator::moment));
        }
        energy.curves.push_back(energies);
        position.curves.push_back(positions);
    }
    result.plots = {history, energy, position};
    return result;
}

// --- impulses

namespace {

// An impulse at the end of a thin rod: v = J / m, w = 6 J / (m L).
void strike_rod(Result& result, double step) {
    World world{without_gravity()};
    constexpr double mass = 3, length = 2, impulse = 5;
    BodyDef def;
    def.mass_properties = MassProperties{};
    def.mass_properties->mass = float(mass);
    const float inertia = float(mass * length * length / 12);
    def.mass_properties->inertia_diagonal = {inertia * 1e-3f, inertia, inertia};
    const BodyId rod = add_body(world, Box{{float(length / 2), 0.01f, 0.01f}}, def);
    world.body(rod).apply_impulse_at({0, float(impulse), 0}, {length / 2, 0, 0});
    world.step(float(step));
    const double v = double(world.body(rod).linear_velocity().y), w = double(world.body(rod).angular_velocity().z);
    result.rows.push_back(
        {"velocity of a rod struck at its end, m/s", step, impulse / mass, v, round_off, Bar::relative, ""});
    result.rows.push_back(
        {"its angular velocity, rad/s", step, 6 * impulse / (mass * length), w, round_off, Bar::relative, ""});
}

// A box hits a smooth plane with one corner: J = -(1 + e) n.v / (1/m + n.((I^-1 (r x n)) x r)) along the normal n at
// the corner r. Momenta are compared, because angular momentum is constant after the impact, while the angular velocity
// of a rotating box is not.
void drop_box_on_corner(Result& result, double step) {
    constexpr float restitution = 0.5f;
    constexpr double mass = 2;
    World world{without_gravity()};
    add_ground(world, surface(0, restitution));
    BodyDef def;
    def.mass = float(mass);
    def.rotation = glm::normalize(Quat(0.8f, 0.35f, 0.2f, -0.4f));
    def.linear_velocity = {0.3f, -2, 0.1f};
    const Vec3 half{0.5f, 0.3f, 0.2f};
    glm::dvec3 corner{0, 1, 0}; // the lowest corner, relative to the center
    for (int i = 0; i < 8; ++i) {
        const Vec3 local{i & 1 ? half.x : -half.x, i & 2 ? half.y : -half.y, i & 4 ? half.z : -half.z};
        const glm::dvec3 there(def.rotation * local);
        if (there.y < corner.y) corner = there;
    }
    def.position = {0, 0.05 - corner.y, 0};
    const BodyId box = add_body(world, Box{half}, def, surface(0, restitution));
    const glm::dmat3 inverse = glm::inverse(glm::dmat3(world.body(box).world_inertia()));
    const glm::dvec3 n{0, 1, 0}, v0(def.linear_velocity);
    const glm::dvec3 turn = inverse * glm::cross(corner, n);
    const double impulse = -(1 + double(restitution)) * v0.y / (1 / mass + glm::dot(n, glm::cross(turn, corner)));
    for (int i = 0; i < 1000 && world.body(box).linear_velocity().y == def.linear_velocity.y; ++i)
        world.step(float(step));
    const glm::dvec3 v(world.body(box).linear_velocity()), momentum(world.body(box).angular_momentum());
    const glm::dvec3 expected = impulse * glm::cross(corner, n);
    auto add = [&](const char* quantity, double right, double measured) {
        result.rows.push_back({quantity, step, right, measured, round_off, Bar::relative, ""});
    };
    add("vertical velocity of a box after an impact of its corner, m/s", v0.y + impulse / mass, v.y);
    add("its horizontal velocity, m/s", glm::length(glm::dvec2(v0.x, v0.z)), glm::length(glm::dvec2(v.x, v.z)));
    add("its angular momentum, kg m^2/s", glm::length(expected), glm::length(momentum));
    result.rows.push_back({"relative error of its angular momentum", step, 0,
                           glm::length(momentum - expected) / glm::length(expected), round_off, Bar::at_most, ""});
}

} // namespace

Result measure_impulses() {
    Result result;
    for (const double step : time_steps) strike_rod(result, step);
    for (const double step : time_steps) drop_box_on_corner(result, step);
    return result;
}

} // namespace cairn::validation
