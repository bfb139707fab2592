// Vertex colors, and the reflection properties of surfaces.
#include "mesh_text.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <array>

namespace {

using namespace cairn;
using namespace cairn::scene_test;
using Json = nlohmann::json;

const std::string small_picture_uri =
    "data:image/png;base64,iVBORw0KGgoAAAANSUhEUgAAAAIAAAACCAYAAABytg0kAAAAE0lEQVR42mP4"
    "z8DwHwyBNAgwAABIyQj4xTT9BQAAAABJRU5ErkJggg==";

// A square whose material has every supported property.
struct FinishedParts : MeshParts {
    std::string material = R"({"pbrMetallicRoughness":{"baseColorTexture":{"index":0},"roughnessFactor":0.3,
        "metallicFactor":0.75,"metallicRoughnessTexture":{"index":0}},"normalTexture":{"index":0,"scale":0.5},
        "emissiveFactor":[0.1,0.2,1],"emissiveTexture":{"index":0},
        "extensions":{"KHR_materials_emissive_strength":{"emissiveStrength":3.7}}})";
    std::string colors; // the vertex attribute for colors

    std::string text() {
        const int places = positions({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0});
        const std::vector<float> at{0, 1, 1, 1, 1, 0, 0, 0};
        const int coordinates = accessor(view(packed(at)), 5126, 4, "VEC2");
        const int corners = indices({0, 1, 2, 0, 2, 3});
        const std::string attributes = R"("POSITION":)" + std::to_string(places) + R"(,"TEXCOORD_0":)" +
                                       std::to_string(coordinates) + R"(,"TEXCOORD_1":)" + std::to_string(coordinates);
        meshes = R"({"primitives":[{"material":0,"attributes":{)" + attributes + colors + R"(},"indices":)" +
                 std::to_string(corners) + "}]}";
        nodes = R"({"mesh":0})";
        more = R"(,"materials":[)" + material + R"(],"images":[{"uri":")" + small_picture_uri +
               R"("}],"textures":[{"source":0}])";
        return MeshParts::text();
    }
    scene::VisualMesh load(std::vector<std::string>& warnings) {
        scene::Scene scene = load_text(text());
        warnings = scene.warnings;
        std::erase_if(warnings, [](const std::string& line) { return line.find("no body") != std::string::npos; });
        EXPECT_EQ(scene.visuals.size(), 1u);
        return scene.visuals.at(0);
    }
};

TEST(SceneFinish, IsThatOfTheMaterial) {
    FinishedParts parts;
    std::vector<std::string> warnings;
    const scene::VisualMesh visual = parts.load(warnings);
    EXPECT_TRUE(warnings.empty()) << warnings[0];
    ASSERT_TRUE(visual.finish);
    const scene::Finish& finish = *visual.finish;
    EXPECT_EQ(finish.roughness, 0.3f);
    EXPECT_EQ(finish.metalness, 0.75f);
    EXPECT_EQ(finish.normal_scale, 0.5f);
    EXPECT_EQ(finish.glow, Vec3(0.1f, 0.2f, 1.0f));
    EXPECT_EQ(finish.glow_strength, 3.7f);
    ASSERT_TRUE(finish.normals && finish.rough && finish.glows && visual.texture);
    EXPECT_EQ(finish.normals, finish.rough) << "the same picture, read once";
    EXPECT_TRUE(finish.normals->is_data);
    EXPECT_FALSE(finish.glows->is_data);
    EXPECT_FALSE(visual.texture->is_data);
    EXPECT_EQ(visual.surface->coordinates.size(), 4u);
}

// The format's default is a rough metal. A material that does not mention these properties must not become metallic.
TEST(SceneFinish, IsNoneWhereTheMaterialSaysNothingOfIt) {
    for (const char* material : {"{}", R"({"pbrMetallicRoughness":{"baseColorFactor":[1,0,0,1]}})",
                                 R"({"pbrMetallicRoughness":{"metallicFactor":0}})", R"({"emissiveFactor":[0,0,0]})"}) {
        FinishedParts parts;
        parts.material = material;
        std::vector<std::string> warnings;
        EXPECT_FALSE(parts.load(warnings).finish) << material;
    }
    FinishedParts parts;
    parts.material = R"({"pbrMetallicRoughness":{"roughnessFactor":0.5}})";
    std::vector<std::string> warnings;
    const scene::VisualMesh visual = parts.load(warnings);
    ASSERT_TRUE(visual.finish);
    EXPECT_EQ(visual.finish->metalness, 1.0f) << "as the format says";
    EXPECT_TRUE(visual.surface->coordinates.empty());
}

