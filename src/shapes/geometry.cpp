#include "shapes/geometry.h"

#include <limits>

namespace cairn {

using math::DVec3;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// The rotation whose matrix has columns x, y, z.
math::Quat from_axes(DVec3 x, DVec3 y, DVec3 z) {
    // Shepperd's method: computes the largest of the four components from the diagonal.
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
    // Scaled first, since the squares of a tiny or huge normal would underflow or overflow.
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

std::span<const Material> surface_materials(const ShapeData& data) {
    if (const auto* mesh = std::get_if<std::shared_ptr<const MeshData>>(&data)) return (*mesh)->materials.materials;
    if (const auto* field = std::get_if<std::shared_ptr<const HeightFieldData>>(&data))
        return (*field)->materials.materials;
    return {};
}

namespace {

// Sets type, size and bounding radius; a plane also rotates the shape.
struct GeometryMaker {
    Geometry& g;

    void operator()(const Sphere& sphere) const { set(ShapeType::sphere, {sphere.radius, 0, 0}, sphere.radius); }
    void operator()(const Box& box) const {
        const math::Vec3 size{box.half_extents.x, box.half_extents.y, box.half_extents.z};
        set(ShapeType::box, size, math::length(size) + box.rounding);
        g.rounding = box.rounding;
    }
    void operator()(const Plane& plane) const {
        g.rotation = math::normalized(g.rotation * plane_rotation(plane));
        g.is_double_sided = plane.double_sided;
        if (!plane.half_extents) {
            set(ShapeType::plane, {}, 0);
            return;
        }
        const auto half = [](float extent) { return std::isinf(extent) ? endless : extent; };
        const math::Vec3 size{half(plane.half_extents->x), 0, half(plane.half_extents->y)};
        set(ShapeType::rectangle, size, size.x == endless || size.z == endless ? 0.0f : math::length(size));
    }
    void operator()(const Capsule& c) const {
        const float top = c.radius_top.value_or(c.radius);
        set(ShapeType::capsule, {c.radius, c.half_height, top}, c.half_height + std::max(c.radius, top));
    }
    void operator()(const Cylinder& c) const {
        const float top = c.radius_top.value_or(c.radius), widest = std::max(c.radius, top);
        set(ShapeType::cylinder, {c.radius, c.half_height, top},
            std::sqrt(c.half_height * c.half_height + widest * widest) + c.rounding);
        g.rounding = c.rounding;
    }
    void operator()(const Hull& hull) const {
        const HullData& data = *hull.data();
        g.middle = 0.5f * (data.lo + data.hi);
        float square = 0;
        for (const math::Vec3& v : data.vertices) square = std::max(square, math::dot(v - g.middle, v - g.middle));
        set(ShapeType::hull, {}, std::sqrt(square) + hull.rounding);
        g.rounding = hull.rounding;
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

Geometry near_part(const Geometry& g, DVec3& center, math::DQuat rotation, DVec3 point, double reach) {
    if (!is_strip(g)) return g;
    Geometry part = g;
    const math::DMat3 axes = math::to_matrix(rotation);
    for (const int i : {0, 2}) {
        if (g.size[i] != endless) continue;
        center += math::dot(axes.column(i), point - center) * axes.column(i);
        part.size[i] = g.size[2 - i] + float(reach);
    }
    part.bounding_radius = math::length(part.size);
    return part;
}

ShapeData make_shape_data(const Shape& shape) {
    if (const auto* hull = std::get_if<Hull>(&shape)) return hull->data();
    if (const auto* mesh = std::get_if<Mesh>(&shape)) return mesh->data();
    if (const auto* field = std::get_if<HeightField>(&shape)) return field->data();
    return {};
}

namespace {

// The error of bounds due to a rotation rounded to float and sums in float, relative to the bounding radius.
constexpr double rounding = 1e-6;

// Bounds of both end balls, relative to the position.
DBounds capsule_bounds(DVec3 size, const math::Mat3& m) {
    DBounds b;
    for (int i = 0; i < 3; ++i) {
        const double up = size.y * double(m.c1[i]);
        b.lo[i] = std::min(up - size.z, -up - size.x);
        b.hi[i] = std::max(up + size.z, -up + size.x);
    }
    return b;
}

// Bounds of both end discs: along a world axis e, a disc of radius r spanned by c0 and c2 has the extent r sqrt((c0 .
// e)^2 + (c2 . e)^2).
DBounds cylinder_bounds(DVec3 size, const math::Mat3& m) {
    DBounds b;
    for (int i = 0; i < 3; ++i) {
        const double x = double(m.c0[i]), z = double(m.c2[i]), up = size.y * double(m.c1[i]);
        const double reach = std::sqrt(x * x + z * z), low = size.x * reach, top = size.z * reach;
        b.lo[i] = std::min(up - top, -up - low);
        b.hi[i] = std::max(up + top, -up + low);
    }
    return b;
}

DBounds hull_bounds(const HullData& hull, const math::Mat3& m) {
    DBounds b;
    for (int i = 0; i < 3; ++i) {
        const Columns::Range r = hull.vertex_columns.range({m.c0[i], m.c1[i], m.c2[i]});
        b.lo[i] = double(r.least), b.hi[i] = double(r.greatest);
    }
    return b;
}

// Bounds of the rotated corners of a box.
DBounds box_bounds(DVec3 lo, DVec3 hi, const math::Mat3& m) {
    const DVec3 center = 0.5 * (lo + hi), half = 0.5 * (hi - lo);
    DBounds b;
    for (int i = 0; i < 3; ++i) {
        const DVec3 row{double(m.c0[i]), double(m.c1[i]), double(m.c2[i])};
        const double middle = math::dot(row, center), reach = math::dot(math::abs(row), half);
        b.lo[i] = middle - reach;
        b.hi[i] = middle + reach;
    }
    return b;
}

// The extent of a mesh along a direction, within `slack`. Visits the child with the greatest bound first, so that most
// of the others are skipped.
struct MeshSupport {
    const MeshData& mesh;
    DVec3 direction;
    double slack, best = -infinity;

    // Searches the boxes of a block.
    void search(std::size_t level, std::size_t block) {
        if (level == 0) {
            const std::size_t first = 24 * block, last = std::min(first + 24, mesh.indices.size());
            for (std::size_t i = first; i < last; ++i)
                best = std::max(best, math::dot(direction, math::to_double(mesh.vertices[mesh.indices[i]])));
            return;
        }
        const BoxBlock& boxes = mesh.levels[level][block];
        const std::size_t count = std::min<std::size_t>(8, mesh.levels[level - 1].size() - 8 * block);
        double reach[8];
        for (std::size_t i = 0; i < count; ++i) {
            const DVec3 lo = math::to_double(boxes.lo_of(i)), hi = math::to_double(boxes.hi_of(i));
            reach[i] = 0.5 * (math::dot(direction, lo + hi) + math::dot(math::abs(direction), hi - lo));
        }
        for (;;) {
            std::size_t farthest = 0;
            for (std::size_t i = 1; i < count; ++i)
                if (reach[i] > reach[farthest]) farthest = i;
            if (!(reach[farthest] > best + slack)) return;
            reach[farthest] = -infinity;
            search(level - 1, 8 * block + farthest);
        }
    }
};

DBounds mesh_bounds(const MeshData& mesh, const math::Mat3& m) {
    const math::Mat3 upright;
    if (m.c0 == upright.c0 && m.c1 == upright.c1 && m.c2 == upright.c2)
        return {math::to_double(mesh.lo), math::to_double(mesh.hi)};
    const double slack = 0.25 * rounding * double(mesh.bounding_radius);
    auto reach = [&](DVec3 direction) {
        MeshSupport support{mesh, direction, slack};
        support.search(mesh.levels.size() - 1, 0);
        return support.best;
    };
    DBounds b;
    for (int i = 0; i < 3; ++i) {
        const DVec3 row{double(m.c0[i]), double(m.c1[i]), double(m.c2[i])};
        b.lo[i] = -reach(-row);
        b.hi[i] = reach(row);
    }
    return b;
}

// Bounds of the field's bounding box: exact while the field is upright.
DBounds height_field_bounds(const HeightFieldData& field, const math::Mat3& m) {
    const double x = grid_half(field.columns, field.spacing_x), z = grid_half(field.rows, field.spacing_z);
    return box_bounds({-x, double(field.least), -z}, {x, double(field.greatest), z}, m);
}

DBounds bounds_about_position(const Geometry& shape, const ShapeData& data, const math::Mat3& m) {
    switch (shape.type) {
    case ShapeType::capsule:
        return capsule_bounds(math::to_double(shape.size), m);
    case ShapeType::cylinder:
        return cylinder_bounds(math::to_double(shape.size), m);
    case ShapeType::hull:
        return hull_bounds(hull_of(data), m);
    case ShapeType::mesh:
        return mesh_bounds(mesh_of(data), m);
    default:
        return height_field_bounds(height_field_of(data), m);
    }
}

} // namespace

DBounds geometry_bounds(const Geometry& shape, const ShapeData& data, DVec3 position, const math::Mat3& m) {
    if (shape.type == ShapeType::plane) return {{-infinity, -infinity, -infinity}, {infinity, infinity, infinity}};
    if (shape.type == ShapeType::sphere) {
        const double r = shape.size.x;
        const DVec3 half{r, r, r};
        return {position - half, position + half};
    }
    if (shape.type == ShapeType::box || shape.type == ShapeType::rectangle) {
        DVec3 half = math::to_double(shape.size.x * math::abs(m.c0) + shape.size.y * math::abs(m.c1) +
                                     shape.size.z * math::abs(m.c2));
        if (shape.rounding > 0) half += math::DVec3{shape.rounding, shape.rounding, shape.rounding};
        return {position - half, position + half};
    }
    const DBounds b = bounds_about_position(shape, data, m);
    const double pad = rounding * double(shape.bounding_radius) + double(shape.rounding);
    const DVec3 outward{pad, pad, pad};
    return {position + b.lo - outward, position + b.hi + outward};
}

float smallest_extent(const Geometry& g, const ShapeData& data) {
    switch (g.type) {
    case ShapeType::sphere:
        return 2 * g.size.x;
    case ShapeType::box:
        return 2 * (std::min({g.size.x, g.size.y, g.size.z}) + g.rounding);
    case ShapeType::capsule:
        return 2 * std::max(g.size.x, g.size.z);
    case ShapeType::cylinder:
        return 2 * (std::min(g.size.y, std::max(g.size.x, g.size.z)) + g.rounding);
    case ShapeType::hull:
        return hull_of(data).width + 2 * g.rounding;
    case ShapeType::plane:
    case ShapeType::rectangle:
    case ShapeType::mesh:
    case ShapeType::height_field:
        break;
    }
    return unlimited_extent;
}

} // namespace cairn
