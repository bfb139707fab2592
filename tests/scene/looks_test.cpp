// Textures, and skinned meshes that deform with several bodies.
#include "mesh_text.h"

#include "scene/animation.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cctype>
#include <cmath>
#include <random>
#include <set>

namespace {

using namespace cairn;
using namespace cairn::scene_test;
using Json = nlohmann::json;

// Two by two texels: red, green, blue, and a translucent white.
const std::string picture_text = "iVBORw0KGgoAAAANSUhEUgAAAAIAAAACCAYAAABytg0kAAAAE0lEQVR42mP4z8DwHwyBNAgwAABIyQj4xTT9"
                                 "BQAAAABJRU5ErkJggg==";
const std::string picture_uri = R"({"uri":"data:image/png;base64,)" + picture_text + R"("})";

const std::vector<float> square{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
const std::vector<float> square_coordinates{0, 1, 1, 1, 1, 0, 0, 0};
const std::vector<std::uint16_t> square_corners{0, 1, 2, 0, 2, 3};

struct TexturedParts : MeshParts {
    std::string material = R"({"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}})";
    std::string images = picture_uri, samplers = "{}", texture = R"({"source":0,"sampler":0})";
    std::vector<float> coordinates = square_coordinates;
    bool has_coordinates = true;

    std::string text() {
        const int places = positions(square);
        std::string attributes = R"({"POSITION":)" + std::to_string(places);
        if (has_coordinates) {
            const int at = accessor(view(packed(coordinates)), 5126, coordinates.size() / 2, "VEC2");
            attributes += R"(,"TEXCOORD_0":)" + std::to_string(at) + R"(,"TEXCOORD_1":)" + std::to_string(at);
        }
        const int corners = indices(square_corners);
        meshes = R"({"primitives":[{"material":0,"attributes":)" + attributes + R"(},"indices":)" +
                 std::to_string(corners) + "}]}";
        nodes = R"({"mesh":0})";
        more = R"(,"materials":[)" + material + R"(],"images":[)" + images + R"(],"samplers":[)" + samplers +
               R"(],"textures":[)" + texture + "]";
        return MeshParts::text();
    }
};

TEST(SceneTextures, AreThePicturesOfTheFileWithTheirCoordinates) {
    TexturedParts parts;
    parts.samplers = R"({"magFilter":9728,"wrapS":33071,"wrapT":33648})";
    parts.material = R"({"alphaMode":"MASK","pbrMetallicRoughness":{"baseColorFactor":[1,0.5,0.25,1],
        "baseColorTexture":{"index":0}}})";
    const scene::Scene scene = load_text(parts.text());
    ASSERT_EQ(scene.visuals.size(), 1u);
    const scene::VisualMesh& visual = scene.visuals[0];
    EXPECT_EQ(visual.color, Vec3(1.0f, 0.5f, 0.25f));
    ASSERT_TRUE(visual.texture);
    EXPECT_EQ(base64(*visual.texture->file), picture_text);
    EXPECT_EQ(visual.texture->wrap_u, scene::Texture::Wrap::clamp);
    EXPECT_EQ(visual.texture->wrap_v, scene::Texture::Wrap::mirror);
    EXPECT_FALSE(visual.texture->is_smooth);
    EXPECT_EQ(visual.texture->alpha_cutoff, 0.5f);
    ASSERT_EQ(visual.surface->coordinates.size(), 4u);
    for (std::size_t i = 0; i < 4; ++i)
        EXPECT_EQ(visual.surface->coordinates[i], glm::vec2(square_coordinates[2 * i], square_coordinates[2 * i + 1]));
    EXPECT_TRUE(scene.warnings.empty() || scene.warnings[0].find("no body") != std::string::npos);
}

