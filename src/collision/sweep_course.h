// How two shapes come near each other on their ways: looks at a pair, one after another, until it is known whether and
// when they meet. For core_sweep.cpp, which says what a pair is.
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

inline constexpr double known_depth_part = 0.5; // of contacts that the solver knows
// Cores count as met when they are this near, as part of the depth.
inline constexpr double tolerance_part = 0.1;
// After so many looks at a pair that turns fast and comes hardly nearer, the time that was reached is the answer.
inline constexpr int max_rounds = 100;

// What is looked at: cores, what is twice as deep, the cores of contacts that the solver knows (`deep`: to see how what
// is deeper than the others sinks), or the shapes themselves.
enum class Layer { core, inner, deep, known_core, skin, impact };

// `half_width`: the smaller one of the pair.
inline double depth_of(const Convex& c, Layer layer, double half_width) {
    if (c.kind == Convex::Kind::polygon || layer >= Layer::skin) return 0;
    if (layer == Layer::inner) return std::min(2 * core_depth_of(c.extent), c.extent);
    return layer >= Layer::deep ? known_depth_part * std::min(c.extent, half_width) : core_depth_of(c.extent);
}
// By the narrower of the two, however wide the one is that moves.
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

// What is known of a shape on its way.
class Mover {
  public:
    Mover(const SweptShape& s, Layer layer, double half_width, double from, double to)
        : layer(layer), half_width(half_width), s_(s), from_(from), to_(to),
          first_(from > s.path.begin || s.until < 1 ? pose_at(from) : s.path.first()),
          last_(s.until < 1 || to < s.path.until ? pose_at(to) : s.path.end()), turn_(length(s.path.turn)) {
        const double ball = is_ball() ? 0 : s.geometry.bounding_radius;
        const DVec3 to_middle = middle_offset();
        reach_ = length(to_middle) + ball;
        start = first_.x, end = last_.x;
        if (to_middle == DVec3{}) return; // no turn moves it
        start += math::rotate(first_.q, to_middle);
        end += math::rotate(last_.q, to_middle);
    }
    bool is_ball() const { return s_.geometry.type == ShapeType::sphere; }
    double bounding_radius() const { return s_.geometry.bounding_radius; }
    double until() const { return s_.until; }
    const SweptShape& shape() const { return s_; }
    RigidPath::Pose body_at(double time) const { return time == from_ ? first_ : time == to_ ? last_ : pose_at(time); }
    // A ball about the center of mass, which no turn moves, and its center.
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
    // How fast any point can come along a direction that does not turn, at most.
    double speed_along(DVec3 n, double time) const {
        if (time >= s_.until) return 0;
        return dot(n, s_.path.translation) + length(math::cross(n, s_.path.turn)) * reach_;
    }
    // Of any point, at most.
    double speed() const { return length(s_.path.translation) + turn_ * reach_; }
    // Of a point of it.
    DVec3 velocity_of(DVec3 point, double time) const {
        if (time >= s_.until) return {};
        return s_.path.translation + math::cross(s_.path.turn, point - (s_.path.start + time * s_.path.translation));
    }
    // Seen from a frame that turns with this, about its center of mass: how far a point of another is from the straight
    // line between two of its places, at most. As RigidPath::sagitta has it, with what a turning frame adds to the
    // acceleration of d, the way from the center of mass: 2 w x d' and w x (w x d).
    double sagitta_of(const Mover& other) const {
        const double way = length(other.s_.path.translation - s_.path.translation);
        const double distance = length(other.s_.path.start - s_.path.start) + way + other.reach_;
        const double speed = way + other.turn_ * other.reach_;
        return other.sagitta() + s_.path.sagitta(distance) + 0.25 * turn_ * speed;
    }
    // A direction that is fixed in it.
    DVec3 turned(DVec3 n, double from, double to) const {
        return math::rotate(body_at(to).q, math::rotate(math::conjugate(body_at(from).q), n));
    }
    // How far the middle is from the straight line between two of its places, at most.
    double sagitta() const { return s_.path.sagitta(reach_); }
    bool is_still() const { return speed() == 0; }
    // How far its points are from where they were if all of it moved at one velocity, at most.
    double beside_straight() const { return s_.until >= 1 ? turn_ * reach_ : std::numeric_limits<double>::infinity(); }
    // How far its points move about its middle, at most.
    double turning() const { return is_ball() ? 0 : turn_ * s_.geometry.bounding_radius; }
    // From the center of mass, in the body's frame: of the middle of its bounds, and of a point deep inside.
    DVec3 middle_offset() const { return s_.offset + in_body(math::to_double(s_.geometry.middle)); }
    DVec3 inside_offset() const {
        return s_.geometry.type == ShapeType::hull ? s_.offset + in_body(hull_of(s_.data).inside) : middle_offset();
    }
    const Layer layer;
    const double half_width; // the smaller one of the pair, m
    math::DVec3 start, end;  // of the middle of its bounds: when it is first looked at, and last

