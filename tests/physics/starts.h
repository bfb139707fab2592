// Random starts for tests that must not depend on one.
#pragma once

#include <glm/gtc/quaternion.hpp>

#include <random>

namespace cairn_test {

class Starts {
  public:
    explicit Starts(unsigned seed) : random_(seed) {}
    double between(double a, double b) { return a + (b - a) * (double(random_()) / 4294967295.0); }
    glm::dquat rotation() {
        const double w = between(-1, 1), x = between(-1, 1), y = between(-1, 1), z = between(-1, 1);
        return glm::normalize(glm::dquat(w, x, y, z));
    }

  private:
    std::mt19937 random_;
};

} // namespace cairn_test