// KHR_texture_transform defines the order: scale, then rotation, then offset.
TEST(SceneTextures, AreMovedTurnedAndScaled) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> number(-3.0, 3.0);
    for (int round = 0; round < 20; ++round) {
        const double u0 = number(random), v0 = number(random), su = number(random), sv = number(random),
                     angle = number(random);
        TexturedParts parts;
        parts.material = R"({"pbrMetallicRoughness":{"baseColorTexture":{"index":0,"texCoord":7,"extensions":{
            "KHR_texture_transform":{"texCoord":1,"offset":[)" +
                         std::to_string(u0) + "," + std::to_string(v0) + R"(],"rotation":)" + std::to_string(angle) +
                         R"(,"scale":[)" + std::to_string(su) + "," + std::to_string(sv) + "]}}}}}";
        const scene::Scene scene = load_text(parts.text());
        ASSERT_TRUE(scene.visuals.at(0).texture);
        for (std::size_t i = 0; i < 4; ++i) {
            const glm::dvec3 at(square_coordinates[2 * i], square_coordinates[2 * i + 1], 1.0);
            const glm::dmat3 offset(1, 0, 0, 0, 1, 0, u0, v0, 1); // in columns, as in the extension's text
            const glm::dmat3 turn(std::cos(angle), -std::sin(angle), 0, std::sin(angle), std::cos(angle), 0, 0, 0, 1);
            const glm::dmat3 scale(su, 0, 0, 0, sv, 0, 0, 0, 1);
            const glm::dvec3 expected = offset * turn * scale * at;
            const glm::vec2 found = scene.visuals[0].surface->coordinates[i];
            EXPECT_NEAR(double(found.x), expected.x, 1e-5);
            EXPECT_NEAR(double(found.y), expected.y, 1e-5);
        }
    }
}

// A scene is never rejected because of its textures, and a warning explains why a mesh is gray.
TEST(SceneTextures, ThatCannotBeReadAreALineOfWarningAndGray) {
    struct Case {
        const char* what;
        void (*change)(TexturedParts&);
    };
    const Case cases[] = {
        {"is neither a PNG nor a JPEG picture", [](TexturedParts& p) { p.images = R"({"uri":"data:;base64,AAAA"})"; }},
        {"other files cannot be read", [](TexturedParts& p) { p.images = R"({"uri":"wood.png"})"; }},
        {"must have a member \"bufferView\"", [](TexturedParts& p) { p.images = "{}"; }},
        {"has no TEXCOORD_0", [](TexturedParts& p) { p.has_coordinates = false; }},
        {"as many elements as POSITION", [](TexturedParts& p) { p.coordinates.resize(6); }},
        {"finite", [](TexturedParts& p) { p.coordinates[3] = std::nanf(""); }},
        {"has no picture in PNG or JPEG", [](TexturedParts& p) { p.texture = "{}"; }},
        {"textures", [](TexturedParts& p) { p.texture = ""; }},
        {"wrapS", [](TexturedParts& p) { p.samplers = R"({"wrapS":3})"; }},
    };
    for (const Case& wrong : cases) {
        TexturedParts parts;
        wrong.change(parts);
        const scene::Scene scene = load_text(parts.text());
        ASSERT_EQ(scene.visuals.size(), 1u) << wrong.what;
        EXPECT_FALSE(scene.visuals[0].texture) << wrong.what;
        EXPECT_EQ(scene.visuals[0].color, Vec3(0.4f)) << wrong.what;
        ASSERT_FALSE(scene.warnings.empty()) << wrong.what;
        EXPECT_NE(scene.warnings[0].find(wrong.what), std::string::npos) << scene.warnings[0];
        EXPECT_NE(scene.warnings[0].find("(its texture is not shown: a plain gray"), std::string::npos);
    }
}

// A skinned mesh: one body carries its lower half, another its upper half, and both carry the middle. The bones are
// nodes below these bodies, rotated and scaled, with a different bind pose.
struct BentParts : MeshParts {
    std::vector<std::uint8_t> joints;
    std::vector<float> shares, bindings;
    std::string skin_nodes = "2,4,5";

