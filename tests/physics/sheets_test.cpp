// Two-sided planes, and strips, which are infinite along one axis only.
#include "support.h"

#include <limits>

namespace cairn_test {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

struct Sheet {
    const char* name;
    Plane plane;
};
std::vector<Sheet> sheets() {
    return {{"infinite", Plane{{0, 1, 0}, {1, 0, 0}, {}, true}},
            {"rectangle", Plane{{0, 1, 0}, {1, 0, 0}, glm::vec2(4, 3), true}},
            {"strip along x", Plane{{0, 1, 0}, {1, 0, 0}, glm::vec2(infinity, 3), true}},
            {"strip along z", Plane{{0, 1, 0}, {1, 0, 0}, glm::vec2(3, infinity), true}}};
}
std::vector<Shape> balls_and_boxes() {
    return {Sphere{0.5f}, Box{{0.5f, 0.5f, 0.5f}}, Box{{0.4f, 0.4f, 0.4f}, 0.1f}, Capsule{0.25f, 0.25f},
            Cylinder{0.5f, 0.5f}};
}

WorldDef pulled(float gravity) {
    WorldDef def;
    def.gravity = {0, gravity, 0};
    return def;
}

// Gravity pulls bodies toward the sheet from each of its sides, which face up and down.
TEST(Sheets, HoldWhatFallsOnThemFromEitherSide) {
    for (const Sheet& sheet : sheets())
        for (const Shape& shape : balls_and_boxes())
            for (const double side : {1.0, -1.0}) {
                World world(pulled(float(-9.81 * side)));
                BodyDef def;
                def.type = BodyType::static_;
                add_body(world, sheet.plane, def, surface(0.5f));
                def.type = BodyType::dynamic;
                def.position = {0.3, 2 * side, 0.2};
                const BodyId id = add_body(world, shape, def, surface(0.5f));
                run(world, 1.0f / 60.0f, 240);
                const std::string what = std::string(sheet.name) + ", shape " + std::to_string(shape.index()) +
                                         ", side " + std::to_string(int(side));
                EXPECT_NEAR(world.body(id).position().y, 0.5 * side, 2e-3) << what;
                EXPECT_FALSE(world.body(id).is_awake()) << what;
            }
}

// Two bodies at once, one on each side, pressed against the sheet.
TEST(Sheets, HoldTwoThingsBackToBack) {
    for (const Sheet& sheet : sheets()) {
        World world(without_gravity());
        BodyDef def;
        def.type = BodyType::static_;
        add_body(world, sheet.plane, def);
        def.type = BodyType::dynamic;
        def.position = {0, 0.5, 0};
        const BodyId above = add_body(world, Sphere{0.5f}, def);
        def.position = {0, -0.5, 0};
        const BodyId below = add_body(world, Sphere{0.5f}, def);
        for (int i = 0; i < 240; ++i) {
            world.body(above).add_force({0, -5000, 0});
            world.body(below).add_force({0, 5000, 0});
            world.step(1.0f / 60.0f);
        }
        EXPECT_NEAR(world.body(above).position().y, 0.5, 2e-3) << sheet.name;
        EXPECT_NEAR(world.body(below).position().y, -0.5, 2e-3) << sheet.name;
    }
}

TEST(Sheets, FastThingsDoNotPass) {
    for (const Sheet& sheet : sheets())
        for (const Shape& shape : balls_and_boxes())
            for (const double side : {1.0, -1.0})
                for (const float speed : {10.0f, 60.0f, 300.0f}) {
                    World world(without_gravity());
                    BodyDef def;
                    def.type = BodyType::static_;
                    add_body(world, sheet.plane, def);
                    def.type = BodyType::dynamic;
                    def.position = {0.1, 7 * side, 0.2};
                    def.linear_velocity = {0, float(-side) * speed, 0};
                    const BodyId id = add_body(world, shape, def);
                    run(world, 1.0f / 60.0f, 60);
                    EXPECT_GT(side * world.body(id).position().y, 0.4)
                        << sheet.name << " " << shape.index() << " " << side << " " << speed;
                }
}

// A body with parts on both sides of a rectangle, like a clip over its edge, stays where it is.
TEST(Sheets, AClipHoldsOnToTheEdgeOfARectangle) {
    World world(without_gravity());
    BodyDef def;
    def.type = BodyType::static_;
    add_body(world, Plane{{0, 1, 0}, {1, 0, 0}, glm::vec2(2, 2), true}, def);
    def.type = BodyType::dynamic;
    def.position = {2.2, 0, 0};
    const BodyId clip = world.create_body(def);
    for (const float y : {0.12f, -0.12f}) {
        ShapeDef jaw;
        jaw.position = {-0.4f, y, 0};
        world.add_shape(clip, Box{{0.5f, 0.1f, 0.2f}}, jaw);
    }
    ShapeDef back;
    back.position = {0.2f, 0, 0};
    world.add_shape(clip, Box{{0.1f, 0.22f, 0.2f}}, back);
    for (int i = 0; i < 240; ++i) {
        world.body(clip).add_force({0, i / 40 % 2 == 0 ? 300.0f : -300.0f, 0});
        world.step(1.0f / 60.0f);
        ASSERT_LT(std::fabs(world.body(clip).position().y), 0.025) << i;
    }
}

// One-sided strips hold bodies on their front only, along their whole length, and end at their sides.
TEST(Sheets, AStripHasSidesAndNoEnds) {
    for (const double x : {0.0, 50.0, 1e4, 1e6}) {
        World world;
        BodyDef def;
        def.type = BodyType::static_;
        add_body(world, Plane{{0, 1, 0}, {1, 0, 0}, glm::vec2(infinity, 1)}, def, surface(0.5f));
        def.type = BodyType::dynamic;
        std::vector<BodyId> on, beside;
        for (const Shape& shape : balls_and_boxes()) {
            def.position = {x + 3 * double(on.size()), 0.6, 0};
            on.push_back(add_body(world, shape, def, surface(0.5f)));
            def.position.z = 2.1;
            beside.push_back(add_body(world, shape, def, surface(0.5f)));
        }
        run(world, 1.0f / 60.0f, 180);
        for (const BodyId id : on) EXPECT_NEAR(world.body(id).position().y, 0.5, 2e-3) << x;
        for (const BodyId id : beside) EXPECT_LT(world.body(id).position().y, -10) << x;
    }
}

TEST(Sheets, ThingsSlideAlongAStripAsOnAPlane) {
    double speeds[2];
    for (const bool is_strip : {false, true}) {
        World world(without_sleep());
        BodyDef def;
        def.type = BodyType::static_;
        Plane plane;
        if (is_strip) plane.half_extents = glm::vec2(infinity, 2);
        add_body(world, plane, def, surface(0.05f));
        def.type = BodyType::dynamic;
        def.position = {0, 0.3, 0};
        def.linear_velocity = {14, 0, 0};
        const BodyId id = add_body(world, Box{{0.4f, 0.3f, 0.5f}}, def, surface(0.05f));
        run(world, 1.0f / 60.0f, 480);
        speeds[is_strip] = double(world.body(id).linear_velocity().x);
        EXPECT_NEAR(world.body(id).position().z, 0, 0.01);
    }
    EXPECT_GT(speeds[0], 5);
    EXPECT_NEAR(speeds[1], speeds[0], 0.02);
}

} // namespace
} // namespace cairn_test
