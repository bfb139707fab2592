// Random numbers, positions and rotations that are the same on every machine.
#pragma once

#include <cairn/math.h>

#include <random>

namespace cairn::test {

class Chance {
  public:
    explicit Chance(unsigned seed) : engine_(seed) {}
    float between(float low, float high) { return low + (high - low) * float(engine_() / 4294967296.0); }
    unsigned below(unsigned n) { return engine_() % n; }
    Vec3 in_box(float half) { return {between(-half, half), between(-half, half), between(-half, half)}; }
    Quat rotation() { return glm::normalize(Quat(between(-1, 1), between(-1, 1), between(-1, 1), between(-1, 1))); }

  private:
    std::mt19937 engine_;
};

} // namespace cairn::test
