// Joints in files: every type with every property survives saving and loading, and a second save gives the same text.
#include "joint_text.h"

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

namespace {

using namespace cairn;
using namespace cairn::scene_test;
using scene::Scene;

constexpr float infinite = std::numeric_limits<float>::infinity();

bool same(const JointSpring& a, const JointSpring& b) {
    return a.stiffness == b.stiffness && a.damping == b.damping && a.is_acceleration == b.is_acceleration;
}
bool same(const JointRange& a, const JointRange& b);
bool same(const JointMotor& a, const JointMotor& b);
bool same(const JointControl& a, const JointControl& b);
bool same(float a, float b) { return a == b; }
template <class T> bool same(const std::optional<T>& a, const std::optional<T>& b) {
    return a.has_value() == b.has_value() && (!a || same(*a, *b));
}
bool same(const JointRange& a, const JointRange& b) {
    return a.lower == b.lower && a.upper == b.upper && same(a.spring, b.spring);
}
bool same(const JointMotor& a, const JointMotor& b) {
    return a.velocity == b.velocity && a.position == b.position && same(a.spring, b.spring) &&
           a.max_force == b.max_force;
}
bool same(const JointControl& a, const JointControl& b) {
    return same(a.limits, b.limits) && same(a.motor, b.motor) && a.friction == b.friction;
}
bool same(const FixedJoint&, const FixedJoint&) { return true; }
bool same(const BallJoint& a, const BallJoint& b) {
    return same(a.cone_angle, b.cone_angle) && same(a.twist, b.twist) && a.friction == b.friction;
}
bool same(const HingeJoint& a, const HingeJoint& b) { return same(a.angle, b.angle); }
bool same(const SliderJoint& a, const SliderJoint& b) { return same(a.translation, b.translation); }
bool same(const CylindricalJoint& a, const CylindricalJoint& b) {
    return same(a.translation, b.translation) && same(a.angle, b.angle);
}
bool same(const UniversalJoint& a, const UniversalJoint& b) {
    return same(a.first, b.first) && same(a.second, b.second);
}
bool same(const DistanceJoint& a, const DistanceJoint& b) { return same(a.distance, b.distance); }
bool same(const WheelJoint& a, const WheelJoint& b) {
    return same(a.suspension, b.suspension) && same(a.steering, b.steering) && same(a.spin, b.spin);
}
bool same(const ServoJoint& a, const ServoJoint& b) {
    return a.position == b.position && a.rotation == b.rotation && same(a.linear, b.linear) &&
           same(a.angular, b.angular) && a.max_force == b.max_force && a.max_torque == b.max_torque;
}
bool same(const GearJoint& a, const GearJoint& b) { return a.ratio == b.ratio; }
bool same(const RackJoint& a, const RackJoint& b) { return a.radius == b.radius; }
bool same(const PulleyJoint& a, const PulleyJoint& b) {
    return a.ground_a == b.ground_a && a.ground_b == b.ground_b && a.ratio == b.ratio && same(a.length, b.length);
}
bool same(const JointLimit& a, const JointLimit& b) {
    return a.kind == b.kind && a.axes == b.axes && same(a.min, b.min) && same(a.max, b.max) &&
           same(a.stiffness, b.stiffness) && a.damping == b.damping;
}
bool same(const JointDrive& a, const JointDrive& b) {
    return a.kind == b.kind && a.is_acceleration == b.is_acceleration && a.axis == b.axis &&
           same(a.max_force, b.max_force) && a.position_target == b.position_target &&
           a.velocity_target == b.velocity_target && a.stiffness == b.stiffness && a.damping == b.damping;
}
template <class T> bool same(const std::vector<T>& a, const std::vector<T>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const T& x, const T& y) { return same(x, y); });
}
bool same(const GeneralJoint& a, const GeneralJoint& b) { return same(a.limits, b.limits) && same(a.drives, b.drives); }
bool same(const Joint& a, const Joint& b) {
    return a.index() == b.index() &&
           std::visit([&](const auto& x) { return same(x, std::get<std::decay_t<decltype(x)>>(b)); }, a);
}

