#include "recording/foxglove.h"

#include <cairn/triangles.h>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cmath>
#include <variant>
#include <vector>

namespace cairn::recording {

namespace {

constexpr std::string_view foxglove_messages = R"(
message Vector3
double x 1
double y 2
double z 3
message Point3
double x 1
double y 2
double z 3
message Quaternion
double x 1
double y 2
double z 3
double w 4
message Pose
Vector3 position 1
Quaternion orientation 2
message Color
double r 1
double g 2
double b 3
double a 4
message KeyValuePair
string key 1
string value 2
message FrameTransform
Timestamp timestamp 1
string parent_frame_id 2
string child_frame_id 3
Vector3 translation 4
Quaternion rotation 5
message FrameTransforms
repeated FrameTransform transforms 1
message ArrowPrimitive
Pose pose 1
double shaft_length 2
double shaft_diameter 3
double head_length 4
double head_diameter 5
Color color 6
message CubePrimitive
Pose pose 1
Vector3 size 2
Color color 3
message SpherePrimitive
Pose pose 1
Vector3 size 2
Color color 3
message CylinderPrimitive
Pose pose 1
Vector3 size 2
double bottom_scale 3
double top_scale 4
Color color 5
message LinePrimitive
enum Type LINE_STRIP LINE_LOOP LINE_LIST
Type type 1
Pose pose 2
double thickness 3
bool scale_invariant 4
repeated Point3 points 5
Color color 6
repeated Color colors 7
repeated fixed32 indices 8
message TriangleListPrimitive
Pose pose 1
repeated Point3 points 2
Color color 3
repeated Color colors 4
repeated fixed32 indices 5
message TextPrimitive
Pose pose 1
bool billboard 2
double font_size 3
bool scale_invariant 4
Color color 5
string text 6
message ModelPrimitive
Pose pose 1
Vector3 scale 2
Color color 3
bool override_color 4
string url 5
string media_type 6
bytes data 7
message SceneEntityDeletion
enum Type MATCHING_ID ALL
Timestamp timestamp 1
Type type 2
string id 3
message SceneEntity
Timestamp timestamp 1
string frame_id 2
string id 3
Duration lifetime 4
bool frame_locked 5
repeated KeyValuePair metadata 6
repeated ArrowPrimitive arrows 7
repeated CubePrimitive cubes 8
repeated SpherePrimitive spheres 9
repeated CylinderPrimitive cylinders 10
repeated LinePrimitive lines 11
repeated TriangleListPrimitive triangles 12
repeated TextPrimitive texts 13
repeated ModelPrimitive models 14
message SceneUpdate
repeated SceneEntityDeletion deletions 1
repeated SceneEntity entities 2
message JointState
string name 1
double position 2
double velocity 3
double acceleration 4
double effort 5
message JointStates
Timestamp timestamp 1
repeated JointState joints 2
message Log
enum Level UNKNOWN DEBUG INFO WARNING ERROR FATAL
Timestamp timestamp 1
Level level 2
string message 3
string name 4
string file 5
fixed32 line 6
)";

constexpr std::string_view own_messages = R"(
message Statistics
Timestamp timestamp 1
uint64 bodies 2
uint64 awake_bodies 3
uint64 contacts 4
uint64 islands 5
double kinetic_energy 6
double potential_energy 7
double max_penetration 8
double step_milliseconds 9
message JointLoad
string name 1
double force 2
double torque 3
double gap 4
message JointLoads
Timestamp timestamp 1
repeated JointLoad joints 2
)";

// Drawn size and thickness of an infinite plane, m.
constexpr float plane_size = 100.0f, plane_thickness = 0.01f; // m

template <class V> ProtoWriter vector_message(const V& v) {
    ProtoWriter result;
    return result.real(1, double(v.x)).real(2, double(v.y)).real(3, double(v.z));
}

ProtoWriter rotation_message(const Quat& q) {
    ProtoWriter result;
    return result.real(1, double(q.x)).real(2, double(q.y)).real(3, double(q.z)).real(4, double(q.w));
}

ProtoWriter pose_message(const Transform& pose) {
    ProtoWriter result;
    return result.message(1, vector_message(pose.position)).message(2, rotation_message(pose.rotation));
}

// The rotation that turns one direction into another.
Quat turn_to(const Vec3& from, const Vec3& to) {
    const float c = glm::dot(from, to);
    if (c < -0.9999f) {
        const Vec3 other = std::abs(from.x) < 0.9f ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
        return glm::angleAxis(3.14159265f, glm::normalize(glm::cross(from, other)));
    }
    const Vec3 axis = glm::cross(from, to);
    return glm::normalize(Quat(1.0f + c, axis.x, axis.y, axis.z));
}

Transform placed(const Transform& frame, const Vec3& position, const Quat& rotation = Quat(1, 0, 0, 0)) {
    return {frame.position + Position(frame.rotation * position), frame.rotation * rotation};
}

void append_faces(const Hull& hull, std::vector<std::uint32_t>& indices) {
    for (std::size_t i = 0; i < hull.face_count(); ++i) {
        const auto face = hull.face(i);
        for (std::size_t k = 2; k < face.size(); ++k) indices.insert(indices.end(), {face[0], face[k - 1], face[k]});
    }
}

struct Surface {
    std::vector<Vec3> points;
    std::vector<std::uint32_t> indices;
};

Surface surface_of(const HeightField& field) {
    Surface result;
    const std::vector<Vec3> vertices = field.vertices();
    for (const std::uint32_t corner : field.indices()) {
        result.indices.push_back(std::uint32_t(result.points.size()));
        result.points.push_back(vertices[corner]);
    }
    return result;
}

} // namespace

std::string foxglove_schemas() { return describe_messages("foxglove", foxglove_messages); }
std::string own_schemas() { return describe_messages("cairn", own_messages); }

