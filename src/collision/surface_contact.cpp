#include "collision/surface_contact.h"

#include "collision/box_triangle.h"
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

bool is_sharp_box(const Convex& c) { return c.kind == Convex::Kind::box && c.is_sharp; }
double squared(DVec3 v) { return math::dot(v, v); }

bool is_near(DVec3 a, DVec3 b, double distance) { return squared(a - b) < distance * distance; }

// An edge between triangles in the plane of a deeper patch is none: the shape slides over it.
bool is_seam(const SurfaceScratch& scratch, const SurfacePatch& patch, const TriangleHit& hit, double size) {
    if (hit.on_face || is_near(patch.normal, hit.normal, same_normal)) return false;
    const double tolerance = flatness * size, deepest = std::max(patch.depth, 0.0) + tolerance;
    for (std::uint32_t i = hit.first_point; i < hit.first_point + hit.point_count; ++i) {
        const SurfacePoint& p = scratch.points[i];
        const DVec3 foot = p.position + 0.5 * p.separation * hit.normal;
        const double height = -math::dot(patch.normal, foot - patch.foot);
        if (height > tolerance || height < -deepest) return false;
    }
    return true;
}

// The hit of one triangle, in the frame of the shape `a`.
void add_hit(const Convex& a, const BoxHit& found, std::uint32_t triangle, SurfaceScratch& scratch) {
    const auto first = static_cast<std::uint32_t>(scratch.points.size());
    scratch.points.resize(first + std::size_t(found.count));
    for (int i = 0; i < found.count; ++i)
        scratch.points[first + std::size_t(i)] = {a.center + a.axes * found.points[i].position,
                                                  found.points[i].separation};
    scratch.hits.push_back({a.axes * found.normal, a.center + a.axes * found.foot, -found.separation, first,
                            static_cast<std::uint32_t>(found.count), triangle, found.on_face, none});
}
void add_hit(const Manifold& found, const SurfaceContact& contact, std::uint32_t triangle, SurfaceScratch& scratch) {
    const auto first = static_cast<std::uint32_t>(scratch.points.size());
    const DVec3 normal = math::to_double(math::to_vec(found.normal));
    double least = double(found.points[0][3]);
    for (int i = 0; i < found.count; ++i) {
        const double separation = double(found.points[i][3]);
        least = std::min(least, separation);
        scratch.points.push_back({math::to_double(math::to_vec(found.points[i])), separation});
    }
    const SurfacePoint& p = scratch.points[first];
    scratch.hits.push_back({normal, p.position + 0.5 * p.separation * normal, -least, first,
                            static_cast<std::uint32_t>(found.count), triangle,
                            contact.part == SurfaceContact::Part::face, none});
}

void find_hits(const Convex& a, const Surface& surface, double margin, SurfaceScratch& scratch) {
    scratch.hits.clear();
    scratch.points.clear();
    const bool is_box = is_sharp_box(a);
    // Bounds of the shape in the frame of the surface.
    math::Vec3 lo, hi;
    for (int i = 0; i < 3; ++i) {
        const DVec3 axis = surface.axes.column(i);
        const double center = math::dot(axis, surface.center);
        double least, greatest;
        if (is_box) {
            const double middle = math::dot(axis, a.center), half = math::dot(a.size, math::abs(to_local(a, axis)));
            least = middle - half, greatest = middle + half;
        } else
            least = math::dot(axis, support(a, -axis)), greatest = math::dot(axis, support(a, axis));
        lo[i] = float(least - center - margin);
        hi[i] = float(greatest - center + margin);
        const float rounding = 1e-6f * std::max(std::fabs(lo[i]), std::fabs(hi[i]));
        lo[i] -= rounding, hi[i] += rounding;
    }
    const auto to_common = [&](math::Vec3 v) { return surface.center + surface.axes * math::to_double(v); };
    BoxOnTriangles box(a, surface.center, surface.axes, margin);
    BoxHit hit; // of one triangle after the other
    const auto test = [&](const auto& data) {
        for_each_triangle(data, lo, hi, [&](std::uint32_t index) {
            const Triangle t = triangle_of(data, index);
            using Verdict = BoxOnTriangles::Verdict;
            Verdict verdict = Verdict::unsure;
            if (is_box) {
                verdict = box.test(t, hit);
                if (verdict == Verdict::touching) add_hit(a, hit, index, scratch);
                if (verdict == Verdict::touching || verdict == Verdict::apart) return;
            }
            const Convex triangle = make_triangle(to_common(t.a), to_common(t.b), to_common(t.c));
            const DVec3 guess = -triangle.axes.c1;
            Manifold found;
            const SurfaceContact contact =
                verdict == Verdict::beyond_faces
                    ? collide_surface_beyond(box.best_face(), a, triangle, margin, guess, found)
                    : collide_surface(a, triangle, margin, guess, found);
            if (found.count > 0) add_hit(found, contact, index, scratch);
        });
    };
    if (const auto* mesh = std::get_if<std::shared_ptr<const MeshData>>(&surface.data))
        test(**mesh);
    else
        test(height_field_of(surface.data));
}