// Two balls, and a static body.
struct Balls {
    Scene scene{World(), {}, {}, {}, {}};
    BodyId left, right, still;
    Balls() {
        const auto add = [&](const char* name, Position at, BodyType type) {
            BodyDef def;
            def.name = name;
            def.position = at;
            def.type = type;
            const BodyId id = scene.world.create_body(def);
            scene.world.add_shape(id, Sphere{0.25f});
            return id;
        };
        left = add("left", {-1, 2, 0}, BodyType::dynamic);
        right = add("right", {1, 2, 0.5}, BodyType::dynamic);
        still = add("still", {0, 4, 0}, BodyType::static_);
    }
};

std::string name_of(const World& world, BodyId body) {
    return body.is_null() ? "the world" : std::string(world.body(body).name());
}

void expect_same_joint(const World& a, JointId id_a, const World& b, JointId id_b) {
    const JointDef &x = a.joint_def(id_a), &y = b.joint_def(id_b);
    SCOPED_TRACE(x.name);
    EXPECT_TRUE(same(x.joint, y.joint));
    EXPECT_EQ(name_of(a, x.body_a), name_of(b, y.body_a));
    EXPECT_EQ(name_of(a, x.body_b), name_of(b, y.body_b));
    EXPECT_EQ(x.frame_a.position, y.frame_a.position);
    EXPECT_EQ(x.frame_b.position, y.frame_b.position);
    for (int i = 0; i < 4; ++i) {
        EXPECT_NEAR(x.frame_a.rotation[i], y.frame_a.rotation[i], 2e-7);
        EXPECT_NEAR(x.frame_b.rotation[i], y.frame_b.rotation[i], 2e-7);
    }
    EXPECT_EQ(x.enable_collision, y.enable_collision);
    EXPECT_EQ(x.break_force, y.break_force);
    EXPECT_EQ(x.break_torque, y.break_torque);
    EXPECT_EQ(x.solver, y.solver);
    EXPECT_EQ(x.enabled, y.enabled);
    EXPECT_EQ(x.name, y.name);
}

// Checks that all joints are restored in their order, and that saving again gives the same text. Returns the text.
std::string expect_saved(const Scene& scene) {
    const std::string text = scene::save_to_string(scene);
    const Scene again = load_text(text);
    EXPECT_TRUE(scene::save_to_string(again) == text) << text << "\n" << scene::save_to_string(again);
    const std::vector<JointId> before = scene.world.joints(), after = again.world.joints();
    EXPECT_EQ(before.size(), after.size());
    if (before.size() != after.size()) return text;
    for (std::size_t i = 0; i < before.size(); ++i) expect_same_joint(scene.world, before[i], again.world, after[i]);
    EXPECT_TRUE(again.warnings.empty());
    return text;
}

const JointSpring soft{120.5f, 3.25f, false}, fast{900.0f, 60.0f, true};
const JointControl rich{JointRange{-0.5f, 0.75f, soft}, JointMotor{1.5f, 0.25f, fast, 40.0f}, 0.125f};
const JointControl spin{std::nullopt, JointMotor{-7.0f, 0.0f, std::nullopt, infinite}, 0.0f};
const JointControl half{JointRange{-infinite, 0.1f, std::nullopt}, std::nullopt, 2.0f};

