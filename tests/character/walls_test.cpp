// Characters against walls, in corners and gaps: they never pass through, never get stuck, and slide along correctly.
#include "walking.h"

#include <glm/gtc/quaternion.hpp>

namespace {

using namespace cairn_test;

// Adds a wall of one kind: 0 a thin box, 1 a two-sided mesh, 2 a plane, 3 a hull, 4 a thin rectangle. `out`: its
// normal.
void add_wall(World& world, int kind, double distance, double angle) {
    const Quat turn = about_up(angle);
    const Vec3 out = turn * Vec3(1, 0, 0);
    const Position at = -distance * Position(out);
    if (kind == 0) add_fixed(world, at - 0.01 * Position(out), Box{{0.01f, 6, 60}}, turn);
    if (kind == 1) {
        std::vector<Vec3> v;
        std::vector<std::uint32_t> indices;
        for (int i = 0; i <= 100; ++i)
            for (const float y : {-6.0f, 6.0f}) v.push_back({0, y, float(i - 50) * 1.3f});
        for (std::uint32_t i = 0; i < 100; ++i)
            for (const std::uint32_t k : {0u, 2u, 1u, 1u, 2u, 3u, 0u, 1u, 2u, 1u, 3u, 2u}) indices.push_back(2 * i + k);
        add_fixed(world, at, Mesh(v, indices), turn);
    }
    if (kind == 2) add_fixed(world, at, Plane{.normal = {1, 0, 0}}, turn);
    if (kind == 3) {
        std::vector<Vec3> v;
        for (int i = 0; i < 8; ++i) v.push_back({i & 1 ? 0.0f : -0.02f, i & 2 ? 6.0f : -6.0f, i & 4 ? 60.0f : -60.0f});
        add_fixed(world, at, Hull(v), turn);
    }
    if (kind == 4)
        add_fixed(world, at, Plane{.normal = {1, 0, 0}, .tangent = {0, 0, 1}, .half_extents = glm::vec2(60, 6)}, turn);
}

TEST(CharacterWalls, SlidesAlongWallsOfAnyKindAtAnySpeedAndNeverPasses) {
    Chance chance(11);
    for (int i = 0; i < 200; ++i) {
        World world;
        add_floor(world);
        const int kind = i % 5;
        const double angle = chance.between(0, 6.28), distance = chance.between(0.5, 3);
        add_wall(world, kind, distance, angle);
        const BodyId c = add_character(world, {0, 0, 0});
        const double speed = std::pow(10.0, chance.between(0, 2));
        const Vec3 out = about_up(angle) * Vec3(1, 0, 0), along = about_up(angle) * Vec3(0, 0, 1);
        const double toward = chance.between(0.1, 1.4); // angle from along the wall to straight into it
        const Vec3 wanted = float(speed) * (float(std::cos(toward)) * along - float(std::sin(toward)) * out);
        world.body(c).set_walk_velocity(wanted);
        const int steps = int(60 * std::min(1.0, 40 / speed)) + 1;
        double nearest = 1e9;
        for (int s = 0; s < steps; ++s) {
            world.step(frame);
            const Position p = world.body(c).position();
            nearest = std::min(nearest, glm::dot(p, Position(out)) + distance);
            ASSERT_FALSE(overlaps_something(world, c)) << "kind " << kind << " speed " << speed;
        }
        EXPECT_GT(nearest, double(radius)) << "kind " << kind << " speed " << speed;
        const Position p = world.body(c).position();
        const double walked = glm::dot(p, Position(along)), wanted_along = speed * std::cos(toward) * steps / 60.0;
        EXPECT_NEAR(walked, wanted_along, 0.02 * wanted_along + 0.05)
            << "kind " << kind << " speed " << speed << " toward " << toward;
        EXPECT_NEAR(feet_of(world, c).y, 0, 2e-3) << "kind " << kind << " speed " << speed;
    }
}

TEST(CharacterWalls, StaysInCornersOfAnyAngleAndComesOutAgain) {
    Chance chance(12);
    for (int i = 0; i < 150; ++i) {
        World world;
        add_floor(world);
        const double first = chance.between(0, 6.28), opening = chance.between(0.3, 2.4);
        const int kind = i % 5;
        // Two walls whose front sides form a corner with that opening angle.
        add_wall(world, kind, 2, first);
        add_wall(world, kind, 2, first + 3.14159265 - opening);
        const BodyId c = add_character(world, {0, 0, 0});
        const Vec3 into =
            -glm::normalize(about_up(first) * Vec3(1, 0, 0) + about_up(first + 3.14159265 - opening) * Vec3(1, 0, 0));
        const float speed = float(std::pow(10.0, chance.between(0, 2)));
        world.body(c).set_walk_velocity(speed * (into + 0.1f * chance.heading()));
        for (int s = 0; s < 60 + int(600 / speed); ++s) {
            world.step(frame);
            ASSERT_FALSE(overlaps_something(world, c)) << kind << " " << opening << " " << speed;
        }
        const Position there = world.body(c).position();
        run(world, 10);
        EXPECT_LT(glm::length(world.body(c).position() - there), 2e-3) << "it trembles " << opening << " " << speed;
        world.body(c).set_walk_velocity(-3.0f * into);
        run(world, 60);
        EXPECT_NEAR(glm::length(world.body(c).position() - there), 3, 0.1) << kind << " " << opening << " " << speed;
    }
}

TEST(CharacterWalls, PassesThroughGapsThatItFitsAndStopsAtNarrowerOnes) {
    Chance chance(13);
    for (int i = 0; i < 60; ++i) {
        const double gap = i % 2 ? chance.between(0.65, 0.8) : chance.between(0.3, 0.63);
        World world;
        add_floor(world);
        add_fixed(world, {2, 0, 5 + 0.5 * gap}, Box{{0.5f, 3, 5}});
        add_fixed(world, {2, 0, -5 - 0.5 * gap}, Box{{0.5f, 3, 5}});
        const BodyId c = add_character(world, {0, 0, chance.between(-0.1, 0.1)});
        world.body(c).set_walk_velocity({float(chance.between(1, 10)), 0, 0});
        for (int s = 0; s < 300; ++s) {
            world.step(frame);
            ASSERT_FALSE(overlaps_something(world, c));
        }
        if (i % 2)
            EXPECT_GT(world.body(c).position().x, 3) << gap;
        else
            EXPECT_LT(world.body(c).position().x, 2) << gap;
    }
}

TEST(CharacterWalls, AnyConvexShapeIsStoppedInAnyDirectionOfUp) {
    Chance chance(14);
    for (int i = 0; i < 60; ++i) {
        const Quat turn = glm::normalize(Quat(float(chance.between(-1, 1)), float(chance.between(-1, 1)),
                                              float(chance.between(-1, 1)), float(chance.between(-1, 1))));
        WorldDef settings;
        settings.gravity = turn * Vec3(0, -9.81f, 0);
        World world(settings);
        const auto place = [&](const Vec3& p) { return Position(turn * p); };
        add_fixed(world, place({0, -0.5f, 0}), Box{{20, 0.5f, 20}}, turn);
        add_fixed(world, place({3, 0, 0}), Box{{0.05f, 5, 20}}, turn);
        std::vector<Vec3> corners;
        for (int k = 0; k < 12; ++k)
            corners.push_back(
                {float(0.4 * std::cos(k * 1.0472)), k < 6 ? -0.8f : 0.8f, float(0.4 * std::sin(k * 1.0472))});
        const Shape shapes[] = {Capsule{0.5f, 0.3f},
                                Capsule{0.5f, 0.3f, 0.15f},
                                Box{{0.3f, 0.8f, 0.3f}},
                                Cylinder{0.8f, 0.3f},
                                Sphere{0.5f},
                                Hull(corners),
                                Box{{0.2f, 0.7f, 0.2f}, 0.1f},
                                Cylinder{0.7f, 0.2f, {}, 0.1f}};
        const Shape& shape = shapes[i % 8];
        const BodyId c = add_body(world, BodyType::kinematic, place({0, 1.2f, 0}), shape, {}, turn);
        CharacterDef def;
        def.up = 3.0f * (turn * Vec3(0, 1, 0));
        world.body(c).set_character(def);
        run(world, 60);
        ASSERT_TRUE(stands(world, c)) << i % 8;
        const double speed = std::pow(10.0, chance.between(0, 2));
        world.body(c).set_walk_velocity(float(speed) * (turn * Vec3(1, 0, float(chance.between(-0.05, 0.05)))));
        for (int s = 0; s < 30 + int(180 / speed); ++s) {
            world.step(frame);
            ASSERT_FALSE(overlaps_something(world, c, shape)) << i % 8;
        }
        const Vec3 there = glm::conjugate(turn) * Vec3(world.body(c).position());
        EXPECT_GT(there.x, 2.2f) << i % 8;
        EXPECT_LT(there.x, 3.0f) << i % 8;
        EXPECT_TRUE(stands(world, c)) << i % 8 << " " << there.x << " " << there.y << " " << there.z << " " << speed;
    }
}

TEST(CharacterWalls, ComesOutOfWhatOverlapsIt) {
    Chance chance(15);
    for (int i = 0; i < 60; ++i) {
        World world;
        add_floor(world);
        const Quat turn = about_up(chance.between(0, 6.28));
        add_fixed(world, {0, 0, 0}, Box{{1, 3, 1}}, turn);
        const double depth = chance.between(0, 0.5);
        const Vec3 out = turn * Vec3(1, 0, 0);
        const BodyId c = add_character(world, Position(out * float(1 + radius - depth)));
        ASSERT_EQ(overlaps_something(world, c), depth > 0);
        run(world, 60);
        EXPECT_FALSE(overlaps_something(world, c)) << depth;
        EXPECT_LT(glm::dot(world.body(c).position(), Position(out)), 1 + radius + 0.03) << depth;
    }
}

TEST(CharacterWalls, FallsAlongWallsAndFromCeilings) {
    Chance chance(16);
    for (int i = 0; i < 60; ++i) {
        World world;
        add_floor(world);
        const double angle = chance.between(0, 6.28);
        add_wall(world, i % 5, 1, angle);
        add_fixed(world, {0, 5, 0}, Box{{20, 0.5f, 20}});
        const Vec3 out = about_up(angle) * Vec3(1, 0, 0);
        const BodyId c = add_character(world, {0, 0, 0});
        run(world, 3);
        world.body(c).jump(12); // 7 m if there were no ceiling
        world.body(c).set_walk_velocity(-5.0f * out);
        double highest = 0;
        int in_the_air = 0;
        for (int s = 0; s < 120; ++s) {
            world.step(frame);
            ASSERT_FALSE(overlaps_something(world, c));
            highest = std::max(highest, feet_of(world, c).y);
            in_the_air += !stands(world, c);
        }
        EXPECT_NEAR(highest, 4.5 - 2 * foot - 2 * usual_skin, 5e-3);
        // Up to the ceiling, and down again from rest: the wall does not slow the fall.
        const double up = (12 - std::sqrt(144 - 2 * 9.81 * highest)) / 9.81, down = std::sqrt(2 * highest / 9.81);
        EXPECT_NEAR(in_the_air / 60.0, up + down, 0.05);
    }
}

} // namespace
