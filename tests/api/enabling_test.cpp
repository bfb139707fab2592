// Bodies and joints that are disabled (taken out of the world) and enabled again.
#include "chance.h"
#include "test_world.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

namespace cairn::test {
namespace {

Shape any_shape(Chance& chance) {
    const float size = chance.between(0.1f, 0.4f);
    switch (chance.below(4)) {
    case 0:
        return Sphere{size};
    case 1:
        return Box{{size, chance.between(0.1f, 0.4f), 0.2f}};
    case 2:
        return Capsule{0.5f * size, size};
    default:
        return Cylinder{size, 0.2f};
    }
}

// Bodies that fall on the ground and on each other, some of them connected by joints, with kinematic bodies, a trigger
// and a character among them.
struct Heap {
    World world;
    std::vector<BodyId> bodies; // all bodies except the ground

    explicit Heap(unsigned seed) {
        Chance chance(seed);
        add_ground(world);
        for (int i = 0; i < 30; ++i) {
            BodyDef def = body_at(Position(chance.in_box(1.5f)) + Position(0.0, 2.0, 0.0));
            def.rotation = chance.rotation();
            if (i % 10 == 9) def.type = BodyType::kinematic, def.angular_velocity = chance.in_box(1.0f);
            ShapeDef shape;
            shape.is_trigger = i == 5;
            bodies.push_back(add_body(world, def, any_shape(chance), shape));
            // Far from the heap.
            if (i % 7 == 1) bodies.push_back(add_body(world, body_at({4.0 + i, 0.3, 0.0}), Sphere{0.3f}));
        }
        for (int i = 0; i < 8; ++i) {
            const BodyId a = bodies[any(chance)], b = bodies[any(chance)];
            const bool can_be_joined = a != b && (is_dynamic(a) || is_dynamic(b));
            if (!can_be_joined) continue;
            const Position middle = 0.5 * (world.body(a).position() + world.body(b).position());
            const Joint joint = chance.below(2) ? Joint(BallJoint{}) : Joint(HingeJoint{});
            JointDef def = world.joint_at(a, b, middle, {0.0f, 1.0f, 0.0f}, joint);
            def.enable_collision = true; // otherwise destroying a joint requests pairs anew, in another order
            world.create_joint(def);
        }
        bodies.push_back(add_body(world, body_at({0.0, 0.9, 3.0}, BodyType::kinematic), Capsule{0.3f, 0.6f}));
        world.body(bodies.back()).set_character({});
        world.body(bodies.back()).set_walk_velocity({0.0f, 0.0f, -1.0f});
    }
    std::size_t any(Chance& chance) const { return chance.below(unsigned(bodies.size())); }
    Body body(std::size_t i) { return world.body(bodies[i]); }
    bool is_dynamic(BodyId id) { return world.body(id).type() == BodyType::dynamic; }
};

// Compares position, rotation and velocities bit for bit.
bool moves_alike(const Body& a, const Body& b) {
    const Transform p = a.transform(), q = b.transform();
    const Vec3 v[] = {a.linear_velocity(), a.angular_velocity()}, w[] = {b.linear_velocity(), b.angular_velocity()};
    return std::memcmp(&p.position, &q.position, sizeof p.position) == 0 &&
           std::memcmp(&p.rotation, &q.rotation, sizeof p.rotation) == 0 && std::memcmp(v, w, sizeof v) == 0;
}

TEST(Enabling, WhatIsDisabledIsNotThereForAllOthers) {
    for (unsigned seed = 0; seed < 24; ++seed) {
        Heap without(seed), disabled(seed);
        Chance chance(100 + seed);
        const int before = int(chance.below(200));
        run(without.world, before);
        run(disabled.world, before);
        std::vector<std::size_t> out;
        for (int i = 0; i < 6; ++i)
            if (const std::size_t k = without.any(chance); std::find(out.begin(), out.end(), k) == out.end())
                out.push_back(k);
        std::vector<Transform> places;
        for (const std::size_t k : out) {
            places.push_back(disabled.body(k).transform());
            without.world.destroy_body(without.bodies[k]);
            disabled.body(k).set_enabled(false);
        }
        EXPECT_EQ(without.world.kinetic_energy(), disabled.world.kinetic_energy());
        EXPECT_EQ(without.world.linear_momentum(), disabled.world.linear_momentum());
        run(without.world, 150);
        run(disabled.world, 150);
        for (std::size_t k = 0; k < without.bodies.size(); ++k) {
            if (!without.world.is_valid(without.bodies[k])) continue;
            ASSERT_TRUE(moves_alike(without.body(k), disabled.body(k))) << "seed " << seed << ", body " << k;
        }
        EXPECT_EQ(without.world.contacts().size(), disabled.world.contacts().size());
        for (std::size_t i = 0; i < out.size(); ++i) {
            EXPECT_EQ(disabled.body(out[i]).position(), places[i].position);
            EXPECT_EQ(disabled.body(out[i]).rotation(), places[i].rotation);
        }
    }
}

TEST(Enabling, WhatIsMadeDisabledIsNotThereEither) {
    for (unsigned seed = 0; seed < 8; ++seed) {
        World with, without;
        Chance chance(seed);
        add_ground(with);
        add_ground(without);
        std::vector<BodyId> first, second;
        for (int i = 0; i < 20; ++i) {
            BodyDef def = body_at(Position(chance.in_box(0.8f)) + Position(0.0, 1.5, 0.0), BodyType::dynamic);
            def.rotation = chance.rotation();
            const Shape shape = any_shape(chance);
            if (i % 4 == 3) {
                def.enabled = false;
                def.type = BodyType(chance.below(3));
                def.linear_velocity = def.type == BodyType::static_ ? Vec3(0.0f) : chance.in_box(3.0f);
                add_body(with, def, shape);
                continue;
            }
            first.push_back(add_body(with, def, shape));
            second.push_back(add_body(without, def, shape));
        }
        run(with, 200);
        run(without, 200);
        for (std::size_t i = 0; i < first.size(); ++i)
            ASSERT_TRUE(moves_alike(with.body(first[i]), without.body(second[i]))) << "seed " << seed << ", " << i;
    }
}

TEST(Enabling, AFlightGoesOnAsItWas) {
    for (unsigned seed = 0; seed < 20; ++seed) {
        Chance chance(seed);
        BodyDef def = body_at(Position(chance.in_box(5.0f)));
        def.linear_velocity = chance.in_box(10.0f);
        def.angular_velocity = chance.in_box(5.0f);
        def.rotation = chance.rotation();
        World flies, pauses;
        const Shape shape = any_shape(chance);
        const BodyId one = add_body(flies, def, shape), other = add_body(pauses, def, shape);
        const int before = int(chance.below(60)), pause = 1 + int(chance.below(60));
        run(flies, before);
        run(pauses, before);
        const Vec3 velocity = pauses.body(other).linear_velocity();
        pauses.body(other).set_enabled(false);
        EXPECT_FALSE(pauses.body(other).enabled() || pauses.body(other).is_awake());
        run(pauses, pause);
        EXPECT_EQ(pauses.body(other).linear_velocity(), velocity);
        EXPECT_EQ(pauses.kinetic_energy(), 0.0);
        pauses.body(other).set_enabled(true);
        run(flies, 60);
        run(pauses, 60);
        EXPECT_TRUE(moves_alike(flies.body(one), pauses.body(other))) << seed;
    }
}

TEST(Enabling, IsSeenByNoQueryAndTouchesNothing) {
    World world;
    const BodyId ground = add_ground(world),
                 table = add_body(world, body_at({0.0, 0.5, 0.0}, BodyType::static_), Box{});
    const BodyId crate = add_crate(world, {0.0, 1.5, 0.0});
    run(world, 200);
    EXPECT_FALSE(world.body(crate).is_awake());
    world.body(table).set_enabled(false);
    EXPECT_TRUE(world.body(crate).is_awake()) << "what lay on it wakes";
    const auto hit = world.cast_ray({0.0, 0.5, 3.0}, {0.0f, 0.0f, -1.0f}, 10.0f);
    EXPECT_FALSE(hit.has_value());
    EXPECT_TRUE(world.overlap(Sphere{0.3f}, {{0.0, 0.5, 0.0}, Quat(1.0f, 0.0f, 0.0f, 0.0f)}).empty());
    EXPECT_TRUE(world.contacts(table).empty());
    world.step(frame);
    ASSERT_EQ(world.contact_ends().size(), 1u);
    EXPECT_TRUE(world.contact_ends()[0].body_a == table || world.contact_ends()[0].body_b == table);
    run(world, 120);
    EXPECT_NEAR(world.body(crate).position().y, 0.5, 1e-3) << "it fell to the ground";
    world.body(table).set_position({0.0, 0.5, 5.0}); // its position is changed while it is disabled
    world.body(table).set_enabled(true);
    EXPECT_TRUE(world.cast_ray({0.0, 0.5, 9.0}, {0.0f, 0.0f, -1.0f}, 10.0f).has_value());
    world.body(ground).set_enabled(false);
    run(world, 30);
    EXPECT_LT(world.body(crate).position().y, -0.5) << "planes are disabled as well";
}

TEST(Enabling, JointsActWhileBothBodiesAreEnabled) {
    for (unsigned seed = 0; seed < 12; ++seed) {
        Chance chance(seed);
        World world;
        BodyDef def = body_at(Position(chance.in_box(1.0f)), BodyType(chance.below(2) ? 0 : 2));
        def.gravity_scale = 0.0f; // a dynamic support must not fall
        const BodyId support = add_body(world, def, Sphere{2.0f});
        const BodyId bob = add_body(world, body_at(def.position + Position(3.0, 0.0, 0.0)), Sphere{0.1f});
        JointDef joint = world.joint_at(support, bob, def.position, {0.0f, 0.0f, 1.0f}, BallJoint{});
        joint.break_force = 1e4f;
        const JointId id = world.create_joint(joint);
        const BodyId out = chance.below(2) ? support : bob, stays = out == bob ? support : bob;
        run(world, 20);
        EXPECT_GT(glm::length(world.joint_state(id).force), 1.0f);
        world.body(out).set_enabled(false);
        EXPECT_EQ(world.joint_state(id).force, Vec3(0.0f));
        const Vec3 v = world.body(stays).linear_velocity();
        const float pull = world.body(stays).type() == BodyType::dynamic && stays == bob ? -9.81f : 0.0f;
        run(world, 30);
        const Vec3 expected = v + Vec3(0.0f, pull * 30 * frame, 0.0f);
        EXPECT_LT(glm::length(world.body(stays).linear_velocity() - expected), 1e-3f) << "it moves freely";
        EXPECT_TRUE(world.is_valid(id));
        const Position arm = world.body(bob).position() - world.body(support).position();
        world.body(bob).set_position(world.body(support).position() + 3.0 * glm::normalize(arm));
        world.body(out).set_enabled(true);
        run(world, 120);
        EXPECT_LT(world.joint_state(id).linear_error, 1e-3f);
        EXPECT_NEAR(glm::length(world.body(bob).position() - world.body(support).position()), 3.0, 2e-3);
    }
}

TEST(Enabling, WhatIsPutBackIntoSomethingIsPushedOutGently) {
    for (unsigned seed = 0; seed < 10; ++seed) {
        Chance chance(seed);
        World world;
        add_ground(world);
        const BodyId one = add_crate(world, {0.0, 0.5, 0.0}), other = add_crate(world, {0.0, 1.5, 0.0});
        run(world, 100);
        world.body(one).set_enabled(false);
        run(world, 100); // the other body has fallen to the position of the disabled one
        world.body(one).set_position(world.body(other).position() + Position(chance.in_box(0.5f)) * Position(1, 0, 1));
        world.body(one).set_enabled(true);
        float fastest = 0;
        for (int i = 0; i < 240; ++i) {
            world.step(frame);
            for (const BodyId id : {one, other})
                fastest = std::max(fastest, glm::length(world.body(id).linear_velocity()));
        }
        EXPECT_LT(fastest, world.settings().recovery_speed + 0.5f);
        EXPECT_LT(world.statistics().max_penetration, 0.01f);
    }
}

TEST(Enabling, SurvivesSnapshotsAndThreadsAndAnyOrder) {
    for (unsigned seed = 0; seed < 6; ++seed) {
        Heap one(seed), many(seed);
        many.world.set_threads(3);
        Chance chance(200 + seed);
        for (int i = 0; i < 60; ++i) {
            const std::size_t k = one.any(chance);
            const unsigned what = chance.below(6);
            const Position place = Position(chance.in_box(1.0f)) + Position(0.0, 1.5, 0.0);
            for (Heap* heap : {&one, &many}) {
                Body body = heap->body(k);
                if (what < 4) body.set_enabled(!body.enabled());
                if (what == 4 && !body.is_character()) body.set_type(BodyType::dynamic);
                if (what == 5) body.set_position(place);
            }
            ASSERT_TRUE(stays_sane(one.world, 5));
            run(many.world, 5);
            ASSERT_EQ(one.world.state_hash(), many.world.state_hash()) << "seed " << seed << ", change " << i;
            if (i % 10 != 9) continue;
            const Snapshot snapshot = many.world.save();
            World fresh;
            fresh.restore(snapshot);
            const std::vector<BodyId> copies = fresh.bodies(), bodies = many.world.bodies();
            ASSERT_EQ(copies.size(), bodies.size());
            for (std::size_t b = 0; b < bodies.size(); ++b)
                EXPECT_EQ(many.world.body(bodies[b]).enabled(), fresh.body(copies[b]).enabled());
            run(fresh, 20);
            run(many.world, 20);
            EXPECT_EQ(fresh.state_hash(), many.world.state_hash());
            many.world.restore(snapshot);
        }
    }
}

TEST(Enabling, NothingPushesWhatIsDisabled) {
    World world;
    const BodyId id = add_crate(world, {0.0, 5.0, 0.0});
    Body body = world.body(id);
    body.add_force({1e3f, 0.0f, 0.0f}); // the force is discarded when the body is disabled
    body.set_enabled(false);
    const std::string refused = "wrong_state | Body::add_force | ";
    EXPECT_EQ(refusal([&] { body.add_force({1, 0, 0}); }).substr(0, refused.size()), refused);
    for (const std::string& told : {refusal([&] {
                                        body.add_force_at({1, 0, 0}, {0, 0, 0});
                                    }),
                                    refusal([&] {
                                        body.add_torque({1, 0, 0});
                                    }),
                                    refusal([&] {
                                        body.apply_impulse({1, 0, 0});
                                    }),
                                    refusal([&] {
                                        body.apply_impulse_at({1, 0, 0}, {0, 0, 0});
                                    }),
                                    refusal([&] {
                                        body.apply_angular_impulse({1, 0, 0});
                                    })})
        EXPECT_NE(told.find("the body must be enabled"), std::string::npos) << told;
    body.set_linear_velocity({0.0f, 3.0f, 0.0f});
    body.set_mass_from_shapes(7.0f);
    EXPECT_EQ(body.mass(), 7.0f);
    EXPECT_EQ(body.type(), BodyType::dynamic);
    EXPECT_NE(refusal([&] { world.add_shape(id, Plane{}); }), "");
    body.set_enabled(true);
    body.apply_impulse({7.0f, 0.0f, 0.0f});
    EXPECT_EQ(body.linear_velocity(), Vec3(1.0f, 3.0f, 0.0f));
    world.step(frame);
    EXPECT_NEAR(body.linear_velocity().x, 1.0f, 1e-6f);
}

TEST(Enabling, ACharacterThatIsDisabledStandsStillAndGoesOn) {
    World world;
    add_ground(world);
    const BodyId floor = add_body(world, body_at({0.0, 0.5, 0.0}, BodyType::static_), Box{{5.0f, 0.5f, 5.0f}});
    const BodyId walker = add_body(world, body_at({0.0, 1.9, 0.0}, BodyType::kinematic), Capsule{0.3f, 0.6f});
    Body body = world.body(walker);
    body.set_character({});
    body.set_walk_velocity({1.0f, 0.0f, 0.0f});
    run(world, 60);
    const Position there = body.position();
    EXPECT_NEAR(there.x, 1.0, 0.1);
    body.set_enabled(false);
    run(world, 60);
    EXPECT_EQ(body.position(), there);
    body.set_enabled(true);
    run(world, 60);
    EXPECT_NEAR(body.position().x, there.x + 1.0, 0.1);
    world.body(floor).set_enabled(false); // the body falls to the ground
    run(world, 60);
    EXPECT_NEAR(body.position().y, there.y - 1.0, 0.05);
}

// Heaps of bodies with more joints, between bodies that collide with each other and bodies that do not.
struct JoinedHeap : Heap {
    std::vector<JointId> joints;

