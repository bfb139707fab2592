#include "collision/surface_contact.h"

#include "collision/box_triangle.h"
#include "collision/contact_points.h"
#include "collision/convex_contact.h"
#include "shapes/surface_materials.h"

#include <algorithm>

namespace cairn {

using math::DVec3;

namespace {

constexpr double same_patch = 0.12;          // difference of unit normals, 7 degrees: hits within this form one patch
constexpr double same_normal = 2e-4;         // difference of unit normals: an edge so near a face supports nothing
constexpr double normal_rounding = 1e-6;     // difference of a unit normal that is computed twice
constexpr double flatness = 1e-4;            // share of the shape's size: tolerance for points on planes or triangles
constexpr std::size_t none = ~std::size_t{}; // index of a patch: none

// The pose of the frame of the hits in the common frame; the identity by default.
struct Placement {
    DVec3 center;
    math::DMat3 axes;
    bool is_common = true;

    DVec3 turned(DVec3 v) const { return is_common ? v : axes * v; }
    DVec3 placed(DVec3 p) const { return is_common ? p : center + axes * p; }
    DVec3 turned_back(DVec3 v) const {
        return is_common ? v : DVec3{math::dot(axes.c0, v), math::dot(axes.c1, v), math::dot(axes.c2, v)};
    }
    DVec3 placed_back(DVec3 p) const { return is_common ? p : turned_back(p - center); }
};

bool is_sharp_box(const Convex& c) { return c.kind == Convex::Kind::box && c.is_sharp; }
double squared(DVec3 v) { return math::dot(v, v); }

bool is_near(DVec3 a, DVec3 b, double distance) { return squared(a - b) < distance * distance; }

// Whether a hit at an edge is at an internal edge: one in the plane of a deeper patch, over which the shape slides.
// (For boxes whose edges are separated, foot points can be off by some micrometers, too far for LocalMinima.)
bool is_internal_edge(const SurfaceScratch& scratch, const SurfacePatch& patch, const TriangleHit& hit, double size) {
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

// Removes hits on the far sides of a thin wall, or of a sheet with triangles on both sides: the center of the shape is
// behind the far side as well, and the shape may extend through it. A shape is not lifted to the far side if a triangle
// with the shape in front of it lies between: at or behind the far side, and on the line from the shape's center to it.
void drop_far_sides(SurfaceScratch& scratch, double tolerance) {
    std::vector<TriangleHit>& hits = scratch.hits;
    const auto is_far_side = [&](const TriangleHit& hit) {
        return hit.is_lifted && std::any_of(hits.begin(), hits.end(), [&](const TriangleHit& near) {
                   const DVec3 way = near.foot - hit.foot; // the foot of a lifted shape is below its center
                   return !near.is_lifted && math::dot(near.normal, hit.normal) < 0 &&
                          math::dot(hit.normal, way) >= -tolerance && math::dot(near.normal, way) <= tolerance;
               });
    };
    if (std::any_of(hits.begin(), hits.end(), [](const TriangleHit& hit) { return hit.is_lifted; }))
        hits.erase(std::remove_if(hits.begin(), hits.end(), is_far_side), hits.end()); // hits on fronts all stay
}

// Adds the hit of one triangle.
void add_hit(const BoxHit& found, std::uint32_t triangle, SurfaceScratch& scratch) {
    const auto first = static_cast<std::uint32_t>(scratch.points.size());
    scratch.points.insert(scratch.points.end(), found.points, found.points + found.count);
    scratch.hits.push_back({found.normal, found.foot, -found.separation, first, static_cast<std::uint32_t>(found.count),
                            triangle, found.on_face, false, none});
}
// Adds a hit, from a manifold in the common frame.
void add_hit(const Manifold& found, const SurfaceContact& contact, const Placement& frame, std::uint32_t triangle,
             SurfaceScratch& scratch) {
    const auto first = static_cast<std::uint32_t>(scratch.points.size());
    const DVec3 normal = frame.turned_back(math::to_double(math::to_vec(found.normal)));
    double least = double(found.points[0][3]);
    for (int i = 0; i < found.count; ++i) {
        const double separation = double(found.points[i][3]);
        least = std::min(least, separation);
        scratch.points.push_back({frame.placed_back(math::to_double(math::to_vec(found.points[i]))), separation});
    }
    const SurfacePoint& p = scratch.points[first];
    scratch.hits.push_back({normal, p.position + 0.5 * p.separation * normal, -least, first,
                            static_cast<std::uint32_t>(found.count), triangle,
                            contact.part == SurfaceContact::Part::face, contact.is_lifted, none});
}

struct Bounds {
    math::Vec3 lo, hi;
};

// Bounds of the shape, enlarged by `reach`, in the frame of the surface.
Bounds bounds_of(const Convex& a, const Surface& surface, double reach) {
    Bounds bounds;
    for (int i = 0; i < 3; ++i) {
        const DVec3 axis = surface.axes.column(i);
        const double center = math::dot(axis, surface.center);
        double least, greatest;
        if (is_sharp_box(a)) {
            const double middle = math::dot(axis, a.center), half = math::dot(a.size, math::abs(to_local(a, axis)));
            least = middle - half, greatest = middle + half;
        } else
            least = math::dot(axis, support(a, -axis)), greatest = math::dot(axis, support(a, axis));
        float &lo = bounds.lo[i], &hi = bounds.hi[i];
        lo = float(least - center - reach);
        hi = float(greatest - center + reach);
        const float rounding = 1e-6f * std::max(std::fabs(lo), std::fabs(hi));
        lo -= rounding, hi += rounding;
    }
    return bounds;
}

// Calls f(data) for the mesh or height field.
template <class F> void with_data(const Surface& surface, F&& f) {
    if (const auto* mesh = std::get_if<std::shared_ptr<const MeshData>>(&surface.data))
        f(**mesh);
    else
        f(height_field_of(surface.data));
}

std::uint32_t material_number(const Surface& surface, std::uint32_t triangle) {
    std::uint32_t number = 0;
    with_data(surface, [&](const auto& data) { number = material_number(data, triangle); });
    return number;
}

// Whether a point is on a triangle, within a tolerance.
bool is_on(const DVec3 (&corners)[3], DVec3 p, double tolerance) {
    const DVec3 n = math::cross(corners[1] - corners[0], corners[2] - corners[0]);
    const double square = squared(n), height = math::dot(n, p - corners[0]);
    if (!(height * height <= tolerance * tolerance * square)) return false;
    for (int i = 0; i < 3; ++i) {
        const DVec3 from = corners[i], edge = corners[(i + 1) % 3] - from;
        const double inside = math::dot(math::cross(edge, p - from), n);
        if (inside < 0 && inside * inside > tolerance * tolerance * squared(edge) * square) return false;
    }
    return true;
}

// Finds the hits of a shape of any kind; returns a lower bound of its distance from all triangles.
class HitSearch {
  public:
    HitSearch(const Convex& a, const Surface& surface, double margin, const Placement& frame, SurfaceScratch& scratch)
        : a_(a), surface_(surface), margin_(margin), frame_(frame), scratch_(scratch) {}

    double search(double reach) {
        const Bounds bounds = bounds_of(a_, surface_, reach);
        double distance = reach;
        with_data(surface_, [&](const auto& data) {
            for_each_triangle(data, bounds.lo, bounds.hi, [&](std::uint32_t index) {
                test(triangle_of(data, index), index);
                distance = 0;
            });
        });
        return distance;
    }
    double search_around_box(const TriangleKernels& kernels, double reach) {
        const Bounds bounds = bounds_of(a_, surface_, reach);
        BoxOnTriangles box(kernels, a_, surface_.center, surface_.axes, margin_);
        double distance = reach;
        const auto test_all = [&](const auto& data) {
            distance = std::min(distance, box.look([&](std::uint32_t index) { return triangle_of(data, index); }));
            using Verdict = BoxOnTriangles::Verdict;
            box.test([&](std::uint32_t index, Verdict verdict, const BoxHit& hit) {
                if (verdict == Verdict::touching)
                    add_hit(hit, index, scratch_);
                else
                    test(triangle_of(data, index), index,
                         verdict == Verdict::beyond_faces ? &box.best_face() : nullptr);
            });
        };
        with_data(surface_, [&](const auto& data) {
            for_each_triangle(data, bounds.lo, bounds.hi, [&](std::uint32_t index) {
                if (box.count() == BoxOnTriangles::most) test_all(data);
                box.add(index);
            });
            if (box.count() > 0) test_all(data);
        });
        return distance;
    }

    // Replaces the hit of a triangle that is coplanar with a deeper face by its contact along the face normal: a tilted
    // shape is nearest to the triangle's edge there, but may be over all of it.
    void go_on_with(const SurfacePatch& face, std::uint32_t hit) {
        const Convex triangle = placed(scratch_.hits[hit].triangle);
        const DVec3 n = -triangle.axes.c1;
        if (!is_near(frame_.turned(face.normal), n, same_normal)) return;
        Manifold found;
        collide_front(a_, triangle, margin_, found);
        replace(hit, found);
    }

    // A shape that is sunk in near an edge beyond which the surface continues or rises is not pushed out over the edge,
    // but along the triangle's normal: in the corner of a room, each wall would otherwise push it through the other.
    void lift_from_corners(double tolerance) {
        for (std::uint32_t k = 0; k < scratch_.hits.size(); ++k) {
            const TriangleHit& hit = scratch_.hits[k];
            if (hit.on_face || hit.is_lifted || !(hit.depth > tolerance)) continue;
            const Convex triangle = placed(hit.triangle);
            const DVec3 normal = frame_.turned(hit.normal), foot = frame_.placed(hit.foot);
            if (!leaves_over_corner(triangle, hit.triangle, normal, foot, hit.depth, tolerance)) continue;
            Manifold found;
            collide_lifted(a_, triangle, margin_, found);
            replace(k, found);
        }
    }

    // The contact of a cylinder or cone with the plane of a face, if all its points are over triangles in that plane:
    // if the rim meets several triangles, each would otherwise have its own lowest point. (For other shapes, these
    // points are vertices.)
    bool lies_on_plane(std::size_t patch, double tolerance, Manifold& out) const {
        const SurfacePatch& face = scratch_.patches[patch];
        if (!face.on_face || a_.kind != Convex::Kind::cylinder) return false;
        collide_plane(a_, -face.normal, math::dot(face.normal, face.foot - a_.center), margin_, out);
        for (int i = 0; i < out.count; ++i) {
            const DVec3 p = math::to_double(math::to_vec(out.points[i]));
            if (!is_over_face(face, p + (0.5 * double(out.points[i][3])) * face.normal, tolerance)) return false;
        }
        for (int i = 0; i < out.count; ++i) out.features[i] &= 255u;
        out.features[0] |= on_second_face;
        return out.count > 0;
    }

  private:
    bool is_over_face(const SurfacePatch& face, DVec3 foot, double tolerance) const {
        return std::any_of(scratch_.hits.begin(), scratch_.hits.end(), [&](const TriangleHit& hit) {
            const Convex t = placed(hit.triangle);
            return is_near(-t.axes.c1, face.normal, same_normal) &&
                   material_number(surface_, hit.triangle) == face.material &&
                   is_on({t.corners[0], t.corners[1], t.corners[2]}, foot, tolerance);
        });
    }
    // Replaces a hit by what was found for the same triangle, if anything.
    void replace(std::uint32_t hit, const Manifold& found) {
        if (found.count == 0) return;
        add_hit(found, {}, frame_, scratch_.hits[hit].triangle, scratch_);
        scratch_.hits[hit] = scratch_.hits.back();
        scratch_.hits.pop_back();
    }
    // Whether the contact is at an edge beyond which the surface continues or rises, and its normal pushes the shape
    // over that edge. False at a corner, where it depends on all adjacent triangles. The position is known to within
    // the depth.
    bool leaves_over_corner(const Convex& triangle, std::uint32_t index, DVec3 normal, DVec3 foot, double depth,
                            double tolerance) const {
        const DVec3 up = triangle.axes.c1;
        int at = -1; // index of the edge
        for (int i = 0; i < 3; ++i) {
            const DVec3 from = triangle.corners[i], edge = triangle.corners[(i + 1) % 3] - from;
            const DVec3 outward = (1 / math::length(edge)) * math::cross(edge, up);
            if (math::dot(outward, foot - from) < -depth) continue;
            if (at >= 0 || !(-math::dot(normal, outward) > same_normal)) return false;
            at = i;
        }
        if (at < 0) return false;
        bool goes_on = false;
        with_data(surface_, [&](const auto& data) {
            const std::uint32_t across = neighbor_of(data, index, at);
            if (across == no_triangle) return;
            const Convex other = placed(triangle_of(data, across));
            goes_on = std::all_of(other.corners, other.corners + 3, [&](const DVec3& corner) {
                return math::dot(up, corner - triangle.corners[at]) >= -tolerance;
            });
        });
        return goes_on;
    }
    Convex placed(const Triangle& t) const {
        const auto to_common = [&](math::Vec3 v) { return surface_.center + surface_.axes * math::to_double(v); };
        return make_triangle(to_common(t.a), to_common(t.b), to_common(t.c));
    }
    Convex placed(std::uint32_t index) const {
        Convex triangle;
        with_data(surface_, [&](const auto& data) { triangle = placed(triangle_of(data, index)); });
        return triangle;
    }
    // Tests a triangle by the general convex test. beyond: what is known of the faces, if they do not give the contact.
    void test(const Triangle& t, std::uint32_t index, const FaceReach* beyond = nullptr) {
        const Convex triangle = placed(t);
        const DVec3 guess = -triangle.axes.c1;
        Manifold found;
        const SurfaceContact contact = beyond ? collide_surface_beyond(*beyond, a_, triangle, margin_, guess, found)
                                              : collide_surface(a_, triangle, margin_, guess, found);
        if (found.count > 0) add_hit(found, contact, frame_, index, scratch_);
    }

    const Convex& a_;
    const Surface& surface_;
    double margin_;
    const Placement& frame_;
    SurfaceScratch& scratch_;
};

// Tests whether a hit is a local minimum of the distance from the surface. At the edge of a triangle whose neighbor
// continues towards the shape it is not: the next triangle of a floor, or the next facet of a bowl, begins there.
class LocalMinima {
  public:
    LocalMinima(const Surface& surface, const Placement& frame, const SurfaceScratch& scratch, double tolerance)
        : surface_(surface), frame_(frame), scratch_(scratch), tolerance_(tolerance) {}

    // Tests the hit at `place` in the order of depths.
    bool has(std::size_t place) const {
        const TriangleHit& hit = scratch_.hits[scratch_.order[place]];
        if (hit.on_face) return true;
        for (std::uint32_t i = hit.first_point; i < hit.first_point + hit.point_count; ++i) {
            const SurfacePoint& p = scratch_.points[i];
            if (!goes_on(place, hit, p.position + 0.5 * p.separation * hit.normal)) return true;
        }
        return false;
    }

  private:
    // Whether a triangle with a deeper hit, along another normal, contains this point.
    bool goes_on(std::size_t place, const TriangleHit& hit, DVec3 foot) const {
        for (std::size_t k = 0; k < place; ++k) {
            const TriangleHit& other = scratch_.hits[scratch_.order[k]];
            if (!is_near(other.normal, hit.normal, same_normal) && is_on_triangle(other.triangle, foot)) return true;
        }
        return false;
    }
    bool is_on_triangle(std::uint32_t index, DVec3 p) const {
        bool is_on_it = false;
        with_data(surface_, [&](const auto& data) {
            const Triangle t = triangle_of(data, index);
            const auto placed = [&](math::Vec3 v) {
                return frame_.placed_back(surface_.center + surface_.axes * math::to_double(v));
            };
            is_on_it = is_on({placed(t.a), placed(t.b), placed(t.c)}, p, tolerance_);
        });
        return is_on_it;
    }
    const Surface& surface_;
    const Placement& frame_;
    const SurfaceScratch& scratch_;
    const double tolerance_;
};

// Whether a hit with another normal than that of a deeper face is in the plane of the face.
bool may_go_on_with(const SurfacePatch& face, const TriangleHit& hit, double size) {
    return face.on_face && is_near(face.normal, hit.normal, same_patch) &&
           !is_near(face.normal, hit.normal, normal_rounding) &&
           std::fabs(math::dot(face.normal, hit.foot - face.foot)) <= flatness * size;
}

// Writes the points of all hits of a patch, reduced to four.
void write_patch(SurfaceScratch& scratch, std::size_t patch, const Placement& frame, double extent, Manifold& out) {
    const DVec3 normal = scratch.patches[patch].normal;
    const FlatFrame flat(normal, {});
    if (scratch.flat.size() < scratch.points.size()) {
        scratch.flat.resize(scratch.points.size());
        scratch.which.resize(scratch.points.size());
    }
    std::size_t count = 0;
    for (const std::uint32_t k : scratch.order) {
        const TriangleHit& hit = scratch.hits[k];
        if (hit.patch != patch) continue;
        for (std::uint32_t i = hit.first_point; i < hit.first_point + hit.point_count; ++i) {
            scratch.flat[count] = flat.flat(scratch.points[i].position, scratch.points[i].separation);
            scratch.which[count++] = i;
        }
    }
    const Chosen chosen = choose_points({scratch.flat.data(), count}, extent);
    clear_manifold(out);
    out.count = chosen.count;
    math::put(out.normal, math::to_float(frame.turned(normal)));
    for (int i = 0; i < chosen.count; ++i) {
        const SurfacePoint& p = scratch.points[scratch.which[chosen.index[i]]];
        math::put(out.points[i], math::to_float(frame.placed(p.position)));
        out.points[i][3] = static_cast<float>(p.separation);
        out.features[i] = static_cast<std::uint32_t>(chosen.index[i]) & 255u;
    }
    if (scratch.patches[patch].on_face) out.features[0] |= on_second_face;
}

} // namespace

double collide_triangles(const TriangleKernels& kernels, const Convex& a, const Surface& surface, double margin,
                         double reach, SurfaceScratch& scratch, std::vector<Manifold>& manifolds) {
    manifolds.clear();
    scratch.hits.clear();
    scratch.points.clear();
    const bool is_box = is_sharp_box(a);
    // The hits of boxes are in the box's frame.
    const Placement frame = is_box ? Placement{a.center, a.axes, false} : Placement{};
    HitSearch search(a, surface, margin, frame, scratch);
    const double distance = is_box ? search.search_around_box(kernels, reach) : search.search(reach);
    if (scratch.hits.empty()) return distance;
    const DVec3 axis = surface.axes.c0;
    const double size = is_box ? math::length(a.size) : 0.5 * math::length(support(a, axis) - support(a, -axis));
    drop_far_sides(scratch, flatness * size);
    search.lift_from_corners(flatness * size);
    scratch.order.resize(scratch.hits.size());
    for (std::uint32_t i = 0; i < scratch.order.size(); ++i) scratch.order[i] = i;
    std::sort(scratch.order.begin(), scratch.order.end(), [&](std::uint32_t i, std::uint32_t k) {
        const TriangleHit &p = scratch.hits[i], &q = scratch.hits[k];
        return p.depth != q.depth ? p.depth > q.depth : p.triangle < q.triangle;
    });
    scratch.patches.clear();
    const LocalMinima minima(surface, frame, scratch, flatness * size);
    for (std::size_t place = 0; place < scratch.order.size(); ++place) {
        for (const SurfacePatch& face : scratch.patches)
            if (may_go_on_with(face, scratch.hits[scratch.order[place]], size))
                search.go_on_with(face, scratch.order[place]);
        TriangleHit& hit = scratch.hits[scratch.order[place]];
        const bool is_edge = std::any_of(scratch.patches.begin(), scratch.patches.end(), [&](const SurfacePatch& p) {
            return is_internal_edge(scratch, p, hit, size);
        });
        if (is_edge || !minima.has(place)) continue;
        const std::uint32_t material = material_number(surface, hit.triangle);
        const auto same = std::find_if(scratch.patches.begin(), scratch.patches.end(), [&](const SurfacePatch& patch) {
            return patch.material == material && is_near(patch.normal, hit.normal, same_patch);
        });
        hit.patch = std::size_t(same - scratch.patches.begin());
        if (same == scratch.patches.end())
            scratch.patches.push_back({hit.normal, hit.foot, hit.depth, hit.on_face, material});
        else if (hit.on_face && is_near(same->normal, hit.normal, same_normal))
            same->on_face = true;
    }
    manifolds.resize(scratch.patches.size());
    for (std::size_t i = 0; i < manifolds.size(); ++i) {
        if (!search.lies_on_plane(i, flatness * size, manifolds[i]))
            write_patch(scratch, i, frame, a.extent, manifolds[i]);
        manifolds[i].features[0] |= scratch.patches[i].material << surface_material_bit;
    }
    return 0;
}

} // namespace cairn
