// A step in a steady state allocates no memory.
#include "test_world.h"

#include "../sanitized.h"
#include "../unit/allocation_count.h"

namespace cairn::test {
namespace {

WorldDef sleepless() {
    WorldDef def;
    def.enable_sleep = false;
    return def;
}

std::size_t allocations_of(World& world, int steps) {
    const std::size_t before = allocation_count();
    run(world, steps);
    return allocation_count() - before;
}

TEST(Allocation, CountsWhatIsAllocated) {
    if (cairn_test::is_thread_sanitized) GTEST_SKIP() << "the sanitizer has an operator new of its own";
    const std::size_t before = allocation_count();
    World world;
    EXPECT_GT(allocation_count(), before);
}

TEST(Allocation, SettledPileThatIsAwakeAllocatesNothing) {
    World world(sleepless());
    add_ground(world);
    for (int i = 0; i < 150; ++i) {
        const Position p(0.9 * (i % 5), 0.6 + 0.8 * (i / 25), 0.9 * (i / 5 % 5));
        if (i % 2)
            add_body(world, body_at(p), Sphere{0.35f});
        else
            add_body(world, body_at(p), Box{{0.3f, 0.35f, 0.4f}});
    }
    run(world, 900);
    EXPECT_GT(world.statistics().contacts, 150u);
    EXPECT_EQ(allocations_of(world, 60), 0u);
}

TEST(Allocation, StackThatIsAwakeAllocatesNothing) {
    World world(sleepless());
    add_ground(world);
    for (int i = 0; i < 10; ++i) add_crate(world, {0.0, 0.5 + i, 0.0});
    run(world, 300);
    EXPECT_EQ(allocations_of(world, 60), 0u);
}

TEST(Allocation, SleepingPileAllocatesNothing) {
    World world;
    add_ground(world);
    for (int i = 0; i < 20; ++i) add_crate(world, {2.0 * i, 0.5, 0.0});
    run(world, 300);
    EXPECT_EQ(world.statistics().awake_bodies, 0u);
    EXPECT_EQ(allocations_of(world, 60), 0u);
}

TEST(Allocation, FieldsForcesDampingAndSpinAllocateNothing) {
    for (const Integrator integrator : {Integrator::semi_implicit_euler, Integrator::explicit_euler, Integrator::rk4}) {
        WorldDef def = sleepless();
        def.gravity = {0.0f, 0.0f, 0.0f};
        def.integrator = integrator;
        World world(def);
        ForceField field;
        field.kind = ForceField::Kind::radial;
        field.strength = 0.001f; // the bodies stay apart: no new pairs for which buffers would have to grow
        world.add_force_field(field);
        for (int i = 0; i < 20; ++i) {
            BodyDef body = body_at({3.0 * i, 0.0, 0.0});
            body.angular_velocity = {1.0f, 5.0f, 2.0f};
            body.linear_damping = 0.1f;
            add_body(world, body, Box{{0.1f, 0.2f, 0.3f}});
        }
        Body body = world.body(world.bodies()[3]);
        run(world, 120); // the slots are sorted for the first time after 16 steps
        const std::size_t before = allocation_count();
        for (int i = 0; i < 60; ++i) {
            body.add_force({1.0f, 0.0f, 0.0f});
            body.add_torque({0.0f, 1.0f, 0.0f});
            world.step(frame);
        }
        EXPECT_EQ(allocation_count() - before, 0u);
    }
}

TEST(Allocation, MovingPlatformAndRayCastsAllocateNothing) {
    World world(sleepless());
    add_ground(world);
    const BodyId platform = add_body(world, body_at({0.0, 1.0, 0.0}, BodyType::kinematic), Box{{2.0f, 0.2f, 2.0f}});
    add_crate(world, {0.0, 1.7, 0.0});
    world.body(platform).set_angular_velocity({0.0f, 0.2f, 0.0f});
    run(world, 120);
    const std::size_t before = allocation_count();
    for (int i = 0; i < 60; ++i) {
        world.step(frame);
        EXPECT_TRUE(world.cast_ray({0.0, 10.0, 0.0}, {0.0f, -1.0f, 0.0f}, 100.0).has_value());
    }
    EXPECT_EQ(allocation_count() - before, 0u);
}

TEST(Allocation, APoolOfWorldsAllocatesNothingOnceItHasRun) {
    World start;
    add_ground(start);
    for (int i = 0; i < 11; ++i) add_crate(start, {1.5 * (i % 4), 0.6 + 1.1 * (i / 4), 0.0});
    const std::vector<BodyId> crates = start.bodies();
    for (int i = 1; i < 4; ++i)
        start.create_joint(start.joint_at(crates[i], crates[i + 1], {1.5 * i - 0.75, 0.6, 0}, {0, 0, 1}, HingeJoint{}));
    const Snapshot snapshot = start.save();
    WorldPool pool(snapshot, 200, 2);
    WorldDef awake = start.settings();
    awake.enable_sleep = false;
    pool.for_each([&](World& world, std::size_t) { world.set_settings(awake); });
    pool.step(1.0f / 60.0f, 240);
    const std::size_t before = allocation_count();
    pool.step(1.0f / 60.0f, 30);
    EXPECT_EQ(allocation_count() - before, 0u);
}

} // namespace
} // namespace cairn::test
