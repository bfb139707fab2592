// How two shapes approach each other on their paths: evaluates their distance at successive times until it is known
// whether and when they meet. For core_sweep.cpp, which defines the kinds of pairs.
#pragma once

#include "collision/core_sweep.h"

#include "shapes/convex.h"
#include "shapes/gjk.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cairn::sweep {

using math::dot;
using math::DQuat;
using math::DVec3;
using math::length;

inline constexpr double known_depth_part = 0.5; // of the half width: for contacts that the solver knows
// Share of the depth: cores count as touching when they are this near.
inline constexpr double tolerance_part = 0.1;
// The greatest number of evaluations for a pair that rotates fast and hardly approaches; then the time reached is the
// answer.
inline constexpr int max_rounds = 100;

// The part of the shapes that is swept: cores; inner cores, which are twice as deep; the cores of contacts that the
// solver knows (known_core; `deep`: to detect how shapes that are deeper than the other layers sink); or the shapes
// themselves (skin, impact).
enum class Layer { core, inner, deep, known_core, skin, impact };

// `half_width`: the smaller of the pair's smallest half widths.
inline double depth_of(const Convex& c, Layer layer, double half_width) {
    if (c.kind == Convex::Kind::polygon || layer >= Layer::skin) return 0;
    if (layer == Layer::inner) return std::min(2 * core_depth_of(c.extent), c.extent);
    return layer >= Layer::deep ? known_depth_part * std::min(c.extent, half_width) : core_depth_of(c.extent);
}
// The tolerance follows the narrower of the two shapes, however wide the moving one is.
inline double tolerance_of(const Convex& c, Layer layer, double half_width) {
    const double half = std::min(c.extent, half_width);
    switch (layer) {
    case Layer::core:
        return tolerance_part * core_depth_of(half);
    case Layer::inner:
    case Layer::deep:
        return sinking_part * core_depth_of(half);
    case Layer::known_core:
        return tolerance_part * known_depth_part * half;
    case Layer::skin:
        return touch_tolerance(half);
    case Layer::impact:
        break;
    }
    return impact_tolerance(half);
}

// A shape that moves along its path, and bounds of its motion.
class MovingShape {
  public:
    MovingShape(const SweptShape& s, Layer layer, double half_width, double from, double to)
        : layer(layer), half_width(half_width), s_(s), from_(from), to_(to),
          first_(from > s.path.begin || s.until < 1 ? pose_at(from) : s.path.first()),
          last_(s.until < 1 || to < s.path.until ? pose_at(to) : s.path.end()), turn_(length(s.path.turn)) {
        const double ball = is_ball() ? 0 : s.geometry.bounding_radius;
        const DVec3 to_middle = middle_offset();
        reach_ = length(to_middle) + ball;
        start = first_.x, end = last_.x;
        if (to_middle == DVec3{}) return; // no rotation moves it
        start += math::rotate(first_.q, to_middle);
        end += math::rotate(last_.q, to_middle);
    }
    bool is_ball() const { return s_.geometry.type == ShapeType::sphere; }
    double bounding_radius() const { return s_.geometry.bounding_radius; }
    double until() const { return s_.until; }
    const SweptShape& shape() const { return s_; }
    RigidPath::Pose body_at(double time) const { return time == from_ ? first_ : time == to_ ? last_ : pose_at(time); }
    // A ball about the center of mass, which no rotation moves, and its center.
    bool is_point() const { return is_ball() && reach_ == 0; }
    DVec3 center_at(double time) const { return s_.path.start + std::min(time, s_.until) * s_.path.translation; }
    DQuat first_rotation() const { return rotation_at(first_); }
    DQuat rotation_at(const RigidPath::Pose& pose) const {
        return s_.geometry.is_turned ? pose.q * own_rotation() : pose.q;
    }
    DVec3 origin_at(const RigidPath::Pose& pose) const { return pose.x + math::rotate(pose.q, s_.offset); }
    DVec3 middle_at(double time) const {
        const RigidPath::Pose pose = body_at(time);
        return pose.x + math::rotate(pose.q, middle_offset());
    }
    // The greatest speed of any point along a direction of constant orientation.
    double speed_along(DVec3 n, double time) const {
        if (time >= s_.until) return 0;
        return dot(n, s_.path.translation) + length(math::cross(n, s_.path.turn)) * reach_;
    }
    // The greatest speed of any point.
    double speed() const { return length(s_.path.translation) + turn_ * reach_; }
    // The velocity of a material point.
    DVec3 velocity_of(DVec3 point, double time) const {
        if (time >= s_.until) return {};
        return s_.path.translation + math::cross(s_.path.turn, point - (s_.path.start + time * s_.path.translation));
    }
    // In a frame that rotates with this shape about its center of mass: the greatest distance of a point of another
    // shape from the straight line between two of its positions. As RigidPath::sagitta, plus the apparent accelerations
    // of a rotating frame, 2 w x d' and w x (w x d), where d is the vector from the center of mass.
    double sagitta_of(const MovingShape& other) const {
        const double displacement = length(other.s_.path.translation - s_.path.translation);
        const double distance = length(other.s_.path.start - s_.path.start) + displacement + other.reach_;
        const double speed = displacement + other.turn_ * other.reach_;
        return other.sagitta() + s_.path.sagitta(distance) + 0.25 * turn_ * speed;
    }
    // A direction that is fixed in the shape, at another time.
    DVec3 turned(DVec3 n, double from, double to) const {
        return math::rotate(body_at(to).q, math::rotate(math::conjugate(body_at(from).q), n));
    }
    // The greatest distance of the shape's middle from the straight line between two of its positions.
    double sagitta() const { return s_.path.sagitta(reach_); }
    bool is_still() const { return speed() == 0; }
    // The greatest distance of the shape's points from where they would be if all moved at one constant velocity.
    double beside_straight() const { return s_.until >= 1 ? turn_ * reach_ : std::numeric_limits<double>::infinity(); }
    // The greatest displacement of the shape's points about its middle by rotation.
    double turning() const { return is_ball() ? 0 : turn_ * s_.geometry.bounding_radius; }
    // Offsets from the center of mass, in the body's frame: of the middle of the shape's bounds, and of a point deep
    // inside.
    DVec3 middle_offset() const { return s_.offset + in_body(math::to_double(s_.geometry.middle)); }
    DVec3 inside_offset() const {
        return s_.geometry.type == ShapeType::hull ? s_.offset + in_body(hull_of(s_.data).inside) : middle_offset();
    }
    const Layer layer;
    const double half_width; // the smaller of the pair, m
    math::DVec3 start, end;  // of the middle of the shape's bounds, at the first and last time

