#include "collision/surface_contact.h"

#include "collision/contact_points.h"
#include "collision/convex_contact.h"

#include <algorithm>

namespace cairn {

using math::DVec3;

namespace {

constexpr double same_patch = 0.02;  // difference of unit normals, 1.1 degrees: hits that are one patch
constexpr double same_normal = 2e-4; // likewise: an edge that is touched so holds nothing up
constexpr double flatness = 1e-4;    // of the shape's size: how far out of a plane a point may be
constexpr double unlimited = 1e300;
constexpr std::size_t none = ~std::size_t{}; // of the patches

double squared(DVec3 v) { return math::dot(v, v); }

DVec3 normal_of(const Manifold& m) { return math::to_double(math::to_vec(m.normal)); }
DVec3 point_of(const Manifold& m, int i) { return math::to_double(math::to_vec(m.points[i])); }

bool is_near(DVec3 a, DVec3 b, double distance) { return squared(a - b) < distance * distance; }

// Where the surface is at a point of a manifold.
DVec3 foot_of(const Manifold& m, int i) { return point_of(m, i) + 0.5 * double(m.points[i][3]) * normal_of(m); }

// An edge between triangles in the plane of a deeper patch is none: the shape slides over it.
bool is_seam(const SurfacePatch& patch, const TriangleHit& hit, double size) {
    if (hit.on_face || is_near(patch.normal, normal_of(hit.manifold), same_normal)) return false;
    const double tolerance = flatness * size, deepest = std::max(patch.depth, 0.0) + tolerance;
    for (int i = 0; i < hit.manifold.count; ++i) {
        const double height = -math::dot(patch.normal, foot_of(hit.manifold, i) - patch.foot);
        if (height > tolerance || height < -deepest) return false;
    }
    return true;
}

// Tells triangles that a box surely does not touch, in the frame of the box and with few operations: only such that
// collide_surface would find apart along the normal of the triangle or of a face of the box, or behind the triangle.
class BoxFilter {
  public:
    BoxFilter(const Convex& box, const Surface& surface, double margin)
        : half_(box.size), origin_(to_local(box, surface.center - box.center)),
          slack_(1e-6 * box.extent + 1e-12 * math::length(origin_)), reach_(margin + slack_) {
        for (int k = 0; k < 3; ++k) axes_[k] = to_local(box, surface.axes.column(k));
    }

    bool is_apart(const Triangle& t) const {
        const DVec3 a = to_box(t.a), b = to_box(t.b), c = to_box(t.c);
        const DVec3 normal = math::cross(b - a, c - a);
        // Times the length of the normal: the height of the middle, and half the size of the box along the normal.
        const double square = squared(normal), height = -math::dot(normal, a);
        const double size = math::dot(half_, math::abs(normal));
        if (height * height <= slack_ * slack_ * square) return false;
        if (height < 0) return is_beyond(-height - size, slack_, square) || is_beside(a, b, c, normal);
        return is_beyond(height - size, reach_, square) || is_out(a.x, b.x, c.x, half_.x) ||
               is_out(a.y, b.y, c.y, half_.y) || is_out(a.z, b.z, c.z, half_.z);
    }

  private:
    DVec3 to_box(math::Vec3 v) const {
        return origin_ + double(v.x) * axes_[0] + double(v.y) * axes_[1] + double(v.z) * axes_[2];
    }
    static bool is_beyond(double gap, double least, double square) {
        return gap > 0 && gap * gap > least * least * square;
    }
    bool is_out(double p, double q, double r, double half) const {
        const double limit = half + reach_;
        return (p > limit && q > limit && r > limit) || (p < -limit && q < -limit && r < -limit);
    }
    // The middle of the box is not over the triangle, as seen along the normal.
    bool is_beside(DVec3 a, DVec3 b, DVec3 c, DVec3 normal) const {
        const auto is_outside = [&](DVec3 from, DVec3 to) {
            const DVec3 inward = math::cross(normal, to - from);
            return is_beyond(math::dot(inward, from), slack_, squared(inward));
        };
        return is_outside(a, b) || is_outside(b, c) || is_outside(c, a);
    }

