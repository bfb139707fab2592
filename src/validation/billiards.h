// The exact motion of equal, smooth, elastic balls that collide in pairs: event-driven, in double precision.
#pragma once

#include <glm/vec3.hpp>

#include <limits>
#include <vector>

namespace cairn::validation {

struct BilliardBall {
    glm::dvec3 position{0, 0, 0}; // m
    glm::dvec3 velocity{0, 0, 0}; // m/s
};

class Billiards {
  public:
    Billiards(std::vector<BilliardBall> balls, double radius) : balls_(std::move(balls)), diameter_(2 * radius) {}

    const std::vector<BilliardBall>& balls() const { return balls_; }
    double time() const { return time_; }                           // s
    const std::vector<double>& impacts() const { return impacts_; } // times of the impacts, s, in ascending order

    // Time from now to the next impact, s; infinite if there is none.
    double until_next() const;
    // Advances up to the next impact, and through it; returns false if there is none.
    bool to_next_impact();
    // Advances to the given time, through all impacts before it.
    void advance_to(double time);

  private:
    struct Next {
        double seconds = std::numeric_limits<double>::infinity();
        std::size_t a = 0, b = 0;
    };
    Next next() const;
    void fly(double seconds);
    void meet(const Next& pair);

    std::vector<BilliardBall> balls_;
    std::vector<double> impacts_;
    double diameter_, time_ = 0;
};

} // namespace cairn::validation
