// Shading of surfaces with different material properties.
#include "viewer/headless.h"

#include "picture_files.h"
#include "test_scene.h"

#include <gtest/gtest.h>

#include <array>
#include <functional>

namespace {

using namespace cairn;
using namespace cairn::viewer;

constexpr int width = 160, height = 120;

// A sheet of 4 m by 4 m that faces the viewer and fills the picture.
struct Sheet {
    std::vector<Vec3> colors;
    std::shared_ptr<const Finish> finish;
    Vec3 color{0.5f, 0.5f, 0.5f};
    Lighting lighting;
    bool is_mirrored = false; // the image is flipped horizontally
    ColorMode mode = ColorMode::scene;

    // The mean colors in the middle of the right and of the left half of the picture.
    std::array<Vec3, 2> halves() const {
        World world;
        const BodyId body = world.create_body({.type = BodyType::static_});
        world.add_shape(body, Box{{0.1f, 0.1f, 0.1f}});
        const std::vector<Vec3> corners{{-2, -2, 0}, {2, -2, 0}, {2, 2, 0}, {-2, 2, 0}};
        const float left = is_mirrored ? 1.0f : 0.0f;
        const std::vector<glm::vec2> places{{left, 1}, {1 - left, 1}, {1 - left, 0}, {left, 0}};
        const std::vector<std::uint32_t> triangles{0, 1, 2, 0, 2, 3};
        ShapeMesh mesh = make_shape_mesh(visual_triangles(corners, {}, triangles, places, colors), MeshVisual::visual);
        mesh.finish = finish;
        Visual visual{body, {}, std::make_shared<const ShapeMesh>(std::move(mesh)), color};
        FrameOptions options;
        options.colors = mode;
        options.lighting = lighting;
        HeadlessRenderer renderer(width, height);
        MeshCache meshes;
        renderer.draw(make_frame(world, {}, CameraPose{{0, 0, 4}, {0, 0, 0}, 0.8f}, options, meshes, {&visual, 1}));
        std::array<Vec3, 2> sums{Vec3(0.0f), Vec3(0.0f)};
        for (int y = height / 3; y < 2 * height / 3; ++y)
            for (int x = width / 4; x < 3 * width / 4; ++x) sums[x < width / 2 ? 1 : 0] += color_at(renderer, x, y);
        for (Vec3& sum : sums) sum /= float(height / 3 * (width / 4));
        return sums;
    }
    Vec3 mean() const {
        const std::array<Vec3, 2> both = halves();
        return 0.5f * (both[0] + both[1]);
    }
    static Vec3 color_at(const HeadlessRenderer& renderer, int x, int y) {
        const std::uint8_t* p = &renderer.pixels()[std::size_t(3 * (y * width + x))];
        return {p[0], p[1], p[2]};
    }
};

std::shared_ptr<const TexturePicture> picture_of(const std::function<std::array<std::uint8_t, 4>(int, int)>& texel) {
    TextureStyle style;
    style.is_data = true;
    return std::make_shared<const TexturePicture>(read_texture(test::shared(test::png_of(16, 16, texel)), style));
}

Lighting from(const Vec3& direction) { return lighting_of(std::vector<Light>{{.towards = direction}}, {0, 0, 0}); }

TEST(Finish, OfColoredVerticesIsTheirColorBetweenThem) {
    Sheet sheet;
    sheet.color = Vec3(1.0f);
    sheet.colors = {{0, 0, 1}, {1, 0, 0}, {1, 0, 0}, {0, 0, 1}}; // blue on the left, red on the right
    const std::array<Vec3, 2> halves = sheet.halves();
    EXPECT_GT(halves[0].x, halves[0].z + 30.0f);
    EXPECT_GT(halves[1].z, halves[1].x + 30.0f);
    EXPECT_LT(halves[0].y, 60.0f);
    sheet.mode = ColorMode::mass; // in this mode colors encode data
    const std::array<Vec3, 2> plain = sheet.halves();
    EXPECT_LT(glm::length(plain[0] - plain[1]), 12.0f);
}

// Normal maps whose normals lean to the right, or up: light from that side makes the surface brighter, also with
// mirrored texture coordinates.
TEST(Finish, OfNormalsTurnsTheSurfaceAsThePictureHasIt) {
    const auto leaning = [](int red, int green) {
        return std::make_shared<const Finish>(Finish{
            .roughness = 1.0f, .normals = picture_of([=](int, int) {
                                   return std::array<std::uint8_t, 4>{std::uint8_t(red), std::uint8_t(green), 218, 255};
                               })});
    };
    const auto brightness = [](const std::shared_ptr<const Finish>& finish, const Vec3& sun, bool is_mirrored = false) {
        Sheet sheet;
        sheet.finish = finish, sheet.lighting = from(sun), sheet.is_mirrored = is_mirrored;
        sheet.color = Vec3(0.1f);
        const Vec3 color = sheet.mean();
        return color.x + color.y + color.z;
    };
    const auto flat = leaning(128, 128), right = leaning(218, 128), up = leaning(128, 218);
    const Vec3 from_right(0.8f, 0.0f, 0.6f), from_left(-0.8f, 0.0f, 0.6f), above(0.0f, 0.8f, 0.6f),
        below(0.0f, -0.8f, 0.6f);
    EXPECT_GT(brightness(right, from_right), brightness(flat, from_right) + 40.0f);
    EXPECT_LT(brightness(right, from_left), brightness(flat, from_left) - 40.0f);
    EXPECT_GT(brightness(right, from_left, true), brightness(right, from_right, true) + 40.0f);
    EXPECT_GT(brightness(up, above), brightness(up, below) + 40.0f);
    Finish half = *right;
    half.normal_scale = 0.0f;
    EXPECT_NEAR(brightness(std::make_shared<const Finish>(half), from_right), brightness(flat, from_right), 6.0f);
}

// A specular highlight is small and bright on a smooth surface, wide and faint on a rough one, and tinted on a metal.
TEST(Finish, OfRoughAndSmoothSurfacesAndMetalsMirrorsTheLight) {
    const auto shown = [](float roughness, float metalness, const Vec3& sun = {0.0f, 0.0f, 1.0f}) {
        Sheet sheet;
        sheet.color = {0.9f, 0.3f, 0.05f};
        sheet.finish = std::make_shared<const Finish>(Finish{roughness, metalness});
        sheet.lighting = from(sun);
        return sheet.mean();
    };
    const Vec3 smooth = shown(0.35f, 0.0f), rough = shown(1.0f, 0.0f), metal = shown(0.35f, 1.0f, {0.9f, 0.0f, 0.4f});
    EXPECT_GT(smooth.z, rough.z + 15.0f) << "white light on top of the color";
    EXPECT_GT(metal.x, metal.z + 60.0f) << "what it mirrors has its color";
    Sheet sheet;
    sheet.color = {0.9f, 0.3f, 0.05f};
    sheet.lighting = from({0.0f, 0.0f, 1.0f});
    // Green is the roughness, blue the metalness: rough on the left, smooth on the right.
    sheet.finish = std::make_shared<const Finish>(
        Finish{1.0f, 1.0f, picture_of([](int x, int) {
                   return std::array<std::uint8_t, 4>{0, std::uint8_t(x < 8 ? 255 : 89), 0, 255};
               })});
    const std::array<Vec3, 2> halves = sheet.halves();
    EXPECT_LT(glm::length(halves[0] - smooth), 25.0f);
    EXPECT_LT(glm::length(halves[1] - rough), 25.0f);
    EXPECT_GT(halves[0].z, halves[1].z + 10.0f);
}

TEST(Finish, ThatGlowsIsSeenInTheDark) {
    Sheet sheet;
    sheet.lighting.sun = Vec3(0.0f);
    sheet.color = Vec3(0.0f);
    sheet.finish = std::make_shared<const Finish>(Finish{.roughness = 1.0f});
    const Vec3 dark = sheet.mean();
    sheet.finish = std::make_shared<const Finish>(Finish{.roughness = 1.0f, .glow = {0.0f, 1.0f, 0.0f}});
    const Vec3 green = sheet.mean();
    EXPECT_GT(green.y, dark.y + 100.0f);
    EXPECT_LT(green.x, dark.x + 40.0f);
    sheet.finish = std::make_shared<const Finish>(
        Finish{.roughness = 1.0f,
               .glow = {0.0f, 1.0f, 0.0f},
               .glows = picture_of([](int x, int) {
                   return std::array<std::uint8_t, 4>{255, std::uint8_t(x < 8 ? 255 : 0), 255, 255};
               })});
    const std::array<Vec3, 2> halves = sheet.halves();
    EXPECT_GT(halves[1].y, halves[0].y + 80.0f);
}

} // namespace
