// From a document to a world. Nodes are walked from the roots down, in the order of the file, so that equal
// files give equal worlds: handles, storage and all.
#include "scene/definitions.h"
#include "scene/document.h"
#include "scene/gltf_file.h"
#include "scene/node_graph.h"
#include "scene/node_transform.h"
#include "scene/scene.h"
#include "scene/world_settings.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace cairn::scene {

namespace {

constexpr Range color_range{0.0, 1.0, false};
constexpr std::size_t max_warnings = 100;

// Where the walk stands.
struct Place {
    NodeTransform world;        // of the node above
    std::optional<BodyId> body; // that a collider here belongs to
    NodeTransform in_body;      // of the node above, seen from that body
    std::size_t depth = 0;
};

// A velocity from the node's axes, in which the file has it, to the world's: turned with the node, and not scaled.
Vec3 turned(const glm::dquat& rotation, const glm::dvec3& v) {
    if (rotation.x == 0.0 && rotation.y == 0.0 && rotation.z == 0.0) return Vec3(v);
    glm::dvec3 result = glm::normalize(rotation) * v;
    // Turning back and forth leaves a speck where a component was zero; it is below what a float can tell of the
    // whole vector, and would grow into a difference from save to save.
    const double speck = 1e-8 * std::max({std::fabs(result.x), std::fabs(result.y), std::fabs(result.z)});
    for (int i = 0; i < 3; ++i) {
        if (std::fabs(result[i]) < speck) result[i] = 0.0;
    }
    return Vec3(result);
}

class Builder {
  public:
    Builder(const Value& document, WorldSettings settings, std::vector<std::string> warnings)
        : document_(document), definitions_(document),
          warnings_(std::move(warnings)), scene_{World(settings.world), std::move(settings.info), {}, {}, {}} {}

    Scene build(const std::optional<Value>& scene) {
        for (const ForceField& field : scene_.info.force_fields) {
            scene_.force_fields.push_back(scene_.world.add_force_field(field));
        }
        graph_ = read_node_graph(document_, scene);
        for (const std::size_t root : graph_.roots) visit(root, {});
        definitions_.refuse_separating_filters();
        if (warnings_.size() > max_warnings) {
            const std::size_t more = warnings_.size() - max_warnings;
            warnings_.resize(max_warnings);
            warnings_.push_back("and " + std::to_string(more) + " more warnings");
        }
        scene_.warnings = std::move(warnings_);
        return std::move(scene_);
    }

  private:
    Value node(std::size_t index) const { return document_.require("nodes")[index]; }

    void visit(std::size_t index, Place place) {
        const Value here = node(index);
        if (place.depth > max_node_depth) {
            here.fail("must be at most " + std::to_string(max_node_depth) + " nodes below its root");
        }
        const NodeTransform local = read_transform(here);
        place.world = compose(place.world, local);
        if (place.body) place.in_body = compose(place.in_body, local);
        ++place.depth;

        const auto physics = extension(here, "KHR_physics_rigid_bodies");
        const auto own = extension(here, "CAIRN_body");
        if (physics) refuse_unsupported(*physics);
        const auto motion = physics ? physics->find("motion") : std::nullopt;
        if (motion || (own && !place.body)) {
            place.body = add_body(here, motion, own, place.world);
            place.in_body = NodeTransform{{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0, 0.0}, place.world.scale};
        } else if (own) {
            own->fail("must stand on a node with a motion, or on one that no body holds already");
        }
        if (const auto collider = physics ? physics->find("collider") : std::nullopt) {
            if (place.body) {
                add_collider(here, *collider, *place.body, place.in_body);
            } else {
                const BodyId alone = add_body(here, std::nullopt, std::nullopt, place.world);
                add_collider(here, *collider, alone, {{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0, 0.0}, place.world.scale});
            }
        }
        for (const std::size_t child : graph_.children[index]) visit(child, place);
        if (motion) finish_motion(*motion, *place.body, place.world);
    }

