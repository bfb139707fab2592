// Islands fall asleep, and wake when something affects them.
#include "test_world.h"

#include <algorithm>
#include <functional>
#include <ostream>
#include <random>
#include <vector>

namespace cairn::test {
namespace {

// A stack of two crates, and one crate apart from it, all asleep.
struct Asleep {
    World world;
    BodyId ground, below, above, apart;
    explicit Asleep(const WorldDef& def = {}) : world(def) {
        ground = add_ground(world);
        below = add_crate(world, {0.0, 0.5, 0.0});
        above = add_crate(world, {0.0, 1.5, 0.0});
        apart = add_crate(world, {20.0, 0.5, 0.0});
        run(world, 240);
    }
    bool is_awake(BodyId body) { return world.body(body).is_awake(); }
};

TEST(Sleep, StackFallsAsleepAndCostsNothing) {
    Asleep asleep;
    EXPECT_FALSE(asleep.is_awake(asleep.below) || asleep.is_awake(asleep.above) || asleep.is_awake(asleep.apart));
    EXPECT_EQ(asleep.world.statistics().awake_bodies, 0u);
    EXPECT_EQ(asleep.world.statistics().islands, 0u);
    EXPECT_EQ(asleep.world.statistics().sleeping_islands, 2u);
    EXPECT_EQ(asleep.world.statistics().contacts, 3u) << "sleeping contacts are still there";
    EXPECT_EQ(asleep.world.contacts().size(), 3u);
    EXPECT_EQ(asleep.world.kinetic_energy(), 0.0);
    const std::uint64_t hash = asleep.world.state_hash();
    run(asleep.world, 60);
    EXPECT_EQ(asleep.world.state_hash(), hash);
}

// Links of robots often have an inertia but no shape.
TEST(Sleep, ABodyWithoutShapesStaysAwakeWhileItTurns) {
    WorldDef def;
    def.gravity = {0.0f, 0.0f, 0.0f};
    World world(def);
    BodyDef body;
    body.mass_properties = MassProperties{2.0f, {}, {0.5f, 0.02f, 0.5f}, {1.0f, 0.0f, 0.0f, 0.0f}};
    // At a radius of 0.5 m: faster than the 0.05 m/s below which a body may sleep.
    body.angular_velocity = {0.0f, 0.2f, 0.0f};
    const BodyId turns = world.create_body(body);
    body.angular_velocity = {0.0f, 0.05f, 0.0f};
    const BodyId hardly = world.create_body(body);
    run(world, 120);
    EXPECT_EQ(world.body(turns).angular_velocity().y, 0.2f);
    EXPECT_FALSE(world.body(hardly).is_awake());
}

TEST(Sleep, TakesTheGivenTimeAndSpeed) {
    for (const float time : {0.0f, 0.25f, 2.0f}) {
        WorldDef def;
        def.sleep_time = time;
        World world(def);
        add_ground(world);
        const BodyId crate = add_crate(world, {0.0, 0.5, 0.0});
        int steps = 0;
        while (world.body(crate).is_awake() && steps < 600) {
            world.step(frame);
            ++steps;
        }
        EXPECT_NEAR(steps * frame, time, 0.2f);
    }
    WorldDef def;
    def.sleep_speed = 0.0f;
    Asleep never(def);
    EXPECT_TRUE(never.is_awake(never.below)) << "nothing is slower than not moving";
}

TEST(Sleep, CanBeTurnedOff) {
    WorldDef def;
    def.enable_sleep = false;
    Asleep never(def);
    EXPECT_EQ(never.world.statistics().awake_bodies, 3u);
    Asleep asleep;
    asleep.world.set_settings(def);
    EXPECT_EQ(asleep.world.statistics().awake_bodies, 3u) << "turning it off wakes all";
    run(asleep.world, 240);
    EXPECT_EQ(asleep.world.statistics().awake_bodies, 3u);
}

TEST(Sleep, OneThatMayNotSleepKeepsItsIslandAwake) {
    World world;
    add_ground(world);
    BodyDef restless = body_at({0.0, 1.5, 0.0});
    restless.allow_sleep = false;
    const BodyId below = add_crate(world, {0.0, 0.5, 0.0}), above = add_body(world, restless, Box{}),
                 apart = add_crate(world, {20.0, 0.5, 0.0});
    run(world, 300);
    EXPECT_TRUE(world.body(below).is_awake());
    EXPECT_TRUE(world.body(above).is_awake());
    EXPECT_FALSE(world.body(apart).is_awake());
    world.body(above).set_allow_sleep(true);
    run(world, 120);
    EXPECT_FALSE(world.body(above).is_awake());
}

TEST(Sleep, AirborneBodiesDoNotSleepAtTheTopOfTheirFlight) {
    WorldDef def;
    def.sleep_time = 0.1f;
    World world(def);
    BodyDef up;
    up.linear_velocity = {0.0f, 3.0f, 0.0f};
    const BodyId ball = add_body(world, up, Sphere{});
    for (int i = 0; i < 120; ++i) {
        world.step(frame);
        ASSERT_TRUE(world.body(ball).is_awake()) << "step " << i;
    }
}

struct Wake {
    const char* name;
    std::function<void(Asleep&)> cause;
    bool above, apart; // whether each of these must be awake after a few steps (`below` always must)
};
std::ostream& operator<<(std::ostream& out, const Wake& wake) { return out << wake.name; }

class Waking : public testing::TestWithParam<Wake> {};

TEST_P(Waking, WakesTheIslandAndNoOther) {
    Asleep asleep;
    GetParam().cause(asleep);
    bool below = false, above = false, apart = false;
    for (int i = 0; i < 12; ++i) {
        below |= asleep.is_awake(asleep.below);
        above |= asleep.is_awake(asleep.above);
        apart |= asleep.is_awake(asleep.apart);
        asleep.world.step(frame);
    }
    EXPECT_TRUE(below);
    EXPECT_EQ(above, GetParam().above);
    EXPECT_EQ(apart, GetParam().apart);
    EXPECT_TRUE(stays_sane(asleep.world, 300));
}

template <class F> std::function<void(Asleep&)> on_below(F&& f) {
    return [f](Asleep& asleep) { f(asleep.world.body(asleep.below)); };
}

INSTANTIATE_TEST_SUITE_P(
    Causes, Waking,
    testing::Values(Wake{"wake", on_below([](Body b) { b.wake(); }), true, false},
                    Wake{"impulse", on_below([](Body b) {
                             b.apply_impulse({1.0f, 0.0f, 0.0f});
                         }),
                         true, false},
                    Wake{"force", on_below([](Body b) {
                             b.add_force({1.0f, 0.0f, 0.0f});
                         }),
                         true, false},
                    Wake{"torque", on_below([](Body b) {
                             b.add_torque({1.0f, 0.0f, 0.0f});
                         }),
                         true, false},
                    Wake{"velocity", on_below([](Body b) {
                             b.set_linear_velocity({0.1f, 0.0f, 0.0f});
                         }),
                         true, false},
                    Wake{"spin", on_below([](Body b) {
                             b.set_angular_velocity({0.0f, 0.1f, 0.0f});
                         }),
                         true, false},
                    Wake{"teleport", on_below([](Body b) {
                             b.set_position({0.05, 0.5, 0.0});
                         }),
                         true, false},
                    Wake{"gravity_scale", on_below([](Body b) { b.set_gravity_scale(2.0f); }), true, false},
                    Wake{"mass", on_below([](Body b) { b.set_mass_from_shapes(5.0f); }), true, false},
                    Wake{"material", [](Asleep& a) { a.world.set_material(a.world.body(a.below).shapes()[0], {}); },
                         true, false},
                    Wake{"added_shape", [](Asleep& a) { a.world.add_shape(a.below, Sphere{0.1f}); }, true, false},
                    Wake{"removed_above",
                         [](Asleep& a) {
                             a.world.destroy_body(a.above);
                             a.above = a.below;
                         },
                         true, false},
                    Wake{"type_of_above",
                         [](Asleep& a) {
                             a.world.body(a.above).set_type(BodyType::static_);
                             a.above = a.below;
                         },
                         true, false},
                    Wake{"gravity",
                         [](Asleep& a) {
                             WorldDef def;
                             def.gravity.y = -5.0f;
                             a.world.set_settings(def);
                         },
                         true, true},
                    Wake{"field",
                         [](Asleep& a) {
                             ForceField f;
                             f.direction = {1, 0, 0};
                             a.world.add_force_field(f);
                         },
                         true, true},
                    Wake{"removed_ground", [](Asleep& a) { a.world.destroy_body(a.ground); }, true, true},
                    Wake{"ground_moved",
                         [](Asleep& a) {
                             a.world.body(a.ground).set_position({0.0, -1.0, 0.0});
                         },
                         true, true},
                    Wake{"ground_material",
                         [](Asleep& a) { a.world.set_material(a.world.body(a.ground).shapes()[0], {}); }, true, true},
                    Wake{"ball_falls_on_it",
                         [](Asleep& a) {
                             add_body(a.world, body_at({0.0, 2.35, 0.0}), Sphere{0.3f});
                         },
                         true, false},
                    Wake{"static_placed_into_it",
                         [](Asleep& a) {
                             add_body(a.world, body_at({0.9, 0.5, 0.0}, BodyType::static_), Box{});
                         },
                         true, false},
                    Wake{"kinematic_runs_into_it",
                         [](Asleep& a) {
                             BodyDef def = body_at({-1.05, 0.5, 0.0}, BodyType::kinematic);
                             def.linear_velocity = {1.0f, 0.0f, 0.0f};
                             add_body(a.world, def, Box{});
                         },
                         true, false}),
    [](const auto& info) { return std::string(info.param.name); });

TEST(Sleep, MovedStaticBodyWakesWhatRestedOnIt) {
    World world;
    const BodyId shelf = add_body(world, body_at({0.0, 5.0, 0.0}, BodyType::static_), Box{{2.0f, 0.1f, 2.0f}});
    const BodyId crate = add_crate(world, {0.0, 5.6, 0.0});
    run(world, 120);
    ASSERT_FALSE(world.body(crate).is_awake());
    world.body(shelf).set_position({10.0, 5.0, 0.0});
    run(world, 60);
    EXPECT_LT(world.body(crate).position().y, 2.0) << "it falls";
}

// Without the fix the body stayed asleep in mid-air, although its support had moved away.
TEST(Sleep, WhatHangsOnABodyThatIsMovedWakes) {
    const Joint joints[] = {BallJoint{}, HingeJoint{}, FixedJoint{}, SliderJoint{}};
    for (const BodyType type : {BodyType::static_, BodyType::kinematic})
        for (const Joint& joint : joints)
            for (const bool turns : {false, true}) {
                World world;
                Body hook = world.body(world.create_body(body_at({0.0, 0.0, 0.0}, type)));
                const Body crate = world.body(add_crate(world, {0.0, -2.0, 0.0}));
                world.create_joint(world.joint_at(hook.id(), crate.id(), {}, {0, 0, 1}, joint));
                run(world, 300);
                ASSERT_FALSE(crate.is_awake());
                const Position before = crate.position();
                if (turns)
                    hook.set_rotation(glm::angleAxis(0.3f, Vec3(1, 0, 0)));
                else
                    hook.set_position({0.3, 0.0, 0.0});
                EXPECT_TRUE(crate.is_awake());
                run(world, 30);
                const bool lets_it_turn = turns && std::holds_alternative<BallJoint>(joint);
                EXPECT_EQ(glm::length(crate.position() - before) > 0.01, !lets_it_turn) << joint.index() << turns;
            }
}

TEST(Sleep, RemovedSupportLetsTheStackFall) {
    Asleep asleep;
    asleep.world.destroy_body(asleep.below);
    run(asleep.world, 120);
    EXPECT_NEAR(asleep.world.body(asleep.above).position().y, 0.5, 0.02);
}

TEST(Sleep, PassingByWakesNobody) {
    Asleep asleep;
    BodyDef def = body_at({-5.0, 1.0, 1.2});
    def.linear_velocity = {10.0f, 0.0f, 0.0f};
    def.gravity_scale = 0.0f;
    add_body(asleep.world, def, Sphere{0.5f});
    for (int i = 0; i < 60; ++i) {
        asleep.world.step(frame);
        ASSERT_FALSE(asleep.is_awake(asleep.below)) << "step " << i;
    }
}

TEST(Sleep, IslandsThatComeApartSleepApart) {
    World world;
    add_ground(world);
    const BodyId left = add_crate(world, {-0.5, 0.5, 0.0}), right = add_crate(world, {0.5, 0.5, 0.0});
    run(world, 10);
    EXPECT_EQ(world.statistics().islands, 1u);
    for (int i = 0; i < 600; ++i) {
        world.body(right).set_linear_velocity({0.5f, 0.0f, 0.0f});
        world.step(frame);
    }
    EXPECT_FALSE(world.body(left).is_awake());
    EXPECT_TRUE(world.body(right).is_awake());
}

// A wall of loose bricks that are created asleep, as in a game level.
struct Wall {
    World world;
    std::vector<BodyId> bricks;
    explicit Wall(bool is_asleep) {
        add_ground(world);
        for (int row = 0; row < 8; ++row)
            for (int i = 0; i < 8; ++i)
                bricks.push_back(add_crate(world, {1.01 * i + 0.5 * (row % 2), 0.5 + row, 0.0}));
        if (!is_asleep) return;
        for (const BodyId brick : bricks) world.body(brick).sleep();
    }
};

TEST(Sleep, WhatIsMadeAsleepStaysAsItIs) {
    Wall wall(true);
    const BodyId floating = add_crate(wall.world, {0.0, 30.0, 0.0}), pushed = add_crate(wall.world, {0.0, 40.0, 0.0});
    wall.world.body(floating).set_linear_velocity({1, 2, 3});
    wall.world.body(floating).add_force({100, 0, 0});
    wall.world.body(floating).sleep();
    EXPECT_EQ(wall.world.body(floating).linear_velocity(), Vec3(0.0f));
    wall.world.body(pushed).sleep();
    wall.world.body(pushed).add_force({100, 0, 0});
    std::vector<Transform> before;
    for (const BodyId brick : wall.bricks) before.push_back(wall.world.body(brick).transform());
    run(wall.world, 1);
    EXPECT_FALSE(wall.world.body(floating).is_awake());
    EXPECT_TRUE(wall.world.body(pushed).is_awake()) << "what is pushed wakes";
    EXPECT_EQ(wall.world.sleep_events().size(), 65u);
    EXPECT_TRUE(wall.world.sleep_events()[0].asleep);
    wall.world.destroy_body(pushed);
    run(wall.world, 100);
    EXPECT_EQ(wall.world.statistics().awake_bodies, 0u);
    EXPECT_EQ(wall.world.statistics().tested_pairs, 0u);
    EXPECT_EQ(wall.world.statistics().sleeping_islands, 2u) << "it is known what touches what";
    for (std::size_t i = 0; i < before.size(); ++i)
        EXPECT_EQ(wall.world.body(wall.bricks[i]).position(), before[i].position);
    EXPECT_EQ(wall.world.body(floating).position(), Position(0, 30, 0));
    wall.world.body(floating).wake();
    run(wall.world, 1);
    EXPECT_LT(wall.world.body(floating).linear_velocity().y, -0.1f) << "the force is forgotten, gravity is not";
    EXPECT_EQ(wall.world.body(floating).linear_velocity().x, 0.0f);
}

TEST(Sleep, WhatTouchesSomethingThatMovesOrMayNotSleepStaysAwake) {
    for (const bool may_sleep : {true, false}) {
        World world;
        add_ground(world);
        const BodyId below = add_crate(world, {0, 0.5, 0}), above = add_crate(world, {0, 1.5, 0});
        world.body(above).set_allow_sleep(may_sleep);
        world.body(below).sleep();
        if (may_sleep)
            world.body(above).set_linear_velocity({1, 0, 0});
        else
            world.body(above).sleep();
        run(world, 3);
        EXPECT_TRUE(world.body(below).is_awake() && world.body(above).is_awake()) << may_sleep;
    }
    World world;
    const BodyId ground = add_ground(world);
    EXPECT_NO_THROW(world.body(ground).sleep()) << "like wake: it is neither";
}

// When a ball hits it, the wall falls like one that fell asleep by itself: no brick stays in the air.
TEST(Sleep, WhatWasMadeAsleepWakesWhenItLosesWhatCarriesIt) {
    for (int place = 0; place < 12; ++place) {
        Wall wall(true);
        run(wall.world, 10);
        const BodyId ball = wall.world.create_body({.position = {0.7 * place, 0.6, 5.0}});
        wall.world.add_shape(ball, Sphere{0.5f}, {.density = 20000});
        wall.world.body(ball).set_linear_velocity({0, 0, -30});
        run(wall.world, 900);
        std::vector<Position> before;
        for (const BodyId brick : wall.bricks) before.push_back(wall.world.body(brick).position());
        for (const BodyId brick : wall.bricks) wall.world.body(brick).wake();
        run(wall.world, 60);
        for (std::size_t i = 0; i < before.size(); ++i)
            EXPECT_LT(glm::length(wall.world.body(wall.bricks[i]).position() - before[i]), 0.05)
                << "ball " << place << ", brick " << i << " at " << before[i].y;
    }
}

// Two balls hit a body at rest in free space within one step: a sleeping body must move in the same way as one that may
// not sleep.
TEST(Sleep, WhatSleepsInFreeSpaceIsStruckTwiceInAStepLikeWhatIsAwake) {
    int in_impact_twice = 0;
    for (std::uint32_t seed = 0; seed < 200; ++seed) {
        std::mt19937 bits(seed);
        const auto uniform = [&](double least, double most) {
            return least + (most - least) * double(bits() % 100003) / 100003;
        };
        const auto direction = [&] { return glm::normalize(glm::dvec3(uniform(-1, 1), uniform(-1, 1), 1.1)); };
        const Shape shape = seed % 2 ? Shape(Sphere{0.3f}) : Shape(Box{{0.3f, 0.2f, 0.25f}});
        Material material;
        material.restitution = float(uniform(0, 1));
        material.static_friction = material.dynamic_friction = float(uniform(0, 1));
        std::vector<BodyDef> balls;
        const double speed = uniform(20, 60), first = uniform(2, 3);
        for (const double side : {-1.0, 1.0}) {
            const glm::dvec3 way = side * direction();
            BodyDef def = body_at(
                Position(glm::dvec3(uniform(-0.1, 0.1), uniform(-0.1, 0.1), 0) - way * (first + uniform(0, 0.2))));
            def.linear_velocity = Vec3(speed * way);
            balls.push_back(def);
        }
        std::vector<Vec3> ends;
        bool is_twice = false;
        for (const bool sleeps : {true, false}) {
            WorldDef settings = weightless();
            settings.enable_sleep = sleeps;
            World world(settings);
            std::vector<BodyId> all{add_body(world, body_at({0, 0, 0}), shape, with_material(material))};
            run(world, 60);
            EXPECT_EQ(world.statistics().awake_bodies, sleeps ? 0u : 1u);
            for (const BodyDef& def : balls) all.push_back(add_body(world, def, Sphere{0.1f}, with_material(material)));
            for (int i = 0; i < 12; ++i) {
                const bool slept = !world.body(all[0]).is_awake();
                world.step(frame);
                is_twice |= slept && world.statistics().impacts > 1;
            }
            for (const BodyId body : all) ends.push_back(world.body(body).linear_velocity());
            ends.push_back(world.body(all[0]).angular_velocity() * 0.3f);
            ends.push_back(Vec3(world.body(all[0]).position()));
        }
        in_impact_twice += is_twice;
        for (std::size_t i = 0; i < ends.size() / 2; ++i)
            EXPECT_LT(glm::length(ends[i] - ends[i + ends.size() / 2]), 0.01 * speed) << "start " << seed << ", " << i;
    }
    EXPECT_GT(in_impact_twice, 50);
}

} // namespace
} // namespace cairn::test
