// Exactly coplanar triangles form one facet; on a convex surface facets are convex, and they are never split. Facets
// are then merged, the largest first, if the result is an acceptable face: a disk, flat and convex within the
// tolerance. If a merge fails, a smaller tolerance is tried; a single facet is always acceptable. Points that no face
// needs are reported to the caller, who removes them and returns with a new triangulation.
#include "shapes/hull_faces.h"

#include "core/order.h"

#include <algorithm>

namespace cairn::hull {

using math::DVec3;

namespace {

constexpr std::uint32_t none = ~std::uint32_t{};

struct Point2 {
    double x = 0, y = 0;
};
Point2 operator-(Point2 a, Point2 b) { return {a.x - b.x, a.y - b.y}; }
double dot(Point2 a, Point2 b) { return a.x * b.x + a.y * b.y; }
double cross(Point2 a, Point2 b) { return a.x * b.y - a.y * b.x; }

// The signed distance of p from the segment a b; negative on its left side.
double beyond_segment(Point2 p, Point2 a, Point2 b) {
    const Point2 e = b - a, d = p - a, f = p - b;
    const double length = std::sqrt(dot(e, e));
    if (length == 0) return std::sqrt(dot(d, d));
    const double side = -cross(e, d) / length;
    if (dot(d, e) >= 0 && dot(f, e) <= 0) return side;
    const double distance = std::sqrt(std::min(dot(d, d), dot(f, f)));
    return side < 0 ? -distance : distance;
}

struct Facet {
    DVec3 area, normal;                 // area vector (twice the area), and its direction
    std::uint32_t first = 0, count = 0; // range of triangles
    bool is_taken = false, is_alone = false;
    std::uint32_t mark = 0;
};

class FaceMaker {
  public:
    FaceMaker(std::span<const GridPoint> points, std::span<const Triangle> triangles, double plane_tolerance,
              double corner_tolerance)
        : points_(points), triangles_(triangles), plane_tolerance_(plane_tolerance),
          corner_tolerance_(corner_tolerance), facet_of_(triangles.size(), none), after_(points.size(), none),
          faces_at_(points.size(), 0), is_kept_(points.size(), false), is_redundant_(points.size(), false) {}

    Faces run() {
        find_facets();
        find_alone();
        out_.faces.reserve(facets_.size());
        out_.loops.reserve(3 * facets_.size());
        std::vector<std::uint32_t> others;
        std::vector<std::uint64_t> sizes;
        for (std::uint32_t i = 0; i < facets_.size(); ++i)
            if (!facets_[i].is_alone) others.push_back(i), sizes.push_back(~order_key(size_of(facets_[i])));
        for (const std::uint32_t i : order_by(sizes))
            if (!facets_[others[i]].is_taken) make_face(others[i]);
        for (Facet& facet : facets_)
            if (facet.is_alone && !facet.is_taken) make_pointed_face(facet);
        find_redundant();
        for (std::uint32_t p = 0; p < points_.size(); ++p)
            if (is_redundant_[p]) out_.redundant.push_back(p);
        return std::move(out_);
    }

  private:
    struct Corner {
        std::uint32_t at, before, after;
    };

    void find_facets() {
        facets_.reserve(triangles_.size());
        by_facet_.reserve(triangles_.size());
        for (std::uint32_t seed = 0; seed < triangles_.size(); ++seed) {
            if (facet_of_[seed] != none) continue;
            const auto index = std::uint32_t(facets_.size());
            Facet facet;
            facet.first = std::uint32_t(by_facet_.size());
            facet_of_[seed] = index;
            by_facet_.push_back(seed);
            const auto& a = triangles_[seed].corners;
            for (std::size_t i = facet.first; i < by_facet_.size(); ++i) {
                const Triangle& triangle = triangles_[by_facet_[i]];
                const auto& c = triangle.corners;
                facet.area += to_double(area_vector(points_[c[0]], points_[c[1]], points_[c[2]]));
                for (const std::uint32_t other : triangle.neighbors) {
                    if (facet_of_[other] != none) continue;
                    const auto& d = triangles_[other].corners;
                    bool is_flat = true;
                    for (int k = 0; k < 3 && is_flat; ++k)
                        is_flat = side_of(points_[a[0]], points_[a[1]], points_[a[2]], points_[d[k]]) == 0;
                    if (!is_flat) continue;
                    facet_of_[other] = index;
                    by_facet_.push_back(other);
                }
            }
            facet.count = std::uint32_t(by_facet_.size()) - facet.first;
            facet.normal = math::normalized(facet.area);
            facets_.push_back(facet);
        }
    }