    explicit BentParts(std::uint32_t seed) {
        std::mt19937 random(seed);
        std::uniform_real_distribution<float> number(-1.0f, 1.0f);
        for (int vertex = 0; vertex < 4; ++vertex) {
            float rest = 1.0f;
            for (int k = 0; k < 4; ++k) {
                joints.push_back(std::uint8_t(k < 3 ? k : 0));
                const float share = k == 2 ? rest : k == 3 ? 0.0f : rest * (0.5f + 0.5f * number(random));
                shares.push_back(share);
                rest -= share;
            }
        }
        for (int bone = 0; bone < 3; ++bone)
            for (int column = 0; column < 4; ++column)
                for (int row = 0; row < 4; ++row)
                    bindings.push_back(row == 3 ? (column == 3 ? 1.0f : 0.0f) : number(random));
        nodes = R"({"mesh":0,"skin":0,"translation":[9,9,9]},)"
                R"({"translation":[1,2,3],"rotation":[0.5,0.5,-0.5,0.5],"children":[2],"extensions":
                {"KHR_physics_rigid_bodies":{"motion":{},"collider":{"geometry":{"shape":0}}}}},)"
                R"({"translation":[0.1,0.2,-0.3],"scale":[2,0.5,1]},)"
                R"({"translation":[-4,0,1],"children":[4],"extensions":
                {"KHR_physics_rigid_bodies":{"motion":{"isKinematic":true},"collider":{"geometry":{"shape":0}}}}},)"
                R"({"rotation":[0,0.6,0,0.8]},{"translation":[0,0,5]})";
        roots = "0,1,3,5";
        shapes = R"({"type":"sphere","sphere":{"radius":0.5}})";
    }
    std::string text() {
        const int places = positions(square), corners = indices(square_corners);
        const int numbers = accessor(view(packed(joints)), 5121, joints.size() / 4, "VEC4");
        const int weights = accessor(view(packed(shares)), 5126, shares.size() / 4, "VEC4");
        const int matrices = accessor(view(packed(bindings)), 5126, bindings.size() / 16, "MAT4");
        meshes = R"({"primitives":[{"attributes":{"POSITION":)" + std::to_string(places) + R"(,"JOINTS_0":)" +
                 std::to_string(numbers) + R"(,"WEIGHTS_0":)" + std::to_string(weights) + R"(},"indices":)" +
                 std::to_string(corners) + "}]}";
        more =
            R"(,"skins":[{"joints":[)" + skin_nodes + R"(],"inverseBindMatrices":)" + std::to_string(matrices) + "}]";
        return MeshParts::text();
    }
};

// The positions of the vertices according to the bones of the visual.
std::vector<glm::dvec3> vertices_now(const scene::Scene& scene, const scene::VisualMesh& visual) {
    std::vector<glm::dvec3> places;
    for (std::size_t i = 0; i < visual.surface->vertices.size(); ++i) {
        glm::dvec3 sum(0.0);
        for (std::size_t k = 0; k < 4; ++k) {
            const scene::BoneWeights& weights = visual.surface->weights[i];
            const scene::Bone& bone = visual.bones[weights.bones[k]];
            glm::dvec3 at = bone.linear * glm::dvec3(visual.surface->vertices[i]) + bone.translation;
            if (!bone.body.is_null()) {
                const Body body = scene.world.body(bone.body);
                at = body.position() + glm::dquat(body.rotation()) * at;
            }
            sum += double(weights.shares[k]) * at;
        }
        places.push_back(sum);
    }
    return places;
}

glm::dmat4 matrix(const glm::dvec3& translation, const glm::dquat& rotation, const glm::dvec3& scale) {
    glm::dmat4 m(glm::mat3_cast(rotation));
    for (int i = 0; i < 3; ++i) m[i] *= scale[i];
    m[3] = glm::dvec4(translation, 1.0);
    return m;
}

