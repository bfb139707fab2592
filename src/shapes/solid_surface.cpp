#include "shapes/solid_surface.h"

#include "math/angle.h"
#include "shapes/hull.h"

#include <array>
#include <cmath>
#include <cstdint>

namespace cairn {

using math::DVec3;

namespace {

// Tessellation of curved sides: corners around the axis, and rings from the rim of a cap to its pole.
constexpr int sides = 12, cap_rings = 3;
// The cosines of multiples of 30 degrees. Those of a quarter circle also give the rings of a cap.
constexpr double third = 0.86602540378443865;
constexpr std::array<double, sides> cosines = {1, third, 0.5, 0, -0.5, -third, -1, -third, -0.5, 0, 0.5, third};
double cosine(int i) { return cosines[std::size_t(i % sides)]; }
double sine(int i) { return cosine(i + 3 * sides / 4); }

class SurfaceBuilder {
  public:
    explicit SurfaceBuilder(std::vector<SurfaceTriangle>& triangles) : triangles_(triangles) {}

    void add_box(DVec3 half) {
        constexpr int corners[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                       {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
        const auto corner = [&](int i) {
            return DVec3{i & 1 ? half.x : -half.x, i & 2 ? half.y : -half.y, i & 4 ? half.z : -half.z};
        };
        for (const auto& face : corners) add_quad(corner(face[0]), corner(face[1]), corner(face[2]), corner(face[3]));
    }
    // A ring about the y axis. Rings are listed from bottom to top.
    struct Ring {
        double radius, height;
    };
    void add_rings(const Ring* rings, int count) {
        // The polygon has the same cross-sectional area as the circle.
        const double grown = std::sqrt(math::pi / (0.5 * sides * sine(1)));
        const auto corner = [&](const Ring& r, int i) {
            return DVec3{grown * r.radius * cosine(i), r.height, grown * r.radius * sine(i)};
        };
        for (int i = 0; i < sides; ++i) {
            const Ring &low = rings[0], &high = rings[count - 1];
            add({0, low.height, 0}, corner(low, i), corner(low, i + 1));
            add({0, high.height, 0}, corner(high, i + 1), corner(high, i));
            for (int k = 0; k + 1 < count; ++k)
                add_quad(corner(rings[k], i + 1), corner(rings[k], i), corner(rings[k + 1], i),
                         corner(rings[k + 1], i + 1));
        }
    }
    void add_hull(const HullData& hull) {
        for (const HullFace& face : hull.faces) {
            const auto corner = [&](std::uint32_t i) {
                return math::to_double(hull.vertices[hull.loops[face.first + i]]);
            };
            for (std::uint32_t i = 2; i < face.count; ++i) add(corner(0), corner(i - 1), corner(i));
        }
    }

  private:
    void add(DVec3 a, DVec3 b, DVec3 c) {
        if (math::cross(b - a, c - a) != DVec3{}) triangles_.push_back({a, b, c});
    }
    void add_quad(DVec3 a, DVec3 b, DVec3 c, DVec3 d) { add(a, b, c), add(a, c, d); }
    std::vector<SurfaceTriangle>& triangles_;
};

// The lower ball comes first; a cone lies between both balls, and ends near the circles where it touches them.
void add_capsule(SurfaceBuilder& builder, DVec3 size) {
    std::array<SurfaceBuilder::Ring, 2 * cap_rings + 2> rings;
    for (int i = 0; i <= cap_rings; ++i) {
        rings[std::size_t(i)] = {size.x * sine(i), -size.y - size.x * cosine(i)};
        rings[rings.size() - 1 - std::size_t(i)] = {size.z * sine(i), size.y + size.z * cosine(i)};
    }
    builder.add_rings(rings.data(), int(rings.size()));
}

// Computed by Newton's method, for the same bits on all platforms.
double cube_root_near_one(double x) {
    double root = 1;
    for (int i = 0; i < 12; ++i) root = root - (root - x / (root * root)) / 3;
    return root;
}

void grow_to(double volume, DVec3 center, std::vector<SurfaceTriangle>& triangles) {
    double sum = 0;
    for (const SurfaceTriangle& t : triangles)
        sum += math::dot(t.a - center, math::cross(t.b - center, t.c - center)) / 6;
    if (!(sum > 0.25 * volume) || !(sum < 4 * volume)) return; // the shape is thinner than its rounding
    const double factor = cube_root_near_one(volume / sum);
    for (SurfaceTriangle& t : triangles)
        for (DVec3* const p : {&t.a, &t.b, &t.c}) *p = center + factor * (*p - center);
}

} // namespace

void make_solid_surface(const Geometry& shape, const ShapeData& data, std::vector<SurfaceTriangle>& triangles) {
    triangles.clear();
    SurfaceBuilder builder(triangles);
    const DVec3 size = math::to_double(shape.size);
    const double rounding = shape.rounding;
    switch (shape.type) {
    case ShapeType::box:
        builder.add_box(size + DVec3{rounding, rounding, rounding});
        break;
    case ShapeType::capsule:
        add_capsule(builder, size);
        break;
    case ShapeType::cylinder: {
        const SurfaceBuilder::Ring rings[] = {{size.x + rounding, -size.y - rounding},
                                              {size.z + rounding, size.y + rounding}};
        builder.add_rings(rings, 2);
        break;
    }
    case ShapeType::hull:
        builder.add_hull(hull_of(data));
        break;
    default:
        return;
    }
    const DVec3 position = math::to_double(shape.position);
    if (shape.is_turned || position != DVec3{}) {
        const math::DMat3 turn = math::to_matrix(math::normalized(math::to_double(shape.rotation)));
        for (SurfaceTriangle& t : triangles)
            for (DVec3* const p : {&t.a, &t.b, &t.c}) *p = position + turn * *p;
    }
    if (shape.type != ShapeType::capsule && rounding == 0) return; // the volume is correct without scaling
    const MassSum mass = geometry_mass(shape, data, 1);
    grow_to(mass.mass, mass.center, triangles);
}

} // namespace cairn
