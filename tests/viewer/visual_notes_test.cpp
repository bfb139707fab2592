// The visual meshes of a scene in the notes of a recording.
#include "viewer/visual_notes.h"

#include "picture_files.h"
#include "test_scene.h"

#include <gtest/gtest.h>

#include <random>

namespace {

using namespace cairn;
using namespace cairn::viewer;

std::shared_ptr<const ShapeMesh> mesh_of_triangles(int triangles) {
    std::vector<Vec3> vertices;
    std::vector<std::uint32_t> indices;
    for (int i = 0; i < 3 * triangles; ++i) {
        vertices.push_back({0.1f * float(i), float(i % 3), 0.3f * float(i * i % 5)});
        indices.push_back(std::uint32_t(i));
    }
    return std::make_shared<const ShapeMesh>(
        make_shape_mesh(visual_triangles(vertices, {}, indices), MeshVisual::visual));
}

struct VisualNotes : testing::Test {
    LoadedScene scene = test::boxes_on_plane(2);
    std::vector<Visual> visuals;
    void SetUp() override {
        const auto shared = mesh_of_triangles(7);
        const std::vector<BodyId> bodies = scene.world.bodies();
        visuals.push_back({bodies[1], {{0.1, 1.0 / 3.0, -2.0}, Quat(0.6f, 0.0f, 0.8f, 0.0f)}, shared, {0.1f, 0.2f, 1}});
        visuals.push_back({bodies[2], {}, shared, {1.0f, 0.0f, 0.0f}});
        visuals.push_back({BodyId(), {{5, 6, 7}, Quat(1, 0, 0, 0)}, mesh_of_triangles(1), {0.5f, 0.5f, 0.5f}});
    }
};

TEST_F(VisualNotes, ComeBackAsTheyWere) {
    const Notes notes = notes_of(visuals, scene.world);
    EXPECT_EQ(notes.size(), 3u) << "two meshes, and where they are";
    const std::vector<Visual> back = visuals_of(notes, scene.world);
    ASSERT_EQ(back.size(), visuals.size());
    for (std::size_t i = 0; i < back.size(); ++i) {
        EXPECT_EQ(back[i].body, visuals[i].body);
        EXPECT_EQ(back[i].local.position, visuals[i].local.position);
        EXPECT_EQ(back[i].local.rotation, visuals[i].local.rotation);
        EXPECT_EQ(back[i].color, visuals[i].color);
        EXPECT_EQ(back[i].mesh->look, MeshVisual::visual);
        const TriangleMesh &before = visuals[i].mesh->triangles, &now = back[i].mesh->triangles;
        EXPECT_EQ(now.indices, before.indices);
        ASSERT_EQ(now.vertices.size(), before.vertices.size());
        for (std::size_t k = 0; k < now.vertices.size(); ++k) {
            EXPECT_EQ(now.vertices[k].corner, before.vertices[k].corner);
            EXPECT_EQ(now.vertices[k].normal, before.vertices[k].normal);
        }
    }
    EXPECT_EQ(back[0].mesh, back[1].mesh);
}

// Gives the first mesh a texture, and makes both bodies and the ground its bones.
void dress(std::vector<Visual>& visuals) {
    ShapeMesh mesh = *visuals[0].mesh;
    TextureStyle style{TextureStyle::Wrap::clamp, TextureStyle::Wrap::mirror, false, 0.25f};
    mesh.texture = std::make_shared<const TexturePicture>(read_texture(test::shared(test::four_texels()), style));
    TextureStyle of_data;
    of_data.is_data = true;
    const auto data = std::make_shared<const TexturePicture>(read_texture(test::shared(test::four_texels()), of_data));
    mesh.finish = std::make_shared<const Finish>(Finish{0.3f, 0.7f, data, nullptr, 0.5f, {0.1f, 0.2f, 1}, 3, data});
    std::uint16_t count = 0;
    for (MeshVertex& vertex : mesh.triangles.vertices) {
        vertex.inset = {0.1f * float(count), 1.0f / 3.0f, 0.0f};
        mesh.weights.push_back({{std::uint16_t(count % 3), std::uint16_t((count + 1) % 3), 0, 0}, {0.3f, 0.7f, 0, 0}});
        mesh.triangles.colors.emplace_back(0.01f * float(count), 1.0f / 3.0f, 1.0f);
        ++count;
    }
    visuals.push_back({BodyId(), {}, std::make_shared<const ShapeMesh>(std::move(mesh)), {1, 1, 1}});
    visuals.back().bones = {{visuals[0].body, glm::dmat3(0.1, 0.2, 0.3, 4, 5, 6, 7, 8, 1.0 / 9.0), {1, 2, 1.0 / 3.0}},
                            {visuals[1].body, glm::dmat3(2.0), {}},
                            {BodyId(), glm::dmat3(1.0), {4, 5, 6}}};
}

TEST_F(VisualNotes, OfTexturesAndBonesComeBackAsTheyWere) {
    dress(visuals);
    const std::vector<Visual> back = visuals_of(notes_of(visuals, scene.world), scene.world);
    ASSERT_EQ(back.size(), 4u);
    EXPECT_FALSE(back[0].mesh->texture);
    EXPECT_TRUE(back[0].bones.empty());
    const Visual &now = back[3], &before = visuals[3];
    ASSERT_TRUE(now.mesh->texture);
    EXPECT_EQ(now.mesh->texture->texels, before.mesh->texture->texels);
    EXPECT_EQ(*now.mesh->texture->file, *before.mesh->texture->file);
    EXPECT_EQ(now.mesh->texture->style.wrap_u, TextureStyle::Wrap::clamp);
    EXPECT_EQ(now.mesh->texture->style.wrap_v, TextureStyle::Wrap::mirror);
    EXPECT_FALSE(now.mesh->texture->style.is_smooth);
    EXPECT_EQ(now.mesh->texture->style.alpha_cutoff, 0.25f);
    EXPECT_EQ(now.mesh->triangles.colors, before.mesh->triangles.colors);
    ASSERT_TRUE(now.mesh->finish);
    const Finish &found = *now.mesh->finish, &given = *before.mesh->finish;
    EXPECT_EQ(found.roughness, given.roughness);
    EXPECT_EQ(found.metalness, given.metalness);
    EXPECT_EQ(found.normal_scale, given.normal_scale);
    EXPECT_EQ(found.glow, given.glow);
    EXPECT_EQ(found.glow_strength, given.glow_strength);
    EXPECT_FALSE(found.normals);
    ASSERT_TRUE(found.rough);
    EXPECT_TRUE(found.rough->style.is_data);
    EXPECT_EQ(found.rough, found.glows) << "one picture";
    EXPECT_FALSE(now.mesh->texture->style.is_data);
    for (std::size_t i = 0; i < before.mesh->weights.size(); ++i) {
        EXPECT_EQ(now.mesh->triangles.vertices[i].inset, before.mesh->triangles.vertices[i].inset);
        EXPECT_EQ(now.mesh->weights[i].bones, before.mesh->weights[i].bones);
        EXPECT_EQ(now.mesh->weights[i].shares, before.mesh->weights[i].shares);
    }
    ASSERT_EQ(now.bones.size(), 3u);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(now.bones[i].body, before.bones[i].body);
        EXPECT_EQ(now.bones[i].linear, before.bones[i].linear);
        EXPECT_EQ(now.bones[i].translation, before.bones[i].translation);
    }
    const Notes notes = notes_of(visuals, scene.world);
    scene.world.destroy_body(visuals[1].body);
    EXPECT_EQ(visuals_of(notes, scene.world).size(), 2u) << "one of its bones is gone";
}

