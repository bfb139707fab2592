// Builds a world from a document. Nodes are visited from the roots down, in the order of the file, so that equal files
// give equal worlds, including handles and storage.
#include "scene/character.h"
#include "scene/colliders.h"
#include "scene/document.h"
#include "scene/filters.h"
#include "scene/gltf_file.h"
#include "scene/joints.h"
#include "scene/json_number.h"
#include "scene/loaded_world.h"
#include "scene/mass_sum.h"
#include "scene/model_body.h"
#include "scene/models.h"
#include "scene/node_graph.h"
#include "scene/node_transform.h"
#include "scene/scene.h"
#include "scene/spelling.h"
#include "scene/view.h"
#include "scene/visuals.h"
#include "scene/world_settings.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>

namespace cairn::scene {

namespace {

// The state of the traversal at a node.
struct Place {
    NodeTransform world;         // transform of the parent node
    Affine map;                  // the same as an affine map, which may be skewed
    std::optional<BodyId> body;  // the body that a collider at this node belongs to
    NodeTransform in_body;       // transform of the parent node relative to that body
    std::optional<BodyId> fixed; // the nearest ancestor body that is static and was made for a lone collider or trigger
    NodeTransform in_fixed;
    std::size_t depth = 0;
};

// A node that a joint may be attached to.
struct JointFrame {
    std::optional<BodyId> body; // the body that the node moves with, or the static body above it
    NodeTransform transform;    // relative to that body, else to the world
    Affine map;                 // to the world, possibly skewed
};

const NodeTransform at_body(const NodeTransform& world) {
    return {{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0, 0.0}, world.scale, false};
}

// Rotates a velocity from the axes of the node, in which the file gives it, to those of the world; it is not scaled.
Vec3 turned(const glm::dquat& rotation, const glm::dvec3& v) {
    if (rotation.x == 0.0 && rotation.y == 0.0 && rotation.z == 0.0) return Vec3(v);
    glm::dvec3 result = glm::normalize(rotation) * v;
    // Rotating back and forth leaves a tiny value where a component was zero; it is below float precision relative to
    // the whole vector, and would grow from save to save. It is set to zero.
    const double speck = 1e-8 * std::max({std::fabs(result.x), std::fabs(result.y), std::fabs(result.z)});
    for (int i = 0; i < 3; ++i) {
        if (std::fabs(result[i]) < speck) result[i] = 0.0;
    }
    return Vec3(result);
}

class Builder {
  public:
    Builder(const Value& document, const Buffers& buffers, const NodeGraph& graph, WorldSettings settings,
            std::vector<std::string> warnings, const LoadOptions& options)
        : document_(document), graph_(graph), surfaces_(document, buffers, graph), colliders_(document, surfaces_),
          visuals_(document, surfaces_), filters_(document), warnings_(std::move(warnings)),
          joints_(document, warnings_), scene_{loaded_world(settings.world, options),
                                               std::move(settings.info),
                                               {},
                                               {},
                                               {}} {}

    Scene build() {
        for (const ForceField& field : scene_.info.force_fields) {
            scene_.force_fields.push_back(scene_.world.add_force_field(field));
        }
        if (!joints_.empty()) joint_frames_.resize(graph_.children.size());
        if (document_.find("skins")) bone_places_.resize(graph_.children.size());
        for (const std::size_t root : graph_.roots) visit(root, {});
        for (const std::size_t skinned : skinned_nodes_)
            visuals_.add_skinned(node(skinned), bone_places_, scene_, warnings_);
        // The order of the file, in which joints are also saved: the order of joints affects the solver.
        std::sort(joint_nodes_.begin(), joint_nodes_.end());
        for (const std::size_t node : joint_nodes_) add_joint(node);
        scene_.collision_systems = filters_.names();
        for (auto& [number, bodies] : groups_) {
            if (bodies.size() > 1) scene_.groups.push_back(std::move(bodies));
        }
        if (aims_camera_) aim_camera(scene_.world, *scene_.info.camera);
        limit_warnings(warnings_);
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
        place.map = compose(place.map, read_affine(here));
        if (place.body) place.in_body = compose(place.in_body, local);
        if (place.fixed) place.in_fixed = compose(place.in_fixed, local);
        ++place.depth;

        const auto physics = extension(here, "KHR_physics_rigid_bodies");
        const auto own = extension(here, "CAIRN_body");
        const auto motion = physics ? physics->find("motion") : std::nullopt;
        const auto collider = physics ? physics->find("collider") : std::nullopt;
        const auto trigger = physics ? physics->find("trigger") : std::nullopt;
        const bool is_group = trigger && check_group(*trigger, index);
        if (motion || ((own || is_group) && !place.body)) {
            place.body = add_body(here, motion, own, place.world);
            place.in_body = at_body(place.world);
        } else if (own) {
            own->fail("must belong to a node with a motion, or to a node that is not yet part of a body");
        }
        std::optional<BodyId> body = place.body;
        NodeTransform in_body = place.in_body;
        if (!body && (collider || trigger)) { // a static body of its own, to which child nodes do not belong
            body = add_body(here, std::nullopt, std::nullopt, place.world);
            in_body = at_body(place.world);
            place.fixed = body;
            place.in_fixed = in_body;
        }
        if (collider) add_collider(here, *collider, *body, in_body);
        if (trigger && !is_group) add_trigger(here, *trigger, *body, in_body);
        if (!bone_places_.empty()) bone_places_[index] = BonePlace{place.body, place.map};
        if (here.find("skin") && here.find("mesh"))
            skinned_nodes_.push_back(index);
        else
            visuals_.add(here, body, body ? in_body : place.world, scene_, warnings_);
        aims_camera_ = read_view(document_, here, place.map, scene_.info) || aims_camera_;
        note_joint(index, physics, place);
        for (const std::size_t child : graph_.children[index]) visit(child, place);
        if (motion) finish_motion(*motion, *place.body, place.world);
        if (const auto walks = own ? own->find("character") : std::nullopt)
            read_character(*walks, scene_.world.body(*place.body));
    }

