// API calls on characters: which are valid, and what survives saving, recording and many threads.
#include "walking.h"

#include <cairn/history.h>
#include <cairn/snapshot_ring.h>

#include <functional>
#include <limits>
#include <string>

namespace {

using namespace cairn_test;

constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();

// The field of the error that a call throws; empty if it throws none.
std::string refused(const std::function<void()>& call) {
    try {
        call();
    } catch (const Error& error) {
        return error.field();
    }
    return {};
}

TEST(CharacterCalls, RefuseWhatTheyCannotDoAndChangeNothing) {
    World world;
    add_floor(world);
    const BodyId c = add_character(world, {0, 0, 0}), box = add_body(world, BodyType::dynamic, {5, 1, 0}, Box{});
    run(world, 5);
    const auto before = world.save().bytes;
    const auto with = [&](auto member, float value) {
        return refused([&] {
            CharacterDef def;
            def.*member = value;
            world.body(c).set_character(def);
        });
    };
    for (const float bad : {-1.0f, not_a_number, -std::numeric_limits<float>::infinity()}) {
        EXPECT_EQ(with(&CharacterDef::max_slope, bad), "CharacterDef.max_slope");
        EXPECT_EQ(with(&CharacterDef::step_height, bad), "CharacterDef.step_height");
        EXPECT_EQ(with(&CharacterDef::stick_distance, bad), "CharacterDef.stick_distance");
        EXPECT_EQ(with(&CharacterDef::skin, bad), "CharacterDef.skin");
        EXPECT_EQ(with(&CharacterDef::mass, bad), "CharacterDef.mass");
        EXPECT_EQ(with(&CharacterDef::max_push_force, bad), "CharacterDef.max_push_force");
        EXPECT_EQ(with(&CharacterDef::air_acceleration, bad), "CharacterDef.air_acceleration");
        EXPECT_EQ(refused([&] { world.body(c).jump(bad); }), "Body::jump speed");
    }
    EXPECT_EQ(with(&CharacterDef::max_slope, 1.6f), "CharacterDef.max_slope");
    EXPECT_EQ(with(&CharacterDef::skin, 0.0f), "CharacterDef.skin");
    EXPECT_EQ(refused([&] { world.body(c).jump(0); }), "Body::jump speed");
    EXPECT_EQ(refused([&] { world.body(c).set_walk_velocity({0, not_a_number, 0}); }), "Body::set_walk_velocity");
    EXPECT_EQ(refused([&] { world.body(c).set_walk_velocity({1e30f, 0, 0}); }), "Body::set_walk_velocity");
    EXPECT_EQ(refused([&] { world.body(c).set_character({.up = {0, 0, 0}}); }), "CharacterDef.up");
    EXPECT_EQ(refused([&] { world.body(c).set_character({.up = {0, not_a_number, 0}}); }), "CharacterDef.up");
    EXPECT_EQ(refused([&] { world.body(c).set_type(BodyType::dynamic); }), "Body::set_type");
    EXPECT_EQ(refused([&] { world.body(box).set_character({}); }), "Body::set_character");
    EXPECT_EQ(refused([&] { world.body(box).set_walk_velocity({}); }), "Body::set_walk_velocity");
    EXPECT_EQ(refused([&] { world.body(box).jump(1); }), "Body::jump");
    EXPECT_EQ(refused([&] { world.body(box).remove_character(); }), "Body::remove_character");
    EXPECT_EQ(refused([&] { world.body(box).character_state(); }), "Body::character_state");
    EXPECT_EQ(refused([&] { world.body(box).character(); }), "Body::character");
    EXPECT_EQ(refused([&] { world.body(box).walk_velocity(); }), "Body::walk_velocity");
    EXPECT_EQ(world.save().bytes, before);
}

TEST(CharacterCalls, TellWhatWasAskedFor) {
    World world;
    const BodyId c = add_character(world, {0, 0, 0});
    CharacterDef def{.up = {0, 0, 5},
                     .max_slope = 0.5f,
                     .step_height = 0.1f,
                     .stick_distance = 0.2f,
                     .skin = 0.01f,
                     .mass = 50,
                     .max_push_force = 100,
                     .air_acceleration = 3,
                     .flies = true};
    world.body(c).set_character(def);
    const CharacterDef told = world.body(c).character();
    EXPECT_EQ(told.up, Vec3(0, 0, 1));
    EXPECT_EQ(told.max_slope, def.max_slope);
    EXPECT_EQ(told.step_height, def.step_height);
    EXPECT_EQ(told.stick_distance, def.stick_distance);
    EXPECT_EQ(told.skin, def.skin);
    EXPECT_EQ(told.mass, def.mass);
    EXPECT_EQ(told.max_push_force, def.max_push_force);
    EXPECT_EQ(told.air_acceleration, def.air_acceleration);
    EXPECT_TRUE(told.flies);
    world.body(c).set_walk_velocity({1, 2, 3});
    EXPECT_EQ(world.body(c).walk_velocity(), Vec3(1, 2, 3));
    run(world, 60);
    EXPECT_LT(glm::length(world.body(c).position() - Position(1, 2 + double(foot + usual_skin), 3)), 1e-3);
    world.body(c).remove_character();
    EXPECT_FALSE(world.body(c).is_character());
    const Position there = world.body(c).position();
    run(world, 10);
    EXPECT_EQ(world.body(c).position(), there);
    world.destroy_body(c);
    run(world, 2);
    EXPECT_EQ(refused([&] { world.body(c); }), "BodyId");
}

TEST(CharacterCalls, AreNoFasterThanTheWorldAllows) {
    World world(WorldDef{.max_linear_speed = 5});
    add_floor(world);
    const BodyId c = add_character(world, {0, 0, 0});
    world.body(c).set_walk_velocity({1e15f, 0, 0});
    run(world, 60);
    EXPECT_NEAR(world.body(c).position().x, 5, 0.01);
    world.body(c).set_character({.flies = true});
    run(world, 60);
    EXPECT_NEAR(world.body(c).position().x, 10, 0.01);
}

TEST(CharacterCalls, StaySaneBeyondMeasure) {
    for (const float dt : {1e-30f, 1e-6f, 1.0f, 1e30f}) {
        for (const float gravity : {0.0f, -1e30f, 3e38f}) {
            World world(WorldDef{.gravity = {0, gravity, 0}});
            add_floor(world);
            const BodyId c = add_character(world, {1e15, 0, 0}), d = add_character(world, {0, 0, 0});
            world.body(d).set_gravity_scale(-3e38f);
            world.body(d).set_walk_velocity({1e15f, 0, 0});
            for (int s = 0; s < 5; ++s) {
                world.body(d).jump(1e15f);
                world.step(dt);
            }
            World other;
            other.restore(world.save()); // throws if a value is NaN
            EXPECT_TRUE(std::isfinite(world.body(c).position().x + world.body(d).position().y)) << dt << " " << gravity;
        }
    }
}

TEST(CharacterCalls, WhatOneStandsOnMayGo) {
    World world;
    const BodyId floor = add_floor(world);
    const BodyId platform = add_fixed(world, {0, 1, 0}, Box{{1, 0.1f, 1}});
    const BodyId c = add_character(world, {0, 1.1, 0});
    run(world, 5);
    EXPECT_EQ(world.body(c).character_state().ground_body, platform);
    EXPECT_EQ(world.body(c).character_state().ground_shape, world.body(platform).shapes()[0]);
    EXPECT_NEAR(world.body(c).character_state().ground_point.y, 1.1, 1e-3);
    EXPECT_EQ(world.body(c).character_state().ground_normal, Vec3(0, 1, 0));
    world.destroy_body(platform);
    EXPECT_TRUE(world.body(c).character_state().ground_body.is_null());
    world.save(); // the saved state is consistent
    World other;
    other.restore(world.save());
    run(world, 60);
    EXPECT_EQ(world.body(c).character_state().ground_body, floor);
    EXPECT_NEAR(feet_of(world, c).y, 0, 2e-3);
}

TEST(CharacterCalls, IsThrownByItsLinearVelocity) {
    World world;
    add_floor(world);
    const BodyId c = add_character(world, {0, 0, 0}, {.air_acceleration = 0});
    run(world, 5);
    world.body(c).set_linear_velocity({3, 4, 0});
    run(world, 30);
    EXPECT_NEAR(world.body(c).position().x, 1.5, 0.01);
    EXPECT_NEAR(feet_of(world, c).y, 4 * 0.5 - 9.81 * 0.125, 0.01);
}

TEST(CharacterCalls, MeetsWhatItsShapeCollidesWithAndNoTriggers) {
    World world;
    add_floor(world);
    ShapeDef ghost;
    ghost.filter.collides_with = 2;
    add_body(world, BodyType::static_, {2, 1, 0}, Box{{0.1f, 1, 5}}, ghost);
    ShapeDef trigger;
    trigger.is_trigger = true;
    add_body(world, BodyType::static_, {4, 1, 0}, Box{{0.1f, 1, 5}}, trigger);
    const BodyId wall = add_fixed(world, {6, 1, 0}, Box{{0.1f, 1, 5}});
    const BodyId c = add_character(world, {0, 0, 0});
    world.body(c).set_walk_velocity({4, 0, 0});
    run(world, 120);
    EXPECT_NEAR(world.body(c).position().x, 6 - 0.1 - double(radius + usual_skin), 2e-3);
    EXPECT_TRUE(world.is_valid(wall));
}

// A small world with every feature of characters; its inputs depend only on the step number.
struct Stroll {
    World world;
    std::vector<BodyId> walkers;
    BodyId lift;
    explicit Stroll(int threads = 1) {
        world.set_threads(threads);
        add_floor(world);
        for (int k = 0; k < 5; ++k) add_fixed(world, {3.0 + 0.4 * k, 0.1 * k, 0}, Box{{0.2f, 0.1f * float(k + 1), 2}});
        lift = add_body(world, BodyType::kinematic, {-3, 0.1, 0}, Box{{1, 0.1f, 1}});
        for (int i = 0; i < 30; ++i)
            add_body(world, BodyType::dynamic, {-1.0 + 0.5 * (i % 5), 0.25 + 0.5 * (i / 15), 2 + 0.5 * (i / 5 % 3)},
                     Box{{0.2f, 0.2f, 0.2f}}, {.density = 200});
        for (int i = 0; i < 4; ++i) walkers.push_back(add_character(world, {0.0, 0, -1.0 + 0.8 * i}));
    }
    void step() {
        const auto n = world.step_count();
        world.body(lift).set_linear_velocity({n % 240 < 120 ? 0.5f : -0.5f, n % 120 < 60 ? 1.0f : -1.0f, 0});
        for (std::size_t i = 0; i < walkers.size(); ++i) {
            Body body = world.body(walkers[i]);
            if ((n + 13 * i) % 50 == 0) {
                const int way = int((n / 50 + i) % 4);
                body.set_walk_velocity(3.0f * Vec3(way == 0   ? 1
                                                   : way == 1 ? -1
                                                              : 0,
                                                   0,
                                                   way == 2   ? 1
                                                   : way == 3 ? -1
                                                              : 0));
            }
            if ((n + 29 * i) % 90 == 0) body.jump(4);
        }
        world.step(frame);
    }
};

TEST(CharacterCalls, GoOnBitForBitFromSnapshotsAndOnAnyNumberOfThreads) {
    Stroll one, four(4);
    SnapshotRing ring(8);
    std::uint64_t foretold = 0;
    for (int s = 0; s < 400; ++s) {
        one.step(), four.step();
        ASSERT_EQ(one.world.state_hash(), four.world.state_hash()) << s;
        if (s % 57 == 50) {
            ASSERT_EQ(one.world.state_hash(), foretold) << s;
        }
        if (s % 57 != 20) continue;
        Stroll other;
        other.world.restore(one.world.save());
        other.walkers = one.walkers, other.lift = one.lift;
        ring.push(other.world);
        for (int k = 0; k < 5; ++k) other.step();
        ring.restore(other.world);
        ASSERT_EQ(other.world.save().bytes, one.world.save().bytes);
        for (int k = 0; k < 30; ++k) other.step();
        foretold = other.world.state_hash();
    }
}

TEST(CharacterCalls, AreUndoneAndRedone) {
    World world;
    add_floor(world);
    const BodyId c = add_character(world, {0, 0, 0});
    run(world, 5);
    History history(world);
    world.body(c).set_walk_velocity({2, 0, 0});
    run(world, 60);
    history.commit(world, "walk");
    const std::uint64_t walked = world.state_hash();
    world.body(c).jump(3);
    run(world, 10);
    history.commit(world, "jump");
    const std::uint64_t jumped = world.state_hash();
    history.undo(world);
    EXPECT_EQ(world.state_hash(), walked);
    EXPECT_EQ(world.body(c).walk_velocity(), Vec3(2, 0, 0));
    history.undo(world);
    EXPECT_EQ(world.body(c).walk_velocity(), Vec3(0, 0, 0));
    history.redo(world), history.redo(world);
    EXPECT_EQ(world.state_hash(), jumped);
}

} // namespace
