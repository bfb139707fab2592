#include "viewer/world_state.h"

#include "viewer/fluid_drawing.h"

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <unordered_map>
#include <utility>

namespace cairn::viewer {

namespace {

constexpr float strip_half_length = 1000.0f; // m; drawn half length of rectangles that are infinite along one axis

// The rotation of a frame with y along the normal and x along the tangent.
Quat plane_frame(const Plane& plane) {
    const Vec3 normal = glm::normalize(plane.normal);
    Vec3 tangent = plane.tangent - normal * glm::dot(normal, plane.tangent);
    if (glm::dot(tangent, tangent) < 1e-8f) {
        tangent = std::abs(normal.x) < 0.7f ? Vec3(1.0f, 0.0f, 0.0f) : Vec3(0.0f, 0.0f, 1.0f);
        tangent -= normal * glm::dot(normal, tangent);
    }
    tangent = glm::normalize(tangent);
    return glm::normalize(glm::quat_cast(Mat3(tangent, normal, glm::cross(tangent, normal))));
}

// Sets type, size and bounds of a shape; for planes also the rotation.
struct ShapeReader {
    ShapeLayout& layout;

    void operator()(const Sphere& sphere) const {
        set(ShapeType::sphere, Vec3(sphere.radius), Vec3(sphere.radius), sphere.radius);
    }
    void operator()(const Box& box) const { set_box(ShapeType::box, box.half_extents); }
    void operator()(const Plane& plane) const {
        layout.rotation = layout.rotation * plane_frame(plane);
        layout.type = ShapeType::plane;
        if (!plane.half_extents) return;
        const glm::vec2 half = glm::min(*plane.half_extents, glm::vec2(strip_half_length));
        set_box(ShapeType::rectangle, {half.x, 0.0f, half.y});
    }
    void operator()(const Capsule& capsule) const {
        const float top = capsule.radius_top.value_or(capsule.radius), wide = std::max(capsule.radius, top);
        const float reach = capsule.half_height + wide;
        set(ShapeType::capsule, {capsule.radius, capsule.half_height, top}, {wide, reach, wide}, reach);
    }
    void operator()(const Cylinder& cylinder) const {
        const float top = cylinder.radius_top.value_or(cylinder.radius), wide = std::max(cylinder.radius, top);
        set(ShapeType::cylinder, {cylinder.radius, cylinder.half_height, top}, {wide, cylinder.half_height, wide},
            glm::length(glm::vec2(cylinder.half_height, wide)));
    }
    // The bounds of these shapes are set with their meshes.
    void operator()(const Hull&) const { set(ShapeType::hull, Vec3(1.0f), Vec3(0.0f), 0.0f); }
    void operator()(const Mesh&) const { set(ShapeType::mesh, Vec3(1.0f), Vec3(0.0f), 0.0f); }
    void operator()(const HeightField&) const { set(ShapeType::height_field, Vec3(1.0f), Vec3(0.0f), 0.0f); }

  private:
    void set_box(ShapeType type, const Vec3& half) const { set(type, half, half, glm::length(half)); }
    void set(ShapeType type, const Vec3& half_size, const Vec3& bound_extent, float bound_radius) const {
        layout.type = type;
        layout.half_size = half_size;
        layout.bound_extent = bound_extent;
        layout.bound_radius = bound_radius;
    }
};

// Adds meshes to a layout, each once.
class MeshList {
  public:
    explicit MeshList(WorldLayout& layout) : layout_(layout) {}
    std::size_t add(const std::shared_ptr<const ShapeMesh>& mesh) {
        const auto [place, is_new] = places_.try_emplace(mesh.get(), layout_.meshes.size());
        if (is_new) layout_.meshes.push_back(mesh);
        return place->second;
    }
    void give_mesh(ShapeLayout& shape, const std::shared_ptr<const ShapeMesh>& mesh) {
        if (!mesh) return;
        shape.mesh = add(mesh);
        shape.half_size = Vec3(1.0f); // mesh coordinates are meters already
        shape.bound_center = mesh->center;
        shape.bound_extent = mesh->extent;
        shape.bound_radius = mesh->radius;
    }

