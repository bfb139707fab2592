// The picture of a shape covers exactly the pixels whose rays hit it: two ways to the same silhouette that share no
// code.
#include "viewer/headless.h"
#include "viewer/spawn.h"

#include "test_scene.h"

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace {

using namespace cairn;
using namespace cairn::viewer;

constexpr int width = 200, height = 150;
constexpr float aspect = float(width) / float(height);

struct Agreement {
    int covered = 0;      // pixels whose center ray hits the shape
    int wrong = 0;        // pixels that show something else, although all four neighbors' rays agree with theirs
    double darkest = 1e9; // least sum of the colors of a covered pixel
};

// Compares the picture with rays in a world with red shapes in front of a blue sky.
Agreement compare(const World& world, const HeadlessRenderer& renderer, const CameraPose& pose) {
    const OrbitCamera camera(pose);
    std::vector<int> met(std::size_t(width) * height);
    const auto index = [](int x, int y) { return std::size_t(y) * width + std::size_t(x); };
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const glm::vec2 device(2.0f * (float(x) + 0.5f) / width - 1.0f, 1.0f - 2.0f * (float(y) + 0.5f) / height);
            const Ray ray = camera.pick_ray(device, aspect);
            met[index(x, y)] = world.cast_ray(ray.origin, ray.direction, 1e5).has_value();
        }
    Agreement result;
    for (int y = 1; y + 1 < height; ++y)
        for (int x = 1; x + 1 < width; ++x) {
            const int here = met[index(x, y)];
            const std::uint8_t* pixel = &renderer.pixels()[3 * index(x, y)];
            result.covered += here;
            if (here) result.darkest = std::min(result.darkest, double(pixel[0]) + pixel[1] + pixel[2]);
            const int around =
                met[index(x - 1, y)] + met[index(x + 1, y)] + met[index(x, y - 1)] + met[index(x, y + 1)];
            if (around != 4 * here) continue; // at the silhouette
            const bool red = pixel[0] > pixel[2];
            result.wrong += red != (here == 1);
        }
    return result;
}

void expect_the_silhouette_of_rays(const Shape& shape, const std::string& name) {
    World world;
    const bool is_surface = std::holds_alternative<cairn::Mesh>(shape) || std::holds_alternative<HeightField>(shape);
    BodyDef def;
    def.type = is_surface ? BodyType::static_ : BodyType::dynamic;
    def.position = {0.3, 1.0, -0.2};
    def.rotation = is_surface ? Quat(1, 0, 0, 0) : glm::angleAxis(0.9f, glm::normalize(Vec3(1.0f, 0.4f, 0.3f)));
    const BodyId body = world.create_body(def);
    const Appearance red{world.add_shape(body, shape), {0.9f, 0.05f, 0.02f}};
    HeadlessRenderer renderer(width, height);
    FrameOptions options;
    options.grid = false;
    const CameraPose poses[]{{{2.0, 3.0, 4.0}, {0.3, 1.0, -0.2}, 0.6f},
                             {{2.0, 3.0, 4.0}, {0.3, 1.0, -0.2}, 0.6f, true},
                             {{-1.4, -1.0, -4.4}, {-3.1, -3.0, -8.6}, 0.6f, true}}; // the shape is behind the eye
    for (const CameraPose& pose : poses) {
        renderer.draw(make_frame(world, std::span(&red, 1), pose, options));
        const Agreement agreement = compare(world, renderer, pose);
        const std::string which = name + (pose.is_parallel ? ", parallel rays" : "");
        EXPECT_GT(agreement.covered, 400) << which;
        // Bevels remove the outermost edges and corners.
        EXPECT_LE(agreement.wrong, 10 + agreement.covered / 200) << which;
        EXPECT_GT(agreement.darkest, 20.0) << which; // no cracks or unlit spots
    }
}

TEST(ShapePicture, CoversWhatRaysMeet) {
    expect_the_silhouette_of_rays(Sphere{0.6f}, "sphere");
    expect_the_silhouette_of_rays(Capsule{0.5f, 0.3f, {}}, "capsule");
    expect_the_silhouette_of_rays(Capsule{0.5f, 0.5f, 0.2f}, "tapered capsule");
    expect_the_silhouette_of_rays(Capsule{0.4f, 0.0001f, 0.5f}, "drop");
    expect_the_silhouette_of_rays(Capsule{0.1f, 0.6f, 0.2f}, "a ball in a ball");
    expect_the_silhouette_of_rays(Cylinder{0.5f, 0.6f, {}}, "cylinder");
    expect_the_silhouette_of_rays(Cylinder{0.05f, 0.8f, {}}, "coin");
    expect_the_silhouette_of_rays(Cylinder{0.5f, 0.7f, 0.2f}, "tapered cylinder");
    expect_the_silhouette_of_rays(cone(0.6f, 0.6f), "cone");
    expect_the_silhouette_of_rays(Hull(test::cube_corners()), "hull");
    expect_the_silhouette_of_rays(test::cube_surface(), "mesh");
    expect_the_silhouette_of_rays(test::hills(12, 0.15f), "height field");
}

