#include "viewer/scaling.h"

#include <cairn/error.h>

#include <glm/gtc/quaternion.hpp>

#include <cmath>
#include <utility>
#include <variant>
#include <vector>

namespace cairn::viewer {

namespace {

bool is_along_axes(const Quat& rotation) { return rotation.x == 0.0f && rotation.y == 0.0f && rotation.z == 0.0f; }

// Scales shapes by factors along the body's axes. `turn`: rotation from the shape's frame to that of the body. Factors
// may differ only for shapes that can be stretched.
struct Scaled {
    Vec3 factors;
    Quat turn;

    Vec3 point(const Vec3& p) const { return glm::conjugate(turn) * (factors * (turn * p)); }
    std::vector<Vec3> points(std::span<const Vec3> from) const {
        std::vector<Vec3> to;
        for (const Vec3& p : from) to.push_back(point(p));
        return to;
    }
    float size() const { return factors.x; }
    Shape operator()(const Sphere& sphere) const { return Sphere{sphere.radius * size()}; }
    Shape operator()(const Box& box) const { return Box{box.half_extents * factors, box.rounding * size()}; }
    Shape operator()(const Capsule& capsule) const {
        Capsule result = capsule;
        result.half_height *= size();
        result.radius *= size();
        if (result.radius_top) *result.radius_top *= size();
        return result;
    }
    Shape operator()(const Cylinder& cylinder) const {
        Cylinder result = cylinder;
        result.half_height *= size();
        result.radius *= size();
        if (result.radius_top) *result.radius_top *= size();
        result.rounding *= size();
        return result;
    }
    Shape operator()(const Plane& plane) const {
        if (!plane.half_extents)
            throw Error(ErrorCode::unsupported, "plane", "", "is infinite, so it cannot be scaled");
        Plane result = plane;
        *result.half_extents *= size();
        return result;
    }
    Shape operator()(const Hull& hull) const {
        Hull result(points(hull.vertices()));
        result.rounding = hull.rounding * size();
        return result;
    }
    Shape operator()(const Mesh& mesh) const { return Mesh(points(mesh.vertices()), mesh.indices()); }
    Shape operator()(const HeightField& field) const {
        std::vector<float> heights(field.heights().begin(), field.heights().end());
        for (float& height : heights) height *= size();
        return HeightField(field.columns(), field.rows(), field.spacing() * size(), heights);
    }
};

} // namespace

bool can_be_stretched(const World& world, BodyId body) {
    for (const ShapeId id : world.body(body).shapes()) {
        const Shape& shape = world.shape(id);
        const auto* box = std::get_if<Box>(&shape);
        const auto* hull = std::get_if<Hull>(&shape);
        const bool can = box    ? box->rounding == 0.0f && is_along_axes(world.shape_def(id).rotation)
                         : hull ? hull->rounding == 0.0f
                                : std::holds_alternative<Mesh>(shape);
        if (!can) return false;
    }
    return true;
}

void scale_body(World& world, BodyId id, const Vec3& factors) {
    Body body = world.body(id);
    std::vector<std::pair<Shape, ShapeDef>> shapes; // complete before the body is changed
    for (const ShapeId shape : body.shapes()) {
        ShapeDef def = world.shape_def(shape);
        shapes.emplace_back(std::visit(Scaled{factors, def.rotation}, world.shape(shape)), def);
        shapes.back().second.position = def.position * factors;
    }
    const bool has_mass = body.type() == BodyType::dynamic && std::isfinite(body.mass());
    const MassProperties before = has_mass ? body.mass_properties() : MassProperties{};
    std::size_t next = 0;
    for (const ShapeId shape : body.shapes()) {
        const auto& [geometry, def] = shapes[next++];
        world.set_shape(shape, geometry);
        world.set_shape_def(shape, def);
    }
    if (!has_mass || body.mass_properties().mass != before.mass) return;
    // The mass was set explicitly, so changing the shapes did not change it.
    const float volume = factors.x * factors.y * factors.z;
    if (volume != 1.0f) body.set_mass_from_shapes(before.mass * volume);
}

} // namespace cairn::viewer
