// Shared by the tests of convex shapes: shapes in arbitrary poses, hulls made by hand, random numbers.
#pragma once

#include "collision/manifold.h"
#include "shapes/convex.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <random>
#include <string>
#include <vector>

namespace convex_test {

using cairn::Convex;
using cairn::math::cross;
using cairn::math::DMat3;
using cairn::math::dot;
using cairn::math::DQuat;
using cairn::math::DVec3;
using cairn::math::length;
using cairn::math::normalized;

// Generates the same numbers with every standard library.
class Random {
  public:
    explicit Random(std::uint32_t seed) : engine_(seed) {}
    double uniform(double low, double high) { return low + (high - low) * (engine_() / 4294967296.0); }
    int below(int n) { return static_cast<int>(engine_() % static_cast<std::uint32_t>(n)); }
    DVec3 direction() {
        for (;;) {
            const DVec3 v{uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)};
            const double l = length(v);
            if (l > 0.05 && l < 1.0) return (1.0 / l) * v;
        }
    }
    DQuat rotation() {
        for (;;) {
            const DQuat q{uniform(-1, 1), uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)};
            const double l = q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w;
            if (l > 0.01 && l < 1.0) return cairn::math::normalized(q);
        }
    }

  private:
    std::mt19937 engine_;
};

inline DQuat about(DVec3 axis, double angle) {
    const double s = std::sin(angle / 2);
    return {s * axis.x, s * axis.y, s * axis.z, std::cos(angle / 2)};
}

// A hull with three faces at every vertex, so that each vertex of the core is the intersection of three offset faces.
inline std::shared_ptr<const cairn::HullData> make_hull(const std::vector<DVec3>& corners,
                                                        const std::vector<std::vector<std::uint32_t>>& faces) {
    auto hull = std::make_shared<cairn::HullData>();
    DVec3 lo = corners[0], hi = corners[0];
    for (DVec3 c : corners) {
        hull->vertices.push_back(cairn::math::to_float(c));
        lo = cairn::math::min(lo, c);
        hi = cairn::math::max(hi, c);
        hull->bounding_radius = std::max(hull->bounding_radius, float(length(c)));
    }
    hull->lo = cairn::math::to_float(lo);
    hull->hi = cairn::math::to_float(hi);
    const auto vertex = [&](std::size_t i) { return cairn::math::to_double(hull->vertices[i]); };
    std::vector<DVec3> normals;
    std::vector<cairn::math::Vec3> core;
    double width = 1e300;
    for (const auto& loop : faces) {
        DVec3 n;
        for (std::size_t i = 0; i < loop.size(); ++i) n += cross(vertex(loop[i]), vertex(loop[(i + 1) % loop.size()]));
        n = normalized(n);
        normals.push_back(n);
        cairn::HullFace face;
        face.normal = cairn::math::to_float(n);
        face.first = static_cast<std::uint32_t>(hull->loops.size());
        face.count = static_cast<std::uint32_t>(loop.size());
        double offset = -1e300, least = 1e300;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            offset = std::max(offset, dot(n, vertex(i)));
            least = std::min(least, dot(n, vertex(i)));
        }
        face.offset = static_cast<float>(offset);
        width = std::min(width, offset - least);
        for (std::uint32_t i : loop) hull->loops.push_back(i);
        hull->faces.push_back(face);
    }
    hull->width = static_cast<float>(width);
    hull->inset = static_cast<float>(std::min(0.02, 0.025 * width));
    for (std::uint32_t v = 0; v < corners.size(); ++v) {
        hull->neighbor_start.push_back(static_cast<std::uint32_t>(hull->neighbors.size()));
        std::vector<std::size_t> around;
        for (std::size_t f = 0; f < faces.size(); ++f)
            for (std::size_t i = 0; i < faces[f].size(); ++i)
                if (faces[f][i] == v) {
                    hull->neighbors.push_back(faces[f][(i + 1) % faces[f].size()]);
                    hull->faces_at.push_back(static_cast<std::uint32_t>(f));
                    around.push_back(f);
                }
        // Cramer's rule for the intersection of the three offset planes.
        const DVec3 n0 = normals[around[0]], n1 = normals[around[1]], n2 = normals[around[2]];
        const DVec3 p = vertex(v);
        const double m = hull->inset;
        const DVec3 d{dot(n0, p) - m, dot(n1, p) - m, dot(n2, p) - m};
        const double det = dot(n0, cross(n1, n2));
        core.push_back(
            cairn::math::to_float((1 / det) * (d.x * cross(n1, n2) + d.y * cross(n2, n0) + d.z * cross(n0, n1))));
    }
    hull->neighbor_start.push_back(static_cast<std::uint32_t>(hull->neighbors.size()));
    hull->core = cairn::Columns(core);
    cairn::arrange(*hull);
    return hull;
}

