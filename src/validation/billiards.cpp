#include "validation/billiards.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace cairn::validation {

Billiards::Next Billiards::next() const {
    Next first;
    for (std::size_t a = 0; a < balls_.size(); ++a)
        for (std::size_t b = a + 1; b < balls_.size(); ++b) {
            const glm::dvec3 d = balls_[b].position - balls_[a].position;
            const glm::dvec3 v = balls_[b].velocity - balls_[a].velocity;
            const double closing = -glm::dot(d, v), v2 = glm::dot(v, v);
            if (!(closing > 0)) continue; // also skips the pair that has just collided
            // |d + t v| = diameter: the smaller root, in the form without cancellation.
            const double c = glm::dot(d, d) - diameter_ * diameter_, root2 = closing * closing - v2 * c;
            if (root2 < 0) continue;
            const double t = std::fmax(0, c / (closing + std::sqrt(root2)));
            if (t < first.seconds) first = {t, a, b};
        }
    return first;
}

double Billiards::until_next() const { return next().seconds; }

void Billiards::fly(double seconds) {
    for (BilliardBall& ball : balls_) ball.position += seconds * ball.velocity;
    time_ += seconds;
}

void Billiards::meet(const Next& pair) {
    BilliardBall &a = balls_[pair.a], &b = balls_[pair.b];
    const glm::dvec3 normal = glm::normalize(b.position - a.position);
    const glm::dvec3 exchanged = glm::dot(b.velocity - a.velocity, normal) * normal;
    a.velocity += exchanged;
    b.velocity -= exchanged;
    impacts_.push_back(time_);
}

bool Billiards::to_next_impact() {
    const Next pair = next();
    if (!std::isfinite(pair.seconds)) return false;
    fly(pair.seconds);
    meet(pair);
    return true;
}

void Billiards::advance_to(double time) {
    for (Next pair = next(); time_ + pair.seconds <= time; pair = next()) {
        fly(pair.seconds);
        meet(pair);
    }
    fly(time - time_);
}

} // namespace cairn::validation
