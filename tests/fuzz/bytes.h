// Converts the input bytes of a fuzz target to numbers.
#pragma once

#include <cairn/cairn.h>

#include <cstdint>
#include <span>

namespace cairn_fuzz {

using namespace cairn;

// Numbers from bytes; zeros after the last byte.
class Bytes {
  public:
    explicit Bytes(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

    bool is_empty() const { return bytes_.empty(); }
    int pick(int n) { return next() % n; } // 0 to n - 1
    double fraction() {                    // 0 to 1, in steps of 1/65536
        const int high = next();
        return double(256 * high + next()) / 65536;
    }
    float unit() { return float(std::int8_t(next())) / 128.0f; }       // -1 to 1
    float size() { return 0.05f + float(next() & 63) / 64.0f * 0.5f; } // m
    Vec3 vector(float length) {
        const float x = unit(), y = unit(), z = unit();
        return length * Vec3(x, y, z);
    }
    Quat rotation() {
        const float x = unit(), y = unit(), z = unit();
        return {1.0f, x, y, z};
    }
    Position place() { return Position(vector(4.0f)) + Position(0, 3, 0); }

  private:
    int next() {
        if (bytes_.empty()) return 0;
        const int value = bytes_.front();
        bytes_ = bytes_.subspan(1);
        return value;
    }
    std::span<const std::uint8_t> bytes_;
};

} // namespace cairn_fuzz