  private:
    // Normalized in double: a float quaternion is unit only to 1e-7, which would scale a planet of 1 km by a tenth of a
    // millimeter.
    DQuat own_rotation() const { return math::normalized(math::to_double(s_.geometry.rotation)); }
    RigidPath::Pose pose_at(double time) const { return s_.path.at(std::min(time, s_.until)); }
    DVec3 in_body(DVec3 local) const { return s_.geometry.is_turned ? math::rotate(own_rotation(), local) : local; }
    const SweptShape& s_;
    const double from_, to_;
    const RigidPath::Pose first_, last_; // at from_ and to_
    const double turn_;
    double reach_;
};

inline constexpr double overlapped = -1; // meeting time of shapes that overlap from the start

struct Gap {
    double distance;
    DVec3 normal; // from a to b
    DVec3 on_a;   // the nearest point of a
};

// The range of times that is searched.
struct Span {
    double begin, end;
};

// The time until which the bound of the approach speed remains the same: a body may stop before the end.
inline double next_stop(const MovingShape& a, const MovingShape& b, double time, double end) {
    for (const double until : {a.until(), b.until()})
        if (time < until) end = std::min(end, until);
    return end;
}

inline constexpr double infinity = std::numeric_limits<double>::infinity();

// The result of a search: how two shapes approach each other.
struct SweepResult {
    double meeting = never;    // a time, or `overlapped`
    double nearest = 0;        // if they do not meet: the time when they are nearest,
    Gap gap{infinity, {}, {}}; // and their distance then
    bool is_certain = false;   // it is proven that they do not meet

    void take(const SweepResult& other) {
        meeting = std::min(meeting, other.meeting);
        if (other.gap.distance < gap.distance) nearest = other.nearest, gap = other.gap;
    }
};
inline constexpr SweepResult surely_apart{never, 0, {infinity, {}, {}}, true};

// Share of the excess: overlapping shapes may sink deeper by this before they are stopped, so that a body that is
// pressed in more and more within a step is stopped some ten times until its center is reached.
inline constexpr double deeper_part = 0.25;

// A query about a pair. `within`: distances up to this matter. `floor_part`: if not 0, the event is not the touch, but
// that inner cores are nearer than this share of the distance that they have when the shapes touch; if they are nearer
// already, it is that they are nearer by the share `deeper` of the deficit (infinite: they count as overlapping).
struct SweepQuery {
    double within = 0, floor_part = 0;
    Separation& known;
    double deeper = deeper_part;
};