    std::span<const std::uint32_t> triangles_of(const Facet& facet) const {
        return {by_facet_.data() + facet.first, facet.count};
    }

    double offset_of(const Facet& facet) const {
        return math::dot(facet.normal, to_double(points_[triangles_[by_facet_[facet.first]].corners[0]]));
    }

    bool fits(const Facet& facet, DVec3 normal, double least) const {
        // limit 0.5: slivers along an edge of the body join the face that they are oriented like
        if (!(math::dot(facet.normal, normal) > 0.5)) return false;
        for (const std::uint32_t t : triangles_of(facet))
            for (const std::uint32_t corner : triangles_[t].corners)
                if (!(math::dot(normal, to_double(points_[corner])) >= least)) return false;
        return true;
    }

    static double size_of(const Facet& facet) { return math::dot(facet.area, facet.area); }

    // Whether facet b is no longer available when facet a is processed. A facet that stays alone counts as processed in
    // the order of sizes.
    bool is_gone(std::uint32_t b, std::uint32_t a) const {
        if (!facets_[b].is_alone) return facets_[b].is_taken;
        const double size_a = size_of(facets_[a]), size_b = size_of(facets_[b]);
        return facets_[b].is_taken || size_b > size_a || (size_b == size_a && b < a);
    }

    // Finds pointed triangles that no other facet will join; on round bodies these are the majority. They need no order
    // by size, and are processed in storage order.
    void find_alone() {
        for (std::uint32_t index = 0; index < facets_.size(); ++index) {
            Facet& facet = facets_[index];
            const double least = offset_of(facet) - plane_tolerance_;
            facet.is_alone = is_pointed(facet);
            if (!facet.is_alone) continue;
            for (const std::uint32_t t : triangles_of(facet))
                for (const std::uint32_t neighbor : triangles_[t].neighbors) {
                    const std::uint32_t other = facet_of_[neighbor];
                    if (other != index && fits(facets_[other], facet.normal, least)) facet.is_alone = false;
                }
        }
    }

    // Collects the facets around the seed that lie within the tolerance below its plane.
    void grow(std::uint32_t seed, double tolerance) {
        ++mark_;
        region_.assign(1, seed);
        facets_[seed].mark = mark_;
        const DVec3 normal = facets_[seed].normal;
        const double least = offset_of(facets_[seed]) - tolerance;
        for (std::size_t i = 0; i < region_.size(); ++i)
            for (const std::uint32_t t : triangles_of(facets_[region_[i]]))
                for (const std::uint32_t neighbor : triangles_[t].neighbors) {
                    Facet& facet = facets_[facet_of_[neighbor]];
                    if (facet.mark == mark_ || is_gone(facet_of_[neighbor], seed)) continue;
                    if (!fits(facet, normal, least)) continue;
                    facet.mark = mark_;
                    region_.push_back(facet_of_[neighbor]);
                }
    }

    // Traces the outline of the region. Returns false if it is not one simple loop.
    bool trace() {
        std::size_t edges = 0;
        bool is_simple = true;
        std::uint32_t start = none;
        touched_.clear();
        for (const std::uint32_t index : region_)
            for (const std::uint32_t t : triangles_of(facets_[index]))
                for (int k = 0; k < 3; ++k) {
                    if (facets_[facet_of_[triangles_[t].neighbors[k]]].mark == mark_) continue;
                    const std::uint32_t from = triangles_[t].corners[k], to = triangles_[t].corners[(k + 1) % 3];
                    is_simple = is_simple && after_[from] == none;
                    after_[from] = to;
                    touched_.push_back(from);
                    start = std::min(start, from);
                    ++edges;
                }
        loop_.clear();
        if (is_simple && edges >= 3)
            for (std::uint32_t p = start; loop_.size() <= edges;) {
                loop_.push_back(p);
                p = after_[p];
                if (p == start || p == none) break;
            }
        for (const std::uint32_t p : touched_) after_[p] = none;
        return is_simple && loop_.size() == edges && edges >= 3;
    }

