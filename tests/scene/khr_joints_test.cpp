// Joints of the draft's samples and conformance files (in the folder CAIRN_KHR_SAMPLES): they behave as their names and
// READMEs say.
#include "khr_samples.h"

#include "scene/scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace {

using namespace cairn;
namespace fs = std::filesystem;

class KhrJoints : public KhrSampleTest {};

// A file with two boxes, the second of which is dynamic, and a joint.
struct TwoBoxes {
    scene::Scene scene;
    BodyId moving;
    JointId joint;
    Position start;
    double linear_error = 0, angular_error = 0; // the maximum so far

    explicit TwoBoxes(scene::Scene loaded) : scene(std::move(loaded)) {
        EXPECT_TRUE(scene.warnings.empty());
        joint = scene.world.joints().at(0);
        moving = scene.world.joint_def(joint).body_b;
        start = body().position();
        EXPECT_EQ(body().type(), BodyType::dynamic);
        // The static box, so that the joint may disable their collision.
        EXPECT_FALSE(scene.world.joint_def(joint).body_a.is_null());
    }
    Body body() { return scene.world.body(moving); }
    Position position() { return body().position(); }
    JointState state() const { return scene.world.joint_state(joint); }
    void run(
        double seconds, const std::function<void()>& after_step = [] {}) {
        for (int i = 0; i < static_cast<int>(std::lround(seconds / double(dt))); ++i) {
            scene.world.step(dt);
            linear_error = std::max(linear_error, double(state().linear_error));
            angular_error = std::max(angular_error, double(state().angular_error));
            after_step();
        }
    }
};

// 00, fixed: the box keeps its pose.
TEST_F(KhrJoints, Fixed) {
    TwoBoxes boxes(load("RigidBodies_Joint_00"));
    double farthest = 0;
    boxes.run(5.0, [&] { farthest = std::max(farthest, glm::length(boxes.position() - boxes.start)); });
    std::printf("fixed: moves %.2e m\n", farthest);
    EXPECT_LT(farthest, 1e-3);
    EXPECT_GT(boxes.body().rotation().w, 0.9999999f);
    EXPECT_NEAR(boxes.state().force.y, 1000.0f * 9.81f, 5.0f); // carries the weight
}

// 01, ball: the box hangs by a corner, swings, and rotates about more than one axis.
TEST_F(KhrJoints, Ball) {
    TwoBoxes boxes(load("RigidBodies_Joint_01"));
    double farthest = 0, highest = -10;
    boxes.run(10.0, [&] {
        farthest = std::max(farthest, glm::length(boxes.position() - boxes.start));
        highest = std::max(highest, boxes.position().y);
        // The center of the box keeps its distance from the corner.
        EXPECT_NEAR(glm::length(boxes.position() - Position(0.5, -0.5, 0.5)), std::sqrt(0.75), 2e-3);
    });
    std::printf("ball: moves %.3f m, gap %.2e m\n", farthest, boxes.linear_error);
    EXPECT_LT(boxes.linear_error, 2e-3);
    EXPECT_GT(farthest, 0.8); // it swings through below the corner
    EXPECT_LT(highest, boxes.start.y + 0.01);
}

// 02, a hinge about the x axis: the box swings in the plane perpendicular to it.
TEST_F(KhrJoints, Hinge) {
    TwoBoxes boxes(load("RigidBodies_Joint_02"));
    double farthest = 0, highest = -10, aside = 0;
    boxes.run(10.0, [&] {
        farthest = std::max(farthest, glm::length(boxes.position() - boxes.start));
        highest = std::max(highest, boxes.position().y);
        aside = std::max(aside, std::fabs(boxes.position().x));
        const Vec3 x = boxes.body().rotation() * Vec3(1.0f, 0.0f, 0.0f);
        aside = std::max(aside, std::sqrt(double(x.y) * x.y + double(x.z) * x.z));
    });
    std::printf("hinge: moves %.3f m, gap %.2e m, turns aside by %.2e\n", farthest, boxes.linear_error, aside);
    EXPECT_LT(boxes.linear_error, 2e-3);
    EXPECT_LT(aside, 2e-3);
    // From 45 degrees off the lowest position to 45 degrees beyond: a chord of 2 r sin 45 = 1 m.
    EXPECT_NEAR(farthest, 1.0, 0.02);
    EXPECT_LT(highest, boxes.start.y + 0.01);
}

