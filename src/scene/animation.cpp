#include "scene/animation.h"

#include "scene/buffer_writer.h"
#include "scene/definition_writer.h"
#include "scene/gltf_file.h"
#include "scene/json_number.h"
#include "scene/tessellation.h"

#include "files/output_file.h"

#include <array>
#include <cmath>
#include <utility>

namespace cairn::scene {

namespace {

using Json = nlohmann::ordered_json;

// Colors of shapes without a color of their own: gray for static, dark for kinematic bodies; dynamic bodies cycle
// through six colors.
constexpr Vec3 static_color{0.55f, 0.57f, 0.6f}, kinematic_color{0.25f, 0.28f, 0.35f};
constexpr std::array<Vec3, 6> dynamic_colors{{{0.8f, 0.3f, 0.2f},
                                              {0.2f, 0.5f, 0.8f},
                                              {0.9f, 0.65f, 0.15f},
                                              {0.3f, 0.65f, 0.35f},
                                              {0.55f, 0.35f, 0.7f},
                                              {0.2f, 0.65f, 0.65f}}};

Vec3 plain_color(BodyType type, std::size_t number) {
    if (type == BodyType::static_) return static_color;
    return type == BodyType::kinematic ? kinematic_color : dynamic_colors[number % dynamic_colors.size()];
}

// The key of a shape's geometry: its type and sizes, or the address of its shared data.
struct ShapeKey {
    std::string operator()(const Sphere& s) const { return sizes("sphere", {s.radius}); }
    std::string operator()(const Box& b) const {
        return sizes("box", {b.half_extents.x, b.half_extents.y, b.half_extents.z, b.rounding});
    }
    std::string operator()(const Plane& p) const {
        glm::vec2 half = p.half_extents.value_or(glm::vec2(0.0f));
        // 0 stands for infinite, as no finite size is 0
        for (int i = 0; i < 2; ++i) half[i] = std::isinf(half[i]) ? 0.0f : half[i];
        return sizes("plane", {p.normal.x, p.normal.y, p.normal.z, p.tangent.x, p.tangent.y, p.tangent.z, half.x,
                               half.y, p.double_sided ? 1.0f : 0.0f});
    }
    std::string operator()(const Capsule& c) const {
        return sizes("capsule", {c.half_height, c.radius, c.radius_top.value_or(c.radius)});
    }
    std::string operator()(const Cylinder& c) const {
        return sizes("cylinder", {c.half_height, c.radius, c.radius_top.value_or(c.radius), c.rounding});
    }
    std::string operator()(const Hull& hull) const {
        return address(hull.data().get()) + sizes(" rounded", {hull.rounding});
    }
    template <class Shared> std::string operator()(const Shared& shape) const { return address(shape.data().get()); }