  private:
    WorldLayout& layout_;
    std::unordered_map<const ShapeMesh*, std::size_t> places_;
};

void add_visuals(WorldLayout& layout, MeshList& meshes, std::span<const Visual> visuals) {
    if (visuals.empty()) return;
    std::unordered_map<BodyId, std::size_t> bodies;
    for (std::size_t i = 0; i < layout.bodies.size(); ++i) bodies.emplace(layout.bodies[i].id, i);
    for (const Visual& visual : visuals) {
        VisualLayout shown{std::nullopt, visual.local, 0, visual.color};
        if (visual.body) {
            const auto body = bodies.find(visual.body);
            if (body == bodies.end()) continue;
            shown.body = body->second;
            layout.bodies[body->second].has_visuals = true;
        }
        bool is_whole = true;
        for (const Bone& bone : visual.bones) {
            const auto body = bodies.find(bone.body);
            is_whole = is_whole && (bone.body.is_null() || body != bodies.end());
            std::optional<std::size_t> place;
            if (body != bodies.end()) place = body->second;
            shown.parts.push_back({place, bone.linear, bone.translation});
        }
        if (!is_whole) continue; // one of its bodies was destroyed
        for (const VisualLayout::Part& part : shown.parts)
            if (part.body) layout.bodies[*part.body].has_visuals = true;
        shown.mesh = meshes.add(visual.mesh);
        layout.visuals.push_back(std::move(shown));
    }
}

ShapeLayout read_shape(const World& world, ShapeId id, std::size_t body) {
    const ShapeDef& def = world.shape_def(id);
    ShapeLayout layout;
    layout.body = body;
    layout.position = def.position;
    layout.rotation = glm::normalize(def.rotation);
    layout.is_trigger = def.is_trigger;
    std::visit(ShapeReader{layout}, world.shape(id));
    return layout;
}

// The root of a union-find tree, with path halving.
std::uint32_t find_root(std::vector<std::uint32_t>& parents, std::uint32_t index) {
    while (parents[index] != index) {
        parents[index] = parents[parents[index]];
        index = parents[index];
    }
    return index;
}

std::vector<std::uint32_t> find_islands(const World& world, const WorldLayout& layout) {
    std::unordered_map<BodyId, std::uint32_t> dynamic_bodies;
    for (std::size_t i = 0; i < layout.bodies.size(); ++i)
        if (layout.bodies[i].type == BodyType::dynamic && layout.bodies[i].is_enabled)
            dynamic_bodies.emplace(layout.bodies[i].id, std::uint32_t(i));
    std::vector<std::uint32_t> parents(layout.bodies.size());
    std::iota(parents.begin(), parents.end(), 0u);
    const auto join = [&](BodyId body_a, BodyId body_b) {
        const auto a = dynamic_bodies.find(body_a), b = dynamic_bodies.find(body_b);
        if (a == dynamic_bodies.end() || b == dynamic_bodies.end()) return;
        const std::uint32_t root_a = find_root(parents, a->second), root_b = find_root(parents, b->second);
        parents[std::max(root_a, root_b)] = std::min(root_a, root_b);
    };
    for (const Contact& contact : world.contacts()) join(contact.body_a, contact.body_b);
    for (const JointId joint : world.joints()) join(world.joint_def(joint).body_a, world.joint_def(joint).body_b);
    for (std::uint32_t i = 0; i < parents.size(); ++i) parents[i] = find_root(parents, i);
    return parents;
}

} // namespace

std::string label_of(BodyId body, const std::string& name) {
    return name.empty() ? "body " + std::to_string(body.index()) : name;
}

WorldLayout read_layout(const World& world, std::span<const Appearance> appearances, MeshCache& meshes,
                        std::span<const Visual> visuals) {
    std::unordered_map<ShapeId, Vec3> colors;
    for (const Appearance& appearance : appearances) colors.emplace(appearance.shape, appearance.color);
    WorldLayout layout;
    MeshList mesh_list(layout);
    bool any_mass = false;
    for (const BodyId id : world.bodies()) {
        const Body body = world.body(id);
        const float mass = body.mass();
        if (body.type() == BodyType::dynamic && std::isfinite(mass)) {
            layout.min_mass = any_mass ? std::min(layout.min_mass, mass) : mass;
            layout.greatest_mass = any_mass ? std::max(layout.greatest_mass, mass) : mass;
            any_mass = true;
        }
        for (const ShapeId shape : body.shapes()) {
            layout.shapes.push_back(read_shape(world, shape, layout.bodies.size()));
            mesh_list.give_mesh(layout.shapes.back(), meshes.mesh_of(world.shape(shape)));
            const auto color = colors.find(shape);
            if (color != colors.end()) layout.shapes.back().color = color->second;
        }
        layout.bodies.push_back({id, body.type(), mass, body.name(), body.enabled(), false});
    }
    meshes.drop_unused();
    add_visuals(layout, mesh_list, visuals);
    return layout;
}

WorldMotion read_motion(const World& world, const WorldLayout& layout, bool with_islands,
                        std::shared_ptr<const std::vector<JointLayout>> joints) {
    const std::size_t count = layout.bodies.size();
    WorldMotion motion;
    motion.transforms.resize(count);
    motion.speeds.resize(count);
    motion.awake.resize(count);
    std::vector<BodyId> ids(count);
    for (std::size_t i = 0; i < count; ++i) ids[i] = layout.bodies[i].id;
    world.read_transforms(ids, motion.transforms);
    for (std::size_t i = 0; i < count; ++i) {
        if (layout.bodies[i].type == BodyType::static_) continue;
        const Body body = world.body(ids[i]);
        motion.speeds[i] = glm::length(body.linear_velocity());
        motion.awake[i] = body.is_awake() ? 1 : 0;
    }
    motion.fluids = read_fluids(world);
    if (with_islands) motion.islands = find_islands(world, layout);
    motion.joints = std::move(joints);
    if (!motion.joints) return motion;
    motion.joint_states.reserve(motion.joints->size());
    for (const JointLayout& joint : *motion.joints) motion.joint_states.push_back(world.joint_state(joint.id));
    return motion;
}

namespace {

// An axis-aligned box that grows, and the sphere around it.
struct Extent {
    Position least{1e300}, greatest{-1e300};