// The parameters of a search: it ends when the shapes are as near as `tolerance`; their distance matters up to
// `within`.
struct SearchSettings {
    double tolerance, within = 0;
    bool is_impact = false;   // shapes within the tolerance that separate, or stay, have not met
    double highest_floor = 0; // the share `floor_part` of the distance of inner cores where the shapes touch
    double deeper = deeper_part;

    bool sinks() const { return highest_floor > 0; }
    // The distance of inner cores down to which shapes may sink whose inner cores are now at `distance`.
    double floor_from(double distance) const {
        const double missing = highest_floor - distance;
        return (missing > 0 ? distance - deeper * missing : highest_floor) - 2 * tolerance;
    }
};

inline SearchSettings settings_of(const Convex& c, const MovingShape& m, const SweepQuery& asked,
                                  double depth_of_other) {
    return {tolerance_of(c, m.layer, m.half_width), asked.within, m.layer == Layer::impact,
            asked.floor_part * (depth_of(c, m.layer, m.half_width) + depth_of_other), asked.deeper};
}

// The approach speed of the nearest points along the normal, and their relative speed, m/s.
struct Closing {
    double along, speed;
};
inline Closing closing_of(const MovingShape& a, const MovingShape& b, const Gap& gap, double time) {
    const DVec3 v = a.velocity_of(gap.on_a, time) - b.velocity_of(gap.on_a + gap.distance * gap.normal, time);
    return {dot(gap.normal, v), length(v)};
}

// The minimum of the distance on two paths, bracketed by the evaluations: between the last one where the shapes
// approach and the first one where they do not, or at an end.
class Bracket {
  public:
    struct Sample {
        double time;
        Gap gap;
        Closing closing;
    };
    void add(const Sample& now) {
        const bool is_turn = has_last_ && last_.closing.along > 0 && !(now.closing.along > 0);
        const bool is_start = !has_last_ && !(now.closing.along > 0);
        if (is_turn || is_start) keep(is_turn ? last_ : now, now);
        last_ = now, has_last_ = true;
    }
    // After the last evaluation: the minimum by the Illinois method (false position), until the approach speed is
    // nearly 0.
    template <class F> SweepResult least(double speed, double within, F&& sample_at) {
        if (last_.closing.along > 0) keep(last_, last_);
        Sample lo = before_, hi = after_;
        const double lower = 0.5 * (lo.gap.distance + hi.gap.distance - speed * (hi.time - lo.time)); // lower bound
        if (lower > within) return {};
        Sample best = lo.gap.distance < hi.gap.distance ? lo : hi;
        double rate_lo = lo.closing.along, rate_hi = hi.closing.along;
        for (int round = 0; round < max_samples && lo.time < hi.time; ++round) {
            const double time = lo.time + (hi.time - lo.time) * (rate_lo / (rate_lo - rate_hi));
            const Sample sample = sample_at(time);
            if (sample.gap.distance < best.gap.distance) best = sample;
            if (std::fabs(sample.closing.along) <= turned_part * sample.closing.speed) {
                best = sample;
                break;
            }
            if (sample.closing.along > 0) {
                lo = sample, rate_lo = sample.closing.along, rate_hi *= 0.5;
            } else {
                hi = sample, rate_hi = sample.closing.along, rate_lo *= 0.5;
            }
        }
        return {never, best.time, best.gap};
    }

  private:
    static constexpr int max_samples = 16;
    static constexpr double turned_part = 0.05; // of the relative speed
    void keep(const Sample& before, const Sample& after) {
        const double distance = std::min(before.gap.distance, after.gap.distance);
        if (!(distance < least_)) return;
        least_ = distance, before_ = before, after_ = after;
    }
    Sample before_{}, after_{}, last_{};
    double least_ = infinity;
    bool has_last_ = false;
};

// Share of the step: how far time advances while the nearest points do not approach.
inline constexpr double longest_leap = 1.0 / 16;

// A time for which the shapes certainly do not close the distance `clearance`.
inline double certain_time(const MovingShape& a, const MovingShape& b, const Gap& gap, double clearance, double time) {
    const double speed = a.speed_along(gap.normal, time) + b.speed_along(-gap.normal, time);
    return speed > 0 ? clearance / speed : never;
}