    DVec3 half_, origin_, axes_[3]; // of the surface's frame, as the box sees it
    double slack_, reach_;
};

void find_hits(const Convex& a, const Surface& surface, double margin, std::vector<TriangleHit>& hits) {
    hits.clear();
    // Bounds of the shape in the frame of the surface.
    math::Vec3 lo, hi;
    for (int i = 0; i < 3; ++i) {
        const DVec3 axis = surface.axes.column(i);
        const double center = math::dot(axis, surface.center);
        lo[i] = float(math::dot(axis, support(a, -axis)) - center - margin);
        hi[i] = float(math::dot(axis, support(a, axis)) - center + margin);
        const float rounding = 1e-6f * std::max(std::fabs(lo[i]), std::fabs(hi[i]));
        lo[i] -= rounding, hi[i] += rounding;
    }
    const auto to_common = [&](math::Vec3 v) { return surface.center + surface.axes * math::to_double(v); };
    const bool is_box = a.kind == Convex::Kind::box && a.is_sharp; // rounded ones are left to the exact test
    const BoxFilter filter(a, surface, margin);
    const auto test = [&](const auto& data) {
        for_each_triangle(data, lo, hi, [&](std::uint32_t index) {
            const Triangle t = triangle_of(data, index);
            if (is_box && filter.is_apart(t)) return;
            TriangleHit hit{};
            const Convex triangle = make_triangle(to_common(t.a), to_common(t.b), to_common(t.c));
            const SurfaceContact contact = collide_surface(a, triangle, margin, -triangle.axes.c1, hit.manifold);
            if (hit.manifold.count == 0) return;
            hit.triangle = index;
            hit.on_face = contact.part == SurfaceContact::Part::face;
            hit.depth = -double(hit.manifold.points[0][3]);
            for (int i = 1; i < hit.manifold.count; ++i)
                hit.depth = std::max(hit.depth, -double(hit.manifold.points[i][3]));
            hits.push_back(hit);
        });
    };
    if (const auto* mesh = std::get_if<std::shared_ptr<const MeshData>>(&surface.data))
        test(**mesh);
    else
        test(height_field_of(surface.data));
}

// The points of all hits of a patch, reduced to four; in turns, where there are very many.
void write_patch(const SurfaceScratch& scratch, std::size_t patch, double extent, Manifold& out) {
    constexpr std::size_t most = 28; // ContactPoints has room for four more
    const DVec3 normal = scratch.patches[patch].normal;
    ContactPoints points;
    const auto add = [&](const Manifold& m) {
        for (int i = 0; i < m.count; ++i)
            points.add({point_of(m, i), double(m.points[i][3]), static_cast<std::uint32_t>(points.size())});
    };
    const auto reduce = [&] {
        write_manifold(points, normal, {}, extent, unlimited, -unlimited, out);
        points.clear();
    };
    for (const TriangleHit& hit : scratch.hits) {
        if (hit.patch != patch) continue;
        add(hit.manifold);
        if (points.size() <= most) continue;
        reduce();
        add(out);
    }
    reduce();
}

} // namespace

void collide_triangles(const Convex& a, const Surface& surface, double margin, SurfaceScratch& scratch,
                       std::vector<Manifold>& manifolds) {
    manifolds.clear();
    find_hits(a, surface, margin, scratch.hits);
    std::sort(scratch.hits.begin(), scratch.hits.end(), [](const TriangleHit& p, const TriangleHit& q) {
        return p.depth != q.depth ? p.depth > q.depth : p.triangle < q.triangle;
    });
    const double size = 0.5 * math::length(support(a, surface.axes.c0) - support(a, -surface.axes.c0));
    scratch.patches.clear();
    for (TriangleHit& hit : scratch.hits) {
        hit.patch = none;
        const DVec3 normal = normal_of(hit.manifold);
        const auto seam = std::find_if(scratch.patches.begin(), scratch.patches.end(),
                                       [&](const SurfacePatch& patch) { return is_seam(patch, hit, size); });
        if (seam != scratch.patches.end()) continue;
        const auto same = std::find_if(scratch.patches.begin(), scratch.patches.end(), [&](const SurfacePatch& patch) {
            return is_near(patch.normal, normal, same_patch);
        });
        hit.patch = std::size_t(same - scratch.patches.begin());
        if (same == scratch.patches.end()) scratch.patches.push_back({normal, foot_of(hit.manifold, 0), hit.depth});
    }
    manifolds.resize(scratch.patches.size());
    for (std::size_t i = 0; i < manifolds.size(); ++i) write_patch(scratch, i, a.extent, manifolds[i]);
}

} // namespace cairn
