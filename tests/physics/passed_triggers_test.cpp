// A body that passes through a trigger within a step causes an enter and a leave event.
#include "support.h"

#include "validation/random_starts.h"

#include <cmath>
#include <string>
#include <vector>

namespace cairn_test {
namespace {

ShapeDef trigger() {
    ShapeDef def;
    def.is_trigger = true;
    return def;
}

WorldDef weightless() {
    WorldDef def = without_sleep();
    def.gravity = {0, 0, 0};
    return def;
}

BodyId add_trigger(World& world, const Shape& shape, const RandomStart& random, const glm::dvec3& place,
                   BodyType type = BodyType::static_) {
    BodyDef def;
    def.type = type;
    def.position = random.place(place);
    def.rotation = random.quat();
    const BodyId body = world.create_body(def);
    world.add_shape(body, shape, trigger());
    return body;
}

Mesh sheet() {
    const std::vector<Vec3> corners{{0, -2, -2}, {0, 2, -2}, {0, 2, 2}, {0, -2, 2}};
    const std::vector<std::uint32_t> triangles{0, 1, 2, 0, 2, 3};
    return Mesh(corners, triangles);
}

// Shoots a spinning body along the -x axis of the start, from 4 to 7 m before the origin.
BodyId shoot(World& world, const Shape& shape, RandomStart& random, double speed) {
    BodyDef def;
    def.position = random.place({random.uniform(4, 7), random.uniform(-0.2, 0.2), random.uniform(-0.2, 0.2)});
    def.rotation = random.quat();
    def.linear_velocity = Vec3(random.turned({-speed, 0, 0}));
    def.angular_velocity = Vec3(float(random.uniform(0, 20)), 3, float(random.uniform(-5, 5)));
    return add_body(world, shape, def, surface(0.5f));
}

// Counts enter and leave events of a trigger; the two must alternate.
struct Visits {
    int in = 0, out = 0;
    bool alternate = true;
    void note(const World& world) {
        for (const TriggerEvent& event : world.trigger_events()) {
            ++(event.inside ? in : out);
            alternate &= in - out == (event.inside ? 1 : 0);
        }
    }
};

class PassedTriggersAt : public ::testing::TestWithParam<double> {};

TEST_P(PassedTriggersAt, SeeWhatFliesThroughThem) {
    const double speed = GetParam();
    const Shape triggers[] = {Box{Vec3(0.05f, 1, 1)}, Sphere{0.5f}, Capsule{0.5f, 0.3f}, Cylinder{0.6f, 0.4f}, sheet()};
    const Shape shots[] = {Box{Vec3(0.05f)}, Sphere{0.03f}, Capsule{0.1f, 0.03f}};
    RandomStart seeds(2428);
    for (const Shape& zone : triggers)
        for (const Shape& shot : shots)
            for (int i = 0; i < 8; ++i) {
                RandomStart random(std::uint32_t(seeds.uniform(0, 1e6)));
                World world(weightless());
                add_trigger(world, zone, random, {0, 0, 0});
                const BodyId body = shoot(world, shot, random, speed);
                Visits visits;
                for (int step = 0; step < int(60 * 14 / speed) + 3; ++step) world.step(1.0f / 60), visits.note(world);
                EXPECT_LT(random.back(Vec3(world.body(body).linear_velocity())).x, -0.99 * speed); // nothing was hit
                EXPECT_TRUE(visits.alternate);
                EXPECT_GE(visits.in, 1) << i;
                EXPECT_LE(visits.in, 2) << i; // a corner may reenter as the body rotates
                EXPECT_EQ(visits.in, visits.out) << i;
            }
}
INSTANTIATE_TEST_SUITE_P(Speeds, PassedTriggersAt, ::testing::Values(5, 30, 100, 400),
                         [](const auto& info) { return std::to_string(int(info.param)) + "MetersPerSecond"; });

// Enter events within one step are in the order in which the body reaches the triggers.
TEST(PassedTriggers, AreListedInTheOrderOfTheFlight) {
    for (int i = 0; i < 20; ++i) {
        RandomStart random(std::uint32_t(50 + i));
        World world(weightless());
        std::vector<BodyId> zones;
        for (int k = 0; k < 5; ++k) { // not created in the order of the passage
            const double place = 0.4 * ((k * 3) % 5);
            zones.push_back(add_trigger(world, Box{Vec3(0.05f, 1, 1)}, random, {place, 0, 0}));
        }
        shoot(world, Sphere{0.03f}, random, 400);
        std::vector<double> places;
        for (int step = 0; step < 4; ++step) {
            world.step(1.0f / 60);
            for (const TriggerEvent& event : world.trigger_events())
                if (event.inside)
                    for (int k = 0; k < 5; ++k)
                        if (event.trigger_body == zones[std::size_t(k)]) places.push_back(0.4 * ((k * 3) % 5));
        }
        ASSERT_EQ(places.size(), 5u) << i;
        EXPECT_TRUE(std::is_sorted(places.rbegin(), places.rend())) << i; // the body comes from the far end
    }
}

// A ball bounces between two walls and passes the trigger in the middle each time, several times per step.
TEST(PassedTriggers, SeeEveryPassOfWhatBounces) {
    for (const double speed : {20.0, 90.0}) {
        RandomStart random(7);
        World world(weightless());
        for (const double side : {-1.0, 1.0}) {
            BodyDef wall;
            wall.type = BodyType::static_;
            wall.position = random.place({side * 0.6, 0, 0});
            wall.rotation = random.quat();
            ShapeDef def;
            def.material = surface(0, 1);
            world.add_shape(world.create_body(wall), Box{Vec3(0.1f, 1, 1)}, def);
        }
        add_trigger(world, Box{Vec3(0.01f, 0.5f, 0.5f)}, random, {0, 0, 0});
        BodyDef def;
        def.position = random.place({0.2, 0, 0});
        def.linear_velocity = Vec3(random.turned({speed, 0, 0}));
        ShapeDef elastic;
        elastic.material = surface(0, 1);
        const BodyId ball = world.create_body(def);
        world.add_shape(ball, Sphere{0.05f}, elastic);
        Visits visits;
        for (int step = 0; step < 60; ++step) world.step(1.0f / 60), visits.note(world);
        const double passes = speed / 0.9; // passes per second; the distance between the walls is 0.9 m
        EXPECT_TRUE(visits.alternate) << speed;
        EXPECT_NEAR(visits.in, passes, speed < 50 ? 1.5 : 0.1 * passes) << speed; // steps may begin or end inside
    }
}

// A trigger on a kinematic body that sweeps over a body at rest.
TEST(PassedTriggers, SeeWhatTheyAreMovedOver) {
    for (int i = 0; i < 10; ++i) {
        RandomStart random(std::uint32_t(90 + i));
        World world(weightless());
        BodyDef def;
        def.position = random.place({0, 0, 0});
        add_body(world, Sphere{0.05f}, def, surface(0.5f));
        const BodyId gate =
            add_trigger(world, Box{Vec3(0.02f, 1, 1)}, random, {random.uniform(2, 3), 0, 0}, BodyType::kinematic);
        world.body(gate).set_linear_velocity(Vec3(random.turned({-60, 0, 0})));
        Visits visits;
        for (int step = 0; step < 8; ++step) world.step(1.0f / 60), visits.note(world);
        EXPECT_EQ(visits.in, 1) << i;
        EXPECT_EQ(visits.out, 1) << i;
    }
}

} // namespace
} // namespace cairn_test
