#include "collision/contact_points.h"

#include "collision/flat_points.h"

#include <algorithm>
#include <limits>

namespace cairn {

using math::dot;
using math::DVec3;

namespace {

// As in kernels/face_clip.h: candidates that tie within this factor are taken in their order, so that rounding does not
// change the choice from step to step; a third or fourth point must be farther than `thinnest` beside the others.
constexpr double tie = 1 + 2e-4, thinnest = 1e-3;

// Chooses at most four points: the deepest; the one farthest from it; on each side of the line through both, the one
// that spans the largest triangle; if one side is empty, the point farthest outside the triangle of the other three.
// All measures are weighted by how near the surfaces are: a box on three peaks of a mesh must not lose one of them to
// points that are farther out and do not touch, or it would rock to and fro. But all overlapping points have equal
// weight: if a cylinder is pressed in on one side, its points must not all be there, as nothing would then support the
// other side. Between planes the weights change nothing: a point twice as far out is at most twice as far apart.
class Reducer {
  public:
    Reducer(std::span<FlatPoint> points, double extent) : points_(points), extent_(extent) {
        for (const FlatPoint& p : points) lowest_ = std::min(lowest_, p.separation);
        const double alike = std::max(flat_contact_part * extent, -lowest_);
        for (FlatPoint& p : points) p.nearness = p.separation - lowest_ > alike ? alike / (p.separation - lowest_) : 1;
    }

    Chosen choose() {
        Chosen r;
        if (!deepest(r)) return r;
        const double nearest = same_point_part * extent_;
        double farthest = nearest * nearest;
        const FlatPoint a = at(r, 0);
        if (!best(r, farthest, [=](const FlatPoint& p) { return square(p, a); })) return r;
        const FlatPoint b = at(r, 1);
        const double least = std::max(thinnest * farthest, nearest * std::sqrt(farthest));
        bool has_left = false, has_right = false;
        best_on_sides(r, least, a, b, has_left, has_right);
        if (has_left == has_right) return r;
        // One side is empty: search beyond the edges from the third point to each of the others.
        const FlatPoint c = at(r, 2);
        const double sign = has_left ? 1 : -1;
        double area = least;
        best(r, area, [=](const FlatPoint& p) { return std::max(-sign * cross(b, c, p), -sign * cross(c, a, p)); });
        return r;
    }

  private:
    static double square(const FlatPoint& p, const FlatPoint& q) {
        return (p.x - q.x) * (p.x - q.x) + (p.y - q.y) * (p.y - q.y);
    }
    static double cross(const FlatPoint& a, const FlatPoint& b, const FlatPoint& p) {
        return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
    }
    const FlatPoint& at(const Chosen& r, int i) const { return points_[r.index[i]]; }

    bool deepest(Chosen& r) const {
        double outermost = -1;
        const FlatPoint* p = points_.data();
        const std::size_t n = points_.size();
        for (std::size_t i = 0; i < n; ++i) {
            if (!(p[i].separation <= lowest_ + flat_contact_part * extent_)) continue;
            const double d = p[i].x * p[i].x + p[i].y * p[i].y;
            if (d > outermost * tie) outermost = d, r.index[0] = i, r.count = 1;
        }
        return r.count == 1;
    }
    // Adds the point with the largest weighted measure among those whose measure exceeds `least`, which becomes its
    // measure.
    template <class Measure> bool best(Chosen& r, double& least, Measure measure) const {
        const FlatPoint* p = points_.data();
        const std::size_t n = points_.size();
        const double bar = least * tie;
        double most = 0;
        bool is_found = false;
        for (std::size_t i = 0; i < n; ++i) {
            const double value = measure(p[i]), weighed = p[i].nearness * value;
            if (value > bar && weighed > most * tie)
                most = weighed, least = value, r.index[r.count] = i, is_found = true;
        }
        r.count += is_found ? 1 : 0;
        return is_found;
    }

    // The same search on both sides of the line from a to b in one pass.
    void best_on_sides(Chosen& r, double least, const FlatPoint& a, const FlatPoint& b, bool& has_left,
                       bool& has_right) const {
        const FlatPoint* p = points_.data();
        const std::size_t n = points_.size();
        const double bar = least * tie;
        double left = 0, right = 0;
        std::size_t at_left = n, at_right = n;
        for (std::size_t i = 0; i < n; ++i) {
            const double value = cross(a, b, p[i]), size = std::fabs(value);
            if (!(size > bar)) continue;
            const double weighed = p[i].nearness * size;
            double& most = value > 0 ? left : right;
            if (weighed > most * tie) most = weighed, (value > 0 ? at_left : at_right) = i;
        }
        has_left = at_left < n, has_right = at_right < n;
        if (has_left) r.index[r.count++] = at_left;
        if (has_right) r.index[r.count++] = at_right;
    }

    std::span<FlatPoint> points_;
    double extent_, lowest_ = std::numeric_limits<double>::infinity();
};

} // namespace

FlatFrame::FlatFrame(const DVec3& normal, const DVec3& middle) : center(middle) {
    // Any frame in the plane suffices: only distances and areas matter.
    const DVec3 axis = std::fabs(normal.x) < 0.5 ? DVec3{1, 0, 0} : DVec3{0, 1, 0};
    e1 = math::normalized(math::cross(axis, normal)), e2 = math::cross(normal, e1);
}

Chosen choose_points(std::span<FlatPoint> points, double extent) {
    if (points.size() > 1) return Reducer(points, extent).choose();
    return {static_cast<int>(points.size()), {}};
}

void clear_manifold(Manifold& out) {
    out = {};
    for (auto& p : out.points) p[3] = 1e30f;
}

void write_manifold(const ContactPoints& points, const DVec3& normal, const DVec3& center, double extent, double margin,
                    double least, Manifold& out) {
    clear_manifold(out);
    const ContactPoint* const list = points.list.data();
    const std::size_t n = points.list.size();
    Buffer<FlatPoint, 32> flat;
    Buffer<std::size_t, 32> which; // indices of the points within the margin
    DVec3 middle;
    if (n > 1) {
        const ContactFrame& f = points.frame;
        DVec3 d = center - f.origin;
        if (f.leans) { // project to the plane along the normal
            const DVec3 across = math::cross(f.e1, f.e2);
            d -= (dot(d, across) / dot(f.normal, across)) * f.normal;
        }
        middle = {dot(d, f.e1), dot(d, f.e2), 0};
    }
    for (std::size_t i = 0; i < n; ++i)
        if (list[i].separation <= margin) {
            flat.add({list[i].x - middle.x, list[i].y - middle.y, list[i].separation, 1});
            which.add(i);
        }
    const Chosen chosen = choose_points({flat.data(), flat.size()}, extent);
    if (chosen.count == 0) return;
    out.count = chosen.count;
    math::put(out.normal, math::to_float(normal));
    for (int i = 0; i < chosen.count; ++i) {
        const ContactPoint& p = list[which[chosen.index[i]]];
        math::put(out.points[i], math::to_float(points.position(p)));
        out.points[i][3] = static_cast<float>(p.separation < least ? least : p.separation);
        out.features[i] = p.feature;
    }
}

} // namespace cairn
