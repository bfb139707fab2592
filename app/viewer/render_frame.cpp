#include "viewer/render_frame.h"

#include "viewer/fluid_drawing.h"
#include "viewer/joint_drawing.h"
#include "viewer/palette.h"
#include "viewer/solver_view.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <unordered_map>
#include <utility>

namespace cairn::viewer {

namespace {

constexpr double grid_period = 100.0; // meters; common period of all grid lines

// The color of a body in the modes that color whole bodies; else empty.
std::optional<Vec3> body_color(const WorldLayout& layout, const WorldMotion& motion, std::size_t index,
                               ColorMode mode) {
    const BodyLayout& body = layout.bodies[index];
    const bool moving = body.type == BodyType::dynamic;
    switch (mode) {
    case ColorMode::mass:
        return moving ? mass_ramp(mass_fraction(body.mass, layout.min_mass, layout.greatest_mass)) : static_color();
    case ColorMode::speed:
        return body.type == BodyType::static_ ? static_color() : speed_ramp(speed_fraction(motion.speeds[index]));
    case ColorMode::island:
        if (!moving) return static_color();
        if (!motion.awake[index]) return sleeping_color();
        return category_color(motion.islands.empty() ? 0u : motion.islands[index]);
    case ColorMode::shape:
    case ColorMode::scene:
        break;
    }
    return std::nullopt;
}

Vec3 color_of(const WorldLayout& layout, const WorldMotion& motion, const ShapeLayout& shape, ColorMode mode) {
    if (const auto color = body_color(layout, motion, shape.body, mode)) return *color;
    if (mode == ColorMode::shape) return shape_color(shape.type);
    if (shape.color) return *shape.color;
    if (shape.type == ShapeType::plane) return ground_color();
    if (shape.type == ShapeType::mesh) return surface_color();
    if (shape.type == ShapeType::height_field) return terrain_color();
    const BodyLayout& body = layout.bodies[shape.body];
    return body.type == BodyType::dynamic ? default_color(body.id.index()) : static_color();
}

Transform interpolate(const Transform& from, const Transform& to, float fraction) {
    if (fraction >= 1.0f) return to;
    // Interpolates along the shorter arc; the angle of one step is small, so normalized linear interpolation suffices.
    const float sign = glm::dot(from.rotation, to.rotation) < 0.0f ? -1.0f : 1.0f;
    const Quat mixed = from.rotation * (1.0f - fraction) + to.rotation * (sign * fraction);
    return {from.position + (to.position - from.position) * double(fraction), glm::normalize(mixed)};
}

// The instance list for a shape's type; the entry of a mesh must exist already.
std::vector<Instance>& instances_of(ShapeInstances& all, const ShapeLayout& shape) {
    if (shape.mesh) return all.meshes[*shape.mesh].instances;
    switch (shape.type) {
    case ShapeType::sphere:
        return all.spheres;
    case ShapeType::box:
        return all.boxes;
    case ShapeType::capsule:
        return all.capsules;
    case ShapeType::cylinder:
        return all.cylinders;
    default:
        return all.rectangles;
    }
}

GroundPlane ground_of(const Position& point, const Quat& rotation, const Position& origin, const Vec3& color) {
    const Vec3 normal = rotation * Vec3(0.0f, 1.0f, 0.0f);
    const glm::dvec3 offset = point - origin;
    const glm::dvec3 nearest = glm::dvec3(normal) * glm::dot(glm::dvec3(normal), offset);
    const glm::dvec3 from_point = nearest - offset;
    const auto along = [&](const Vec3& axis) {
        return float(std::fmod(glm::dot(from_point, glm::dvec3(rotation * axis)), grid_period));
    };
    return {Vec3(nearest), rotation, {along({1.0f, 0.0f, 0.0f}), along({0.0f, 0.0f, 1.0f})}, color};
}

Instance instance_at(const Position& position, const Quat& rotation, const Position& origin, const Vec3& color) {
    Instance instance;
    instance.position = Vec3(position - origin);
    instance.rotation = {rotation.x, rotation.y, rotation.z, rotation.w};
    instance.color = color;
    return instance;
}

// The bounding box edges of a trigger or disabled body: neither can be touched, so nothing solid is drawn. Planes have
// no box.
void add_outline(RenderFrame& frame, const ShapeLayout& shape, const Position& position, const Quat& rotation,
                 const Vec3& color) {
    if (shape.type == ShapeType::plane) return;
    const auto corner = [&](int i) {
        const Vec3 signs(i & 1 ? 1.0f : -1.0f, i & 2 ? 1.0f : -1.0f, i & 4 ? 1.0f : -1.0f);
        return Vec3(position - frame.origin) + rotation * (shape.bound_center + signs * shape.bound_extent);
    };
    for (int i = 0; i < 8; ++i)
        for (const int axis : {1, 2, 4})
            if (!(i & axis)) frame.lines.push_back({corner(i), corner(i | axis), color});
}

// Poses of all bodies, interpolated between two motions.
std::vector<Transform> poses_between(const WorldMotion& previous, const WorldMotion& current, float fraction) {
    std::vector<Transform> poses(current.transforms.size());
    for (std::size_t i = 0; i < poses.size(); ++i)
        poses[i] = interpolate(previous.transforms[i], current.transforms[i], fraction);
    return poses;
}

bool is_highlighted(BodyId body, const FrameOptions& options) {
    return (options.selected && body == options.selected) ||
           std::binary_search(options.selection.begin(), options.selection.end(), body);
}

Transform pose_of(const ShapeLayout& shape, const Transform& body) {
    return {body.position + Position(body.rotation * shape.position), glm::normalize(body.rotation * shape.rotation)};
}

// The corners of a box around the selected body, visible on bodies of any color: in the frame of its shape if it has
// only one. Not drawn for several bodies, which they would clutter, during a drag, which has its own marks, or around
// infinite shapes.
void add_selection_marks(RenderFrame& frame, const WorldLayout& layout, std::span<const Transform> transforms,
                         const FrameOptions& options) {
    if (!options.selected || options.selection.size() > 1 || options.drag) return;
    std::vector<const ShapeLayout*> shapes;
    for (const ShapeLayout& shape : layout.shapes)
        if (shape.bound_radius > 0.0f && layout.bodies[shape.body].id == options.selected) shapes.push_back(&shape);
    if (shapes.empty()) return;
    const bool is_alone = shapes.size() == 1;
    const Transform& body = transforms[shapes.front()->body];
    const Transform pose = is_alone ? pose_of(*shapes.front(), body) : body;
    Vec3 low(std::numeric_limits<float>::infinity()), high = -low;
    for (const ShapeLayout* shape : shapes) {
        const glm::mat3 turn = is_alone ? glm::mat3(1.0f) : glm::mat3_cast(shape->rotation);
        const Vec3 center = turn * shape->bound_center + (is_alone ? Vec3(0.0f) : shape->position);
        Vec3 extent(0.0f);
        for (int axis = 0; axis < 3; ++axis) extent += glm::abs(turn[axis]) * shape->bound_extent[axis];
        low = glm::min(low, center - extent);
        high = glm::max(high, center + extent);
    }
    constexpr float reach = 0.2f; // share of an edge, from each of its ends
    constexpr float width = 1.6f; // pixels
    const Vec3 origin(pose.position - frame.origin);
    for (int corner = 0; corner < 8; ++corner) {
        const auto is_high = [corner](int axis) { return (corner >> axis & 1) != 0; };
        const Vec3 at(is_high(0) ? high.x : low.x, is_high(1) ? high.y : low.y, is_high(2) ? high.z : low.z);
        for (int axis = 0; axis < 3; ++axis) {
            Vec3 end = at;
            end[axis] += (is_high(axis) ? -reach : reach) * (high[axis] - low[axis]);
            frame.strokes.push_back(
                {origin + pose.rotation * at, origin + pose.rotation * end, selection_color(), width});
        }
    }
}

void add_rigid(ShapeInstances& all, const Position& origin, const VisualLayout& visual, const WorldLayout& layout,
               const WorldMotion& motion, std::span<const Transform> transforms, const FrameOptions& options) {
    Transform pose = visual.local;
    Vec3 color = visual.color;
    bool is_selected = false, is_plain = false;
    if (visual.body) {
        const Transform& body = transforms[*visual.body];
        pose = {body.position + Position(body.rotation * Vec3(visual.local.position)),
                glm::normalize(body.rotation * visual.local.rotation)};
        const std::optional<Vec3> other = body_color(layout, motion, *visual.body, options.colors);
        color = other.value_or(visual.color);
        is_plain = other.has_value();
        is_selected = is_highlighted(layout.bodies[*visual.body].id, options);
    }
    MeshInstances& group = all.meshes[visual.mesh];
    Instance instance = instance_at(pose.position, pose.rotation, origin, color);
    instance.half_size = Vec3(1.0f);
    instance.pattern = is_plain ? 0.0f : 1.0f; // a color mode hides textures, so that its color is readable
    instance.emphasis = is_selected ? 1.0f : 0.0f;
    instance.bound_radius = glm::length(group.mesh->center) + group.mesh->radius;
    group.instances.push_back(instance);
}

// Adds a skinned mesh: a new mesh for this picture, with its origin at the position of the first bone.
void add_bent(ShapeInstances& all, const Position& origin, const VisualLayout& visual, const WorldLayout& layout,
              const WorldMotion& motion, std::span<const Transform> transforms, const FrameOptions& options) {
    const auto pose_of = [&](const VisualLayout::Part& part) {
        return part.body ? transforms[*part.body] : Transform{};
    };
    const ShapeMesh& mesh = *all.meshes[visual.mesh].mesh;
    const Transform first = pose_of(visual.parts[0]);
    const Position center = first.position + Position(glm::dquat(first.rotation) * visual.parts[0].translation);
    std::vector<BoneMap> bones;
    std::optional<Vec3> other;
    bool is_selected = false;
    for (const VisualLayout::Part& part : visual.parts) {
        const Transform pose = pose_of(part);
        const glm::dmat3 turn = glm::mat3_cast(glm::dquat(pose.rotation));
        bones.push_back({glm::mat3(turn * part.linear), Vec3(turn * part.translation + pose.position - center)});
        if (!part.body) continue;
        if (!other) other = body_color(layout, motion, *part.body, options.colors);
        is_selected = is_selected || is_highlighted(layout.bodies[*part.body].id, options);
    }
    ShapeMesh now = make_shape_mesh(bent(mesh.triangles, mesh.weights, bones), mesh.look);
    now.texture = mesh.texture;
    now.finish = mesh.finish;
    Instance instance = instance_at(center, Quat(1.0f, 0.0f, 0.0f, 0.0f), origin, other.value_or(visual.color));
    instance.half_size = Vec3(1.0f);
    instance.pattern = other ? 0.0f : 1.0f;
    instance.emphasis = is_selected ? 1.0f : 0.0f;
    instance.bound_radius = glm::length(now.center) + now.radius;
    all.meshes.push_back({std::make_shared<const ShapeMesh>(std::move(now)), {instance}});
}

// Whether the shape's body is drawn by visual meshes instead.
bool is_covered(const WorldLayout& layout, const ShapeLayout& shape, const FrameOptions& options) {
    return options.visuals && layout.bodies[shape.body].has_visuals && !shape.is_trigger;
}

void add_visual(ShapeInstances& all, const Position& origin, const VisualLayout& visual, const WorldLayout& layout,
                const WorldMotion& motion, std::span<const Transform> transforms, const FrameOptions& options) {
    if (visual.parts.empty())
        add_rigid(all, origin, visual, layout, motion, transforms, options);
    else
        add_bent(all, origin, visual, layout, motion, transforms, options);
}

bool is_any_shown(const VisualLayout& visual, const std::vector<char>& is_shown) {
    const auto shown = [&](const VisualLayout::Part& part) { return part.body && is_shown[*part.body]; };
    return visual.body ? is_shown[*visual.body] != 0 : std::any_of(visual.parts.begin(), visual.parts.end(), shown);
}

void add_solid(ShapeInstances& all, const Position& origin, const ShapeLayout& shape, const Transform& pose,
               const Vec3& color, const WorldLayout& layout, const FrameOptions& options) {
    Instance instance = instance_at(pose.position, pose.rotation, origin, color);
    instance.half_size = shape.half_size;
    instance.emphasis = is_highlighted(layout.bodies[shape.body].id, options) ? 1.0f : 0.0f;
    // Slopes are tinted only where the color is neither set by the scene nor meaningful in the color mode.
    if (shape.type == ShapeType::height_field && (shape.color || options.colors != ColorMode::scene))
        instance.pattern = 0.0f;
    instance.bound_radius = glm::length(shape.bound_center) + shape.bound_radius;
    instances_of(all, shape).push_back(instance);
}

// Strings are thin solid cylinders, with depth test and shadows.
void add_strings(RenderFrame& frame, const WorldMotion& motion, std::span<const Transform> transforms) {
    constexpr float thickness = 0.01f; // share of the length
    for (const JointLayout& joint : *motion.joints) {
        if (!joint.color || !joint.def.enabled) continue;
        const JointFrames ends = frames_of(joint, transforms);
        const Vec3 way(ends.b.position - ends.a.position);
        const float length = glm::length(way);
        if (length <= 0.0f) continue;
        // Rotation from the y axis, along which cylinders lie, to the string: the quaternion of half the angle about
        // the common perpendicular.
        const Vec3 along = way / length;
        const Quat half(1.0f + along.y, along.z, 0.0f, -along.x);
        const Quat rotation = along.y > -0.999f ? glm::normalize(half) : Quat(0.0f, 1.0f, 0.0f, 0.0f);
        Instance instance =
            instance_at(0.5 * (ends.a.position + ends.b.position), rotation, frame.origin, *joint.color);
        instance.half_size = Vec3(0.5f * thickness, 0.5f, 0.5f * thickness) * length;
        instance.pattern = 0.0f;
        instance.bound_radius = 0.51f * length;
        frame.cylinders.push_back(instance);
    }
}

// Visible through all surfaces: the grabbed point may be on the far side, and the target inside a body.
void add_drag(RenderFrame& frame, const WorldLayout& layout, std::span<const Transform> transforms,
              const DragLine& drag) {
    const auto body = std::find_if(layout.bodies.begin(), layout.bodies.end(),
                                   [&](const BodyLayout& known) { return known.id == drag.body; });
    if (body == layout.bodies.end()) return;
    const Transform& pose = transforms[std::size_t(body - layout.bodies.begin())];
    const Vec3 held(pose.position + Position(pose.rotation * drag.local_point) - frame.origin);
    const Vec3 target(drag.target - frame.origin);
    constexpr float line_width = 2.5f, held_width = 9.0f, target_width = 6.0f; // pixels
    frame.strokes.push_back({held, target, drag_color(), line_width});
    frame.strokes.push_back({held, held, drag_color(), held_width});
    frame.strokes.push_back({target, target, drag_color(), target_width});
}

// Adds a ground plane. An orthographic camera parallel to the plane sees only its edge, which is drawn as a line.
void add_plane(RenderFrame& frame, const Transform& pose, const Vec3& color) {
    frame.grounds.push_back(ground_of(pose.position, pose.rotation, frame.origin, color));
    const Vec3 to_target(frame.camera.target - frame.camera.position), normal = pose.rotation * Vec3(0.0f, 1.0f, 0.0f);
    const float distance = glm::length(to_target);
    constexpr float level = 1e-3f, reach = 20.0f; // share of the distance to the target
    if (!frame.camera.is_parallel || std::abs(glm::dot(to_target, normal)) > level * distance) return;
    const Vec3 target(frame.camera.target - frame.origin), point(pose.position - frame.origin);
    const Vec3 middle = target - normal * glm::dot(target - point, normal);
    const Vec3 half = glm::normalize(glm::cross(to_target, normal)) * (reach * distance);
    frame.lines.push_back({middle - half, middle + half, 0.35f * color});
}

} // namespace

const char* name_of(ColorMode mode) {
    switch (mode) {
    case ColorMode::scene:
        return "scene";
    case ColorMode::mass:
        return "mass";
    case ColorMode::speed:
        return "speed";
    case ColorMode::island:
        return "island and sleep";
    case ColorMode::shape:
        return "shape";
    }
    return "";
}

const char* name_of(JointsShown shown) {
    constexpr const char* names[joints_shown_count] = {"selected or loaded", "all", "none"};
    return names[int(shown)];
}

RenderFrame make_frame(const WorldLayout& layout, const WorldMotion& previous, const WorldMotion& current,
                       float fraction, const CameraPose& camera, const FrameOptions& options) {
    RenderFrame frame;
    frame.origin = OrbitCamera(camera).render_origin();
    frame.camera = camera;
    frame.grid = options.grid;
    frame.shadows = options.shadows;
    frame.lighting = options.lighting;
    const std::vector<Transform> transforms = poses_between(previous, current, fraction);
    for (const auto& mesh : layout.meshes) frame.meshes.push_back({mesh, {}});
    if (options.visuals)
        for (const VisualLayout& visual : layout.visuals)
            if (!visual.body || layout.bodies[*visual.body].is_enabled)
                add_visual(frame, frame.origin, visual, layout, current, transforms, options);
    for (const ShapeLayout& shape : layout.shapes) {
        const BodyLayout& body = layout.bodies[shape.body];
        if (body.is_enabled && is_covered(layout, shape, options)) continue;
        const Transform pose = pose_of(shape, transforms[shape.body]);
        if (shape.is_trigger || !body.is_enabled) {
            const Vec3 color = !body.is_enabled ? disabled_color() : trigger_color();
            add_outline(frame, shape, pose.position, pose.rotation,
                        is_highlighted(body.id, options) ? selection_color() : color);
            continue;
        }
        const Vec3 color = color_of(layout, current, shape, options.colors);
        if (shape.type == ShapeType::plane)
            add_plane(frame, pose, color);
        else
            add_solid(frame, frame.origin, shape, pose, color, layout, options);
    }
    draw_fluids(frame, current);
    if (current.joints) add_strings(frame, current, transforms);
    if (options.joints != JointsShown::none && current.joints) draw_joints(frame, layout, current, transforms, options);
    if (current.solver) draw_solver(frame, *current.solver);
    add_selection_marks(frame, layout, transforms, options);
    if (options.drag) add_drag(frame, layout, transforms, *options.drag);
    return frame;
}

void add_ghosts(RenderFrame& frame, const WorldLayout& layout, const WorldMotion& current, const RunPicture& other,
                float fraction, const FrameOptions& options) {
    std::unordered_map<BodyId, std::size_t> places;
    for (std::size_t i = 0; i < layout.bodies.size(); ++i) places.emplace(layout.bodies[i].id, i);
    const WorldLayout& ghosts = *other.layout;
    std::vector<char> is_shown(ghosts.bodies.size(), 1);
    for (std::size_t i = 0; i < ghosts.bodies.size(); ++i)
        if (const auto here = places.find(ghosts.bodies[i].id); here != places.end())
            is_shown[i] = is_elsewhere(current.transforms[here->second], other.current->transforms[i]);
    const std::vector<Transform> transforms = poses_between(*other.previous, *other.current, fraction);
    FrameOptions plain = options;
    plain.selected = {};
    plain.selection.clear();
    for (const auto& mesh : ghosts.meshes) frame.ghosts.meshes.push_back({mesh, {}});
    if (options.visuals)
        for (const VisualLayout& visual : ghosts.visuals)
            if (is_any_shown(visual, is_shown))
                add_visual(frame.ghosts, frame.origin, visual, ghosts, *other.current, transforms, plain);
    for (const ShapeLayout& shape : ghosts.shapes) {
        if (!is_shown[shape.body] || is_covered(ghosts, shape, options) || shape.is_trigger) continue;
        if (shape.type == ShapeType::plane) continue;
        add_solid(frame.ghosts, frame.origin, shape, pose_of(shape, transforms[shape.body]),
                  color_of(ghosts, *other.current, shape, options.colors), ghosts, plain);
    }
}

RenderFrame make_frame(const World& world, std::span<const Appearance> appearances, const CameraPose& camera,
                       const FrameOptions& options, MeshCache& meshes, std::span<const Visual> visuals,
                       std::span<const JointAppearance> strings) {
    const WorldLayout layout = read_layout(world, appearances, meshes, visuals);
    std::shared_ptr<const std::vector<JointLayout>> joints;
    if (options.joints != JointsShown::none || !strings.empty())
        joints = std::make_shared<const std::vector<JointLayout>>(read_joints(world, layout, {}, strings));
    const WorldMotion motion = read_motion(world, layout, options.colors == ColorMode::island, std::move(joints));
    return make_frame(layout, motion, motion, 1.0f, camera, options);
}

RenderFrame make_frame(const World& world, std::span<const Appearance> appearances, const CameraPose& camera,
                       const FrameOptions& options) {
    MeshCache meshes;
    return make_frame(world, appearances, camera, options, meshes);
}

} // namespace cairn::viewer