std::vector<Joint> all_joints() {
    const JointLimit lock{JointAxis::linear, {true, true, true}, 0.0f, 0.0f, std::nullopt, 0.0f};
    const JointLimit cone{JointAxis::angular, {false, true, true}, std::nullopt, 0.7f, 50.0f, 2.0f};
    const JointLimit damped{JointAxis::angular, {true, false, false}, -1.0f, std::nullopt, std::nullopt, 4.0f};
    JointDrive turn;
    turn.kind = JointAxis::angular;
    turn.is_acceleration = true;
    turn.axis = 2;
    turn.max_force = 0.0f;
    turn.position_target = -0.4f;
    turn.stiffness = 8.0f;
    JointDrive push;
    push.axis = 1;
    push.velocity_target = 2.5f;
    push.damping = 0.3f;
    return {FixedJoint{},
            BallJoint{},
            BallJoint{0.6f, JointRange{-0.3f, 0.2f, soft}, 0.5f},
            HingeJoint{},
            HingeJoint{rich},
            HingeJoint{spin},
            HingeJoint{half},
            SliderJoint{rich},
            SliderJoint{JointControl{JointRange{0.0f, 0.0f, std::nullopt}, std::nullopt, 0.0f}},
            CylindricalJoint{rich, spin},
            UniversalJoint{half, rich},
            DistanceJoint{rich},
            DistanceJoint{},
            WheelJoint{rich, std::nullopt, spin},
            WheelJoint{rich, half, spin},
            WheelJoint{rich, JointControl{}, spin}, // free steering
            ServoJoint{},
            ServoJoint{{0.1f, 0.2f, -0.3f}, {0.8f, 0.6f, 0.0f, 0.0f}, soft, fast, 100.0f, 20.0f},
            GearJoint{-2.5f},
            RackJoint{0.35f},
            PulleyJoint{{-1.0, 5.0, 0.0}, {1.0, 5.0, 0.125}, 2.0f, 9.0f},
            GeneralJoint{},
            GeneralJoint{{lock, cone, damped}, {turn, push}}};
}

TEST(JointSave, EveryTypeKeepsEveryProperty) {
    for (const Joint& joint : all_joints()) {
        SCOPED_TRACE("type " + std::to_string(joint.index()));
        Balls balls;
        JointDef def;
        def.body_a = balls.left;
        def.body_b = balls.right;
        def.frame_a = {{0.5, 0.25, -0.125}, {0.8f, 0.0f, 0.6f, 0.0f}};
        def.frame_b = {{-0.5, 0.0, 1e-3}, {0.70710678f, 0.0f, 0.0f, 0.70710678f}};
        def.joint = joint;
        def.name = "joint \"" + std::to_string(joint.index()) + "\"";
        balls.scene.world.create_joint(def);
        def.enable_collision = true;
        def.break_force = 1234.5f;
        def.break_torque = 0.3f;
        def.solver = JointSolver::direct;
        def.name.clear();
        balls.scene.world.create_joint(def);
        def.solver = JointSolver::iterative;
        def.break_torque = infinite;
        def.enabled = false;
        balls.scene.world.create_joint(def);
        expect_saved(balls.scene);
    }
}

TEST(JointSave, KeepsTheOrderAndTheWorldOnEitherSide) {
    Balls balls;
    const auto join = [&](BodyId a, BodyId b, const char* name) {
        JointDef def = balls.scene.world.joint_at(a, b, {0.3, 2.5, 0.1}, {1.0f, 2.0f, -0.5f}, HingeJoint{});
        def.name = name;
        return balls.scene.world.create_joint(def);
    };
    join(balls.right, {}, "1");
    join({}, balls.left, "2");
    const JointId gone = join(balls.left, balls.still, "3");
    join(balls.still, balls.right, "4");
    join(balls.left, balls.right, "5");
    join(balls.right, balls.left, "6");
    balls.scene.world.destroy_joint(gone);
    expect_saved(balls.scene);
    const Scene again = load_text(scene::save_to_string(balls.scene));
    EXPECT_TRUE(again.world.joint_def(*again.world.find_joint("1")).body_b.is_null());
    EXPECT_TRUE(again.world.joint_def(*again.world.find_joint("2")).body_a.is_null());
    const JointDef& fourth = again.world.joint_def(*again.world.find_joint("4"));
    EXPECT_EQ(fourth.body_a, again.world.find_body("still")); // the static body itself, not only its position
    EXPECT_EQ(again.world.body(fourth.body_a).type(), BodyType::static_);
}

