#include "bench/scenes.h"

#include <cmath>
#include <cstdint>
#include <iterator>
#include <utility>

namespace cairn::bench {

namespace {

constexpr float pi = 3.14159265f;

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

  private:
    std::uint32_t state_;
};

class Builder {
  public:
    explicit Builder(std::string_view name) { scene.name = name; }
    Scene scene;

    SceneBody& box(Motion motion, Vec3 position, Vec3 half_extents, float density = 1000.0f, Quat rotation = unturned) {
        Part part;
        part.half_extents = half_extents;
        const float volume = 8 * half_extents.x * half_extents.y * half_extents.z;
        return add(motion, position, rotation, density, volume, part);
    }
    SceneBody& sphere(Motion motion, Vec3 position, float radius, float density = 1000.0f) {
        Part part;
        part.shape = PartShape::sphere;
        part.radius = radius;
        return add(motion, position, unturned, density, 4.0f / 3.0f * pi * radius * radius * radius, part);
    }
    // A floor whose upper side is y = 0.
    void ground(float half_extent) { box(Motion::fixed, {0, -1, 0}, {half_extent, 1, half_extent}); }
    // The same, with walls around -half_width..half_width.
    void room(float half_width, float height) {
        constexpr float thickness = 2.0f; // half of it
        const float outer = half_width + 2 * thickness, center = half_width + thickness, middle = height / 2;
        box(Motion::fixed, {0, -thickness, 0}, {outer, thickness, outer});
        box(Motion::fixed, {center, middle, 0}, {thickness, middle, outer});
        box(Motion::fixed, {-center, middle, 0}, {thickness, middle, outer});
        box(Motion::fixed, {0, middle, center}, {half_width, middle, thickness});
        box(Motion::fixed, {0, middle, -center}, {half_width, middle, thickness});
        const float reach = half_width + 0.5f;
        scene.lower_bound = {-reach, -0.5f, -reach};
        scene.upper_bound = {reach, 1e9f, reach};
    }
    // A wall of boxes, one fewer in each row; the boxes of a row just touch.
    void pyramid(int base, float x_center, float z) {
        constexpr float half = 0.5f, density = 100.0f;
        for (int row = 0; row < base; ++row)
            for (int i = row; i < base; ++i) {
                const float x = (row + 1) * half + 2 * (i - row) * half - half * base;
                box(Motion::dynamic, {x_center + x, (2 * row + 1) * half, z}, {half, half, half}, density);
            }
    }
    // Bodies let fall from a jittered grid into a room. `add_body(random, position)` makes one.
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
    // A hollow kinematic box that turns about the z axis, 2 half_width wide inside and 2 half_depth deep.
    void drum(Vec3 center, float half_width, float half_depth, float speed) {
        constexpr float thickness = 1.0f; // half of it
        const float outer = half_width + 2 * thickness, depth = half_depth + 2 * thickness;
        SceneBody body;
        body.motion = Motion::kinematic;
        body.position = center;
        body.angular_velocity = {0, 0, speed};
        body.first_part = scene.parts.size();
        const auto wall = [&](Vec3 position, Vec3 half_extents) {
            Part part;
            part.position = position;
            part.half_extents = half_extents;
            scene.parts.push_back(part);
        };
        const float x = half_width + thickness, z = half_depth + thickness;
        wall({x, 0, 0}, {thickness, outer, depth});
        wall({-x, 0, 0}, {thickness, outer, depth});
        wall({0, x, 0}, {half_width, thickness, depth});
        wall({0, -x, 0}, {half_width, thickness, depth});
        wall({0, 0, z}, {half_width, half_width, thickness});
        wall({0, 0, -z}, {half_width, half_width, thickness});
        body.part_count = scene.parts.size() - body.first_part;
        scene.bodies.push_back(body);
        scene.lower_bound = {-1e9f, -1e9f, -half_depth - 0.5f};
        scene.upper_bound = {1e9f, 1e9f, half_depth + 0.5f};
        scene.axis_point = center;
        scene.axis_distance = std::sqrt(2.0f) * half_width + 0.5f;
    }

  private:
    static constexpr Quat unturned{1.0f, 0.0f, 0.0f, 0.0f};

