// From a world to a document. Everything is written in the order of the world, one node to a line, with the
// shortest numbers that read back the same: equal worlds give equal bytes.
#include "scene/gltf_file.h"
#include "scene/json_number.h"
#include "scene/scene.h"
#include "scene/world_settings.h"

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

const char* rule_name(CombineRule rule) {
    switch (rule) {
    case CombineRule::average:
        return "average";
    case CombineRule::minimum:
        return "minimum";
    case CombineRule::maximum:
        return "maximum";
    case CombineRule::multiply:
        return "multiply";
    }
    throw Error(ErrorCode::invalid_value, "CombineRule", std::to_string(static_cast<int>(rule)),
                "must be a known rule");
}

// The file's planes face +y and are measured along x and z.
Quat plane_frame(const Plane& plane) {
    const glm::dvec3 up = glm::normalize(glm::dvec3(plane.normal));
    const glm::dvec3 guess = plane.half_extents      ? glm::dvec3(plane.tangent)
                             : std::fabs(up.x) < 0.9 ? glm::dvec3(1.0, 0.0, 0.0)
                                                     : glm::dvec3(0.0, 0.0, 1.0);
    const glm::dvec3 x = glm::normalize(guess - up * glm::dot(up, guess));
    return Quat(glm::quat_cast(glm::dmat3(x, up, glm::cross(x, up))));
}

// The rotation of a shape as the file measures it.
Quat file_rotation(const Shape& shape, const Quat& rotation) {
    const Plane* plane = std::get_if<Plane>(&shape);
    if (plane == nullptr) return rotation;
    const bool turned =
        plane->normal != Vec3(0.0f, 1.0f, 0.0f) || (plane->half_extents && plane->tangent != Vec3(1.0f, 0.0f, 0.0f));
    return turned ? glm::normalize(rotation * plane_frame(*plane)) : rotation;
}

struct ShapeWriter {
    Json operator()(const Sphere& sphere) const {
        return {{"type", "sphere"}, {"sphere", {{"radius", shortest(sphere.radius)}}}};
    }
    Json operator()(const Box& box) const {
        return {{"type", "box"}, {"box", {{"size", number_array(box.half_extents * 2.0f)}}}};
    }
    Json operator()(const Plane& plane) const {
        Json json{{"type", "plane"}, {"plane", Json::object()}};
        if (plane.half_extents) {
            json["plane"] = {{"sizeX", shortest(plane.half_extents->x * 2.0f)},
                             {"sizeZ", shortest(plane.half_extents->y * 2.0f)}};
        }
        return json;
    }
};

// Definitions that nodes refer to by index, each listed once.
class Table {
  public:
    std::size_t index(const Json& entry) {
        const auto [found, is_new] = indices_.try_emplace(entry.dump(), lines_.size());
        if (is_new) lines_.push_back(found->first);
        return found->second;
    }
    const std::vector<std::string>& lines() const { return lines_; }

  private:
    std::unordered_map<std::string, std::size_t> indices_;
    std::vector<std::string> lines_;
};

class Writer {
  public:
    explicit Writer(const Scene& scene) : scene_(scene) {
        for (const Appearance& appearance : scene.appearances) colors_[appearance.shape.bits] = appearance.color;
    }

    std::string write() {
        for (const BodyId id : scene_.world.bodies()) add_body(id);
        Json settings = write_world_settings(scene_.world.settings(), scene_.info);
        Json scene{{"nodes", roots_}, {"extensions", {{"CAIRN_world", std::move(settings)}}}};
        if (roots_.empty()) scene.erase("nodes"); // glTF has no empty arrays
        std::string text = "{\n\"asset\": {\"version\":\"2.0\",\"generator\":\"cairn\"},\n\"extensionsUsed\": " +
                           extensions_used().dump() + ",\n\"scene\": 0,\n\"scenes\": [\n" + scene.dump() + "\n]";
        if (!nodes_.empty()) text += ",\n\"nodes\": " + lines(nodes_);
        if (!shapes_.lines().empty()) {
            text += ",\n\"extensions\": {\n\"KHR_implicit_shapes\": {\"shapes\": " + lines(shapes_.lines()) +
                    "},\n\"KHR_physics_rigid_bodies\": {\"physicsMaterials\": " + lines(materials_.lines()) + "}\n}";
        }
        return text + "\n}\n";
    }

  private:
    static std::string lines(const std::vector<std::string>& entries) {
        std::string text = "[";
        for (std::size_t i = 0; i < entries.size(); ++i) text += (i == 0 ? "\n" : ",\n") + entries[i];
        return text + "\n]";
    }

    Json extensions_used() const {
        Json used = Json::array({"CAIRN_world"});
        if (uses_body_extension_) used.push_back("CAIRN_body");
        if (uses_material_extension_) used.push_back("CAIRN_material");
        if (!nodes_.empty()) used.push_back("KHR_physics_rigid_bodies");
        if (!shapes_.lines().empty()) used.push_back("KHR_implicit_shapes");
        return used;
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
        nodes_.emplace_back(); // its children follow it
        const bool is_alone = shapes.size() == 1 && stands_at_origin(shapes[0]);
        if (is_alone) {
            physics["collider"] = collider(shapes[0]);
            add_color(shapes[0], node);
        } else if (!shapes.empty()) {
            Json children = Json::array();
            for (const ShapeId shape : shapes) children.push_back(add_child(shape));
            node["children"] = std::move(children);
        }
        if (!physics.empty()) node["extensions"]["KHR_physics_rigid_bodies"] = std::move(physics);
        add_body_extension(body, is_alone, node);
        nodes_[index] = node.dump();
    }

