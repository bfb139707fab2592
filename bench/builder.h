// Helpers that build the scenes.
#pragma once

#include "bench/scenes.h"

#include <cmath>
#include <cstdint>
#include <string_view>

namespace cairn::bench {

// xorshift32 (Marsaglia, "Xorshift RNGs", 2003).
class Random {
  public:
    explicit Random(std::uint32_t seed) : state_(seed * 2654435761u + 12345u) {}

    std::uint32_t next() {
        state_ ^= state_ << 13;
        state_ ^= state_ >> 17;
        state_ ^= state_ << 5;
        return state_;
    }
    std::uint32_t below(std::uint32_t count) { return next() % count; }
    float between(float low, float high) {
        return low + (high - low) * (static_cast<float>(next() >> 8) * (1.0f / 16777216.0f));
    }
    // Uniform over all rotations: a point in the unit 4-ball, normalized.
    Quat rotation() {
        for (;;) {
            const float x = between(-1, 1), y = between(-1, 1), z = between(-1, 1), w = between(-1, 1);
            const float square = x * x + y * y + z * z + w * w;
            if (square > 1 || square < 0.05f) continue;
            const float scale = 1.0f / std::sqrt(square);
            return Quat(w * scale, x * scale, y * scale, z * scale);
        }
    }
    // Uniform over the unit sphere.
    Vec3 direction() {
        for (;;) {
            const float x = between(-1, 1), y = between(-1, 1), z = between(-1, 1);
            const float square = x * x + y * y + z * z;
            if (square > 1 || square < 0.01f) continue;
            return Vec3(x, y, z) * (1.0f / std::sqrt(square));
        }
    }

  private:
    std::uint32_t state_;
};

inline Part box_part(Vec3 half_extents, Vec3 position = Vec3(0.0f)) {
    Part part;
    part.half_extents = half_extents;
    part.position = position;
    return part;
}

inline Part sphere_part(float radius, Vec3 position = Vec3(0.0f)) {
    Part part;
    part.shape = PartShape::sphere;
    part.radius = radius;
    part.position = position;
    return part;
}

class Builder {
  public:
    explicit Builder(std::string_view name) { scene.name = name; }
    Scene scene;

    SceneBody& body(Motion motion, Vec3 position, std::span<const Part> parts, float density = 1000.0f,
                    Quat rotation = unturned);
    SceneBody& body(Motion motion, Vec3 position, const Part& part, float density = 1000.0f, Quat rotation = unturned) {
        return body(motion, position, std::span(&part, 1), density, rotation);
    }
    SceneBody& box(Motion motion, Vec3 position, Vec3 half_extents, float density = 1000.0f, Quat rotation = unturned) {
        return body(motion, position, box_part(half_extents), density, rotation);
    }
    SceneBody& sphere(Motion motion, Vec3 position, float radius, float density = 1000.0f) {
        return body(motion, position, sphere_part(radius), density);
    }
    // A floor whose upper side is y = 0.
    void ground(float half_extent) { box(Motion::fixed, {0, -1, 0}, {half_extent, 1, half_extent}); }
    // The same floor with walls at -half_width and half_width along x and z.
    void room(float half_width, float height);
    // A wall of boxes with one box fewer in each row; the boxes of a row just touch.
    void pyramid(int base, float x_center, float z) {
        constexpr float half = 0.5f, density = 100.0f;
        for (int row = 0; row < base; ++row)
            for (int i = row; i < base; ++i) {
                const float x = (row + 1) * half + 2 * (i - row) * half - half * base;
                box(Motion::dynamic, {x_center + x, (2 * row + 1) * half, z}, {half, half, half}, density);
            }
    }
    // Bodies that fall from a jittered grid into a room. `add_body(random, position)` adds one body.
    template <class F> void pile(int count, int layers, float spacing, std::uint32_t seed, F&& add_body) {
        const int across = static_cast<int>(std::ceil(std::sqrt(static_cast<double>(count) / layers)));
        const int rows = (count + across * across - 1) / (across * across);
        room(0.5f * across * spacing + 0.25f, rows * spacing + 20);
        Random random(seed);
        for (int i = 0; i < count; ++i) {
            const int x = i % across, z = i / across % across, y = i / (across * across);
            const float middle = 0.5f * (across - 1);
            const float dx = random.between(-0.04f, 0.04f);
            const float dy = random.between(-0.02f, 0.02f);
            const float dz = random.between(-0.04f, 0.04f);
            add_body(random, Vec3((x - middle) * spacing + dx, 1.5f + y * spacing + dy, (z - middle) * spacing + dz));
        }
    }
    // A hollow kinematic box that rotates about the z axis; its interior is 2 half_width wide and 2 half_depth deep.
    void drum(Vec3 center, float half_width, float half_depth, float speed);

  private:
    static constexpr Quat unturned{1.0f, 0.0f, 0.0f, 0.0f};
};

} // namespace cairn::bench
