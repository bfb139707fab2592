// Meshes and height fields whose triangles have materials of their own: friction, restitution and queries use the
// material of the place.
#include "support.h"
#include "validation/random_starts.h"

#include <algorithm>
#include <array>
#include <memory>

namespace {

using namespace cairn_test;

constexpr float frame = 1.0f / 60;

// A horizontal floor of square cells about the origin, each with one of several materials.
class Patchwork {
  public:
    // `numbers`: the material of cell (x, z) is at x * cells + z.
    Patchwork(int cells, float width, SurfaceMaterials materials) : cells_(cells), width_(width), own_(materials) {}

    Shape as_mesh(RandomStart& start) const {
        const Mesh plain = flat_mesh(cells_, width_);
        const std::span<const Vec3> corners = plain.vertices();
        // Triangles are in random order, as in files.
        std::vector<std::array<std::uint32_t, 3>> triangles;
        for (std::size_t i = 0; i < plain.indices().size(); i += 3)
            triangles.push_back({plain.indices()[i], plain.indices()[i + 1], plain.indices()[i + 2]});
        for (std::size_t i = triangles.size(); i > 1; --i)
            std::swap(triangles[i - 1], triangles[std::size_t(start.uniform(0, 0.999999) * double(i))]);
        SurfaceMaterials of_triangles{own_.materials, {}};
        std::vector<std::uint32_t> indices;
        for (const auto& t : triangles) {
            const Vec3 middle = (corners[t[0]] + corners[t[1]] + corners[t[2]]) / 3.0f;
            of_triangles.numbers.push_back(std::uint16_t(number_at(double(middle.x), double(middle.z))));
            indices.insert(indices.end(), t.begin(), t.end());
        }
        return Mesh(corners, indices, of_triangles);
    }
    Shape as_field() const {
        SurfaceMaterials of_cells{own_.materials, {}};
        for (int z = 0; z < cells_; ++z)
            for (int x = 0; x < cells_; ++x)
                of_cells.numbers.push_back(own_.numbers[std::size_t(x) * std::size_t(cells_) + std::size_t(z)]);
        return HeightField(cells_ + 1, cells_ + 1, {width_, width_},
                           std::vector<float>(std::size_t(cells_ + 1) * std::size_t(cells_ + 1)), of_cells);
    }
    Shape of_kind(int kind, RandomStart& start) const { return kind == 0 ? as_mesh(start) : as_field(); }

    int number_at(double x, double z) const {
        const auto cell = [&](double p) {
            return std::size_t(std::clamp(p / double(width_) + 0.5 * cells_, 0.0, cells_ - 1.0));
        };
        return own_.numbers[cell(x) * std::size_t(cells_) + cell(z)];
    }

