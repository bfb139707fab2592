#include "collision/core_sweep.h"

#include "shapes/convex.h"
#include "shapes/gjk.h"
#include "shapes/mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cairn {

using math::DMat3;
using math::dot;
using math::DQuat;
using math::DVec3;
using math::length;

namespace {

// How far the core is inside the shape: m at least, and as part of the smallest half width.
constexpr double core_depth = 1e-3, core_depth_part = 0.02;
constexpr double known_depth_part = 0.5; // of contacts that the solver knows
// Cores count as met when they are this near, as part of the depth.
constexpr double tolerance_part = 0.1;
constexpr double impact_share = 0.01; // of the tolerance of a touch: how near shapes are where an impact is
// After so many looks at a pair that turns fast and comes hardly nearer, the time that was reached is the answer.
constexpr int max_rounds = 100;
// A way along a mesh is looked at in pieces of so many sizes of what moves, but no more than that many.
constexpr double sizes_per_piece = 8;
constexpr int max_pieces = 64;

// What is looked at: cores, those of contacts that the solver knows, or the shapes themselves.
enum class Layer { core, known_core, skin, impact };

double depth_of(const Convex& c, Layer layer) {
    if (c.kind == Convex::Kind::polygon || layer >= Layer::skin) return 0;
    return layer == Layer::known_core ? known_depth_part * c.extent : std::max(core_depth, core_depth_part * c.extent);
}
double tolerance_of(const Convex& c, Layer layer) {
    if (layer >= Layer::skin) {
        const double tolerance = touch_tolerance(c.extent);
        return layer == Layer::skin ? tolerance : impact_share * tolerance;
    }
    return tolerance_part * depth_of(c, layer);
}

// What is known of a shape on its way.
class Mover {
  public:
    Mover(const SweptShape& s, Layer layer, double from, double to) : layer(layer), s_(s), turn_(length(s.path.turn)) {
        const double ball = is_ball() ? 0 : s.geometry.bounding_radius;
        const DVec3 to_middle = middle_offset();
        reach_ = length(to_middle) + ball;
        const RigidPath::Pose first = from > s.path.begin || s.until < 1 ? body_at(from) : s.path.first();
        start = first.x + math::rotate(first.q, to_middle);
        const RigidPath::Pose last = s.until < 1 || to < s.path.until ? body_at(to) : s.path.end();
        end = last.x + math::rotate(last.q, to_middle);
    }
    bool is_ball() const { return s_.geometry.type == ShapeType::sphere; }
    double bounding_radius() const { return s_.geometry.bounding_radius; }
    double until() const { return s_.until; }
    const SweptShape& shape() const { return s_; }
    RigidPath::Pose body_at(double time) const { return s_.path.at(std::min(time, s_.until)); }
    DQuat rotation_at(const RigidPath::Pose& pose) const {
        return s_.geometry.is_turned ? pose.q * math::to_double(s_.geometry.rotation) : pose.q;
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
    // How far the middle is from the straight line between two of its places, at most.
    double sagitta() const { return s_.path.sagitta(reach_); }
    bool is_still() const { return speed() == 0; }
    // Whether all of it moves at one velocity.
    bool moves_straight() const { return turn_ * reach_ == 0 && s_.until >= 1; }
    // How far its points move about its middle, at most.
    double turning() const { return is_ball() ? 0 : turn_ * s_.geometry.bounding_radius; }
    DVec3 middle_offset() const { return s_.offset + local_middle(); } // from the center of mass, in the body's frame
    const Layer layer;
    math::DVec3 start, end; // of the middle of its bounds: when it is first looked at, and last

  private:
    DVec3 local_middle() const {
        const DVec3 m = math::to_double(s_.geometry.middle);
        return s_.geometry.is_turned ? math::rotate(math::to_double(s_.geometry.rotation), m) : m;
    }
    const SweptShape& s_;
    double turn_, reach_;
};

constexpr double overlapped = -1; // a time: from the start

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
double next_stop(const Mover& a, const Mover& b, double time, double end) {
    for (const double until : {a.until(), b.until()})
        if (time < until) end = std::min(end, until);
    return end;
}

constexpr double infinity = std::numeric_limits<double>::infinity();

// How two shapes come near each other.
struct Course {
    double meeting = never;    // a time, or `overlapped`
    double nearest = 0;        // where they do not meet: when they are nearest,
    Gap gap{infinity, {}, {}}; // and how near

