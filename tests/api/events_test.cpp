// Events of a step: contacts that begin, end and hit, bodies that fall asleep and wake, and the list of contacts.
#include "test_world.h"

#include <algorithm>
#include <vector>

namespace cairn::test {
namespace {

Material without_friction() {
    Material material;
    material.static_friction = material.dynamic_friction = 0.0f;
    return material;
}

// Steps until a contact begins. Returns the number of steps taken, or -1 if none begins.
int run_until_touching(World& world, int most) {
    for (int i = 0; i < most; ++i) {
        world.step(frame);
        if (!world.contact_begins().empty()) return i + 1;
    }
    return -1;
}

TEST(Events, BallThatFallsBeginsToTouchAndHitsOnce) {
    World world;
    const BodyId ground = add_ground(world);
    const BodyId ball = add_body(world, body_at({2.0, 5.5, -1.0}), Sphere{});
    const ShapeId ground_shape = world.body(ground).shapes()[0], ball_shape = world.body(ball).shapes()[0];
    const int steps = run_until_touching(world, 120);
    // The ball falls 5 m: t = sqrt(2 h / g) = 1.0096 s, and arrives with sqrt(2 g h) = 9.905 m/s.
    EXPECT_NEAR(steps * frame, 1.0096, 0.05);
    ASSERT_EQ(world.contact_begins().size(), 1u);
    ASSERT_EQ(world.contact_hits().size(), 1u);
    EXPECT_TRUE(world.contact_ends().empty());
    const ContactBegin begin = world.contact_begins()[0];
    EXPECT_EQ(begin.body_a, ball);
    EXPECT_EQ(begin.body_b, ground);
    EXPECT_EQ(begin.shape_a, ball_shape);
    EXPECT_EQ(begin.shape_b, ground_shape);
    const ContactHit hit = world.contact_hits()[0];
    EXPECT_EQ(hit.shape_a, ball_shape);
    EXPECT_EQ(hit.shape_b, ground_shape);
    EXPECT_EQ(hit.body_a, ball);
    EXPECT_EQ(hit.body_b, ground);
    EXPECT_NEAR(hit.approach_speed, 9.905f, 0.2f);
    EXPECT_NEAR(hit.normal.y, -1.0f, 1e-6f) << "from the ball to the ground";
    EXPECT_NEAR(hit.point.x, 2.0, 1e-4);
    EXPECT_NEAR(hit.point.y, 0.0, 0.02);
    EXPECT_NEAR(hit.point.z, -1.0, 1e-4);
    for (int i = 0; i < 60; ++i) {
        world.step(frame);
        ASSERT_TRUE(world.contact_begins().empty() && world.contact_ends().empty() && world.contact_hits().empty())
            << "step " << i;
    }
}

TEST(Events, SlowTouchIsNoHit) {
    World world;
    add_ground(world);
    add_body(world, body_at({0.0, 0.52, 0.0}), Sphere{}); // arrives at 0.63 m/s
    ASSERT_GT(run_until_touching(world, 60), 0);
    EXPECT_TRUE(world.contact_hits().empty());
    WorldDef def;
    def.hit_speed = 0.4f; // compared with the approach speed at the start of the step
    World attentive(def);
    add_ground(attentive);
    add_body(attentive, body_at({0.0, 0.52, 0.0}), Sphere{});
    ASSERT_GT(run_until_touching(attentive, 60), 0);
    EXPECT_EQ(attentive.contact_hits().size(), 1u);
}

// Without the fix one impact in ten at 1,000 Hz, namely one at the very end of a step, was not reported in that step:
// the remainder of the step was too short for the impact to be detected.
TEST(Events, ImpactsAtTheEndOfAStepAreHits) {
    for (const float dt : {frame, 1.0f / 240, 1.0f / 1000})
        for (const float restitution : {0.0f, 0.5f})
            for (int start = 0; start < 40; ++start) {
                WorldDef settings;
                settings.gravity = {};
                World world(settings);
                Material material;
                material.restitution = restitution;
                BodyDef ball;
                ball.linear_velocity = {2.0f, 0.0f, 0.0f};
                add_body(world, ball, Sphere{0.25f}, with_material(material));
                ball.position = {0.9 + 0.003 * start, 0.0, 0.0};
                ball.linear_velocity = {-2.0f, 0.0f, 0.0f};
                add_body(world, ball, Sphere{0.25f}, with_material(material));
                std::vector<ContactHit> hits;
                for (int i = 0; float(i) * dt < 0.3f; ++i) {
                    world.step(dt);
                    hits.insert(hits.end(), world.contact_hits().begin(), world.contact_hits().end());
                }
                ASSERT_EQ(hits.size(), 1u) << "dt " << dt << ", restitution " << restitution << ", start " << start;
                EXPECT_NEAR(hits.front().approach_speed, 4.0f, 1e-3f);
            }
}

TEST(Events, ContactEndsWhenABallIsLiftedOff) {
    World world;
    const BodyId ground = add_ground(world);
    const BodyId ball = add_body(world, body_at({0.0, 0.5, 0.0}), Sphere{});
    run(world, 30);
    world.body(ball).set_linear_velocity({0.0f, 5.0f, 0.0f});
    std::vector<ContactEnd> ends;
    for (int i = 0; i < 10; ++i) {
        world.step(frame);
        ends.insert(ends.end(), world.contact_ends().begin(), world.contact_ends().end());
    }
    ASSERT_EQ(ends.size(), 1u);
    EXPECT_EQ(ends[0].body_a, ball);
    EXPECT_EQ(ends[0].body_b, ground);
    EXPECT_TRUE(world.contacts().empty());
}

TEST(Events, BounceEndsAndBeginsInTurn) {
    World world;
    Material rubber;
    rubber.restitution = 1.0f;
    add_ground(world, rubber);
    add_body(world, body_at({0.0, 1.5, 0.0}), Sphere{}, with_material(rubber));
    int begins = 0, ends = 0;
    for (int i = 0; i < 600; ++i) {
        world.step(frame);
        begins += int(world.contact_begins().size());
        ends += int(world.contact_ends().size());
        ASSERT_TRUE(begins == ends || begins == ends + 1) << "step " << i;
    }
    // Falling and rising by a meter takes 2 sqrt(2 / g) = 0.903 s: the first hit is at 0.45 s, and there are eleven in
    // 10 s.
    EXPECT_NEAR(begins, 11, 1);
}

TEST(Events, RemovedBodyEndsItsContactsWithStaleHandles) {
    World world;
    const BodyId ground = add_ground(world);
    const BodyId crate = add_crate(world, {0.0, 0.5, 0.0});
    const ShapeId shape = world.body(crate).shapes()[0];
    run(world, 10);
    world.destroy_body(crate);
    world.step(frame);
    ASSERT_EQ(world.contact_ends().size(), 1u);
    const ContactEnd end = world.contact_ends()[0];
    EXPECT_EQ(end.body_a, crate);
    EXPECT_EQ(end.shape_a, shape);
    EXPECT_EQ(end.body_b, ground);
    EXPECT_FALSE(world.is_valid(end.body_a));
    EXPECT_FALSE(world.is_valid(end.shape_a));
    EXPECT_TRUE(world.is_valid(end.body_b));
}

TEST(Events, BodyRemovedBeforeATypeChangeStillEndsItsContacts) {
    World world;
    add_ground(world);
    const BodyId first = add_crate(world, {0.0, 0.5, 0.0}), second = add_crate(world, {5.0, 0.5, 0.0});
    run(world, 10);
    world.destroy_body(first);
    world.body(second).set_type(BodyType::kinematic);
    world.step(frame);
    EXPECT_EQ(world.contact_ends().size(), 2u);
}

TEST(Events, EveryBeginOfAMixedHeapIsFollowedByAtMostOneEnd) {
    World world;
    add_ground(world);
    for (int i = 0; i < 60; ++i) {
        const Position p(0.7 * (i % 4), 1.0 + 0.8 * (i / 4), 0.6 * (i % 3));
        if (i % 2)
            add_body(world, body_at(p), Sphere{0.3f});
        else
            add_body(world, body_at(p), Box{{0.3f, 0.2f, 0.4f}});
    }
    // Brief contacts begin and end within one step: they are not among the contacts at its end, and their end is
    // reported in the next step.
    std::vector<std::pair<ShapeId, ShapeId>> touching, brief;
    for (int i = 0; i < 400; ++i) {
        world.step(frame);
        for (const ContactEnd& end : world.contact_ends()) {
            std::erase(brief, std::pair(end.shape_a, end.shape_b));
            const auto at = std::find(touching.begin(), touching.end(), std::pair(end.shape_a, end.shape_b));
            ASSERT_NE(at, touching.end()) << "an end without a begin, step " << i;
            touching.erase(at);
        }
        for (const ContactBegin& begin : world.contact_begins()) {
            const std::pair pair(begin.shape_a, begin.shape_b);
            ASSERT_EQ(std::find(touching.begin(), touching.end(), pair), touching.end()) << "begun twice, step " << i;
            touching.push_back(pair);
        }
        ASSERT_TRUE(brief.empty()) << "brief, and not ended in the next step, " << i;
        std::vector<std::pair<ShapeId, ShapeId>> contacts;
        for (const Contact& contact : world.contacts()) contacts.emplace_back(contact.shape_a, contact.shape_b);
        std::sort(contacts.begin(), contacts.end());
        for (const ContactBegin& begin : world.contact_begins()) {
            const std::pair pair(begin.shape_a, begin.shape_b);
            if (!std::binary_search(contacts.begin(), contacts.end(), pair)) brief.push_back(pair);
        }
        std::vector<std::pair<ShapeId, ShapeId>> expected = touching;
        std::erase_if(expected, [&](const auto& pair) { return std::count(brief.begin(), brief.end(), pair) > 0; });
        std::sort(expected.begin(), expected.end());
        ASSERT_EQ(contacts, expected) << "contacts() is what has begun and not ended, step " << i;
        ASSERT_EQ(world.statistics().contacts, contacts.size());
    }
}

TEST(Events, SameSceneGivesSameEventsInSameOrder) {
    auto record = [](bool with_other_world_first) {
        std::vector<World> others(with_other_world_first ? 3 : 0);
        World world;
        add_ground(world);
        for (int i = 0; i < 40; ++i) add_crate(world, {0.6 * (i % 5), 1.0 + 1.1 * (i / 5), 0.3 * (i % 3)});
        std::vector<std::uint32_t> log;
        for (int i = 0; i < 300; ++i) {
            world.step(frame);
            for (const auto& e : world.contact_begins())
                log.insert(log.end(), {1u, e.shape_a.index(), e.shape_b.index()});
            for (const auto& e : world.contact_ends())
                log.insert(log.end(), {2u, e.shape_a.index(), e.shape_b.index()});
            for (const auto& e : world.contact_hits())
                log.insert(log.end(), {3u, e.shape_a.index(), e.shape_b.index()});
            for (const auto& e : world.sleep_events())
                log.insert(log.end(), {4u, e.body.index(), std::uint32_t(e.asleep)});
        }
        return log;
    };
    const auto first = record(false);
    EXPECT_GT(first.size(), 100u);
    EXPECT_EQ(first, record(true));
}

TEST(Events, ContactsHoldWhatGravityAsksFor) {
    World world;
    const BodyId ground = add_ground(world);
    const BodyId below = add_crate(world, {0.0, 0.5, 0.0}), above = add_crate(world, {0.1, 1.5, 0.0});
    world.body(below).set_allow_sleep(false);
    run(world, 120);
    ASSERT_EQ(world.contacts().size(), 2u);
    ASSERT_EQ(world.contacts(below).size(), 2u);
    ASSERT_EQ(world.contacts(above).size(), 1u);
    ASSERT_EQ(world.contacts(ground).size(), 1u);
    for (const Contact& contact : world.contacts()) {
        EXPECT_EQ(contact.point_count, 4);
        float impulse = 0;
        for (int i = 0; i < contact.point_count; ++i) impulse += contact.points[i].normal_impulse;
        const bool on_ground = contact.body_a == ground || contact.body_b == ground;
        EXPECT_NEAR(impulse / frame, (on_ground ? 2 : 1) * 1000.0f * 9.81f, 30.0f);
        EXPECT_NEAR(std::fabs(contact.normal.y), 1.0f, 1e-3f);
        for (int i = 0; i < contact.point_count; ++i) {
            EXPECT_NEAR(contact.points[i].point.y, on_ground ? 0.0 : 1.0, 0.01);
            EXPECT_NEAR(contact.points[i].separation, 0.0f, 0.01f);
            EXPECT_NEAR(std::fabs(contact.points[i].point.z), 0.5, 0.01);
        }
    }
}

TEST(Events, FrictionImpulseActsOnB) {
    World world;
    const BodyId ground = add_ground(world);
    const BodyId crate = add_crate(world, {0.0, 0.5, 0.0});
    run(world, 30);
    world.body(crate).set_linear_velocity({5.0f, 0.0f, 0.0f});
    world.step(frame);
    ASSERT_EQ(world.contacts().size(), 1u);
    const Contact contact = world.contacts()[0];
    // Friction decelerates the crate with 0.6 of its weight, and acts on the ground with the opposite sign.
    const float sign = contact.body_b == ground ? 1.0f : -1.0f;
    EXPECT_NEAR(sign * contact.friction_impulse.x, 0.6f * 9810.0f * frame, 0.05f * 9810.0f * frame);
    EXPECT_NEAR(contact.friction_impulse.y, 0.0f, 1.0f);
}

TEST(Events, SleepAndWakeAreReportedOnceForEachBody) {
    World world;
    add_ground(world, without_friction());
    const BodyId below = add_crate(world, {0.0, 0.5, 0.0}), above = add_crate(world, {0.0, 1.5, 0.0});
    std::vector<BodyId> asleep;
    for (int i = 0; i < 240; ++i) {
        world.step(frame);
        for (const SleepEvent& event : world.sleep_events()) {
            EXPECT_TRUE(event.asleep);
            EXPECT_FALSE(world.body(event.body).is_awake());
            asleep.push_back(event.body);
        }
    }
    std::sort(asleep.begin(), asleep.end());
    EXPECT_EQ(asleep, (std::vector<BodyId>{below, above}));
    world.body(above).wake();
    EXPECT_TRUE(world.body(below).is_awake()) << "an island wakes as a whole";
    world.step(frame);
    EXPECT_EQ(world.statistics().awake_bodies, 2u);
    std::vector<BodyId> woken;
    for (const SleepEvent& event : world.sleep_events())
        if (!event.asleep) woken.push_back(event.body);
    std::sort(woken.begin(), woken.end());
    EXPECT_EQ(woken, (std::vector<BodyId>{below, above})) << "what woke between two steps is an event of the second";
}

} // namespace
} // namespace cairn::test