    void add_body_extension(const Body& body, bool is_alone, Json& node) {
        Json own = Json::object();
        if (body.linear_damping() != 0.0f) own["linear_damping"] = shortest(body.linear_damping());
        if (body.angular_damping() != 0.0f) own["angular_damping"] = shortest(body.angular_damping());
        // A static body whose colliders sit on other nodes is one body only by this mark.
        const bool needs_mark = body.type() == BodyType::static_ && !is_alone;
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
        node["extensions"]["KHR_physics_rigid_bodies"]["collider"] = collider(id);
        add_color(id, node);
        nodes_.push_back(node.dump());
        return nodes_.size() - 1;
    }

    void add_color(ShapeId id, Json& node) const {
        const auto found = colors_.find(id.bits);
        if (found != colors_.end()) node["extras"]["cairn_color"] = number_array(found->second);
    }

    Json collider(ShapeId id) {
        const std::size_t shape = shapes_.index(std::visit(ShapeWriter{}, scene_.world.shape(id)));
        return {{"geometry", {{"shape", shape}}}, {"physicsMaterial", material(scene_.world.shape_def(id))}};
    }

    std::size_t material(const ShapeDef& def) {
        const Material& m = def.material;
        Json json{{"staticFriction", shortest(m.static_friction)},
                  {"dynamicFriction", shortest(m.dynamic_friction)},
                  {"restitution", shortest(m.restitution)},
                  {"frictionCombine", rule_name(m.friction_combine)},
                  {"restitutionCombine", rule_name(m.restitution_combine)}};
        Json own;
        if (def.density != ShapeDef{}.density) own["density"] = shortest(def.density);
        if (m.rolling_friction != 0.0f) own["rolling_friction"] = shortest(m.rolling_friction);
        if (m.torsional_friction != 0.0f) own["torsional_friction"] = shortest(m.torsional_friction);
        if (!own.empty()) {
            json["extensions"]["CAIRN_material"] = std::move(own);
            uses_material_extension_ = true;
        }
        return materials_.index(json);
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

    // A world vector in the node's axes, where the file has velocities, as they are turned by the rotation that the
    // file has. In doubles, so that turning it back gives the same floats.
    static Json local(const Body& body, const Vec3& v) {
        if (is_identity(body.rotation())) return number_array(v);
        const glm::dquat rotation = glm::normalize(written_rotation(body.rotation()));
        return number_array(Position(glm::conjugate(rotation) * glm::dvec3(v)));
    }

    // As little as possible: nothing if the masses follow from the shapes, the mass alone if it scales them.
    void add_mass(const Body& body, Json& json) {
        const MassProperties properties = body.mass_properties();
        if (same(properties, from_shapes(body, std::nullopt))) return;
        json["mass"] = std::isinf(properties.mass) ? 0.0 : shortest(properties.mass);
        if (same(properties, from_shapes(body, properties.mass))) return;
        json["centerOfMass"] = number_array(properties.center_of_mass);
        json["inertiaDiagonal"] = number_array(properties.inertia_diagonal);
        json["inertiaOrientation"] = number_array(properties.inertia_orientation);
    }

    // Mass properties that the body would have without any of its own.
    MassProperties from_shapes(const Body& body, std::optional<float> mass) {
        BodyDef def;
        def.mass = mass;
        const BodyId id = scratch_.create_body(def);
        bool has_mass = false;
        for (const ShapeId shape : body.shapes()) {
            const ShapeDef& shape_def = scene_.world.shape_def(shape);
            has_mass = has_mass || shape_def.density > 0.0f;
            scratch_.add_shape(id, scene_.world.shape(shape), shape_def);
        }
        MassProperties properties = std::as_const(scratch_).body(id).mass_properties();
        scratch_.destroy_body(id);
        if (!has_mass) properties.mass = 0.0f; // like no body: everything has to be written
        return properties;
    }

    const Scene& scene_;
    World scratch_;
    std::unordered_map<std::uint64_t, Vec3> colors_;
    Table shapes_, materials_;
    std::vector<std::string> nodes_;
    std::vector<std::size_t> roots_;
    bool uses_body_extension_ = false, uses_material_extension_ = false;
};

} // namespace

// Reading rounds a little: the engine normalizes rotations, and keeps the center of mass rather than the origin of a
// body. So the text is read and written again until it repeats, which it does after a step or two; where it
// alternates, the least of its forms is taken. The next save starts in the same circle, and ends at the same form.
std::string save_to_string(const Scene& scene) {
    constexpr std::size_t most_rounds = 16;
    std::vector<std::string> forms{Writer(scene).write()};
    while (forms.size() < most_rounds) {
        const std::string& last = forms.back();
        std::string next =
            Writer(load_from_memory(std::as_bytes(std::span(last.data(), last.size())), "saved scene")).write();
        const auto found = std::find(forms.begin(), forms.end(), next);
        if (found != forms.end()) return *std::min_element(found, forms.end());
        forms.push_back(std::move(next));
    }
    return forms.back();
}

void save(const Scene& scene, const std::filesystem::path& path) { write_file(path, save_to_string(scene)); }

} // namespace cairn::scene