    // Returns whether a trigger combines the triggers on child nodes instead of having a geometry of its own.
    bool check_group(const Value& trigger, std::size_t index) const {
        const auto nodes = trigger.find("nodes");
        if (!nodes) return false;
        if (const auto geometry = trigger.find("geometry")) geometry->fail("must not stand beside nodes");
        const std::size_t count = nodes->size(max_nodes, "nodes");
        if (count == 0) nodes->fail("must not be empty");
        std::set<std::size_t> below;
        std::vector<std::size_t> open{index};
        while (!open.empty()) {
            const std::size_t next = open.back();
            open.pop_back();
            for (const std::size_t child : graph_.children[next]) {
                below.insert(child);
                open.push_back(child);
            }
        }
        for (std::size_t i = 0; i < count; ++i) {
            const Value entry = (*nodes)[i];
            const std::size_t part = entry.index(graph_.children.size(), "nodes");
            const auto physics = extension(node(part), "KHR_physics_rigid_bodies");
            if (below.count(part) == 0 || !physics || !physics->find("trigger")) {
                entry.fail("must be a node below this one that has a trigger");
            }
        }
        return true;
    }

    // Records the frame for joints that may be attached to this node, if the file has any joints.
    void note_joint(std::size_t index, const std::optional<Value>& physics, const Place& place) {
        if (physics && physics->find("joint")) joint_nodes_.push_back(index);
        if (joints_.empty()) return;
        joint_frames_[index] = place.body    ? JointFrame{place.body, place.in_body, place.map}
                               : place.fixed ? JointFrame{place.fixed, place.in_fixed, place.map}
                                             : JointFrame{std::nullopt, place.world, place.map};
    }

    void add_joint(std::size_t index) {
        const Value here = node(index);
        const Value joint = extension(here, "KHR_physics_rigid_bodies")->require("joint");
        JointDef def = joints_.joint(joint.require("joint"));
        const Value connected = joint.require("connectedNode");
        const std::size_t other = connected.index(graph_.children.size(), "nodes");
        if (!joint_frames_[other]) connected.fail("must be the index of a node of the scene");
        if (const auto name = here.find("name")) def.name = name->text();
        if (const auto collide = joint.find("enableCollision")) def.enable_collision = collide->boolean();
        const auto place = [&](std::size_t which, BodyId& body, Transform& frame) {
            const JointFrame& found = *joint_frames_[which];
            if (found.body) body = *found.body;
            frame = frame_of(found, node(which));
        };
        place(index, def.body_a, def.frame_a);
        place(other, def.body_b, def.frame_b);
        if (const auto why = reason_to_idle(def)) {
            warnings_.push_back(joint.place() + *why);
            scene_.idle_joints.push_back(std::move(def));
            return;
        }
        try {
            const JointId made = scene_.world.create_joint(def);
            if (const auto color = visuals_.own_color(here)) scene_.joint_appearances.push_back({made, *color});
        } catch (const Error& error) {
            joint.fail(error);
        }
    }

