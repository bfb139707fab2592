// Scenes with every shape.
#include "scene_tools.h"

#include <cmath>
#include <limits>

namespace cairn_test {

using namespace cairn;

namespace {

// All shapes on a height field and on a mesh beside it, with a conveyor, a trigger and two collision layers.
struct AllShapes : Scene {
    void build(World& world) override {
        Numbers numbers(23);
        std::vector<float> heights;
        for (int i = 0; i < 17 * 17; ++i) heights.push_back(0.25f * numbers.next());
        add_fixed(world, HeightField(17, 17, {1, 1}, heights));
        std::vector<Vec3> vertices;
        std::vector<std::uint32_t> indices;
        for (std::uint32_t r = 0; r < 9; ++r)
            for (std::uint32_t c = 0; c < 9; ++c)
                vertices.emplace_back(2.0f * float(c), 0.3f * numbers.next(), 2.0f * float(r));
        for (std::uint32_t r = 0; r < 8; ++r)
            for (std::uint32_t c = 0; c < 8; ++c) {
                const std::uint32_t a = 9 * r + c, b = a + 1, d = a + 9, e = d + 1;
                indices.insert(indices.end(), {a, d, e, a, e, b});
            }
        add_fixed(world, Mesh(vertices, indices), {8, 0.1, -8});
        ShapeDef belt;
        belt.surface_velocity = {1, 0, 0.5f};
        add_fixed(world, Box{{2, 0.2f, 8}}, {0, 0.3, 0}, belt);
        ShapeDef zone;
        zone.is_trigger = true;
        add_fixed(world, Box{{4, 1, 4}}, {8, 1, 0}, zone);
        const Hull rocks[] = {rock(numbers, 8), rock(numbers, 14), rock(numbers, 40)};
        for (int i = 0; i < 96; ++i) {
            BodyDef def;
            def.position = Position(1.3 * (i % 10), 1 + 1.1 * (i / 40), 1.6 * (i / 10 % 4) - 2.4);
            def.rotation = numbers.rotation();
            const float size = 0.35f + 0.1f * numbers.next();
            const Shape shapes[] = {Sphere{size},     Box{{size, 0.3f, size}},   Capsule{size, 0.2f, {}},
                                    rocks[i % 3],     Cylinder{size, 0.3f, {}},  Capsule{size, 0.3f, 0.15f},
                                    cone(0.4f, size), Cylinder{size, 0.3f, 0.2f}};
            ShapeDef shape;
            if (i % 16 == 5) shape.filter = {2, 1}; // these do not collide with each other
            add(world, shapes[i % 8], def, shape);
        }
    }
};

// Rounded shapes on hills and on a two-sided plane, and between walls that are strips.
class RoundedShapes final : public Scene {
    void build(World& world) override {
        Numbers numbers(23);
        add_fixed(world, Plane{{0, 1, 0}, {1, 0, 0}, {}, true});
        constexpr float endless = std::numeric_limits<float>::infinity();
        add_fixed(world, Plane{{0, 0, 1}, {1, 0, 0}, glm::vec2(endless, 3), true}, {0, 0, -4});
        add_fixed(world, Plane{{0, 0, -1}, {1, 0, 0}, glm::vec2(endless, 3)}, {0, 0, 4});
        std::vector<float> heights(17 * 17);
        for (float& height : heights) height = 0.3f * numbers.next();
        add_fixed(world, HeightField(17, 17, {0.5f, 0.5f}, heights));
        add_fixed(world, Box{{2, 0.1f, 2}, 0.1f}, {6, 0.4, 0});
        Hull pebble = rock(numbers, 20);
        pebble.rounding = 0.1f;
        for (int i = 0; i < 60; ++i) {
            BodyDef def;
            def.position = Position(1.1 * (i % 8) - 2, 1 + 1.2 * (i / 40), 1.3 * (i / 8 % 5) - 2.6);
            def.rotation = numbers.rotation();
            const float size = 0.25f + 0.1f * numbers.next(), r = 0.08f;
            const Shape shapes[] = {Box{{size, 0.2f, size}, r},    Cylinder{size, 0.2f, {}, r}, pebble,
                                    Cylinder{size, 0.3f, 0.0f, r}, Box{{size, 0.2f, size}},     Sphere{size}};
            add(world, shapes[i % 6], def);
        }
    }
};

// Two-sided and moving surfaces: a hammock, a rotating disc of triangles, a belt that is a mesh, a rectangle, a trigger
// of each kind that has an interior; and compounds of hulls, capsules and cylinders on them.
class Surfaces final : public Scene {
    static Mesh fan(int corners, float radius) {
        std::vector<Vec3> vertices{{0, 0, 0}};
        std::vector<std::uint32_t> indices;
        for (int i = 0; i < corners; ++i) { // around the circle, with t the tangent of half the angle
            const float t = std::abs(8.0f * float(i) / float(corners) - 4) - 2, sign = 2 * i < corners ? 1.0f : -1.0f;
            const float c = (1 - t * t / 4) / (1 + t * t / 4), s = t / (1 + t * t / 4);
            vertices.emplace_back(radius * s, 0.05f * float(i % 3), sign * radius * c);
        }
        for (int i = 0; i < corners; ++i)
            indices.insert(indices.end(), {0, std::uint32_t(1 + (i + 1) % corners), std::uint32_t(1 + i)});
        return Mesh(vertices, indices);
    }

