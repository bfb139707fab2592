#include "flown_way.h"

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cmath>

namespace cairn_test {
namespace {

constexpr double finest_turn = 0.05; // rad, per step of the integration
constexpr double longest_turn = 2;   // rad between knots; a longer rotation would be taken for the shorter way around
constexpr double bend_share = 0.1;   // of the tolerance: greatest error of one rotation between knots

glm::dvec3 inertia_times(const FreeBody& body, const glm::dquat& rotation, const glm::dvec3& spin) {
    const glm::dquat axes = rotation * body.principal;
    return axes * (body.inertia * (glm::conjugate(axes) * spin));
}
glm::dvec3 spin_at(const FreeBody& body, const glm::dquat& rotation, const glm::dvec3& momentum) {
    const glm::dquat axes = rotation * body.principal;
    return axes * ((glm::conjugate(axes) * momentum) / body.inertia);
}
glm::dquat turned(const glm::dquat& rotation, const glm::dvec3& turn) {
    const double angle = glm::length(turn);
    return angle > 0 ? glm::normalize(glm::angleAxis(angle, turn / angle) * rotation) : rotation;
}
double angle_between(const glm::dquat& a, const glm::dquat& b) {
    const glm::dquat turn = a * glm::conjugate(b);
    return 2 * std::atan2(glm::length(glm::dvec3(turn.x, turn.y, turn.z)), std::fabs(turn.w));
}

// The rotation after `duration` seconds with constant angular momentum, by the classical Runge-Kutta method.
glm::dquat turned_freely(const FreeBody& body, const glm::dquat& q, const glm::dvec3& momentum, double duration) {
    const auto rate = [&](const glm::dquat& at) {
        const glm::dvec3 w = spin_at(body, at, momentum);
        return 0.5 * (glm::dquat(0, w.x, w.y, w.z) * at);
    };
    const glm::dquat a = rate(q), b = rate(q + 0.5 * duration * a), c = rate(q + 0.5 * duration * b);
    const glm::dquat d = rate(q + duration * c);
    return glm::normalize(q + (duration / 6) * (a + 2.0 * b + 2.0 * c + d));
}

class Flight {
  public:
    Flight(const FreeBody& body, double dt, const BodyState& from)
        : body_(body), dt_(dt), state_(from), knots_{{0, from.center, from.rotation}} {}

    const BodyState& state() const { return state_; }
    const std::vector<Knot>& knots() const { return knots_; }
    void change(const glm::dvec3& velocity, const glm::dvec3& momentum) {
        state_.velocity = velocity;
        state_.spin = body_.inertia.x > 0 ? spin_at(body_, state_.rotation, momentum) : momentum;
    }

    // Advances to a time in 0 to 1.
    void go_to(double time) {
        const double duration = (time - time_) * dt_;
        if (!(duration > 0)) return;
        const double begin = time_;
        const BodyState from = state_;
        const glm::dvec3 momentum = inertia_times(body_, from.rotation, from.spin);
        const int n = 1 + int(glm::length(from.spin) * duration / finest_turn);
        glm::dvec3 first_spin = from.spin;
        double turn = 0;
        for (int i = 1; i <= n; ++i) {
            const double part = double(i) / n, step = duration / n, step_turn = glm::length(state_.spin) * step;
            BodyState next = state_;
            next.center = from.center + part * duration * from.velocity;
            if (body_.inertia.x > 0) {
                next.rotation = turned_freely(body_, state_.rotation, momentum, step);
                next.spin = spin_at(body_, next.rotation, momentum);
            } else {
                next.rotation = turned(state_.rotation, step * state_.spin);
            }
            turn += step_turn;
            const double bend =
                glm::length(next.spin - first_spin) * (turn / std::max(glm::length(first_spin), 1e-30)) / 8;
            if (turn > longest_turn || bend * body_.reach > bend_share * body_.tolerance) {
                if (knots_.back().time < time_) knots_.push_back({time_, state_.center, state_.rotation});
                first_spin = state_.spin;
                turn = step_turn;
            }
            state_ = next;
            time_ = begin + part * (time - begin);
        }
        time_ = time;
        knots_.push_back({time, state_.center, state_.rotation});
    }

  private:
    const FreeBody body_;
    const double dt_;
    double time_ = 0;
    BodyState state_;
    std::vector<Knot> knots_;
};

bool is_at(const FreeBody& body, const BodyState& one, const BodyState& other) {
    return glm::length(one.center - other.center) <= body.tolerance &&
           angle_between(one.rotation, other.rotation) * body.reach <= body.tolerance;
}

std::vector<Knot> ended_at(const Flight& flight, const BodyState& to) {
    std::vector<Knot> knots = flight.knots();
    knots.back() = {1, to.center, to.rotation};
    return knots;
}

} // namespace

BodyPath reconstruct_path(const FreeBody& body, const BodyState& from, const BodyState& to, double dt) {
    Flight straight(body, dt, from);
    straight.go_to(1);
    if (is_at(body, straight.state(), to)) return {ended_at(straight, to), false};
    // The intersection of the line from the start with the line to the end.
    const glm::dvec3 change = from.velocity - to.velocity, left = to.center - from.center - dt * to.velocity;
    const double change2 = glm::dot(change, change);
    if (!(change2 > 0)) return {};
    const double time = glm::dot(change, left) / change2 / dt;
    if (!(time >= 0) || !(time <= 1)) return {};
    Flight broken(body, dt, from);
    broken.go_to(time);
    broken.change(to.velocity, body.inertia.x > 0 ? inertia_times(body, to.rotation, to.spin) : to.spin);
    broken.go_to(1);
    if (!is_at(body, broken.state(), to)) return {};
    return {ended_at(broken, to), true};
}

} // namespace cairn_test
