// Writes a world as a document. Everything is written in the order of the world, one node per line, with the shortest
// numbers that read back the same: equal worlds give equal bytes.
#include "scene/character.h"
#include "scene/definition_writer.h"
#include "scene/gltf_file.h"
#include "scene/json_number.h"
#include "scene/scene.h"
#include "scene/world_settings.h"

#include "files/output_file.h"

#include <cairn/triangles.h>

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <utility>

namespace cairn::scene {

namespace {

using Json = nlohmann::ordered_json;

bool is_zero(const Vec3& v) { return v.x == 0.0f && v.y == 0.0f && v.z == 0.0f; }
bool is_identity(const Quat& q) { return q.x == 0.0f && q.y == 0.0f && q.z == 0.0f && q.w == 1.0f; }

bool same(const MassProperties& a, const MassProperties& b) {
    return a.mass == b.mass && a.center_of_mass == b.center_of_mass && a.inertia_diagonal == b.inertia_diagonal &&
           a.inertia_orientation == b.inertia_orientation;
}

class Writer {
  public:
    explicit Writer(const Scene& scene) : scene_(scene), definitions_(scene) {
        for (const Appearance& appearance : scene.appearances) colors_[appearance.shape.bits] = appearance.color;
        for (const JointAppearance& shown : scene.joint_appearances) joint_colors_[shown.joint.bits] = shown.color;
        for (std::size_t i = 0; i < scene.visuals.size(); ++i) {
            if (is_drawn(scene.visuals[i])) visuals_[scene.visuals[i].body.bits].push_back(i);
        }
        number_groups();
        for (const BodyId id : scene_.world.bodies()) add_mesh_nodes(id);
        for (const BodyId id : scene_.world.bodies()) add_body(id);
        for (const VisualMesh& visual : scene_.visuals) {
            if (visual.body.is_null() && is_drawn(visual)) roots_.push_back(add_visual(visual));
        }
        for (const JointId id : scene_.world.joints()) {
            const auto color = joint_colors_.find(id.bits);
            add_joint(scene_.world.joint_def(id), color == joint_colors_.end() ? nullptr : &color->second);
        }
        for (const JointDef& joint : scene_.idle_joints) add_joint(joint);
        for (const Light& light : scene_.info.lights) add_light(light);
    }

    std::string text() const { return document(true); }
    std::string container() const { return glb_container(document(false), definitions_.buffer().bytes()); }

  private:
    std::string document(bool with_data) const {
        Json settings = write_world_settings(scene_.world.settings(), scene_.info);
        Json scene{{"nodes", roots_}, {"extensions", {{"CAIRN_world", std::move(settings)}}}};
        if (roots_.empty()) scene.erase("nodes"); // glTF does not allow empty arrays
        std::string text = "{\n\"asset\": {\"version\":\"2.0\",\"generator\":\"cairn\"},\n\"extensionsUsed\": " +
                           json_text(extensions_used()) + ",\n\"scene\": 0,\n\"scenes\": [\n" + json_text(scene) +
                           "\n]";
        std::vector<std::string> nodes;
        for (const Json& node : nodes_) nodes.push_back(node.is_null() ? "{}" : json_text(node));
        text += list("nodes", nodes) + list("meshes", definitions_.meshes().lines()) +
                list("materials", definitions_.colors().lines());
        for (const auto& [name, lines] : definitions_.look_writer().arrays()) text += list(name, *lines);
        if (const BufferWriter& buffer = definitions_.buffer(); !buffer.empty()) {
            text += list("accessors", buffer.accessors()) + list("bufferViews", buffer.views());
            Json entry{{"byteLength", buffer.bytes().size()}};
            if (with_data) entry["uri"] = data_uri(buffer.bytes());
            text += list("buffers", {json_text(entry)});
        }
        return text + extensions() + "\n}\n";
    }