  private:
    int cells_;
    float width_;
    SurfaceMaterials own_;
};

BodyDef placed(const RandomStart& start, const glm::dvec3& at, BodyType type = BodyType::dynamic) {
    BodyDef def;
    def.type = type;
    def.position = start.place(at);
    def.rotation = start.quat();
    return def;
}

// A material whose combine rule every other rule overrides. The floor combines by minimum friction and maximum
// restitution, so that its values alone count.
Material yielding() {
    Material material = surface(2);
    material.friction_combine = material.restitution_combine = CombineRule::multiply;
    return material;
}
Material floor_material(float friction, float restitution = 0) {
    Material material = surface(friction, restitution);
    material.friction_combine = CombineRule::minimum;
    material.restitution_combine = CombineRule::maximum;
    return material;
}

// Balls that do not rotate, and boxes small compared with the stripes, slide over stripes with different friction, each
// of which takes its part of the energy. (A step across a border, up to 12 cm, uses the friction of one of the two
// stripes.)
TEST(SurfaceMaterials, WhatSlidesIsBrakedAsTheStripesUnderItHaveIt) {
    constexpr int cells = 20;
    double worst_ball = 0, worst_box = 0;
    for (unsigned seed = 0; seed < 40; ++seed) {
        RandomStart start(seed);
        SurfaceMaterials materials;
        std::vector<double> friction;
        for (int x = 0; x < cells; ++x) {
            friction.push_back(start.uniform(0.05, 0.5));
            if (x > 0) materials.materials.push_back(floor_material(float(friction.back())));
            for (int z = 0; z < cells; ++z) materials.numbers.push_back(std::uint16_t(x)); // 0: material of the shape
        }
        World world(with_turned_gravity(start));
        add_body(world, Patchwork(cells, 1, materials).of_kind(int(seed % 2), start),
                 placed(start, {}, BodyType::static_), floor_material(float(friction[0])));
        const double from = start.uniform(-9.5, -8.5), speed = start.uniform(4, 7);
        const bool is_ball = seed % 4 < 2;
        BodyDef def = placed(start, {from, 0.1, start.uniform(-8, 8)});
        def.linear_velocity = Vec3(start.turned({speed, 0, 0}));
        if (is_ball) def.mass_properties = MassProperties{2, {0, 0, 0}, {0, 0, 0}, {1, 0, 0, 0}};
        const Shape shape = is_ball ? Shape(Sphere{0.1f}) : Shape(Box{{0.1f, 0.1f, 0.1f}});
        const BodyId body = add_body(world, shape, def, yielding());
        run(world, frame, 60 * 8);
        // The point where the body has lost all of its kinetic energy.
        double left = speed * speed / (2 * gravity), end = from;
        while (left > 0) {
            const int stripe = int(std::floor(end + 1e-9)) + cells / 2;
            const double way = std::min(std::floor(end + 1e-9) + 1 - end, left / friction[std::size_t(stripe)]);
            left -= friction[std::size_t(stripe)] * way, end += way;
            ASSERT_LT(stripe, cells - 1);
        }
        const double way = start.back(Vec3(world.body(body).position() - start.place({}))).x - from;
        double& worst = is_ball ? worst_ball : worst_box;
        worst = std::max(worst, std::fabs(way / (end - from) - 1));
        EXPECT_NEAR(way, end - from, (is_ball ? 0.02 : 0.03) * (end - from)) << seed;
    }
    RecordProperty("worst_ball", std::to_string(worst_ball));
    RecordProperty("worst_box", std::to_string(worst_box));
}

// Balls, and boxes that land flat, rebound with the restitution of the cell that they hit.
TEST(SurfaceMaterials, WhatFallsBouncesAsThePlaceWhereItLandsHasIt) {
    constexpr int cells = 16, bodies = 24;
    for (unsigned seed = 0; seed < 12; ++seed) {
        RandomStart start(seed);
        SurfaceMaterials materials;
        std::vector<double> restitution{start.uniform(0, 0.9)};
        for (int i = 0; i < 6; ++i) {
            restitution.push_back(i == 0 ? 0 : start.uniform(0.2, 0.95));
            materials.materials.push_back(floor_material(0.4f, float(restitution.back())));
        }
        for (int i = 0; i < cells * cells; ++i) materials.numbers.push_back(std::uint16_t(start.uniform(0, 6.999)));
        const Patchwork floor(cells, 1, materials);
        WorldDef settings = with_turned_gravity(start);
        settings.hit_speed = 0.5f;
        World world(settings);
        const BodyId ground = add_body(world, floor.of_kind(int(seed % 2), start), placed(start, {}, BodyType::static_),
                                       floor_material(0.4f, float(restitution[0])));
        struct Falling {
            BodyId id;
            int number;
            bool has_hit = false;
        };
        std::vector<Falling> all;
        for (int i = 0; i < bodies; ++i) {
            // Near the center of a cell of its own.
            const double x = i % 8 * 2 - 7.5 + start.uniform(-0.25, 0.25),
                         z = i / 8 * 2 - 3.5 + start.uniform(-0.25, 0.25);
            BodyDef def = placed(start, {x, start.uniform(0.5, 3), z});
            def.linear_velocity = Vec3(start.turned({0, -start.uniform(0, 20), 0}));
            const Shape shape = i % 2 == 0 ? Shape(Sphere{0.1f}) : Shape(Box{{0.1f, 0.1f, 0.1f}});
            all.push_back({add_body(world, shape, def, yielding()), floor.number_at(x, z)});
        }
        const Vec3 up = Vec3(start.turned({0, 1, 0}));
        for (int n = 0; n < 90; ++n) {
            world.step(frame);
            for (const ContactHit& hit : world.contact_hits())
                for (Falling& body : all) {
                    if (body.has_hit || (hit.body_a != body.id && hit.body_b != body.id)) continue;
                    body.has_hit = true;
                    EXPECT_TRUE(hit.body_a == ground || hit.body_b == ground);
                    EXPECT_EQ(hit.surface_material, body.number) << seed;
                    const double left = frame - hit.time, e = restitution[std::size_t(body.number)];
                    // The body has been in free flight since the hit, or has come to rest.
                    const double after = double(glm::dot(world.body(body.id).linear_velocity(), up));
                    const double meant = e * double(hit.approach_speed) - gravity * left;
                    EXPECT_NEAR(after, e > 0 ? meant : 0, 0.01 * double(hit.approach_speed) + 0.02)
                        << "seed " << seed << ", restitution " << e << ", at " << hit.approach_speed << " m/s";
                }
        }
        for (const Falling& body : all) EXPECT_TRUE(body.has_hit);
    }
}

Shape bumpy_field(unsigned seed, const SurfaceMaterials& materials) {
    RandomStart start(seed);
    std::vector<float> heights;
    for (int i = 0; i < 21 * 21; ++i) heights.push_back(float(start.uniform(0, 0.4)));
    return HeightField(21, 21, {0.5f, 0.5f}, heights, materials);
}
// Drops 60 bodies of all kinds onto the floor.
void throw_bodies(World& world, unsigned seed) {
    RandomStart start(seed);
    const Shape shapes[] = {Sphere{0.15f}, Box{{0.2f, 0.1f, 0.15f}}, Capsule{0.15f, 0.1f, {}},
                            Cylinder{0.1f, 0.15f, {}}, Hull(box_corners({0.1f, 0.2f, 0.15f}))};
    for (int i = 0; i < 60; ++i) {
        const RandomStart turned(1000 * seed + unsigned(i));
        BodyDef def;
        def.position = {start.uniform(-3, 3), start.uniform(1, 4), start.uniform(-3, 3)};
        def.rotation = turned.quat();
        def.linear_velocity = Vec3(turned.turned({start.uniform(0, 8), 0, 0}));
        Material material = surface(0.5f, i % 3 == 0 ? 0.5f : 0);
        material.rolling_friction = 0.01f;
        add_body(world, shapes[i % 5], def, material);
    }
}

// A material given for all triangles has, to the last bit, the effect of the same material given for the shape.
TEST(SurfaceMaterials, OneForAllTrianglesIsAsThatOfTheShape) {
    const Material material = surface(0.3f, 0.4f);
    for (unsigned seed = 0; seed < 6; ++seed) {
        World of_shape, of_triangles;
        BodyDef def;
        def.type = BodyType::static_;
        add_body(of_shape, bumpy_field(seed, {}), def, material);
        add_body(of_triangles, bumpy_field(seed, {{surface(0), material}, std::vector<std::uint16_t>(400, 2)}), def,
                 surface(0.9f));
        for (World* world : {&of_shape, &of_triangles}) {
            throw_bodies(*world, seed);
            run(*world, frame, 180);
        }
        EXPECT_EQ(of_shape.state_hash(), of_triangles.state_hash()) << seed;
    }
}

// Bodies on several materials at once come to rest, and penetrate no deeper than on one.
TEST(SurfaceMaterials, HeapsOnAPatchworkComeToRest) {
    for (unsigned seed = 0; seed < 6; ++seed) {
        RandomStart start(seed);
        SurfaceMaterials materials{{surface(0.2f), surface(0.9f, 0.5f), surface(0.5f)}, {}};
        for (int i = 0; i < 400; ++i) materials.numbers.push_back(std::uint16_t(start.uniform(0, 3.999)));
        World world;
        BodyDef def;
        def.type = BodyType::static_;
        add_body(world, bumpy_field(seed, materials), def, surface(0.4f));
        for (const Vec3& normal : {Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 0, 1), Vec3(0, 0, -1)}) {
            def.position = Position(-4.9f * normal);
            add_body(world, Plane{normal, {0, 1, 0}, {}}, def);
        }
        throw_bodies(world, seed);
        double deepest = 0;
        for (int i = 0; i < 900; ++i) {
            world.step(frame);
            if (i > 300) deepest = std::max(deepest, deepest_overlap(world));
        }
        EXPECT_LT(deepest, 0.004) << seed;
        double fastest = 0;
        for (const BodyId id : world.bodies())
            fastest = std::max(fastest, double(glm::length(world.body(id).linear_velocity())));
        EXPECT_LT(fastest, 0.02) << seed;
    }
}

