// Ray casts and overlap tests, compared with closed forms and with brute force.
#include "test_world.h"

#include <algorithm>
#include <random>
#include <thread>
#include <vector>

namespace cairn::test {
namespace {

using DVec = glm::dvec3;

constexpr double endless = std::numeric_limits<double>::infinity();

DVec turn_back(const Quat& q, const DVec& v) { return glm::conjugate(glm::normalize(glm::dquat(q))) * v; }

Plane rectangle(const Vec3& normal, const Vec3& tangent, const glm::vec2& half_extents) {
    Plane plane;
    plane.normal = normal;
    plane.tangent = tangent;
    plane.half_extents = half_extents;
    return plane;
}

// --- each shape

TEST(CastRay, MeetsASphereWhereTheQuadraticSays) {
    World world;
    const BodyId body = add_body(world, body_at({3.0, -1.0, 2.0}, BodyType::static_), Sphere{1.5f});
    const Position origin(-7.0, 0.2, 2.3);
    const auto hit = world.cast_ray(origin, {10.0f, 0.0f, 0.0f}, endless);
    ASSERT_TRUE(hit);
    const double x = 3.0 - std::sqrt(1.5 * 1.5 - 1.2 * 1.2 - 0.3 * 0.3);
    EXPECT_NEAR(hit->distance, x + 7.0, 1e-6);
    EXPECT_NEAR(hit->point.x, x, 1e-6);
    const DVec normal = (hit->point - Position(3.0, -1.0, 2.0)) / 1.5;
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(hit->normal[i], normal[i], 1e-6);
    EXPECT_EQ(hit->body, body);
    EXPECT_EQ(hit->shape, world.body(body).shapes()[0]);
}

TEST(CastRay, MeetsEachFaceOfABox) {
    World world;
    add_body(world, body_at({1.0, 2.0, 3.0}, BodyType::static_), Box{{0.5f, 1.0f, 1.5f}});
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {-1.0, 1.0}) {
            Position origin(1.1, 2.1, 3.1);
            origin[axis] += 10 * side;
            Vec3 direction(0.0f);
            direction[axis] = float(-0.25 * side);
            const auto hit = world.cast_ray(origin, direction, 100.0);
            ASSERT_TRUE(hit);
            const double half = 0.5 * (axis + 1);
            EXPECT_NEAR(hit->distance, 10.0 + side * 0.1 - half, 1e-6);
            Vec3 normal(0.0f);
            normal[axis] = float(side);
            EXPECT_EQ(hit->normal, normal);
        }
}

TEST(CastRay, MeetsATurnedBox) {
    World world;
    BodyDef def = body_at({0.0, 0.0, 0.0}, BodyType::static_);
    def.rotation = glm::angleAxis(float(pi / 4), Vec3(0.0f, 0.0f, 1.0f));
    add_body(world, def, Box{});
    const auto hit = world.cast_ray({-5.0, 0.1, 0.0}, {1.0f, 0.0f, 0.0f}, 100.0);
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->point.x, -(std::sqrt(0.5) - 0.1), 1e-6);
    EXPECT_NEAR(hit->normal.x, -std::sqrt(0.5), 1e-6);
    EXPECT_NEAR(hit->normal.y, std::sqrt(0.5), 1e-6);
}

TEST(CastRay, MeetsAPlaneFromAboveAndItsSolidSideFromBelow) {
    World world;
    Plane slope;
    slope.normal = {0.0f, 3.0f, 4.0f};
    add_body(world, body_at({0.0, 1.0, 0.0}, BodyType::static_), slope);
    const auto hit = world.cast_ray({5.0, 6.0, 0.0}, {0.0f, -2.0f, 0.0f}, 100.0);
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->distance, 5.0, 1e-6);
    EXPECT_NEAR(hit->normal.y, 0.6f, 1e-6f);
    EXPECT_NEAR(hit->normal.z, 0.8f, 1e-6f);
    EXPECT_FALSE(world.cast_ray({5.0, 6.0, 0.0}, {0.0f, 1.0f, 0.0f}, 100.0)) << "away from it";
    EXPECT_FALSE(world.cast_ray({5.0, 6.0, 0.0}, {1.0f, 0.0f, 0.0f}, endless)) << "along it";
    const auto below = world.cast_ray({5.0, -6.0, 0.0}, {0.0f, 1.0f, 0.0f}, 100.0);
    ASSERT_TRUE(below) << "a ray that starts in the solid side meets it";
    EXPECT_EQ(below->distance, 0.0);
}

