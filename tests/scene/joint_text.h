// Scenes with one joint for tests: a ball of 1 kg with a moment of inertia of 1 kg m^2 about every axis, at the origin
// and jointed to the world there.
#pragma once

#include "scene_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace cairn::scene_test {

// `rules`: members of the physicsJoint; `motion`: additional members of the body's motion, with a leading comma;
// `gravity`: three numbers; `frames`: members of both frames' nodes, with a trailing comma.
inline std::string joint_text(const std::string& rules, const std::string& motion = "",
                              const std::string& gravity = "0,0,0", const std::string& frames = "") {
    return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0,1],"extensions":{"CAIRN_world":{"gravity":[)" +
           gravity + R"(],"sleep":false}}}],"nodes":[{)" + frames +
           R"("name":"joint","extensions":{"KHR_physics_rigid_bodies":{"joint":{"joint":0,"connectedNode":2}}}},)" +
           R"({"name":"ball","children":[2],"extensions":{"KHR_physics_rigid_bodies":{"motion":{"mass":1,)" +
           R"("inertiaDiagonal":[1,1,1])" + motion + R"(},"collider":{"geometry":{"shape":0}}}}},{)" + frames +
           R"("name":"frame"}],"extensions":{"KHR_implicit_shapes":{"shapes":[{"type":"sphere","sphere":{"radius":)" +
           R"(0.1}}]},)" + R"("KHR_physics_rigid_bodies":{"physicsJoints":[{)" + rules + "}]}}}";
}

struct OneJoint {
    scene::Scene scene;
    BodyId ball;
    JointId joint;

    explicit OneJoint(const std::string& text) : scene(load_text(text)), ball(*scene.world.find_body("ball")) {
        joint = scene.world.joints().at(0);
    }
    Body body() { return scene.world.body(ball); }
    Position position() { return body().position(); }
    Vec3 spin() { return body().angular_velocity(); }
    Vec3 speed() { return body().linear_velocity(); }
    // The rotation vector; valid for angles below pi.
    glm::dvec3 turned() {
        glm::dquat q(body().rotation());
        if (q.w < 0) q = -q;
        const glm::dvec3 v(q.x, q.y, q.z);
        const double sine = glm::length(v);
        return sine < 1e-12 ? glm::dvec3(0.0) : v * (2.0 * std::atan2(sine, q.w) / sine);
    }
    template <class AfterStep> void run(double seconds, AfterStep&& after_step) {
        for (int i = 0; i < static_cast<int>(std::lround(seconds * 60)); ++i) {
            scene.world.step(1.0f / 60.0f);
            after_step();
        }
    }
    void run(double seconds) {
        run(seconds, [] {});
    }
};

} // namespace cairn::scene_test