    static void refuse_unsupported(const Value& physics) {
        if (const auto trigger = physics.find("trigger")) trigger->refuse("triggers are not supported yet");
        if (const auto joint = physics.find("joint")) joint->refuse("joints are not supported yet");
    }

    BodyId add_body(const Value& here, const std::optional<Value>& motion, const std::optional<Value>& own,
                    const NodeTransform& world) {
        require_usable(world, here);
        BodyDef def;
        def.type = BodyType::static_;
        def.position = world.translation;
        def.rotation = Quat(world.rotation);
        if (const auto name = here.find("name")) def.name = name->text();
        if (motion) read_motion(*motion, def);
        if (own) {
            if (const auto value = own->find("linear_damping")) def.linear_damping = value->real(nonnegative_float);
            if (const auto value = own->find("angular_damping")) def.angular_damping = value->real(nonnegative_float);
        }
        try {
            return scene_.world.create_body(def);
        } catch (const Error& error) {
            (motion ? *motion : here).fail(error);
        }
    }

    static void read_motion(const Value& motion, BodyDef& def) {
        def.type = BodyType::dynamic;
        if (const auto kinematic = motion.find("isKinematic"); kinematic && kinematic->boolean()) {
            def.type = BodyType::kinematic;
        }
        const auto mass = motion.find("mass");
        if (mass) {
            const float value = mass->real(nonnegative_float);
            if (def.type == BodyType::dynamic) {
                def.mass = value == 0.0f ? std::numeric_limits<float>::infinity() : value;
            }
        }
        if (const auto factor = motion.find("gravityFactor")) def.gravity_scale = factor->real();
    }

    // What has to wait until the body has its shapes: they move its center of mass, and with it the velocities.
    void finish_motion(const Value& motion, BodyId id, const NodeTransform& world) {
        const auto linear = read_vector(motion, "linearVelocity"), angular = read_vector(motion, "angularVelocity");
        Body body = scene_.world.body(id);
        const std::optional<MassProperties> mass = read_mass(motion, body, world.scale);
        try {
            if (mass) body.set_mass_properties(*mass);
            if (linear) body.set_linear_velocity(turned(world.rotation, *linear));
            if (angular) body.set_angular_velocity(turned(world.rotation, *angular));
        } catch (const Error& error) {
            motion.fail(error);
        }
    }

    static std::optional<glm::dvec3> read_vector(const Value& owner, const char* name, const Range& range = any_float) {
        const auto vector = owner.find(name);
        return vector ? std::optional(vector->vector3(range)) : std::nullopt;
    }

    // The mass properties that the file gives, over those that follow from the shapes; nothing if they all follow.
    std::optional<MassProperties> read_mass(const Value& motion, const Body& body, const glm::dvec3& scale) {
        const auto center = read_vector(motion, "centerOfMass");
        const auto inertia = read_vector(motion, "inertiaDiagonal", nonnegative_float);
        const auto turn = motion.find("inertiaOrientation");
        const Quat orientation = turn ? Quat(turn->rotation()) : Quat(1.0f, 0.0f, 0.0f, 0.0f);
        if (body.type() != BodyType::dynamic) return std::nullopt;
        const bool has_mass = has_massive_shape(body);
        if (has_mass && !center && !inertia && !turn) return std::nullopt;
        MassProperties properties;
        if (has_mass) {
            properties = body.mass_properties();
        } else {
            if (const auto mass = motion.find("mass")) properties.mass = mass->real(nonnegative_float);
            if (properties.mass == 0.0f) properties.mass = std::numeric_limits<float>::infinity();
            const float moment = std::isinf(properties.mass) ? 0.0f : 0.4f * properties.mass * 0.25f;
            properties.inertia_diagonal = {moment, moment, moment};
        }
        if (!has_mass && !inertia) {
            warnings_.push_back(motion.place() + "has no collider with mass; the inertia is taken as that of a ball of "
                                                 "0.5 m radius");
        }
        if (center) properties.center_of_mass = Vec3(*center * scale);
        if (inertia) properties.inertia_diagonal = Vec3(*inertia);
        if (inertia || turn) properties.inertia_orientation = orientation;
        return properties;
    }