TEST(CastRay, MeetsARectangleWithinItsExtentsAndFromItsFrontOnly) {
    World world;
    // The rectangle measures 2 m along x (the tangent) and 6 m along normal x tangent = -z.
    add_body(world, body_at({0.0, 1.0, 0.0}, BodyType::static_),
             rectangle({0.0f, 1.0f, 0.0f}, {1.0f, 0.0f, 0.0f}, {1.0f, 3.0f}));
    const Vec3 down(0.0f, -1.0f, 0.0f);
    EXPECT_NEAR(world.cast_ray({0.9, 5.0, 2.9}, down, 100.0)->distance, 4.0, 1e-6);
    EXPECT_NEAR(world.cast_ray({-0.9, 5.0, -2.9}, down, 100.0)->distance, 4.0, 1e-6);
    EXPECT_FALSE(world.cast_ray({1.1, 5.0, 0.0}, down, 100.0));
    EXPECT_FALSE(world.cast_ray({0.0, 5.0, 3.1}, down, 100.0));
    EXPECT_FALSE(world.cast_ray({0.0, -5.0, 0.0}, {0.0f, 1.0f, 0.0f}, 100.0)) << "it is one-sided";
}

TEST(CastRay, EndsAtItsLengthAndTakesDirectionsOfAnyLength) {
    World world;
    add_body(world, body_at({0.0, 0.0, 0.0}, BodyType::static_), Sphere{1.0f});
    for (const float scale : {1e-20f, 1.0f, 1e20f}) {
        const auto hit = world.cast_ray({-5.0, 0.0, 0.0}, {scale, 0.0f, 0.0f}, 4.0);
        ASSERT_TRUE(hit) << scale;
        EXPECT_NEAR(hit->distance, 4.0, 1e-9);
        EXPECT_FALSE(world.cast_ray({-5.0, 0.0, 0.0}, {scale, 0.0f, 0.0f}, 3.999));
        EXPECT_FALSE(world.cast_ray({-5.0, 0.0, 0.0}, {-scale, 0.0f, 0.0f}, endless));
    }
    EXPECT_FALSE(world.cast_ray({-5.0, 0.0, 0.0}, {1.0f, 0.0f, 0.0f}, 0.0));
}

TEST(CastRay, DoesNotMeetFromWithinWhatItStartsIn) {
    World world;
    add_body(world, body_at({0.0, 0.0, 0.0}, BodyType::static_), Sphere{1.0f});
    add_body(world, body_at({0.0, 0.0, 0.0}, BodyType::static_), Box{{2.0f, 2.0f, 2.0f}});
    EXPECT_FALSE(world.cast_ray({0.1, 0.2, 0.3}, {1.0f, 0.0f, 0.0f}, endless));
    const BodyId far = add_body(world, body_at({5.0, 0.0, 0.0}, BodyType::static_), Sphere{1.0f});
    const auto hit = world.cast_ray({0.1, 0.0, 0.0}, {1.0f, 0.0f, 0.0f}, endless);
    ASSERT_TRUE(hit) << "it goes on to the next";
    EXPECT_EQ(hit->body, far);
    EXPECT_NEAR(hit->distance, 3.9, 1e-6);
}

TEST(CastRay, IsExactFarFromTheOrigin) {
    World world;
    const Position far(1e7, -2e7, 3e7);
    add_body(world, body_at(far, BodyType::static_), Sphere{1.0f});
    add_body(world, body_at(far + Position(0.0, 10.0, 0.0), BodyType::static_), Box{});
    EXPECT_NEAR(world.cast_ray(far + Position(-5.0, 0.6, 0.0), {1.0f, 0.0f, 0.0f}, 100.0)->distance, 5.0 - 0.8, 1e-5);
    EXPECT_NEAR(world.cast_ray(far + Position(-5.0, 10.2, 0.0), {1.0f, 0.0f, 0.0f}, 100.0)->distance, 4.5, 1e-5);
}

TEST(CastRay, FollowsBodiesThatMoveSleepAndAreRemoved) {
    World world;
    add_ground(world);
    const BodyId crate = add_crate(world, {0.0, 3.0, 0.0});
    const auto down = [&] { return world.cast_ray({0.2, 10.0, 0.2}, {0.0f, -1.0f, 0.0f}, 100.0); };
    EXPECT_NEAR(down()->distance, 6.5, 1e-6) << "before the first step";
    run(world, 240);
    EXPECT_FALSE(world.body(crate).is_awake());
    EXPECT_EQ(down()->body, crate);
    EXPECT_NEAR(down()->distance, 9.0, 0.01);
    world.body(crate).set_position({0.0, 5.0, 0.0});
    EXPECT_NEAR(down()->distance, 4.5, 1e-6) << "at once after a teleport";
    world.destroy_body(crate);
    ASSERT_TRUE(down());
    EXPECT_NE(down()->body, crate) << "at once after a removal";
    EXPECT_NEAR(down()->distance, 10.0, 1e-6);
}