    void include(const Position& from, const Position& to) {
        least = glm::min(least, from);
        greatest = glm::max(greatest, to);
    }
    void include_ball(const Position& center, double radius) { include(center - radius, center + radius); }
    void include_visual(const Transform& pose, const ShapeMesh& mesh) {
        include_ball(pose.position + Position(pose.rotation * mesh.center), double(mesh.radius));
    }
    bool is_empty() const { return least.x > greatest.x; }
    BoundingBall ball() const {
        if (is_empty()) return {};
        return {(least + greatest) * 0.5, float(glm::length(greatest - least) * 0.5)};
    }
};

// Distance that an object with these bounds falls onto a static or kinematic body; 0 if there is nothing below.
double height_of_fall(const World& world, const Bounds& bounds, const Position& gravity) {
    constexpr double highest = 1e4; // m
    if (gravity == Position(0.0)) return 0.0;
    const Position middle = 0.5 * (bounds.min + bounds.max);
    for (const RayHit& hit : world.cast_ray_all(middle, Vec3(gravity), highest)) {
        if (world.body(hit.body).type() == BodyType::dynamic) continue;
        const double reach = 0.5 * glm::dot(bounds.max - bounds.min, glm::abs(gravity));
        return std::max(hit.distance - reach, 0.0);
    }
    return 0.0;
}

} // namespace

BoundingBall bounding_ball(const WorldLayout& layout, const WorldMotion& motion) {
    const bool any_dynamic = std::any_of(layout.bodies.begin(), layout.bodies.end(),
                                         [](const BodyLayout& body) { return body.type == BodyType::dynamic; });
    Extent extent;
    for (const ShapeLayout& shape : layout.shapes) {
        if (shape.type == ShapeType::plane) continue;
        if (any_dynamic && layout.bodies[shape.body].type != BodyType::dynamic) continue;
        const Transform& body = motion.transforms[shape.body];
        const Vec3 in_body = shape.position + shape.rotation * shape.bound_center;
        const Position center = body.position + Position(body.rotation * in_body);
        extent.include_ball(center, double(shape.bound_radius));
    }
    if (extent.is_empty())
        for (const VisualLayout& visual : layout.visuals)
            if (!visual.body && visual.parts.empty()) extent.include_visual(visual.local, *layout.meshes[visual.mesh]);
    return extent.ball();
}

CameraPose fit_camera(const World& world, std::span<const Visual> visuals) {
    Extent dynamic, all;
    const Vec3 pull = world.settings().gravity;
    const Position gravity = pull == Vec3(0.0f) ? Position(0.0) : Position(glm::normalize(pull));
    for (const BodyId id : world.bodies()) {
        const Body body = world.body(id);
        for (const ShapeId shape : body.shapes()) {
            const Bounds bounds = world.shape_bounds(shape);
            if (!std::isfinite(bounds.min.x) || !std::isfinite(bounds.max.x)) continue; // an infinite plane
            all.include(bounds.min, bounds.max);
            if (body.type() != BodyType::dynamic) continue;
            dynamic.include(bounds.min, bounds.max);
            const double fall = height_of_fall(world, bounds, gravity);
            dynamic.include(bounds.min + fall * gravity, bounds.max + fall * gravity);
        }
    }
    if (all.is_empty())
        for (const Visual& visual : visuals)
            if (!visual.body && visual.bones.empty()) all.include_visual(visual.local, *visual.mesh);
    const BoundingBall ball = dynamic.is_empty() ? all.ball() : dynamic.ball();
    OrbitCamera camera(CameraPose{ball.center + Position(0.6, 0.4, 1.0), ball.center, 0.785398f});
    camera.frame(ball.center, ball.radius);
    return camera.pose();
}

} // namespace cairn::viewer