// 05, prismatic: down a slope of 45 degrees from +2 m to -2 m, through the other box, without rotation.
TEST_F(KhrJoints, Prismatic) {
    TwoBoxes boxes(load("RigidBodies_Joint_05"));
    const Quat turn = boxes.body().rotation();
    double aside = 0;
    boxes.run(0.5, [&] { aside = std::max(aside, std::fabs(boxes.position().x + boxes.position().y)); });
    // g sin 45 t^2 / 2
    EXPECT_NEAR(glm::length(boxes.position() - boxes.start), 0.5 * 9.81 * 0.70711 * 0.25, 0.04);
    boxes.run(4.0, [&] {
        aside = std::max(aside, std::fabs(boxes.position().x + boxes.position().y));
        EXPECT_LT(glm::length(boxes.position()), 2.01);
    });
    std::printf("prismatic: ends at (%.4f, %.4f), %.2e m off its line\n", boxes.position().x, boxes.position().y,
                aside);
    EXPECT_LT(aside, 2e-3);
    EXPECT_NEAR(boxes.position().x, std::sqrt(2.0), 2e-3);
    EXPECT_NEAR(boxes.position().y, -std::sqrt(2.0), 2e-3);
    EXPECT_NEAR(std::fabs(glm::dot(boxes.body().rotation(), turn)), 1.0f, 1e-6f);
}

// 07, a stiff spring: the two points are at most 1 m apart, and the box hangs at that distance.
TEST_F(KhrJoints, StiffSpring) {
    TwoBoxes boxes(load("RigidBodies_Joint_07"));
    double farthest = 0, lowest = 0;
    boxes.run(10.0, [&] {
        farthest = std::max(farthest, double(boxes.state().positions[0]));
        lowest = std::min(lowest, boxes.position().y);
    });
    std::printf("stiff spring: %.4f m apart at most, falls to %.3f m\n", farthest, lowest);
    EXPECT_NEAR(farthest, 1.0, 0.01);
    EXPECT_LT(lowest, -1.9); // below the static box by the length of the rope and the distance to the box's center
    EXPECT_GT(lowest, -0.5 - 1.0 - std::sqrt(0.75) - 0.01);
}

// 09, revolute with an angular drive: 1 m beside the other box, it rotates about the x axis at 90 degrees per second.
TEST_F(KhrJoints, AngularDrive) {
    TwoBoxes boxes(load("RigidBodies_Joint_09"));
    double farthest = 0;
    const auto watch = [&] { farthest = std::max(farthest, glm::length(boxes.position() - boxes.start)); };
    boxes.run(1.0, watch);
    EXPECT_NEAR(boxes.body().angular_velocity().x, 1.5707964 * (1 - std::exp(-1.0)), 0.02); // damping of 1/s
    boxes.run(9.0, watch);
    std::printf("drive: turns with %.4f rad/s, moves %.2e m\n", boxes.body().angular_velocity().x, farthest);
    EXPECT_NEAR(boxes.body().angular_velocity().x, 1.5707964f, 2e-3f);
    EXPECT_LT(farthest, 2e-3);
}

// The sample JointTypes: joints are found by the names of the bodies they connect.
class JointTypes : public KhrJoints {
  protected:
    void SetUp() override {
        KhrJoints::SetUp();
        if (IsSkipped()) return;
        scene_.emplace(load("JointTypes"));
        ASSERT_EQ(scene_->world.joints().size(), 11u);
        ASSERT_TRUE(scene_->warnings.empty()) << scene_->warnings[0];
    }
    World& world() { return scene_->world; }
    Body body(const char* name) { return scene_->world.body(*scene_->world.find_body(name)); }
    // The joint between two bodies.
    JointId joint(const char* a, const char* b) {
        for (const JointId id : world().joints()) {
            const JointDef& def = world().joint_def(id);
            if (world().body(def.body_a).name() == a && world().body(def.body_b).name() == b) return id;
        }
        throw Error(ErrorCode::invalid_value, a, {}, "has no such joint");
    }
    void run(double seconds, const std::function<void()>& after_step) {
        for (int i = 0; i < static_cast<int>(std::lround(seconds / double(dt))); ++i) {
            world().step(dt);
            after_step();
        }
    }