inline std::shared_ptr<const cairn::HullData> box_hull(DVec3 h) {
    std::vector<DVec3> c;
    for (int i = 0; i < 8; ++i) c.push_back({i & 1 ? h.x : -h.x, i & 2 ? h.y : -h.y, i & 4 ? h.z : -h.z});
    return make_hull(c, {{1, 3, 7, 5}, {0, 4, 6, 2}, {2, 6, 7, 3}, {0, 1, 5, 4}, {4, 5, 7, 6}, {0, 2, 3, 1}});
}
inline std::shared_ptr<const cairn::HullData> tetrahedron(double s) {
    return make_hull({{s, s, s}, {s, -s, -s}, {-s, s, -s}, {-s, -s, s}}, {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}});
}
// A prism with n sides whose axis is y.
inline std::shared_ptr<const cairn::HullData> prism(int n, double radius, double half_height, double top = 1) {
    std::vector<DVec3> c;
    std::vector<std::vector<std::uint32_t>> faces(2);
    for (int i = 0; i < n; ++i) {
        const double angle = 2 * 3.14159265358979324 * i / n;
        c.push_back({radius * std::cos(angle), -half_height, radius * std::sin(angle)});
        c.push_back({top * radius * std::cos(angle), half_height, top * radius * std::sin(angle)});
        const auto k = static_cast<std::uint32_t>(2 * i), next = static_cast<std::uint32_t>(2 * ((i + 1) % n));
        faces[0].push_back(k);
        faces[1].insert(faces[1].begin(), k + 1);
        faces.push_back({k, k + 1, next + 1, next});
    }
    return make_hull(c, faces);
}
// A dodecahedron, with 20 vertices.
inline std::shared_ptr<const cairn::HullData> dodecahedron(double s) {
    const double g = 1.6180339887498949, i = 1 / g;
    std::vector<DVec3> c;
    for (double x : {-1.0, 1.0})
        for (double y : {-1.0, 1.0})
            for (double z : {-1.0, 1.0}) c.push_back({s * x, s * y, s * z});
    for (double p : {-g, g})
        for (double q : {-i, i}) {
            c.push_back({0, s * q, s * p});
            c.push_back({s * q, s * p, 0});
            c.push_back({s * p, 0, s * q});
        }
    std::vector<std::vector<std::uint32_t>> faces;
    for (double p : {-g, g})
        for (double q : {-1.0, 1.0})
            for (int axis = 0; axis < 3; ++axis) {
                DVec3 n;
                n[axis] = p;
                n[(axis + 1) % 3] = q;
                n = normalized(n);
                std::vector<std::pair<double, std::uint32_t>> around;
                double most = 0;
                for (DVec3 v : c) most = std::max(most, dot(n, v));
                DVec3 e1 = normalized(cross(n, DVec3{0.3, 0.5, 0.7})), e2 = cross(n, e1);
                for (std::uint32_t k = 0; k < c.size(); ++k)
                    if (dot(n, c[k]) > most - 1e-6 * s) around.push_back({std::atan2(dot(e2, c[k]), dot(e1, c[k])), k});
                if (around.size() != 5) continue;
                std::sort(around.begin(), around.end());
                faces.emplace_back();
                for (auto& a : around) faces.back().push_back(a.second);
            }
    return make_hull(c, faces);
}

