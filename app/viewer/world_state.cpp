#include "viewer/world_state.h"

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <unordered_map>

namespace cairn::viewer {

namespace {

// The frame with y along the normal and x along the tangent.
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

ShapeLayout read_shape(const World& world, ShapeId id, std::size_t body) {
    const ShapeDef& def = world.shape_def(id);
    ShapeLayout layout;
    layout.body = body;
    layout.position = def.position;
    layout.rotation = glm::normalize(def.rotation);
    const Shape& shape = world.shape(id);
    if (const Sphere* sphere = std::get_if<Sphere>(&shape)) {
        layout.type = ShapeType::sphere;
        layout.half_size = Vec3(sphere->radius);
    } else if (const Box* box = std::get_if<Box>(&shape)) {
        layout.type = ShapeType::box;
        layout.half_size = box->half_extents;
    } else {
        const Plane& plane = std::get<Plane>(shape);
        layout.type = plane.half_extents ? ShapeType::rectangle : ShapeType::plane;
        layout.rotation = layout.rotation * plane_frame(plane);
        if (plane.half_extents) layout.half_size = {plane.half_extents->x, 0.0f, plane.half_extents->y};
    }
    return layout;
}

// The root of a union-find tree, halving paths on the way.
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
        if (layout.bodies[i].type == BodyType::dynamic) dynamic_bodies.emplace(layout.bodies[i].id, std::uint32_t(i));
    std::vector<std::uint32_t> parents(layout.bodies.size());
    std::iota(parents.begin(), parents.end(), 0u);
    for (const Contact& contact : world.contacts()) {
        const auto a = dynamic_bodies.find(contact.body_a), b = dynamic_bodies.find(contact.body_b);
        if (a == dynamic_bodies.end() || b == dynamic_bodies.end()) continue;
        const std::uint32_t root_a = find_root(parents, a->second), root_b = find_root(parents, b->second);
        parents[std::max(root_a, root_b)] = std::min(root_a, root_b);
    }
    for (std::uint32_t i = 0; i < parents.size(); ++i) parents[i] = find_root(parents, i);
    return parents;
}

} // namespace

WorldLayout read_layout(const World& world, std::span<const Appearance> appearances) {
    std::unordered_map<ShapeId, Vec3> colors;
    for (const Appearance& appearance : appearances) colors.emplace(appearance.shape, appearance.color);
    WorldLayout layout;
    bool any_mass = false;
    for (const BodyId id : world.bodies()) {
        const Body body = world.body(id);
        const float mass = body.mass();
        if (body.type() == BodyType::dynamic && std::isfinite(mass)) {
            layout.least_mass = any_mass ? std::min(layout.least_mass, mass) : mass;
            layout.greatest_mass = any_mass ? std::max(layout.greatest_mass, mass) : mass;
            any_mass = true;
        }
        for (const ShapeId shape : body.shapes()) {
            layout.shapes.push_back(read_shape(world, shape, layout.bodies.size()));
            const auto color = colors.find(shape);
            if (color != colors.end()) layout.shapes.back().color = color->second;
        }
        layout.bodies.push_back({id, body.type(), mass, body.name()});
    }
    return layout;
}

WorldMotion read_motion(const World& world, const WorldLayout& layout, bool with_islands) {
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
    if (with_islands) motion.islands = find_islands(world, layout);
    return motion;
}

BoundingBall bounding_ball(const WorldLayout& layout, const WorldMotion& motion) {
    const bool any_dynamic = std::any_of(layout.bodies.begin(), layout.bodies.end(),
                                         [](const BodyLayout& body) { return body.type == BodyType::dynamic; });
    Position least(1e300), greatest(-1e300);
    for (const ShapeLayout& shape : layout.shapes) {
        if (shape.type == ShapeType::plane) continue;
        if (any_dynamic && layout.bodies[shape.body].type != BodyType::dynamic) continue;
        const Transform& transform = motion.transforms[shape.body];
        const Position center = transform.position + Position(transform.rotation * shape.position);
        const double radius = shape.type == ShapeType::sphere ? shape.half_size.x : glm::length(shape.half_size);
        least = glm::min(least, center - radius);
        greatest = glm::max(greatest, center + radius);
    }
    if (least.x > greatest.x) return {};
    return {(least + greatest) * 0.5, float(glm::length(greatest - least) * 0.5)};
}

CameraPose fit_camera(const World& world) {
    const WorldLayout layout = read_layout(world, {});
    const BoundingBall ball = bounding_ball(layout, read_motion(world, layout));
    OrbitCamera camera(CameraPose{ball.center + Position(0.6, 0.4, 1.0), ball.center, 0.785398f});
    camera.frame(ball.center, ball.radius);
    return camera.pose();
}

} // namespace cairn::viewer