    bool has_massive_shape(const Body& body) const {
        for (const ShapeId shape : body.shapes()) {
            if (scene_.world.shape_def(shape).density > 0.0f) return true;
        }
        return false;
    }

    void add_collider(const Value& here, const Value& collider, BodyId body, const NodeTransform& in_body) {
        require_usable(in_body, here);
        const Value geometry = collider.require("geometry");
        if (const auto mesh = geometry.find("node")) {
            mesh->refuse("meshes and convex hulls as colliders are not supported yet");
        }
        definitions_.use_filter(collider.find("collisionFilter"));
        Substance substance;
        if (const auto index = collider.find("physicsMaterial")) substance = definitions_.substance(*index);
        const Value index = geometry.require("shape");
        if (in_body.scale.x == 0.0 || in_body.scale.y == 0.0 || in_body.scale.z == 0.0) {
            warnings_.push_back(collider.place() + "is disabled by a scale of zero");
            return;
        }
        const Shape shape = definitions_.shape(index, in_body.scale, warnings_);
        if (std::holds_alternative<Plane>(shape) && scene_.world.body(body).type() == BodyType::dynamic) {
            collider.refuse("planes have no mass and may only belong to static and kinematic bodies");
        }
        ShapeDef def;
        def.position = Vec3(in_body.translation);
        def.rotation = Quat(in_body.rotation);
        def.density = substance.density;
        def.material = substance.material;
        try {
            const ShapeId id = scene_.world.add_shape(body, shape, def);
            if (const auto color = color_of(here)) scene_.appearances.push_back({body, id, *color});
        } catch (const Error& error) {
            collider.fail(error);
        }
    }

    // The node's own color, else that of the material of its mesh's first part.
    std::optional<Vec3> color_of(const Value& here) const {
        if (const auto extras = here.find("extras"); extras && extras->is_object()) {
            if (const auto color = extras->find("cairn_color")) return color->float_vector3(color_range);
        }
        const auto mesh = here.find("mesh");
        if (!mesh) return std::nullopt;
        const Value meshes = document_.require("meshes");
        const Value primitives =
            meshes[mesh->index(meshes.size(max_definitions, "meshes"), "meshes")].require("primitives");
        if (primitives.size(max_definitions, "primitives") == 0) primitives.fail("must not be empty");
        const auto material = primitives[0].find("material");
        if (!material) return std::nullopt;
        const Value materials = document_.require("materials");
        const Value found = materials[material->index(materials.size(max_definitions, "materials"), "materials")];
        const auto roughness = found.find("pbrMetallicRoughness");
        const auto color = roughness ? roughness->find("baseColorFactor") : std::nullopt;
        if (!color) return std::nullopt;
        if (color->size(4, "numbers") != 4) color->fail("must be an array of 4 numbers");
        return Vec3((*color)[0].real(color_range), (*color)[1].real(color_range), (*color)[2].real(color_range));
    }

    Value document_;
    Definitions definitions_;
    std::vector<std::string> warnings_;
    Scene scene_;
    NodeGraph graph_;
};

} // namespace

Scene load_from_memory(std::span<const std::byte> bytes, const std::string& name) {
    const nlohmann::json json = parse_gltf(bytes, name);
    const Value document(json, name);
    check_document(document);
    const auto scene = default_scene(document);
    const auto own = scene ? extension(*scene, "CAIRN_world") : std::nullopt;
    std::vector<std::string> warnings;
    WorldSettings settings;
    if (own) settings = read_world_settings(*own, warnings);
    if (settings.info.title.empty() && scene) {
        if (const auto title = scene->find("name")) settings.info.title = title->text();
    }
    return Builder(document, std::move(settings), std::move(warnings)).build(scene);
}

Scene load(const std::filesystem::path& path) {
    const std::vector<std::byte> bytes = read_file(path);
    return load_from_memory(bytes, path.filename().generic_string());
}

} // namespace cairn::scene
