#include "viewer/selection_frame.h"

#include <glm/common.hpp>
#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

namespace cairn::viewer {

namespace {

// Points that span the projection of a shape: for a sphere four points of its outline, since the corners of its
// bounding box would lie outside; for any other shape the corners of its bounding box. Empty for infinite shapes.
std::vector<Position> outline(const ShapeLayout& shape, const Transform& body, const OrbitCamera& camera) {
    if (shape.bound_radius <= 0.0f) return {};
    const Quat rotation = body.rotation * shape.rotation;
    const Position origin =
        body.position + Position(body.rotation * shape.position) + Position(rotation * shape.bound_center);
    std::vector<Position> points;
    if (shape.type == ShapeType::sphere) {
        for (const Vec3& way : {camera.right(), camera.up()})
            for (const float side : {-1.0f, 1.0f})
                points.push_back(origin + Position(way * (side * shape.bound_radius)));
        return points;
    }
    for (int corner = 0; corner < 8; ++corner) {
        const Vec3 signs(corner & 1 ? 1.0f : -1.0f, corner & 2 ? 1.0f : -1.0f, corner & 4 ? 1.0f : -1.0f);
        points.push_back(origin + Position(rotation * (signs * shape.bound_extent)));
    }
    return points;
}

} // namespace

SelectionFrame SelectionFrame::between(const glm::vec2& a, const glm::vec2& b) {
    return {glm::min(a, b), glm::max(a, b)};
}

bool SelectionFrame::contains(const glm::vec2& point) const {
    return point.x >= low.x && point.x <= high.x && point.y >= low.y && point.y <= high.y;
}

std::vector<BodyId> bodies_within(const SelectionFrame& frame, const WorldLayout& layout, const WorldMotion& motion,
                                  const OrbitCamera& camera, float aspect) {
    const auto is_inside = [&](const Position& point) {
        const auto device = camera.project(point, aspect);
        return device && frame.contains(*device);
    };
    struct Found {
        bool has_shapes = false, is_inside = true;
    };
    std::vector<Found> found(layout.bodies.size());
    for (const ShapeLayout& shape : layout.shapes) {
        Found& body = found[shape.body];
        body.has_shapes = true;
        if (!body.is_inside) continue;
        const std::vector<Position> points = outline(shape, motion.transforms[shape.body], camera);
        body.is_inside = !points.empty() && std::all_of(points.begin(), points.end(), is_inside);
    }
    std::vector<BodyId> bodies;
    for (std::size_t i = 0; i < found.size(); ++i)
        if (found[i].is_inside && (found[i].has_shapes || is_inside(motion.transforms[i].position)))
            bodies.push_back(layout.bodies[i].id);
    return bodies;
}

} // namespace cairn::viewer