// A shape together with the data it refers to; it can be placed in any pose.
struct Solid {
    cairn::Geometry geometry;
    cairn::ShapeData data;
    Convex at(DVec3 center, DQuat q = {}) const { return make_convex(geometry, data, center, q); }
};
inline Solid solid(const cairn::Shape& shape) {
    return {cairn::make_geometry(shape, {}), cairn::make_shape_data(shape)};
}
inline Solid ball(double r) { return solid(cairn::Sphere{float(r)}); }
inline Solid box(double x, double y, double z) { return solid(cairn::Box{{float(x), float(y), float(z)}}); }
inline Solid capsule(double half, double r) { return solid(cairn::Capsule{float(half), float(r)}); }
inline Solid capsule(double half, double r, double top) {
    return solid(cairn::Capsule{float(half), float(r), float(top)});
}
inline Solid cylinder(double half, double r) { return solid(cairn::Cylinder{float(half), float(r)}); }
inline Solid cylinder(double half, double r, double top) {
    return solid(cairn::Cylinder{float(half), float(r), float(top)});
}
inline Solid hull(std::shared_ptr<const cairn::HullData> data) {
    cairn::Geometry g;
    g.type = cairn::ShapeType::hull;
    g.bounding_radius = data->bounding_radius;
    return {g, std::move(data)};
}

// The shape with rounding: its Minkowski sum with a ball.
inline Solid rounded(Solid s, double r) {
    s.geometry.rounding = float(r);
    s.geometry.bounding_radius += float(r);
    return s;
}

// A random shape of any kind, about `s` in size.
inline Solid any_solid(Random& random, double s) {
    const auto u = [&] { return s * random.uniform(0.2, 1); };
    const auto r = [&] { return s * (random.below(2) ? random.uniform(0.02, 0.1) : random.uniform(0.1, 0.5)); };
    switch (random.below(13)) {
    case 0:
        return ball(u());
    case 1:
        return box(u(), u(), u());
    case 2:
        return capsule(u(), u());
    case 3:
        return capsule(u(), u(), u());
    case 4:
        return cylinder(u(), u());
    case 5:
        return cylinder(u(), u(), u());
    case 6:
        return cylinder(u(), u(), 0);
    case 7:
        return hull(tetrahedron(u()));
    case 8:
        return rounded(box(u(), u(), u()), r());
    case 9:
        return rounded(cylinder(u(), u()), r());
    case 10:
        return rounded(cylinder(u(), u(), random.below(2) ? u() : 0), r());
    case 11:
        return rounded(hull(random.below(2) ? tetrahedron(u()) : prism(3 + random.below(6), u(), u())), r());
    default:
        return hull(random.below(2) ? dodecahedron(0.5 * u()) : prism(3 + random.below(6), u(), u()));
    }
}

inline const DQuat lying = about({0, 0, 1}, 1.5707963267948966);

// A rotation: arbitrary (kind 0), by quarter turns (1), or nearly by quarter turns.
inline DQuat any_turn(Random& random, int kind) {
    if (kind == 0) return random.rotation();
    const DVec3 axes[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const double off = kind == 1 ? 0 : std::pow(10, random.uniform(-12, -2));
    return about(axes[random.below(3)], 0.5 * 3.14159265358979 * random.below(4) + off);
}

inline DVec3 normal_of(const cairn::Manifold& m) { return {m.normal[0], m.normal[1], m.normal[2]}; }
inline double deepest(const cairn::Manifold& m) {
    double d = 1e30;
    for (int i = 0; i < m.count; ++i) d = std::min(d, double(m.points[i][3]));
    return d;
}

} // namespace convex_test
