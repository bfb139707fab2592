// Bodies in fluids: how they float, bob, turn, sink and drift, against hydrostatics and closed forms. The direction of
// gravity is random.
#include "support.h"

#include "validation/random_starts.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace cairn_test {
namespace {

constexpr double water = 1000;

ForceField still_water() {
    ForceField field;
    field.kind = ForceField::Kind::fluid;
    return field;
}

// A world with gravity in a random direction and a fluid at a random place. `random` transforms coordinates with y up
// and the surface at 0 into the world.
class Sea {
  public:
    explicit Sea(std::uint32_t seed, ForceField field = still_water()) : random(seed), world(with_gravity(random)) {
        field.center = random.place({0, 0, 0});
        field.direction = Vec3(random.turned(glm::dvec3(field.direction)));
        fluid = world.add_force_field(field);
    }
    BodyId add(const Shape& shape, double density, const glm::dvec3& place, const glm::dvec3& velocity = {},
               const Quat& turned = Quat{1, 0, 0, 0}) {
        BodyDef def;
        def.position = random.place(place);
        def.rotation = random.quat() * turned;
        def.linear_velocity = Vec3(random.turned(velocity));
        ShapeDef shape_def;
        shape_def.density = float(density);
        const BodyId body = world.create_body(def);
        world.add_shape(body, shape, shape_def);
        return body;
    }
    void run(double seconds, float dt = 1 / 60.0f) {
        for (int i = 0; i < int(std::lround(seconds / double(dt))); ++i) world.step(dt);
    }
    double height(BodyId body) const {
        return random.back(world.body(body).center_of_mass() - random.place({0, 0, 0})).y;
    }
    glm::dvec3 velocity(BodyId body) const { return random.back(glm::dvec3(world.body(body).linear_velocity())); }

    RandomStart random;
    World world;
    ForceFieldId fluid;