// --- brute force

struct Scene {
    World world{weightless()};
    std::vector<ShapeId> shapes;

    explicit Scene(unsigned seed) {
        std::mt19937 random(seed);
        std::uniform_real_distribution<float> unit(-1.0f, 1.0f), size(0.1f, 1.0f);
        const auto vector = [&] { return Vec3(unit(random), unit(random), unit(random)); };
        for (int i = 0; i < 200; ++i) {
            BodyDef def = body_at(Position(vector()) * 12.0, BodyType(i % 3));
            def.rotation = Quat(unit(random), unit(random), unit(random), unit(random) + 1.5f);
            const BodyId body = world.create_body(def);
            ShapeDef shape = shape_at(vector());
            shape.rotation = Quat(1.5f, unit(random), unit(random), unit(random));
            if (i % 2)
                shapes.push_back(world.add_shape(body, Sphere{size(random)}, shape));
            else
                shapes.push_back(world.add_shape(body, Box{{size(random), size(random), size(random)}}, shape));
        }
    }
};

// Distance along the ray (of unit direction) to a shape, computed from its public description only; negative on a miss.
double brute_distance(const World& world, ShapeId id, const Position& origin, const DVec& direction) {
    const Transform pose = world.shape_transform(id);
    const DVec o = turn_back(pose.rotation, origin - pose.position), d = turn_back(pose.rotation, direction);
    if (const auto* sphere = std::get_if<Sphere>(&world.shape(id))) {
        const double r = sphere->radius, b = glm::dot(o, d), c = glm::dot(o, o) - r * r;
        if (c < 0 || b * b < c || b > 0) return -1;
        return -b - std::sqrt(b * b - c);
    }
    const Vec3 half = std::get<Box>(world.shape(id)).half_extents;
    double enter = -1e300, leave = 1e300;
    for (int i = 0; i < 3; ++i) {
        double t1 = (-double(half[i]) - o[i]) / d[i], t2 = (double(half[i]) - o[i]) / d[i];
        if (t1 > t2) std::swap(t1, t2);
        enter = std::max(enter, t1);
        leave = std::min(leave, t2);
    }
    return enter <= leave && enter > 0 ? enter : -1;
}

TEST(CastRay, FindsWhatBruteForceFinds) {
    Scene scene(7);
    std::mt19937 random(11);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    int hits = 0;
    for (int step = 0; step < 3; ++step) {
        for (int i = 0; i < 2000; ++i) {
            const Position origin(15 * unit(random), 15 * unit(random), 15 * unit(random));
            const Vec3 direction(float(unit(random)), float(unit(random)), float(unit(random)));
            const DVec d = glm::normalize(DVec(direction));
            const double length = 5 + 20 * std::fabs(unit(random));
            std::vector<double> expected;
            for (const ShapeId shape : scene.shapes) {
                const double distance = brute_distance(scene.world, shape, origin, d);
                if (distance >= 0 && distance <= length) expected.push_back(distance);
            }
            std::sort(expected.begin(), expected.end());
            const auto all = scene.world.cast_ray_all(origin, direction, length);
            ASSERT_EQ(all.size(), expected.size()) << "ray " << i;
            for (std::size_t k = 0; k < all.size(); ++k) {
                ASSERT_NEAR(all[k].distance, expected[k], 1e-4);
                ASSERT_NEAR(glm::length(all[k].normal), 1.0f, 1e-5f);
                ASSERT_LT(glm::dot(DVec(all[k].normal), d), 1e-6) << "faces the ray";
                ASSERT_LT(glm::length(all[k].point - (origin + all[k].distance * d)), 1e-9);
            }
            const auto first = scene.world.cast_ray(origin, direction, length);
            ASSERT_EQ(first.has_value(), !expected.empty());
            if (!first) continue;
            ++hits;
            ASSERT_EQ(first->shape, all[0].shape);
            ASSERT_EQ(first->distance, all[0].distance);
        }
        run(scene.world, 30);
    }
    EXPECT_GT(hits, 500);
}

