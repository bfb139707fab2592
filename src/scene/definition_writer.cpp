#include "scene/definition_writer.h"

#include "scene/filters.h"
#include "scene/joints.h"
#include "scene/json_number.h"

#include <cairn/triangles.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace cairn::scene {

namespace {

using Json = nlohmann::ordered_json;

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

Quat plane_frame(const Plane& plane) {
    const glm::dvec3 up = glm::normalize(glm::dvec3(plane.normal));
    const glm::dvec3 guess = plane.half_extents      ? glm::dvec3(plane.tangent)
                             : std::fabs(up.x) < 0.9 ? glm::dvec3(1.0, 0.0, 0.0)
                                                     : glm::dvec3(0.0, 0.0, 1.0);
    const glm::dvec3 x = glm::normalize(guess - up * glm::dot(up, guess));
    return Quat(glm::quat_cast(glm::dmat3(x, up, glm::cross(x, up))));
}

// Returns the rotation of a plane that differs from the file's standard plane; nothing for other shapes.
std::optional<Quat> turn_of_plane(const Shape& shape) {
    const Plane* plane = std::get_if<Plane>(&shape);
    if (plane == nullptr) return std::nullopt;
    const bool turned =
        plane->normal != Vec3(0.0f, 1.0f, 0.0f) || (plane->half_extents && plane->tangent != Vec3(1.0f, 0.0f, 0.0f));
    return turned ? std::optional(plane_frame(*plane)) : std::nullopt;
}

struct ShapeWriter {
    Json operator()(const Sphere& sphere) const {
        return {{"type", "sphere"}, {"sphere", {{"radius", shortest(sphere.radius)}}}};
    }
    Json operator()(const Box& box) const {
        return rounded({{"type", "box"}, {"box", {{"size", number_array(box.half_extents * 2.0f)}}}}, box.rounding);
    }
    Json operator()(const Plane& plane) const {
        Json json{{"type", "plane"}, {"plane", Json::object()}};
        const glm::vec2 half = plane.half_extents.value_or(glm::vec2(std::numeric_limits<float>::infinity()));
        if (!std::isinf(half.x)) json["plane"]["sizeX"] = shortest(half.x * 2.0f);
        if (!std::isinf(half.y)) json["plane"]["sizeZ"] = shortest(half.y * 2.0f);
        if (plane.double_sided) json["plane"]["doubleSided"] = true;
        return json;
    }
    Json operator()(const Capsule& capsule) const { return column("capsule", capsule); }
    Json operator()(const Cylinder& cylinder) const { return rounded(column("cylinder", cylinder), cylinder.rounding); }
    template <class Other> Json operator()(const Other&) const {
        throw Error(ErrorCode::invalid_value, "Shape", {}, "has no implicit form");
    }

  private:
    static Json rounded(Json shape, float rounding) {
        if (rounding > 0.0f) shape["extensions"]["CAIRN_shape"]["rounding"] = shortest(rounding);
        return shape;
    }
    template <class Column> static Json column(const char* name, const Column& shape) {
        return {{"type", name},
                {name,
                 {{"height", shortest(shape.half_height * 2.0f)},
                  {"radiusBottom", shortest(shape.radius)},
                  {"radiusTop", shortest(shape.radius_top.value_or(shape.radius))}}}};
    }
};

// Triangulates every face of a hull as a fan.
std::vector<std::uint32_t> triangles_of(const Hull& hull) {
    std::vector<std::uint32_t> indices;
    for (std::size_t f = 0; f < hull.face_count(); ++f) {
        const std::span<const std::uint32_t> face = hull.face(f);
        for (std::size_t i = 2; i < face.size(); ++i) indices.insert(indices.end(), {face[0], face[i - 1], face[i]});
    }
    return indices;
}

} // namespace

Quat file_rotation(const Shape& shape, const Quat& rotation) {
    const std::optional<Quat> turn = turn_of_plane(shape);
    return turn ? glm::normalize(rotation * *turn) : rotation;
}

DefinitionWriter::DefinitionWriter(const Scene& scene) { name_layers(scene); }