// A box slides half on ice and half on rubber, in three stripes along its path: its deceleration is the mean of the
// two.
TEST(SurfaceMaterials, WhatSlidesOnTwoAtOnceIsBrakedByBoth) {
    for (unsigned seed = 0; seed < 12; ++seed) {
        RandomStart start(seed);
        SurfaceMaterials materials{{floor_material(0.1f), floor_material(0.5f)}, {}};
        constexpr int cells = 40;
        for (int x = 0; x < cells; ++x)
            for (int z = 0; z < cells; ++z) materials.numbers.push_back(z == 19 || z == 20 ? 1 : 2);
        World world(with_turned_gravity(start));
        add_body(world, Patchwork(cells, 0.5f, materials).of_kind(int(seed % 2), start),
                 placed(start, {}, BodyType::static_));
        BodyDef def = placed(start, {start.uniform(-8, -7), 0.1, 0});
        const double speed = start.uniform(5, 7);
        def.linear_velocity = Vec3(start.turned({speed, 0, 0}));
        const BodyId body = add_body(world, Box{{0.7f, 0.1f, 1}}, def, yielding());
        run(world, frame, 60);
        const double now = start.back(world.body(body).linear_velocity()).x;
        EXPECT_NEAR((speed - now) / gravity, 0.3, 0.06) << seed; // 0.3 x 1 s
        EXPECT_LT(glm::length(world.body(body).angular_velocity()), 0.02) << seed;
    }
}

