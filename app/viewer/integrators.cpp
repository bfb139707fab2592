#include "viewer/integrators.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

namespace cairn::viewer {

namespace {

constexpr double stiffness =
    4.0 * std::numbers::pi * std::numbers::pi;                // 1/s^2, of the spring and of the orbit: a period of 1 s
constexpr double gravity = 9.81, length = 1.0, release = 2.0; // m/s^2, m, rad
constexpr double eccentricity = 0.5;
// Rates of the top, 1/s: one precession and three nutations per second. Their sum is determined by spin and moments of
// inertia, their product by weight and moment of inertia.
constexpr double precession = 2.0 * std::numbers::pi, nutation = 6.0 * std::numbers::pi;
constexpr double gyroscopic = precession + nutation, toppling = precession * nutation;

using Pair = std::array<double, 2>;

Pair plus(const Pair& a, const Pair& b, double factor) { return {a[0] + factor * b[0], a[1] + factor * b[1]}; }

Pair acceleration(LabSystem system, const Pair& place, const Pair& velocity) {
    switch (system) {
    case LabSystem::top:
        return {toppling * place[0] - gyroscopic * velocity[1], toppling * place[1] + gyroscopic * velocity[0]};
    case LabSystem::spring:
        return {-stiffness * place[0], -stiffness * place[1]};
    case LabSystem::pendulum:
        return {-gravity / length * std::sin(place[0]), 0.0};
    case LabSystem::orbit:
        break;
    }
    const double r = std::hypot(place[0], place[1]), pull = -stiffness / (r * r * r);
    return {pull * place[0], pull * place[1]};
}

// The complete elliptic integral of the first kind, by the arithmetic-geometric mean (Abramowitz and Stegun 17.6).
double quarter_period(double k) {
    double a = 1.0, b = std::sqrt(1.0 - k * k);
    while (std::abs(a - b) > 1e-15) {
        const double mean = 0.5 * (a + b);
        b = std::sqrt(a * b);
        a = mean;
    }
    return std::numbers::pi / (2.0 * a);
}

// Jacobi's amplitude of u, by the descending Landen transformation (Abramowitz and Stegun 16.4).
double amplitude(double u, double k) {
    std::array<double, 12> a{1.0}, c{k};
    double b = std::sqrt(1.0 - k * k);
    std::size_t n = 0;
    while (n + 1 < a.size() && std::abs(c[n]) > 1e-15) {
        a[n + 1] = 0.5 * (a[n] + b);
        c[n + 1] = 0.5 * (a[n] - b);
        b = std::sqrt(a[n] * b);
        ++n;
    }
    double phi = std::ldexp(a[n] * u, int(n));
    for (; n > 0; --n) phi = 0.5 * (phi + std::asin(c[n] / a[n] * std::sin(phi)));
    return phi;
}

// sin(angle / 2) = k sn(K + w t): released at rest.
LabState exact_pendulum(double time) {
    const double k = std::sin(0.5 * release), rate = std::sqrt(gravity / length);
    const double phi = amplitude(quarter_period(k) + rate * time, k);
    LabState state;
    state.place[0] = 2.0 * std::asin(k * std::sin(phi));
    state.velocity[0] = 2.0 * k * rate * std::cos(phi);
    return state;
}

// Solves Kepler's equation for the eccentric anomaly by Newton's method.
LabState exact_orbit(double time) {
    const double mean = 2.0 * std::numbers::pi * (time - std::floor(time));
    double anomaly = mean + eccentricity * std::sin(mean);
    for (int i = 0; i < 20; ++i)
        anomaly -= (anomaly - eccentricity * std::sin(anomaly) - mean) / (1.0 - eccentricity * std::cos(anomaly));
    const double minor = std::sqrt(1.0 - eccentricity * eccentricity);
    const double rate = 2.0 * std::numbers::pi / (1.0 - eccentricity * std::cos(anomaly));
    LabState state;
    state.place = {std::cos(anomaly) - eccentricity, minor * std::sin(anomaly)};
    state.velocity = {-rate * std::sin(anomaly), rate * minor * std::cos(anomaly)};
    return state;
}

// The sum of a precession and a nutation circle whose velocities cancel at the start.
LabState exact_top(double time) {
    const double slow = nutation / (nutation - precession), fast = -precession / (nutation - precession);
    LabState state;
    state.place = {slow * std::cos(precession * time) + fast * std::cos(nutation * time),
                   slow * std::sin(precession * time) + fast * std::sin(nutation * time)};
    state.velocity = {-slow * precession * std::sin(precession * time) - fast * nutation * std::sin(nutation * time),
                      slow * precession * std::cos(precession * time) + fast * nutation * std::cos(nutation * time)};
    return state;
}

} // namespace

const char* name_of(LabSystem system) {
    switch (system) {
    case LabSystem::top:
        return "top";
    case LabSystem::spring:
        return "spring";
    case LabSystem::pendulum:
        return "pendulum";
    case LabSystem::orbit:
        break;
    }
    return "orbit";
}

const char* explanation_of(LabSystem system) {
    switch (system) {
    case LabSystem::top:
        return "A spinning top near upright: a = (mgl / I) x + (I3 spin / I) (up x v). Exact: two circles. The "
               "force\ndepends on the velocity, so that semi-implicit Euler gains energy, too.";
    case LabSystem::spring:
        return "A mass on a spring: a = -(2 pi / 1 s)^2 x, released at 1 m. Exact: x = cos(2 pi t).";
    case LabSystem::pendulum:
        return "A pendulum of 1 m: a = -(g / l) sin(angle), released at 2 rad. Exact: elliptic functions.";
    case LabSystem::orbit:
        break;
    }
    return "A planet: a = -GM r / |r|^3, eccentricity 0.5, period 1 s. Exact: Kepler's equation.";
}

const char* name_of(Integrator integrator) {
    switch (integrator) {
    case Integrator::explicit_euler:
        return "explicit Euler";
    case Integrator::semi_implicit_euler:
        return "semi-implicit Euler";
    case Integrator::rk4:
        break;
    }
    return "Runge-Kutta 4";
}

std::uint32_t color_of(Integrator integrator) {
    switch (integrator) {
    case Integrator::explicit_euler:
        return 0xe67e22;
    case Integrator::semi_implicit_euler:
        return 0x56b4e9;
    case Integrator::rk4:
        break;
    }
    return 0x20b080;
}

const char* formula_of(Integrator integrator) {
    switch (integrator) {
    case Integrator::explicit_euler:
        return "x += h v, then v += h a(old x)";
    case Integrator::semi_implicit_euler:
        return "v += h a(x), then x += h v(new)";
    case Integrator::rk4:
        break;
    }
    return "four slopes per step, weighted 1 2 2 1";
}

LabState start_of(LabSystem system) {
    LabState state;
    switch (system) {
    case LabSystem::spring:
    case LabSystem::top:
        state.place[0] = 1.0;
        break;
    case LabSystem::pendulum:
        state.place[0] = release;
        break;
    case LabSystem::orbit:
        state.place[0] = 1.0 - eccentricity;
        state.velocity[1] = 2.0 * std::numbers::pi * std::sqrt((1.0 + eccentricity) / (1.0 - eccentricity));
    }
    return state;
}

double period_of(LabSystem system) {
    if (system != LabSystem::pendulum) return 1.0;
    return 4.0 * quarter_period(std::sin(0.5 * release)) / std::sqrt(gravity / length);
}

double energy_of(LabSystem system, const LabState& state) {
    const double kinetic = 0.5 * (state.velocity[0] * state.velocity[0] + state.velocity[1] * state.velocity[1]);
    switch (system) {
    case LabSystem::top:
        return kinetic - 0.5 * toppling * (state.place[0] * state.place[0] + state.place[1] * state.place[1]);
    case LabSystem::spring:
        return kinetic + 0.5 * stiffness * (state.place[0] * state.place[0] + state.place[1] * state.place[1]);
    case LabSystem::pendulum:
        return kinetic + gravity / length * (1.0 - std::cos(state.place[0]));
    case LabSystem::orbit:
        break;
    }
    return kinetic - stiffness / std::hypot(state.place[0], state.place[1]);
}

LabState exact(LabSystem system, double time) {
    if (system == LabSystem::pendulum) return exact_pendulum(time);
    if (system == LabSystem::orbit) return exact_orbit(time);
    if (system == LabSystem::top) return exact_top(time);
    LabState state;
    state.place[0] = std::cos(2.0 * std::numbers::pi * time);
    state.velocity[0] = -2.0 * std::numbers::pi * std::sin(2.0 * std::numbers::pi * time);
    return state;
}

LabState step(LabSystem system, Integrator integrator, const LabState& state, double h) {
    const auto a = [system](const Pair& place, const Pair& velocity) { return acceleration(system, place, velocity); };
    LabState next;
    switch (integrator) {
    case Integrator::explicit_euler:
        next.place = plus(state.place, state.velocity, h);
        next.velocity = plus(state.velocity, a(state.place, state.velocity), h);
        return next;
    case Integrator::semi_implicit_euler:
        next.velocity = plus(state.velocity, a(state.place, state.velocity), h);
        next.place = plus(state.place, next.velocity, h);
        return next;
    case Integrator::rk4:
        break;
    }
    const Pair v1 = state.velocity, a1 = a(state.place, v1);
    const Pair v2 = plus(state.velocity, a1, 0.5 * h), a2 = a(plus(state.place, v1, 0.5 * h), v2);
    const Pair v3 = plus(state.velocity, a2, 0.5 * h), a3 = a(plus(state.place, v2, 0.5 * h), v3);
    const Pair v4 = plus(state.velocity, a3, h), a4 = a(plus(state.place, v3, h), v4);
    for (std::size_t i = 0; i < 2; ++i) {
        next.place[i] = state.place[i] + h / 6.0 * (v1[i] + 2.0 * v2[i] + 2.0 * v3[i] + v4[i]);
        next.velocity[i] = state.velocity[i] + h / 6.0 * (a1[i] + 2.0 * a2[i] + 2.0 * a3[i] + a4[i]);
    }
    return next;
}

std::array<double, 2> drawn_place(LabSystem system, const LabState& state) {
    if (system == LabSystem::pendulum) return {std::sin(state.place[0]), -std::cos(state.place[0])};
    // The tilt reaches about twice its initial value.
    if (system == LabSystem::top) return {0.8 * state.place[0], 0.8 * state.place[1]};
    return state.place;
}

std::vector<LabState> trajectory(LabSystem system, Integrator integrator, double h, double seconds) {
    std::vector<LabState> states{start_of(system)};
    const std::size_t steps = std::size_t(std::floor(seconds / h + 1e-9));
    states.reserve(steps + 1);
    for (std::size_t i = 0; i < steps; ++i) states.push_back(step(system, integrator, states.back(), h));
    return states;
}

double greatest_error(LabSystem system, Integrator integrator, double h, double seconds) {
    double greatest = 0.0;
    const std::vector<LabState> states = trajectory(system, integrator, h, seconds);
    for (std::size_t i = 0; i < states.size(); ++i) {
        const LabState right = exact(system, double(i) * h);
        greatest =
            std::max(greatest, std::hypot(states[i].place[0] - right.place[0], states[i].place[1] - right.place[1]));
    }
    return greatest;
}

Chart energy_chart(LabSystem system, double h, double seconds) {
    Chart chart;
    char title[96];
    std::snprintf(title, sizeof title, "energy of the %s, steps of 1/%.0f s", name_of(system), 1.0 / h);
    chart.title = title;
    chart.x_label = "time, s";
    chart.y_label = "change of the energy, % of the initial energy";
    chart.top = 200.0;
    const double start = energy_of(system, start_of(system));
    Curve known{"exact", {}, {}, 0xa9b0ba, false, true};
    for (const Integrator integrator : lab_integrators) {
        Curve curve{name_of(integrator), {}, {}, color_of(integrator), false, false};
        const std::vector<LabState> states = trajectory(system, integrator, h, seconds);
        for (std::size_t i = 0; i < states.size(); ++i) {
            curve.x.push_back(double(i) * h);
            curve.y.push_back(100.0 * (energy_of(system, states[i]) - start) / std::abs(start));
        }
        if (known.x.empty()) known.x = curve.x, known.y.assign(curve.x.size(), 0.0);
        chart.curves.push_back(std::move(curve));
    }
    chart.curves.insert(chart.curves.begin(), std::move(known));
    return chart;
}

Chart error_chart(LabSystem system) {
    Chart chart;
    chart.title = std::string("greatest error of the ") + name_of(system) + " in one period";
    chart.x_label = "length of a step, s";
    chart.y_label = system == LabSystem::pendulum ? "error, rad"
                    : system == LabSystem::top    ? "error, relative to the initial tilt"
                                                  : "error, m";
    chart.log_x = chart.log_y = true;
    for (const Integrator integrator : lab_integrators) {
        Curve curve{"", {}, {}, color_of(integrator), true, false};
        for (const double rate : {60.0, 120.0, 240.0, 480.0, 960.0, 1920.0}) {
            curve.x.push_back(1.0 / rate);
            curve.y.push_back(greatest_error(system, integrator, 1.0 / rate, period_of(system)));
        }
        char label[64];
        // Uses the shortest steps, because the order of a method is the limit of the slope.
        const Curve shortest{"", {curve.x.end() - 3, curve.x.end()}, {curve.y.end() - 3, curve.y.end()}};
        std::snprintf(label, sizeof label, "%s, slope %.1f", name_of(integrator), log_slope(shortest).value_or(0.0));
        curve.label = label;
        chart.curves.push_back(std::move(curve));
    }
    return chart;
}

} // namespace cairn::viewer