    // Returns the extension objects of the document.
    std::string extensions() const {
        std::string shapes = list("shapes", definitions_.shapes().lines());
        std::string physics = list("physicsMaterials", definitions_.materials().lines()) +
                              list("collisionFilters", definitions_.filters().lines()) +
                              list("physicsJoints", definitions_.joints().lines());
        std::string text;
        if (!shapes.empty()) text += ",\n\"KHR_implicit_shapes\": {" + shapes.substr(2) + "}";
        if (!physics.empty()) text += ",\n\"KHR_physics_rigid_bodies\": {" + physics.substr(2) + "}";
        const std::string lights = list("lights", lights_);
        if (!lights.empty()) text += ",\n\"KHR_lights_punctual\": {" + lights.substr(2) + "}";
        return text.empty() ? "" : ",\n\"extensions\": {\n" + text.substr(2) + "\n}";
    }

    // Returns an array member, preceded by a comma; nothing if it is empty.
    static std::string list(const char* name, const std::vector<std::string>& entries) {
        if (entries.empty()) return {};
        std::string text = std::string(",\n\"") + name + "\": [";
        for (std::size_t i = 0; i < entries.size(); ++i) text += (i == 0 ? "\n" : ",\n") + entries[i];
        return text + "\n]";
    }

    Json extensions_used() const {
        Json used = Json::array({"CAIRN_world"});
        if (uses_body_extension_) used.push_back("CAIRN_body");
        if (definitions_.uses_material_extension()) used.push_back("CAIRN_material");
        if (definitions_.uses_joint_extension()) used.push_back("CAIRN_joint");
        if (definitions_.uses_shape_extension() || uses_rounded_hulls_) used.push_back("CAIRN_shape");
        if (definitions_.uses_mesh_extension()) used.push_back("CAIRN_mesh");
        if (definitions_.uses_height_fields()) used.push_back("CAIRN_height_field");
        if (nodes_.size() > lights_.size()) used.push_back("KHR_physics_rigid_bodies");
        if (!definitions_.shapes().lines().empty()) used.push_back("KHR_implicit_shapes");
        if (!lights_.empty()) used.push_back("KHR_lights_punctual");
        if (definitions_.look_writer().uses_glow_strength()) used.push_back("KHR_materials_emissive_strength");
        return used;
    }

    bool is_drawn(const VisualMesh& visual) const {
        const auto is_there = [this](const Bone& bone) {
            return bone.body.is_null() || scene_.world.is_valid(bone.body);
        };
        return visual.surface && !visual.surface->indices.empty() &&
               std::all_of(visual.bones.begin(), visual.bones.end(), is_there);
    }

    static bool needs_mesh(const Shape& shape) {
        return std::holds_alternative<Hull>(shape) || std::holds_alternative<Mesh>(shape);
    }

    // The draft requires that meshes of colliders belong to nodes that the scene does not show.
    void add_mesh_nodes(BodyId id) {
        for (const ShapeId shape_id : scene_.world.body(id).shapes()) {
            const Shape& shape = scene_.world.shape(shape_id);
            if (!needs_mesh(shape)) continue;
            const std::size_t mesh = definitions_.collider_mesh(shape);
            if (mesh_nodes_.try_emplace(mesh, nodes_.size()).second) nodes_.push_back({{"mesh", mesh}});
        }
    }

    void add_body(BodyId id) {
        const Body body = scene_.world.body(id);
        Json node, physics;
        if (!body.name().empty()) node["name"] = body.name();
        node["translation"] = number_array(body.position());
        if (!is_identity(body.rotation())) node["rotation"] = number_array(body.rotation());
        if (body.type() != BodyType::static_) physics["motion"] = motion(body);

        const std::vector<ShapeId> shapes = body.shapes();
        const std::size_t index = nodes_.size();
        roots_.push_back(index);
        node_of_[id.bits] = index;
        nodes_.emplace_back(); // its child nodes are appended after it
        const bool is_alone = shapes.size() == 1 && stands_at_origin(shapes[0]);
        Json children = Json::array();
        if (is_alone) {
            add_shape(shapes[0], physics);
            add_color(shapes[0], node);
        } else {
            for (const ShapeId shape : shapes) children.push_back(add_child(shape));
        }
        const auto visuals = visuals_.find(id.bits);
        if (visuals != visuals_.end()) {
            for (const std::size_t i : visuals->second) children.push_back(add_visual(scene_.visuals[i]));
        }
        // Without this mark the shapes of a static body would be read as several bodies, unless it has one lone
        // collider.
        const bool needs_mark = body.type() == BodyType::static_ && (!is_alone || !children.empty());
        if (!children.empty()) node["children"] = std::move(children);
        if (!physics.empty()) node["extensions"]["KHR_physics_rigid_bodies"] = std::move(physics);
        add_body_extension(body, needs_mark, node);
        nodes_[index] = std::move(node);
    }

