// Cameras and lights of glTF files.
#include "scene_text.h"

#include <gtest/gtest.h>

#include <string>

namespace {

using namespace cairn;
using namespace cairn::scene_test;
using scene::Scene;

Scene load_view(const std::string& nodes, const std::string& more, const std::string& world) {
    return load_text(R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0,1])" + world + R"(}],"nodes":[)" +
                     node(R"("translation":[4,2,0],)", R"("motion":{},"collider":{"geometry":{"shape":0}})") + "," +
                     nodes + R"(],"extensions":{"KHR_implicit_shapes":{"shapes":[{"type":"sphere"}]})" + more + "}");
}
const std::string perspective = R"(},"cameras":[{"type":"perspective","perspective":{"yfov":1.0,"znear":0.1}}])";

TEST(SceneView, TheCameraOfAFileIsTheFirstView) {
    // At 4 2 10, looking along -z at the ball.
    const Scene scene = load_view(R"({"translation":[4,2,10],"camera":0})", perspective, "");
    ASSERT_TRUE(scene.info.camera);
    EXPECT_LT(glm::length(scene.info.camera->position - Position(4, 2, 10)), 1e-9);
    EXPECT_LT(glm::length(scene.info.camera->target - Position(4, 2, 0)), 1e-6);
    EXPECT_NEAR(scene.info.camera->vertical_fov_degrees, 57.2958f, 1e-3f);
    const Scene again = load_text(scene::save_to_string(scene));
    ASSERT_TRUE(again.info.camera);
    EXPECT_LT(glm::length(again.info.camera->target - Position(4, 2, 0)), 1e-6);
}

TEST(SceneView, TurnedAndScaledNodesTurnTheView) {
    // Half a turn about y: it looks along +z, away from the ball, at what is a meter before it.
    const Scene scene =
        load_view(R"({"translation":[4,2,10],"rotation":[0,1,0,0],"scale":[3,3,3],"camera":0})", perspective, "");
    EXPECT_LT(glm::length(scene.info.camera->target - Position(4, 2, 11)), 1e-6);
}

TEST(SceneView, OrthographicCamerasAreReadAndSavedAsSuch) {
    const Scene scene =
        load_view(R"({"translation":[4,2,1],"camera":0})",
                  R"(},"cameras":[{"type":"orthographic","orthographic":{"xmag":3,"ymag":2,"znear":0,"zfar":9}}])", "");
    const Scene again = load_text(scene::save_to_string(scene));
    for (const auto& camera : {scene.info.camera, again.info.camera}) {
        ASSERT_TRUE(camera);
        EXPECT_TRUE(camera->is_orthographic);
        EXPECT_LT(glm::length(camera->target - Position(4, 2, 0)), 1e-6) << "at the ball";
        EXPECT_NEAR(camera->position.z * 0.41421356, 2.0, 1e-6) << "2 m above the middle fill the picture";
    }
    EXPECT_FALSE(load_view(R"({"translation":[4,2,10],"camera":0})", perspective, "").info.camera->is_orthographic);
}

TEST(SceneView, TheWorldsOwnCameraComesFirst) {
    const Scene scene = load_view(R"({"translation":[4,2,10],"camera":0})", perspective,
                                  R"(,"extensions":{"CAIRN_world":{"camera":{"position":[1,2,3],"target":[0,1,0]}}})");
    EXPECT_EQ(scene.info.camera->position, Position(1, 2, 3));
}

TEST(SceneView, TheSunOfTheFileShines) {
    const Scene scene =
        load_view(R"({"rotation":[-0.70710678,0,0,0.70710678],"extensions":{"KHR_lights_punctual":{"light":0}}})",
                  R"(,"KHR_lights_punctual":{"lights":[{"type":"directional"}]}})", "");
    ASSERT_TRUE(scene.info.light);
    EXPECT_LT(glm::length(*scene.info.light - Vec3(0, 1, 0)), 1e-5f); // shines down
    EXPECT_FALSE(load_view("{}", "}", "").info.light);
}

TEST(SceneView, CamerasThatAreNotThereAreRefused) {
    EXPECT_THROW(load_view(R"({"camera":1})", perspective, ""), Error);
    EXPECT_THROW(load_view(R"({"extensions":{"KHR_lights_punctual":{"light":0}}})", "}", ""), Error);
}

} // namespace
