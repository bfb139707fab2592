#include "shapes/geometry.h"

#include <limits>

namespace cairn {

using math::DVec3;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// The rotation whose columns are the images of x, y, z.
math::Quat from_axes(DVec3 x, DVec3 y, DVec3 z) {
    // Shepperd's method: the largest of the four components is computed from the diagonal.
    const double trace = x.x + y.y + z.z;
    math::DQuat q;
    if (trace > 0) {
        const double s = 2 * std::sqrt(1 + trace);
        q = {(y.z - z.y) / s, (z.x - x.z) / s, (x.y - y.x) / s, s / 4};
    } else if (x.x > y.y && x.x > z.z) {
        const double s = 2 * std::sqrt(1 + x.x - y.y - z.z);
        q = {s / 4, (y.x + x.y) / s, (z.x + x.z) / s, (y.z - z.y) / s};
    } else if (y.y > z.z) {
        const double s = 2 * std::sqrt(1 + y.y - x.x - z.z);
        q = {(y.x + x.y) / s, s / 4, (z.y + y.z) / s, (z.x - x.z) / s};
    } else {
        const double s = 2 * std::sqrt(1 + z.z - x.x - y.y);
        q = {(z.x + x.z) / s, (z.y + y.z) / s, s / 4, (x.y - y.x) / s};
    }
    return math::to_float(math::normalized(q));
}

math::Quat plane_rotation(const Plane& plane) {
    DVec3 normal{plane.normal.x, plane.normal.y, plane.normal.z};
    // Scale first: the squares of a tiny or huge normal would leave the range.
    const double largest = std::max({std::fabs(normal.x), std::fabs(normal.y), std::fabs(normal.z)});
    normal = math::normalized((1 / largest) * normal);
    DVec3 tangent{plane.tangent.x, plane.tangent.y, plane.tangent.z};
    tangent = tangent - math::dot(tangent, normal) * normal;
    const double length = math::length(tangent);
    if (!plane.half_extents || !(length > 1e-6))
        tangent = math::to_double(math::any_orthogonal(math::to_float(normal)));
    tangent = math::normalized(tangent - math::dot(tangent, normal) * normal);
    return from_axes(tangent, normal, math::cross(tangent, normal));
}

math::Quat convert(const Quat& q) { return {q.x, q.y, q.z, q.w}; }

} // namespace

namespace {

// Type, size and bounding radius; a plane also turns the shape.
struct GeometryMaker {
    Geometry& g;

    void operator()(const Sphere& sphere) const { set(ShapeType::sphere, {sphere.radius, 0, 0}, sphere.radius); }
    void operator()(const Box& box) const {
        const math::Vec3 size{box.half_extents.x, box.half_extents.y, box.half_extents.z};
        set(ShapeType::box, size, math::length(size));
    }
    void operator()(const Plane& plane) const {
        g.rotation = math::normalized(g.rotation * plane_rotation(plane));
        if (!plane.half_extents) {
            set(ShapeType::plane, {}, 0);
            return;
        }
        const math::Vec3 size{plane.half_extents->x, 0, plane.half_extents->y};
        set(ShapeType::rectangle, size, math::length(size));
    }
    void operator()(const Capsule& c) const {
        const float top = c.radius_top.value_or(c.radius);
        set(ShapeType::capsule, {c.radius, c.half_height, top}, c.half_height + std::max(c.radius, top));
    }
    void operator()(const Cylinder& c) const {
        const float top = c.radius_top.value_or(c.radius), widest = std::max(c.radius, top);
        set(ShapeType::cylinder, {c.radius, c.half_height, top},
            std::sqrt(c.half_height * c.half_height + widest * widest));
    }
    void operator()(const Hull& hull) const {
        const HullData& data = *hull.data();
        g.middle = 0.5f * (data.lo + data.hi);
        float square = 0;
        for (const math::Vec3& v : data.vertices) square = std::max(square, math::dot(v - g.middle, v - g.middle));
        set(ShapeType::hull, {}, std::sqrt(square));
    }
    void operator()(const Mesh& mesh) const { set(ShapeType::mesh, {}, mesh.data()->bounding_radius); }
    void operator()(const HeightField& field) const { set(ShapeType::height_field, {}, field.data()->bounding_radius); }

  private:
    void set(ShapeType type, math::Vec3 size, float radius) const {
        g.type = type;
        g.size = size;
        g.bounding_radius = radius;
    }
};

} // namespace

Geometry make_geometry(const Shape& shape, const Transform& pose) {
    Geometry g;
    g.position = {float(pose.position.x), float(pose.position.y), float(pose.position.z)};
    g.rotation = convert(pose.rotation);
    std::visit(GeometryMaker{g}, shape);
    g.is_turned = !(g.rotation.x == 0 && g.rotation.y == 0 && g.rotation.z == 0);
    return g;
}