    explicit JoinedHeap(unsigned seed) : Heap(seed) {
        Chance chance(1000 + seed);
        for (int i = 0; i < 10; ++i) {
            const BodyId a = bodies[any(chance)], b = bodies[any(chance)];
            const float kind = chance.between(0.0f, 1.0f);
            if (a == b || !(is_dynamic(a) || is_dynamic(b))) continue;
            const Position middle = 0.5 * (world.body(a).position() + world.body(b).position());
            const Joint joint = kind < 0.4f   ? Joint(BallJoint{})
                                : kind < 0.7f ? Joint(HingeJoint{})
                                              : Joint(FixedJoint{});
            JointDef def = world.joint_at(a, b, middle, {0.0f, 1.0f, 0.0f}, joint);
            def.enable_collision = i % 2 == 0;
            def.solver = JointSolver(chance.below(3));
            world.create_joint(def);
        }
        joints = world.joints();
    }
};

TEST(Enabling, AJointThatIsDisabledIsNotThereForAnything) {
    for (unsigned seed = 0; seed < 24; ++seed) {
        JoinedHeap without(seed), disabled(seed);
        Chance chance(100 + seed);
        const int before = int(chance.below(200));
        run(without.world, before);
        run(disabled.world, before);
        for (std::size_t i = 0; i < without.joints.size(); ++i) {
            if (chance.below(2)) continue;
            without.world.destroy_joint(without.joints[i]);
            disabled.world.set_joint_enabled(disabled.joints[i], false);
        }
        run(without.world, 150);
        run(disabled.world, 150);
        for (std::size_t k = 0; k < without.bodies.size(); ++k)
            ASSERT_TRUE(moves_alike(without.body(k), disabled.body(k))) << "seed " << seed << ", body " << k;
        EXPECT_EQ(without.world.contacts().size(), disabled.world.contacts().size());
        EXPECT_EQ(without.world.statistics().islands, disabled.world.statistics().islands);
    }
}

// A joint that is created disabled, and enabled before the next step, gives the same bits as one created enabled.
TEST(Enabling, AJointThatIsMadeDisabledIsThereOnceItIsEnabled) {
    for (unsigned seed = 0; seed < 12; ++seed) {
        JoinedHeap at_once(seed), later(seed);
        Chance chance(200 + seed);
        for (Heap* heap : {static_cast<Heap*>(&at_once), static_cast<Heap*>(&later)}) run(heap->world, 30);
        const Vec3 axis = chance.in_box(1.0f);
        const auto join = [&](Heap& heap, bool enabled) {
            const Position middle = 0.5 * (heap.body(0).position() + heap.body(1).position());
            JointDef def = heap.world.joint_at(heap.bodies[0], heap.bodies[1], middle, axis, BallJoint{});
            def.enabled = enabled;
            return heap.world.create_joint(def);
        };
        join(at_once, true);
        const JointId made = join(later, false);
        EXPECT_FALSE(later.world.joint_def(made).enabled);
        later.world.set_joint_enabled(made, true);
        EXPECT_TRUE(later.world.joint_def(made).enabled);
        for (Heap* heap : {static_cast<Heap*>(&at_once), static_cast<Heap*>(&later)}) run(heap->world, 120);
        for (std::size_t k = 0; k < at_once.bodies.size(); ++k)
            ASSERT_TRUE(moves_alike(at_once.body(k), later.body(k))) << "seed " << seed << ", body " << k;
    }
}

TEST(Enabling, AJointThatIsEnabledAgainBringsItsBodiesTogether) {
    for (const JointSolver solver : {JointSolver::iterative, JointSolver::direct}) {
        World world;
        const BodyId box = add_body(world, body_at({0.0, -1.0, 0.0}), Box{{0.1f, 0.1f, 0.1f}});
        JointDef def = world.joint_at({}, box, {0.0, 0.0, 0.0}, {0.0f, 0.0f, 1.0f}, HingeJoint{});
        def.solver = solver;
        const JointId joint = world.create_joint(def);
        run(world, 120);
        const float weight = glm::length(world.joint_state(joint).force);
        EXPECT_NEAR(weight, world.body(box).mass() * 9.81f, 1e-3f * weight);
        run(world, 120);
        EXPECT_FALSE(world.body(box).is_awake());
        world.set_joint_enabled(joint, false);
        EXPECT_EQ(world.joint_state(joint).force, Vec3(0.0f));
        run(world, 30);
        EXPECT_NEAR(world.body(box).position().y, -1.0 - 0.5 * 9.81 * 0.25, 0.05); // the box woke and falls
        EXPECT_NEAR(world.joint_state(joint).linear_error, 0.5f * 9.81f * 0.25f, 0.05f);
        EXPECT_TRUE(world.joint_events().empty());
        world.set_joint_enabled(joint, true);
        float fastest = 0.0f;
        for (int i = 0; i < 240; ++i) {
            world.step(frame);
            fastest = std::max(fastest, glm::length(world.body(box).linear_velocity()));
        }
        EXPECT_LT(world.joint_state(joint).linear_error, 1e-3f);
        EXPECT_LT(fastest, 6.0f); // joint errors are corrected no faster than this, apart from the fall
    }
}

TEST(Enabling, WhetherAJointIsEnabledIsKept) {
    JoinedHeap heap(3);
    for (std::size_t i = 0; i < heap.joints.size(); i += 2) heap.world.set_joint_enabled(heap.joints[i], false);
    run(heap.world, 20);
    const Snapshot saved = heap.world.save();
    World other;
    other.restore(saved);
    for (std::size_t i = 0; i < heap.joints.size(); ++i)
        EXPECT_EQ(other.joint_def(other.joints()[i]).enabled, i % 2 == 1);
    for (World* world : {&heap.world, &other})
        for (const JointId joint : world->joints()) world->set_joint_enabled(joint, true);
    run(heap.world, 60);
    run(other, 60);
    EXPECT_EQ(heap.world.state_hash(), other.state_hash());
}

} // namespace
} // namespace cairn::test
