#include "collision/core_sweep.h"

#include "collision/sweep_search.h"
#include "collision/swept_core.h"
#include "shapes/convex_query.h"
#include "shapes/mesh.h"

#include <optional>

namespace cairn {

using math::DMat3;
using math::dot;
using math::DQuat;
using math::DVec3;
using math::length;
using namespace sweep;

namespace {

// A path along a mesh is processed in pieces of this many sizes of the moving shape, but at most max_pieces of them.
constexpr double sizes_per_piece = 8;
constexpr int max_pieces = 64;

// The support distance of a shape from its center along a unit direction.
double reach_along(DVec3 n, const Convex& c) {
    const Core core = exact_core(c);
    if (c.kind == Convex::Kind::ball) return core.radius;
    if (c.kind != Convex::Kind::box) return dot(n, core_support(core, n) - c.center) + core.radius;
    const DVec3 along = math::abs(to_local(c, n));
    return dot(along, c.size) + core.radius;
}

// The separation of two shapes along a unit direction from `a` to `b`.
double gap_along(DVec3 n, const Convex& a, const Convex& b) {
    return dot(n, b.center - a.center) - (reach_along(n, a) + reach_along(-n, b));
}

// Whether two shapes stay farther apart along a direction than `settings` asks, and by how much: a cheap test that most
// pairs pass.
template <class Pair>
bool stay_apart_along(Separation& known, const MovingShape& a, const MovingShape& b, Span span, Pair& pair,
                      const SearchSettings& settings) {
    const double square = dot(known.axis, known.axis);
    if (!(square > 0)) return false;
    const DVec3 n = (1 / std::sqrt(square)) * known.axis;
    const double limit = settings.tolerance + settings.within + settings.highest_floor,
                 first = pair.apart_along(n, span.begin) - limit;
    if (!(first > 0)) return false;
    const double last = pair.apart_along(n, span.end) - limit, sagitta = a.sagitta() + b.sagitta();
    if (!stay_apart_between(a, b, span, sagitta, first, last)) return false;
    known = {n, slack_between(span, sagitta, first, last)};
    return true;
}

bool begins_in_front(DVec3 point, const Convex& face) { return dot(face.axes.c1, point - face.corners[0]) > 0; }

class ConvexPair {
  public:
    static constexpr bool has_axes = true;
    ConvexPair(const MovingShape& a, const MovingShape& b, Span span, DVec3& axis)
        : a_(a, span), b_(b, span, a.start, length(a.end - a.start) + a.sagitta() + a.bounding_radius()),
          finder_(axis) {}
    const Convex& first_at(double time) { return a_.at(time); }
    const Convex& second_at(double time) { return b_.at(time); }
    Gap gap_at(double time) { return finder_.gap_of(a_, b_, time); }
    double apart_along(DVec3 n, double time) { return gap_along(n, a_.at(time), b_.at(time)); }

  private:
    SweptCore a_, b_;
    GapFinder finder_;
};

SweepResult search_convexes(const MovingShape& a, const MovingShape& b, Span span, const SweepQuery& asked) {
    if (!(dot(asked.known.axis, asked.known.axis) > 0)) asked.known.axis = b.start - a.start;
    ConvexPair pair(a, b, span, asked.known.axis);
    const Convex &first = pair.first_at(span.begin), &second = pair.second_at(span.begin);
    if (second.kind == Convex::Kind::polygon && !b.shape().geometry.is_double_sided &&
        !begins_in_front(inside_of(first), second))
        return {};
    const SearchSettings settings = settings_of(first, a, asked, depth_of(second, b.layer, b.half_width));
    if (stay_apart_along(asked.known, a, b, span, pair, settings)) return surely_apart;
    if (settings.deeper == infinity && // the normal of the contact that pushes them apart
        pair.apart_along(math::normalized(asked.known.axis), span.begin) < settings.highest_floor)
        return {overlapped};
    return search(a, b, settings, span, pair);
}

class PlanePair {
  public:
    static constexpr bool has_axes = false;
    PlanePair(SweptCore& a, const MovingShape& b, DVec3 start, double begin) : a_(a), b_(b) {
        if (b.shape().geometry.is_double_sided && height_of(start, begin) < 0) side_ = -1;
    }
    Gap gap_at(double time) {
        const Core core = exact_core(a_.at(time));
        const DVec3 down = -side_ * up_at(time), lowest = core_support(core, down) + core.radius * down;
        return {side_ * height_of(lowest, time), down, lowest};
    }
    double apart_along(DVec3, double time) { return b_.is_still() ? gap_at(time).distance : -infinity; }