TEST(OverlapBounds, FindsWhatBruteForceFinds) {
    Scene scene(3);
    std::mt19937 random(5);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    std::size_t found = 0;
    for (int i = 0; i < 500; ++i) {
        const Position center(12 * unit(random), 12 * unit(random), 12 * unit(random));
        const Position half(std::fabs(3 * unit(random)), std::fabs(3 * unit(random)), std::fabs(3 * unit(random)));
        const Bounds box{center - half, center + half};
        std::vector<ShapeId> expected;
        for (const ShapeId shape : scene.shapes) {
            const Bounds b = scene.world.shape_bounds(shape);
            if (glm::all(glm::lessThanEqual(b.min, box.max)) && glm::all(glm::lessThanEqual(box.min, b.max)))
                expected.push_back(shape);
        }
        std::sort(expected.begin(), expected.end());
        const auto result = scene.world.overlap_bounds(box);
        ASSERT_EQ(result, expected);
        found += result.size();
    }
    EXPECT_GT(found, 500u);
    EXPECT_TRUE(scene.world.overlap_bounds({Position(1.0), Position(-1.0)}).empty()) << "an empty box";
    EXPECT_EQ(scene.world.overlap_bounds({Position(-endless), Position(endless)}).size(), scene.shapes.size());
}

TEST(ShapeBounds, AreTight) {
    World world;
    BodyDef def = body_at({1.0, 2.0, 3.0});
    def.rotation = glm::angleAxis(float(pi / 4), Vec3(0.0f, 0.0f, 1.0f));
    const BodyId body = add_body(world, def, Box{});
    const Bounds box = world.shape_bounds(world.body(body).shapes()[0]);
    EXPECT_NEAR(box.min.x, 1.0 - std::sqrt(0.5), 1e-5);
    EXPECT_NEAR(box.max.y, 2.0 + std::sqrt(0.5), 1e-5);
    EXPECT_NEAR(box.max.z, 3.5, 1e-5);
    const BodyId ground = add_ground(world);
    const Bounds plane = world.shape_bounds(world.body(ground).shapes()[0]);
    EXPECT_EQ(plane.min.x, -endless);
    EXPECT_EQ(plane.max.y, endless);
}

// --- overlap

TEST(Overlap, SphereAgainstEachShape) {
    World world;
    const BodyId ball = add_body(world, body_at({0.0, 5.0, 0.0}, BodyType::static_), Sphere{1.0f});
    const BodyId box = add_body(world, body_at({5.0, 5.0, 0.0}, BodyType::static_), Box{{1.0f, 1.0f, 1.0f}});
    const BodyId ground = add_ground(world);
    const BodyId tray = add_body(world, body_at({10.0, 5.0, 0.0}, BodyType::static_),
                                 rectangle({0.0f, 1.0f, 0.0f}, {1.0f, 0.0f, 0.0f}, {1.0f, 1.0f}));
    const auto shape_of = [&](BodyId body) { return world.body(body).shapes()[0]; };
    struct Case {
        BodyId body;
        Position touching, apart;
    };
    for (const Case& c :
         {Case{ball, {1.49, 5.0, 0.0}, {1.51, 5.0, 0.0}},
          Case{box, {5.0 + 1.0 + 0.35, 5.0 + 1.0 + 0.35, 0.0}, {5.0 + 1.36, 5.0 + 1.36, 0.0}},
          Case{ground, {-7.0, 0.49, 0.0}, {-7.0, 0.51, 0.0}}, Case{tray, {10.9, 5.49, 0.0}, {10.9, 5.51, 0.0}}}) {
        EXPECT_EQ(world.overlap(Sphere{0.5f}, {c.touching, Quat(1, 0, 0, 0)}), std::vector<ShapeId>{shape_of(c.body)});
        EXPECT_TRUE(world.overlap(Sphere{0.5f}, {c.apart, Quat(1, 0, 0, 0)}).empty());
    }
}

