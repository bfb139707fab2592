// Bodies: their types, their mass properties, and the state that can be read of them.
#include "test_world.h"

#include <algorithm>
#include <array>
#include <vector>

namespace cairn::test {
namespace {

// Principal moments in ascending order.
std::array<float, 3> sorted_moments(const MassProperties& properties) {
    const Vec3 d = properties.inertia_diagonal;
    std::array<float, 3> moments{d.x, d.y, d.z};
    std::sort(moments.begin(), moments.end());
    return moments;
}

void expect_tensor(const Mat3& tensor, const Mat3& expected, float tolerance) {
    for (int c = 0; c < 3; ++c)
        for (int r = 0; r < 3; ++r) EXPECT_NEAR(tensor[c][r], expected[c][r], tolerance) << "entry " << r << " " << c;
}

// --- mass

TEST(Mass, SphereAndBoxHaveTheClosedForms) {
    World world;
    const Body ball = world.body(add_body(world, {}, Sphere{0.7f}, with_density(800.0f)));
    const double m = 800 * 4.0 / 3 * pi * 0.7 * 0.7 * 0.7;
    EXPECT_NEAR(ball.mass(), m, 1e-5 * m);
    for (const float moment : sorted_moments(ball.mass_properties())) EXPECT_NEAR(moment, 0.4 * m * 0.49, 1e-5 * m);

    const Body box = world.body(add_body(world, {}, Box{{1.0f, 2.0f, 3.0f}}, with_density(10.0f)));
    EXPECT_NEAR(box.mass(), 480.0f, 1e-3f);
    // m / 3 (b^2 + c^2) for half extents.
    expect_tensor(box.world_inertia(), Mat3(160.0f * 13, 0, 0, 0, 160.0f * 10, 0, 0, 0, 160.0f * 5), 0.05f);
}

TEST(Mass, CompoundFollowsTheParallelAxisTheorem) {
    World world;
    const BodyId id = world.create_body(body_at({10.0, 20.0, 30.0}));
    world.add_shape(id, Box{{0.5f, 0.5f, 0.5f}}, shape_at({1.0f, 0.0f, 0.0f}));  // 1000 kg
    world.add_shape(id, Box{{0.5f, 0.5f, 0.5f}}, shape_at({-2.0f, 0.0f, 0.0f})); // 1000 kg
    ShapeDef heavy = shape_at({0.0f, 3.0f, 0.0f});
    heavy.density = 2000.0f;
    world.add_shape(id, Box{{0.5f, 0.5f, 0.5f}}, heavy); // 2000 kg
    const Body body = world.body(id);
    EXPECT_NEAR(body.mass(), 4000.0f, 0.01f);
    const Vec3 center(-0.25f, 1.5f, 0.0f);
    const MassProperties properties = body.mass_properties();
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(properties.center_of_mass[i], center[i], 1e-5f);
    for (int i = 0; i < 3; ++i)
        EXPECT_NEAR(body.center_of_mass()[i], Position(10.0, 20.0, 30.0)[i] + double(center[i]), 1e-5);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(body.position()[i], 10.0 * (i + 1), 1e-5) << "the origin stays";
    Mat3 expected(0.0f);
    const auto add_part = [&](float mass, const Vec3& at) {
        const Vec3 d = at - center;
        expected += mass * (Mat3(1.0f / 6.0f) + glm::dot(d, d) * Mat3(1.0f) - glm::outerProduct(d, d));
    };
    add_part(1000.0f, {1.0f, 0.0f, 0.0f});
    add_part(1000.0f, {-2.0f, 0.0f, 0.0f});
    add_part(2000.0f, {0.0f, 3.0f, 0.0f});
    expect_tensor(body.world_inertia(), expected, 0.2f);
}

TEST(Mass, TurnedShapeAndTurnedBodyTurnTheTensor) {
    World world;
    const Quat quarter = glm::angleAxis(float(pi / 2), Vec3(0.0f, 0.0f, 1.0f));
    ShapeDef turned;
    turned.rotation = quarter;
    const Body by_shape = world.body(add_body(world, {}, Box{{1.0f, 2.0f, 3.0f}}, turned));
    BodyDef def;
    def.rotation = quarter;
    const Body by_body = world.body(add_body(world, def, Box{{1.0f, 2.0f, 3.0f}}));
    const Body plain = world.body(add_body(world, {}, Box{{2.0f, 1.0f, 3.0f}}));
    expect_tensor(by_shape.world_inertia(), plain.world_inertia(), 1.0f);
    expect_tensor(by_body.world_inertia(), plain.world_inertia(), 1.0f);
}

TEST(Mass, GivenMassScalesTheShapesInertia) {
    World world;
    BodyDef def;
    def.mass = 6.0f;
    const BodyId id = add_body(world, def, Box{});
    Body body = world.body(id);
    EXPECT_NEAR(body.mass(), 6.0f, 1e-5f);
    EXPECT_NEAR(body.mass_properties().inertia_diagonal.x, 1.0f, 1e-5f);
    world.add_shape(id, Box{}, shape_at({1.0f, 0.0f, 0.0f}));
    EXPECT_NEAR(body.mass(), 6.0f, 1e-5f) << "a given mass stays when shapes are added";
    EXPECT_NEAR(body.mass_properties().center_of_mass.x, 0.5f, 1e-5f);
    body.set_mass_from_shapes();
    EXPECT_NEAR(body.mass(), 2000.0f, 1e-2f);
    body.set_mass_from_shapes(12.0f);
    EXPECT_NEAR(body.mass(), 12.0f, 1e-5f);
    world.remove_shape(body.shapes()[1]);
    EXPECT_NEAR(body.mass(), 12.0f, 1e-5f);
    EXPECT_NEAR(body.mass_properties().center_of_mass.x, 0.0f, 1e-6f);
    EXPECT_NEAR(body.mass_properties().inertia_diagonal.x, 2.0f, 1e-5f);
}

TEST(Mass, GivenPropertiesOverrideShapes) {
    World world;
    MassProperties given;
    given.mass = 3.0f;
    given.center_of_mass = {0.1f, 0.2f, 0.3f};
    given.inertia_diagonal = {1.0f, 2.0f, 2.5f};
    given.inertia_orientation = glm::angleAxis(0.5f, glm::normalize(Vec3(1.0f, 2.0f, 3.0f)));
    BodyDef def;
    def.mass_properties = given;
    for (const bool at_creation : {true, false}) {
        Body body = world.body(add_body(world, at_creation ? def : BodyDef{}, Box{}));
        if (!at_creation) body.set_mass_properties(given);
        world.add_shape(body.id(), Sphere{});
        EXPECT_EQ(body.mass(), 3.0f);
        EXPECT_EQ(body.mass_properties().center_of_mass, given.center_of_mass);
        EXPECT_EQ(body.mass_properties().inertia_diagonal, given.inertia_diagonal);
        const Mat3 axes(given.inertia_orientation);
        expect_tensor(body.world_inertia(), axes * Mat3(1, 0, 0, 0, 2, 0, 0, 0, 2.5f) * glm::transpose(axes), 1e-5f);
    }
}

TEST(Mass, MovedCenterKeepsTheOriginAndTheMotionOfTheMaterial) {
    World world(weightless());
    BodyDef def;
    def.linear_velocity = {1.0f, 0.0f, 0.0f};
    def.angular_velocity = {0.0f, 0.0f, 2.0f};
    Body body = world.body(add_body(world, def, Box{}));
    const Vec3 before = body.velocity_at({0.3, 0.4, 0.5});
    world.add_shape(body.id(), Box{}, shape_at({0.0f, 1.0f, 0.0f}));
    EXPECT_NEAR(body.center_of_mass().y, 0.5, 1e-6);
    EXPECT_NEAR(glm::length(body.position()), 0.0, 1e-6);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(body.velocity_at({0.3, 0.4, 0.5})[i], before[i], 1e-6f);
}

// --- types

TEST(Types, StaticAndKinematicBodiesHaveInfiniteMassAndNoEnergy) {
    World world;
    for (const BodyType type : {BodyType::static_, BodyType::kinematic}) {
        BodyDef def = body_at({0.0, 0.0, 0.0}, type);
        def.linear_velocity = {1.0f, 2.0f, 3.0f};
        const BodyId id = add_body(world, def, Box{});
        const Body body = world.body(id);
        EXPECT_EQ(body.type(), type);
        EXPECT_EQ(body.mass(), infinity);
        EXPECT_EQ(body.kinetic_energy(), 0.0);
        EXPECT_EQ(body.linear_velocity(), type == BodyType::static_ ? Vec3(0.0f) : def.linear_velocity);
        world.destroy_body(id);
    }
    EXPECT_EQ(world.kinetic_energy(), 0.0);
    EXPECT_EQ(world.linear_momentum(), glm::dvec3(0.0));
}

TEST(Types, KinematicBodyMovesWithItsVelocityWhateverIsInItsWay) {
    World world;
    add_ground(world);
    BodyDef def = body_at({-3.0, 0.6, 0.0}, BodyType::kinematic);
    def.linear_velocity = {2.0f, 0.0f, 0.0f};
    def.angular_velocity = {0.0f, 1.0f, 0.0f};
    const BodyId pusher = add_body(world, def, Box{});
    const BodyId crate = add_crate(world, {0.0, 0.5, 0.0});
    run(world, 120);
    EXPECT_NEAR(world.body(pusher).position().x, 1.0, 1e-4);
    EXPECT_NEAR(world.body(pusher).position().y, 0.6, 1e-6);
    const Quat q = world.body(pusher).rotation();
    EXPECT_NEAR(std::fabs(q.w), std::cos(1.0), 1e-4);
    EXPECT_NEAR(std::fabs(q.y), std::sin(1.0), 1e-4);
    EXPECT_GT(world.body(crate).position().x, 1.5) << "it pushes what is dynamic";
}

TEST(Types, MoveToArrivesInTheGivenTime) {
    World world;
    Body platform =
        world.body(add_body(world, body_at({1.0, 2.0, 3.0}, BodyType::kinematic), Box{}, shape_at({0.5f, 0.0f, 0.0f})));
    for (const int steps : {1, 30}) {
        for (const float angle : {0.0f, 0.001f, 1.0f, 3.0f}) {
            const Transform target{{4.0, -1.0, 2.0}, glm::angleAxis(angle, glm::normalize(Vec3(1.0f, -2.0f, 0.5f)))};
            platform.set_transform({1.0, 2.0, 3.0}, Quat(1, 0, 0, 0));
            platform.move_to(target, steps * frame);
            run(world, steps);
            for (int i = 0; i < 3; ++i)
                EXPECT_NEAR(platform.position()[i], target.position[i], 1e-3) << "angle " << angle << " in " << steps;
            EXPECT_NEAR(std::fabs(glm::dot(platform.rotation(), target.rotation)), 1.0f, 1e-5f)
                << "angle " << angle << " in " << steps;
        }
    }
}

// Without the fix the body rotated about the center of its shapes and drifted away: whenever a shape was added, the new
// center of mass took over the velocity of the material there.
TEST(Types, KinematicBodyTurnsAboutItsOrigin) {
    World world;
    BodyDef def = body_at({1.0, 2.0, 3.0}, BodyType::kinematic);
    def.angular_velocity = {0.0f, 0.0f, 3.0f};
    Body cam = world.body(add_body(world, def, Box{}, shape_at({0.5f, 0.2f, 0.0f})));
    world.add_shape(cam.id(), Sphere{}, shape_at({2.0f, 0.0f, 0.0f}));
    run(world, 100);
    EXPECT_EQ(cam.position(), Position(1.0, 2.0, 3.0));
    EXPECT_EQ(cam.center_of_mass(), Position(1.0, 2.0, 3.0));
    EXPECT_EQ(cam.linear_velocity(), Vec3(0.0f));
    // A body made dynamic rotates about its center of mass; the velocity of its material stays as it is.
    const Vec3 before = cam.velocity_at({2.0, 2.0, 3.0});
    cam.set_type(BodyType::dynamic);
    EXPECT_NEAR(glm::length(cam.velocity_at({2.0, 2.0, 3.0}) - before), 0.0f, 1e-5f);
    EXPECT_GT(glm::length(cam.center_of_mass() - Position(1.0, 2.0, 3.0)), 1.0);
    // A center of mass that is given in the definition is kept.
    def.mass_properties = MassProperties{};
    def.mass_properties->center_of_mass = {1.0f, 0.0f, 0.0f};
    const Body given = world.body(add_body(world, def, Box{}));
    EXPECT_EQ(given.center_of_mass(), Position(2.0, 2.0, 3.0));
}

TEST(Types, MovingPlatformCarriesABox) {
    World world;
    Body platform = world.body(add_body(world, body_at({0.0, 1.0, 0.0}, BodyType::kinematic), Box{{3.0f, 0.2f, 3.0f}}));
    const Body crate = world.body(add_crate(world, {0.0, 1.7, 0.0}));
    run(world, 30);
    // The platform accelerates gently for one second, then moves on for two seconds, up and sideways.
    for (int i = 0; i < 180; ++i) {
        const float share = std::min(float(i) / 60.0f, 1.0f);
        platform.set_linear_velocity({2.0f * share, 0.5f * share, 0.0f});
        world.step(frame);
    }
    const Position apart = crate.position() - platform.position();
    EXPECT_NEAR(apart.x, 0.0, 0.05);
    EXPECT_NEAR(apart.y, 0.7, 0.02);
    EXPECT_NEAR(crate.linear_velocity().x, 2.0f, 0.02f);
    EXPECT_GT(platform.position().x, 4.5);
}

TEST(Types, ChangedTypeTakesEffect) {
    World world;
    add_ground(world);
    const BodyId id = add_crate(world, {0.0, 5.0, 0.0});
    Body body = world.body(id);
    body.set_type(BodyType::static_);
    run(world, 30);
    EXPECT_EQ(body.position(), Position(0.0, 5.0, 0.0));
    EXPECT_EQ(body.mass(), infinity);
    EXPECT_EQ(world.statistics().dynamic_bodies, 0u);
    body.set_type(BodyType::kinematic);
    body.set_linear_velocity({1.0f, 0.0f, 0.0f});
    run(world, 60);
    EXPECT_NEAR(body.position().x, 1.0, 1e-5);
    body.set_type(BodyType::dynamic);
    EXPECT_NEAR(body.mass(), 1000.0f, 0.01f);
    run(world, 240);
    EXPECT_NEAR(body.position().y, 0.5, 0.01) << "it falls and rests";
    EXPECT_EQ(world.statistics().dynamic_bodies, 1u);
}

TEST(Types, StaticGroundThatBecomesDynamicFallsWithWhatItCarried) {
    World world;
    const BodyId shelf = add_body(world, body_at({0.0, 5.0, 0.0}, BodyType::static_), Box{{2.0f, 0.1f, 2.0f}});
    const BodyId crate = add_crate(world, {0.0, 5.6, 0.0});
    run(world, 120);
    EXPECT_FALSE(world.body(crate).is_awake());
    world.body(shelf).set_type(BodyType::dynamic);
    run(world, 60);
    EXPECT_LT(world.body(shelf).position().y, 1.0);
    EXPECT_LT(world.body(crate).position().y, 2.0);
}

// --- the rest

TEST(Bodies, KeepNamesAndUserData) {
    World world;
    BodyDef def;
    def.name = "first";
    def.user_data = 42;
    const BodyId first = world.create_body(def), second = world.create_body(def);
    EXPECT_EQ(world.find_body("first"), first) << "the first of that name";
    EXPECT_FALSE(world.find_body("other"));
    world.body(first).set_name("other");
    EXPECT_EQ(world.find_body("first"), second);
    EXPECT_EQ(world.find_body("other"), first);
    EXPECT_EQ(world.body(second).user_data(), 42u);
    world.destroy_body(second);
    EXPECT_FALSE(world.find_body("first"));
}

TEST(Bodies, VelocityAtAPointIncludesTheRotation) {
    World world(weightless());
    BodyDef def = body_at({1.0, 0.0, 0.0});
    def.linear_velocity = {0.0f, 1.0f, 0.0f};
    def.angular_velocity = {0.0f, 0.0f, 3.0f};
    const Body body = world.body(add_body(world, def, Sphere{}));
    EXPECT_NEAR(body.velocity_at({3.0, 0.0, 0.0}).y, 7.0f, 1e-6f);
    EXPECT_NEAR(body.velocity_at({1.0, 2.0, 0.0}).x, -6.0f, 1e-6f);
    const double m = body.mass();
    EXPECT_NEAR(body.kinetic_energy(), 0.5 * m + 0.5 * 0.4 * m * 0.25 * 9, 1e-3);
    EXPECT_NEAR(body.angular_momentum().z, 0.4 * m * 0.25 * 3, 1e-3);
}

TEST(Bodies, ReadTransformsGivesWhatTheAccessorsGive) {
    World world;
    add_ground(world);
    for (int i = 0; i < 10; ++i) add_crate(world, {1.5 * i, 2.0, 0.0});
    run(world, 20);
    const auto ids = world.bodies();
    std::vector<Transform> out(ids.size());
    world.read_transforms(ids, out);
    for (std::size_t i = 0; i < ids.size(); ++i) {
        EXPECT_EQ(out[i].position, world.body(ids[i]).position());
        EXPECT_EQ(out[i].rotation, world.body(ids[i]).rotation());
    }
}

TEST(Bodies, TeleportKeepsVelocityAndFindsContactsAnew) {
    World world;
    add_ground(world);
    const BodyId id = add_crate(world, {0.0, 0.5, 0.0});
    run(world, 20);
    Body body = world.body(id);
    body.set_linear_velocity({1.0f, 0.0f, 0.0f});
    body.set_transform({100.0, 50.0, 0.0}, glm::angleAxis(0.3f, Vec3(0.0f, 1.0f, 0.0f)));
    EXPECT_EQ(body.linear_velocity(), Vec3(1.0f, 0.0f, 0.0f));
    EXPECT_EQ(body.position(), Position(100.0, 50.0, 0.0));
    EXPECT_NEAR(body.rotation().y, std::sin(0.15f), 1e-6f);
    world.step(frame);
    EXPECT_EQ(world.contact_ends().size(), 1u);
    EXPECT_TRUE(world.contacts().empty());
}

TEST(Bodies, SettingThePlaceWhereABodyAlreadyIsChangesNothing) {
    World world(weightless());
    BodyDef def = body_at({0.1, 0.2, 0.3});
    def.angular_velocity = {1.0f, 2.0f, 3.0f};
    const BodyId id = add_body(world, def, Box{{0.1f, 0.2f, 0.3f}}, shape_at({0.3f, 0.2f, 0.1f}));
    run(world, 37);
    Body body = world.body(id);
    const Position center = body.center_of_mass();
    body.set_position(body.position());
    EXPECT_LT(glm::length(body.center_of_mass() - center), 1e-12)
        << "rotation must not be rounded by a change of position";
}

TEST(Shapes, AreReadAsTheyWereGiven) {
    World world;
    const BodyId body = world.create_body(body_at({1.0, 0.0, 0.0}));
    ShapeDef def = shape_at({0.0f, 2.0f, 0.0f});
    def.user_data = 9;
    def.material.restitution = 0.25f;
    const ShapeId ball = world.add_shape(body, Sphere{0.3f}, def), box = world.add_shape(body, Box{{1.0f, 2.0f, 3.0f}});
    EXPECT_EQ(world.body(body).shapes(), (std::vector<ShapeId>{ball, box}));
    EXPECT_EQ(world.body_of(ball), body);
    EXPECT_EQ(std::get<Sphere>(world.shape(ball)).radius, 0.3f);
    EXPECT_EQ(std::get<Box>(world.shape(box)).half_extents, Vec3(1.0f, 2.0f, 3.0f));
    EXPECT_EQ(world.shape_def(ball).user_data, 9u);
    EXPECT_EQ(world.shape_def(ball).material.restitution, 0.25f);
    EXPECT_NEAR(world.shape_transform(ball).position.x, 1.0, 1e-6);
    EXPECT_NEAR(world.shape_transform(ball).position.y, 2.0, 1e-6);
    Material other;
    other.restitution = 0.5f;
    world.set_material(ball, other);
    EXPECT_EQ(world.shape_def(ball).material.restitution, 0.5f);
    world.remove_shape(ball);
    EXPECT_EQ(world.body(body).shapes(), std::vector<ShapeId>{box});
}

} // namespace
} // namespace cairn::test