// The material of the shape applies to triangles without a material of their own, and to no others.
TEST(SurfaceMaterials, TheMaterialOfTheShapeIsThatOfNumberZero) {
    RandomStart start(1);
    SurfaceMaterials materials{{floor_material(0.3f)}, {}};
    for (int x = 0; x < 4; ++x)
        for (int z = 0; z < 4; ++z) materials.numbers.push_back(std::uint16_t(x / 2));
    World world;
    BodyDef def;
    def.type = BodyType::static_;
    const BodyId ground = add_body(world, Patchwork(4, 5, materials).as_mesh(start), def, floor_material(0.3f));
    std::vector<BodyId> boxes;
    for (const double x : {-5.0, 5.0}) {
        def.type = BodyType::dynamic;
        def.position = {x, 0.1, -9};
        boxes.push_back(add_body(world, Box{{0.1f, 0.1f, 0.1f}}, def, yielding()));
    }
    run(world, frame, 60);
    world.set_material(world.body(ground).shapes()[0], floor_material(0.1f));
    for (const BodyId id : boxes) world.body(id).set_linear_velocity({0, 0, 6});
    run(world, frame, 60);
    EXPECT_NEAR(double(world.body(boxes[0]).linear_velocity().z), 6 - 0.1 * gravity, 0.02);
    EXPECT_NEAR(double(world.body(boxes[1]).linear_velocity().z), 6 - 0.3 * gravity, 0.02);
    // After set_shape with a mesh without materials, the material of the shape applies to all of it.
    world.set_shape(world.body(ground).shapes()[0], flat_mesh(4, 5));
    for (const BodyId id : boxes) world.body(id).set_linear_velocity({0, 0, 6});
    run(world, frame, 60);
    for (const BodyId id : boxes) EXPECT_NEAR(double(world.body(id).linear_velocity().z), 6 - 0.1 * gravity, 0.02);
}