    // A joint frame has no shape that a skewed transform could deform: its position and the direction of its x axis are
    // kept, and the other two axes are made perpendicular to it.
    Transform frame_of(const JointFrame& frame, const Value& here) {
        if (!frame.transform.is_skewed) {
            require_usable(frame.transform, here);
            return {frame.transform.translation, Quat(frame.transform.rotation)};
        }
        NodeTransform straight;
        straight.translation = frame.map.translation;
        require_usable(straight, here);
        const auto rotation = rotation_of(frame.map.linear);
        if (!rotation) here.fail("must not be flattened by a scale, as the frame of a joint");
        warnings_.push_back(here.place() + "is the frame of a joint below a nonuniform scale, which skews it; its x "
                                           "axis is kept, and the other axes are made perpendicular to it");
        if (!frame.body) return {straight.translation, Quat(*rotation)};
        const Transform body = scene_.world.body(*frame.body).transform();
        const glm::dquat back = glm::conjugate(glm::normalize(glm::dquat(body.rotation)));
        return {back * (straight.translation - body.position), Quat(glm::normalize(back * *rotation))};
    }

    std::optional<std::string> reason_to_idle(const JointDef& def) const {
        const auto is_dynamic = [&](BodyId body) {
            return !body.is_null() && scene_.world.body(body).type() == BodyType::dynamic;
        };
        if (def.body_a == def.body_b || !(is_dynamic(def.body_a) || is_dynamic(def.body_b))) {
            return "does not join two bodies of which one is dynamic, and has no effect";
        }
        const auto* general = std::get_if<GeneralJoint>(&def.joint);
        if (general != nullptr && free_rows(*general) > max_free_rows) {
            return "has more than " + std::to_string(max_free_rows) +
                   " limits and drives that are not plain locks, and has no effect";
        }
        return std::nullopt;
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
            if (const auto value = own->find("allow_sleep")) def.allow_sleep = value->boolean();
            if (const auto value = own->find("enabled")) def.enabled = value->boolean();
        }
        try {
            const BodyId body = scene_.world.create_body(def);
            if (const auto group = own ? own->find("group") : std::nullopt)
                groups_[group->integer(0, std::numeric_limits<int>::max())].push_back(body);
            return body;
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

    // Sets the properties that depend on the body having its shapes: shapes move its center of mass, and with it its
    // velocities.
    void finish_motion(const Value& motion, BodyId id, const NodeTransform& world) {
        const auto linear = read_vector(motion, "linearVelocity"), angular = read_vector(motion, "angularVelocity");
        Body body = scene_.world.body(id);
        const std::optional<MassProperties> mass = read_mass(motion, body, world.scale);
        warn_of_speed(motion, "linearVelocity", linear, scene_.world.settings().max_linear_speed, "m/s");
        warn_of_speed(motion, "angularVelocity", angular, scene_.world.settings().max_angular_speed, "rad/s");
        try {
            if (mass) body.set_mass_properties(*mass);
            // Every added shape moves the center of mass, which changes the origin by a rounding error.
            if (body.position() != world.translation) body.set_position(world.translation);
            if (linear) body.set_linear_velocity(turned(world.rotation, *linear));
            if (angular) body.set_angular_velocity(turned(world.rotation, *angular));
        } catch (const Error& error) {
            motion.fail(error);
        }
    }

    void warn_of_speed(const Value& motion, const char* name, const std::optional<glm::dvec3>& velocity, float most,
                       const char* unit) {
        if (!velocity || !(std::sqrt(glm::dot(*velocity, *velocity)) > static_cast<double>(most))) return;
        warnings_.push_back(motion.place() + name + " is reduced to the world's limit of " + short_number(most) + " " +
                            unit);
    }

    static std::optional<glm::dvec3> read_vector(const Value& owner, const char* name, const Range& range = any_float) {
        const auto vector = owner.find(name);
        return vector ? std::optional(vector->vector3(range)) : std::nullopt;
    }

    // Returns the mass properties that the file gives, completed by those computed from the shapes; nothing if the file
    // gives none.
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
        if (inertia) properties.inertia_diagonal = Vec3(real_moments(motion, *inertia));
        if (inertia || turn) properties.inertia_orientation = orientation;
        return properties;
    }

    // A zero moment stands for infinite inertia about that axis.
    glm::dvec3 real_moments(const Value& motion, const glm::dvec3& given) {
        if (given.x == 0.0 || given.y == 0.0 || given.z == 0.0) return given;
        const auto nearest = nearest_valid_moments(given);
        if (!nearest) return given;
        warnings_.push_back(motion.place() +
                            "inertiaDiagonal: one moment exceeds the sum of the other two, which is impossible; the "
                            "nearest possible moments are used: " +
                            short_number(nearest->x) + ", " + short_number(nearest->y) + ", " +
                            short_number(nearest->z));
        return *nearest;
    }

    bool has_massive_shape(const Body& body) const {
        for (const ShapeId shape : body.shapes()) {
            if (scene_.world.shape_def(shape).density > 0.0f) return true;
        }
        return false;
    }

