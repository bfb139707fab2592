// Textures of meshes, and skinned meshes.
#include "viewer/textures.h"

#include "viewer/bending.h"
#include "viewer/render_frame.h"

#include "picture_files.h"
#include "test_scene.h"

#include <cairn/error.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <random>

namespace {

using namespace cairn;
using namespace cairn::viewer;
using test::shared;

TEST(Textures, OfPngFilesAreTheTexelsOfTheFile) {
    const TexturePicture picture = read_texture(shared(test::four_texels()), {});
    EXPECT_EQ(picture.width, 2);
    EXPECT_EQ(picture.height, 2);
    EXPECT_EQ(picture.texels,
              (std::vector<std::uint8_t>{255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 255, 255, 255, 0}));
}

TEST(Textures, OfJpegFilesAreNearlyTheColorsOfThePicture) {
    const TexturePicture picture = read_texture(shared(test::red_and_blue_jpeg()), {});
    ASSERT_EQ(picture.width, 16);
    ASSERT_EQ(picture.height, 8);
    for (const int x : {0, 4, 11, 15}) {
        const std::uint8_t* texel = &picture.texels[std::size_t(4 * (3 * 16 + x))];
        EXPECT_NEAR(texel[0], x < 8 ? 255 : 0, 3) << x;
        EXPECT_NEAR(texel[2], x < 8 ? 0 : 255, 3) << x;
        EXPECT_EQ(texel[3], 255);
    }
}

// Whatever a file contains, the result is an image, or an error that says that it cannot be read.
TEST(Textures, OfDamagedFilesAreAPictureOrAnError) {
    std::mt19937 random(11);
    for (const std::string& good : {test::four_texels(), test::red_and_blue_jpeg()}) {
        std::size_t refused = 0;
        const auto read = [&](const std::string& file) {
            try {
                const TexturePicture picture = read_texture(shared(file), {});
                ASSERT_EQ(picture.texels.size(), 4u * std::size_t(picture.width) * std::size_t(picture.height));
            } catch (const Error& error) {
                ++refused;
                ASSERT_NE(std::string(error.what()).find("texture: "), std::string::npos) << error.what();
            }
        };
        for (std::size_t size = 0; size < good.size(); ++size) read(good.substr(0, size));
        EXPECT_GT(refused, good.size() / 4);
        for (int round = 0; round < 3000; ++round) {
            std::string file = good;
            for (unsigned i = random() % 4; i < 4; ++i) file[random() % file.size()] = char(random());
            read(file);
        }
    }
    EXPECT_THROW(read_texture(nullptr, {}), Error);
    EXPECT_THROW(read_texture(shared("GIF89a"), {}), Error);
}

// A header of a few bytes must not cause an unlimited allocation.
TEST(Textures, OfTooManyPixelsAreRefused) {
    try {
        read_texture(shared(test::png_header(60'000, 60'000) + test::png_chunk("IDAT", "")), {});
        FAIL() << "nothing was thrown";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::unsupported);
        EXPECT_NE(std::string(error.what()).find("60000 x 60000"), std::string::npos) << error.what();
    }
}

TEST(Textures, WithALongEdgeAreMadeSmallerByHalves) {
    const TexturePicture picture = read_texture(
        shared(test::png_of(9000, 3,
                            [](int x, int) {
                                return std::array<std::uint8_t, 4>{std::uint8_t(x % 4 < 2 ? 0 : 200), 100, 50, 255};
                            })),
        {});
    EXPECT_EQ(picture.width, 2250);
    EXPECT_EQ(picture.height, 1);
    for (int x = 0; x < picture.width; ++x) {
        const std::uint8_t* texel = &picture.texels[std::size_t(4 * x)];
        ASSERT_EQ(texel[0], 100) << x; // the mean of four texels
        ASSERT_EQ(texel[1], 100) << x;
        ASSERT_EQ(texel[3], 255) << x;
    }
}

Quat random_rotation(std::mt19937& random) {
    std::normal_distribution<float> number;
    return glm::normalize(Quat(number(random), number(random), number(random), number(random)));
}

