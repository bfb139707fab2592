// The cores of shapes at successive times on their paths, and the distances of two of them. For core_sweep.cpp.
#pragma once

#include "collision/sweep_search.h"
#include "shapes/convex_query.h"

#include <optional>

namespace cairn::sweep {

using math::DMat3;

// The frame of a shape.
struct Frame {
    DVec3 origin;
    DMat3 axes;
    DVec3 to_world(DVec3 p) const { return origin + axes * p; }
    DVec3 to_local(DVec3 p) const {
        const DVec3 d = p - origin;
        return {dot(axes.c0, d), dot(axes.c1, d), dot(axes.c2, d)};
    }
};
inline Frame frame_at(const MovingShape& m, double time) {
    const RigidPath::Pose pose = m.body_at(time);
    return {m.origin_at(pose), math::to_matrix(m.rotation_at(pose))};
}

// The core of a shape at successive times: it is made once, and then only placed.
class SweptCore {
  public:
    // The cores at the ends of the span are kept, as they are requested often. Infinitely long strips are replaced by
    // the part within `reach` of the point `near`.
    SweptCore(const MovingShape& m, Span span, DVec3 near = {}, double reach = 0)
        : m_(m), near_(near), reach_(reach), begin_{span.begin, made({}, {0, 0, 0, 1})}, end_{span.end},
          local_center_(begin_.core.center), scale_{begin_.core.axes.c0.x, begin_.core.axes.c1.y,
                                                    begin_.core.axes.c2.z} {
        place(begin_);
    }
    const Convex& at(double time) {
        now_ = time == begin_.time ? &begin_ : time == end_.time ? &end_ : &between_;
        if (now_->is_placed && now_->time == time) return now_->core;
        now_->time = time;
        now_->core = begin_.core;
        place(*now_);
        return now_->core;
    }
    const Frame& frame() const { return now_->frame; } // at the time of the last call

  private:
    struct Placed {
        double time = 0;
        Convex core{};
        Frame frame{};
        bool is_placed = false;
    };
    Convex made(DVec3 center, DQuat rotation) const {
        const Geometry part = near_part(m_.shape().geometry, center, rotation, near_, reach_);
        Convex core = make_convex(part, m_.shape().data, center, rotation);
        if (m_.layer < Layer::skin) shrink(core, depth_of(core, m_.layer, m_.half_width));
        return core;
    }
    // Places a copy of the core at the shape's pose at p.time.
    void place(Placed& p) const {
        p.is_placed = true;
        if (m_.is_point()) { // a ball that no rotation moves
            p.core.center = p.frame.origin = m_.center_at(p.time);
            return;
        }
        p.frame = frame_at(m_, p.time);
        if (p.core.kind == Convex::Kind::polygon) {
            const RigidPath::Pose pose = m_.body_at(p.time);
            p.core = made(m_.origin_at(pose), m_.rotation_at(pose));
            return;
        }
        p.core.center = p.frame.to_world(local_center_);
        p.core.axes = {scale_.x * p.frame.axes.c0, scale_.y * p.frame.axes.c1, scale_.z * p.frame.axes.c2};
    }

    const MovingShape& m_;
    const DVec3 near_;
    const double reach_;
    Placed begin_, end_, between_;
    const DVec3 local_center_, scale_; // in the shape's frame
    Placed* now_ = &begin_;
};

// The gap between a ball and a shape with a closed formula: of all kinds except hulls and polygons.
inline std::optional<Gap> gap_of_ball(const Convex& ball, const Convex& other) {
    if (ball.kind != Convex::Kind::ball) return std::nullopt;
    const DVec3 local = to_local(other, ball.center - other.center);
    const std::optional<DVec3> nearest = nearest_in_core(other, local);
    if (!nearest) return std::nullopt;
    const DVec3 to_nearest = other.axes * (*nearest - local);
    const double distance = length(to_nearest);
    if (!(distance > 0)) return Gap{-1, {}, {}};
    const double radius = exact_core(ball).radius;
    const DVec3 normal = (1 / distance) * to_nearest;
    return Gap{distance - (radius + exact_core(other).radius), normal, ball.center + radius * normal};
}

// The same gap with the shapes exchanged.
inline Gap seen_from_other(const Gap& gap) { return {gap.distance, -gap.normal, gap.on_a + gap.distance * gap.normal}; }

// Distances of two shapes at successive times: each GJK starts with the vertices of the last simplex, which are points
// of the shapes at any pose.
class GapFinder {
  public:
    // `axis`: the initial direction from one shape to the other; updated by each call.
    explicit GapFinder(DVec3& axis) : axis_(axis) {}
    Gap gap_of(SweptCore& a, SweptCore& b, double time) {
        const Convex &first = a.at(time), &second = b.at(time);
        return gap_of(first, a.frame(), second, b.frame());
    }
    Gap gap_of(const Convex& a, const Frame& frame_a, const Convex& b, const Frame& frame_b) {
        const Gap gap = find(a, frame_a, b, frame_b);
        if (gap.distance >= 0) axis_ = gap.normal;
        return gap;
    }

  private:
    Gap find(const Convex& a, const Frame& frame_a, const Convex& b, const Frame& frame_b) {
        if (const std::optional<Gap> gap = gap_of_ball(a, b)) return *gap;
        if (const std::optional<Gap> gap = gap_of_ball(b, a)) return seen_from_other(*gap);
        const Core core_a = exact_core(a), core_b = exact_core(b);
        const CorePair pair{core_a, core_b};
        Simplex start;
        for (int i = 0; i < count_; ++i) {
            const DVec3 p = frame_a.to_world(on_a_[i]), q = frame_b.to_world(on_b_[i]);
            start.points[i] = {p, q, p - q};
        }
        start.count = count_;
        const GjkResult r = count_ > 0 ? gjk_distance_from(pair, start, infinity, tolerance)
                                       : gjk_distance(pair, axis_, infinity, tolerance);
        if (r.state != GjkResult::State::apart) return {-1, {}, {}};
        count_ = std::min(r.simplex.count, 3);
        for (int i = 0; i < count_; ++i) {
            on_a_[i] = frame_a.to_local(r.simplex.points[i].a);
            on_b_[i] = frame_b.to_local(r.simplex.points[i].b);
        }
        return {r.distance - (core_a.radius + core_b.radius), r.normal, r.on_a + core_a.radius * r.normal};
    }

    static constexpr double tolerance = 1e-6;
    DVec3& axis_;
    int count_ = 0;
    DVec3 on_a_[3], on_b_[3]; // in the shapes' frames
};

} // namespace cairn::sweep
