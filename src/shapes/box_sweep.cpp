#include "shapes/box_sweep.h"

#include <cmath>
#include <limits>

namespace cairn {

using math::dot;
using math::DVec3;

namespace {

// The squared sine of the angle between two edges: below the first they are parallel, and their axis adds nothing to
// those of the faces; between both, rounding is too much of it.
constexpr double parallel = 1e-28, nearly_parallel = 1e-10;

constexpr int axis_count = 15;
constexpr int none = -1; // of the edges
constexpr int after(int i) { return i == 2 ? 0 : i + 1; }

// What the boxes' shadows on an axis are, all times the length of the axis.
struct Shadows {
    double apart;  // of the middles, from the moving to the still one
    double speed;  // of the moving one, in a whole way
    double radii;  // half of both shadows
    double length; // of the axis; 0: it says nothing
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
        if (last_ >= 0 && meet_face(last_, r)) { // then nothing parts them any longer
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
    // The axis across an edge of each.
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
    // Whether the shadows on an axis do not come together in time; else the fraction at which the last ones do so far.
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
    // Of boxes that nothing parts at the start.
    BoxSweep overlap() const {
        BoxSweep r;
        if (is_vague_ || shallowest_ > -tolerance_) return r;
        r.state = BoxSweep::State::overlapping;
        if (!meet(shallowest_axis_, r)) r.normal = {};
        return r;
    }
    DVec3 axis(int k) const { // of two edges
        const int pair = k - 6;
        return (1 / shadows_[k].length) * math::cross(a_.axes.column(pair / 3), b_.axes.column(pair % 3));
    }
    // The corner of a box that lies farthest along a direction, or the middle of such an edge along axis `edge`. False
    // where others lie as far.
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
    // Whether a corner of one box meets a face of the other at the fraction, within it, and where.
    bool meet_face(int k, BoxSweep& r) const {
        DVec3 local; // in the frame of the face
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
    // `local`: where in the plane of the face, in the frame of its box.
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
    // Where they meet along an axis at the fraction, or are deepest within each other. False where it is not one point.
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
    double cosine_[3][3]; // of the angles between an edge of a and one of b
    Shadows shadows_[axis_count];
    bool is_vague_ = false; // edges are nearly parallel
    int last_ = -1;         // the axis that parts them until `fraction_`
    double fraction_ = 0;
    double shallowest_ = -std::numeric_limits<double>::infinity(); // of the axes that do not part them, m
    int shallowest_axis_ = 0;
};

} // namespace

BoxSweep sweep_boxes(const Convex& moving, DVec3 way, const Convex& still, double limit, double tolerance) {
    return BoxPair(moving, way, still, tolerance).sweep(limit);
}

} // namespace cairn
