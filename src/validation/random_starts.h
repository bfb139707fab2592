// Random initial conditions of an experiment in free space: any position, any orientation, and any phase of a step. The
// same on every machine.
#pragma once

#include "validation/worlds.h"

#include <cmath>
#include <cstdint>
#include <random>

namespace cairn::validation {

class RandomStart {
  public:
    explicit RandomStart(std::uint32_t seed) : random_(seed) {
        // One after the other: compilers evaluate the arguments of a call in different orders.
        const double z = uniform(-1, 1), y = uniform(-1, 1), x = uniform(-1, 1), w = uniform(-1, 1);
        glm::dquat turn(w, x, y, z);
        if (glm::length(turn) < 0.01) turn = {1, 0, 0, 0};
        rotation_ = glm::normalize(turn);
        offset_ = {uniform(-50, 50), uniform(-50, 50), uniform(-50, 50)};
    }

    double uniform(double least, double greatest) {
        return least + (greatest - least) * double(random_() % 1000003) / 1000003;
    }
    Position place(const glm::dvec3& point) const { return rotation_ * point + offset_; }
    glm::dvec3 turned(const glm::dvec3& vector) const { return rotation_ * vector; }
    const glm::dquat& rotation() const { return rotation_; }
    Quat quat() const { return glm::normalize(Quat(rotation_)); }
    // Rotates a vector of the world back to the frame of the experiment.
    glm::dvec3 back(const Vec3& vector) const { return glm::conjugate(rotation_) * glm::dvec3(vector); }

  private:
    std::mt19937 random_;
    glm::dquat rotation_{1, 0, 0, 0};
    glm::dvec3 offset_{0, 0, 0}; // m
};

// World settings whose gravity is rotated by a random start.
inline WorldDef with_turned_gravity(const RandomStart& start) {
    WorldDef def;
    def.gravity = Vec3(start.turned({0, -gravity, 0}));
    return def;
}

} // namespace cairn::validation
