// Every shape at rest on every other, and how round things roll (row 8 of docs/validation.md).
#include "support.h"

#include <array>

namespace cairn_test {
namespace {

struct NamedShape {
    const char* name;
    Shape shape;
    double half_height; // of the lowest point below its origin, as it lies by `rotation`
    Quat rotation{1, 0, 0, 0};
};

const Quat lying = glm::angleAxis(float(pi / 2), Vec3(1, 0, 0));

Hull rounded_hull() { // an octagonal prism
    std::vector<Vec3> points;
    for (const float y : {-0.4f, 0.4f})
        for (int i = 0; i < 8; ++i)
            points.emplace_back(0.5f * std::cos(float(pi) * float(i) / 4), y,
                                0.5f * std::sin(float(pi) * float(i) / 4));
    return Hull(points);
}

std::vector<NamedShape> movers() {
    return {{"sphere", Sphere{0.5f}, 0.5},
            {"box", Box{{0.5f, 0.4f, 0.5f}}, 0.4},
            {"capsule lying", Capsule{0.4f, 0.3f, {}}, 0.3, lying},
            {"tapered capsule upright", Capsule{0.2f, 0.3f, 0.2f}, 0.5},
            {"cylinder on end", Cylinder{0.4f, 0.5f, {}}, 0.4},
            {"cylinder lying", Cylinder{0.5f, 0.4f, {}}, 0.4, lying},
            {"tapered cylinder", Cylinder{0.4f, 0.5f, 0.3f}, 0.4},
            {"cone", cone(0.5f, 0.4f), 0.4},
            {"hull", rounded_hull(), 0.4}};
}

// Wide things to lie on, with their upper side at y = 0.
std::vector<NamedShape> grounds() {
    const std::vector<Vec3> square = {{-6, 0, -6}, {6, 0, -6}, {-6, 0, 6}, {6, 0, 6}};
    const std::vector<std::uint32_t> triangles = {0, 2, 3, 0, 3, 1};
    const std::array<Vec3, 8> slab = {Vec3{-6, -1, -6}, {6, -1, -6}, {-6, -1, 6}, {6, -1, 6},
                                      {-6, 0, -6},      {6, 0, -6},  {-6, 0, 6},  {6, 0, 6}};
    return {{"sphere", Sphere{6.0f}, 6},
            {"box", Box{{6, 1, 6}}, 1},
            {"plane", Plane{}, 0},
            {"rectangle", Plane{{0, 1, 0}, {1, 0, 0}, glm::vec2(6, 6)}, 0},
            {"capsule", Capsule{6.0f, 6.0f, {}}, 6, lying},
            {"cylinder on end", Cylinder{1.0f, 6.0f, {}}, 1},
            {"cylinder lying", Cylinder{6.0f, 6.0f, {}}, 6, lying},
            {"hull", Hull(slab), 0},
            {"mesh", Mesh(square, triangles), 0},
            {"height field", HeightField(7, 7, {2, 2}, std::vector<float>(49, 0.0f)), 0}};
}

// Dropped from a hand's breadth, it comes to rest on the ground, as it was, and sinks less than 2 mm.
TEST(Shapes, EveryShapeRestsOnEveryGround) {
    for (const NamedShape& ground : grounds()) {
        for (const NamedShape& mover : movers()) {
            World world;
            BodyDef def;
            def.type = BodyType::static_;
            def.position = {0, -ground.half_height, 0};
            def.rotation = ground.rotation;
            Material rough = surface(0.8f);
            rough.rolling_friction = 0.02f;
            add_body(world, ground.shape, def, rough);
            def.type = BodyType::dynamic;
            def.position = {0.05, mover.half_height + 0.1, 0.03};
            def.rotation = mover.rotation;
            const BodyId id = add_body(world, mover.shape, def, rough);
            run(world, 1.0f / 60.0f, 300);
            const Body body = world.body(id);
            const std::string what = std::string(mover.name) + " on " + ground.name;
            EXPECT_NEAR(body.position().y, mover.half_height, 0.012) << what;
            EXPECT_LT(deepest_overlap(world), 0.002) << what;
            EXPECT_LT(glm::length(body.linear_velocity()), 0.02) << what;
            const Vec3 up = body.rotation() * Vec3(0, 1, 0), was = mover.rotation * Vec3(0, 1, 0);
            if (!std::holds_alternative<Sphere>(mover.shape)) {
                EXPECT_GT(glm::dot(up, was), 0.995f) << what;
            }
        }
    }
}

// Two dynamic ones of any kinds: the upper one is held by the lower one.
TEST(Shapes, EveryShapeCarriesEveryOther) {
    for (const NamedShape& lower : movers()) {
        for (const NamedShape& upper : movers()) {
            if (std::string(lower.name) == "cone") continue; // nothing rests on its tip
            World world(without_gravity());
            BodyDef def;
            def.rotation = lower.rotation;
            const BodyId a = add_body(world, lower.shape, def, surface(0.5f));
            def.rotation = upper.rotation;
            def.position = {0.01, lower.half_height + upper.half_height + 0.05, 0.02};
            def.linear_velocity = {0, -1, 0};
            const BodyId b = add_body(world, upper.shape, def, surface(0.5f));
            run(world, 1.0f / 60.0f, 60);
            const std::string what = std::string(upper.name) + " on " + lower.name;
            // Inelastic: they go on together, or have turned each other away; but none has passed the other.
            EXPECT_LT(world.body(a).linear_velocity().y, -0.05f) << what;
            EXPECT_GT(world.body(b).position().y, world.body(a).position().y + 0.3) << what;
            EXPECT_LT(deepest_overlap(world), 0.01) << what;
        }
    }
}

class RoundThings : public EveryStep {};
CAIRN_AT_EVERY_STEP(RoundThings);

// Row 8: a = g sin / (1 + 1/2).
TEST_P(RoundThings, CylinderRollsDownASlopeWithTwoThirdsOfGravity) {
    const Slope slope{radians(30)};
    World world;
    slope.add_to(world, surface(0.8f));
    BodyDef def;
    def.position = 0.5 * slope.normal();
    def.rotation = lying;
    const BodyId id = add_body(world, Cylinder{0.5f, 0.5f, {}}, def, surface(0.8f));
    const auto speed = [&] { return glm::dot(glm::dvec3(world.body(id).linear_velocity()), slope.downhill()); };
    const int half = steps_in(0.5);
    run(world, dt(), half);
    const double v0 = speed();
    run(world, dt(), 2 * half);
    EXPECT_NEAR((speed() - v0) / (2 * half * double(dt())) / 3.27, 1, 0.005);
    EXPECT_LT(std::fabs(world.body(id).position().z), 0.001) << "it rolls straight";
    const double height = glm::dot(world.body(id).position(), slope.normal());
    EXPECT_NEAR(height, 0.5, 0.002);
}

TEST_P(RoundThings, CylinderRollsOnForEver) {
    for (const bool is_capsule : {false, true}) {
        World world(without_sleep());
        add_ground(world, surface(0.5f));
        BodyDef def;
        def.position = {0, 0.5, 0};
        def.rotation = lying;
        def.linear_velocity = {4, 0, 0};
        def.angular_velocity = {0, 0, -8};
        const Shape shape = is_capsule ? Shape(Capsule{0.5f, 0.5f, {}}) : Shape(Cylinder{0.5f, 0.5f, {}});
        const BodyId id = add_body(world, shape, def, surface(0.5f));
        run(world, dt(), steps_in(10));
        EXPECT_NEAR(world.body(id).linear_velocity().x, 4, 0.04) << is_capsule;
        EXPECT_NEAR(world.body(id).position().z, 0, 0.01) << is_capsule;
        EXPECT_NEAR(world.body(id).position().y, 0.5, 0.001) << is_capsule;
    }
}

// A wall that is thinner than what stands beside it, at a slant to the axes of its mesh: the far side is within the
// bounds of the body, and the body behind it.
TEST(Shapes, NothingIsPulledThroughThinWalls) {
    const float c = std::sqrt(0.5f);
    std::vector<Vec3> corners;
    for (const float across : {-0.1f, 0.0f})
        for (const float y : {0.0f, 3.0f})
            for (const float along : {-2.0f, 2.0f}) corners.push_back({c * (across + along), y, c * (along - across)});
    const std::vector<std::uint32_t> triangles = {0, 1, 3, 0, 3, 2, 4, 6, 7, 4, 7, 5, 0, 4, 5, 0, 5, 1,
                                                  2, 3, 7, 2, 7, 6, 0, 2, 6, 0, 6, 4, 1, 5, 7, 1, 7, 3};
    const Shape shapes[] = {Box{{0.25f, 0.25f, 0.25f}}, Sphere{0.25f}, Cylinder{0.25f, 0.25f}, Capsule{0.1f, 0.15f}};
    for (const Shape& shape : shapes)
        for (const double distance : {0.361, 0.46, 0.6}) {
            World world;
            add_ground(world);
            BodyDef wall;
            wall.type = BodyType::static_;
            add_body(world, Mesh(corners, triangles), wall);
            BodyDef def;
            def.position = {double(c) * distance, 0.25, -double(c) * distance};
            const BodyId body = add_body(world, shape, def);
            run(world, 1.0f / 60.0f, 60);
            EXPECT_LT(glm::distance(world.body(body).position(), def.position), 0.002)
                << shape.index() << " " << distance;
        }
}

} // namespace
} // namespace cairn_test