TEST(JointSave, WhatIsLoadedAgainMovesTheSame) {
    Balls balls;
    for (const Joint& joint : {Joint{HingeJoint{rich}}, Joint{BallJoint{0.5f, std::nullopt, 0.1f}}}) {
        balls.scene.world.create_joint(
            balls.scene.world.joint_at(balls.left, balls.still, {0, 4, 0}, {0.0f, 0.0f, 1.0f}, joint));
    }
    balls.scene.world.create_joint(
        balls.scene.world.joint_at(balls.left, balls.right, {0, 2, 0}, {1.0f, 1.0f, 1.0f}, UniversalJoint{}));
    Scene first = load_text(scene::save_to_string(balls.scene));
    Scene second = load_text(scene::save_to_string(first));
    const std::uint64_t start = first.world.state_hash();
    for (int i = 0; i < 120; ++i) {
        first.world.step(1.0f / 60.0f);
        second.world.step(1.0f / 60.0f);
    }
    EXPECT_NE(first.world.state_hash(), start);
    EXPECT_EQ(first.world.state_hash(), second.world.state_hash());
}

TEST(JointSave, APulleyKeepsTheLengthThatItWasMadeWith) {
    Balls balls;
    JointDef def;
    def.body_a = balls.left;
    def.body_b = balls.right;
    def.joint = PulleyJoint{{-1.0, 5.0, 0.0}, {1.0, 5.0, 0.5}, 2.0f, std::nullopt};
    const JointId id = balls.scene.world.create_joint(def);
    const std::optional<float> length = std::get<PulleyJoint>(balls.scene.world.joint_def(id).joint).length;
    ASSERT_TRUE(length.has_value());
    EXPECT_NEAR(*length, 3.0 + 2.0 * 3.0, 1e-6);
    for (int i = 0; i < 30; ++i) balls.scene.world.step(1.0f / 60.0f);
    const Scene again = load_text(scene::save_to_string(balls.scene));
    EXPECT_EQ(std::get<PulleyJoint>(again.world.joint_def(again.world.joints().at(0)).joint).length, length);
}

TEST(JointSave, OtherProgramsSeeWhatTheDraftCanSay) {
    Balls balls;
    JointDef def;
    def.body_a = balls.left;
    def.body_b = balls.right;
    def.joint = HingeJoint{rich};
    def.break_force = 5.0f;
    balls.scene.world.create_joint(def);
    def.joint = GeneralJoint{};
    def.break_force = infinite;
    balls.scene.world.create_joint(def);
    const auto json = nlohmann::json::parse(scene::save_to_string(balls.scene));
    const auto& joints = json.at("extensions").at("KHR_physics_rigid_bodies").at("physicsJoints");
    const auto& hinge = joints.at(0);
    EXPECT_EQ(hinge.at("limits").at(0), nlohmann::json::parse(R"({"linearAxes":[0,1,2],"min":0.0,"max":0.0})"));
    EXPECT_EQ(hinge.at("limits").at(1), nlohmann::json::parse(R"({"angularAxes":[1,2],"min":0.0,"max":0.0})"));
    EXPECT_EQ(hinge.at("limits").at(2),
              nlohmann::json::parse(R"({"angularAxes":[0],"min":-0.5,"max":0.75,"stiffness":120.5,"damping":3.25})"));
    EXPECT_EQ(hinge.at("drives").at(0),
              nlohmann::json::parse(R"({"type":"angular","mode":"acceleration","axis":0,"maxForce":40.0,)"
                                    R"("positionTarget":0.25,"stiffness":900.0,"velocityTarget":1.5,"damping":60.0})"));
    EXPECT_EQ(hinge.at("extensions").at("CAIRN_joint").at("type"), "hinge");
    EXPECT_EQ(hinge.at("extensions").at("CAIRN_joint").at("break_force"), 5.0);
    EXPECT_EQ(joints.at(1), nlohmann::json::object());
    EXPECT_NE(json.at("extensionsUsed").dump().find("CAIRN_joint"), std::string::npos);
}

