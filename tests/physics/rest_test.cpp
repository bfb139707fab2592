// Bodies at rest that do not sleep: their contacts are not recomputed, and no contact may be stale.
#include "support.h"

#include "validation/random_starts.h"

#include <algorithm>
#include <cmath>

namespace cairn_test {
namespace {

struct BoxOnTable {
    World world{without_sleep()};
    BodyId table, box;
    explicit BoxOnTable(BodyType type = BodyType::static_) {
        table = world.create_body({.type = type});
        world.add_shape(table, Box{{2, 0.5f, 2}});
        BodyDef def;
        def.position = {0, 1, 0};
        box = world.create_body(def);
        world.add_shape(box, Box{});
        run(world, 1.0f / 60, 120);
    }
    double height() { return world.body(box).position().y; }
};

TEST(Rest, BoxFallsWhenTheTableItRestsOnIsMovedAway) {
    BoxOnTable scene;
    scene.world.body(scene.table).set_position({10, 0, 0});
    run(scene.world, 1.0f / 60, 60);
    EXPECT_LT(scene.height(), -3);
}

TEST(Rest, BoxFallsWhenTheTableItRestsOnLosesItsShape) {
    BoxOnTable scene;
    scene.world.remove_shape(scene.world.body(scene.table).shapes().front());
    run(scene.world, 1.0f / 60, 60);
    EXPECT_LT(scene.height(), -3);
}

TEST(Rest, BoxRidesOnAKinematicTableThatBeginsToMove) {
    BoxOnTable scene(BodyType::kinematic);
    scene.world.body(scene.table).set_linear_velocity({0, 0.1f, 0});
    run(scene.world, 1.0f / 60, 60);
    EXPECT_NEAR(scene.height(), 1.1, 0.005);
}

TEST(Rest, BoxFollowsATableThatIsTurnedByHand) {
    BoxOnTable scene(BodyType::kinematic);
    scene.world.body(scene.table).set_rotation(glm::angleAxis(0.05f, glm::vec3(0, 0, 1)));
    run(scene.world, 1.0f / 60, 120);
    EXPECT_NEAR(glm::angle(scene.world.body(scene.box).rotation()), 0.05, 0.005);
}

TEST(Rest, BoxThatIsPushedSlidesAsOneThatWasNeverAtRest) {
    BoxOnTable rested;
    rested.world.body(rested.box).set_linear_velocity({1, 0, 0});
    const double start = rested.world.body(rested.box).position().x;
    run(rested.world, 1.0f / 60, 60);
    const double friction = Material{}.dynamic_friction;
    EXPECT_NEAR(rested.world.body(rested.box).position().x - start, 1 / (2 * friction * 9.81), 0.01);
}

// Five bodies stacked with gaps from zero to half of the contact tolerance. Pairs must not be omitted from the first
// step because all bodies have the same free fall and so do not approach each other.
TEST(Rest, WhatIsMadeTouchingIsHeldFromTheFirstStep) {
    for (int i = 0; i < 60; ++i) {
        RandomStart start(std::uint32_t(90 + i));
        World world(with_turned_gravity(start));
        BodyDef def;
        def.type = BodyType::static_;
        def.position = start.place({0, 0, 0});
        def.rotation = start.quat();
        add_body(world, Plane{}, def);
        def.type = BodyType::dynamic;
        const double gap = i % 4 == 0 ? 0 : std::pow(10.0, start.uniform(-8, -4.3));
        const Shape shape = i % 3 == 0   ? Shape(Box{{0.1f, 0.1f, 0.1f}})
                            : i % 3 == 1 ? Shape(Hull(box_corners({0.1f, 0.1f, 0.1f})))
                                         : Shape(Cylinder{.half_height = 0.1f, .radius = 0.1f});
        for (int k = 0; k < 5; ++k) {
            def.position = start.place({0, 0.1 + gap + k * (0.2 + gap), 0});
            add_body(world, shape, def);
        }
        world.step(1.0f / 60);
        for (const BodyId id : world.bodies())
            EXPECT_LT(glm::length(world.body(id).linear_velocity()), 0.008) << i << ", " << gap << " m apart";
    }
}

TEST(Rest, SlowCreepIsNotLost) { // 1e-5 m/s
    WorldDef def = without_sleep();
    def.gravity = {0, 0, 0};
    World world(def);
    const BodyId body = world.create_body({});
    world.add_shape(body, Box{});
    BodyDef near_by;
    near_by.position = {0, 1.0001, 0};
    near_by.linear_velocity = {0, -1e-5f, 0};
    const BodyId other = world.create_body(near_by);
    world.add_shape(other, Box{});
    run(world, 1.0f / 60, 60 * 20); // a path of 0.2 mm for a gap of 0.1 mm
    EXPECT_NEAR(world.body(other).position().y - world.body(body).position().y, 1.0, 5e-6);
    EXPECT_LT(world.body(body).position().y, -1e-5); // pushed by the other
}

// Four points of the contact of a box with a mesh are kept. When they were the outermost ones, whether they touched or
// not, 84 of 93 boxes that lay alone on the hills of the benchmark tipped back and forth between peaks forever.
TEST(Rest, BoxesThatLieOnThreePeaksOfATerrainComeToRest) {
    int moving = 0, all = 0;
    for (std::uint32_t seed = 1; seed <= 4; ++seed) {
        World world(without_sleep());
        constexpr int columns = 161;
        std::vector<float> heights;
        std::uint32_t number = seed;
        for (int i = 0; i < columns * columns; ++i) {
            number = number * 1664525u + 1013904223u;
            heights.push_back(0.03f * float(number >> 8) / float(1 << 24));
        }
        BodyDef ground;
        ground.type = BodyType::static_;
        add_body(world, HeightField(columns, columns, {0.25f, 0.25f}, heights), ground, {});
        std::vector<BodyId> boxes;
        for (int row = 0; row < 8; ++row)
            for (int column = 0; column < 8; ++column) {
                BodyDef def;
                // Placed off the corners of the grid: a box centered over one may stand on a single peak for 6 s.
                def.position = {4 * column - 14.0 + 0.03 * row, 0.3, 4 * row - 14.0 + 0.02 * column + 0.04};
                def.rotation = glm::angleAxis(0.1f * float(8 * row + column), glm::vec3(0, 1, 0));
                boxes.push_back(add_body(world, Box{{0.5f, 0.2f, 0.4f}}, def, {}));
            }
        run(world, 1.0f / 60, 360);
        std::vector<float> fastest(boxes.size());
        for (int i = 0; i < 60; ++i) {
            world.step(1.0f / 60);
            for (std::size_t k = 0; k < boxes.size(); ++k)
                fastest[k] = std::max(fastest[k], glm::length(world.body(boxes[k]).linear_velocity()));
        }
        all += int(boxes.size());
        moving += int(std::count_if(fastest.begin(), fastest.end(), [](float v) { return v > 1e-3f; }));
    }
    EXPECT_EQ(all, 256);
    EXPECT_EQ(moving, 0);
}

// Reported contacts are those of the end of the step, at the final poses. Pairs are tested again only after their
// bodies have moved by some millimeters; in between the contact points move with the bodies.
TEST(Rest, ContactsAreWhereTheBodiesAre) {
    for (const bool is_hull : {false, true}) {
        World world(without_sleep());
        BodyDef def;
        def.type = BodyType::kinematic;
        def.angular_velocity = {0.004f, 0.006f, 0.003f};
        def.linear_velocity = {0.003f, -0.002f, 0.001f};
        const BodyId table = add_body(world, Box{{2, 0.5f, 2}}, def, {});
        BodyDef on;
        on.position = {0.7, 0.8, -0.4};
        const std::vector<Vec3> corners = {{0.5f, 0.3f, 0.4f},   {-0.5f, 0.3f, 0.4f},  {0.5f, -0.3f, 0.4f},
                                           {-0.5f, -0.3f, 0.4f}, {0.5f, 0.3f, -0.4f},  {-0.5f, 0.3f, -0.4f},
                                           {0.5f, -0.3f, -0.4f}, {-0.5f, -0.3f, -0.4f}};
        const Shape shape = is_hull ? Shape(Hull(corners)) : Shape(Box{{0.5f, 0.3f, 0.4f}});
        const BodyId box = add_body(world, shape, on, {});
        run(world, 1.0f / 60, 60);
        int seen = 0;
        for (int i = 0; i < 600; ++i) {
            world.step(1.0f / 60);
            for (const Contact& contact : world.contacts())
                for (int k = 0; k < contact.point_count; ++k) {
                    const ContactPoint& point = contact.points[k];
                    const auto own = [&](BodyId id) {
                        const Body body = world.body(id);
                        return glm::inverse(glm::dquat(body.rotation())) * (point.point - body.position());
                    };
                    const glm::dvec3 in_box = own(box), in_table = own(table);
                    EXPECT_LT(std::fabs(std::fabs(in_box.x) - 0.5), 1e-3) << i;
                    EXPECT_LT(std::fabs(std::fabs(in_box.z) - 0.4), 1e-3) << i;
                    // The point lies midway between the bottom of the box and the top of the table, half of the
                    // reported separation from each.
                    EXPECT_NEAR(-0.3 - in_box.y, 0.5 * double(point.separation), 2e-5) << i;
                    EXPECT_NEAR(in_table.y - 0.5, 0.5 * double(point.separation), 2e-5) << i;
                    ++seen;
                }
        }
        EXPECT_GT(seen, 2000);
    }
}

// A belt moves tangentially to its own surface; the box that a wall holds on it stays, and so must its contact points.
TEST(Rest, ABeltDoesNotCarryContactPointsAway) {
    World world(without_sleep());
    BodyDef fixed;
    fixed.type = BodyType::static_;
    const BodyId ground = world.create_body(fixed);
    ShapeDef belt;
    belt.surface_velocity = {2, 0, 0};
    world.add_shape(ground, Box{{10, 0.5f, 2}}, belt);
    fixed.position = {1.5, 1, 0};
    add_body(world, Box{{0.5f, 1, 2}}, fixed, {});
    BodyDef def;
    def.position = {0, 0.8, 0};
    const BodyId box = add_body(world, Box{{0.5f, 0.3f, 0.4f}}, def, {});
    run(world, 1.0f / 60, 1200);
    int seen = 0;
    for (const Contact& contact : world.contacts()) {
        if (contact.body_b != ground && contact.body_a != ground) continue;
        for (int k = 0; k < contact.point_count; ++k, ++seen) {
            const glm::dvec3 off = contact.points[k].point - world.body(box).position();
            EXPECT_NEAR(std::fabs(off.x), 0.5, 1e-3);
            EXPECT_NEAR(std::fabs(off.z), 0.4, 1e-3);
        }
    }
    EXPECT_EQ(seen, 4);
    EXPECT_NEAR(world.body(box).position().x, 0.5, 0.01);
}

// The direction of a belt is given in the frame of the shape, not in a frame made from the normal.
TEST(Rest, ABeltOnAPlaneCarriesAlongItsOwnAxes) {
    for (std::uint32_t seed = 0; seed < 24; ++seed) {
        RandomStart random(seed);
        const glm::dvec3 up(0, 1, 0), along(0, 0, 1);
        WorldDef settings = without_sleep();
        settings.gravity = Vec3(random.turned(-gravity * up));
        World world(settings);
        const BodyId ground = world.create_body({.type = BodyType::static_, .position = random.place({0, 0, 0})});
        // In the frame of the shape the normal is `plane.normal`, and the belt moves along `def.surface_velocity`.
        const RandomStart frame(seed + 100);
        ShapeDef def;
        def.rotation = glm::normalize(Quat(random.rotation() * glm::conjugate(frame.rotation())));
        def.surface_velocity = Vec3(frame.turned(along));
        Plane plane{Vec3(frame.turned(up)), Vec3(frame.turned(along)), {}};
        if (seed % 2) plane.half_extents = glm::vec2(5, 5);
        world.add_shape(ground, plane, def);
        const BodyId box = world.create_body({.position = random.place(0.3 * up), .rotation = random.quat()});
        world.add_shape(box, Box{{0.3f, 0.3f, 0.3f}});
        run(world, 1.0f / 60, 120);
        const glm::dvec3 velocity = random.back(world.body(box).linear_velocity());
        EXPECT_LT(glm::length(velocity - along), 0.01) << "start " << seed;
    }
}

// A pair whose contact points once moved with the bodies instead of being tested must not stay in that state, and be
// moved forever, once its bodies are at rest.
TEST(Rest, WhatWasMovedAlongIsLeftAloneOnceItRests) {
    const std::vector<Vec3> corners = {{0, 0.5f, 0}, {-0.5f, 0, -0.5f}, {0.5f, 0, -0.5f}, {0, 0, 0.5f}};
    const Shape shapes[] = {Box{{0.5f, 0.2f, 0.4f}}, Hull(corners)};
    for (const Shape& shape : shapes) {
        World world(without_sleep());
        BodyDef def;
        def.type = BodyType::static_;
        add_body(world, HeightField(9, 9, {0.5f, 0.5f}, std::vector<float>(81, 0.0f)), def, {});
        def.type = BodyType::dynamic;
        def.position = {0, 0.4, 0};
        add_body(world, shape, def, {});
        run(world, 1.0f / 60, 300);
        EXPECT_EQ(world.statistics().candidate_pairs, 1u);
        EXPECT_EQ(world.statistics().contacts, 1u);
        std::size_t tested = 0; // tests are due now and then, as the body creeps by 1e-6 m/s
        for (int i = 0; i < 60; ++i) {
            world.step(1.0f / 60);
            tested += world.statistics().tested_pairs;
        }
        EXPECT_LT(tested, 30u) << shape.index();
    }
}

// Up to eight corners of two faces touch, and four points are kept. Chosen anew in each step, they followed the
// trembling of the boxes. Returns how many boxes of a heap still move after 15 s; it comes to rest in 5 to 12 s,
// depending on the start.
int moving_in_heap(double shift) {
    World world(without_sleep());
    BodyDef fixed;
    fixed.type = BodyType::static_;
    fixed.position = {0, -1, 0};
    add_body(world, Box{{10, 1, 10}}, fixed, {});
    for (const double side : {-1.0, 1.0}) {
        fixed.position = {4.5 * side, 10, 0};
        add_body(world, Box{{1, 10, 6}}, fixed, {});
        fixed.position = {0, 10, 4.5 * side};
        add_body(world, Box{{6, 10, 1}}, fixed, {});
    }
    std::vector<BodyId> boxes;
    for (int i = 0; i < 160; ++i) {
        BodyDef def;
        def.position = {1.8 * (i % 4) - 2.7 + shift, 1 + 1.8 * (i / 16), 1.8 * (i / 4 % 4) - 2.7};
        def.rotation = glm::angleAxis(0.7f * float(i), glm::normalize(glm::vec3(1 + i % 3, i % 5, i % 7)));
        boxes.push_back(add_body(world, Box{}, def, {}));
    }
    run(world, 1.0f / 60, 900);
    int moving = 0;
    for (const BodyId box : boxes) moving += glm::length(world.body(box).linear_velocity()) > 1e-3f ? 1 : 0;
    return moving;
}

TEST(Rest, AHeapOfEqualBoxesComesToRest) {
    for (int i = 0; i < 6; ++i) EXPECT_EQ(moving_in_heap(1e-5 * i), 0) << i;
}

// Rows of dominoes along a spiral that have fallen on each other. When friction acted at the center of the load of the
// previous step, a quarter of them rocked sideways forever, at 3 cm/s.
TEST(Rest, FallenDominoesComeToRest) {
    for (int shot = 0; shot < 32; ++shot) {
        World world;
        BodyDef ground;
        ground.type = BodyType::static_;
        ground.position = {0, -1, 0};
        add_body(world, Box{{20, 1, 20}}, ground, {});
        std::vector<BodyId> dominoes;
        for (int i = 0; i < 40; ++i) {
            const double angle = 2 * std::atan(0.03 * i);
            BodyDef def;
            def.position = {8 * std::cos(angle), 0.5, 8 * std::sin(angle)};
            def.rotation = glm::angleAxis(float(-angle), glm::vec3(0, 1, 0));
            dominoes.push_back(add_body(world, Box{{0.3f, 0.5f, 0.05f}}, def, {}));
        }
        Body first = world.body(dominoes.front());
        first.apply_impulse_at(first.mass() * Vec3(0, 0, 1.3f + 0.015f * float(shot)),
                               first.position() + Position(0, 0.4, 0));
        run(world, 1.0f / 60, 900);
        int awake = 0;
        for (const BodyId domino : dominoes) awake += world.body(domino).is_awake();
        EXPECT_EQ(awake, 0) << shot;
    }
}

// When separated pairs were not tested again before they had moved by a fraction of their size, a block of 100 m
// penetrated the ground by 26 cm, and one of 10 m by 2 mm.
TEST(Rest, WhatIsHugeIsTestedBeforeItReachesTheGround) {
    for (const float half : {5.0f, 50.0f})
        for (const double gap : {0.03, 0.1}) {
            World world(without_sleep());
            BodyDef def;
            def.type = BodyType::static_;
            def.position = {0, -1, 0};
            add_body(world, Box{{200, 1, 200}}, def, {});
            std::vector<Vec3> corners;
            for (int i = 0; i < 8; ++i)
                corners.emplace_back(i & 1 ? half : -half, i & 2 ? half : -half, i & 4 ? half : -half);
            def.type = BodyType::dynamic;
            def.position = {0, half + gap, 0};
            def.linear_velocity = {0, -0.1f, 0};
            const BodyId block = add_body(world, Hull(corners), def, {});
            double lowest = gap;
            for (int i = 0; i < 60; ++i) {
                world.step(1.0f / 60);
                lowest = std::min(lowest, world.body(block).position().y - double(half));
            }
            EXPECT_GT(lowest, -0.0005) << half << ' ' << gap;
        }
}

} // namespace
} // namespace cairn_test