    // Numbers the groups from 0, without groups of which fewer than two bodies still exist.
    void number_groups() {
        int number = 0;
        for (std::vector<BodyId> bodies : scene_.groups) {
            std::erase_if(bodies, [&](BodyId id) { return !scene_.world.is_valid(id); });
            if (bodies.size() < 2) continue;
            for (const BodyId id : bodies) group_of_[id.bits] = number;
            ++number;
        }
    }

    void add_body_extension(const Body& body, bool needs_mark, Json& node) {
        Json own = Json::object();
        if (body.linear_damping() != 0.0f) own["linear_damping"] = shortest(body.linear_damping());
        if (body.angular_damping() != 0.0f) own["angular_damping"] = shortest(body.angular_damping());
        if (!body.allow_sleep()) own["allow_sleep"] = false;
        if (!body.enabled()) own["enabled"] = false;
        if (const auto group = group_of_.find(body.id().bits); group != group_of_.end()) own["group"] = group->second;
        if (body.is_character()) own["character"] = written_character(body);
        if (own.empty() && !needs_mark) return;
        node["extensions"]["CAIRN_body"] = std::move(own);
        uses_body_extension_ = true;
    }

    bool stands_at_origin(ShapeId id) const {
        const ShapeDef& def = scene_.world.shape_def(id);
        return is_zero(def.position) && is_identity(file_rotation(scene_.world.shape(id), def.rotation));
    }

    std::size_t add_child(ShapeId id) {
        const ShapeDef& def = scene_.world.shape_def(id);
        const Quat rotation = file_rotation(scene_.world.shape(id), def.rotation);
        Json node;
        if (!is_zero(def.position)) node["translation"] = number_array(def.position);
        if (!is_identity(rotation)) node["rotation"] = number_array(rotation);
        add_shape(id, node["extensions"]["KHR_physics_rigid_bodies"]);
        add_color(id, node);
        nodes_.push_back(std::move(node));
        return nodes_.size() - 1;
    }

    void add_color(ShapeId id, Json& node) const {
        const auto found = colors_.find(id.bits);
        if (found != colors_.end()) node["extras"]["cairn_color"] = number_array(found->second);
    }

    // Writes the collider or the trigger of a shape.
    void add_shape(ShapeId id, Json& physics) {
        const Shape& shape = scene_.world.shape(id);
        const ShapeDef& def = scene_.world.shape_def(id);
        Json json;
        if (!needs_mesh(shape)) {
            json["geometry"]["shape"] = definitions_.shape(shape);
        } else {
            json["geometry"]["node"] = mesh_nodes_.at(definitions_.collider_mesh(shape));
            json["geometry"]["convexHull"] = std::holds_alternative<Hull>(shape);
            if (const float rounding = rounding_of(shape); rounding > 0.0f) {
                json["geometry"]["extensions"]["CAIRN_shape"]["rounding"] = shortest(rounding);
                uses_rounded_hulls_ = true;
            }
        }
        if (!def.is_trigger) json["physicsMaterial"] = definitions_.material(shape, def);
        if (const auto filter = definitions_.filter(def.filter)) json["collisionFilter"] = *filter;
        physics[def.is_trigger ? "trigger" : "collider"] = std::move(json);
    }

    std::size_t add_visual(const VisualMesh& visual) {
        Json node{{"mesh", definitions_.visual_mesh(visual)}};
        if (visual.bones.empty()) {
            place(visual.local, node);
        } else {
            node["skin"] =
                definitions_.look_writer().skin(visual.bones, [this](BodyId body) { return bone_node(body); });
        }
        nodes_.push_back(std::move(node));
        return nodes_.size() - 1;
    }