TEST(JointSave, JointsThatCannotActAreKeptWithAWarning) {
    const auto load = [](const std::string& motion, const std::string& rules) {
        std::string text = joint_text(rules);
        const std::string old = R"("motion":{"mass":1,"inertiaDiagonal":[1,1,1]},)";
        if (!motion.empty()) text.replace(text.find(old), old.size(), motion);
        return text;
    };
    const std::string lock = R"("limits":[{"linearAxes":[0,1,2],"min":0,"max":0}])";
    std::string many = R"("limits":[)";
    for (int i = 0; i < 9; ++i) many += std::string(i == 0 ? "" : ",") + R"({"linearAxes":[0],"min":0,"max":1})";
    const std::string place = "test.gltf: nodes[0].extensions.KHR_physics_rigid_bodies.joint: ";
    for (const auto& [text, warning] :
         {std::pair(load(R"("motion":{"isKinematic":true},)", lock),
                    place + "does not join two bodies of which one is dynamic, and has no effect"),
          std::pair(load(" ", lock), place + "does not join two bodies of which one is dynamic, and has no effect"),
          std::pair(load("", many + "]"),
                    place + "has more than 8 limits and drives that are not plain locks, and has no effect")}) {
        Scene scene = load_text(text);
        EXPECT_TRUE(scene.world.joints().empty());
        ASSERT_EQ(scene.idle_joints.size(), 1u);
        ASSERT_EQ(scene.warnings.size(), 1u);
        EXPECT_EQ(scene.warnings[0], warning);
        const std::string saved = scene::save_to_string(scene);
        const Scene again = load_text(saved);
        ASSERT_EQ(again.idle_joints.size(), 1u);
        EXPECT_TRUE(same(again.idle_joints[0].joint, scene.idle_joints[0].joint));
        EXPECT_EQ(again.idle_joints[0].name, "joint");
        EXPECT_TRUE(scene::save_to_string(again) == saved);
        scene.world.step(1.0f / 60.0f);
    }
    // Eight are accepted.
    many.resize(many.rfind(",{"));
    EXPECT_EQ(load_text(load("", many + "]")).world.joints().size(), 1u);
}

TEST(JointSave, MistakesInCairnJointAreNamed) {
    const auto expect_refused = [](const std::string& own, const std::string& message) {
        try {
            load_text(joint_text(R"("extensions":{"CAIRN_joint":)" + own + "}"));
            FAIL() << own;
        } catch (const Error& error) {
            EXPECT_EQ(error.what(), message);
            EXPECT_EQ(error.code(), ErrorCode::invalid_file);
        }
    };
    const std::string at = "test.gltf: extensions.KHR_physics_rigid_bodies.physicsJoints[0].extensions.CAIRN_joint";
    const std::string node = "test.gltf: nodes[0].extensions.KHR_physics_rigid_bodies.joint: ";
    expect_refused(R"({"type":"glue"})",
                   at + ".type: must be one of \"fixed\", \"ball\", \"hinge\", \"slider\", \"cylindrical\", "
                        "\"universal\", \"distance\", \"wheel\", \"servo\", \"gear\", \"rack\", \"pulley\", "
                        "\"general\", got \"glue\"");
    expect_refused(R"({"type":1})", at + ".type: must be a string, got 1");
    expect_refused(R"({"break_force":0})", at + ".break_force: must be > 0, got 0");
    expect_refused(R"({"solver":"best"})",
                   at + ".solver: must be \"automatic\", \"iterative\" or \"direct\", got \"best\"");
    expect_refused(R"({"type":"hinge","angle":{"limits":3}})", at + ".angle.limits: must be an object, got 3");
    expect_refused(R"({"type":"hinge","angle":{"friction":-1}})",
                   node + "HingeJoint.angle.friction: must be finite and >= 0, got -1");
    expect_refused(R"({"type":"gear","ratio":0})", node + "GearJoint.ratio: must not be 0, got 0");
}

TEST(JointSave, WhatIsShownAsAStringIsShownAgain) {
    std::string text = joint_text("\"limits\":[]");
    EXPECT_TRUE(load_text(text).joint_appearances.empty());
    const std::string name = R"("name":"joint",)";
    text.insert(text.find(name) + name.size(), R"("extras":{"cairn_color":[0.5,0.25,1]},)");
    Scene scene = load_text(text);
    for (int i = 0; i < 2; ++i) {
        ASSERT_EQ(scene.joint_appearances.size(), 1u);
        EXPECT_EQ(scene.joint_appearances[0].joint, scene.world.joints().at(0));
        EXPECT_EQ(scene.joint_appearances[0].color, Vec3(0.5f, 0.25f, 1.0f));
        scene = load_text(scene::save_to_string(scene));
    }
}

} // namespace
