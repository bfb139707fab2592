#include "bench/mass.h"

#include "bench/rotate.h"

#include <stdexcept>

namespace cairn::bench {

namespace {

using Vector = glm::dvec3;
using Matrix = glm::dmat3;

constexpr double pi = 3.14159265358979323846;

Matrix diagonal(double x, double y, double z) { return Matrix(Vector(x, 0, 0), Vector(0, y, 0), Vector(0, 0, z)); }

// The inertia that is added when a point mass is moved from the center to `arm` (parallel axis theorem).
Matrix steiner(double mass, const Vector& arm) {
    return mass * (glm::dot(arm, arm) * Matrix(1.0) - glm::outerProduct(arm, arm));
}

MassProperties of_box(const Vector& half_extents, double density) {
    const double mass = 8 * density * half_extents.x * half_extents.y * half_extents.z;
    const Vector square = mass / 3 * half_extents * half_extents;
    return {mass, Vector(0.0), diagonal(square.y + square.z, square.x + square.z, square.x + square.y)};
}

MassProperties of_ball(double radius, double density) {
    const double mass = 4.0 / 3.0 * pi * density * radius * radius * radius;
    const double moment = 0.4 * mass * radius * radius;
    return {mass, Vector(0.0), diagonal(moment, moment, moment)};
}

MassProperties of_cylinder(double radius, double half_height, double density) {
    const double mass = 2 * pi * density * radius * radius * half_height;
    const double across = mass * (radius * radius / 4 + half_height * half_height / 3);
    return {mass, Vector(0.0), diagonal(across, 0.5 * mass * radius * radius, across)};
}

// A capsule is a cylinder and two hemispheres, whose centers of mass are 3/8 of the radius from their flat sides.
MassProperties of_capsule(double radius, double half_height, double density) {
    MassProperties sum = of_cylinder(radius, half_height, density);
    const MassProperties balls = of_ball(radius, density);
    const double farther = balls.mass * half_height * (half_height + 0.75 * radius);
    sum.mass += balls.mass;
    sum.inertia += balls.inertia + diagonal(farther, 0, farther);
    return sum;
}

MassProperties at_origin(const Scene& scene, const Part& part, double density) {
    switch (part.shape) {
    case PartShape::sphere:
        return of_ball(double(part.radius), density);
    case PartShape::box:
        return of_box(Vector(part.half_extents), density);
    case PartShape::capsule:
        return of_capsule(double(part.radius), double(part.half_height), density);
    case PartShape::cylinder:
        return of_cylinder(double(part.radius), double(part.half_height), density);
    case PartShape::hull: {
        MassProperties unit = mass_of(scene.hulls[part.index]);
        return {density * unit.mass, unit.center, density * unit.inertia};
    }
    case PartShape::mesh:
        break;
    }
    return {};
}

} // namespace

MassProperties mass_of(const Scene& scene, const Part& part, double density) {
    MassProperties mass = at_origin(scene, part, density);
    Matrix turn;
    for (int i = 0; i < 3; ++i) turn[i] = rotate(part.rotation, Matrix(1.0)[i]);
    mass.center = Vector(part.position) + turn * mass.center;
    mass.inertia = turn * mass.inertia * glm::transpose(turn);
    return mass;
}

MassProperties operator+(const MassProperties& a, const MassProperties& b) {
    MassProperties sum;
    sum.mass = a.mass + b.mass;
    if (!(sum.mass > 0)) return sum;
    sum.center = (a.mass * a.center + b.mass * b.center) / sum.mass;
    sum.inertia =
        a.inertia + steiner(a.mass, a.center - sum.center) + b.inertia + steiner(b.mass, b.center - sum.center);
    return sum;
}

std::vector<std::array<std::uint32_t, 3>> hull_triangles(std::span<const Vec3> points) {
    std::vector<std::array<std::uint32_t, 3>> triangles;
    const auto count = static_cast<std::uint32_t>(points.size());
    const auto add_if_face = [&](std::uint32_t i, std::uint32_t j, std::uint32_t k) {
        const Vector origin(points[i]);
        const Vector normal = glm::normalize(glm::cross(Vector(points[j]) - origin, Vector(points[k]) - origin));
        bool above = false, below = false;
        for (std::uint32_t m = 0; m < count; ++m) {
            if (m == i || m == j || m == k) continue;
            const double height = glm::dot(normal, Vector(points[m]) - origin);
            above = above || height > -1e-7;
            below = below || height < 1e-7;
        }
        if (!above) triangles.push_back({i, j, k});
        if (!below) triangles.push_back({i, k, j});
    };
    for (std::uint32_t i = 0; i < count; ++i)
        for (std::uint32_t j = i + 1; j < count; ++j)
            for (std::uint32_t k = j + 1; k < count; ++k) add_if_face(i, j, k);
    // Euler's formula: a triangulated polyhedron with n vertices has 2 n - 4 triangles.
    if (count < 4 || triangles.size() != 2 * count - 4)
        throw std::invalid_argument("a point is no corner of the hull, or four points lie in a plane");
    return triangles;
}

// Sums over the tetrahedra of the origin and each triangle (Tonon, "Explicit exact formulas for the 3-D tetrahedron
// inertia tensor in terms of its vertex coordinates", 2004, in the form of second moments).
MassProperties mass_of(const ConvexHull& hull) {
    double volume = 0;
    Vector first(0.0);
    Matrix second(0.0); // integral of x x^T
    for (const auto& [i, j, k] : hull.triangles) {
        const Vector a(hull.points[i]), b(hull.points[j]), c(hull.points[k]), sum = a + b + c;
        const double v = glm::dot(a, glm::cross(b, c)) / 6;
        volume += v;
        first += v / 4 * sum;
        second +=
            v / 20 *
            (glm::outerProduct(a, a) + glm::outerProduct(b, b) + glm::outerProduct(c, c) + glm::outerProduct(sum, sum));
    }
    const Vector center = first / volume;
    const Matrix about_origin = (second[0][0] + second[1][1] + second[2][2]) * Matrix(1.0) - second;
    return {volume, center, about_origin - steiner(volume, center)};
}

} // namespace cairn::bench
