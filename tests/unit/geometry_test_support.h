// Shared by the tests of bounds, masses and rays: a seeded generator, poses, and hulls made by hand.
#pragma once

#include "shapes/geometry.h"

#include <cmath>
#include <memory>
#include <random>

namespace cairn::test {

using math::DVec3;

struct Random {
    std::mt19937_64 engine;
    explicit Random(std::uint64_t seed) : engine(seed) {}
    double operator()(double lo, double hi) { return lo + (hi - lo) * double(engine() >> 11) * 0x1p-53; }
    std::size_t below(std::size_t n) { return std::size_t(engine() % n); }
    DVec3 direction() {
        for (;;) {
            const DVec3 v{(*this)(-1, 1), (*this)(-1, 1), (*this)(-1, 1)};
            const double square = math::dot(v, v);
            if (square > 1e-4 && square < 1) return (1 / std::sqrt(square)) * v;
        }
    }
    math::Quat rotation() {
        const DVec3 axis = direction();
        return math::to_float(math::normalized(math::DQuat{axis.x, axis.y, axis.z, (*this)(-1, 1)}));
    }
    DVec3 point(double reach) { return {(*this)(-reach, reach), (*this)(-reach, reach), (*this)(-reach, reach)}; }
};

// A prism of `sides` sides around y, scaled and sheared; its face planes are computed from its vertices.
inline std::shared_ptr<const HullData> prism(int sides, DVec3 scale, double slant) {
    auto hull = std::make_shared<HullData>();
    double square = 0;
    for (int i = 0; i < 2 * sides; ++i) {
        const double angle = 2 * 3.14159265358979323846 * (i % sides) / sides, y = i < sides ? -scale.y : scale.y;
        const DVec3 v{scale.x * std::cos(angle) + slant * y, y, scale.z * std::sin(angle)};
        hull->vertices.push_back(math::to_float(v));
        square = std::max(square, math::dot(v, v));
    }
    hull->vertex_columns = Columns(hull->vertices);
    hull->bounding_radius = float(std::sqrt(square) * (1 + 1e-7));
    auto add_face = [&](std::initializer_list<std::uint32_t> corners) {
        const auto* c = corners.begin();
        const DVec3 a = math::to_double(hull->vertices[c[0]]);
        const DVec3 n = math::normalized(
            math::cross(math::to_double(hull->vertices[c[1]]) - a, math::to_double(hull->vertices[c[2]]) - a));
        hull->faces.push_back({math::to_float(n), float(math::dot(n, a)), std::uint32_t(hull->loops.size()),
                               std::uint32_t(corners.size())});
        hull->loops.insert(hull->loops.end(), corners);
    };
    const auto n = std::uint32_t(sides);
    for (std::uint32_t i = 0; i < n; ++i) {
        const std::uint32_t next = (i + 1) % n;
        add_face({i, i + n, next + n, next});
    }
    add_face({0, 1, 2}); // only the planes of these faces matter here
    add_face({n + 2, n + 1, n});
    return hull;
}

struct Sample {
    Geometry geometry;
    ShapeData data;
};
inline Sample sample_of(const Shape& shape) { return {make_geometry(shape, {}), make_shape_data(shape)}; }
inline Sample sample_of(std::shared_ptr<const HullData> hull) { return sample_of(Shape(Hull(std::move(hull)))); }

} // namespace cairn::test