  private:
    DVec3 up_at(double time) const { return math::rotate(b_.rotation_at(b_.body_at(time)), DVec3{0, 1, 0}); }
    double height_of(DVec3 p, double time) const { return dot(p - b_.origin_at(b_.body_at(time)), up_at(time)); }

    SweptCore& a_;
    const MovingShape& b_;
    double side_ = 1;
};

SweepResult search_plane(const MovingShape& a, const MovingShape& b, Span span, const SweepQuery& asked) {
    SweptCore core(a, span);
    const SearchSettings settings = settings_of(core.at(span.begin), a, asked, 0);
    return search(a, b, settings, span, PlanePair(core, b, a.start, span.begin));
}

Convex triangle_at(const Frame& frame, const Triangle& t) {
    const auto corner = [&](math::Vec3 v) { return frame.to_world(math::to_double(v)); };
    return make_triangle(corner(t.a), corner(t.b), corner(t.c));
}

class TrianglePair {
  public:
    static constexpr bool has_axes = true;
    // `center`: of `a` at the beginning of the span.
    TrianglePair(SweptCore& a, const MovingShape& b, const Triangle& triangle, double begin, DVec3 center)
        : a_(a), b_(b), triangle_(triangle), begin_frame_(frame_at(b, begin)),
          begin_face_(triangle_at(begin_frame_, triangle)), from_center_(begin_face_.center - center),
          axis_(from_center_), finder_(axis_) {}
    const Convex& begin_face() const { return begin_face_; } // at the beginning of the span
    DVec3 from_center() const { return from_center_; }       // from the center of `a` to that face
    Gap gap_at(double time) {
        const Convex& core = a_.at(time);
        const Frame b = b_.is_still() ? begin_frame_ : frame_at(b_, time);
        return finder_.gap_of(core, a_.frame(), face_at(b), b);
    }
    double apart_along(DVec3 n, double time) {
        return gap_along(n, a_.at(time), b_.is_still() ? begin_face_ : face_at(frame_at(b_, time)));
    }

