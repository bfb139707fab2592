// Rendered pictures, judged by statistics that tolerate the rounding of different drivers.
#include "viewer/headless.h"

#include "../sanitized.h"
#include "picture_files.h"
#include "test_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace cairn;
using namespace cairn::viewer;
namespace fs = std::filesystem;

constexpr int width = 320, height = 180;

struct Color {
    double red = 0.0, green = 0.0, blue = 0.0; // 0 to 255
    double sum() const { return red + green + blue; }
};

// The mean color of a square patch; coordinates are fractions of the picture, from its top left corner.
Color mean(const HeadlessRenderer& renderer, double x, double y, double half_size = 0.01) {
    Color color;
    int count = 0;
    for (int py = int((y - half_size) * height); py <= int((y + half_size) * height); ++py)
        for (int px = int((x - half_size) * width); px <= int((x + half_size) * width); ++px) {
            const std::uint8_t* pixel = &renderer.pixels()[3 * std::size_t(py * width + px)];
            color.red += pixel[0];
            color.green += pixel[1];
            color.blue += pixel[2];
            ++count;
        }
    return {color.red / count, color.green / count, color.blue / count};
}

Color mean_at(const HeadlessRenderer& renderer, const OrbitCamera& camera, const Position& point) {
    const auto device = camera.project(point, float(width) / float(height));
    return mean(renderer, 0.5 + 0.5 * device->x, 0.5 - 0.5 * device->y);
}

// A new temporary folder that is removed at the end.
struct Folder {
    fs::path path = fs::temp_directory_path() /
                    ("cairn_test_" + std::to_string(std::chrono::steady_clock::now().time_since_epoch().count()));
    Folder() { fs::create_directories(path); }
    ~Folder() { fs::remove_all(path); }
};

TEST(HeadlessRenderer, GhostsLetThroughWhatIsBehindThem) {
    const LoadedScene scene = test::boxes_on_plane(1);
    HeadlessRenderer renderer(width, height);
    const CameraPose pose{{0.0, 2.0, 6.0}, {0.0, 0.5, 0.0}};
    const OrbitCamera camera(pose);
    RenderFrame frame = make_frame(scene.world, scene.appearances, pose);
    const auto draw = [&] {
        renderer.draw(frame);
        return mean_at(renderer, camera, {0.0, 0.5, 0.5});
    };
    const Color solid = draw();
    frame.ghosts.boxes = std::exchange(frame.boxes, {});
    const Color ghost = draw();
    frame.ghosts.boxes.push_back(frame.ghosts.boxes.front());
    frame.ghosts.boxes.back().position.z -= 0.6f; // behind the first ghost
    const Color two = draw();
    frame.ghosts.boxes.clear();
    const Color behind = draw();
    EXPECT_GT(ghost.red - ghost.green, 10.0); // the box is red ...
    EXPECT_LT(ghost.red - ghost.green, 0.6 * (solid.red - solid.green));
    EXPECT_LT(ghost.green, behind.green - 10.0); // ... and the ground gray
    EXPECT_GT(ghost.green, solid.green + 10.0);
    EXPECT_NEAR(two.sum(), ghost.sum(), 6.0);
}

TEST(HeadlessRenderer, DrawsSkyBodyGroundAndShadow) {
    const LoadedScene scene = test::boxes_on_plane(1);
    HeadlessRenderer renderer(width, height);
    const CameraPose pose{{0.0, 2.0, 6.0}, {0.0, 0.5, 0.0}};
    const OrbitCamera camera(pose);
    RenderFrame frame = make_frame(scene.world, scene.appearances, pose);
    frame.lighting.to_sun = {1.0f, 1.0f, 0.0f}; // the shadow of a cube of 1 m extends 1 m along -x
    renderer.draw(frame);

    const Color sky = mean(renderer, 0.5, 0.03), box = mean_at(renderer, camera, {0.0, 0.5, 0.5});
    EXPECT_GT(sky.blue, sky.red + 10.0);
    EXPECT_GT(sky.sum(), 200.0);
    EXPECT_GT(box.red, 3.0 * box.blue);
    const Color shadowed = mean_at(renderer, camera, {-1.0, 0.0, 0.0}),
                lit = mean_at(renderer, camera, {1.6, 0.0, 0.0});
    EXPECT_LT(shadowed.sum(), 0.75 * lit.sum());
    EXPECT_GT(shadowed.sum(), 0.15 * lit.sum()); // ambient light from the sky remains

    frame.shadows = false;
    renderer.draw(frame);
    EXPECT_NEAR(mean_at(renderer, camera, {-1.0, 0.0, 0.0}).sum(), lit.sum(), 0.05 * lit.sum());
}

