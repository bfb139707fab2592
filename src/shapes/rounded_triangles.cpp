#include "shapes/hull.h"

#include <cairn/triangles.h>

#include <algorithm>
#include <cmath>

namespace cairn {

using math::DVec3;

namespace {

class Builder {
  public:
    explicit Builder(ShapeTriangles& out) : out_(out) {}

    std::uint32_t add(DVec3 p, DVec3 normal) {
        out_.vertices.push_back({float(p.x), float(p.y), float(p.z)});
        out_.normals.push_back({float(normal.x), float(normal.y), float(normal.z)});
        return std::uint32_t(out_.vertices.size() - 1);
    }
    void add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        out_.indices.insert(out_.indices.end(), {a, b, c});
    }
    // Adds triangles between two rows of `count` vertices each, the second to the left of the first. If all vertices of
    // a row coincide, only the triangles at the other row have area.
    void add_strip(std::uint32_t first, std::uint32_t second, std::uint32_t count, bool first_is_point,
                   bool second_is_point) {
        for (std::uint32_t i = 0; i + 1 < count; ++i) {
            if (!first_is_point) add_triangle(first + i, first + i + 1, second + i + 1);
            if (!second_is_point) add_triangle(first + i, second + i + 1, second + i);
        }
    }

  private:
    ShapeTriangles& out_;
};

// A unit vector between a and b, which must not be opposite, at i of `steps`.
DVec3 between(DVec3 a, DVec3 b, int i, int steps) {
    if (i == 0) return a;
    if (i == steps) return b;
    const double t = double(i) / steps;
    return math::normalized((1 - t) * a + t * b);
}

// The corners and faces of a box or hull, each face counterclockwise as seen from outside.
struct Solid {
    std::vector<DVec3> corners, normals; // normals are per face
    std::vector<std::vector<std::uint32_t>> faces;
};

Solid solid_of(const Box& box) {
    Solid s;
    for (int i = 0; i < 8; ++i) {
        const auto side = [&](int axis) {
            return double(i >> axis & 1 ? box.half_extents[axis] : -box.half_extents[axis]);
        };
        s.corners.push_back({side(0), side(1), side(2)});
    }
    for (std::uint32_t axis = 0; axis < 3; ++axis) {
        const std::uint32_t u = 1u << (axis + 1) % 3, v = 1u << (axis + 2) % 3, top = 1u << axis;
        DVec3 normal;
        normal[int(axis)] = 1;
        s.normals.insert(s.normals.end(), {normal, -normal});
        s.faces.push_back({top, top | u, top | u | v, top | v});
        s.faces.push_back({0, v, u | v, u});
    }
    return s;
}

Solid solid_of(const HullData& hull) {
    Solid s;
    for (const math::Vec3& v : hull.vertices) s.corners.push_back(math::to_double(v));
    for (std::size_t f = 0; f < hull.faces.size(); ++f) s.normals.push_back(hull.unit_normal(f));
    for (const HullFace& f : hull.faces) {
        const auto first = hull.loops.begin() + std::ptrdiff_t(f.first);
        s.faces.emplace_back(first, first + std::ptrdiff_t(f.count));
    }
    return s;
}

// A rounded solid: flat faces, cylinder sectors along the edges, ball sectors at the corners.
class RoundedSolid {
  public:
    RoundedSolid(const Solid& solid, double radius, ShapeTriangles& out)
        : solid_(solid), r_(radius), steps_(solid.corners.size() <= 32    ? 4
                                            : solid.corners.size() <= 256 ? 2
                                                                          : 1),
          out_(out) {
        for (std::uint32_t f = 0; f < solid.faces.size(); ++f) {
            const auto& loop = solid.faces[f];
            for (std::size_t i = 0; i < loop.size(); ++i) {
                const std::size_t before = (i + loop.size() - 1) % loop.size(), after = (i + 1) % loop.size();
                sides_.push_back({loop[i], loop[after], loop[before], f});
            }
        }
        std::sort(sides_.begin(), sides_.end(),
                  [](const Side& a, const Side& b) { return a.from != b.from ? a.from < b.from : a.to < b.to; });
    }

    void add_all() {
        for (std::uint32_t f = 0; f < solid_.faces.size(); ++f) add_face(f);
        for (const Side& side : sides_) add_edge(side);
        for (std::size_t i = 0; i < sides_.size(); ++i)
            if (i == 0 || sides_[i].from != sides_[i - 1].from) add_corner(sides_[i]);
    }

  private:
    // A side of a face, with the corner before it.
    struct Side {
        std::uint32_t from, to, before, face;
    };

    const Side& side(std::uint32_t from, std::uint32_t to) const {
        return *std::lower_bound(sides_.begin(), sides_.end(), std::pair(from, to),
                                 [](const Side& s, const std::pair<std::uint32_t, std::uint32_t>& key) {
                                     return s.from != key.first ? s.from < key.first : s.to < key.second;
                                 });
    }
    // Evaluates to the same points for both orders of the faces, so that there are no cracks.
    DVec3 arc(std::uint32_t face, std::uint32_t other, int i) const {
        return face < other ? between(solid_.normals[face], solid_.normals[other], i, steps_)
                            : between(solid_.normals[other], solid_.normals[face], steps_ - i, steps_);
    }
    std::uint32_t add_point(std::uint32_t corner, DVec3 n) { return out_.add(solid_.corners[corner] + r_ * n, n); }