// Ray casts, shape casts and closest-point queries report the triangle; contacts report the material number.
TEST(SurfaceMaterials, QueriesAndContactsNameThePlace) {
    for (unsigned seed = 0; seed < 20; ++seed) {
        RandomStart start(seed);
        SurfaceMaterials materials{std::vector<Material>(9), {}};
        for (int i = 0; i < 100; ++i) materials.numbers.push_back(std::uint16_t(start.uniform(0, 9.999)));
        const Patchwork floor(10, 1, materials);
        const Shape shape = floor.of_kind(int(seed % 2), start);
        World world(with_turned_gravity(start));
        add_body(world, shape, placed(start, {}, BodyType::static_));
        const auto number_of = [&](int triangle) {
            const bool is_mesh = std::holds_alternative<Mesh>(shape);
            const SurfaceMaterials& own =
                is_mesh ? std::get<Mesh>(shape).materials() : std::get<HeightField>(shape).materials();
            const int part = is_mesh ? triangle : triangle / 2;
            return part >= 0 && std::size_t(part) < own.numbers.size() ? int(own.numbers[std::size_t(part)]) : -1;
        };
        for (int i = 0; i < 40; ++i) {
            const auto inside = [&] { return std::floor(start.uniform(-5, 4.999)) + start.uniform(0.1, 0.9); };
            const double x = inside(), z = inside();
            const Position above = start.place({x, 2, z});
            const Vec3 down = Vec3(start.turned({0, -3, 0}));
            const auto ray = world.cast_ray(above, down, 5);
            ASSERT_TRUE(ray);
            EXPECT_EQ(number_of(ray->triangle), floor.number_at(x, z)) << x << " " << z;
            const auto cast = world.cast_shape(Sphere{0.05f}, {above, start.quat()}, down);
            ASSERT_TRUE(cast);
            EXPECT_EQ(number_of(cast->triangle), floor.number_at(x, z)) << x << " " << z;
            const auto near = world.closest_point(above, 5);
            ASSERT_TRUE(near);
            EXPECT_EQ(number_of(near->triangle), floor.number_at(x, z)) << x << " " << z;
        }
        std::vector<std::pair<BodyId, int>> balls;
        for (int i = 0; i < 10; ++i) {
            const double x = i - 4.5 + start.uniform(-0.4, 0.4), z = start.uniform(-0.4, 0.4) - 4.5 + i;
            balls.emplace_back(add_body(world, Sphere{0.05f}, placed(start, {x, 0.05, z})), floor.number_at(x, z));
        }
        run(world, frame, 3);
        const std::vector<Contact> contacts = world.contacts();
        EXPECT_EQ(contacts.size(), balls.size());
        for (const Contact& contact : contacts)
            for (const auto& [ball, number] : balls)
                EXPECT_TRUE(contact.body_a != ball || contact.surface_material == number);
    }
    World world;
    BodyDef def;
    add_body(world, Sphere{1}, def);
    EXPECT_EQ(world.cast_ray({0, 5, 0}, {0, -1, 0}, 9)->triangle, -1);
}

// Runs continue identically from a snapshot, and with any number of threads.
TEST(SurfaceMaterials, AreKeptInSnapshotsAndTheSameForAnyNumberOfThreads) {
    SurfaceMaterials materials{{surface(0.1f, 0.8f), surface(0.9f), surface(0.3f, 0.3f)}, {}};
    for (unsigned i = 0; i < 400; ++i) materials.numbers.push_back(std::uint16_t(i * 2654435761u >> 30));
    std::uint64_t hash = 0;
    for (const int threads : {1, 2, 4}) {
        World world;
        world.set_threads(threads);
        BodyDef def;
        def.type = BodyType::static_;
        add_body(world, bumpy_field(1, materials), def);
        throw_bodies(world, 1);
        run(world, frame, 60);
        const Snapshot half = world.save();
        run(world, frame, 60);
        const std::uint64_t once = world.state_hash();
        world.restore(half);
        run(world, frame, 60);
        EXPECT_EQ(world.state_hash(), once);
        if (threads == 1) hash = once;
        EXPECT_EQ(once, hash) << threads;
    }
}

TEST(SurfaceMaterials, ThatAreNoneAreRefused) {
    const std::vector<Vec3> corners{{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {1, 0, 1}};
    const std::vector<std::uint32_t> indices{0, 1, 2, 2, 1, 3};
    const auto refusal = [&](const SurfaceMaterials& materials) -> std::string {
        try {
            Mesh(corners, indices, materials);
        } catch (const Error& error) {
            return error.field() + ": " + error.value();
        }
        return "none";
    };
    EXPECT_EQ(refusal({{Material{}}, {0, 1}}), "none");
    EXPECT_EQ(refusal({{Material{}}, {}}), "none");
    EXPECT_EQ(refusal({{}, {0, 0}}), "none");
    EXPECT_EQ(refusal({{Material{}}, {0, 2}}), "Mesh materials.numbers[1]: 2");
    EXPECT_EQ(refusal({{Material{}}, {0}}), "Mesh materials.numbers: 1");
    EXPECT_EQ(refusal({{Material{}, surface(-1)}, {}}), "Mesh materials.materials[1].static_friction: -1");
    EXPECT_EQ(refusal({{surface(0, 2)}, {}}), "Mesh materials.materials[0].restitution: 2");
    EXPECT_EQ(refusal({std::vector<Material>(65536), {}}), "Mesh materials.materials: 65536");
    try {
        HeightField(2, 3, {1, 1}, std::vector<float>(6), {{}, {0, 0, 0}});
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.field(), "HeightField materials.numbers");
        EXPECT_EQ(error.value(), "3");
    }
}

} // namespace
