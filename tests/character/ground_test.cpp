// Characters on floors, slopes, stairs and edges.
#include "walking.h"

namespace {

using namespace cairn_test;

// The most visible behavior comes first.

TEST(CharacterGround, AFallingOneLandsAndStandsStill) {
    World world;
    add_floor(world);
    const BodyId c = add_character(world, {0, 2, 0});
    EXPECT_FALSE(stands(world, c));
    run(world, 10);
    EXPECT_NEAR(world.body(c).character_state().velocity.y, -9.81 * 10 / 60, 1e-3);
    run(world, 80);
    ASSERT_TRUE(stands(world, c));
    const Position there = world.body(c).position();
    EXPECT_NEAR(feet_of(world, c).y, 0, 1.5e-3);
    run(world, 60);
    EXPECT_EQ(world.body(c).position(), there);
    EXPECT_EQ(world.body(c).linear_velocity(), Vec3(0));
}

TEST(CharacterGround, WalksWithTheSpeedThatIsAsked) {
    Chance chance(1);
    for (int i = 0; i < 20; ++i) {
        World world;
        add_floor(world);
        const BodyId c = add_character(world, {0, 0, 0});
        const float speed = float(chance.between(0.1, 20));
        const Vec3 heading = chance.heading();
        world.body(c).set_walk_velocity(speed * heading);
        run(world, 60);
        const Position feet = feet_of(world, c), wanted = Position(speed * heading);
        EXPECT_LT(glm::length(feet - Position(0, feet.y, 0) - wanted * (feet.x == feet.x ? 1.0 : 0.0)),
                  0.02 * speed + 2e-3);
        EXPECT_NEAR(feet.y, 0, 2e-3);
        EXPECT_TRUE(stands(world, c));
    }
}

TEST(CharacterGround, JumpsAsHighAsItsSpeedSays) {
    for (const float dt : {1.0f / 30, 1.0f / 60, 1.0f / 240}) {
        World world;
        add_floor(world);
        const BodyId c = add_character(world, {0, 0, 0});
        run(world, 10, dt);
        const double start = world.body(c).position().y;
        world.body(c).jump(5);
        double highest = start;
        for (double t = 0; t < 1; t += double(dt)) {
            world.step(dt);
            highest = std::max(highest, world.body(c).position().y);
        }
        EXPECT_NEAR(highest - start, 25 / (2 * 9.81), 0.01) << dt;
        run(world, int(0.3 / dt), dt);
        EXPECT_NEAR(world.body(c).position().y, start, 2e-3);
        EXPECT_TRUE(stands(world, c));
    }
}

TEST(CharacterGround, ClimbsStairsUpToItsStepHeight) {
    Chance chance(2);
    for (int i = 0; i < 30; ++i) {
        World world;
        add_floor(world);
        const double rise = i % 3 == 0 ? 0.2995 : chance.between(0.02, 0.29), tread = chance.between(0.25, 0.6);
        const double angle = chance.between(-0.6, 0.6); // angle of approach
        for (int k = 0; k < 10; ++k) add_fixed(world, {1 + tread * k + 5, rise * (k + 1) - 5, 0}, Box{{5, 5, 10}});
        const BodyId c = add_character(world, {0, 0, 0});
        const float speed = float(chance.between(0.5, 6));
        world.body(c).set_walk_velocity(speed * Vec3(std::cos(angle), 0, std::sin(angle)));
        const double way = 1 + 10 * tread + 0.8, seconds = way / (double(speed) * std::cos(angle));
        bool always = true;
        for (int s = 0; s < int(1.2 * seconds * 60); ++s) {
            world.step(frame);
            always = always && (s < 3 || stands(world, c));
            if (feet_of(world, c).x > way) break;
        }
        EXPECT_TRUE(always) << rise << " " << tread << " " << speed;
        EXPECT_NEAR(feet_of(world, c).y, 10 * rise, 2e-3) << rise << " " << tread << " " << speed << " " << angle;
        // And down again, always on the ground.
        world.body(c).set_walk_velocity(-speed * Vec3(std::cos(angle), 0, std::sin(angle)));
        always = true;
        for (int s = 0; s < int(1.2 * seconds * 60) && feet_of(world, c).x > -0.3; ++s) {
            world.step(frame);
            always = always && stands(world, c);
        }
        EXPECT_TRUE(always) << "down " << rise << " " << tread << " " << speed;
        EXPECT_NEAR(feet_of(world, c).y, 0, 2e-3) << rise << " " << tread << " " << speed;
    }
}

TEST(CharacterGround, DoesNotClimbWhatIsHigherThanAStep) {
    Chance chance(3);
    for (int i = 0; i < 20; ++i) {
        World world;
        add_floor(world);
        const double rise = i % 2 == 0 ? 0.304 : chance.between(0.31, 1.5); // without the fix it climbed up to 0.322
        add_fixed(world, {1 + 5, rise - 5, 0}, Box{{5, 5, 1000}});
        const BodyId c = add_character(world, {0, 0, 0});
        world.body(c).set_walk_velocity(float(chance.between(0.5, 20)) * Vec3(1, 0, float(chance.between(-1, 1))));
        run(world, 120);
        EXPECT_NEAR(feet_of(world, c).y, 0, 2e-3) << rise;
        EXPECT_LT(feet_of(world, c).x, 1 - radius);
    }
}

TEST(CharacterGround, WalksUpSlopesUpToItsLimitAndSlidesDownSteeperOnes) {
    Chance chance(4);
    for (int i = 0; i < 40; ++i) {
        World world;
        const double limit = chance.between(0.3, 1.0), slope = chance.between(0.05, 1.3);
        if (std::fabs(limit - slope) < 0.02) continue;
        // The plane rises along x.
        const Vec3 normal(-float(std::sin(slope)), float(std::cos(slope)), 0);
        add_fixed(world, {0, 0, 0}, Plane{.normal = normal});
        CharacterDef def;
        def.max_slope = float(limit);
        const double gap = radius / std::cos(slope) - radius;
        const BodyId c = add_character(world, {0, gap + 0.05, 0}, def);
        run(world, 60);
        const Position before = world.body(c).position();
        if (slope < limit) {
            EXPECT_TRUE(stands(world, c)) << slope << " " << limit;
            run(world, 60);
            EXPECT_LT(glm::length(world.body(c).position() - before), 1e-6) << "creeps";
            const float speed = float(chance.between(1, 10));
            const Vec3 heading = chance.heading();
            world.body(c).set_walk_velocity(speed * heading);
            run(world, 60);
            const Position way = world.body(c).position() - before;
            EXPECT_NEAR(glm::length(way), speed, 0.02 * speed) << slope;
            EXPECT_NEAR(way.y, way.x * std::tan(slope), 0.01 * speed);
            EXPECT_NEAR(way.x * double(heading.z), way.z * double(heading.x), 1e-2 * speed);
        } else {
            EXPECT_EQ(world.body(c).character_state().support, CharacterSupport::steep) << slope << " " << limit;
            EXPECT_LT(before.x, -0.3) << slope;
            // The character cannot walk up, and accelerates as on ice.
            const double speed = double(glm::length(world.body(c).character_state().velocity));
            world.body(c).set_walk_velocity({5, 0, 0});
            run(world, 30);
            EXPECT_NEAR(double(glm::length(world.body(c).character_state().velocity)) - speed,
                        9.81 * std::sin(slope) * 0.5, 0.1)
                << slope;
        }
    }
}

TEST(CharacterGround, WalksOverFlatMeshesWithoutABump) {
    Chance chance(5);
    constexpr int n = 40;
    std::vector<Vec3> vertices;
    std::vector<std::uint32_t> indices;
    for (int r = 0; r <= n; ++r)
        for (int c = 0; c <= n; ++c) vertices.push_back({float(c) * 0.37f - 7, 0, float(r) * 0.29f - 6});
    for (std::uint32_t r = 0; r < n; ++r)
        for (std::uint32_t c = 0; c < n; ++c) {
            const std::uint32_t i = r * (n + 1) + c, up = i + n + 1;
            for (const std::uint32_t k : {i, up, i + 1, i + 1, up, up + 1}) indices.push_back(k);
        }
    for (int i = 0; i < 20; ++i) {
        World world;
        add_fixed(world, {0, 0, 0}, Mesh(vertices, indices));
        const BodyId c = add_character(world, {chance.between(-1, 1), 0, chance.between(-1, 1)});
        run(world, 10);
        const Position start = world.body(c).position();
        const float speed = float(chance.between(0.2, 5));
        const Vec3 heading = chance.heading();
        world.body(c).set_walk_velocity(speed * heading);
        double highest = 0;
        for (int s = 0; s < 60; ++s) {
            world.step(frame);
            highest = std::max(highest, std::fabs(world.body(c).position().y - start.y));
            EXPECT_TRUE(stands(world, c));
        }
        EXPECT_LT(highest, 1e-4);
        EXPECT_LT(glm::length(world.body(c).position() - start - Position(speed * heading)), 1e-3 * speed);
    }
}

} // namespace