ShapeData make_shape_data(const Shape& shape) {
    if (const auto* hull = std::get_if<Hull>(&shape)) return hull->data();
    if (const auto* mesh = std::get_if<Mesh>(&shape)) return mesh->data();
    if (const auto* field = std::get_if<HeightField>(&shape)) return field->data();
    return {};
}

DBounds geometry_bounds(const Geometry& shape, const ShapeData&, DVec3 position, const math::Mat3& m) {
    if (shape.type == ShapeType::plane) return {{-infinity, -infinity, -infinity}, {infinity, infinity, infinity}};
    DVec3 half;
    if (shape.type == ShapeType::sphere) {
        const double r = shape.size.x;
        half = {r, r, r};
    } else {
        half = math::to_double(shape.size.x * math::abs(m.c0) + shape.size.y * math::abs(m.c1) +
                               shape.size.z * math::abs(m.c2));
    }
    return {position - half, position + half};
}

MassSum geometry_mass(const Geometry& shape, const ShapeData&, float density) {
    MassSum m;
    m.center = math::to_double(shape.position);
    const double rho = density;
    DVec3 moments;
    if (shape.type == ShapeType::sphere) {
        const double r = shape.size.x;
        m.mass = rho * (4.0 / 3.0) * 3.14159265358979323846 * r * r * r;
        const double i = 0.4 * m.mass * r * r;
        moments = {i, i, i};
    } else if (shape.type == ShapeType::box) {
        const DVec3 a = math::to_double(shape.size);
        m.mass = rho * 8 * a.x * a.y * a.z;
        const DVec3 s{a.x * a.x, a.y * a.y, a.z * a.z};
        moments = (m.mass / 3) * DVec3{s.y + s.z, s.x + s.z, s.x + s.y};
    }
    m.inertia = math::rotated_diagonal(math::to_matrix(math::normalized(math::to_double(shape.rotation))), moments);
    return m;
}

namespace {

std::optional<ShapeRayHit> cast_sphere(double radius, DVec3 o, DVec3 d, double max_distance) {
    // Nearest point of the line to the center first: no cancellation however far the origin is.
    const double t = -math::dot(o, d);
    const DVec3 nearest = o + t * d;
    const double square = radius * radius - math::dot(nearest, nearest);
    if (math::dot(o, o) < radius * radius || square < 0) return std::nullopt;
    const double distance = t - std::sqrt(square);
    if (distance < 0 || distance > max_distance) return std::nullopt;
    return ShapeRayHit{distance, (1 / radius) * (o + distance * d)};
}

std::optional<ShapeRayHit> cast_box(DVec3 half, DVec3 o, DVec3 d, double max_distance) {
    double enter = -infinity, leave = infinity;
    int axis = -1;
    for (int i = 0; i < 3; ++i) {
        if (d[i] == 0) {
            if (std::fabs(o[i]) > half[i]) return std::nullopt;
            continue;
        }
        const double a = (-half[i] - o[i]) / d[i], b = (half[i] - o[i]) / d[i];
        const double near = std::min(a, b), far = std::max(a, b);
        if (near > enter) enter = near, axis = i;
        leave = std::min(leave, far);
    }
    if (axis < 0 || enter > leave || enter < 0 || enter > max_distance) return std::nullopt;
    DVec3 normal;
    normal[axis] = d[axis] > 0 ? -1 : 1;
    return ShapeRayHit{enter, normal};
}

std::optional<ShapeRayHit> cast_plane(const Geometry& shape, DVec3 o, DVec3 d, double max_distance) {
    if (shape.type == ShapeType::plane && o.y < 0) return ShapeRayHit{0, {0, 1, 0}};
    if (!(d.y < 0)) return std::nullopt; // one-sided
    const double distance = -o.y / d.y;
    if (distance < 0 || distance > max_distance) return std::nullopt;
    const DVec3 p = o + distance * d;
    if (shape.type == ShapeType::rectangle && (std::fabs(p.x) > shape.size.x || std::fabs(p.z) > shape.size.z))
        return std::nullopt;
    return ShapeRayHit{distance, {0, 1, 0}};
}

} // namespace

std::optional<ShapeRayHit> cast_ray(const Geometry& shape, const ShapeData&, DVec3 position, math::Quat rotation,
                                    DVec3 origin, DVec3 direction, double max_distance) {
    const math::DQuat q = math::normalized(math::to_double(rotation));
    const DVec3 o = math::rotate_back(q, origin - position), d = math::rotate_back(q, direction);
    std::optional<ShapeRayHit> hit;
    if (shape.type == ShapeType::sphere)
        hit = cast_sphere(shape.size.x, o, d, max_distance);
    else if (shape.type == ShapeType::box)
        hit = cast_box(math::to_double(shape.size), o, d, max_distance);
    else
        hit = cast_plane(shape, o, d, max_distance);
    if (hit) hit->normal = math::rotate(q, hit->normal);
    return hit;
}

} // namespace cairn