TEST(ShapePicture, EveryShapeThrowsAShadow) {
    const std::vector<std::pair<const char*, Shape>> shapes{{"capsule", Capsule{0.2f, 0.4f, {}}},
                                                            {"cylinder", Cylinder{0.4f, 0.4f, {}}},
                                                            {"hull", Hull(test::cube_corners())},
                                                            {"mesh", test::cube_surface()},
                                                            {"height field", test::hills(9, 0.25f)}};
    HeadlessRenderer renderer(width, height);
    CameraPose pose{{0.0, 6.0, 8.0}, {-1.5, 0.5, 0.0}, 0.8f};
    for (const auto& [name, shape] : shapes) {
        pose.is_parallel = !pose.is_parallel; // both kinds of projection
        const OrbitCamera camera(pose);
        LoadedScene scene = test::boxes_on_plane(0);
        BodyDef def = test::static_body();
        def.position = {0.0, 2.0, 0.0};
        scene.world.add_shape(scene.world.create_body(def), shape);
        RenderFrame frame = make_frame(scene.world, {}, pose);
        frame.lighting.to_sun = {1.0f, 1.0f, 0.0f}; // an object 2 m above the ground casts its shadow 2 m along -x
        const auto brightness = [&] {
            renderer.draw(frame);
            const auto device = camera.project({-2.0, 0.0, 0.0}, aspect);
            const int x = int((0.5f + 0.5f * device->x) * width), y = int((0.5f - 0.5f * device->y) * height);
            const std::uint8_t* pixel = &renderer.pixels()[3 * std::size_t(y * width + x)];
            return int(pixel[0]) + pixel[1] + pixel[2];
        };
        const int shadowed = brightness();
        frame.shadows = false;
        EXPECT_LT(shadowed, 3 * brightness() / 4) << name;
    }
}

TEST(ShapePicture, WaterTintsWhatIsBelowItsSurface) {
    LoadedScene scene = test::boxes_on_plane(1);
    HeadlessRenderer renderer(width, height);
    const CameraPose pose{{0.0, 2.0, 6.0}, {0.0, 0.5, 0.0}};
    const auto color_at = [&](const Position& point) {
        const auto device = OrbitCamera(pose).project(point, aspect);
        const int x = int((0.5 + 0.5 * double(device->x)) * width), y = int((0.5 - 0.5 * double(device->y)) * height);
        const std::uint8_t* pixel = &renderer.pixels()[3 * std::size_t(y * width + x)];
        return glm::dvec3(pixel[0], pixel[1], pixel[2]);
    };
    const auto look = [&] { // above the surface, below it, and at the ground
        renderer.draw(make_frame(scene.world, scene.appearances, pose));
        return std::vector{color_at({0.0, 0.85, 0.5}), color_at({0.0, 0.25, 0.5}), color_at({1.6, 0.0, 0.0})};
    };
    const auto dry = look();
    ForceField water;
    water.kind = ForceField::Kind::fluid;
    water.center = {0.0, 0.6, 0.0};
    scene.world.add_force_field(water);
    const auto wet = look();
    EXPECT_LT(glm::distance(wet[0], dry[0]), 3.0);
    for (const std::size_t i : {1, 2}) {
        EXPECT_LT(wet[i].r, 0.8 * dry[i].r) << i;
        EXPECT_GT(wet[i].b - wet[i].r, dry[i].b - dry[i].r + 20.0) << i;
    }
}

TEST(ShapePicture, OnlyWhatIsShownStaysOnTheGraphicsCard) {
    World world;
    const BodyId body = world.create_body(test::body_at({0.0, 1.0, 0.0}));
    world.add_shape(body, Hull(test::cube_corners()));
    HeadlessRenderer renderer(width, height);
    const CameraPose pose{{2.0, 3.0, 8.0}, {0.0, 1.0, 0.0}};
    const World empty;
    std::weak_ptr<const ShapeMesh> mesh;
    {
        const RenderFrame frame = make_frame(world, {}, pose);
        mesh = frame.meshes.at(0).mesh;
        renderer.draw(frame);
    }
    EXPECT_FALSE(mesh.expired());                                            // the renderer holds it
    for (int i = 0; i < 20; ++i) renderer.draw(make_frame(empty, {}, pose)); // several frames may use it in turn
    EXPECT_TRUE(mesh.expired());
}

} // namespace
