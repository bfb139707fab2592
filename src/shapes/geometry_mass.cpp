// Mass properties of solid shapes, in closed form.
#include "math/angle.h"
#include "shapes/geometry.h"
#include "shapes/rounded_mass.h"

namespace cairn {

using math::DVec3;
using math::pi;

namespace {

// A solid of revolution about y, of density 1: its volume, first and second moment along y (integrals of y and y^2),
// and moment of inertia about y. y is measured from `origin`.
MassSum revolved(double origin, double volume, double first, double second, double axial) {
    if (!(volume > 0)) return {};
    const double mean = first / volume;
    const double across = axial / 2 + (second - first * mean); // half of the axial moment, since x and z are equivalent
    MassSum m;
    m.mass = volume;
    m.center = {0, origin + mean, 0};
    m.inertia = {across, 0, 0, axial, 0, across};
    return m;
}

// A frustum from y = bottom to y = bottom + height, with radius a at the bottom and b at the top. With u = (y - bottom)
// / height the radius is a (1 - u) + b u, and the integrals over u of its powers times powers of u are Beta functions.
MassSum frustum(double bottom, double height, double a, double b) {
    const double aa = a * a, ab = a * b, bb = b * b;
    const double volume = pi * height * (aa + ab + bb) / 3;
    const double first = pi * height * height * (aa + 2 * ab + 3 * bb) / 12;
    const double second = pi * height * height * height * (aa / 30 + ab / 10 + bb / 5);
    const double axial = pi / 2 * height * (aa * aa + aa * ab + aa * bb + ab * bb + bb * bb) / 5;
    return revolved(bottom, volume, first, second, axial);
}

// The part of a ball of radius r about y = center that is below y = center + r s (`side` 1), or above y = center - r s
// (`side` -1): integrals of pi (r^2 - y^2), times 1, y and y^2, and of pi / 2 (r^2 - y^2)^2.
MassSum ball_part(double center, double r, double s, double side) {
    const double r2 = r * r, r3 = r2 * r, s2 = s * s, s3 = s2 * s, s5 = s3 * s2;
    const double volume = pi * r3 * (1 + s) * (1 + s) * (2 - s) / 3;
    const double first = -side * pi * r2 * r2 * (1 - s2) * (1 - s2) / 4;
    const double second = pi * r3 * r2 * ((s3 + 1) / 3 - (s5 + 1) / 5);
    const double axial = pi / 2 * r3 * r2 * ((s + 1) - 2 * (s3 + 1) / 3 + (s5 + 1) / 5);
    return revolved(center, volume, first, second, axial);
}

// A capsule's side touches both balls at the height s r above their centers, s = (a - b) / (2 h).
MassSum capsule_mass(DVec3 size) {
    const double a = size.x, h = size.y, b = size.z, s = (a - b) / (2 * h);
    if (s >= 1) return ball_part(-h, a, 1, 1); // the upper ball is inside the lower one
    if (s <= -1) return ball_part(h, b, 1, 1);
    const double square = (1 - s) * (1 + s), c = std::sqrt(square);
    const MassSum ends = combine(ball_part(-h, a, s, 1), ball_part(h, b, -s, -1));
    return combine(ends, frustum(-h + a * s, 2 * h * square, a * c, b * c));
}

// Computes R m R^T.
math::DSym3 rotated(const math::DMat3& r, const math::DSym3& m) {
    const DVec3 x{r.c0.x, r.c1.x, r.c2.x}, y{r.c0.y, r.c1.y, r.c2.y}, z{r.c0.z, r.c1.z, r.c2.z}; // rows
    const DVec3 mx = m * x, my = m * y, mz = m * z;
    return {math::dot(x, mx), math::dot(x, my), math::dot(x, mz), math::dot(y, my), math::dot(y, mz), math::dot(z, mz)};
}

// Mass properties at density 1, in the shape's frame.
MassSum unit_mass(const Geometry& shape, const ShapeData& data) {
    const DVec3 size = math::to_double(shape.size);
    const double rounding = shape.rounding;
    switch (shape.type) {
    case ShapeType::capsule:
        return capsule_mass(size);
    case ShapeType::box:
        return rounded_box_mass(size, rounding);
    case ShapeType::cylinder:
        if (rounding > 0) return rounded_cylinder_mass(size, rounding);
        return frustum(-size.y, 2 * size.y, size.x, size.z);
    case ShapeType::hull:
        if (rounding > 0) return rounded_hull_mass(hull_of(data), rounding);
        return hull_of(data).unit_mass;
    default:
        return {};
    }
}

} // namespace

MassSum geometry_mass(const Geometry& shape, const ShapeData& data, float density) {
    MassSum m;
    m.center = math::to_double(shape.position);
    const double rho = density;
    const math::DMat3 rotation = math::to_matrix(math::normalized(math::to_double(shape.rotation)));
    if (shape.type == ShapeType::sphere) {
        const double r = shape.size.x;
        m.mass = rho * (4.0 / 3.0) * pi * r * r * r;
        const double i = 0.4 * m.mass * r * r;
        m.inertia = math::rotated_diagonal(rotation, DVec3{i, i, i});
    } else if (shape.type == ShapeType::box && !(shape.rounding > 0)) {
        const DVec3 a = math::to_double(shape.size);
        m.mass = rho * 8 * a.x * a.y * a.z;
        const DVec3 s{a.x * a.x, a.y * a.y, a.z * a.z};
        m.inertia = math::rotated_diagonal(rotation, (m.mass / 3) * DVec3{s.y + s.z, s.x + s.z, s.x + s.y});
    } else if (!is_surface(shape.type)) {
        const MassSum unit = unit_mass(shape, data);
        m.mass = rho * unit.mass;
        m.center += rotation * unit.center;
        const math::DSym3 i = rotated(rotation, unit.inertia);
        m.inertia = {rho * i.xx, rho * i.xy, rho * i.xz, rho * i.yy, rho * i.yz, rho * i.zz};
    }
    return m;
}

} // namespace cairn