    void flatten() {
        DVec3 area;
        for (const std::uint32_t index : region_) area += facets_[index].area;
        normal_ = math::normalized(area);
        const DVec3 axis = std::fabs(normal_.x) < 0.5 ? DVec3{1, 0, 0} : DVec3{0, 1, 0};
        const DVec3 u = math::normalized(math::cross(axis, normal_)), v = math::cross(normal_, u);
        const DVec3 origin = to_double(points_[loop_[0]]);
        flat_.clear();
        for (const std::uint32_t p : loop_) {
            const DVec3 d = to_double(points_[p]) - origin;
            flat_.push_back({math::dot(u, d), math::dot(v, d)});
        }
    }

    // Whether every corner of the outline is within the tolerance of its convex hull (Andrew's monotone chain), and in
    // order.
    bool is_convex(double tolerance) {
        const auto count = std::uint32_t(flat_.size());
        chain_.resize(count);
        for (std::uint32_t i = 0; i < count; ++i) chain_[i] = i;
        std::sort(chain_.begin(), chain_.end(), [&](std::uint32_t a, std::uint32_t b) {
            const Point2 p = flat_[a], q = flat_[b];
            return p.x != q.x ? p.x < q.x : p.y != q.y ? p.y < q.y : a < b;
        });
        ring_.clear();
        auto extend = [&](std::uint32_t i, std::size_t floor) {
            while (ring_.size() >= floor + 2 && cross(flat_[ring_.back()] - flat_[ring_[ring_.size() - 2]],
                                                      flat_[i] - flat_[ring_[ring_.size() - 2]]) <= 0)
                ring_.pop_back();
            ring_.push_back(i);
        };
        for (std::uint32_t k = 0; k < count; ++k) extend(chain_[k], 0);
        const std::size_t lower = ring_.size() - 1;
        for (std::uint32_t k = count - 1; k-- > 0;) extend(chain_[k], lower);
        ring_.pop_back();
        if (ring_.size() < 3) return false;
        std::size_t turns = 0;
        for (std::size_t k = 0; k < ring_.size(); ++k) {
            const std::uint32_t from = ring_[k], to = ring_[(k + 1) % ring_.size()];
            turns += from >= to;
            for (std::uint32_t i = (from + 1) % count; i != to; i = (i + 1) % count)
                if (std::fabs(beyond_segment(flat_[i], flat_[from], flat_[to])) > tolerance) return false;
        }
        return turns == 1;
    }

    // Whether the facet is a triangle with three protruding corners, whatever the rounding, as are most faces of round
    // bodies.
    bool is_pointed(const Facet& facet) const {
        if (facet.count != 1) return false;
        const auto& corners = triangles_[by_facet_[facet.first]].corners;
        const DVec3 a = to_double(points_[corners[0]]), b = to_double(points_[corners[1]]),
                    c = to_double(points_[corners[2]]);
        const double longest =
            std::max({math::dot(b - a, b - a), math::dot(c - b, c - b), math::dot(a - c, a - c)}); // squared length
        const double least = 1.001 * std::max(plane_tolerance_, corner_tolerance_) + 0.01;         // height
        return math::dot(facet.area, facet.area) > least * least * longest;
    }

    // Adds the triangle as a face; none of its corners is blunt.
    void make_pointed_face(Facet& facet) {
        facet.is_taken = true;
        const auto& corners = triangles_[by_facet_[facet.first]].corners;
        const auto least = std::min_element(corners, corners + 3) - corners;
        out_.faces.push_back({facet.normal, std::uint32_t(out_.loops.size()), 3});
        for (std::ptrdiff_t k = least; k < least + 3; ++k) {
            ++faces_at_[corners[k % 3]];
            out_.loops.push_back(corners[k % 3]);
        }
    }