// Whether two shapes that are `first` apart along a direction when a span begins, and `last` when it ends, m, stay
// separated in between. Every point is within 4 S t (1 - t) of the straight line between its end positions (S: the
// sagitta, t: the share of the span), and the support distance of points on straight lines is never beyond the linear
// interpolation of its end values: so the separation is at least (1 - t) first + t last - 4 S t (1 - t), which is
// positive for all t if this is true.
inline bool stay_apart_between(const MovingShape& a, const MovingShape& b, Span span, double sagitta, double first,
                               double last) {
    if (next_stop(a, b, span.begin, span.end) < span.end) return false; // not one smooth arc
    const double duration = span.end - span.begin;
    return first >= 0 && last > 0 && std::sqrt(first) + std::sqrt(last) > 2 * duration * std::sqrt(sagitta);
}

// By how much less `last` may be.
inline double slack_between(Span span, double sagitta, double first, double last) {
    const double least = std::max(2 * (span.end - span.begin) * std::sqrt(sagitta) - std::sqrt(first), 0.0);
    return std::max(last - least * least, 0.0);
}

// The frame in which a separating direction is constant. Two bodies that rotate together while they touch stay
// separated along a face's normal, but only for a moment along a direction that is fixed in the world.
enum class AxisFrame { world, first, second };

template <class Pair>
inline bool stay_apart_in(AxisFrame frame, const MovingShape& a, const MovingShape& b, Pair& pair, Span span,
                          const Gap& gap, double tolerance) {
    const bool turns = frame != AxisFrame::world;
    const MovingShape &fixed = frame == AxisFrame::second ? b : a, &other = frame == AxisFrame::second ? a : b;
    const DVec3 n = turns ? fixed.turned(gap.normal, span.begin, span.end) : gap.normal;
    const double sagitta = turns ? fixed.sagitta_of(other) : a.sagitta() + b.sagitta();
    const double first = std::max(gap.distance - tolerance, 0.0), last = pair.apart_along(n, span.end) - tolerance;
    return stay_apart_between(a, b, span, sagitta, first, last);
}

// A pair provides `gap_at` (time), the distance of the shapes; `apart_along` (direction from a to b, time), their
// separation along a direction; and `has_axes`, whether the latter is valid for any direction, or only for that of the
// gap.
template <class Pair>
inline bool stay_apart_in_any(const MovingShape& a, const MovingShape& b, Pair& pair, Span span, const Gap& gap,
                              double tolerance) {
    const auto apart_in = [&](AxisFrame frame) { return stay_apart_in(frame, a, b, pair, span, gap, tolerance); };
    return apart_in(AxisFrame::world) ||
           (Pair::has_axes && (apart_in(AxisFrame::first) || apart_in(AxisFrame::second)));
}

template <class Pair>
inline bool stay_apart_from(const MovingShape& a, const MovingShape& b, Pair& pair, double time, const Gap& gap,
                            double end, double tolerance) {
    if (!(gap.distance >= 0)) return false;
    return stay_apart_in(AxisFrame::world, a, b, pair, {time, end}, gap, tolerance);
}

// Conservative advancement from `begin` to `end`: misses nothing.
inline constexpr double span_change = 0.25; // factor by which an unproven span is shortened, and then lengthened again
template <class Pair>
inline double advance(const MovingShape& a, const MovingShape& b, double tolerance, double begin, double end,
                      Pair& pair) {
    double time = begin;
    Gap gap = pair.gap_at(time);
    if (!(gap.distance > 0)) return overlapped;
    tolerance = std::min(tolerance, 0.5 * gap.distance); // shapes stopped at the tolerance can then separate
    double span = end - begin;                           // the span tried next
    for (int round = 0; round < max_rounds; ++round) {
        if (!(gap.distance > tolerance)) return time;
        if (stay_apart_from(a, b, pair, time, gap, end, tolerance)) return never;
        const double stop = next_stop(a, b, time, end); // until then the speed bound is constant
        double next = time + certain_time(a, b, gap, gap.distance - 0.5 * tolerance, time);
        // Shapes that separate, or hardly move, stay apart for much longer than the speed bound shows.
        span = std::min(span, span_change * (stop - time));
        for (; time + span > next; span *= span_change) {
            if (stay_apart_in_any(a, b, pair, {time, time + span}, gap, 0.5 * tolerance)) next = time + span;
        }
        span = (next - time) / span_change;
        time = next;
        if (!(time < stop)) {
            if (!(stop < end)) return never;
            time = stop;
        }
        gap = pair.gap_at(time);
    }
    return time;
}