    // Returns the node of a bone, which is that of its body; bones without a body share a node at the origin.
    std::size_t bone_node(BodyId body) {
        if (!body.is_null()) return node_of_.at(body.bits);
        if (!still_node_) {
            still_node_ = nodes_.size();
            roots_.push_back(*still_node_);
            nodes_.push_back(Json::object());
        }
        return *still_node_;
    }

    // Adds a light at a node of its own, whose z axis points opposite to the direction in which it shines.
    void add_light(const Light& light) {
        constexpr const char* names[] = {"directional", "point", "spot"};
        Json json{{"type", names[int(light.kind)]}}, node;
        if (light.color != Vec3(1.0f)) json["color"] = number_array(light.color);
        if (light.intensity != 1.0f) json["intensity"] = shortest(light.intensity);
        if (light.range > 0.0f) json["range"] = shortest(light.range);
        if (light.kind == Light::Kind::spot)
            json["spot"] = {{"innerConeAngle", shortest(light.inner_cone)},
                            {"outerConeAngle", shortest(light.outer_cone)}};
        place({light.position, turn_of_z(light)}, node);
        node["extensions"]["KHR_lights_punctual"]["light"] = lights_.size();
        lights_.push_back(json_text(json));
        roots_.push_back(nodes_.size());
        nodes_.push_back(std::move(node));
    }
    static Quat turn_of_z(const Light& light) {
        if (light.kind == Light::Kind::point) return {1.0f, 0.0f, 0.0f, 0.0f};
        const glm::dvec3 z = glm::normalize(glm::dvec3(light.towards));
        if (z.z < -0.999999) return {0.0f, 0.0f, 1.0f, 0.0f}; // half a turn about y
        return Quat(glm::normalize(glm::dquat(1.0 + z.z, -z.y, z.x, 0.0)));
    }

    static void place(const Transform& transform, Json& node) {
        if (transform.position != Position(0.0)) node["translation"] = number_array(transform.position);
        if (!is_identity(transform.rotation)) node["rotation"] = number_array(transform.rotation);
    }

    void add_joint(const JointDef& joint, const Vec3* color = nullptr) {
        const auto is_gone = [&](BodyId body) { return !body.is_null() && !scene_.world.is_valid(body); };
        if (is_gone(joint.body_a) || is_gone(joint.body_b)) return;
        const std::size_t second = add_frame(joint.body_b, joint.frame_b);
        const std::size_t first = add_frame(joint.body_a, joint.frame_a);
        Json json{{"connectedNode", second}, {"joint", definitions_.joint(joint)}};
        if (joint.enable_collision) json["enableCollision"] = true;
        if (!joint.name.empty()) nodes_[first]["name"] = joint.name;
        nodes_[first]["extensions"]["KHR_physics_rigid_bodies"]["joint"] = std::move(json);
        if (color != nullptr) nodes_[first]["extras"]["cairn_color"] = number_array(*color);
    }

    // Adds a node for the frame of a joint, below its body.
    std::size_t add_frame(BodyId id, const Transform& frame) {
        Json node;
        place(frame, node);
        const std::size_t index = nodes_.size();
        nodes_.push_back(std::move(node));
        if (id.is_null()) {
            roots_.push_back(index);
        } else {
            nodes_[node_of_.at(id.bits)]["children"].push_back(index);
        }
        return index;
    }

    Json motion(const Body& body) {
        Json json = Json::object();
        if (body.type() == BodyType::kinematic) {
            json["isKinematic"] = true;
        } else {
            add_mass(body, json);
        }
        if (!is_zero(body.linear_velocity())) json["linearVelocity"] = local(body, body.linear_velocity());
        if (!is_zero(body.angular_velocity())) json["angularVelocity"] = local(body, body.angular_velocity());
        if (body.gravity_scale() != 1.0f) json["gravityFactor"] = shortest(body.gravity_scale());
        return json;
    }

    // Rotates a world vector to the axes of the node, in which the file gives velocities, by the rotation as it is
    // written. In doubles, so that rotating it back gives the same floats.
    static Json local(const Body& body, const Vec3& v) {
        if (is_identity(body.rotation())) return number_array(v);
        const glm::dquat rotation = glm::normalize(written_rotation(body.rotation()));
        return number_array(Position(glm::conjugate(rotation) * glm::dvec3(v)));
    }