// A pixel is 5 cm here: the second ball is 120 pixels to the right of the first.
TEST(HeadlessRenderer, ParallelRaysShowABallAlikeWhereverItIs) {
    HeadlessRenderer renderer(width, height);
    for (const double depth : {0.0, -30.0, 25.0}) { // the last ball is behind the eye
        World world;
        std::vector<Appearance> red;
        for (const Position& place : {Position(-3.0, 0.0, 0.0), Position(3.0, 0.0, depth)})
            red.push_back(
                {world.add_shape(world.create_body(test::body_at(place)), Sphere{1.2f}), {0.9f, 0.05f, 0.02f}});
        FrameOptions options;
        options.shadows = false;
        const CameraPose pose{{0.0, 0.0, 10.0}, {0.0, 0.0, 0.0}, 2.0f * std::atan(0.45f), true};
        renderer.draw(make_frame(world, red, pose, options));
        int differ = 0, covered = 0;
        for (int y = 60; y < 120; ++y)
            for (int x = 70; x < 130; ++x) {
                const std::uint8_t* pixel = &renderer.pixels()[3 * std::size_t(y * width + x)];
                const double from_middle = std::hypot(x + 0.5 - 100.0, y + 0.5 - 90.0) * 0.05;
                if (from_middle > 1.1) continue;
                ++covered;
                int difference = 0;
                for (int i = 0; i < 3; ++i) difference += std::abs(int(pixel[i]) - int(pixel[3 * 120 + i]));
                differ += difference > 6;
            }
        EXPECT_GT(covered, 1000);
        EXPECT_LE(differ, covered / 100) << depth;
    }
}