    void add_collider(const Value& here, const Value& collider, BodyId body, const NodeTransform& in_body) {
        ShapeDef def;
        if (const auto index = collider.find("physicsMaterial")) {
            const PhysicsMaterial substance = colliders_.substance(*index);
            def.density = substance.density;
            def.material = substance.material;
            def.surface_velocity = substance.surface_velocity;
            def.one_way = substance.one_way;
            if (def.one_way != Vec3(0.0f) && scene_.world.body(body).type() == BodyType::dynamic) {
                index->refuse("a one-way surface may only belong to static and kinematic bodies");
            }
            if (def.surface_velocity != Vec3(0.0f) && scene_.world.body(body).type() == BodyType::dynamic) {
                index->refuse("a surface with a velocity may only belong to static and kinematic bodies");
            }
        }
        add_shape(here, collider, body, in_body, def);
    }

    void add_trigger(const Value& here, const Value& trigger, BodyId body, const NodeTransform& in_body) {
        ShapeDef def;
        def.is_trigger = true;
        def.density = 0.0f;
        add_shape(here, trigger, body, in_body, def);
    }

    // Adds the shape of a collider or trigger.
    void add_shape(const Value& here, const Value& owner, BodyId body, const NodeTransform& in_body, ShapeDef def) {
        require_usable(in_body, here);
        const Value geometry = owner.require("geometry");
        if (const auto index = owner.find("collisionFilter")) def.filter = filters_.filter(*index);
        if (in_body.scale.x == 0.0 || in_body.scale.y == 0.0 || in_body.scale.z == 0.0) {
            warnings_.push_back(owner.place() + "is disabled by a scale of zero");
            return;
        }
        const BodyType type = scene_.world.body(body).type();
        const Quat rotation = Quat(in_body.rotation);
        def.position = Vec3(in_body.translation);
        for (const TurnedShape& made : colliders_.shapes(geometry, in_body.scale, type, def.is_trigger, warnings_)) {
            def.rotation = rotation * made.rotation;
            try {
                const ShapeId id = scene_.world.add_shape(body, made.shape, def);
                if (const auto color = visuals_.color(here)) scene_.appearances.push_back({body, id, *color});
            } catch (const Error& error) {
                owner.fail(error);
            }
        }
    }

    Value document_;
    const NodeGraph& graph_;
    bool aims_camera_ = false; // whether the camera comes from the file and has only a direction yet
    Surfaces surfaces_;
    Colliders colliders_;
    Visuals visuals_;
    Filters filters_;
    std::vector<std::string> warnings_;
    JointTable joints_;
    Scene scene_;
    std::map<int, std::vector<BodyId>> groups_;           // keyed by the group numbers of the file
    std::vector<std::optional<JointFrame>> joint_frames_; // by node; only for nodes that the scene shows
    std::vector<std::size_t> joint_nodes_;
    std::vector<std::optional<BonePlace>> bone_places_; // by node; filled if the file has skins
    std::vector<std::size_t> skinned_nodes_;
};

Scene load_bytes(std::span<const std::byte> bytes, const std::string& name,
                 const std::optional<std::filesystem::path>& folder, const LoadOptions& options) {
    if (std::optional<Scene> model = load_model(bytes, name, folder, options)) return std::move(*model);
    const GltfFile gltf = parse_gltf(bytes, name);
    const Value document(gltf.json, name);
    check_document(document);
    const auto scene = default_scene(document);
    const auto own = scene ? extension(*scene, "CAIRN_world") : std::nullopt;
    std::vector<std::string> warnings;
    WorldSettings settings;
    if (own) settings = read_world_settings(*own, warnings);
    if (settings.info.title.empty() && scene) {
        if (const auto title = scene->find("name")) settings.info.title = title->text();
    }
    check_spelling(document, scene, warnings);
    const NodeGraph graph = read_node_graph(document, scene);
    const Buffers buffers(document, gltf.binary, folder);
    Scene result = Builder(document, buffers, graph, std::move(settings), std::move(warnings), options).build();
    if (!own && result.world.bodies().empty()) { // without CAIRN_world, an empty world is hardly intended
        result.warnings.push_back(document.place() +
                                  "has no body: no node that is shown has a motion, a collider or a trigger of "
                                  "KHR_physics_rigid_bodies, and nothing will move");
    }
    return result;
}

} // namespace

Scene load_from_memory(std::span<const std::byte> bytes, const std::string& name) {
    return load_bytes(bytes, name, std::nullopt, {});
}

Scene load(const std::filesystem::path& path, const LoadOptions& options) {
    return load_bytes(read_file(path), path.filename().generic_string(), path.parent_path(), options);
}

} // namespace cairn::scene