    void add_face(std::uint32_t f) {
        std::vector<std::uint32_t> corners;
        for (const std::uint32_t v : solid_.faces[f]) corners.push_back(add_point(v, solid_.normals[f]));
        for (std::size_t i = 2; i < corners.size(); ++i) out_.add_triangle(corners[0], corners[i - 1], corners[i]);
    }
    // Adds the strip along an edge. The face is to the left of its side, the other face to the right.
    void add_edge(const Side& s) {
        const std::uint32_t other = side(s.to, s.from).face;
        if (s.face > other) return; // added from the other face
        const auto row = [&](std::uint32_t corner) {
            const std::uint32_t first = add_point(corner, arc(s.face, other, 0));
            for (int i = 1; i <= steps_; ++i) add_point(corner, arc(s.face, other, i));
            return first;
        };
        const std::uint32_t from = row(s.from), to = row(s.to);
        out_.add_strip(from, to, std::uint32_t(steps_) + 1, false, false);
    }
    // Adds the ball sector at a corner: the normals of the adjacent faces in counterclockwise order, and triangles from
    // their middle out to the arcs between them.
    void add_corner(const Side& start) {
        std::vector<std::uint32_t> faces;
        DVec3 sum;
        const Side* at = &start;
        do {
            faces.push_back(at->face);
            sum += solid_.normals[at->face];
            at = &side(start.from, at->before);
        } while (at->face != start.face && faces.size() < sides_.size());
        const DVec3 middle = math::normalized(sum);
        for (std::size_t k = 0; k < faces.size(); ++k) {
            const std::uint32_t a = faces[k], b = faces[(k + 1) % faces.size()];
            std::uint32_t inner = 0;
            for (int ring = 0; ring <= steps_; ++ring) {
                const auto outer = add_point(start.from, between(middle, arc(a, b, 0), ring, steps_));
                for (int i = 1; i <= steps_; ++i) add_point(start.from, between(middle, arc(a, b, i), ring, steps_));
                if (ring > 0) out_.add_strip(outer, inner, std::uint32_t(steps_) + 1, false, ring == 1);
                inner = outer;
            }
        }
    }

    const Solid& solid_;
    double r_;
    int steps_;
    Builder out_;
    std::vector<Side> sides_; // sorted by their end points
};

// Sweeps the profile of a rounded cylinder around the y axis.
void add_round(const Cylinder& cylinder, ShapeTriangles& out) {
    constexpr int sectors = 32, steps = 4;
    constexpr double cosine = 0.98078528040323044913, sine = 0.19509032201612826785; // of 2 pi / 32
    const double a = double(cylinder.radius), b = double(cylinder.radius_top.value_or(cylinder.radius));
    const double h = double(cylinder.half_height), r = double(cylinder.rounding);
    const DVec3 down{0, -1, 0}, up{0, 1, 0}, side = math::normalized(DVec3{2 * h, a - b, 0});
    struct Point {
        double radius, y;
        DVec3 normal;
    };
    std::vector<Point> profile{{0, -h - r, down}};
    const auto add_arc = [&](double radius, double y, DVec3 from, DVec3 to) {
        const DVec3 middle = math::normalized(from + to);
        for (int i = 0; i <= 2 * steps; ++i) {
            const DVec3 n = i < steps ? between(from, middle, i, steps) : between(middle, to, i - steps, steps);
            profile.push_back({radius + r * n.x, y + r * n.y, n});
        }
    };
    add_arc(a, -h, down, side);
    add_arc(b, h, side, up);
    if (b > 0) profile.push_back({0, h + r, up});
    Builder builder(out);
    std::uint32_t last = 0;
    for (std::size_t k = 0; k < profile.size(); ++k) {
        const Point& p = profile[k];
        double x = 1, z = 0;
        std::uint32_t row = 0;
        for (int i = 0; i <= sectors; ++i) {
            if (i == sectors) x = 1, z = 0; // exactly as at the start
            const std::uint32_t vertex =
                builder.add({p.radius * x, p.y, -p.radius * z}, {p.normal.x * x, p.normal.y, -p.normal.x * z});
            if (i == 0) row = vertex;
            const double next = x * cosine - z * sine;
            z = z * cosine + x * sine, x = next;
        }
        if (k > 0) builder.add_strip(last, row, sectors + 1, !(profile[k - 1].radius > 0), !(p.radius > 0));
        last = row;
    }
}

} // namespace

float rounding_of(const Shape& shape) {
    if (const auto* box = std::get_if<Box>(&shape)) return box->rounding;
    if (const auto* cylinder = std::get_if<Cylinder>(&shape)) return cylinder->rounding;
    if (const auto* hull = std::get_if<Hull>(&shape)) return hull->rounding;
    return 0;
}

ShapeTriangles rounded_triangles(const Shape& shape) {
    ShapeTriangles out;
    if (!(rounding_of(shape) > 0)) return out;
    if (const auto* cylinder = std::get_if<Cylinder>(&shape))
        add_round(*cylinder, out);
    else if (const auto* box = std::get_if<Box>(&shape))
        RoundedSolid(solid_of(*box), double(box->rounding), out).add_all();
    else if (const auto* hull = std::get_if<Hull>(&shape))
        RoundedSolid(solid_of(*hull->data()), double(hull->rounding), out).add_all();
    return out;
}

} // namespace cairn