// The points of all hits of a patch, reduced to four; in turns, where there are very many.
void write_patch(const SurfaceScratch& scratch, std::size_t patch, double extent, Manifold& out) {
    constexpr std::size_t most = 32; // that ContactPoints has room for
    const DVec3 normal = scratch.patches[patch].normal;
    ContactPoints points;
    const auto add = [&](DVec3 position, double separation) {
        points.add({position, separation, static_cast<std::uint32_t>(points.size())});
    };
    const auto reduce = [&] {
        write_manifold(points, normal, {}, extent, unlimited, -unlimited, out);
        points.clear();
    };
    for (const TriangleHit& hit : scratch.hits) {
        if (hit.patch != patch) continue;
        if (points.size() + hit.point_count > most) {
            reduce();
            for (int i = 0; i < out.count; ++i)
                add(math::to_double(math::to_vec(out.points[i])), double(out.points[i][3]));
        }
        for (std::uint32_t i = hit.first_point; i < hit.first_point + hit.point_count; ++i)
            add(scratch.points[i].position, scratch.points[i].separation);
    }
    reduce();
}

} // namespace

void collide_triangles(const Convex& a, const Surface& surface, double margin, SurfaceScratch& scratch,
                       std::vector<Manifold>& manifolds) {
    manifolds.clear();
    find_hits(a, surface, margin, scratch);
    std::sort(scratch.hits.begin(), scratch.hits.end(), [](const TriangleHit& p, const TriangleHit& q) {
        return p.depth != q.depth ? p.depth > q.depth : p.triangle < q.triangle;
    });
    const DVec3 axis = surface.axes.c0;
    const double size =
        is_sharp_box(a) ? math::length(a.size) : 0.5 * math::length(support(a, axis) - support(a, -axis));
    scratch.patches.clear();
    for (TriangleHit& hit : scratch.hits) {
        hit.patch = none;
        const auto seam = std::find_if(scratch.patches.begin(), scratch.patches.end(),
                                       [&](const SurfacePatch& patch) { return is_seam(scratch, patch, hit, size); });
        if (seam != scratch.patches.end()) continue;
        const auto same = std::find_if(scratch.patches.begin(), scratch.patches.end(), [&](const SurfacePatch& patch) {
            return is_near(patch.normal, hit.normal, same_patch);
        });
        hit.patch = std::size_t(same - scratch.patches.begin());
        if (same == scratch.patches.end()) scratch.patches.push_back({hit.normal, hit.foot, hit.depth});
    }
    manifolds.resize(scratch.patches.size());
    for (std::size_t i = 0; i < manifolds.size(); ++i) write_patch(scratch, i, a.extent, manifolds[i]);
}

} // namespace cairn