// A wall with a texture of four colors, one of which is transparent: each color is at the position given by the file,
// the hole shows the background, and modes in which colors encode data, such as masses, are not covered by textures.
TEST(HeadlessRenderer, TexturesCoverMeshesAsTheFileHasThem) {
    World world;
    const BodyId body = world.create_body({.type = BodyType::static_});
    world.add_shape(body, Box{{1.0f, 1.0f, 0.05f}});
    const std::vector<Vec3> corners{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
    const std::vector<glm::vec2> coordinates{{0, 1}, {1, 1}, {1, 0}, {0, 0}};
    const std::vector<std::uint32_t> triangles{0, 1, 2, 0, 2, 3};
    const auto shown = [&](float cutoff, ColorMode colors) {
        ShapeMesh mesh = make_shape_mesh(visual_triangles(corners, {}, triangles, coordinates), MeshVisual::visual);
        TextureStyle style;
        style.is_smooth = false, style.alpha_cutoff = cutoff;
        mesh.texture = std::make_shared<const TexturePicture>(read_texture(test::shared(test::four_texels()), style));
        Visual visual{body, {}, std::make_shared<const ShapeMesh>(std::move(mesh)), {1, 1, 1}};
        FrameOptions options;
        options.colors = colors;
        HeadlessRenderer renderer(width, height);
        MeshCache meshes;
        const CameraPose pose{{0, 0, 4}, {0, 0, 0}, 0.8f};
        renderer.draw(make_frame(world, {}, pose, options, meshes, {&visual, 1}));
        const OrbitCamera camera(pose);
        std::vector<Color> found;
        for (const Position& place : {Position(-0.5, 0.5, 0), Position(0.5, 0.5, 0), Position(-0.5, -0.5, 0),
                                      Position(0.5, -0.5, 0), Position(1.5, -0.5, 0)})
            found.push_back(mean_at(renderer, camera, place));
        return found;
    };
    const std::vector<Color> whole = shown(0.0f, ColorMode::scene);
    EXPECT_GT(whole[0].red, whole[0].green + 50);
    EXPECT_GT(whole[0].red, whole[0].blue + 50);
    EXPECT_GT(whole[1].green, whole[1].red + 50);
    EXPECT_GT(whole[1].green, whole[1].blue + 50);
    EXPECT_GT(whole[2].blue, whole[2].red + 50);
    EXPECT_GT(whole[2].blue, whole[2].green + 50);
    EXPECT_NEAR(whole[3].red, whole[3].green, 25);
    EXPECT_GT(std::abs(whole[3].sum() - whole[4].sum()), 30) << "white is not the sky";
    const std::vector<Color> with_hole = shown(0.5f, ColorMode::scene);
    EXPECT_NEAR(with_hole[0].red, whole[0].red, 2);
    EXPECT_NEAR(with_hole[3].red, whole[4].red, 6);
    EXPECT_NEAR(with_hole[3].blue, whole[4].blue, 6);
    const std::vector<Color> by_mass = shown(0.0f, ColorMode::mass);
    for (int i = 1; i < 4; ++i) EXPECT_NEAR(by_mass[std::size_t(i)].green, by_mass[0].green, 8) << i;
}

TEST(HeadlessRenderer, LampsShineByDistanceRangeAndCone) {
    const LoadedScene scene = test::boxes_on_plane(0);
    HeadlessRenderer renderer(width, height);
    const CameraPose pose{{0.0, 7.0, 7.0}, {0.0, 0.0, 0.0}};
    const OrbitCamera camera(pose);
    FrameOptions options;
    options.grid = false;
    const auto draw = [&](std::vector<Light> lights) {
        lights.push_back({.intensity = 0.0f}); // no sun
        options.lighting = lighting_of(lights, {0.0, 0.0, 0.0});
        renderer.draw(make_frame(scene.world, {}, pose, options));
    };
    const auto at = [&](const Position& point) { return mean_at(renderer, camera, point); };
    const Position below(0.0, 0.0, 0.0), beside(2.5, 0.0, 0.0);
    draw({});
    const double dark = at(below).sum();
    Light light{Light::Kind::point, {1.0f, 0.1f, 0.1f}, 4.0f, {0.0, 2.0, 0.0}};
    draw({light});
    const Color red = at(below);
    EXPECT_GT(red.sum(), dark + 40.0);
    EXPECT_GT(red.red, red.blue + 40.0) << "it has the color of the light";
    const double far = at(beside).sum();
    EXPECT_LT(far, red.sum() - 20.0);
    EXPECT_GT(far, dark + 5.0);
    light.range = 2.5f;
    draw({light});
    EXPECT_GT(at(below).sum(), dark + 15.0);
    EXPECT_NEAR(at(beside).sum(), dark, 6.0) << "3.2 m away";
    light.range = 0.0f;
    light.kind = Light::Kind::spot;
    light.outer_cone = 0.6f;
    draw({light});
    EXPECT_GT(at(below).sum(), dark + 40.0);
    EXPECT_NEAR(at(beside).sum(), dark, 6.0) << "0.9 rad from the axis";
    light.towards = {1.0f, 0.0f, 0.0f};
    draw({light});
    EXPECT_NEAR(at(below).sum(), dark, 6.0) << "it shines elsewhere";
    draw({{.intensity = 0.0f}, {.color = {0.1f, 0.1f, 1.0f}}});
    EXPECT_GT(at(beside).blue, at(beside).red + 40.0) << "a second one from far away";
}

TEST(HeadlessRenderer, TheSunHasColorAndIntensityOfTheScene) {
    const LoadedScene scene = test::boxes_on_plane(0);
    HeadlessRenderer renderer(width, height);
    const CameraPose pose{{0.0, 2.0, 6.0}, {0.0, 0.5, 0.0}};
    const OrbitCamera camera(pose);
    FrameOptions options;
    options.grid = false;
    const auto ground = [&](const std::vector<Light>& lights) {
        options.lighting = lighting_of(lights, {0.0, 0.0, 0.0});
        renderer.draw(make_frame(scene.world, {}, pose, options));
        return mean_at(renderer, camera, {0.0, 0.0, 0.0});
    };
    const auto of = [&](float intensity) { return ground({{.intensity = intensity}}).sum(); };
    const Color usual = ground({}), white = ground({Light{}}), blue = ground({{.color = {0.2f, 0.2f, 1.0f}}});
    EXPECT_GT(usual.red - usual.blue, white.red - white.blue) << "that of every scene is warm";
    EXPECT_GT(blue.blue, blue.red + 30.0);
    EXPECT_GT(white.sum(), of(0.01f) + 20.0);
    EXPECT_LT(white.sum(), of(10.0f) - 5.0);
    EXPECT_NEAR(of(1e5f), of(1e4f), 1.0) << "eyes adapt";
}

TEST(HeadlessRenderer, BoxesOfLinesAreDrawnAndFaintBehindBodies) {
    const LoadedScene scene = test::boxes_on_plane(1);
    HeadlessRenderer renderer(width, height);
    const CameraPose pose{{0.0, 2.0, 6.0}, {0.0, 0.5, 0.0}};
    const OrbitCamera camera(pose);
    RenderFrame frame = make_frame(scene.world, scene.appearances, pose);
    renderer.draw(frame);
    const std::vector<std::uint8_t> plain(renderer.pixels().begin(), renderer.pixels().end());
    // The excess of blue along the line between two points, at the bluest pixel across the line; the minimum along the
    // line.
    const auto blue_on = [&](const Position& a, const Position& b) {
        double least = 1e9;
        for (int i = 1; i < 10; ++i) {
            const auto device = camera.project(a + (b - a) * (0.1 * i), float(width) / float(height));
            const int x = int((0.5f + 0.5f * device->x) * width), y = int((0.5f - 0.5f * device->y) * height);
            double most = 0.0;
            for (int dy = -2; dy <= 2; ++dy)
                for (int dx = -2; dx <= 2; ++dx) {
                    const std::size_t pixel = 3 * std::size_t((y + dy) * width + x + dx);
                    const auto blueness = [&](const auto& pixels) {
                        return double(pixels[pixel + 2]) - double(pixels[pixel]);
                    };
                    most = std::max(most, blueness(renderer.pixels()) - blueness(plain));
                }
            least = std::min(least, most);
        }
        return least;
    };
    const auto box = [&](const Position& min, const Position& max) {
        return LineBox{Vec3(min - frame.origin), Vec3(max - frame.origin), {0.0f, 0.0f, 1.0f}};
    };
    frame.line_boxes = {box({0.0, -50.0, 0.0}, {0.1, -49.0, 0.1}), box({-1.5, 0.2, -0.2}, {1.5, 1.7, 0.7})};
    renderer.draw(frame);
    const auto corner = [](int k) { return Position(k & 1 ? 1.5 : -1.5, k & 2 ? 1.7 : 0.2, k & 4 ? 0.7 : -0.2); };
    for (int i = 0; i < 8; ++i)
        for (const int axis : {1, 2, 4}) {
            if (i & axis) continue;
            EXPECT_GT(blue_on(corner(i), corner(i | axis)), 12.0) << i << " along " << axis;
        }
    frame.line_boxes = {box({-0.4, 0.1, -0.4}, {0.4, 0.9, 0.4})};
    renderer.draw(frame);
    const double hidden = blue_on({-0.4, 0.1, 0.4}, {0.4, 0.1, 0.4});
    EXPECT_GT(hidden, 8.0);
    EXPECT_LT(hidden, 150.0);
}

TEST(HeadlessRenderer, StrokesAreSeenThroughBodiesButFainter) {
    const LoadedScene scene = test::boxes_on_plane(1);
    HeadlessRenderer renderer(width, height);
    const CameraPose pose{{0.0, 2.0, 6.0}, {0.0, 0.5, 0.0}};
    const OrbitCamera camera(pose);
    RenderFrame frame = make_frame(scene.world, scene.appearances, pose);
    const auto blue_at = [&](const Position& point) { return mean_at(renderer, camera, point).blue; };
    const Position inside(0.0, 0.5, 0.0), before(0.0, 0.5, 0.6), beside(1.5, 1.5, 0.0);
    renderer.draw(frame);
    const double plain = blue_at(inside);
    const auto with_dot = [&](const Position& at) {
        RenderFrame marked = frame;
        const Vec3 place(at - frame.origin);
        marked.strokes.push_back({place, place, {0.0f, 0.0f, 1.0f}, 60.0f});
        renderer.draw(marked);
        return blue_at(at);
    };
    EXPECT_GT(with_dot(before), 240.0);
    const double hidden = with_dot(inside);
    EXPECT_GT(hidden, plain + 30.0);
    EXPECT_LT(hidden, 200.0);
    // A translucent veil shows what is behind it, from either side.
    const Color sky = (renderer.draw(frame), mean_at(renderer, camera, beside));
    for (const float way : {-1.0f, 1.0f}) {
        RenderFrame veiled = frame;
        const Vec3 at(beside - frame.origin);
        veiled.veils.push_back({at + Vec3(-way, -1, 0), at + Vec3(way, -1, 0), at + Vec3(0, 1, 0), {1.0f, 0.0f, 0.0f}});
        renderer.draw(veiled);
        const Color seen = mean_at(renderer, camera, beside);
        EXPECT_LT(seen.blue, sky.blue - 15.0);
        EXPECT_GT(seen.blue, 0.5 * sky.blue);
    }
}

TEST(HeadlessRenderer, EdgesAreSmooth) {
    LoadedScene scene = test::boxes_on_plane(0);
    const BodyId ball = scene.world.create_body(test::body_at({0.0, 3.0, 0.0}));
    scene.world.add_shape(ball, Sphere{1.0f});
    HeadlessRenderer renderer(width, height);
    renderer.draw(make_frame(scene.world, {}, {{0.0, 3.0, 6.0}, {0.0, 3.0, 0.0}}));
    std::set<std::uint32_t> colors;
    for (std::size_t i = 0; i + 2 < renderer.pixels().size(); i += 3)
        colors.insert(std::uint32_t(renderer.pixels()[i]) << 16 | std::uint32_t(renderer.pixels()[i + 1]) << 8 |
                      renderer.pixels()[i + 2]);
    EXPECT_GT(colors.size(), 500u); // neither blank nor uniform
}

// The error of a picture relative to one with four times the resolution that is scaled down: the mean over pixels whose
// color differs from a neighbor's.
double error_at_edges(const std::vector<std::uint8_t>& picture, const std::vector<std::uint8_t>& large) {
    double sum = 0.0;
    int count = 0;
    for (int y = 1; y + 1 < height; ++y)
        for (int x = 1; x + 1 < width; ++x) {
            const auto wanted = [&](int column, int row) {
                double color = 0.0;
                for (int k = 0; k < 16; ++k)
                    color += large[3 * (std::size_t(4 * row + k / 4) * (4 * width) + std::size_t(4 * column + k % 4))];
                return color / 16.0;
            };
            const double here = wanted(x, y);
            if (std::abs(wanted(x + 1, y) - here) + std::abs(wanted(x, y + 1) - here) < 20.0) continue;
            sum += std::abs(picture[3 * (std::size_t(y) * width + std::size_t(x))] - here);
            ++count;
        }
    EXPECT_GT(count, 100);
    return sum / count;
}

TEST(HeadlessRenderer, APassOverThePictureSmoothsEdgesAsSamplesDo) {
    LoadedScene scene = test::boxes_on_plane(3);
    const BodyId ball = scene.world.create_body(test::body_at({0.0, 3.0, 0.0}));
    scene.world.add_shape(ball, Sphere{1.0f});
    FrameOptions options;
    options.shadows = options.grid = false;
    double samples = 0.0, edges = 0.0;
    for (const double angle : {0.1, 0.8, 2.0, 4.5}) {
        const CameraPose pose{{9.0 * std::sin(angle), 4.0, 9.0 * std::cos(angle)}, {0.0, 1.5, 0.0}};
        const RenderFrame frame = make_frame(scene.world, {}, pose, options);
        HeadlessRenderer renderer(width, height), large(4 * width, 4 * height);
        large.draw(frame);
        renderer.draw(frame);
        samples += error_at_edges(renderer.pixels(), large.pixels());
        renderer.draw(frame, Smoothing::edges);
        edges += error_at_edges(renderer.pixels(), large.pixels());
    }
    EXPECT_LT(edges, 1.85 * samples) << edges << " and " << samples; // the ratio is 2.16 without the pass, 1.67 with it
}

// Processor time of a frame with that many bodies, ms; the minimum of several frames.
double time_of_frame(int bodies) {
    LoadedScene scene = test::boxes_on_plane(0);
    for (int i = 0; i < bodies; ++i) {
        const BodyId body = scene.world.create_body(
            test::body_at({0.6 * (i % 10) - 3.0, 0.3 + 0.55 * double(i / 100), 0.6 * (i / 10 % 10) - 3.0}));
        if (i % 2)
            scene.world.add_shape(body, Sphere{0.25f});
        else
            scene.world.add_shape(body, Box{Vec3(0.25f)});
    }
    const RenderFrame frame = make_frame(scene.world, {}, {{8.0, 8.0, 12.0}, {0.0, 2.0, 0.0}});
    HeadlessRenderer renderer(1280, 720);
    renderer.draw(frame, Smoothing::edges); // compiles shaders
    double least = 1e9;
    for (int i = 0; i < 5; ++i) {
        const std::clock_t before = std::clock(); // of all threads
        renderer.draw(frame, Smoothing::edges);
        least = std::min(least, 1e3 * double(std::clock() - before) / CLOCKS_PER_SEC);
    }
    return least;
}

// With software OpenGL, a window must do this thirty times per second. The time is compared with that of ten bodies, as
// the same machine is sometimes slower by half.
TEST(HeadlessRenderer, AThousandBodiesAreDrawnInTime) {
    if (cairn_test::is_sanitized) GTEST_SKIP() << "sanitizers take longer";
    if (opengl_renderer().find("llvmpipe") == std::string::npos) GTEST_SKIP() << "the processor does not draw";
    const double ten = time_of_frame(10), thousand = time_of_frame(1000);
    std::printf("%.0f ms of processor time, %.0f with ten bodies\n", thousand, ten);
    EXPECT_LT(thousand, 3 * ten);
    EXPECT_LT(thousand, 1000);
}

TEST(HeadlessRenderer, HalfOfThePixelsGiveThePictureInLessTime) {
    const LoadedScene scene = test::boxes_on_plane(3);
    const RenderFrame frame = make_frame(scene.world, scene.appearances, scene.camera);
    HeadlessRenderer whole(width, height), half(width, height);
    const auto time_of = [&](HeadlessRenderer& renderer, float scale) {
        renderer.draw(frame, Smoothing::edges, scale); // compiles shaders
        const std::clock_t before = std::clock();
        for (int i = 0; i < 3; ++i) renderer.draw(frame, Smoothing::edges, scale);
        return double(std::clock() - before);
    };
    const double whole_time = time_of(whole, 1.0f), half_time = time_of(half, 0.5f);
    double difference = 0.0; // of color values, 0 to 255
    for (std::size_t i = 0; i < whole.pixels().size(); ++i)
        difference += std::abs(double(whole.pixels()[i]) - double(half.pixels()[i])) / double(whole.pixels().size());
    EXPECT_LT(difference, 2.0);
    EXPECT_GT(difference, 0.0);
    const bool may_be_timed = !cairn_test::is_sanitized && opengl_renderer().find("llvmpipe") != std::string::npos;
    if (may_be_timed) {
        EXPECT_LT(half_time, whole_time);
    }
}

TEST(HeadlessRenderer, SameFrameGivesTheSamePicture) {
    const LoadedScene scene = test::boxes_on_plane(3);
    const RenderFrame frame = make_frame(scene.world, scene.appearances, scene.camera);
    HeadlessRenderer one(width, height), other(width, height);
    other.draw(frame);
    const std::vector<std::uint8_t> picture = other.pixels();
    one.draw(frame);
    EXPECT_EQ(one.pixels(), picture);
    other.draw(frame);
    EXPECT_EQ(other.pixels(), picture);
}

TEST(HeadlessRenderer, EmptyWorldIsDrawnToo) {
    const World world;
    HeadlessRenderer renderer(width, height);
    renderer.draw(make_frame(world, {}, fit_camera(world)));
    EXPECT_GT(mean(renderer, 0.5, 0.1).sum(), 100.0);
}

TEST(HeadlessRenderer, RefusesImpossibleSizes) {
    EXPECT_THROW(HeadlessRenderer(0, 720), Error);
    EXPECT_THROW(HeadlessRenderer(1280, 100000), Error);
}

TEST(HeadlessRenderer, SavesPngInNewFoldersAndLeavesNoTemporaries) {
    const Folder folder;
    const fs::path path = folder.path / "picture.png";
    const LoadedScene scene = test::boxes_on_plane(1);
    HeadlessRenderer renderer(width, height);
    renderer.draw(make_frame(scene.world, {}, scene.camera));
    renderer.save_picture(path);
    std::ifstream file(path, std::ios::binary);
    std::string start(8, '\0');
    file.read(start.data(), 8);
    EXPECT_EQ(start, "\x89PNG\r\n\x1a\n");
    EXPECT_EQ(std::distance(fs::directory_iterator(path.parent_path()), fs::directory_iterator()), 1);
}

TEST(HeadlessRenderer, APathThatCannotBeWrittenIsAnErrorThatNamesIt) {
    const Folder folder;
    std::ofstream(folder.path / "file") << "not a folder";
    const HeadlessRenderer renderer(width, height);
    try {
        renderer.save_picture(folder.path / "file" / "picture.png");
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::io);
        EXPECT_NE(std::string(error.what()).find("picture.png"), std::string::npos);
    }
}

} // namespace