    void make_face(std::uint32_t seed) {
        bool is_good = false;
        double tolerance = plane_tolerance_;
        for (int attempt = 0; attempt < 4 && tolerance > 0 && !is_good; ++attempt, tolerance *= 0.25) {
            grow(seed, tolerance);
            if (region_.size() == 1) break;
            is_good = trace();
            if (!is_good) continue;
            flatten();
            is_good = is_convex(tolerance);
        }
        if (!is_good) {
            ++mark_;
            region_.assign(1, seed);
            facets_[seed].mark = mark_;
            trace();
            flatten();
        }
        for (const std::uint32_t index : region_) facets_[index].is_taken = true;
        for (const std::uint32_t p : loop_) ++faces_at_[p];
        out_.faces.push_back({normal_, std::uint32_t(out_.loops.size()), std::uint32_t(loop_.size())});
        out_.loops.insert(out_.loops.end(), loop_.begin(), loop_.end());
        note_blunt_corners();
    }

    // Records corners that protrude too little or are reflex.
    void note_blunt_corners() {
        const std::size_t count = flat_.size();
        for (std::size_t i = 0; i < count; ++i) {
            const std::size_t before = (i + count - 1) % count, after = (i + 1) % count;
            const double beyond = beyond_segment(flat_[i], flat_[before], flat_[after]);
            if (corner_tolerance_ > 0 && beyond <= corner_tolerance_)
                blunt_.push_back({loop_[i], loop_[before], loop_[after]});
            else if (beyond <= plane_tolerance_)
                hardly_blunt_.push_back({loop_[i], loop_[before], loop_[after]});
        }
    }

    void drop(std::span<const Corner> corners) {
        for (const Corner& corner : corners) {
            if (is_kept_[corner.at] || is_redundant_[corner.before] || is_redundant_[corner.after]) continue;
            is_redundant_[corner.at] = true;
            is_kept_[corner.before] = is_kept_[corner.after] = true;
        }
    }

    // A blunt point is removed only if the two neighbors whose segment it lies on are kept: then the hull shrinks by no
    // more than the point protrudes. Points in the interior of faces are always removed. A point between two faces is
    // removed if it is nearly collinear with their common edge; it may not be if they meet at a sharp edge, and then
    // the faces are unusable.
    void find_redundant() {
        for (std::uint32_t p = 0; p < points_.size(); ++p) is_redundant_[p] = faces_at_[p] == 0;
        drop(blunt_);
        std::erase_if(hardly_blunt_, [&](const Corner& corner) { return faces_at_[corner.at] != 2; });
        drop(hardly_blunt_);
        bool is_any = false;
        for (const bool is : is_redundant_) is_any = is_any || is;
        for (std::uint32_t p = 0; p < points_.size() && !is_any && out_.is_sound; ++p)
            out_.is_sound = faces_at_[p] >= 3;
    }

    std::span<const GridPoint> points_;
    std::span<const Triangle> triangles_;
    double plane_tolerance_, corner_tolerance_;
    std::vector<Facet> facets_;
    std::vector<std::uint32_t> facet_of_, by_facet_; // facet of each triangle; triangles ordered by facet
    std::uint32_t mark_ = 1;
    std::vector<std::uint32_t> region_, loop_, touched_, chain_, ring_;
    std::vector<std::uint32_t> after_; // per point of the outline: the next one
    std::vector<Point2> flat_;         // the outline, projected into the plane of the face
    DVec3 normal_;
    std::vector<std::uint32_t> faces_at_; // per point: the number of faces that meet there
    std::vector<Corner> blunt_, hardly_blunt_;
    std::vector<bool> is_kept_, is_redundant_;
    Faces out_;
};

} // namespace

Faces make_faces(std::span<const GridPoint> points, std::span<const Triangle> triangles, double plane_tolerance,
                 double corner_tolerance) {
    return FaceMaker(points, triangles, plane_tolerance, corner_tolerance).run();
}

} // namespace cairn::hull