// Approach of the shapes themselves by the speed of the nearest points, which takes few evaluations. What it misses is
// caught by the cores. `first`: the gap at `begin`.
template <class Pair>
inline SweepResult approach(const MovingShape& a, const MovingShape& b, SearchSettings settings, double begin,
                            double end, Pair& pair, const Gap& first) {
    const auto sample_of = [&](double time, const Gap& gap) {
        return Bracket::Sample{time, gap, closing_of(a, b, gap, time)};
    };
    const auto sample_at = [&](double time) { return sample_of(time, pair.gap_at(time)); };
    const auto is_near = [&](const Bracket::Sample& sample) { return !(sample.gap.distance > settings.tolerance); };
    // An impact requires that the shapes would approach by more than the tolerance in the rest of the step.
    const auto has_met = [&](const Bracket::Sample& sample) {
        return is_near(sample) && !(settings.is_impact && sample.gap.distance >= 0 &&
                                    sample.closing.along * (1 - sample.time) <= settings.tolerance);
    };
    const auto stays_apart_from = [&](const Bracket::Sample& now) {
        const double clearance = now.gap.distance - settings.tolerance;
        return (clearance > 0 && now.time + certain_time(a, b, now.gap, clearance, now.time) >= end) ||
               (now.gap.distance >= 0 && stay_apart_in_any(a, b, pair, {now.time, end}, now.gap, settings.tolerance));
    };
    Bracket::Sample now = sample_of(begin, first);
    if (has_met(now)) return {begin > 0 || (settings.is_impact && now.gap.distance >= 0) ? begin : overlapped};
    bool is_certain = true; // that they have not met so far
    double beyond = end;    // a time at which they overlap, or the end
    const double sunk = settings.sinks() ? settings.tolerance : -infinity;
    Bracket bracket;
    for (int round = 0; round < max_rounds; ++round) {
        if (has_met(now)) return {now.time};
        if ((settings.is_impact || settings.sinks()) && stays_apart_from(now))
            return is_certain ? surely_apart : SweepResult{};
        bracket.add(now);
        const double clearance = std::max(now.gap.distance - 0.5 * settings.tolerance, 0.0);
        const double leap = !is_near(now) && now.closing.along > 0 ? clearance / now.closing.along : longest_leap;
        const double certain = certain_time(a, b, now.gap, clearance, now.time),
                     next = now.time + std::max(certain, leap);
        is_certain = is_certain && leap <= certain;
        if (!(next < beyond) && beyond == end) {
            const Bracket::Sample last = sample_at(end);
            if (last.gap.distance > settings.tolerance || (settings.is_impact && last.gap.distance >= 0)) {
                bracket.add(last);
                SweepResult result = bracket.least(a.speed() + b.speed(), std::max(settings.within, sunk), sample_at);
                if (result.gap.distance < sunk) result.meeting = result.nearest;
                return result;
            }
        }
        Bracket::Sample there = sample_at(next < beyond ? next : 0.5 * (now.time + beyond));
        while (there.gap.distance < 0 && there.time - now.time > 1e-6 * (end - begin)) { // overshoot
            beyond = there.time;
            there = sample_at(0.5 * (now.time + beyond));
        }
        if (there.gap.distance < 0) return {now.time};
        now = there;
    }
    return {now.time};
}

// A pair whose distance is measured from a floor.
template <class Pair> class AboveFloor {
  public:
    AboveFloor(Pair& pair, double floor) : pair_(pair), floor_(floor) {}
    Gap gap_at(double time) {
        Gap gap = pair_.gap_at(time);
        gap.distance -= floor_;
        return gap;
    }
    double apart_along(DVec3 n, double time) { return pair_.apart_along(n, time) - floor_; }
    static constexpr bool has_axes = Pair::has_axes;

  private:
    Pair& pair_;
    const double floor_;
};

// Searches whether a pair meets in a span of time: by cores, or by the shapes themselves.
template <class Pair>
SweepResult search(const MovingShape& a, const MovingShape& b, SearchSettings settings, Span span, Pair&& pair) {
    if (!settings.sinks() && !(settings.within > 0) && !settings.is_impact)
        return {advance(a, b, settings.tolerance, span.begin, span.end, pair)};
    Gap first = pair.gap_at(span.begin);
    if (!settings.sinks()) return approach(a, b, settings, span.begin, span.end, pair, first);
    const double floor = settings.floor_from(first.distance);
    if (!(floor > 0)) return {overlapped};
    first.distance -= floor;
    AboveFloor above(pair, floor);
    return approach(a, b, settings, span.begin, span.end, above, first);
}

} // namespace cairn::sweep