std::size_t DefinitionWriter::shape(const Shape& shape) {
    uses_shape_extension_ = uses_shape_extension_ || rounding_of(shape) > 0.0f;
    if (const auto* field = std::get_if<HeightField>(&shape)) {
        const auto [found, is_new] = height_fields_.try_emplace(field->data().get());
        if (is_new) found->second = shapes_.index(height_field(*field));
        return found->second;
    }
    return shapes_.index(std::visit(ShapeWriter{}, shape));
}

Json DefinitionWriter::height_field(const HeightField& field) {
    // Accessors hold finite numbers only, so holes are listed separately.
    std::vector<float> heights(field.heights().begin(), field.heights().end());
    Json holes = Json::array();
    for (std::size_t i = 0; i < heights.size(); ++i)
        if (heights[i] == HeightField::hole) heights[i] = 0.0f, holes.push_back(i);
    const glm::vec2 spacing = field.spacing();
    Json grid{{"columns", field.columns()},
              {"rows", field.rows()},
              {"spacing", Json::array({shortest(spacing.x), shortest(spacing.y)})},
              {"heights", buffer_.add_scalars(heights, false)}};
    if (!holes.empty()) grid["holes"] = std::move(holes);
    add_materials(field.materials(), grid);
    return {{"type", "CAIRN_height_field"}, {"extensions", {{"CAIRN_height_field", std::move(grid)}}}};
}

// Writes the materials of a mesh or height field into its extension object.
void DefinitionWriter::add_materials(const SurfaceMaterials& materials, Json& own) {
    if (materials.numbers.empty()) return;
    for (const Material& material : materials.materials) {
        ShapeDef def;
        def.material = material;
        own["materials"].push_back(this->material(Sphere{}, def));
    }
    if (materials.materials.empty()) return;
    own["numbers"] = buffer_.add_numbers(materials.numbers);
}

std::size_t DefinitionWriter::material(const Shape& shape, const ShapeDef& def) {
    const Material& m = def.material;
    Json json{{"staticFriction", shortest(m.static_friction)},
              {"dynamicFriction", shortest(m.dynamic_friction)},
              {"restitution", shortest(m.restitution)},
              {"frictionCombine", rule_name(m.friction_combine)},
              {"restitutionCombine", rule_name(m.restitution_combine)}};
    Json own;
    if (def.density != ShapeDef{}.density) own["density"] = shortest(def.density);
    if (m.rolling_friction != 0.0f) own["rolling_friction"] = shortest(m.rolling_friction);
    if (m.torsional_friction != Material{}.torsional_friction) {
        own["torsional_friction"] = shortest(m.torsional_friction);
    }
    const std::optional<Quat> turn = turn_of_plane(shape);
    const auto in_node = [&](const Vec3& v) { return number_array(turn ? glm::conjugate(*turn) * v : v); };
    if (def.surface_velocity != Vec3(0.0f)) own["surface_velocity"] = in_node(def.surface_velocity);
    if (def.one_way != Vec3(0.0f)) own["one_way"] = in_node(def.one_way);
    if (!own.empty()) {
        json["extensions"]["CAIRN_material"] = std::move(own);
        uses_material_extension_ = true;
    }
    return materials_.index(json);
}

// Only layers with shapes in them have an effect; each of them needs a name. The lowest layer needs none, unless a
// shape is both in it and in another one, which the draft can only express with a name.
void DefinitionWriter::name_layers(const Scene& scene) {
    std::uint64_t used = 0;
    bool lowest_is_shared = false;
    for (const BodyId body : scene.world.bodies()) {
        for (const ShapeId shape : scene.world.body(body).shapes()) {
            const std::uint64_t layers = scene.world.shape_def(shape).filter.layers;
            used |= layers;
            lowest_is_shared = lowest_is_shared || ((layers & unnamed_layer) != 0 && layers != unnamed_layer);
        }
    }
    std::set<std::string> taken(scene.collision_systems.begin(), scene.collision_systems.end());
    for (std::size_t bit = lowest_is_shared ? 0 : 1; bit < 64; ++bit) {
        if ((used >> bit & 1) == 0) continue;
        if (bit >= 1 && bit - 1 < scene.collision_systems.size()) {
            layer_names_[bit] = scene.collision_systems[bit - 1];
            continue;
        }
        std::string name = "layer_" + std::to_string(bit);
        while (!taken.insert(name).second) name += "_";
        layer_names_[bit] = name;
    }
    if (layer_names_.size() > max_collision_systems) {
        throw Error(ErrorCode::unsupported, "Scene", std::to_string(layer_names_.size()),
                    "must have shapes in at most 63 named collision layers to be saved");
    }
}

