// Every shape at rest on every other, and rolling round shapes (row 8 of docs/validation.md).
#include "support.h"

#include <array>
#include <limits>

namespace cairn_test {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

struct NamedShape {
    const char* name;
    Shape shape;
    double half_height; // m, from the origin down to the lowest point, with the rotation `rotation`
    Quat rotation{1, 0, 0, 0};
};

const Quat lying = glm::angleAxis(float(pi / 2), Vec3(1, 0, 0));

Hull octagonal_prism(float radius, float half_height, float rounding = 0) {
    std::vector<Vec3> points;
    for (const float y : {-half_height, half_height})
        for (int i = 0; i < 8; ++i)
            points.emplace_back(radius * std::cos(float(pi) * float(i) / 4), y,
                                radius * std::sin(float(pi) * float(i) / 4));
    Hull hull(points);
    hull.rounding = rounding;
    return hull;
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
            {"hull", octagonal_prism(0.5f, 0.4f), 0.4},
            {"rounded box", Box{{0.35f, 0.25f, 0.35f}, 0.15f}, 0.4},
            {"rounded cylinder on end", Cylinder{0.3f, 0.4f, {}, 0.1f}, 0.4},
            {"rounded cylinder lying", Cylinder{0.4f, 0.3f, {}, 0.1f}, 0.4, lying},
            {"rounded cone", Cylinder{0.3f, 0.4f, 0.0f, 0.1f}, 0.4},
            {"rounded hull", octagonal_prism(0.4f, 0.35f, 0.05f), 0.4}};
}

// Wide shapes as ground, with their upper side at y = 0.
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
            {"rounded box", Box{{6, 0.5f, 6}, 0.5f}, 1},
            {"rounded cylinder", Cylinder{0.5f, 6.0f, {}, 0.5f}, 1},
            {"rounded hull", octagonal_prism(6, 0.5f, 0.5f), 1},
            {"sheet", Plane{{0, 1, 0}, {1, 0, 0}, {}, true}, 0},
            {"sheet from behind", Plane{{0, -1, 0}, {1, 0, 0}, {}, true}, 0},
            {"rectangular sheet", Plane{{0, -1, 0}, {1, 0, 0}, glm::vec2(6, 6), true}, 0},
            {"strip", Plane{{0, 1, 0}, {1, 0, 0}, glm::vec2(infinity, 2)}, 0},
            {"mesh", Mesh(square, triangles), 0},
            {"height field", HeightField(7, 7, {2, 2}, std::vector<float>(49, 0.0f)), 0}};
}

// A shape dropped from about 10 cm comes to rest on the ground, in its original orientation, and penetrates by less
// than 2 mm.
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

// Two dynamic bodies of any two shapes: the lower one stops the upper one.
TEST(Shapes, EveryShapeCarriesEveryOther) {
    for (const NamedShape& lower : movers()) {
        for (const NamedShape& upper : movers()) {
            if (std::string(lower.name).find("cone") != std::string::npos) continue; // nothing rests on a tip
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
            // Restitution is 0: the bodies move on together or have deflected each other, but neither has passed
            // through the other.
            EXPECT_LT(world.body(a).linear_velocity().y, -0.05f) << what;
            EXPECT_GT(world.body(b).position().y, world.body(a).position().y + 0.3) << what;
            EXPECT_LT(deepest_overlap(world), 0.01) << what;
        }
    }
}

// A rounded box is supported at the four corners of the lower face of its sharp core.
TEST(Shapes, ARoundedBoxLiesOnFourPoints) {
    for (const NamedShape& ground : grounds()) {
        if (std::string(ground.name).find("sphere") != std::string::npos || ground.rotation != Quat(1, 0, 0, 0))
            continue;
        World world;
        BodyDef def;
        def.type = BodyType::static_;
        def.position = {0, -ground.half_height, 0};
        add_body(world, ground.shape, def, surface(0.5f));
        def.type = BodyType::dynamic;
        def.position = {0.05, 0.4, 0.03};
        add_body(world, Box{{0.35f, 0.25f, 0.35f}, 0.15f}, def, surface(0.5f));
        run(world, 1.0f / 60.0f, 60);
        ASSERT_EQ(world.contacts().size(), 1u) << ground.name;
        const Contact contact = world.contacts()[0];
        // Where an edge between triangles passes near a corner, its contact point may replace that of the corner.
        const double slack = std::string(ground.name) == "mesh" ? 0.03 : 2e-3;
        ASSERT_EQ(contact.point_count, 4) << ground.name;
        for (int i = 0; i < 4; ++i) {
            EXPECT_NEAR(std::fabs(contact.points[i].point.x - 0.05), 0.35, slack) << ground.name;
            EXPECT_NEAR(std::fabs(contact.points[i].point.z - 0.03), 0.35, slack) << ground.name;
        }
    }
}

// A box with round edges rolls on them when it is tilted. Without losses it would swing back to where it was released.
TEST(Shapes, ARoundedBoxRocksOnItsRoundEdges) {
    World world(without_sleep());
    add_ground(world, surface(1.0f));
    BodyDef def;
    const float tilt = 0.3f;
    def.rotation = glm::angleAxis(tilt, Vec3(0, 0, 1));
    // The center of the lower edge of the core is 0.5 m above the ground.
    const double s = std::sin(double(tilt)), c = std::cos(double(tilt));
    def.position = {0, 0.5 + 0.5 * c - 0.5 * s, 0};
    const BodyId id = add_body(world, Box{{0.5f, 0.5f, 0.5f}, 0.5f}, def, surface(1.0f));
    // The center of mass is 1 m above the ground, and the edge rounds about lines 0.5 m beside the center: the box
    // falls back.
    run(world, 1.0f / 60.0f, 600);
    const Vec3 up = world.body(id).rotation() * Vec3(0, 1, 0);
    EXPECT_GT(up.y, 0.999f);
    EXPECT_NEAR(world.body(id).position().y, 1.0, 2e-3);
    EXPECT_LT(deepest_overlap(world), 2e-3);
}