    std::optional<scene::Scene> scene_;
};

// Joint errors are checked until the rotating bar hits the hinged boxes beside it, which no joint can withstand.
TEST_F(JointTypes, NoneComesApart) {
    const std::vector<JointId> joints = world().joints();
    std::vector<double> linear(joints.size()), angular(joints.size());
    std::vector<bool> is_hit(joints.size());
    const auto touches_bar = [&](BodyId id) {
        const std::vector<Contact> contacts = world().contacts(id);
        return std::any_of(contacts.begin(), contacts.end(), [&](const Contact& contact) {
            return world().body(contact.body_a).name() == "Cube.006" ||
                   world().body(contact.body_b).name() == "Cube.006";
        });
    };
    run(10.0, [&] {
        const bool hits = touches_bar(body("Cube.004").id()) || touches_bar(body("Cube.005").id());
        for (std::size_t i = 0; i < joints.size(); ++i) {
            const JointDef& def = world().joint_def(joints[i]);
            is_hit[i] = is_hit[i] || (hits && world().body(def.body_a).name() == "Cube.004");
            if (is_hit[i]) continue;
            linear[i] = std::max(linear[i], double(world().joint_state(joints[i]).linear_error));
            angular[i] = std::max(angular[i], double(world().joint_state(joints[i]).angular_error));
        }
    });
    for (std::size_t i = 0; i < joints.size(); ++i) {
        const JointDef& def = world().joint_def(joints[i]);
        std::printf("%-9s to %-9s apart %.2e m, turned %.2e\n", std::string(world().body(def.body_a).name()).c_str(),
                    std::string(world().body(def.body_b).name()).c_str(), linear[i], angular[i]);
        EXPECT_LT(linear[i], 4e-3); // briefly, when an eccentric box reaches its limit
        EXPECT_LT(angular[i], 2e-2);
    }
}

TEST_F(JointTypes, BallsAndHingesHang) {
    const auto anchor = [&](const char* name, const Vec3& local) {
        return body(name).position() + Position(body(name).rotation() * local);
    };
    double fallen = 0;
    run(3.0, [&] {
        EXPECT_LT(glm::length(anchor("Cube.001", {0.25f, 0.25f, -0.25f}) - Position(-3.75, 2.75, -0.25)), 3e-3);
        EXPECT_LT(glm::length(anchor("Cube.002", {-0.25f, 0.25f, 0.25f}) - anchor("Cube.001", {-0.25f, -0.25f, 0.25f})),
                  3e-3);
        // Both hinges rotate about z.
        for (const char* name : {"Cube.004", "Cube.005"}) {
            const Vec3 z = body(name).rotation() * Vec3(0.0f, 0.0f, 1.0f);
            EXPECT_GT(z.z, 0.9999f);
            EXPECT_NEAR(body(name).position().z, 0.0, 2e-3);
        }
        fallen = std::max(fallen, 2.0 - body("Cube.005").position().y);
    });
    EXPECT_GT(fallen, 0.2);
    EXPECT_LT(fallen, 1.0);
}

TEST_F(JointTypes, PrismaticSlidesAlongTheTurningBody) {
    double least = 0, most = 0;
    const JointId way = joint("Cube.007", "Cube.006");
    run(10.0, [&] {
        const Position from = body("Cube.007").position() - body("Cube.006").position();
        const double along = glm::dot(from, Position(body("Cube.006").rotation() * Vec3(0.0f, 1.0f, 0.0f)));
        const double aside = glm::dot(from, Position(body("Cube.006").rotation() * Vec3(1.0f, 0.0f, 0.0f)));
        least = std::min(least, along);
        most = std::max(most, along);
        EXPECT_NEAR(aside, -0.0022, 6e-3); // its offset in the file; it tilts a little at its limits
        // Position of the connected node relative to the joint's node.
        EXPECT_NEAR(world().joint_state(way).positions[0], -along, 6e-3);
    });
    std::printf("prismatic: %.4f to %.4f m\n", least, most);
    EXPECT_NEAR(least, -0.5, 0.02); // not measured at the joint, about which the box tilts a little
    EXPECT_NEAR(most, 0.5, 0.02);
}

