#include "scene/visuals.h"

#include "scene/definitions.h"
#include "scene/document.h"

#include <cmath>

namespace cairn::scene {

namespace {

constexpr Range color_range{0.0, 1.0, false};
constexpr std::size_t max_skins = 100'000, max_bones = 65'536;
constexpr float texture_gray = 0.4f; // assumed brightness of a texture that is not shown

} // namespace

std::optional<Vec3> Visuals::own_color(const Value& node) const {
    const auto extras = node.find("extras");
    if (!extras || !extras->is_object()) return std::nullopt;
    const auto color = extras->find("cairn_color");
    return color ? std::optional(color->float_vector3(color_range)) : std::nullopt;
}

Value Visuals::material(const Value& index) const {
    return element(document_.find("materials"), index, max_definitions, "materials");
}

// Returns the base color, which is white by default.
std::optional<Vec3> Visuals::base_color(const Value& material) {
    const auto roughness = material.find("pbrMetallicRoughness");
    const auto color = roughness ? roughness->find("baseColorFactor") : std::nullopt;
    if (!color) return std::nullopt;
    if (color->size(4, "numbers") != 4) color->fail("must be an array of 4 numbers");
    return Vec3((*color)[0].real(color_range), (*color)[1].real(color_range), (*color)[2].real(color_range));
}

// Returns the color for a surface that is shown without its texture.
std::optional<Vec3> Visuals::plain_color(const Value& material) {
    const std::optional<Vec3> color = base_color(material);
    return Textures::is_textured(material) ? texture_gray * color.value_or(Vec3(1.0f)) : color;
}

std::optional<Vec3> Visuals::color(const Value& node) const {
    if (const auto own = own_color(node)) return own;
    const auto index = node.find("mesh");
    if (!index) return std::nullopt;
    const Value primitives = element(document_.find("meshes"), *index, max_meshes, "meshes").require("primitives");
    if (primitives.size(max_primitives, "primitives") == 0) primitives.fail("must not be empty");
    const auto given = primitives[0].find("material");
    return given ? plain_color(material(*given)) : std::nullopt;
}

void Visuals::add(const Value& node, const std::optional<BodyId>& body, const NodeTransform& transform, Scene& scene,
                  std::vector<std::string>& warnings) {
    const auto index = node.find("mesh");
    const glm::dvec3& scale = transform.scale;
    if (!index || scale.x == 0.0 || scale.y == 0.0 || scale.z == 0.0) return;
    if (transform.is_skewed) {
        warnings.push_back(node.place() + "is skewed: its mesh is not shown");
        return;
    }
    require_usable(transform, node);
    VisualMesh like;
    if (body) like.body = *body;
    like.local = {transform.translation, Quat(transform.rotation)};
    add_parts(node, like, scale, scene, warnings);
}

void Visuals::add_parts(const Value& node, const VisualMesh& like, const glm::dvec3& scale, Scene& scene,
                        std::vector<std::string>& warnings) {
    const Value index = node.require("mesh");
    try {
        const std::vector<Triangles>& parts = surfaces_.mesh(index, warnings);
        const auto own = own_color(node);
        for (std::size_t i = 0; i < parts.size(); ++i) {
            VisualMesh visual = like;
            const Dressed& shown = dressed(index, i, parts[i], scale, like.bones.size(), warnings);
            visual.surface = shown.surface;
            std::optional<Vec3> color = own;
            if (!own) {
                visual.texture = shown.texture;
                visual.finish = shown.finish;
                if (parts[i].material)
                    color = visual.texture ? base_color(material(*parts[i].material))
                                           : plain_color(material(*parts[i].material));
            }
            if (color) visual.color = *color;
            scene.visuals.push_back(std::move(visual));
        }
    } catch (const Error& error) {
        if (error.code() != ErrorCode::unsupported) throw;
        warnings.push_back(std::string(error.what()) + " (its mesh is not shown)");
    }
}

void Visuals::add_skinned(const Value& node, std::span<const std::optional<BonePlace>> places, Scene& scene,
                          std::vector<std::string>& warnings) {
    VisualMesh like;
    like.bones =
        read_bones(element(document_.find("skins"), node.require("skin"), max_skins, "skins"), places, scene.world);
    add_parts(node, like, glm::dvec3(1.0), scene, warnings);
}

// glTF 2.0, section 3.7.3: the matrix of a joint is the global transform of its node times its inverse bind matrix.
std::vector<Bone> Visuals::read_bones(const Value& skin, std::span<const std::optional<BonePlace>> places,
                                      const World& world) {
    const Value joints = skin.require("joints");
    const std::size_t count = joints.size(max_bones, "joints");
    if (count == 0) joints.fail("must not be empty");
    std::vector<glm::dmat4> bound(count, glm::dmat4(1.0));
    if (const auto given = skin.find("inverseBindMatrices")) {
        bound = surfaces_.accessors().matrices(*given);
        if (bound.size() < count) given->fail("must have as many elements as joints, " + std::to_string(count));
    }
    std::vector<Bone> bones(count);
    for (std::size_t i = 0; i < count; ++i) {
        const Value joint = joints[i];
        const std::optional<BonePlace>& place = places[joint.index(places.size(), "nodes")];
        if (!place) joint.fail("must be a node that the scene shows");
        const Affine binding{glm::dmat3(bound[i]), glm::dvec3(bound[i][3])};
        Affine map = compose(place->map, binding);
        if (place->body) {
            const Body body = world.body(*place->body);
            const glm::dmat3 back = glm::transpose(glm::mat3_cast(glm::dquat(body.rotation())));
            map = compose({back, -(back * glm::dvec3(body.position()))}, map);
            bones[i].body = *place->body;
        }
        bones[i].linear = map.linear, bones[i].translation = map.translation;
        for (int k = 0; k < 3; ++k) {
            if (!any_float.contains(map.translation[k])) joint.fail("has a position that is too far from the origin");
        }
    }
    return bones;
}

// Reads the first set of weights, which are the four largest.
std::vector<BoneWeights> Visuals::read_weights(const Triangles& triangles, std::size_t bones) {
    const Value joints = triangles.attributes->require("JOINTS_0"), shares = triangles.attributes->require("WEIGHTS_0");
    const std::vector<glm::vec4> numbers = surfaces_.accessors().quadruples(joints);
    const std::vector<glm::vec4> given = surfaces_.accessors().quadruples(shares);
    const std::size_t count = triangles.vertices.size();
    if (numbers.size() != count) joints.fail("must have as many elements as POSITION, " + std::to_string(count));
    if (given.size() != count) shares.fail("must have as many elements as POSITION, " + std::to_string(count));
    std::vector<BoneWeights> result(count);
    for (std::size_t i = 0; i < count; ++i) {
        const glm::vec4 positive = glm::max(given[i], glm::vec4(0.0f));
        const float sum = positive.x + positive.y + positive.z + positive.w;
        if (!(sum > 0.0f) || !std::isfinite(sum))
            shares.fail("must have a sum above 0 for vertex " + std::to_string(i));
        for (int k = 0; k < 4; ++k) {
            const float share = positive[k] / sum, number = numbers[i][k];
            result[i].shares[std::size_t(k)] = share;
            if (share == 0.0f) continue;
            if (!(number >= 0.0f && number < float(bones))) {
                joints.fail("must stay below the " + std::to_string(bones) +
                            " joints of the skin, and does not for vertex " + std::to_string(i));
            }
            result[i].bones[std::size_t(k)] = std::uint16_t(number);
        }
    }
    return result;
}

std::vector<Vec3> Visuals::vertex_colors(const Triangles& triangles, const Textures::Warn& warn) {
    const auto given = triangles.attributes->find("COLOR_0");
    if (!given) return {};
    try {
        std::vector<Vec3> colors = surfaces_.accessors().colors(*given);
        const std::size_t count = triangles.vertices.size();
        if (colors.size() != count) given->fail("must have as many elements as POSITION, " + std::to_string(count));
        return colors;
    } catch (const Error& error) {
        warn(std::string(error.what()) + " (the colors of its vertices are left out)");
        return {};
    }
}

const Visuals::Dressed& Visuals::dressed(const Value& mesh, std::size_t part, const Triangles& triangles,
                                         const glm::dvec3& scale, std::size_t bones,
                                         std::vector<std::string>& warnings) {
    Dressed& found = shared_[{mesh.index(max_meshes, "meshes"), part, scale.x, scale.y, scale.z, bones}];
    if (!found.surface) {
        Triangles made = surfaces_.mapped(triangles, affine(scale), mesh);
        const Textures::Warn warn = [&](const std::string& line) {
            if (warned_.insert(line).second) warnings.push_back(line);
        };
        MaterialAppearance cover;
        if (triangles.material) cover = textures_.covering(material(*triangles.material), triangles, warn);
        Surface surface{std::move(made.vertices), std::move(made.normals), std::move(made.indices),
                        std::move(cover.coordinates)};
        surface.colors = vertex_colors(triangles, warn);
        if (bones > 0) surface.weights = read_weights(triangles, bones);
        found.surface = std::make_shared<const Surface>(std::move(surface));
        found.texture = std::move(cover.texture);
        found.finish = std::move(cover.finish);
    }
    return found;
}

} // namespace cairn::scene