    void take(const Course& other) {
        meeting = std::min(meeting, other.meeting);
        if (other.gap.distance < gap.distance) nearest = other.nearest, gap = other.gap;
    }
};

// What is asked of a course: it ends when the shapes are as near as `tolerance`; how near they come matters up to
// `within`.
struct Question {
    double tolerance, within = 0;
    bool is_impact = false; // what is as near as that and parts, or stays, has not met
};

Question question_of(const Convex& c, Layer layer, double within) {
    return {tolerance_of(c, layer), within, layer == Layer::impact};
}

// How fast the nearest points come nearer along the normal, and move at all, m/s.
struct Closing {
    double along, speed;
};
Closing closing_of(const Mover& a, const Mover& b, const Gap& gap, double time) {
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
constexpr double longest_leap = 1.0 / 16;

// How long two do certainly not meet.
double certain_time(const Mover& a, const Mover& b, const Gap& gap, double way, double time) {
    const double speed = a.speed_along(gap.normal, time) + b.speed_along(-gap.normal, time);
    return speed > 0 ? way / speed : never;
}

// Whether two that are `first` apart along a direction when a span begins and `last` when it ends, m, are so in
// between. Every point is within 4 S t (1 - t) of the straight line between its ends (S: the sagitta, t: the part of
// the span), and the farthest of points on straight lines is never beyond the line between the farthest at both ends:
// so they are (1 - t) first + t last - 4 S t (1 - t) apart, at least, which is positive for all t if this is true.
bool stay_apart_between(const Mover& a, const Mover& b, Span span, double first, double last) {
    if (next_stop(a, b, span.begin, span.end) < span.end) return false; // no one arc
    const double duration = span.end - span.begin, sagitta = duration * duration * (a.sagitta() + b.sagitta());
    return first >= 0 && last > 0 && std::sqrt(first) + std::sqrt(last) > 2 * std::sqrt(sagitta);
}

// Of a pair, `gap_at` (time) tells how far the two are apart, and `apart_along` (direction from a to b, time) how far
// along that.
template <class Pair>
bool stay_apart_from(const Mover& a, const Mover& b, const Pair& pair, double time, const Gap& gap, double end,
                     double tolerance) {
    if (!(gap.distance >= 0)) return false;
    const double last = pair.apart_along(gap.normal, end) - tolerance;
    return stay_apart_between(a, b, {time, end}, std::max(gap.distance - tolerance, 0.0), last);
}

// Advances from `begin` to `end`, so that nothing is missed.
template <class Pair>
double advance(const Mover& a, const Mover& b, double tolerance, double begin, double end, Pair& pair) {
    double time = begin;
    Gap gap = pair.gap_at(time);
    if (!(gap.distance > tolerance)) return begin > 0 ? begin : overlapped;
    for (int round = 0; round < max_rounds; ++round) {
        if (!(gap.distance > tolerance)) return time;
        if (stay_apart_from(a, b, pair, time, gap, end, tolerance)) return never;
        const double stop = next_stop(a, b, time, end); // up to which the speed is what it is
        time += certain_time(a, b, gap, gap.distance - 0.5 * tolerance, time);
        if (!(time < stop)) {
            if (!(stop < end)) return never;
            time = stop;
        }
        gap = pair.gap_at(time);
    }
    return time;
}

// How the shapes themselves come near each other: by the speed of the points that are nearest, which takes a few looks.
// What that misses, the cores do not.
template <class Pair>
Course approach(const Mover& a, const Mover& b, Question question, double begin, double end, Pair& pair) {
    const auto look_at = [&](double time) {
        const Gap gap = pair.gap_at(time);
        return Bracket::Look{time, gap, closing_of(a, b, gap, time)};
    };
    const auto is_near = [&](const Bracket::Look& look) { return !(look.gap.distance > question.tolerance); };
    // An impact is where they would come nearer by more than the tolerance in the rest of the step.
    const auto has_met = [&](const Bracket::Look& look) {
        return is_near(look) && !(question.is_impact && look.gap.distance >= 0 &&
                                  look.closing.along * (1 - look.time) <= question.tolerance);
    };
    Bracket::Look now = look_at(begin);
    if (has_met(now)) return {begin > 0 || (question.is_impact && now.gap.distance >= 0) ? begin : overlapped};
    double beyond = end; // they overlap then, or it is the end
    Bracket seen;
    for (int round = 0; round < max_rounds; ++round) {
        if (has_met(now)) return {now.time};
        if (question.is_impact && stay_apart_from(a, b, pair, now.time, now.gap, end, question.tolerance)) return {};
        seen.see(now);
        const double way = std::max(now.gap.distance - 0.5 * question.tolerance, 0.0);
        const double leap = !is_near(now) && now.closing.along > 0 ? way / now.closing.along : longest_leap;
        const double next = now.time + std::max(certain_time(a, b, now.gap, way, now.time), leap);
        if (!(next < beyond) && beyond == end) {
            const Bracket::Look last = look_at(end);
            if (last.gap.distance > question.tolerance || (question.is_impact && last.gap.distance >= 0)) {
                seen.see(last);
                return seen.least(a.speed() + b.speed(), question.within, look_at);
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

// Of cores, or of the shapes themselves.
template <class Pair> Course course_by(const Mover& a, const Mover& b, Question question, Span span, Pair&& pair) {
    if (question.within > 0 || question.is_impact) return approach(a, b, question, span.begin, span.end, pair);
    return {advance(a, b, question.tolerance, span.begin, span.end, pair)};
}

// The core. Of strips, which have no end, of the part near a point.
Convex core_at(const Mover& m, double time, DVec3 near, double reach) {
    const RigidPath::Pose pose = m.body_at(time);
    DVec3 center = m.origin_at(pose);
    const DQuat q = m.rotation_at(pose);
    const Geometry part = near_part(m.shape().geometry, center, q, near, reach);
    const Convex whole = make_convex(part, m.shape().data, center, q);
    return m.layer >= Layer::skin ? whole : shrunk(whole, depth_of(whole, m.layer));
}
Convex core_at(const Mover& m, double time) { return core_at(m, time, {}, 0); }

Gap gap_of(const Convex& a, const Convex& b, DVec3& guess) {
    const Core core_a = exact_core(a), core_b = exact_core(b);
    const GjkResult r = gjk_distance({core_a, core_b}, guess, infinity, 1e-6);
    if (r.state != GjkResult::State::apart) return {-1, {}, {}};
    guess = r.normal;
    return {r.distance - (core_a.radius + core_b.radius), r.normal, r.on_a + core_a.radius * r.normal};
}

// How far two are apart along a unit direction from `a` to `b`.
double gap_along(DVec3 n, const Convex& a, const Convex& b) {
    const Core core_a = exact_core(a), core_b = exact_core(b);
    return dot(n, core_support(core_b, -n) - core_support(core_a, n)) - (core_a.radius + core_b.radius);
}

// Whether two never come as near as `question` asks along a direction: what is cheap to ask, and true of most.
template <class Pair>
bool stay_apart_along(DVec3 direction, const Mover& a, const Mover& b, Span span, const Pair& pair,
                      const Question& question) {
    const double square = dot(direction, direction);
    if (!(square > 0)) return false;
    const DVec3 n = (1 / std::sqrt(square)) * direction;
    const double limit = question.tolerance + question.within, first = pair.apart_along(n, span.begin) - limit;
    return first > 0 && stay_apart_between(a, b, span, first, pair.apart_along(n, span.end) - limit);
}

bool begins_in_front(DVec3 point, const Convex& face) { return dot(face.axes.c1, point - face.corners[0]) > 0; }

class ConvexPair {
  public:
    ConvexPair(const Mover& a, const Mover& b)
        : guess(b.start - a.start), a_(a), b_(b), reach_(length(a.end - a.start) + a.sagitta() + a.bounding_radius()) {}
    Convex first_at(double time) const { return core_at(a_, time); }
    Convex second_at(double time) const { return core_at(b_, time, a_.start, reach_); }
    Gap gap_at(double time) { return gap_of(first_at(time), second_at(time), guess); }
    double apart_along(DVec3 n, double time) const { return gap_along(n, first_at(time), second_at(time)); }

    DVec3 guess;

  private:
    const Mover &a_, &b_;
    const double reach_; // of the first, about where it starts
};

Course course_of_convexes(const Mover& a, const Mover& b, Span span, double within) {
    ConvexPair pair(a, b);
    const Convex first = pair.first_at(span.begin), second = pair.second_at(span.begin);
    if (second.kind == Convex::Kind::polygon && !b.shape().geometry.is_double_sided &&
        !begins_in_front(middle(first), second))
        return {};
    const Question question = question_of(first, a.layer, within);
    if (stay_apart_along(pair.guess, a, b, span, pair, question)) return {};
    return course_by(a, b, question, span, pair);
}

class PlanePair {
  public:
    PlanePair(const Mover& a, const Mover& b, double begin) : a_(a), b_(b) {
        if (b.shape().geometry.is_double_sided && height_of(a.start, begin) < 0) side_ = -1;
    }
    Gap gap_at(double time) const {
        const Convex c = core_at(a_, time);
        const Core core = exact_core(c);
        const DVec3 down = -side_ * up_at(time), lowest = core_support(core, down) + core.radius * down;
        return {side_ * height_of(lowest, time), down, lowest};
    }
    double apart_along(DVec3, double time) const { return b_.is_still() ? gap_at(time).distance : -infinity; }

  private:
    DVec3 up_at(double time) const { return math::rotate(b_.rotation_at(b_.body_at(time)), DVec3{0, 1, 0}); }
    double height_of(DVec3 p, double time) const { return dot(p - b_.origin_at(b_.body_at(time)), up_at(time)); }

    const Mover &a_, &b_;
    double side_ = 1;
};

Course course_at_plane(const Mover& a, const Mover& b, Span span, double within) {
    return course_by(a, b, question_of(core_at(a, span.begin), a.layer, within), span, PlanePair(a, b, span.begin));
}

Convex triangle_at(const Mover& m, const Triangle& t, double time) {
    const RigidPath::Pose pose = m.body_at(time);
    const DVec3 origin = m.origin_at(pose);
    const DMat3 axes = math::to_matrix(m.rotation_at(pose));
    const auto corner = [&](math::Vec3 v) { return origin + axes * math::to_double(v); };
    return make_triangle(corner(t.a), corner(t.b), corner(t.c));
}

class TrianglePair {
  public:
    TrianglePair(const Mover& a, const Mover& b, const Triangle& triangle, double begin)
        : begin_face(triangle_at(b, triangle, begin)), a_(a), b_(b), triangle_(triangle) {}
    Gap gap_at(double time) { return gap_of(core_at(a_, time), face_at(time), guess); }
    double apart_along(DVec3 n, double time) const { return gap_along(n, core_at(a_, time), face_at(time)); }

    const Convex begin_face; // when the span begins
    DVec3 guess;

  private:
    Convex face_at(double time) const { return b_.is_still() ? begin_face : triangle_at(b_, triangle_, time); }
    const Mover &a_, &b_;
    const Triangle& triangle_;
};

// With the triangles of a mesh or height field, from their front.
Course course_at_triangles(const Mover& a, const Mover& b, Span span, double within) {
    const auto local_at = [&](double time) { // the middle of a, in the frame of the surface
        const RigidPath::Pose pose = b.body_at(time);
        return math::rotate(math::conjugate(b.rotation_at(pose)), a.middle_at(time) - b.origin_at(pose));
    };
    const Geometry& surface = b.shape().geometry;
    const DVec3 start = local_at(span.begin), last = local_at(span.end);
    const double bend = a.sagitta() + b.shape().path.sagitta(length(start) + length(last));
    const double way = length(last - start), size = std::max(a.bounding_radius(), 1e-3);
    const int pieces = std::clamp(int(std::min(way / (sizes_per_piece * size), 1e6)) + 1, 1, max_pieces);
    const double radius = a.bounding_radius() + bend + within;
    Course best;
    bool overlaps = false;
    for (int piece = 0; piece < pieces && best.meeting == never; ++piece) {
        const double length_of_piece = (span.end - span.begin) / pieces;
        const double begin = span.begin + piece * length_of_piece;
        const double end = piece + 1 < pieces ? begin + length_of_piece : span.end;
        const DVec3 p = local_at(begin), q = local_at(end);
        math::Vec3 lo, hi;
        for (int i = 0; i < 3; ++i) {
            lo[i] = float(std::min(p[i], q[i]) - radius * (1 + 1e-5) - 1e-6 * std::fabs(p[i]));
            hi[i] = float(std::max(p[i], q[i]) + radius * (1 + 1e-5) + 1e-6 * std::fabs(p[i]));
        }
        const Convex mover = core_at(a, begin);
        const auto visit = [&](const auto& mesh) {
            for_each_triangle(mesh, lo, hi, [&](std::uint32_t index) {
                const Triangle t = triangle_of(mesh, index);
                TrianglePair pair(a, b, t, begin);
                if (!begins_in_front(middle(mover), pair.begin_face)) return;
                pair.guess = pair.begin_face.center - mover.center;
                const Question question = question_of(mover, a.layer, within);
                const Span part{begin, std::min(end, best.meeting)};
                if (stay_apart_along(-pair.begin_face.axes.c1, a, b, part, pair, question) ||
                    stay_apart_along(pair.guess, a, b, part, pair, question))
                    return;
                const Course course = course_by(a, b, question, part, pair);
                if (course.meeting == overlapped)
                    overlaps = true;
                else
                    best.take(course);
            });
        };
        if (surface.type == ShapeType::mesh)
            visit(mesh_of(b.shape().data));
        else
            visit(height_field_of(b.shape().data));
    }
    if (overlaps) best.meeting = overlapped;
    return best;
}

// Whether they move against each other so little that no core can pass.
bool stay_together(const Mover& a, const Mover& b) {
    const double half = 0.5 * double(std::min(smallest_extent(a.shape().geometry, a.shape().data),
                                              smallest_extent(b.shape().geometry, b.shape().data)));
    const DVec3 way = (b.end - b.start) - (a.end - a.start);
    return length(way) + (a.turning() + b.turning()) <= free_share * half;
}

// Whether balls around both meet at all, along lines, with what they may be beside them.
bool may_meet_on_the_way(const Mover& a, const Mover& b, double within) {
    const DVec3 from = b.start - a.start, to = b.end - a.end, way = to - from;
    double sagitta = a.sagitta() + b.sagitta();
    if (a.until() < 1 || b.until() < 1) sagitta += length(way); // no straight line
    const double reach = a.bounding_radius() + b.bounding_radius() + sagitta + within, square = dot(way, way);
    const double time = square > 0 ? std::clamp(-dot(from, way) / square, 0.0, 1.0) : 0;
    const DVec3 nearest = from + time * way;
    return dot(nearest, nearest) <= reach * reach;
}

Course course_of(const Mover& a, const Mover& b, Span span, double within) {
    const ShapeType type = b.shape().geometry.type;
    if (type == ShapeType::plane) return course_at_plane(a, b, span, within);
    if (type == ShapeType::mesh || type == ShapeType::height_field) return course_at_triangles(a, b, span, within);
    if (!is_strip(b.shape().geometry) && !may_meet_on_the_way(a, b, within)) return {};
    return course_of_convexes(a, b, span, within);
}
double end_of(const SweptShape& a, const SweptShape& b) { return std::min(a.path.until, b.path.until); }

// A ball in the middle of a shape, with half of its smallest half width.
Geometry ball_inside(const Mover& m) {
    Geometry ball;
    const float radius = 0.25f * smallest_extent(m.shape().geometry, m.shape().data);
    ball.size = {radius, radius, radius};
    ball.bounding_radius = radius;
    return ball;
}

} // namespace

RigidPath RigidPath::between(DVec3 x0, DQuat q0, DVec3 x1, DQuat q1, double begin, double until) {
    DQuat by = q1 * math::conjugate(q0);
    if (by.w < 0) by = {-by.x, -by.y, -by.z, -by.w};
    const double share = begin < until ? 1 / (until - begin) : 0;
    const DVec3 translation = share * (x1 - x0);
    return {x0 - begin * translation, translation, q0, by, (4 * share / (1 + by.w)) * by.vector(), begin, until};
}

RigidPath::Pose RigidPath::at(double time) const {
    const double part = begin < until ? (time - begin) / (until - begin) : 1.0;
    const DQuat turned = math::normalized(DQuat{part * by.x, part * by.y, part * by.z, 1 + part * (by.w - 1)});
    return {start + time * translation, math::normalized(turned * rotation)};
}

double time_of_meeting(const SweptShape& a, const SweptShape& b, bool is_known, double from) {
    const Layer layer = is_known ? Layer::known_core : Layer::core;
    const double to = end_of(a, b);
    const Mover first(a, layer, from, to), second(b, layer, from, to);
    if (stay_together(first, second)) return never;
    const double time = course_of(first, second, {from, to}, 0).meeting;
    if (time != overlapped) return time;
    // What begins too deep goes no deeper than up to its middle.
    const Geometry ball = ball_inside(first);
    const SweptShape inside{ball, a.data, first.middle_offset(), a.path, a.until};
    const double deeper = course_of(Mover(inside, layer, from, to), second, {from, to}, 0).meeting;
    return deeper == overlapped ? never : deeper;
}

double time_of_impact(const SweptShape& a, const SweptShape& b, double from) {
    const double to = end_of(a, b);
    const Mover first(a, Layer::impact, from, to), second(b, Layer::impact, from, to);
    const double time = course_of(first, second, {from, to}, 0).meeting;
    // The distance of convex shapes that move straight is a convex function of time: no touch of them is missed.
    const bool is_certain = time != overlapped && first.moves_straight() && second.moves_straight();
    return time >= 0 && (time < 1 || is_certain) ? time : time_of_meeting(a, b, false, from);
}

Nearness nearness_of(const SweptShape& a, const SweptShape& b, double within) {
    const double to = end_of(a, b);
    const Course course = course_of(Mover(a, Layer::skin, 0, to), Mover(b, Layer::skin, 0, to), {0, to}, within);
    if (course.meeting <= to) return {std::max(course.meeting, 0.0), 0, {}, {}};
    return {course.nearest, course.gap.distance, course.gap.normal, course.gap.on_a};
}

} // namespace cairn