class RoundThings : public EveryStep {};
CAIRN_AT_EVERY_STEP(RoundThings);

// Row 8: a = g sin(slope) / (1 + 1/2).
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

// k^2 = I / m of the rounded cylinder follows from its mass properties.
TEST_P(RoundThings, RoundedCylinderRollsDownASlopeAsItsMomentSays) {
    const Slope slope{radians(30)};
    World world;
    slope.add_to(world, surface(0.8f));
    BodyDef def;
    def.position = 0.5 * slope.normal();
    def.rotation = lying;
    const BodyId id = add_body(world, Cylinder{0.5f, 0.3f, {}, 0.2f}, def, surface(0.8f));
    const MassProperties mass = world.body(id).mass_properties();
    const glm::vec3 axis = glm::inverse(mass.inertia_orientation) * Vec3(0, 1, 0);
    double moment = 0;
    for (int i = 0; i < 3; ++i) moment += double(axis[i] * axis[i] * mass.inertia_diagonal[i]);
    const double expected = gravity * std::sin(slope.angle) / (1 + moment / (double(mass.mass) * 0.25));
    const auto speed = [&] { return glm::dot(glm::dvec3(world.body(id).linear_velocity()), slope.downhill()); };
    const int half = steps_in(0.5);
    run(world, dt(), half);
    const double v0 = speed();
    run(world, dt(), 2 * half);
    EXPECT_NEAR((speed() - v0) / (2 * half * double(dt())) / expected, 1, 0.005);
    EXPECT_LT(std::fabs(world.body(id).position().z), 0.001) << "it rolls straight";
}

TEST_P(RoundThings, CylinderRollsOnForEver) {
    const Shape shapes[] = {Capsule{0.5f, 0.5f, {}}, Cylinder{0.5f, 0.5f, {}}, Cylinder{0.4f, 0.4f, {}, 0.1f}};
    for (const Shape& shape : shapes) {
        World world(without_sleep());
        add_ground(world, surface(0.5f));
        BodyDef def;
        def.position = {0, 0.5, 0};
        def.rotation = lying;
        def.linear_velocity = {4, 0, 0};
        def.angular_velocity = {0, 0, -8};
        const BodyId id = add_body(world, shape, def, surface(0.5f));
        run(world, dt(), steps_in(10));
        const char* name = shape.index() == 3                       ? "capsule"
                           : std::get<Cylinder>(shape).rounding > 0 ? "rounded"
                                                                    : "sharp";
        EXPECT_NEAR(world.body(id).linear_velocity().x, 4, 0.04) << name;
        EXPECT_NEAR(world.body(id).position().z, 0, 0.01) << name;
        EXPECT_NEAR(world.body(id).position().y, 0.5, 0.001) << name;
    }
}

// A wall thinner than the body beside it, slanted relative to the axes of its mesh: the far side of the wall lies
// within the bounds of the body, and the body is behind that side.
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

// The center of the bounds of a flat tetrahedron may be outside of it. When that center was used as an interior point,
// it was below the ground, and such tetrahedra fell through.
TEST(Tetrahedra, RestOnAMeshOnTheirFlatSides) {
    const std::vector<Vec3> flat[] = {
        {{0.263f, -0.251f, 0.280f}, {-0.247f, 0.132f, 0.179f}, {-0.218f, 0.137f, 0.234f}, {0.285f, -0.035f, -0.265f}},
        {{-0.186f, -0.179f, 0.204f}, {-0.278f, 0.146f, -0.219f}, {-0.153f, -0.046f, 0.052f}, {0.258f, -0.003f, 0.218f}},
        {{0.072f, 0.215f, 0.164f}, {-0.219f, 0.076f, -0.279f}, {-0.026f, 0.278f, -0.030f}, {-0.236f, -0.206f, 0.086f}},
        {{0.068f, 0.296f, 0.270f}, {0.094f, 0.019f, -0.282f}, {-0.273f, 0.107f, 0.280f}, {0.278f, 0.089f, -0.294f}},
        {{0.194f, 0.278f, 0.200f}, {-0.204f, -0.253f, 0.147f}, {-0.013f, 0.040f, 0.057f}, {-0.184f, 0.024f, -0.195f}},
    };
    const std::vector<Vec3> corners = {{-3, 0, -3}, {3, 0, -3}, {3, 0, 3}, {-3, 0, 3}};
    const std::vector<std::uint32_t> triangles = {0, 2, 1, 0, 3, 2};
    for (const std::vector<Vec3>& points : flat) {
        World world;
        BodyDef ground;
        ground.type = BodyType::static_;
        world.add_shape(world.create_body(ground), Mesh(corners, triangles));
        BodyDef def;
        def.position = {0, 0.5, 0};
        const BodyId body = world.create_body(def);
        world.add_shape(body, Hull(points));
        for (int i = 0; i < 240; ++i) world.step(1.0f / 60);
        EXPECT_GT(world.body(body).center_of_mass().y, 0) << points[0].x;
    }
}

} // namespace
} // namespace cairn_test