TEST(SceneSkins, CarryVerticesAsTheFormatSays) {
    for (std::uint32_t seed = 1; seed <= 10; ++seed) {
        BentParts parts(seed);
        scene::Scene scene = load_text(parts.text());
        ASSERT_EQ(scene.visuals.size(), 1u);
        EXPECT_TRUE(scene.visuals[0].body.is_null());
        ASSERT_EQ(scene.visuals[0].bones.size(), 3u);
        EXPECT_TRUE(scene.visuals[0].bones[2].body.is_null());
        // Computed from the file's numbers with 4 x 4 matrices (glTF 2.0, section 3.7.3.3), after a body has been
        // moved.
        const glm::dvec3 unit(1.0), none(0.0);
        const glm::dquat still(1, 0, 0, 0), elsewhere = glm::normalize(glm::dquat(0.3, -0.5, 0.2, 0.7));
        Body moved = scene.world.body(scene.visuals[0].bones[0].body);
        moved.set_transform({-3, 7, 2}, Quat(elsewhere));
        const glm::dmat4 nodes[] = {matrix({-3, 7, 2}, glm::dquat(Quat(elsewhere)), unit) *
                                        matrix({0.1, 0.2, -0.3}, still, {2, 0.5, 1}),
                                    matrix({-4, 0, 1}, still, unit) * matrix(none, glm::dquat(0.8, 0, 0.6, 0), unit),
                                    matrix({0, 0, 5}, still, unit)};
        const std::vector<glm::dvec3> found = vertices_now(scene, scene.visuals[0]);
        for (std::size_t i = 0; i < 4; ++i) {
            const glm::dvec4 vertex(square[3 * i], square[3 * i + 1], square[3 * i + 2], 1.0);
            glm::dvec4 expected(0.0);
            for (std::size_t k = 0; k < 3; ++k) {
                glm::dmat4 binding;
                for (int n = 0; n < 16; ++n) binding[n / 4][n % 4] = double(parts.bindings[16 * k + std::size_t(n)]);
                expected += double(parts.shares[4 * i + k]) * (nodes[k] * binding * vertex);
            }
            EXPECT_LT(glm::length(found[i] - glm::dvec3(expected)), 1e-5) << seed << " " << i;
        }
    }
}

TEST(SceneSkins, AndTexturesAreTheSameAfterBeingSaved) {
    BentParts parts(3);
    scene::Scene scene = load_text(parts.text());
    TexturedParts textured;
    textured.material = R"({"alphaMode":"MASK","alphaCutoff":0.25,"pbrMetallicRoughness":{
        "baseColorFactor":[1,0.5,0.25,1],"baseColorTexture":{"index":0}}})";
    textured.samplers = R"({"wrapS":33071,"wrapT":33648})";
    scene::VisualMesh covered = load_text(textured.text()).visuals.at(0);
    scene.visuals.push_back(covered);
    covered.body = scene.visuals[0].bones[0].body;
    scene.visuals.push_back(covered);
    for (int i = 0; i < 20; ++i) scene.world.step(1.0f / 60.0f);
    const std::string saved = scene::save_to_string(scene);
    const scene::Scene again = load_text(saved);
    EXPECT_EQ(scene::save_to_string(again), saved);
    EXPECT_TRUE(again.warnings.empty()) << again.warnings[0];
    ASSERT_EQ(again.visuals.size(), 3u);
    std::size_t bent = 0, with_texture = 0;
    for (const scene::VisualMesh& visual : again.visuals) {
        if (!visual.bones.empty()) {
            ++bent;
            const std::vector<glm::dvec3> before = vertices_now(scene, scene.visuals[0]),
                                          now = vertices_now(again, visual);
            for (std::size_t i = 0; i < 4; ++i) EXPECT_LT(glm::length(before[i] - now[i]), 1e-5);
            continue;
        }
        ++with_texture;
        ASSERT_TRUE(visual.texture);
        EXPECT_EQ(*visual.texture->file, *covered.texture->file);
        EXPECT_EQ(visual.texture->wrap_u, covered.texture->wrap_u);
        EXPECT_EQ(visual.texture->wrap_v, covered.texture->wrap_v);
        EXPECT_EQ(visual.texture->is_smooth, covered.texture->is_smooth);
        EXPECT_EQ(visual.texture->alpha_cutoff, 0.25f);
        EXPECT_EQ(visual.surface->coordinates, covered.surface->coordinates);
        EXPECT_EQ(visual.color, covered.color);
    }
    EXPECT_EQ(bent, 1u);
    EXPECT_EQ(with_texture, 2u);
    EXPECT_EQ(Json::parse(saved)["images"].size(), 1u);
    // Removes the visuals that this body carries, wholly or in part.
    scene.world.destroy_body(scene.visuals[0].bones[0].body);
    EXPECT_EQ(load_text(scene::save_to_string(scene)).visuals.size(), 1u);
}