Json DefinitionWriter::layer_names(std::uint64_t layers) const {
    std::vector<std::string> names;
    for (const auto& [bit, name] : layer_names_) {
        if ((layers >> bit & 1) != 0) names.push_back(name);
    }
    std::sort(names.begin(), names.end());
    return Json(names);
}

std::optional<std::size_t> DefinitionWriter::filter(const CollisionFilter& filter) {
    Json json = Json::object();
    const bool collides = filter.layers != 0; // a shape in no layer collides with nothing
    if (collides) {
        if (const Json systems = layer_names(filter.layers); !systems.empty()) json["collisionSystems"] = systems;
    }
    // The draft can only express collision with the unnamed layer by excluding other systems, and no collision with it
    // only by listing the systems to collide with.
    if (!collides || (filter.collides_with & unnamed_layer) == 0) {
        json["collideWithSystems"] = layer_names(collides ? filter.collides_with : 0);
    } else if (const Json others = layer_names(~filter.collides_with); !others.empty()) {
        json["notCollideWithSystems"] = others;
    }
    if (json.empty()) return std::nullopt;
    return filters_.index(json);
}

std::size_t DefinitionWriter::joint(const JointDef& joint) {
    const Json json = write_joint(joint);
    uses_joint_extension_ = uses_joint_extension_ || json.contains("extensions");
    return joints_.index(json);
}

std::size_t DefinitionWriter::collider_mesh(const Shape& shape) {
    const Hull* hull = std::get_if<Hull>(&shape);
    const void* data = hull != nullptr ? static_cast<const void*>(hull->data().get())
                                       : static_cast<const void*>(std::get<Mesh>(shape).data().get());
    if (const auto found = collider_meshes_.find(data); found != collider_meshes_.end()) return found->second;
    const std::span<const Vec3> vertices = hull != nullptr ? hull->vertices() : std::get<Mesh>(shape).vertices();
    Json primitive{{"attributes", {{"POSITION", buffer_.add_vertices(vertices, true)}}}};
    primitive["indices"] = hull != nullptr ? buffer_.add_indices(triangles_of(*hull))
                                           : buffer_.add_indices(std::get<Mesh>(shape).indices());
    Json own = Json::object();
    if (const auto* mesh = std::get_if<Mesh>(&shape)) add_materials(mesh->materials(), own);
    if (!own.empty()) {
        primitive["extensions"]["CAIRN_mesh"] = std::move(own);
        uses_mesh_extension_ = true;
    }
    const std::size_t index = meshes_.index({{"primitives", Json::array({std::move(primitive)})}});
    collider_meshes_.emplace(data, index);
    return index;
}

std::size_t DefinitionWriter::visual_mesh(const VisualMesh& visual) {
    Json primitive = look_writer_.primitive(*visual.surface), material = Json::object();
    const Vec3& c = visual.color;
    if (c != Vec3(1.0f)) {
        material["pbrMetallicRoughness"]["baseColorFactor"] =
            Json::array({shortest(c.x), shortest(c.y), shortest(c.z), 1.0});
    }
    look_writer_.add_look(visual.texture.get(), visual.finish.get(), material);
    if (!material.empty()) {
        if (!visual.finish) material["pbrMetallicRoughness"]["metallicFactor"] = 0.0;
        primitive["material"] = colors_.index(material);
    }
    return meshes_.index({{"primitives", Json::array({std::move(primitive)})}});
}

} // namespace cairn::scene
