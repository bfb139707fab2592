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
    // Half a turn about y: the camera looks along +z, away from the ball, at a point 1 m in front of it.
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
    ASSERT_EQ(scene.info.lights.size(), 1u);
    EXPECT_LT(glm::length(scene.info.lights[0].towards - Vec3(0, 1, 0)), 1e-5f); // shines downwards
    EXPECT_EQ(scene.info.lights[0].intensity, 1.0f);
    EXPECT_TRUE(load_view("{}", "}", "").info.lights.empty());
}

TEST(SceneView, AllLightsAreReadAndSaved) {
    const Scene scene =
        load_view(R"({"rotation":[-0.70710678,0,0,0.70710678],"children":[2,3,4],)"
                  R"("extensions":{"KHR_lights_punctual":{"light":0}}},)"
                  R"({"translation":[1,2,3],"extensions":{"KHR_lights_punctual":{"light":1}}},)"
                  R"({"translation":[0,-5,0],"rotation":[0,1,0,0],"extensions":{"KHR_lights_punctual":{"light":2}}},)"
                  R"({"extensions":{"KHR_lights_punctual":{"light":3}}})",
                  R"(,"KHR_lights_punctual":{"lights":[
           {"type":"directional","color":[1,0.5,0.25],"intensity":3},
           {"type":"point","color":[0,1,0],"intensity":40,"range":12},
           {"type":"spot","intensity":7,"spot":{"innerConeAngle":0.1,"outerConeAngle":0.5}},
           {"type":"area"}]}})",
                  "");
    const std::string text = scene::save_to_string(scene);
    const Scene again = load_text(text);
    for (const Scene* each : {&scene, &again}) {
        const std::vector<scene::Light>& lights = each->info.lights;
        ASSERT_EQ(lights.size(), 3u) << "what the extension does not know does not shine";
        EXPECT_EQ(lights[0].kind, scene::Light::Kind::directional);
        EXPECT_EQ(lights[0].color, Vec3(1.0f, 0.5f, 0.25f));
        EXPECT_EQ(lights[0].intensity, 3.0f);
        EXPECT_LT(glm::length(lights[0].towards - Vec3(0, 1, 0)), 1e-5f);
        EXPECT_EQ(lights[1].kind, scene::Light::Kind::point);
        EXPECT_LT(glm::length(lights[1].position - Position(1, 3, -2)), 1e-5) << "a quarter of a turn about x";
        EXPECT_EQ(lights[1].range, 12.0f);
        EXPECT_EQ(lights[1].intensity, 40.0f);
        EXPECT_EQ(lights[2].kind, scene::Light::Kind::spot);
        EXPECT_LT(glm::length(lights[2].position - Position(0, 0, 5)), 1e-5);
        EXPECT_LT(glm::length(lights[2].towards - Vec3(0, -1, 0)), 1e-5f) << "shines up";
        EXPECT_EQ(lights[2].inner_cone, 0.1f);
        EXPECT_EQ(lights[2].outer_cone, 0.5f);
        EXPECT_EQ(lights[2].range, 0.0f);
    }
    EXPECT_EQ(scene::save_to_string(again), text);
    Scene down = load_view("{}", "}", "");
    down.info.lights.push_back({.towards = {0.0f, 0.0f, -1.0f}});
    const Scene turned = load_text(scene::save_to_string(down));
    ASSERT_EQ(turned.info.lights.size(), 1u);
    EXPECT_LT(glm::length(turned.info.lights[0].towards - Vec3(0, 0, -1)), 1e-5f) << "half a turn";
}

TEST(SceneView, LightsThatMakeNoSenseAreRefused) {
    for (const char* light : {R"({})", R"({"type":"point","intensity":-1})", R"({"type":"point","range":0})",
                              R"({"type":"spot","spot":{"outerConeAngle":3}})", R"({"type":"point","color":[1,1]})"})
        EXPECT_THROW(load_view(R"({"extensions":{"KHR_lights_punctual":{"light":0}}})",
                               std::string(R"(,"KHR_lights_punctual":{"lights":[)") + light + "]}}", ""),
                     Error)
            << light;
}

TEST(SceneView, CamerasThatAreNotThereAreRefused) {
    EXPECT_THROW(load_view(R"({"camera":1})", perspective, ""), Error);
    EXPECT_THROW(load_view(R"({"extensions":{"KHR_lights_punctual":{"light":0}}})", "}", ""), Error);
}

} // namespace
