#include "bench/builder.h"
#include "bench/joint_scenes.h"
#include "bench/shape_scenes.h"

#include <iterator>
#include <utility>

namespace cairn::bench {

namespace {

constexpr float pi = 3.14159265f;

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

constexpr int max_bodies = 1000000;
constexpr SceneKind kinds[] = {
    {"pile_spheres", "equal spheres fall into a room", "bodies", 8000, max_bodies},
    {"pile_boxes", "equal boxes fall into a room", "bodies", 5000, max_bodies},
    {"pile_mixed", "boxes and spheres of many sizes and densities fall into a room", "bodies", 5000, max_bodies},
    {"pyramid", "a wall of boxes, one fewer in each row", "boxes in the lowest row", 40, 1000},
    {"large_pyramid", "the same, larger", "boxes in the lowest row", 100, 1000},
    {"many_pyramids", "a square of pyramids of 55 boxes", "pyramids in a row of the square", 10, 100},
    {"tower", "boxes one on another", "boxes", 40, 10000},
    {"mass_ratio", "four light boxes carry a heavy one", "mass of the heavy box over that of a light one", 1000,
     1000000},
    {"tumbler", "boxes in a box that turns", "boxes", 2000, tumbler_columns* tumbler_rows* tumbler_layers},
    {"convex", "convex polyhedra of 12 to 24 corners fall into a room", "bodies", 1000, max_bodies},
    {"terrain", "boxes fall on hills of 20,000 triangles", "bodies", 2000, max_bodies},
    {"props", "tables, chairs and jacks of 3 to 7 boxes and spheres fall into a room", "bodies", 1500, max_bodies},
    {"capsules", "capsules and cylinders of many sizes fall into a room", "bodies", 3000, max_bodies},
    {"chain", "links on hinges fall and swing; nothing collides", "links", 20, 10000},
    {"joint_grid", "a net of spheres hangs on its upper edge; nothing collides", "spheres in a row", 64, 1000},
    {"joint_swing", "a level net of spheres falls and swings on one edge; nothing collides", "spheres in a row", 64,
     1000},
    {"ragdolls", "ragdolls of 11 bodies and 10 joints fall into a room", "ragdolls", 500, 100000},
};
// The builder functions in the same order as `kinds`.
constexpr void (*builders[])(Builder&, int) = {
    pile_spheres, pile_boxes, pile_mixed, one_pyramid, one_pyramid, many_pyramids, tower,       mass_ratio, tumbler,
    convex,       terrain,    props,      capsules,    chain,       joint_grid,    joint_swing, ragdolls};
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