  private:
    Convex face_at(const Frame& frame) const { return b_.is_still() ? begin_face_ : triangle_at(frame, triangle_); }
    SweptCore& a_;
    const MovingShape& b_;
    const Triangle& triangle_;
    const Frame begin_frame_;
    const Convex begin_face_;
    const DVec3 from_center_;
    DVec3 axis_;
    GapFinder finder_;
};

template <class F> void with_surface(const SweptShape& s, F&& f) {
    if (s.geometry.type == ShapeType::mesh)
        f(mesh_of(s.data));
    else
        f(height_field_of(s.data));
}

// Searches a shape and the front of one triangle.
void meet_triangle(SweptCore& core, const MovingShape& a, const MovingShape& b, const Triangle& triangle, Span span,
                   const SweepQuery& asked, SweepResult& best, bool& overlaps) {
    const Convex& mover = core.at(span.begin);
    TrianglePair pair(core, b, triangle, span.begin, mover.center);
    if (!begins_in_front(inside_of(mover), pair.begin_face())) return;
    const SearchSettings settings = settings_of(mover, a, asked, 0);
    const Span part{span.begin, std::min(span.end, best.meeting)};
    Separation from_front{-pair.begin_face().axes.c1}, from_center{pair.from_center()};
    if (stay_apart_along(from_front, a, b, part, pair, settings) ||
        stay_apart_along(from_center, a, b, part, pair, settings))
        return;
    const SweepResult result = search(a, b, settings, part, pair);
    if (result.meeting == overlapped)
        overlaps = true;
    else
        best.take(result);
}

// Searches a shape and the triangles of a mesh or height field.
SweepResult search_triangles(const MovingShape& a, const MovingShape& b, Span span, const SweepQuery& asked) {
    const auto local_at = [&](double time) { // the middle of a in the surface's frame
        const RigidPath::Pose pose = b.body_at(time);
        return math::rotate(math::conjugate(b.rotation_at(pose)), a.middle_at(time) - b.origin_at(pose));
    };
    const DVec3 start = local_at(span.begin), last = local_at(span.end);
    const double bend = a.sagitta() + b.shape().path.sagitta(length(start) + length(last));
    const double travel = length(last - start), size = std::max(a.bounding_radius(), 1e-3);
    const int pieces = std::clamp(int(std::min(travel / (sizes_per_piece * size), 1e6)) + 1, 1, max_pieces);
    const double radius = a.bounding_radius() + bend + asked.within;
    SweepResult best;
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
        SweptCore core(a, {begin, end});
        with_surface(b.shape(), [&](const auto& surface) {
            for_each_triangle(surface, lo, hi, [&](std::uint32_t index) {
                meet_triangle(core, a, b, triangle_of(surface, index), {begin, end}, asked, best, overlaps);
            });
        });
    }
    if (overlaps) best.meeting = overlapped;
    return best;
}

// Whether the relative motion of two shapes is so small that no core can pass through.
bool stay_together(const MovingShape& a, const MovingShape& b) {
    const DVec3 displacement = (b.end - b.start) - (a.end - a.start);
    return length(displacement) + (a.turning() + b.turning()) <= free_share * a.half_width;
}

// Whether bounding spheres of both shapes meet at all on straight paths, with their deviations from these added.
bool balls_may_meet(const MovingShape& a, const MovingShape& b, double within) {
    const DVec3 from = b.start - a.start, to = b.end - a.end, displacement = to - from;
    double sagitta = a.sagitta() + b.sagitta();
    if (a.until() < 1 || b.until() < 1) sagitta += length(displacement); // the relative path is not straight
    const double reach = a.bounding_radius() + b.bounding_radius() + sagitta + within,
                 square = dot(displacement, displacement);
    const double time = square > 0 ? std::clamp(-dot(from, displacement) / square, 0.0, 1.0) : 0;
    const DVec3 nearest = from + time * displacement;
    return dot(nearest, nearest) <= reach * reach;
}

// Whether a ball misses a box: in the box's frame, its center moves straight past the box's enlarged bounds. The
// deviations of both from straight paths are added.
bool passes_box(const MovingShape& ball, const MovingShape& box, double within) {
    const Geometry& g = box.shape().geometry;
    if (g.type != ShapeType::box || ball.until() < 1 || box.until() < 1) return false;
    const DMat3 axes = math::to_matrix(box.first_rotation());
    const auto seen = [&](DVec3 d) { return DVec3{dot(axes.c0, d), dot(axes.c1, d), dot(axes.c2, d)}; };
    const DVec3 first = seen(ball.start - box.start), last = seen(ball.end - box.end);
    const double reach = ball.bounding_radius() + g.rounding + ball.sagitta() + box.sagitta() + box.turning() + within +
                         touch_tolerance(ball.half_width);
    double enters = 0, leaves = 1;
    for (int i = 0; i < 3; ++i) {
        const double limit = g.size[i] + reach, displacement = last[i] - first[i];
        if (std::fabs(first[i]) > limit && std::fabs(last[i]) > limit && first[i] * last[i] > 0) return true;
        if (displacement == 0) continue;
        const double one = (-limit - first[i]) / displacement, other = (limit - first[i]) / displacement;
        enters = std::max(enters, std::min(one, other)), leaves = std::min(leaves, std::max(one, other));
    }
    return enters > leaves;
}

SweepResult search_pair(const MovingShape& a, const MovingShape& b, Span span, const SweepQuery& asked) {
    const ShapeType type = b.shape().geometry.type;
    if (type == ShapeType::plane) return search_plane(a, b, span, asked);
    if (type == ShapeType::mesh || type == ShapeType::height_field) return search_triangles(a, b, span, asked);
    if (!is_strip(b.shape().geometry) && !balls_may_meet(a, b, asked.within)) return surely_apart;
    if (a.is_ball() && passes_box(a, b, asked.within)) return surely_apart;
    if (b.is_ball() && passes_box(b, a, asked.within)) return surely_apart;
    return search_convexes(a, b, span, asked);
}
double half_width_of(const SweptShape& a, const SweptShape& b) {
    return half_width_of(a.geometry, a.data, b.geometry, b.data);
}
double end_of(const SweptShape& a, const SweptShape& b) { return std::min(a.path.until, b.path.until); }

// Whether it is certain that no cores meet where the result is that there is no meeting. The distance of convex shapes
// in straight motion is a convex function of time, so that no touch of theirs is missed. Shapes that rotate so little
// that it moves their points by less than the tolerance can sink deeper only by as much.
bool is_certain(const SweepResult& result, const MovingShape& a, const MovingShape& b) {
    return result.is_certain || a.beside_straight() + b.beside_straight() <= sinking_part * core_depth_of(a.half_width);
}

// The answer of a search after the first one, which did not suffice: nothing is known about how near the shapes may
// come until the first one finds them.
double by_later_search(double time, Separation& known) {
    known.slack = 0;
    return time;
}

// `axis`: the direction to the other shape if the two touch.
Nearness nearness_on(const SweepResult& result, double to, DVec3 axis) {
    if (result.meeting <= to) return {std::max(result.meeting, 0.0), 0, axis, {}};
    return {result.nearest, result.gap.distance, result.gap.normal, result.gap.on_a};
}

// A ball inside a shape, with a radius of `part` times its smallest half width.
Geometry ball_inside(const MovingShape& m, float part) {
    Geometry ball;
    const float radius = part * 0.5f * smallest_extent(m.shape().geometry, m.shape().data);
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
    return {start + time * translation, turned * rotation}; // a product of two unit quaternions
}

double core_time_of_impact(const SweptShape& a, const SweptShape& b, bool is_known, double from, Separation& known) {
    known.slack = 0;
    const Layer layer = is_known ? Layer::known_core : Layer::core;
    const double to = end_of(a, b), half_width = half_width_of(a, b);
    const MovingShape first(a, layer, half_width, from, to), second(b, layer, half_width, from, to);
    if (from == 0 && to >= 1 && stay_together(first, second)) return never; // parts of a step could add up
    double time = search_pair(first, second, {from, to}, {0, 0, known}).meeting;
    // Cores that overlap at the start may sink until a ball of half their half width, or the center, meets the other.
    for (const float part : {0.5f, 0.0f}) {
        if (time != overlapped) break;
        const Geometry ball = ball_inside(first, part);
        const SweptShape inside{ball, a.data, first.inside_offset(), a.path, a.until};
        time = search_pair(MovingShape(inside, layer, half_width, from, to), second, {from, to}, {0, 0, known}).meeting;
        known.slack = 0;
    }
    return time == overlapped ? never : time;
}

double time_of_sinking(const SweptShape& a, const SweptShape& b, Held held, double from, Separation& known) {
    known.slack = 0;
    const double to = end_of(a, b), half_width = half_width_of(a, b);
    const bool is_known = held == Held::by_contact || held == Held::by_struck_contact;
    const double part = is_known ? 0.5 : 1;
    const double deeper = held == Held::by_contact ? infinity : held == Held::by_nothing ? 0 : deeper_part;
    for (const Layer layer : {Layer::inner, Layer::deep}) {
        const MovingShape first(a, layer, half_width, from, to), second(b, layer, half_width, from, to);
        const SweepResult result = search_pair(first, second, {from, to}, {0, part, known, deeper});
        const double time = result.meeting;
        if (time != overlapped)
            return time < 1 || is_certain(result, first, second)
                       ? time
                       : by_later_search(core_time_of_impact(a, b, is_known, from, known), known);
        if (held != Held::by_nothing) break; // the solver pushes the shapes apart
    }
    return by_later_search(core_time_of_impact(a, b, true, from, known), known);
}

double time_of_impact(const SweptShape& a, const SweptShape& b, Held held, double from, Separation& known) {
    known.slack = 0;
    const double to = end_of(a, b), half_width = half_width_of(a, b);
    const MovingShape first(a, Layer::impact, half_width, from, to), second(b, Layer::impact, half_width, from, to);
    const SweepResult result = search_pair(first, second, {from, to}, {0, 0, known});
    const double time = result.meeting;
    if (time == overlapped) return by_later_search(time_of_sinking(a, b, held, from, known), known);
    return time < 1 || is_certain(result, first, second)
               ? time
               : by_later_search(core_time_of_impact(a, b, false, from, known), known);
}

Nearness nearness_of(const SweptShape& a, const SweptShape& b, double within, DVec3 axis) {
    const double to = end_of(a, b), half_width = half_width_of(a, b);
    const MovingShape first(a, Layer::skin, half_width, 0, to), second(b, Layer::skin, half_width, 0, to);
    Separation known{axis};
    const SweepResult result = search_pair(first, second, {0, to}, {within, 0, known});
    return nearness_on(result, to, known.axis);
}

Nearness nearness_of(const SweptShape& a, const SweptShape& b, std::span<const std::uint32_t> triangles,
                     double within) {
    const double to = end_of(a, b), half_width = half_width_of(a, b);
    const MovingShape first(a, Layer::skin, half_width, 0, to), second(b, Layer::skin, half_width, 0, to);
    Separation known;
    SweepResult best;
    bool overlaps = false;
    SweptCore core(first, {0, to});
    with_surface(b, [&](const auto& surface) {
        for (const std::uint32_t index : triangles)
            meet_triangle(core, first, second, triangle_of(surface, index), {0, to}, {within, 0, known}, best,
                          overlaps);
    });
    if (overlaps) best.meeting = overlapped;
    return nearness_on(best, to, known.axis);
}

} // namespace cairn