  private:
    // Floats make a unit quaternion to 1e-7 only, and a planet of 1 km larger by a tenth of a millimeter.
    DQuat own_rotation() const { return math::normalized(math::to_double(s_.geometry.rotation)); }
    RigidPath::Pose pose_at(double time) const { return s_.path.at(std::min(time, s_.until)); }
    DVec3 in_body(DVec3 local) const { return s_.geometry.is_turned ? math::rotate(own_rotation(), local) : local; }
    const SweptShape& s_;
    const double from_, to_;
    const RigidPath::Pose first_, last_; // there
    const double turn_;
    double reach_;
};

inline constexpr double overlapped = -1; // a time: from the start

struct Gap {
    double distance;
    DVec3 normal; // from a to b
    DVec3 on_a;   // the nearest point
};

// The times that are looked at.
struct Span {
    double begin, end;
};

// Until when the larger of the rates at which two come nearer stays what it is.
inline double next_stop(const Mover& a, const Mover& b, double time, double end) {
    for (const double until : {a.until(), b.until()})
        if (time < until) end = std::min(end, until);
    return end;
}

inline constexpr double infinity = std::numeric_limits<double>::infinity();

// How two shapes come near each other.
struct Course {
    double meeting = never;    // a time, or `overlapped`
    double nearest = 0;        // where they do not meet: when they are nearest,
    Gap gap{infinity, {}, {}}; // and how near
    bool is_certain = false;   // it is proven that they do not meet

    void take(const Course& other) {
        meeting = std::min(meeting, other.meeting);
        if (other.gap.distance < gap.distance) nearest = other.nearest, gap = other.gap;
    }
};
inline constexpr Course surely_apart{never, 0, {infinity, {}, {}}, true};

// What overlaps may go deeper by that part before it is asked again: a body that is pressed in more and more within a
// step is asked some ten times until it is at its middle.
inline constexpr double deeper_part = 0.25;

// What is asked of a pair. `within`: how near it comes matters up to there. `floor_part`: if not 0, it is asked when
// inner cores are nearer than that part of their distance at a touch, in place of when the two meet; what is nearer
// already, when it is nearer by the part `deeper` of what is missing (infinite: it counts as overlapping). `axis`: the
// search begins with that direction from one to the other, or 0, and leaves the last one there.
struct Asked {
    double within = 0, floor_part = 0;
    DVec3& axis;
    double deeper = deeper_part;
};

// What is asked of a course: it ends when the shapes are as near as `tolerance`; how near they come matters up to
// `within`.
struct Question {
    double tolerance, within = 0;
    bool is_impact = false;   // what is as near as that and parts, or stays, has not met
    double highest_floor = 0; // the part that is asked of the distance of inner cores where the shapes touch, at least
    double deeper = deeper_part;

    bool sinks() const { return highest_floor > 0; }
    // Down to which distance of inner cores two may go that are now at another one.
    double floor_from(double distance) const {
        const double missing = highest_floor - distance;
        return (missing > 0 ? distance - deeper * missing : highest_floor) - 2 * tolerance;
    }
};

inline Question question_of(const Convex& c, const Mover& m, const Asked& asked, double depth_of_other) {
    return {tolerance_of(c, m.layer, m.half_width), asked.within, m.layer == Layer::impact,
            asked.floor_part * (depth_of(c, m.layer, m.half_width) + depth_of_other), asked.deeper};
}

// How fast the nearest points come nearer along the normal, and move at all, m/s.
struct Closing {
    double along, speed;
};
inline Closing closing_of(const Mover& a, const Mover& b, const Gap& gap, double time) {
    const DVec3 v = a.velocity_of(gap.on_a, time) - b.velocity_of(gap.on_a + gap.distance * gap.normal, time);
    return {dot(gap.normal, v), length(v)};
}