  public:
    void build(World& world) override {
        add_fixed(world, Plane{});
        add_fixed(world, Plane{{0.2f, 1, 0}, {0, 0, 1}, glm::vec2(2, 2), true}, {0, 2, 0});
        BodyDef disc;
        disc.type = BodyType::kinematic;
        disc.position = {5, 1, 0};
        disc.angular_velocity = {0, -0.7f, 0};
        add(world, fan(12, 2.2f), disc);
        ShapeDef belt;
        belt.surface_velocity = {0.8f, 0, 0.3f};
        const std::vector<Vec3> corners = {{-2, 0, -2}, {2, 0.2f, -2}, {2, 0.4f, 2}, {-2, 0.1f, 2}};
        const std::vector<std::uint32_t> triangles = {0, 2, 1, 0, 3, 2};
        add_fixed(world, Mesh(corners, triangles), {10, 0.6, 0}, belt);
        BodyDef plate;
        plate.type = BodyType::kinematic;
        plate.position = {15, 0.5, 0};
        plate.linear_velocity = {-0.2f, 0.1f, 0};
        plate.angular_velocity = {0, 0.3f, 0.1f};
        add(world, Plane{{0, 1, 0}, {1, 0, 0}, glm::vec2(2, 2)}, plate);
        Numbers numbers(43);
        ShapeDef zone;
        zone.is_trigger = true;
        const Shape zones[] = {Sphere{1.5f}, Capsule{1, 1, {}}, Cylinder{1, 1, 0.5f}, rock(numbers, 10),
                               Box{{1, 2, 1}}};
        for (int i = 0; i < 5; ++i) add_fixed(world, zones[i], {4.0 * i, 1.5, 1}, zone);
        for (int i = 0; i < 36; ++i) {
            BodyDef def;
            def.position = Position(5.0 * (i % 4), 3 + 1.3 * (i / 12), 1.2 * (i / 4 % 3) - 1.2);
            def.rotation = numbers.rotation();
            const float size = 0.3f + 0.1f * numbers.next();
            const Shape shapes[] = {rock(numbers, 9), Capsule{size, 0.2f, 0.1f}, Cylinder{size, 0.25f, {}, 0.05f},
                                    Sphere{size},     Box{{size, 0.2f, 0.3f}},   Cylinder{size, 0.3f, 0.2f}};
            const BodyId body = add(world, shapes[i % 6], def);
            if (i % 3 != 0) continue;
            ShapeDef part;
            part.position = {0.3f, 0.2f, 0};
            part.rotation = numbers.rotation();
            world.add_shape(body, shapes[(i / 3 + 1) % 6], part);
        }
    }
};

} // namespace

Scene& all_shapes() { return make<AllShapes>(); }
Scene& rounded_shapes() { return make<RoundedShapes>(); }
Scene& surfaces() { return make<Surfaces>(); }

} // namespace cairn_test