TEST(SceneSkins, AreInAnimatedFiles) {
    BentParts parts(5);
    scene::Scene scene = load_text(parts.text());
    TexturedParts textured;
    scene.visuals.push_back(load_text(textured.text()).visuals.at(0));
    scene::AnimationBaker baker(scene);
    for (int i = 0; i < 5; ++i) {
        baker.add(scene.world);
        scene.world.step(1.0f / 60.0f);
    }
    const Json json = Json::parse(baker.text());
    ASSERT_EQ(json["skins"].size(), 1u);
    const Json& joints = json["skins"][0]["joints"];
    ASSERT_EQ(joints.size(), 3u);
    std::set<std::size_t> animated;
    for (const Json& channel : json["animations"][0]["channels"])
        animated.insert(channel["target"]["node"].get<std::size_t>());
    EXPECT_EQ(animated.count(joints[0]), 1u) << "the body that falls";
    EXPECT_EQ(animated.count(joints[1]), 0u) << "the one that stands";
    EXPECT_LT(std::size_t(joints[2]), json["nodes"].size());
    std::size_t meshes = 0, with_skin = 0;
    for (const Json& node : json["nodes"]) meshes += node.contains("mesh"), with_skin += node.contains("skin");
    EXPECT_EQ(meshes, 2u) << "no shapes: the mesh stands for them";
    EXPECT_EQ(with_skin, 1u);
    EXPECT_EQ(json["images"].size(), 1u);
    const scene::Scene again = load_text(baker.text());
    EXPECT_EQ(again.visuals.size(), 2u);
}

// However a file is damaged, it is rejected with an error, or its bones and texture coordinates are consistent.
TEST(SceneSkins, AndTexturesOfDamagedFilesFitOrAreRefused) {
    BentParts parts(2);
    scene::Scene scene = load_text(parts.text());
    TexturedParts textured;
    scene.visuals.push_back(load_text(textured.text()).visuals.at(0));
    const std::string good = scene::save_to_string(scene);
    std::mt19937 random(9);
    std::size_t loaded = 0;
    for (int round = 0; round < 4000; ++round) {
        std::string text = good;
        for (unsigned i = random() % 3; i < 3; ++i) {
            char& c = text[random() % text.size()];
            c = std::isdigit(c) && random() % 2 == 0 ? char('0' + random() % 10) : char(32 + random() % 95);
        }
        try {
            const scene::Scene now = load_text(text);
            ++loaded;
            for (const scene::VisualMesh& visual : now.visuals) {
                const scene::Surface& surface = *visual.surface;
                ASSERT_EQ(visual.bones.empty(), surface.weights.empty());
                ASSERT_TRUE(!visual.texture || surface.coordinates.size() == surface.vertices.size());
                if (!visual.bones.empty()) {
                    ASSERT_EQ(vertices_now(now, visual).size(), surface.weights.size());
                }
                for (const scene::BoneWeights& weights : surface.weights)
                    for (const std::uint16_t bone : weights.bones) ASSERT_LT(bone, visual.bones.size());
            }
            load_text(scene::save_to_string(now));
        } catch (const Error& error) {
            ASSERT_NE(std::string(error.what()).find("test.gltf: "), std::string::npos) << error.what();
        }
    }
    EXPECT_GT(loaded, 300u);
}

TEST(SceneSkins, ThatMakeNoSenseAreRefusedByName) {
    const auto message = [](const std::string& text) -> std::string {
        try {
            load_text(text);
        } catch (const Error& error) {
            return error.what();
        }
        return "";
    };
    BentParts parts(1);
    parts.joints[5] = 3;
    EXPECT_NE(message(parts.text()).find("must stay below the 3 joints of the skin, and does not for vertex 1"),
              std::string::npos);
    parts = BentParts(1);
    parts.shares[4] = parts.shares[5] = parts.shares[6] = 0;
    EXPECT_NE(message(parts.text()).find("must have a sum above 0 for vertex 1"), std::string::npos);
    parts = BentParts(1);
    parts.bindings.resize(32);
    EXPECT_NE(message(parts.text()).find("as many elements as joints, 3"), std::string::npos);
    parts = BentParts(1);
    parts.skin_nodes = "2,4,77";
    EXPECT_NE(message(parts.text()).find("skins[0].joints[2]"), std::string::npos);
    parts = BentParts(1);
    parts.roots = "0,1,3"; // a bone that is not in the scene
    EXPECT_NE(message(parts.text()).find("must be a node that the scene shows"), std::string::npos);
    parts = BentParts(1);
    parts.shares.resize(12);
    EXPECT_NE(message(parts.text()).find("as many elements as POSITION, 4"), std::string::npos);
}

} // namespace