TEST(Bending, ByOneBoneIsItsMotionAndByTwoTheMean) {
    std::mt19937 random(5);
    std::normal_distribution<float> number;
    for (int round = 0; round < 200; ++round) {
        TriangleMesh mesh;
        for (int i = 0; i < 3; ++i)
            mesh.vertices.push_back({{number(random), number(random), number(random)},
                                     {0.25f, 0.5f, 0.0f},
                                     glm::normalize(Vec3(number(random), number(random), number(random)))});
        mesh.indices = {0, 1, 2};
        const Quat turns[] = {random_rotation(random), random_rotation(random)};
        const Vec3 moves[] = {{number(random), number(random), number(random)}, {1, 2, 3}};
        std::vector<BoneMap> bones;
        for (int k = 0; k < 2; ++k) bones.push_back({glm::mat3_cast(turns[k]), moves[k]});
        const std::vector<BoneWeights> weights{
            {{0, 0, 0, 0}, {1, 0, 0, 0}}, {{1, 0, 0, 0}, {1, 0, 0, 0}}, {{0, 1, 0, 0}, {0.25f, 0.75f, 0, 0}}};
        const TriangleMesh now = bent(mesh, weights, bones);
        Vec3 expected[3];
        for (int i = 0; i < 2; ++i) {
            expected[i] = turns[i] * mesh.vertices[std::size_t(i)].corner + moves[i];
            EXPECT_LT(
                glm::length(now.vertices[std::size_t(i)].normal - turns[i] * mesh.vertices[std::size_t(i)].normal),
                1e-5f);
        }
        const Vec3 last = mesh.vertices[2].corner;
        expected[2] = 0.25f * (turns[0] * last + moves[0]) + 0.75f * (turns[1] * last + moves[1]);
        for (int i = 0; i < 3; ++i) {
            EXPECT_LT(glm::length(now.vertices[std::size_t(i)].corner - expected[i]), 1e-5f);
            EXPECT_NEAR(glm::length(now.vertices[std::size_t(i)].normal), 1.0f, 1e-5f);
            EXPECT_EQ(now.vertices[std::size_t(i)].inset, mesh.vertices[std::size_t(i)].inset);
        }
        EXPECT_EQ(now.indices, mesh.indices);
    }
}

// A skinned mesh of two bodies, far from the origin: it is drawn between them, instead of their shapes.
TEST(Bending, InPicturesFollowsTheBodiesAndHidesTheirShapes) {
    World world;
    std::vector<Visual> visuals(1);
    Visual& visual = visuals[0];
    for (int i = 0; i < 2; ++i) {
        BodyDef def;
        def.position = {1e6 + 4.0 * i, 10.0, 0.0};
        const BodyId body = world.create_body(def);
        world.add_shape(body, Sphere{0.5f});
        visual.bones.push_back({body, glm::dmat3(1.0), {0.0, 0.0, 0.0}});
    }
    const std::vector<Vec3> corners{{0, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const std::vector<std::uint32_t> triangle{0, 1, 2};
    ShapeMesh mesh = make_shape_mesh(visual_triangles(corners, {}, triangle), MeshVisual::visual);
    mesh.weights = {{{0, 0, 0, 0}, {1, 0, 0, 0}}, {{1, 0, 0, 0}, {1, 0, 0, 0}}, {{0, 1, 0, 0}, {0.5f, 0.5f, 0, 0}}};
    visual.mesh = std::make_shared<const ShapeMesh>(std::move(mesh));
    const CameraPose camera{{1e6, 10.0, 20.0}, {1e6, 10.0, 0.0}, 0.8f};
    MeshCache meshes;
    const auto places = [&](const RenderFrame& frame) {
        std::vector<Position> result;
        for (const MeshInstances& group : frame.meshes)
            for (const Instance& instance : group.instances)
                for (const MeshVertex& vertex : group.mesh->triangles.vertices)
                    result.push_back(frame.origin + Position(instance.position) + Position(vertex.corner));
        return result;
    };
    RenderFrame frame = make_frame(world, {}, camera, {}, meshes, visuals);
    EXPECT_TRUE(frame.spheres.empty());
    std::vector<Position> found = places(frame);
    ASSERT_EQ(found.size(), 3u);
    const Position expected[] = {{1e6, 10, 0}, {1e6 + 4, 11, 0}, {1e6 + 2, 10, 1}};
    for (int i = 0; i < 3; ++i) EXPECT_LT(glm::length(found[std::size_t(i)] - expected[i]), 1e-4) << i;
    world.body(visual.bones[1].body).set_position({1e6 + 6.0, 12.0, 0.0});
    found = places(make_frame(world, {}, camera, {}, meshes, visuals));
    EXPECT_LT(glm::length(found[1] - Position(1e6 + 6, 13, 0)), 1e-4);
    FrameOptions shapes;
    shapes.visuals = false;
    EXPECT_EQ(make_frame(world, {}, camera, shapes, meshes, visuals).spheres.size(), 2u);
    world.destroy_body(visual.bones[0].body); // no body carries that part of the mesh
    frame = make_frame(world, {}, camera, {}, meshes, visuals);
    EXPECT_TRUE(places(frame).empty());
    EXPECT_EQ(frame.spheres.size(), 1u);
}

} // namespace