    SceneBody& add(Motion motion, Vec3 position, Quat rotation, float density, float volume, const Part& part) {
        SceneBody body;
        body.motion = motion;
        body.position = position;
        body.rotation = rotation;
        body.density = density;
        body.first_part = scene.parts.size();
        if (motion == Motion::dynamic) {
            body.mass = density * volume;
            ++scene.dynamic_count;
        }
        scene.parts.push_back(part);
        scene.bodies.push_back(body);
        return scene.bodies.back();
    }
};

void pile_spheres(Builder& b, int size) {
    b.pile(size, 20, 1.15f, 1, [&](Random&, Vec3 p) { b.sphere(Motion::dynamic, p, 0.5f); });
}

void pile_boxes(Builder& b, int size) {
    b.pile(size, 18, 1.82f, 2, [&](Random& random, Vec3 p) {
        b.box(Motion::dynamic, p, {0.5f, 0.5f, 0.5f}, 1000, random.rotation());
    });
}

void pile_mixed(Builder& b, int size) {
    b.pile(size, 16, 2.18f, 3, [&](Random& random, Vec3 p) {
        const float density = random.between(300, 3000);
        if (random.next() & 1024) {
            const float x = random.between(0.2f, 0.6f), y = random.between(0.2f, 0.6f), z = random.between(0.2f, 0.6f);
            b.box(Motion::dynamic, p, {x, y, z}, density, random.rotation());
        } else {
            b.sphere(Motion::dynamic, p, random.between(0.25f, 0.7f), density);
        }
    });
}

void one_pyramid(Builder& b, int size) {
    b.scene.steps = 300;
    b.scene.stands = true;
    b.ground(400);
    b.pyramid(size, 0, 0);
}

void many_pyramids(Builder& b, int size) {
    b.scene.steps = 300;
    b.scene.stands = true;
    b.ground(400);
    const float middle = 0.5f * (size - 1);
    for (int i = 0; i < size; ++i)
        for (int j = 0; j < size; ++j) b.pyramid(10, (j - middle) * 12.0f, (i - middle) * 6.0f);
}

void tower(Builder& b, int size) {
    b.scene.stands = true;
    b.ground(50);
    for (int i = 0; i < size; ++i) b.box(Motion::dynamic, {0, 0.5f + i, 0}, {0.5f, 0.5f, 0.5f});
}

void mass_ratio(Builder& b, int size) {
    b.scene.stands = true;
    b.ground(50);
    for (int i = 0; i < 5; ++i)
        b.box(Motion::dynamic, {0, 0.5f + i, 0}, {0.5f, 0.5f, 0.5f}, i == 4 ? 100.0f * size : 100.0f);
}

constexpr int tumbler_columns = 14, tumbler_rows = 14, tumbler_layers = 11;

void tumbler(Builder& b, int size) {
    const Vec3 center{0, 20, 0};
    b.drum(center, 10, 8, 25 * pi / 180);
    for (int i = 0; i < size; ++i) {
        const int x = i % tumbler_columns, z = i / tumbler_columns % tumbler_layers;
        const int y = i / (tumbler_columns * tumbler_layers);
        const Vec3 offset{(x - 6.5f) * 1.25f, (y - 6.5f) * 1.25f, (z - 5.0f) * 1.25f};
        b.box(Motion::dynamic, center + offset, {0.5f, 0.5f, 0.5f});
    }
}

constexpr int most_bodies = 1000000;
constexpr SceneKind kinds[] = {
    {"pile_spheres", "equal spheres fall into a room", "bodies", 8000, most_bodies},
    {"pile_boxes", "equal boxes fall into a room", "bodies", 5000, most_bodies},
    {"pile_mixed", "boxes and spheres of many sizes and densities fall into a room", "bodies", 5000, most_bodies},
    {"pyramid", "a wall of boxes, one fewer in each row", "boxes in the lowest row", 40, 1000},
    {"large_pyramid", "the same, larger", "boxes in the lowest row", 100, 1000},
    {"many_pyramids", "a square of pyramids of 55 boxes", "pyramids in a row of the square", 10, 100},
    {"tower", "boxes one on another", "boxes", 40, 10000},
    {"mass_ratio", "four light boxes carry a heavy one", "mass of the heavy box over that of a light one", 1000,
     1000000},
    {"tumbler", "boxes in a box that turns", "boxes", 2000, tumbler_columns* tumbler_rows* tumbler_layers},
};
// In the same order.
constexpr void (*builders[])(Builder&, int) = {pile_spheres,  pile_boxes, pile_mixed, one_pyramid, one_pyramid,
                                               many_pyramids, tower,      mass_ratio, tumbler};
static_assert(std::size(kinds) == std::size(builders));

} // namespace

std::span<const SceneKind> scene_kinds() { return kinds; }

namespace {

std::size_t find_kind(std::string_view name) {
    for (std::size_t i = 0; i < std::size(kinds); ++i)
        if (kinds[i].name == name) return i;
    throw SceneError("there is no scene " + std::string(name));
}

} // namespace

void check_size(std::string_view name, int size) {
    const SceneKind& kind = kinds[find_kind(name)];
    if (size >= 0 && size <= kind.greatest_size) return;
    throw SceneError("the size of " + std::string(name) + " (" + std::string(kind.size_meaning) + ") must be at most " +
                     std::to_string(kind.greatest_size) + " and not negative, got " + std::to_string(size));
}

Scene make_scene(std::string_view name, int size) {
    check_size(name, size);
    const std::size_t i = find_kind(name);
    Builder builder(name);
    builders[i](builder, size == 0 ? kinds[i].default_size : size);
    return std::move(builder.scene);
}

} // namespace cairn::bench