    // Writes as little as possible: nothing if the mass properties follow from the shapes, only the mass if they scale
    // with it.
    void add_mass(const Body& body, Json& json) {
        const MassProperties properties = body.mass_properties();
        if (same(properties, from_shapes(body, std::nullopt))) return;
        json["mass"] = std::isinf(properties.mass) ? 0.0 : shortest(properties.mass);
        if (same(properties, from_shapes(body, properties.mass))) return;
        json["centerOfMass"] = number_array(properties.center_of_mass);
        json["inertiaDiagonal"] = number_array(properties.inertia_diagonal);
        json["inertiaOrientation"] = number_array(properties.inertia_orientation);
    }

    // Returns the mass properties that the body would have if they were computed from its shapes.
    MassProperties from_shapes(const Body& body, std::optional<float> mass) {
        BodyDef def;
        def.mass = mass;
        const BodyId id = scratch_.create_body(def);
        bool has_mass = false;
        for (const ShapeId shape : body.shapes()) {
            ShapeDef shape_def = scene_.world.shape_def(shape);
            if (shape_def.is_trigger) shape_def.density = 0.0f; // triggers are read without mass
            has_mass = has_mass || shape_def.density > 0.0f;
            scratch_.add_shape(id, scene_.world.shape(shape), shape_def);
        }
        MassProperties properties = std::as_const(scratch_).body(id).mass_properties();
        scratch_.destroy_body(id);
        if (!has_mass) properties.mass = 0.0f; // differs from every body, so that all properties are written
        return properties;
    }

    const Scene& scene_;
    World scratch_;
    DefinitionWriter definitions_;
    std::unordered_map<std::uint64_t, Vec3> colors_;                      // by shape
    std::unordered_map<std::uint64_t, Vec3> joint_colors_;                // by joint
    std::unordered_map<std::uint64_t, std::vector<std::size_t>> visuals_; // by body
    std::unordered_map<std::uint64_t, std::size_t> node_of_;              // by body
    std::optional<std::size_t> still_node_;                               // the node of bones without a body
    std::unordered_map<std::uint64_t, int> group_of_;                     // by body
    std::unordered_map<std::size_t, std::size_t> mesh_nodes_;             // by mesh
    std::vector<Json> nodes_;
    std::vector<std::string> lights_;
    std::vector<std::size_t> roots_;
    bool uses_body_extension_ = false, uses_rounded_hulls_ = false;
};

// Reading rounds slightly: the engine normalizes rotations, and stores the center of mass rather than the origin of a
// body. So the file is read and written again until a form repeats, usually after one or two rounds. If several forms
// alternate, the lexicographically least is taken. The next save enters the same cycle, and ends at the same form.
std::vector<std::byte> stable_container(const Scene& scene) {
    constexpr std::size_t max_rounds = 16;
    std::vector<std::string> forms{Writer(scene).container()};
    const auto bytes = [](const std::string& form) { return std::as_bytes(std::span(form.data(), form.size())); };
    while (forms.size() < max_rounds) {
        std::string next = Writer(load_from_memory(bytes(forms.back()), "saved scene")).container();
        const auto found = std::find(forms.begin(), forms.end(), next);
        if (found != forms.end()) {
            const std::string& least = *std::min_element(found, forms.end());
            return {bytes(least).begin(), bytes(least).end()};
        }
        forms.push_back(std::move(next));
    }
    return {bytes(forms.back()).begin(), bytes(forms.back()).end()};
}

} // namespace

std::string save_to_string(const Scene& scene) {
    return Writer(load_from_memory(stable_container(scene), "saved scene")).text();
}

void save(const Scene& scene, const std::filesystem::path& path) {
    if (files::extension_of(path) != ".glb") {
        files::write_file(path, save_to_string(scene));
        return;
    }
    const std::vector<std::byte> bytes = stable_container(scene);
    files::write_file(path, std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
}

} // namespace cairn::scene