// Where two are nearest, among what was seen of a course: between the last look at which they came nearer and the first
// at which they did not, or at an end.
class Bracket {
  public:
    struct Look {
        double time;
        Gap gap;
        Closing closing;
    };
    void see(const Look& now) {
        const bool is_turn = has_last_ && last_.closing.along > 0 && !(now.closing.along > 0);
        const bool is_start = !has_last_ && !(now.closing.along > 0);
        if (is_turn || is_start) keep(is_turn ? last_ : now, now);
        last_ = now, has_last_ = true;
    }
    // Nothing follows. By false position (Illinois), until hardly anything approaches.
    template <class F> Course least(double speed, double within, F&& look_at) {
        if (last_.closing.along > 0) keep(last_, last_);
        Look lo = before_, hi = after_;
        const double lower = 0.5 * (lo.gap.distance + hi.gap.distance - speed * (hi.time - lo.time)); // bound
        if (lower > within) return {};
        Look best = lo.gap.distance < hi.gap.distance ? lo : hi;
        double rate_lo = lo.closing.along, rate_hi = hi.closing.along;
        for (int round = 0; round < max_looks && lo.time < hi.time; ++round) {
            const double time = lo.time + (hi.time - lo.time) * (rate_lo / (rate_lo - rate_hi));
            const Look look = look_at(time);
            if (look.gap.distance < best.gap.distance) best = look;
            if (std::fabs(look.closing.along) <= turned_part * look.closing.speed) {
                best = look;
                break;
            }
            if (look.closing.along > 0) {
                lo = look, rate_lo = look.closing.along, rate_hi *= 0.5;
            } else {
                hi = look, rate_hi = look.closing.along, rate_lo *= 0.5;
            }
        }
        return {never, best.time, best.gap};
    }

  private:
    static constexpr int max_looks = 16;
    static constexpr double turned_part = 0.05; // of the speed
    void keep(const Look& before, const Look& after) {
        const double distance = std::min(before.gap.distance, after.gap.distance);
        if (!(distance < least_)) return;
        least_ = distance, before_ = before, after_ = after;
    }
    Look before_{}, after_{}, last_{};
    double least_ = infinity;
    bool has_last_ = false;
};

// How far time goes on where the nearest points do not come nearer for now, as part of the step.
inline constexpr double longest_leap = 1.0 / 16;

// How long two do certainly not meet.
inline double certain_time(const Mover& a, const Mover& b, const Gap& gap, double way, double time) {
    const double speed = a.speed_along(gap.normal, time) + b.speed_along(-gap.normal, time);
    return speed > 0 ? way / speed : never;
}

// Whether two that are `first` apart along a direction when a span begins and `last` when it ends, m, are so in
// between. Every point is within 4 S t (1 - t) of the straight line between its ends (S: the sagitta, t: the part of
// the span), and the farthest of points on straight lines is never beyond the line between the farthest at both ends:
// so they are (1 - t) first + t last - 4 S t (1 - t) apart, at least, which is positive for all t if this is true.
inline bool stay_apart_between(const Mover& a, const Mover& b, Span span, double sagitta, double first, double last) {
    if (next_stop(a, b, span.begin, span.end) < span.end) return false; // no one arc
    const double duration = span.end - span.begin;
    return first >= 0 && last > 0 && std::sqrt(first) + std::sqrt(last) > 2 * duration * std::sqrt(sagitta);
}

// What the direction is fixed in along which two are shown to be apart: two that turn together while they touch are so
// along a face's normal, and for a moment alone along one that stands still.
enum class AxisFrame { world, first, second };

template <class Pair>
inline bool stay_apart_in(AxisFrame frame, const Mover& a, const Mover& b, Pair& pair, Span span, const Gap& gap,
                          double tolerance) {
    const bool turns = frame != AxisFrame::world;
    const Mover &fixed = frame == AxisFrame::second ? b : a, &other = frame == AxisFrame::second ? a : b;
    const DVec3 n = turns ? fixed.turned(gap.normal, span.begin, span.end) : gap.normal;
    const double sagitta = turns ? fixed.sagitta_of(other) : a.sagitta() + b.sagitta();
    const double first = std::max(gap.distance - tolerance, 0.0), last = pair.apart_along(n, span.end) - tolerance;
    return stay_apart_between(a, b, span, sagitta, first, last);
}

// Of a pair, `gap_at` (time) tells how far the two are apart, `apart_along` (direction from a to b, time) how far along
// that, and `has_axes` whether that is so for any direction, or only for that in which they are.
template <class Pair>
inline bool stay_apart_in_any(const Mover& a, const Mover& b, Pair& pair, Span span, const Gap& gap, double tolerance) {
    const auto apart_in = [&](AxisFrame frame) { return stay_apart_in(frame, a, b, pair, span, gap, tolerance); };
    return apart_in(AxisFrame::world) ||
           (Pair::has_axes && (apart_in(AxisFrame::first) || apart_in(AxisFrame::second)));
}

template <class Pair>
inline bool stay_apart_from(const Mover& a, const Mover& b, Pair& pair, double time, const Gap& gap, double end,
                            double tolerance) {
    if (!(gap.distance >= 0)) return false;
    return stay_apart_in(AxisFrame::world, a, b, pair, {time, end}, gap, tolerance);
}