TEST(SceneFinish, ThatIsDamagedIsALineOfWarning) {
    struct Case {
        const char *from, *to, *what;
        bool has_finish;
    };
    const Case cases[] = {
        {R"("scale":0.5)", R"("texCoord":1)", "must have the texCoord and the transform of the other textures", true},
        {R"("normalTexture":{"index":0)", R"("normalTexture":{"index":9)", "normalTexture.index", true},
        {R"("roughnessFactor":0.3)", R"("roughnessFactor":3)", "roughnessFactor: must be", false},
        {R"([0.1,0.2,1])", R"([0.1,0.2,9])", "emissiveFactor[2]: must be", false},
    };
    for (const Case& wrong : cases) {
        FinishedParts parts;
        parts.material.replace(parts.material.find(wrong.from), std::string(wrong.from).size(), wrong.to);
        std::vector<std::string> warnings;
        const scene::VisualMesh visual = parts.load(warnings);
        EXPECT_EQ(visual.finish != nullptr, wrong.has_finish) << wrong.to;
        EXPECT_TRUE(visual.texture) << wrong.to;
        ASSERT_EQ(warnings.size(), 1u) << wrong.to;
        EXPECT_NE(warnings[0].find(wrong.what), std::string::npos) << warnings[0];
    }
}

TEST(SceneFinish, AndColorsOfVerticesAreTheSameAfterBeingSaved) {
    FinishedParts parts;
    const std::vector<float> colors{1, 0, 0, 0, 1, 0, 0, 0, 1, 0.1f, 0.2f, 0.3f};
    parts.colors = R"(,"COLOR_0":)" + std::to_string(parts.accessor(parts.view(packed(colors)), 5126, 4, "VEC3"));
    const scene::Scene scene = load_text(parts.text());
    const std::string saved = scene::save_to_string(scene);
    const scene::Scene again = load_text(saved);
    EXPECT_EQ(scene::save_to_string(again), saved);
    ASSERT_EQ(again.visuals.size(), 1u);
    const scene::VisualMesh &before = scene.visuals[0], &now = again.visuals[0];
    ASSERT_TRUE(now.finish);
    EXPECT_EQ(now.finish->roughness, before.finish->roughness);
    EXPECT_EQ(now.finish->metalness, before.finish->metalness);
    EXPECT_EQ(now.finish->normal_scale, before.finish->normal_scale);
    EXPECT_EQ(now.finish->glow, before.finish->glow);
    EXPECT_EQ(now.finish->glow_strength, before.finish->glow_strength);
    ASSERT_TRUE(now.finish->normals && now.finish->rough && now.finish->glows);
    EXPECT_TRUE(now.finish->rough->is_data);
    EXPECT_EQ(now.surface->colors, before.surface->colors);
    const Json json = Json::parse(saved);
    EXPECT_EQ(json["images"].size(), 1u);
    EXPECT_NE(json["extensionsUsed"].dump().find("KHR_materials_emissive_strength"), std::string::npos);
}

TEST(SceneVertexColors, AreReadInAllFormsOfTheFormat) {
    const std::array<Vec3, 4> expected{Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0.2f, 0.4f, 0.6f), Vec3(0, 0, 0)};
    for (const int channels : {3, 4})
        for (const int type : {5126, 5121, 5123}) {
            FinishedParts parts;
            std::vector<float> floats;
            std::vector<std::uint8_t> bytes;
            std::vector<std::uint16_t> shorts;
            for (const Vec3& color : expected)
                for (int i = 0; i < channels; ++i) {
                    const float part = i < 3 ? color[i] : 0.5f;
                    floats.push_back(part), bytes.push_back(std::uint8_t(part * 255.0f + 0.5f));
                    shorts.push_back(std::uint16_t(part * 65535.0f + 0.5f));
                }
            const std::string data = type == 5126 ? packed(floats) : type == 5121 ? packed(bytes) : packed(shorts);
            const int at = parts.accessor(parts.view(data), type, 4, channels == 3 ? "VEC3" : "VEC4",
                                          type == 5126 ? "" : R"(,"normalized":true)");
            parts.colors = R"(,"COLOR_0":)" + std::to_string(at);
            std::vector<std::string> warnings;
            const scene::VisualMesh visual = parts.load(warnings);
            EXPECT_TRUE(warnings.empty()) << warnings[0];
            ASSERT_EQ(visual.surface->colors.size(), 4u) << type;
            for (std::size_t i = 0; i < 4; ++i)
                EXPECT_LT(glm::length(visual.surface->colors[i] - expected[i]), 1e-5f) << type << " " << channels;
        }
}

TEST(SceneVertexColors, ThatMakeNoSenseAreALineOfWarning) {
    const std::vector<float> nine(9, 0.5f), twelve{1, 0, 0, 0, 1, 0, 0, 0, 1, 0.1f, std::nanf(""), 0.3f};
    struct Case {
        const char* what;
        int type;
        std::vector<float> numbers;
    };
    for (const Case& wrong :
         {Case{"must have as many elements as POSITION", 5126, nine}, Case{"must hold finite numbers", 5126, twelve},
          Case{"or of normalized numbers 5121 or 5123, for colors", 5121, twelve}}) {
        FinishedParts parts;
        const int at = parts.accessor(parts.view(packed(wrong.numbers)), wrong.type, wrong.numbers.size() / 3, "VEC3");
        parts.colors = R"(,"COLOR_0":)" + std::to_string(at);
        std::vector<std::string> warnings;
        EXPECT_TRUE(parts.load(warnings).surface->colors.empty()) << wrong.what;
        ASSERT_EQ(warnings.size(), 1u) << wrong.what;
        EXPECT_NE(warnings[0].find(wrong.what), std::string::npos) << warnings[0];
        EXPECT_NE(warnings[0].find("(the colors of its vertices are left out)"), std::string::npos);
    }
}

} // namespace
