#include "shapes/box_sweep.h"

#include <cmath>
#include <limits>

namespace cairn {

using math::dot;
using math::DVec3;

namespace {

// The squared sine of the angle between two edges. Below the first they are parallel, and their cross product adds no
// axis to those of the faces; between both values the axis suffers too much from rounding.
constexpr double parallel = 1e-28, nearly_parallel = 1e-10;

constexpr int axis_count = 15;
constexpr int none = -1; // no edge
constexpr int after(int i) { return i == 2 ? 0 : i + 1; }

// Projections of both boxes on an axis, all scaled by the length of the axis.
struct Shadows {
    double apart;  // from the center of the moving box to that of the still one
    double speed;  // of the moving box, per whole translation
    double radii;  // sum of the half extents of both projections
    double length; // of the axis; 0: not a usable axis
};

class BoxPair {
  public:
    BoxPair(const Convex& a, DVec3 way, const Convex& b, double tolerance)
        : a_(a), b_(b), way_(way), tolerance_(tolerance) {
        const DVec3 between = b.center - a.center;
#pragma GCC unroll 3
        for (int i = 0; i < 3; ++i) {
            const DVec3 u = a.axes.column(i), v = b.axes.column(i);
#pragma GCC unroll 3
            for (int j = 0; j < 3; ++j) cosine_[i][j] = dot(u, b.axes.column(j));
            shadows_[i] = {dot(u, between), dot(u, way), a.size[i], 1};
            shadows_[3 + i] = {dot(v, between), dot(v, way), b.size[i], 1};
        }
#pragma GCC unroll 3
        for (int i = 0; i < 3; ++i)
#pragma GCC unroll 3
            for (int j = 0; j < 3; ++j) {
                shadows_[i].radii += b.size[j] * std::fabs(cosine_[i][j]);
                shadows_[3 + j].radii += a.size[i] * std::fabs(cosine_[i][j]);
            }
    }

    BoxSweep sweep(double limit) {
        BoxSweep missed;
        missed.state = BoxSweep::State::missed;
        for (int k = 0; k < 6; ++k)
            if (misses(k, limit)) return missed;
        BoxSweep r;
        r.fraction = fraction_;
        if (last_ >= 0 && meet_face(last_, r)) { // then no other axis separates them
            r.state = BoxSweep::State::met;
            return r;
        }
#pragma GCC unroll 3
        for (int i = 0; i < 3; ++i)
#pragma GCC unroll 3
            for (int j = 0; j < 3; ++j) {
                cross(i, j);
                if (misses(6 + 3 * i + j, limit)) return missed;
            }
        if (last_ < 0) return overlap();
        for (const Shadows& s : shadows_)
            if (std::fabs(s.apart - fraction_ * s.speed) > s.radii + tolerance_ * s.length) return missed;
        if (fraction_ > limit) return missed;
        r.fraction = fraction_;
        if (!is_vague_ && meet(last_, r)) r.state = BoxSweep::State::met;
        return r;
    }