TEST_F(VisualNotes, OfBodiesThatAreThere) {
    const Notes notes = notes_of(visuals, scene.world);
    scene.world.destroy_body(visuals[0].body);
    EXPECT_EQ(visuals_of(notes, scene.world).size(), 2u);
    EXPECT_EQ(visuals_of(notes_of(visuals, scene.world), scene.world).size(), 2u);
    EXPECT_TRUE(notes_of({}, scene.world).empty());
    EXPECT_TRUE(visuals_of({}, scene.world).empty());
}

TEST_F(VisualNotes, AreLeftOutWhereTheyAreTooLarge) {
    EXPECT_TRUE(notes_of(visuals, scene.world, 900).empty());
    EXPECT_FALSE(notes_of(visuals, scene.world, 10000).empty());
}

TEST_F(VisualNotes, WhatMakesNoSenseIsLeftOut) {
    dress(visuals);
    const Notes good = notes_of(visuals, scene.world);
    std::mt19937 random(3);
    for (int round = 0; round < 3000; ++round) {
        Notes notes = good;
        auto note = notes.begin();
        std::advance(note, random() % notes.size());
        std::string& text = note->second;
        if (random() % 4 == 0)
            text.resize(random() % text.size());
        else
            for (unsigned i = random() % 4; i < 4; ++i) text[random() % text.size()] = "09AZ-. e+/\n"[random() % 11];
        for (const Visual& visual : visuals_of(notes, scene.world)) {
            ASSERT_TRUE(visual.mesh);
            for (const std::uint32_t index : visual.mesh->triangles.indices)
                ASSERT_LT(index, visual.mesh->triangles.vertices.size());
            ASSERT_EQ(visual.mesh->weights.empty(), visual.bones.empty());
            for (const BoneWeights& weights : visual.mesh->weights)
                for (const std::uint16_t bone : weights.bones) ASSERT_LT(bone, visual.bones.size());
        }
    }
    Notes cut = good;
    cut["mesh 0"].resize(100);
    EXPECT_EQ(visuals_of(cut, scene.world).size(), 2u);
}

} // namespace