// Advances from `begin` to `end`, so that nothing is missed.
inline constexpr double span_change = 0.25; // of a span that is too long to be proven, and back
template <class Pair>
inline double advance(const Mover& a, const Mover& b, double tolerance, double begin, double end, Pair& pair) {
    double time = begin;
    Gap gap = pair.gap_at(time);
    if (!(gap.distance > 0)) return overlapped;
    tolerance = std::min(tolerance, 0.5 * gap.distance); // what has been stopped at it goes on if it parts
    double span = end - begin;                           // is looked at next
    for (int round = 0; round < max_rounds; ++round) {
        if (!(gap.distance > tolerance)) return time;
        if (stay_apart_from(a, b, pair, time, gap, end, tolerance)) return never;
        const double stop = next_stop(a, b, time, end); // up to which the speed is what it is
        double next = time + certain_time(a, b, gap, gap.distance - 0.5 * tolerance, time);
        // What parts, or hardly moves, is apart for much longer than a bound of its speed says.
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

// How the shapes themselves come near each other: by the speed of the points that are nearest, which takes a few looks.
// What that misses, the cores do not. `first`: how near they are at `begin`.
template <class Pair>
inline Course approach(const Mover& a, const Mover& b, Question question, double begin, double end, Pair& pair,
                       const Gap& first) {
    const auto look = [&](double time, const Gap& gap) {
        return Bracket::Look{time, gap, closing_of(a, b, gap, time)};
    };
    const auto look_at = [&](double time) { return look(time, pair.gap_at(time)); };
    const auto is_near = [&](const Bracket::Look& look) { return !(look.gap.distance > question.tolerance); };
    // An impact is where they would come nearer by more than the tolerance in the rest of the step.
    const auto has_met = [&](const Bracket::Look& look) {
        return is_near(look) && !(question.is_impact && look.gap.distance >= 0 &&
                                  look.closing.along * (1 - look.time) <= question.tolerance);
    };
    const auto stays_apart_from = [&](const Bracket::Look& now) {
        const double way = now.gap.distance - question.tolerance;
        return (way > 0 && now.time + certain_time(a, b, now.gap, way, now.time) >= end) ||
               (now.gap.distance >= 0 && stay_apart_in_any(a, b, pair, {now.time, end}, now.gap, question.tolerance));
    };
    Bracket::Look now = look(begin, first);
    if (has_met(now)) return {begin > 0 || (question.is_impact && now.gap.distance >= 0) ? begin : overlapped};
    bool is_certain = true; // that they have not met so far
    double beyond = end;    // they overlap then, or it is the end
    const double sunk = question.sinks() ? question.tolerance : -infinity;
    Bracket seen;
    for (int round = 0; round < max_rounds; ++round) {
        if (has_met(now)) return {now.time};
        if ((question.is_impact || question.sinks()) && stays_apart_from(now))
            return is_certain ? surely_apart : Course{};
        seen.see(now);
        const double way = std::max(now.gap.distance - 0.5 * question.tolerance, 0.0);
        const double leap = !is_near(now) && now.closing.along > 0 ? way / now.closing.along : longest_leap;
        const double certain = certain_time(a, b, now.gap, way, now.time), next = now.time + std::max(certain, leap);
        is_certain = is_certain && leap <= certain;
        if (!(next < beyond) && beyond == end) {
            const Bracket::Look last = look_at(end);
            if (last.gap.distance > question.tolerance || (question.is_impact && last.gap.distance >= 0)) {
                seen.see(last);
                Course course = seen.least(a.speed() + b.speed(), std::max(question.within, sunk), look_at);
                if (course.gap.distance < sunk) course.meeting = course.nearest;
                return course;
            }
        }
        Bracket::Look there = look_at(next < beyond ? next : 0.5 * (now.time + beyond));
        while (there.gap.distance < 0 && there.time - now.time > 1e-6 * (end - begin)) { // too far
            beyond = there.time;
            there = look_at(0.5 * (now.time + beyond));
        }
        if (there.gap.distance < 0) return {now.time};
        now = there;
    }
    return {now.time};
}

// A pair whose distance is counted from a floor.
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

// Of cores, or of the shapes themselves.
template <class Pair> Course course_by(const Mover& a, const Mover& b, Question question, Span span, Pair&& pair) {
    if (!question.sinks() && !(question.within > 0) && !question.is_impact)
        return {advance(a, b, question.tolerance, span.begin, span.end, pair)};
    Gap first = pair.gap_at(span.begin);
    if (!question.sinks()) return approach(a, b, question, span.begin, span.end, pair, first);
    const double floor = question.floor_from(first.distance);
    if (!(floor > 0)) return {overlapped};
    first.distance -= floor;
    AboveFloor above(pair, floor);
    return approach(a, b, question, span.begin, span.end, above, first);
}

} // namespace cairn::sweep