  private:
    // The cross product of an edge of each box.
    void cross(int i, int j) {
        const int k = after(i), l = after(k), m = after(j), n = after(m);
        const double square = cosine_[k][j] * cosine_[k][j] + cosine_[l][j] * cosine_[l][j];
        Shadows& s = shadows_[6 + 3 * i + j];
        if (square < nearly_parallel) {
            is_vague_ = is_vague_ || square > parallel;
            s = {0, 0, 0, 0};
            return;
        }
        s.length = std::sqrt(square);
        s.apart = cosine_[k][j] * shadows_[l].apart - cosine_[l][j] * shadows_[k].apart;
        s.speed = cosine_[k][j] * shadows_[l].speed - cosine_[l][j] * shadows_[k].speed;
        s.radii = a_.size[k] * std::fabs(cosine_[l][j]) + a_.size[l] * std::fabs(cosine_[k][j]) +
                  b_.size[m] * std::fabs(cosine_[i][n]) + b_.size[n] * std::fabs(cosine_[i][m]);
    }
    // Whether the projections on axis k do not begin to overlap by `limit`. Otherwise updates the latest fraction at
    // which the projections on an axis begin to overlap, or the axis of least overlap at the start.
    bool misses(int k, double limit) {
        const Shadows& s = shadows_[k];
        const double gap = 0.5 * tolerance_ * s.length, off = std::fabs(s.apart) - s.radii;
        if (!(off > gap)) {
            if (s.length > 0 && off > shallowest_ * s.length) shallowest_ = off / s.length, shallowest_axis_ = k;
            return false;
        }
        const double toward = s.apart > 0 ? s.speed : -s.speed;
        if (!(toward * limit >= off - gap)) return true;
        if (last_ < 0 || off - gap > toward * fraction_) fraction_ = (off - gap) / toward, last_ = k;
        return false;
    }
    // The result for boxes that no axis separates at the start.
    BoxSweep overlap() const {
        BoxSweep r;
        if (is_vague_ || shallowest_ > -tolerance_) return r;
        r.state = BoxSweep::State::overlapping;
        if (!meet(shallowest_axis_, r)) r.normal = {};
        return r;
    }
    DVec3 axis(int k) const { // the cross product of two edges, normalized
        const int pair = k - 6;
        return (1 / shadows_[k].length) * math::cross(a_.axes.column(pair / 3), b_.axes.column(pair % 3));
    }
    // The corner of a box that is farthest along a direction, or, given an axis `edge`, the middle of the farthest edge
    // along this axis. Returns false if it is not unique.
    bool farthest(const Convex& box, DVec3 d, int edge, DVec3& p) const {
        p = box.center;
#pragma GCC unroll 3
        for (int i = 0; i < 3; ++i) {
            if (i == edge) continue;
            const double along = dot(box.axes.column(i), d);
            if (!(std::fabs(along) * box.size[i] > tolerance_)) return false;
            p += (along < 0 ? -box.size[i] : box.size[i]) * box.axes.column(i);
        }
        return true;
    }
    // Whether a corner of one box touches the interior of a face of the other at the fraction, and where.
    bool meet_face(int k, BoxSweep& r) const {
        DVec3 local; // in the frame of the box of the face
        if (k < 3) {
            if (!meet_own_face(k, r)) return false;
            local = to_local(a_, r.point - r.fraction * way_ - a_.center);
        } else if (!meet_other_face(k, r, local)) {
            return false;
        }
        const DVec3 size = k < 3 ? a_.size : b_.size;
        for (int j = 0; j < 3; ++j)
            if (j != k % 3 && !(std::fabs(local[j]) <= size[j])) return false;
        return true;
    }
    bool meet_own_face(int k, BoxSweep& r) const {
        r.normal = shadows_[k].apart > 0 ? -a_.axes.column(k) : a_.axes.column(k);
        return farthest(b_, r.normal, none, r.point);
    }
    // `local`: the corner in the frame of the box of the face.
    bool meet_other_face(int k, BoxSweep& r, DVec3& local) const {
        const int face = k - 3;
        const double side = shadows_[k].apart > 0 ? -1 : 1;
        r.normal = side * b_.axes.column(face);
        DVec3 corner;
        if (!farthest(a_, -r.normal, none, corner)) return false;
        local = to_local(b_, corner + r.fraction * way_ - b_.center);
        DVec3 on_face;
        for (int j = 0; j < 3; ++j) on_face[j] = j == face ? side * b_.size[j] : within(local[j], b_.size[j]);
        r.point = b_.center + b_.axes * on_face;
        return true;
    }
    // The point and normal at which the boxes touch along axis k at the fraction, or overlap most. False if not unique.
    bool meet(int k, BoxSweep& r) const {
        DVec3 local;
        if (k < 3) return meet_own_face(k, r);
        if (k < 6) return meet_other_face(k, r, local);
        const Shadows& s = shadows_[k];
        const DVec3 at = r.fraction * way_;
        r.normal = s.apart > 0 ? -axis(k) : axis(k);
        const int i = (k - 6) / 3, j = (k - 6) % 3;
        DVec3 on_a, on_b;
        if (!farthest(a_, -r.normal, i, on_a) || !farthest(b_, r.normal, j, on_b)) return false;
        const DVec3 apart = on_b - on_a - at, u = a_.axes.column(i), v = b_.axes.column(j);
        const double along = (cosine_[i][j] * dot(u, apart) - dot(v, apart)) / (s.length * s.length);
        r.point = on_b + within(along, b_.size[j]) * v;
        return true;
    }
    static double within(double x, double most) { return x < -most ? -most : x > most ? most : x; }

    const Convex &a_, &b_;
    DVec3 way_;
    double tolerance_;
    double cosine_[3][3]; // cosines of the angles between edges of a and b
    Shadows shadows_[axis_count];
    bool is_vague_ = false; // whether edges are nearly parallel
    int last_ = -1;         // the axis that separates the boxes until `fraction_`
    double fraction_ = 0;
    // separation (negative) on the axis of least overlap, m
    double shallowest_ = -std::numeric_limits<double>::infinity();
    int shallowest_axis_ = 0;
};

} // namespace

BoxSweep sweep_boxes(const Convex& moving, DVec3 way, const Convex& still, double limit, double tolerance) {
    return BoxPair(moving, way, still, tolerance).sweep(limit);
}

} // namespace cairn