TEST(Overlap, TurnedBoxAgainstEachShape) {
    World world;
    const BodyId ball = add_body(world, body_at({0.0, 5.0, 0.0}, BodyType::static_), Sphere{1.0f});
    const BodyId box = add_body(world, body_at({5.0, 5.0, 0.0}, BodyType::static_), Box{{1.0f, 1.0f, 1.0f}});
    const BodyId ground = add_ground(world);
    const Quat turned = glm::angleAxis(float(pi / 4), Vec3(0.0f, 0.0f, 1.0f));
    const double corner = 0.5 * std::sqrt(2.0);
    struct Case {
        BodyId body;
        Position touching, apart;
    };
    for (const Case& c : {Case{ball, {1.0 + corner - 0.01, 5.0, 0.0}, {1.0 + corner + 0.01, 5.0, 0.0}},
                          Case{box, {5.0 + 1.0 + corner - 0.01, 5.0, 0.0}, {5.0 + 1.0 + corner + 0.01, 5.0, 0.0}},
                          Case{ground, {-7.0, corner - 0.01, 0.0}, {-7.0, corner + 0.01, 0.0}}}) {
        EXPECT_EQ(world.overlap(Box{}, {c.touching, turned}), std::vector<ShapeId>{world.body(c.body).shapes()[0]});
        EXPECT_TRUE(world.overlap(Box{}, {c.apart, turned}).empty());
    }
}

TEST(Overlap, DeepWithinAndAroundAndWithPlanes) {
    World world;
    const BodyId big = add_body(world, body_at({0.0, 20.0, 0.0}, BodyType::static_), Box{{5.0f, 5.0f, 5.0f}});
    const BodyId small = add_body(world, body_at({0.5, 20.0, 0.0}), Sphere{0.1f});
    const auto result = world.overlap(Sphere{0.3f}, {{0.4, 20.0, 0.0}, Quat(1, 0, 0, 0)});
    EXPECT_EQ(result, (std::vector<ShapeId>{world.body(big).shapes()[0], world.body(small).shapes()[0]}))
        << "in order of slot index";
    // Both bodies lie in the half-space below y = 30; the overlap of two planes is not tested.
    add_ground(world);
    EXPECT_EQ(world.overlap(Plane{}, {{0.0, 30.0, 0.0}, Quat(1, 0, 0, 0)}).size(), 2u);
    EXPECT_TRUE(world.overlap(Plane{}, {{0.0, 10.0, 0.0}, Quat(1, 0, 0, 0)}).empty());
}

TEST(Overlap, DoesNotDependOnSleepOrOnSteps) {
    World world;
    add_ground(world);
    const BodyId crate = add_crate(world, {0.0, 0.5, 0.0});
    const auto near = [&] { return world.overlap(Sphere{0.1f}, {{0.0, 1.05, 0.0}, Quat(1, 0, 0, 0)}).size(); };
    EXPECT_EQ(near(), 1u);
    run(world, 200);
    EXPECT_FALSE(world.body(crate).is_awake());
    EXPECT_EQ(near(), 1u);
    world.remove_shape(world.body(crate).shapes()[0]);
    EXPECT_EQ(near(), 0u);
}

// --- threads

TEST(Queries, ManyThreadsGetTheSameAnswersAsOne) {
    Scene scene(21);
    run(scene.world, 20);
    const World& world = scene.world;
    const auto ask = [&world](unsigned seed) {
        std::mt19937 random(seed);
        std::uniform_real_distribution<float> unit(-1.0f, 1.0f);
        std::vector<double> answers;
        for (int i = 0; i < 300; ++i) {
            const Position p(12 * unit(random), 12 * unit(random), 12 * unit(random));
            const Vec3 d(unit(random), unit(random), unit(random));
            const auto hit = world.cast_ray(p, d, 30.0);
            answers.push_back(hit ? hit->distance : -1);
            answers.push_back(double(world.cast_ray_all(p, d, 30.0).size()));
            for (const ShapeId shape : world.overlap(Box{{2.0f, 1.0f, 3.0f}}, {p, Quat(1, 0, 0, 0)}))
                answers.push_back(shape.index());
            for (const ShapeId shape : world.overlap_bounds({p, p + 3.0})) answers.push_back(shape.index());
            answers.push_back(double(world.contacts().size()));
            answers.push_back(world.kinetic_energy());
            answers.push_back(double(world.state_hash() & 0xffffffff));
            answers.push_back(double(world.statistics().contacts));
        }
        return answers;
    };
    std::vector<std::vector<double>> alone(8), together(8);
    for (unsigned i = 0; i < 8; ++i) alone[i] = ask(i);
    std::vector<std::thread> threads;
    for (unsigned i = 0; i < 8; ++i) threads.emplace_back([&, i] { together[i] = ask(i); });
    for (std::thread& thread : threads) thread.join();
    for (unsigned i = 0; i < 8; ++i) EXPECT_EQ(alone[i], together[i]) << "thread " << i;
}

} // namespace
} // namespace cairn::test
