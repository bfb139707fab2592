// Characters on height fields and in crowded rooms: on long random walks they stay above the ground and inside, and
// make progress.
#include "walking.h"

#include <algorithm>

namespace {

using namespace cairn_test;

// A closed room, 20 m wide and 6 m high, as one mesh that faces inwards.
void add_room(World& world) {
    const std::vector<Vec3> v{{-10, 0, -10}, {10, 0, -10}, {10, 0, 10}, {-10, 0, 10},
                              {-10, 6, -10}, {10, 6, -10}, {10, 6, 10}, {-10, 6, 10}};
    const std::uint32_t faces[6][4] = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4},
                                       {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
    std::vector<std::uint32_t> indices;
    for (const auto& f : faces)
        for (const int k : {0, 1, 2, 0, 2, 3}) indices.push_back(f[k]);
    add_fixed(world, {0, 0, 0}, Mesh(v, indices));
}

TEST(CharacterTerrain, StaysInARoomFullOfThingsAtAnySpeed) {
    for (unsigned seed = 0; seed < 12; ++seed) {
        Chance chance(100 + seed);
        World world;
        add_room(world);
        for (int i = 0; i < 40; ++i) {
            const Quat turn = glm::normalize(
                Quat(1, float(chance.between(-1, 1)), float(chance.between(-1, 1)), float(chance.between(-1, 1))));
            const Position at(chance.between(-9, 9), chance.between(0, 2), chance.between(-9, 9));
            if (std::hypot(at.x, at.z) < 2.5) continue;
            const Vec3 size(float(chance.between(0.1, 1.2)), float(chance.between(0.1, 1.2)),
                            float(chance.between(0.1, 1.2)));
            if (i % 3 == 0)
                add_fixed(world, at, Box{size}, turn);
            else if (i % 3 == 1)
                add_fixed(world, at, Cylinder{size.x, size.y}, turn);
            else
                add_body(world, BodyType::dynamic, at + Position(0, 3, 0), Box{0.4f * size}, {.density = 300}, turn);
        }
        const BodyId c = add_character(world, {0, 0.1, 0});
        const double fastest = std::pow(10.0, chance.between(0.3, 2));
        double walked = 0;
        Position last = world.body(c).position();
        for (int s = 0; s < 1200; ++s) {
            if (s % 40 == 0)
                world.body(c).set_walk_velocity(float(chance.between(0.3, 1) * fastest) * chance.heading());
            if (s % 97 == 0) world.body(c).jump(float(chance.between(1, 8)));
            world.step(frame);
            const Position p = world.body(c).position();
            ASSERT_LT(std::max(std::fabs(p.x), std::fabs(p.z)), 10 - 0.9 * radius)
                << seed << " " << s << " " << fastest;
            ASSERT_GT(p.y, 0.95 * foot) << seed << " " << s << " " << fastest;
            ASSERT_LT(p.y, 6 - 0.95 * foot) << seed << " " << s << " " << fastest;
            walked += glm::length(p - last), last = p;
        }
        EXPECT_GT(walked, 20) << seed << ": it got stuck";
    }
}

TEST(CharacterTerrain, WalksOverHillsOfAHeightField) {
    for (unsigned seed = 0; seed < 8; ++seed) {
        Chance chance(200 + seed);
        constexpr int n = 60;
        std::vector<float> heights;
        const double height = chance.between(0.05, 0.9);
        for (int i = 0; i < n * n; ++i) heights.push_back(float(chance.between(0, height)));
        // A border that is too high to leave.
        for (int i = 0; i < n; ++i)
            for (const int k : {i, n * (n - 1) + i, n * i, n * i + n - 1}) heights[std::size_t(k)] = 30;
        World world;
        const HeightField field(n, n, {0.7f, 0.7f}, heights);
        const BodyId ground = add_fixed(world, {0, 0, 0}, field);
        const BodyId c = add_character(world, {0, 3, 0});
        const double fastest = std::pow(10.0, chance.between(0, 1));
        double walked = 0;
        Position last = world.body(c).position();
        for (int s = 0; s < 900; ++s) {
            if (s % 60 == 0) world.body(c).set_walk_velocity(float(fastest) * chance.heading());
            world.step(frame);
            const Position p = world.body(c).position();
            const auto below = world.cast_ray(p, {0, -1, 0}, 100, {.ignored_bodies = {c}});
            ASSERT_TRUE(below && below->body == ground) << seed << " " << s << ": it fell through";
            const Position middle = p - Position(0, double(half_height), 0); // center of the lower hemisphere
            const auto nearest = world.closest_point(middle, 1, {.ignored_bodies = {c}});
            if (nearest) {
                ASSERT_GT(nearest->distance, 0.97 * radius) << seed << " " << s;
            }
            walked += glm::length(p - last), last = p;
        }
        EXPECT_GT(walked, 5) << seed << " " << height << " " << fastest;
    }
}

TEST(CharacterTerrain, ClimbsStairsOfAMeshFromAnySide) {
    Chance chance(31);
    for (int i = 0; i < 20; ++i) {
        const double rise = chance.between(0.1, 0.28), turn = chance.between(0, 6.28);
        std::vector<Vec3> v;
        std::vector<std::uint32_t> indices;
        const auto quad = [&](const Position& a, const Position& b, const Position& c, const Position& d) {
            const auto first = std::uint32_t(v.size());
            for (const Position& p : {a, b, c, d}) v.push_back(Vec3(p));
            for (const std::uint32_t k : {0u, 1u, 2u, 0u, 2u, 3u}) indices.push_back(first + k);
        };
        quad({-5, 0, 3}, {1, 0, 3}, {1, 0, -3}, {-5, 0, -3});
        for (int k = 0; k < 8; ++k) {
            const double x = 1 + 0.4 * k, y = rise * k, end = k == 7 ? x + 4 : x + 0.4;
            quad({x, y, 3}, {x, y + rise, 3}, {x, y + rise, -3}, {x, y, -3});
            quad({x, y + rise, 3}, {end, y + rise, 3}, {end, y + rise, -3}, {x, y + rise, -3});
        }
        World world;
        const Quat about(float(std::cos(0.5 * turn)), 0, float(std::sin(0.5 * turn)), 0);
        add_fixed(world, {0, 0, 0}, Mesh(v, indices), about);
        const BodyId c = add_character(world, {0, 0, 0});
        const Vec3 way = about * glm::normalize(Vec3(1, 0, float(chance.between(-0.25, 0.25))));
        const float speed = float(chance.between(1, 5));
        world.body(c).set_walk_velocity(speed * way);
        double fastest = 0;
        for (int s = 0; s < 1000 && glm::dot(world.body(c).position(), Position(about * Vec3(1, 0, 0))) < 5; ++s) {
            world.step(frame);
            ASSERT_TRUE(s < 2 || stands(world, c)) << rise;
            fastest = std::max(fastest, double(world.body(c).linear_velocity().y));
        }
        EXPECT_NEAR(feet_of(world, c).y, 8 * rise, 2e-3);
        EXPECT_LT(fastest, double(speed)) << "steps are no motion";
    }
}

} // namespace