TEST_F(JointTypes, StiffSpringHoldsAPointInABox) {
    double lowest = 9;
    run(10.0, [&] {
        const Position at = body("Cube.009").position() +
                            Position(body("Cube.009").rotation() * Vec3(0.0f, 0.0f, 1.0f)) - Position(-0.75, 3.0, 0.0);
        // Along the axes of the joint's own frame, which rotates with the body.
        const Position in_frame = glm::conjugate(glm::dquat(body("Cube.009").rotation())) * at;
        for (int i = 0; i < 3; ++i) EXPECT_LT(std::fabs(in_frame[i]), 0.25 + 5e-3);
        lowest = std::min(lowest, body("Cube.009").position().y);
    });
    EXPECT_LT(lowest, 2.6); // it swings about the point, 1 m away
}

TEST_F(JointTypes, FixedStays) {
    run(10.0, [&] {
        EXPECT_LT(glm::length(body("Cube.011").position() - Position(0.25, 2.3, 0.0)), 1e-3);
        EXPECT_GT(body("Cube.011").rotation().w, 0.999999f);
    });
}

TEST_F(JointTypes, LimitedHingeAndConeKeepTheirAngles) {
    constexpr double bound = 0.7853981852531433;
    double least = 0, most = 0, tilt = 0;
    const JointId hinge = joint("Cube.015", "Cube.012"), cone = joint("Cube.013", "Cube.014");
    run(10.0, [&] {
        const double angle = double(world().joint_state(hinge).positions[0]);
        least = std::min(least, angle);
        most = std::max(most, angle);
        for (int i = 0; i < 2; ++i)
            tilt = std::max(tilt, std::fabs(double(world().joint_state(cone).positions[std::size_t(i)])));
    });
    std::printf("limited hinge: %.4f to %.4f rad; cone: %.4f rad\n", least, most, tilt);
    EXPECT_LT(std::max(most, -least), bound + 0.01);
    EXPECT_GT(std::max(most, -least), bound - 0.01); // the wheel drives the hinge to its limit
    EXPECT_LT(tilt, bound + 0.01);
    EXPECT_GT(tilt, bound - 0.01);
}

// 1.57 rad/s about -z; the speed varies periodically, as the center of mass is 0.3 mm off the axis.
TEST_F(JointTypes, VelocityMotorTurnsTheOtherWay) {
    double sum = 0, aside = 0;
    int steps = 0;
    run(10.0, [&] {
        const Vec3 w = body("Cube.017").angular_velocity();
        aside = std::max({aside, std::fabs(double(w.x)), std::fabs(double(w.y))});
        if (world().time() < 6.0) return;
        sum += double(w.z); // over whole turns
        ++steps;
    });
    std::printf("velocity motor: %.4f rad/s\n", sum / steps);
    EXPECT_NEAR(sum / steps, -1.57, 5e-3);
    EXPECT_LT(aside, 5e-3);
}

TEST_F(JointTypes, PositionMotorLifts) {
    // A drive of 10 N/m towards 1.2 m against the weight of 1 kg: it oscillates around 0.219 m above its start.
    const Position start = body("Cube.019").position();
    double least = 9, most = -9, sum = 0;
    int steps = 0;
    run(20.0, [&] {
        const double way = body("Cube.019").position().y - start.y;
        least = std::min(least, way);
        most = std::max(most, way);
        sum += way;
        ++steps;
        EXPECT_NEAR(body("Cube.019").position().x, start.x, 1e-3);
    });
    std::printf("position motor: %.4f to %.4f m, %.4f m on the mean\n", least, most, sum / steps);
    EXPECT_GT(least, -3e-3); // the lower limit
    EXPECT_NEAR(most, 0.438, 0.02);
    EXPECT_NEAR(sum / steps, 0.219, 0.01);
}

} // namespace