ProtoWriter timestamp_message(std::uint64_t nanoseconds) {
    ProtoWriter result;
    return result.number(1, nanoseconds / 1'000'000'000).number(2, nanoseconds % 1'000'000'000);
}

ProtoWriter transform_message(std::uint64_t nanoseconds, std::string_view parent, std::string_view child,
                              const Position& position, const Quat& rotation) {
    ProtoWriter result;
    result.message(1, timestamp_message(nanoseconds)).text(2, parent).text(3, child);
    return result.message(4, vector_message(position)).message(5, rotation_message(rotation));
}

EntityWriter::EntityWriter(std::uint64_t nanoseconds, std::string_view frame, std::string_view id, bool is_locked) {
    entity_.message(1, timestamp_message(nanoseconds)).text(2, frame).text(3, id).number(5, is_locked ? 1 : 0);
}

void EntityWriter::add_box(const Transform& pose, const Vec3& size) {
    ProtoWriter cube;
    entity_.message(8, cube.message(1, pose_message(pose)).message(2, vector_message(size)).message(3, color_));
}

void EntityWriter::add_ball(const Transform& pose, float radius) {
    ProtoWriter ball;
    const Vec3 size(2.0f * radius);
    entity_.message(9, ball.message(1, pose_message(pose)).message(2, vector_message(size)).message(3, color_));
}

// Foxglove's cylinders have z as axis, Cairn's y.
void EntityWriter::add_cylinder(const Transform& pose, float half_height, float low, float high) {
    const float widest = std::max(low, high);
    ProtoWriter cylinder;
    cylinder.message(1, pose_message(placed(pose, Vec3(0.0f), turn_to(Vec3(0, 0, 1), Vec3(0, 1, 0)))))
        .message(2, vector_message(Vec3(2.0f * widest, 2.0f * widest, 2.0f * half_height)))
        .real(3, double(low / widest))
        .real(4, double(high / widest));
    entity_.message(10, cylinder.message(5, color_));
}

void EntityWriter::add_triangles(const Transform& pose, std::span<const Vec3> points,
                                 std::span<const std::uint32_t> indices) {
    ProtoWriter list;
    list.message(1, pose_message(pose));
    for (const Vec3& point : points) list.message(2, vector_message(point));
    entity_.message(12, list.message(3, color_).fixed(5, indices));
}

void EntityWriter::add_shape(const Shape& shape, const Vec3& position, const Quat& rotation, const Vec3& color) {
    color_ = {};
    color_.real(1, double(color.x)).real(2, double(color.y)).real(3, double(color.z)).real(4, 1.0);
    const Transform pose{Position(position), rotation};
    if (rounding_of(shape) > 0.0f) {
        const ShapeTriangles surface = rounded_triangles(shape);
        return add_triangles(pose, surface.vertices, surface.indices);
    }
    if (const auto* ball = std::get_if<Sphere>(&shape)) return add_ball(pose, ball->radius);
    if (const auto* box = std::get_if<Box>(&shape)) return add_box(pose, 2.0f * box->half_extents);
    if (const auto* capsule = std::get_if<Capsule>(&shape)) {
        const float top = capsule->radius_top.value_or(capsule->radius);
        add_cylinder(pose, capsule->half_height, capsule->radius, top);
        add_ball(placed(pose, {0.0f, -capsule->half_height, 0.0f}), capsule->radius);
        return add_ball(placed(pose, {0.0f, capsule->half_height, 0.0f}), top);
    }
    if (const auto* cylinder = std::get_if<Cylinder>(&shape))
        return add_cylinder(pose, cylinder->half_height, cylinder->radius,
                            cylinder->radius_top.value_or(cylinder->radius));
    if (const auto* plane = std::get_if<Plane>(&shape)) {
        const Vec3 normal = glm::normalize(plane->normal);
        const auto end = [](float half) { return std::isfinite(half) ? 2.0f * half : plane_size; };
        const glm::vec2 half = plane->half_extents.value_or(glm::vec2(0.5f * plane_size));
        const Vec3 across = plane->tangent - glm::dot(plane->tangent, normal) * normal;
        const Quat turn =
            plane->half_extents && glm::length(across) > 1e-6f
                ? glm::quat_cast(glm::mat3(glm::normalize(across), normal, glm::cross(glm::normalize(across), normal)))
                : turn_to(Vec3(0, 1, 0), normal);
        const Transform surface = placed(pose, -0.5f * plane_thickness * normal, turn);
        return add_box(surface, {end(half.x), plane_thickness, end(half.y)});
    }
    if (const auto* hull = std::get_if<Hull>(&shape)) {
        std::vector<std::uint32_t> indices;
        append_faces(*hull, indices);
        return add_triangles(pose, hull->vertices(), indices);
    }
    if (const auto* mesh = std::get_if<Mesh>(&shape)) return add_triangles(pose, mesh->vertices(), mesh->indices());
    const Surface surface = surface_of(std::get<HeightField>(shape));
    add_triangles(pose, surface.points, surface.indices);
}

// Foxglove's arrows point along x.
void EntityWriter::add_arrow(const Position& from, const Vec3& way, const Vec3& color) {
    const float length = glm::length(way);
    if (!(length > 0.0f)) return;
    ProtoWriter arrow, paint;
    paint.real(1, double(color.x)).real(2, double(color.y)).real(3, double(color.z)).real(4, 1.0);
    arrow.message(1, pose_message({from, turn_to(Vec3(1, 0, 0), way / length)}))
        .real(2, double(0.8f * length))
        .real(3, double(0.06f * length))
        .real(4, double(0.2f * length))
        .real(5, double(0.14f * length));
    entity_.message(7, arrow.message(6, paint));
}

} // namespace cairn::recording