  private:
    static std::string address(const void* data) {
        return "data " + std::to_string(reinterpret_cast<std::uintptr_t>(data));
    }
    static std::string sizes(const char* kind, const std::vector<float>& values) {
        Json json = Json::array({kind});
        for (const float v : values) json.push_back(shortest(v));
        return json_text(json);
    }
};

void place(const Vec3& position, const Quat& rotation, Json& node) {
    if (position != Vec3(0.0f)) node["translation"] = number_array(position);
    if (rotation != Quat(1.0f, 0.0f, 0.0f, 0.0f)) node["rotation"] = number_array(rotation);
}

Json material(const Vec3& color) {
    return {{"pbrMetallicRoughness",
             {{"baseColorFactor", Json::array({shortest(color.x), shortest(color.y), shortest(color.z), 1.0})},
              {"metallicFactor", 0.0},
              {"roughnessFactor", 0.8}}}};
}

Json parsed(const std::vector<std::string>& lines) {
    Json array = Json::array();
    for (const std::string& line : lines) array.push_back(Json::parse(line));
    return array;
}

} // namespace

bool AnimationBaker::Track::moves() const {
    for (std::size_t i = 1; i < positions.size(); ++i) {
        if (positions[i] != positions[0] || rotations[i] != rotations[0]) return true;
    }
    return false;
}

AnimationBaker::AnimationBaker(const Scene& scene) {
    std::unordered_map<std::uint64_t, Vec3> colors;
    for (const Appearance& appearance : scene.appearances) colors[appearance.shape.bits] = appearance.color;
    std::unordered_map<std::uint64_t, std::vector<const VisualMesh*>> visuals;
    std::vector<const VisualMesh*> scenery;
    for (const VisualMesh& visual : scene.visuals) {
        if (!visual.surface || visual.surface->indices.empty()) continue;
        for (const Bone& bone : visual.bones) visuals[bone.body.bits]; // hides the shapes of the bone's body
        if (visual.body.is_null()) {
            scenery.push_back(&visual);
        } else {
            visuals[visual.body.bits].push_back(&visual);
        }
    }
    const auto part_of = [&](const VisualMesh& visual) {
        return Part{visual.local, surface_of(visual.surface), visual.color, visual.texture, visual.bones,
                    visual.finish};
    };
    for (const BodyId id : scene.world.bodies()) {
        const Body body = scene.world.body(id);
        Track track;
        track.body = id;
        track.name = body.name();
        track.is_static = body.type() == BodyType::static_;
        if (const auto own = visuals.find(id.bits); own != visuals.end()) {
            for (const VisualMesh* visual : own->second) track.parts.push_back(part_of(*visual));
        } else {
            for (const ShapeId shape : body.shapes()) {
                const ShapeDef& def = scene.world.shape_def(shape);
                if (def.is_trigger) continue;
                const auto color = colors.find(shape.bits);
                track.parts.push_back(
                    {{Position(def.position), def.rotation},
                     surface_of(scene.world.shape(shape)),
                     color != colors.end() ? color->second : plain_color(body.type(), tracks_.size())});
            }
        }
        tracks_.push_back(std::move(track));
    }
    if (scenery.empty()) return;
    Track track; // a track without a body, at the origin
    track.name = "scenery";
    track.is_static = true;
    for (const VisualMesh* visual : scenery) track.parts.push_back(part_of(*visual));
    tracks_.push_back(std::move(track));
}

std::size_t AnimationBaker::surface_of(const Shape& shape) {
    const auto [found, is_new] = known_.try_emplace(std::visit(ShapeKey{}, shape), surfaces_.size());
    if (is_new) surfaces_.push_back(std::make_shared<const Surface>(tessellate(shape)));
    return found->second;
}

std::size_t AnimationBaker::surface_of(const std::shared_ptr<const Surface>& surface) {
    const std::string key = "surface " + std::to_string(reinterpret_cast<std::uintptr_t>(surface.get()));
    const auto [found, is_new] = known_.try_emplace(key, surfaces_.size());
    if (is_new) surfaces_.push_back(surface);
    return found->second;
}

void AnimationBaker::add(const World& world) {
    const double start = times_.empty() ? world.time() : times_[0];
    if (!times_.empty() && !(world.time() > times_.back())) {
        throw Error(ErrorCode::wrong_state, "AnimationBaker::add", std::to_string(world.time() - start),
                    "must be called with increasing times");
    }
    times_.push_back(world.time());
    for (Track& track : tracks_) {
        if (track.is_static && !track.positions.empty()) continue;
        Transform pose;
        if (!track.body.is_null()) pose = world.body(track.body).transform();
        Quat rotation = pose.rotation;
        // Both q and -q represent the rotation; the one nearer to the previous keyframe makes viewers interpolate the
        // short way.
        if (!track.rotations.empty() && glm::dot(track.rotations.back(), rotation) < 0.0f) rotation = -rotation;
        track.positions.push_back(Vec3(pose.position));
        track.rotations.push_back(rotation);
    }
}

std::string AnimationBaker::document(bool as_text) const {
    if (times_.empty()) throw Error(ErrorCode::wrong_state, "AnimationBaker", {}, "has no frame to show");
    BufferWriter buffer;
    std::vector<Json> primitives;
    LookWriter looks(buffer);
    for (const auto& surface : surfaces_) primitives.push_back(looks.primitive(*surface));
    std::unordered_map<std::uint64_t, std::size_t> node_of;
    std::size_t still_node = 0; // the node for bones that do not move: it follows the nodes of all bodies
    for (const Track& track : tracks_) {
        if (!track.body.is_null()) node_of[track.body.bits] = still_node;
        still_node += 1 + track.parts.size();
    }
    bool has_still_bones = false;
    const auto bone_node = [&](BodyId body) {
        const auto found = node_of.find(body.bits);
        has_still_bones = has_still_bones || found == node_of.end();
        return found == node_of.end() ? still_node : found->second;
    };
    std::vector<float> times;
    for (const double time : times_) times.push_back(static_cast<float>(time - times_[0]));
    Table materials, meshes;
    Json nodes = Json::array(), roots = Json::array(), samplers = Json::array(), channels = Json::array();
    std::optional<std::size_t> input;
    for (const Track& track : tracks_) {
        const std::size_t index = nodes.size();
        roots.push_back(index);
        Json node = Json::object();
        if (!track.name.empty()) node["name"] = track.name;
        place(track.positions[0], track.rotations[0], node);
        for (std::size_t i = 0; i < track.parts.size(); ++i) node["children"].push_back(index + 1 + i);
        nodes.push_back(std::move(node));
        for (const Part& part : track.parts) {
            Json primitive = primitives[part.surface];
            Json look = material(part.color);
            looks.add_look(part.texture.get(), part.finish.get(), look);
            primitive["material"] = materials.index(look);
            Json child{{"mesh", meshes.index({{"primitives", Json::array({std::move(primitive)})}})}};
            if (part.bones.empty())
                place(Vec3(part.local.position), part.local.rotation, child);
            else
                child["skin"] = looks.skin(part.bones, bone_node);
            nodes.push_back(std::move(child));
        }
        if (!track.moves()) continue;
        if (!input) input = buffer.add_scalars(times, true);
        const auto channel = [&](const char* path, std::size_t output) {
            channels.push_back({{"sampler", samplers.size()}, {"target", {{"node", index}, {"path", path}}}});
            samplers.push_back({{"input", *input}, {"output", output}, {"interpolation", "LINEAR"}});
        };
        channel("translation", buffer.add_vectors(track.positions));
        channel("rotation", buffer.add_quaternions(track.rotations));
    }
    if (has_still_bones) {
        roots.push_back(nodes.size());
        nodes.push_back(Json::object());
    }
    Json scene = Json::object();
    if (!roots.empty()) scene["nodes"] = std::move(roots);
    Json json{{"asset", {{"version", "2.0"}, {"generator", "cairn"}}}, {"scene", 0}, {"scenes", Json::array({scene})}};
    if (looks.uses_glow_strength()) json["extensionsUsed"] = Json::array({"KHR_materials_emissive_strength"});
    const auto add = [&json](const char* name, Json array) {
        if (!array.empty()) json[name] = std::move(array); // glTF does not allow empty arrays
    };
    add("nodes", std::move(nodes));
    add("meshes", parsed(meshes.lines()));
    add("materials", parsed(materials.lines()));
    for (const auto& [name, lines] : looks.arrays()) add(name, parsed(*lines));
    if (!channels.empty()) {
        json["animations"] = Json::array(
            {{{"name", "simulation"}, {"channels", std::move(channels)}, {"samplers", std::move(samplers)}}});
    }
    add("accessors", parsed(buffer.accessors()));
    add("bufferViews", parsed(buffer.views()));
    if (!buffer.empty()) json["buffers"] = Json::array({{{"byteLength", buffer.bytes().size()}}});
    if (!as_text) return glb_container(json_text(json), buffer.bytes());
    if (!buffer.empty()) json["buffers"][0]["uri"] = data_uri(buffer.bytes());
    return json_text(json) + "\n";
}

std::string AnimationBaker::container() const { return document(false); }

std::string AnimationBaker::text() const { return document(true); }

void AnimationBaker::write(const std::filesystem::path& path) const {
    files::write_file(path, files::extension_of(path) == ".gltf" ? text() : container());
}

} // namespace cairn::scene