  private:
    static WorldDef with_gravity(const RandomStart& random) {
        WorldDef def = without_sleep();
        def.gravity = Vec3(random.turned({0, -gravity, 0}));
        return def;
    }
};

// The depth of the lowest point of a ball, m, of whose volume the fraction `part` is submerged.
double depth_of_ball(double radius, double part) {
    double low = 0, high = 2 * radius;
    for (int i = 0; i < 60; ++i) {
        const double d = 0.5 * (low + high), wet = d * d * (3 * radius - d) / (4 * radius * radius * radius);
        (wet < part ? low : high) = d;
    }
    return low;
}

TEST(Fluids, WhatFloatsIsAsDeepAsItsDensitySays) {
    for (std::uint32_t seed = 0; seed < 24; ++seed) {
        Sea sea(seed);
        const double part = sea.random.uniform(0.1, 0.9), half = std::exp(sea.random.uniform(-3, 0.5));
        const BodyId box = sea.add(Box{{float(half), float(0.3 * half), float(half)}}, part * water, {0, 0, 0}),
                     can = sea.add(Cylinder{float(0.3 * half), float(half)}, part * water, {4 * half, 0, 0}),
                     ball = sea.add(Sphere{float(half)}, part * water, {8 * half, 0, 0}),
                     hull = sea.add(Hull(box_corners({float(half), float(0.3 * half), float(half)})), part * water,
                                    {12 * half, 0, 0});
        sea.run(40);
        const double flat = (1 - 2 * part) * 0.3 * half, round = half - depth_of_ball(half, part);
        for (const BodyId body : {box, can, hull})
            EXPECT_NEAR(sea.height(body), flat, 0.003 * half) << seed << ' ' << part;
        EXPECT_NEAR(sea.height(ball), round, 0.003 * half) << seed << ' ' << part;
        for (const BodyId body : {box, can, ball, hull})
            EXPECT_LT(glm::length(sea.velocity(body)), 0.02 * std::sqrt(half)) << seed;
    }
}

// Without added mass the period is 2 pi sqrt(draft / g); without drag and wave damping no energy is lost.
TEST(Fluids, WhatBobsKeepsItsEnergyAndItsPeriod) {
    for (const Integrator integrator : {Integrator::semi_implicit_euler, Integrator::explicit_euler, Integrator::rk4})
        for (const int substeps : {0, 1, 4}) {
            ForceField field = still_water();
            field.drag = field.skin_friction = field.wave_damping = 0;
            field.added_mass = 0;
            Sea sea(std::uint32_t(substeps) + 7, field);
            WorldDef def = sea.world.settings();
            def.integrator = integrator, def.substeps = substeps;
            sea.world.set_settings(def);
            const double half = 0.3, part = 0.5, amplitude = 0.1;
            const BodyId box = sea.add(Box{{1, float(half), 1}}, part * water, {0, amplitude, 0});
            const double omega = std::sqrt(gravity / (2 * half * part));
            double greatest = 0, last = amplitude;
            int crossings = 0, steps = 0;
            for (; steps < 60 * 60; ++steps) {
                sea.world.step(1 / 60.0f);
                const double y = sea.height(box);
                if (steps > 50 * 60) greatest = std::max(greatest, std::fabs(y));
                crossings += y * last < 0;
                last = y;
            }
            EXPECT_NEAR(greatest, amplitude, 0.01 * amplitude) << int(integrator) << ' ' << substeps;
            EXPECT_NEAR(crossings, 60 * omega / pi, 0.004 * 60 * omega / pi + 1) << int(integrator) << ' ' << substeps;
        }
}

TEST(Fluids, WhatSinksReachesItsTerminalSpeed) {
    for (const float dt : {1 / 30.0f, 1 / 60.0f, 1 / 240.0f})
        for (std::uint32_t seed = 0; seed < 6; ++seed) {
            ForceField field = still_water();
            field.skin_friction = 0;
            field.drag = float(RandomStart(seed).uniform(0.3, 2));
            Sea sea(seed + 50, field);
            const double radius = std::exp(sea.random.uniform(-4, 0)), density = sea.random.uniform(1.2, 8) * water;
            const BodyId ball = sea.add(Sphere{float(radius)}, density, {0, -2, 0});
            const BodyId cube = sea.add(Box{Vec3(float(radius))}, density, {9, -2, 0});
            sea.run(60 * std::max(1.0, radius), dt);
            const double g = gravity * (density - water);
            const double of_ball = std::sqrt(g * 4 / 3 * radius / (0.25 * water * double(field.drag))),
                         of_cube = std::sqrt(g * 2 * radius / (0.5 * water * double(field.drag)));
            EXPECT_NEAR(-sea.velocity(ball).y, of_ball, 0.003 * of_ball) << seed;
            EXPECT_NEAR(-sea.velocity(cube).y, of_cube, 0.01 * of_cube) << seed;
        }
}

// However light, fast and thin a body is, it gains no energy when it enters the water, and comes to rest on it.
TEST(Fluids, LightThingsThatAreThrownInComeToRest) {
    for (std::uint32_t seed = 0; seed < 60; ++seed) {
        Sea sea(seed + 200);
        const double size = std::exp(sea.random.uniform(-4, 0)), density = std::exp(sea.random.uniform(1, 6.5));
        const Shape shapes[] = {Sphere{float(size)}, Box{{float(size), float(0.05 * size), float(size)}},
                                Capsule{float(0.5 * size), float(0.5 * size)},
                                Box{{float(size), float(0.3 * size), float(0.5 * size)}}};
        const Quat turned = glm::normalize(Quat(float(sea.random.uniform(-1, 1)), float(sea.random.uniform(-1, 1)),
                                                float(sea.random.uniform(-1, 1)), float(sea.random.uniform(-1, 1))));
        const BodyId body = sea.add(shapes[seed % 4], density, {0, 3 * size + 0.5, 0},
                                    {sea.random.uniform(-20, 20), -sea.random.uniform(0, 60), 0}, turned);
        const double mass = double(sea.world.body(body).mass());
        const auto energy = [&] { return sea.world.kinetic_energy() + mass * gravity * sea.height(body); };
        double most = energy();
        for (int i = 0; i < 30 * 60; ++i) {
            sea.world.step(1 / 60.0f);
            // The body may have continued below the surface for one step.
            ASSERT_LT(sea.world.kinetic_energy(), 1.001 * most + mass * gravity * (4 * size + 1.1)) << seed << ' ' << i;
        }
        EXPECT_LT(glm::length(sea.velocity(body)), 0.3) << seed << ' ' << density << ' ' << size;
    }
}

// A long beam of square cross section floats flat if it is very light or very heavy, and on edge at half the density of
// water. (The metacenter of its flat pose is below its center of mass at relative densities of 0.211 to 0.789.)
TEST(Fluids, SquareLogsFloatFlatOrOnEdge) {
    for (const double part : {0.12, 0.5, 0.88})
        for (std::uint32_t seed = 0; seed < 6; ++seed) {
            Sea sea(seed + 400);
            const double start = sea.random.uniform(0.1, 0.65);
            const BodyId log =
                sea.add(Box{{0.2f, 0.2f, 2}}, part * water, {0, 0, 0}, {}, glm::angleAxis(float(start), Vec3{0, 0, 1}));
            sea.run(60);
            const glm::dvec3 side = sea.random.back(glm::dvec3(sea.world.body(log).rotation() * Vec3{1, 0, 0}));
            double lean = std::fabs(std::atan2(side.y, side.x)); // inclination of its sides, 0 to 45 degrees
            lean = std::fmod(lean, pi / 2);
            lean = std::min(lean, pi / 2 - lean);
            EXPECT_NEAR(lean, part == 0.5 ? pi / 4 : 0, 0.03) << part << ' ' << seed;
        }
}

// A body that floats in a current and is not held takes on the velocity of the current.
TEST(Fluids, WhatFloatsGoesWithTheFlow) {
    ForceField field = still_water();
    field.direction = {1.5f, 0, 0};
    Sea sea(3, field);
    std::vector<BodyId> bodies;
    bodies.push_back(sea.add(Sphere{0.2f}, 500, {0, 0, 0}));
    bodies.push_back(sea.add(Box{{0.3f, 0.2f, 0.4f}}, 300, {2, 0, 0}));
    bodies.push_back(sea.add(Capsule{0.3f, 0.1f}, 700, {4, 0, 0}));
    bodies.push_back(sea.add(Sphere{0.2f}, water, {6, -5, 0}));
    sea.run(60);
    for (const BodyId body : bodies) EXPECT_NEAR(sea.velocity(body).x, 1.5, 0.05);
}

// The part of a beam beyond the side of a pool has no buoyancy. The beam is aligned with the world axes, as the pool
// is.
TEST(Fluids, OnlyWhatIsWithinTheSidesIsLifted) {
    ForceField field = still_water();
    field.half_extents = {2, 3, 4}, field.added_mass = 0;
    World world(without_sleep());
    world.add_force_field(field);
    const auto in_one_step = [&](const Shape& shape, const Position& place) {
        BodyDef def;
        def.position = place;
        const BodyId body = world.create_body(def);
        world.add_shape(body, shape, ShapeDef{.density = 500});
        world.step(1 / 600.0f);
        const Vec3 v = 600.0f * world.body(body).linear_velocity(), w = 600.0f * world.body(body).angular_velocity();
        world.destroy_body(body);
        return std::pair<Vec3, Vec3>{v, w};
    };
    const Box beam{{1, 0.1f, 0.1f}};
    const double twice = gravity; // upward, m/s^2, of a submerged body of half the density of water
    EXPECT_NEAR(in_one_step(beam, {0, -1, 0}).first.y, twice, 0.01);
    const auto [half_in, turned] = in_one_step(beam, {2, -1, 0});
    EXPECT_NEAR(half_in.y, 0, 0.01); // the submerged half has a lift of twice its weight
    // The lift acts 0.5 m from the center: m g x 0.5 m over m (4 + 0.04) / 12 m^2.
    EXPECT_NEAR(turned.z, -gravity * 0.5 / (4.04 / 12), 0.05);
    EXPECT_NEAR(in_one_step(beam, {3.01, -1, 0}).first.y, -gravity, 0.01);
    EXPECT_NEAR(in_one_step(beam, {0, -1, 4}).first.y, 0, 0.01);
    EXPECT_NEAR(in_one_step(beam, {0, -2.95, 0}).first.y, twice, 0.01); // through the bottom: full lift
    EXPECT_NEAR(in_one_step(beam, {0, -3.05, 0}).first.y, -gravity, 0.01);
    EXPECT_NEAR(in_one_step(Sphere{0.5f}, {1.9, -1, 0}).first.y, twice, 0.01);
    EXPECT_NEAR(in_one_step(Sphere{0.5f}, {0, 0, 0}).first.y, 0, 0.01);
}

// A raft that sleeps on the water and is woken moves as if it had stayed awake, whether a stone is put down on it or
// falls on it. In the impact that wakes it, the raft does not yet have its added mass.
TEST(Fluids, WhatWakesOnTheWaterDoesNotFall) {
    for (const double height : {0.3995, 1.0}) {
        const auto raft_under_a_stone = [&](bool sleeps) {
            World world(sleeps ? WorldDef{} : without_sleep());
            world.add_force_field(still_water());
            const BodyId raft = world.create_body({});
            world.add_shape(raft, Box{{2, 0.2f, 2}}, ShapeDef{.density = 500});
            for (int i = 0; i < 600; ++i) world.step(1 / 60.0f);
            EXPECT_EQ(world.body(raft).is_awake(), !sleeps);
            const BodyId stone = world.create_body({.position = {0, height, 0}});
            world.add_shape(stone, Sphere{0.2f}, ShapeDef{.density = 2000});
            std::vector<double> heights;
            for (int i = 0; i < (height < 0.4 ? 25 : 45); ++i) { // before the raft falls asleep again
                world.step(1 / 60.0f);
                heights.push_back(world.body(raft).position().y);
            }
            EXPECT_TRUE(world.body(raft).is_awake());
            return heights;
        };
        const std::vector<double> woken = raft_under_a_stone(true), awake = raft_under_a_stone(false);
        for (std::size_t i = 0; i < woken.size(); ++i)
            EXPECT_NEAR(woken[i], awake[i], height < 0.4 ? 1e-4 : 0.006) << height << ' ' << i;
    }
}

// A wide ship rolls and heaves for a long time: it must not fall asleep at a turning point, where it is slow.
TEST(Fluids, LargeThingsDoNotFallAsleepBesideTheirPlace) {
    WorldDef def;
    World world(def);
    world.add_force_field(still_water());
    BodyDef ship;
    ship.position = {0, 0.6, 0};
    const BodyId body = world.create_body(ship);
    world.add_shape(body, Box{{20, 5, 8}}, ShapeDef{.density = 500});
    for (int i = 0; i < 300 * 60; ++i) world.step(1 / 60.0f);
    EXPECT_NEAR(world.body(body).position().y, 0, 0.08);
    EXPECT_FALSE(world.body(body).is_awake());
}

// The added mass of a ball is half of the water that it displaces; a ball at rest on a rope pulls with its full
// buoyancy less its weight.
TEST(Fluids, WhatIsLightIsHeldBackByWhatItMovesAlong) {
    for (const double density : {3.0, 100.0, 500.0, 900.0}) {
        Sea sea(31);
        const double radius = 0.2, volume = 4.0 / 3 * pi * radius * radius * radius;
        const BodyId ball = sea.add(Sphere{float(radius)}, density, {0, -3, 0});
        const BodyId buoy = sea.add(Sphere{float(radius)}, density, {2, -3, 0});
        const Position anchor = sea.random.place({2, -3 - radius, 0});
        const BodyId ground = sea.world.create_body({.type = BodyType::static_, .position = anchor});
        const JointId rope = sea.world.create_joint(sea.world.joint_at(ground, buoy, anchor, {0, 1, 0}, BallJoint{}));
        sea.world.step(1 / 240.0f);
        const double lift = gravity * (water - density);
        EXPECT_NEAR(sea.velocity(ball).y * 240, lift / (density + 0.5 * water), 0.01 * lift / (density + 0.5 * water));
        sea.run(2);
        EXPECT_NEAR(double(glm::length(sea.world.joint_state(rope).force)), lift * volume, 0.01 * lift * volume)
            << density;
    }
}

TEST(Fluids, AreTheSameForAnyNumberOfThreadsAndAfterASnapshot) {
    const auto make = [](int threads) {
        World world;
        world.set_threads(threads);
        ForceField river = still_water();
        river.direction = {0.3f, 0, 0}, river.half_extents = {30, 4, 20};
        world.add_force_field(river);
        RandomStart random(9);
        for (int i = 0; i < 200; ++i) {
            BodyDef def;
            def.position = {random.uniform(-10, 10), random.uniform(-1, 3), random.uniform(-10, 10)};
            const BodyId body = world.create_body(def);
            const float size = float(random.uniform(0.1, 0.5));
            const Shape shapes[] = {Sphere{size}, Box{{size, 0.5f * size, 0.7f * size}}, Capsule{size, 0.5f * size},
                                    Cylinder{0.4f * size, size}};
            world.add_shape(body, shapes[i % 4], ShapeDef{.density = float(random.uniform(50, 1500))});
        }
        return world;
    };
    World one = make(1), four = make(4);
    for (int i = 0; i < 60; ++i) one.step(1 / 60.0f), four.step(1 / 60.0f);
    EXPECT_EQ(one.state_hash(), four.state_hash());
    const Snapshot saved = one.save();
    for (int i = 0; i < 60; ++i) one.step(1 / 60.0f);
    World other;
    other.restore(saved);
    for (int i = 0; i < 60; ++i) other.step(1 / 60.0f);
    EXPECT_EQ(one.state_hash(), other.state_hash());
    EXPECT_EQ(other.force_field(other.force_fields()[0]).half_extents, Vec3(30, 4, 20));
}

} // namespace
} // namespace cairn_test
