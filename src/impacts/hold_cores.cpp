#include "impacts/hold_cores.h"

#include "bodies/bodies.h"
#include "bodies/finalize.h"
#include "bodies/integrators.h"
#include "bodies/motion_budget.h"
#include "collision/core_sweep.h"
#include "state/joint_links.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace cairn {

using math::DVec3;

namespace {

constexpr int pairs_per_chunk = 16; // for threads

// Where a body was at the start of the pass.
CountedPose pose_before(const State& s, std::int32_t b) {
    if (s.bodies.settings[b].type == BodyType::kinematic || is_awake(s.bodies, s.islands, b))
        return s.bodies.counted[b];
    return {s.bodies.motion[b].x, s.bodies.motion[b].q};
}
// Whether its poses do not say how it turned. Of such a body the ball that is in it however it lies is held.
bool turns_over(const State& s, std::int32_t b, float dt) {
    return math::length(s.bodies.motion[b].w) * dt > half_turn;
}
RigidPath path_of(const State& s, std::int32_t b, float dt) {
    const CountedPose from = pose_before(s, b);
    const BodyMotion& to = s.bodies.motion[b];
    return RigidPath::between(from.x, from.q, to.x, turns_over(s, b, dt) ? from.q : to.q);
}

// About the center of mass.
Geometry inner_ball(const State& s, std::int32_t b) {
    Geometry ball;
    ball.size = {s.bodies.links[b].inner_radius, s.bodies.links[b].inner_radius, s.bodies.links[b].inner_radius};
    ball.bounding_radius = s.bodies.links[b].inner_radius;
    ball.position = s.bodies.mass[b].center;
    return ball;
}

class CoreHolder {
  public:
    CoreHolder(State& state, StepScratch& step, float dt) : s(state), step(step), dt_(dt) {
        if (place_.size() < s.bodies.links.size()) place_.resize(s.bodies.links.size(), none);
        fast_.clear(), paths_.clear(), pairs_.clear(), meetings_.clear();
    }
    void run() {
        for (const std::int32_t b : step.solver.fast) add(b);
        find_expected();
        find_unexpected();
        sort_pairs();
        s.statistics.swept_pairs += pairs_.size();
        step.thread_pool->for_chunks(int(pairs_.size()), pairs_per_chunk, [&](int begin, int end, int) {
            for (int k = begin; k < end; ++k) pairs_[std::size_t(k)].time = time_of(pairs_[std::size_t(k)], 0);
        });
        stop_in_order();
        for (std::size_t i = 0; i < fast_.size(); ++i)
            if (fast_[i].has_stopped()) put_back(std::int32_t(i));
        for (const FastBody& f : fast_) place_[std::size_t(f.body)] = none;
    }

  private:
    void add(std::int32_t b) {
        place_[std::size_t(b)] = std::int32_t(fast_.size());
        fast_.push_back({b, uncounted(pose_before(s, b), s.bodies.motion[b], s.bodies.links[b].radius)});
    }
    void make_path(std::int32_t fast) {
        FastBody& f = fast_[std::size_t(fast)];
        if (f.path != none) return;
        f.path = std::int32_t(paths_.size());
        paths_.push_back(path_of(s, f.body, dt_));
    }
    const RigidPath& path(const FastBody& f) const { return paths_[std::size_t(f.path)]; }
    DBounds bounds_of_way(const FastBody& f) const {
        const DVec3 from = s.bodies.counted[f.body].x, to = s.bodies.motion[f.body].x;
        const double r = double(s.bodies.links[f.body].radius);
        DBounds bounds;
        for (int i = 0; i < 3; ++i)
            bounds.lo[i] = std::min(from[i], to[i]) - r, bounds.hi[i] = std::max(from[i], to[i]) + r;
        return bounds;
    }

    bool may_collide(std::uint32_t a, std::uint32_t b) const {
        const std::int32_t body_a = s.shapes.links[a].body, body_b = s.shapes.links[b].body;
        const ShapeTraits &ta = s.shapes.traits[a], &tb = s.shapes.traits[b];
        return body_a != body_b && !ta.is_trigger && !tb.is_trigger && may_meet(ta.filter, tb.filter) &&
               !joint_forbids_contact(s.bodies, s.joints, body_a, body_b);
    }
    template <class F> void for_each_shape(std::int32_t body, F&& f) const {
        for (std::int32_t k = s.bodies.links[body].first_shape; k != none; k = s.shapes.links[k].next)
            f(std::uint32_t(k));
    }

    std::int32_t fast_of(std::int32_t body) const { return place_[std::size_t(body)]; }
    void add_pair(std::int32_t a, std::uint32_t shape, std::uint32_t other, bool is_known) {
        const std::int32_t b = s.shapes.links[other].body;
        if (!may_pass(a, b, s.shapes.geometry[other])) return;
        make_path(fast_of(a));
        if (fast_of(b) != none) make_path(fast_of(b));
        pairs_.push_back({fast_of(a), fast_of(b), shape, other, never, is_known});
    }

    // Whether two bodies moved against each other so far that a core can pass, and came near each other. The first is
    // fast.
    bool may_pass(std::int32_t a, std::int32_t b, const Geometry& other) const {
        if (s.bodies.settings[b].type == BodyType::kinematic) return true;
        const double moved = fast_[std::size_t(fast_of(a))].moved + moved_by(b);
        const double inner_a = double(s.bodies.links[a].inner_radius), inner_b = double(s.bodies.links[b].inner_radius);
        if (moved <= free_share * std::min(inner_a, inner_b)) return false;
        if (other.type == ShapeType::plane || is_strip(other)) return true; // without an end
        // Along the straight way.
        const CountedPose from_a = pose_before(s, a), from_b = pose_before(s, b);
        const DVec3 start = from_b.x - from_a.x,
                    way = (s.bodies.motion[b].x - from_b.x) - (s.bodies.motion[a].x - from_a.x);
        const double square = math::dot(way, way),
                     radii = double(s.bodies.links[a].radius) + double(s.bodies.links[b].radius);
        const double time = square > 0 ? std::clamp(-math::dot(start, way) / square, 0.0, 1.0) : 0;
        const DVec3 nearest = start + time * way;
        return math::dot(nearest, nearest) <= radii * radii;
    }
    double moved_by(std::int32_t b) const {
        if (fast_of(b) != none) return fast_[std::size_t(fast_of(b))].moved;
        return is_awake(s.bodies, s.islands, b) ? free_share * double(s.bodies.links[b].inner_radius) : 0; // at most
    }

    // Pairs that the narrow phase had before it, but for those that it knew to stay apart.
    void find_expected() {
        for (const std::uint32_t k : step.narrow.open) {
            const std::uint32_t id = step.narrow.candidates[k];
            const PairAnswer& answer = s.contacts.answers[id];
            const bool a_is_fast = fast_of(answer.body_a) != none;
            if (!a_is_fast && fast_of(answer.body_b) == none) continue;
            const ContactInfo& c = s.contacts.info[id];
            if (c.is_trigger) continue;
            const bool is_known = is_group(c) ? c.related != none : c.point_count > 0;
            if (a_is_fast)
                add_pair(answer.body_a, c.shape_a, c.shape_b, is_known);
            else
                add_pair(answer.body_b, c.shape_b, c.shape_a, is_known);
        }
    }

    // All that is near the ways of bodies that are not where they were expected.
    void find_unexpected() {
        if (step.solver.strayed.empty()) return;
        std::vector<FastWay>& ways = step.solver.sweep.ways;
        ways.clear();
        double widest = 0;
        for (std::size_t i = 0; i < fast_.size(); ++i) {
            make_path(std::int32_t(i));
            const DBounds bounds = bounds_of_way(fast_[i]);
            ways.push_back({bounds.lo.x, fast_[i].body, bounds});
            widest = std::max(widest, bounds.hi.x - bounds.lo.x);
        }
        const auto is_listed = [&, count = std::int32_t(ways.size())](std::int32_t body) {
            return fast_of(body) != none && fast_of(body) < count;
        };
        std::sort(ways.begin(), ways.end());
        for (const std::int32_t body : step.solver.strayed) {
            const DBounds bounds = bounds_of_way(fast_[std::size_t(fast_of(body))]);
            const auto try_shape = [&](std::uint32_t other) {
                if (!may_pass(body, s.shapes.links[other].body, s.shapes.geometry[other])) return;
                for_each_shape(body, [&](std::uint32_t shape) {
                    if (may_collide(shape, other)) add_pair(body, shape, other, false);
                });
            };
            s.broad_phase.query_bounds(bounds, [&](std::uint32_t other) {
                if (!is_listed(s.shapes.links[other].body)) try_shape(other);
            });
            const auto begins_before = [](const FastWay& w, double x) { return w.begin < x; };
            auto k = std::lower_bound(ways.begin(), ways.end(), bounds.lo.x - widest, begins_before);
            for (; k != ways.end() && k->begin <= bounds.hi.x; ++k)
                if (k->body != body && meet(bounds, k->bounds)) for_each_shape(k->body, try_shape);
        }
    }

    // Of what was found twice, one stays: that which is known to the solver, if any.
    void sort_pairs() {
        for (FastPair& p : pairs_)
            if (p.second != none && p.other < p.shape) std::swap(p.first, p.second), std::swap(p.shape, p.other);
        const auto key = [](const FastPair& p) { return std::tuple(p.shape, p.other, !p.is_known); };
        std::sort(pairs_.begin(), pairs_.end(), [&](const FastPair& a, const FastPair& b) { return key(a) < key(b); });
        const auto same = [](const FastPair& a, const FastPair& b) { return a.shape == b.shape && a.other == b.other; };
        pairs_.erase(std::unique(pairs_.begin(), pairs_.end(), same), pairs_.end());
    }

    double time_of(const FastPair& pair, double from) const {
        const FastBody& first = fast_[std::size_t(pair.first)];
        const auto swept = [&](std::uint32_t shape, const Geometry& g, const RigidPath& path, double until) {
            const std::int32_t body = s.shapes.links[shape].body;
            return SweptShape{g, s.shapes.data[shape], math::to_double(g.position - s.bodies.mass[body].center), path,
                              until};
        };
        const auto swept_fast = [&](const FastBody& f, std::uint32_t shape, const RigidPath& path, Geometry& ball) {
            const bool is_ball = turns_over(s, f.body, dt_);
            if (is_ball) ball = inner_ball(s, f.body);
            return swept(shape, is_ball ? ball : s.shapes.geometry[shape], path, f.until);
        };
        // Seen from the first, for precision far from the origin.
        const DVec3 origin = path(first).start;
        const auto seen = [&](RigidPath p) {
            p.start = p.start - origin;
            return p;
        };
        Geometry ball_a, ball_b;
        const RigidPath path_a = seen(path(first));
        const SweptShape a = swept_fast(first, pair.shape, path_a, ball_a);
        if (pair.second != none) {
            const FastBody& second = fast_[std::size_t(pair.second)];
            const RigidPath path_b = seen(path(second));
            return time_of_meeting(a, swept_fast(second, pair.other, path_b, ball_b), pair.is_known, from);
        }
        const RigidPath path_b = seen(path_of(s, s.shapes.links[pair.other].body, dt_));
        return time_of_meeting(a, swept(pair.other, s.shapes.geometry[pair.other], path_b, 1), pair.is_known, from);
    }

    // The earliest meeting stops both bodies. Then their pairs are asked again, as what moves on may meet what stands,
    // and so on. No body stops twice, and what happened up to then is not changed.
    void stop_in_order() {
        for (std::size_t k = 0; k < pairs_.size(); ++k) expect(k);
        if (meetings_.empty()) return;
        list_pairs_of_bodies();
        while (!meetings_.empty()) {
            std::pop_heap(meetings_.begin(), meetings_.end());
            const Meeting m = meetings_.back();
            meetings_.pop_back();
            const FastPair pair = pairs_[m.pair];
            if (m.time != pair.time) continue; // it was asked again
            for (const std::int32_t i : {pair.first, pair.second}) {
                if (i == none || fast_[std::size_t(i)].has_stopped()) continue;
                fast_[std::size_t(i)].until = m.time;
                ask_again(i);
            }
        }
    }
    void expect(std::size_t k) {
        if (!(pairs_[k].time < 1)) return;
        meetings_.push_back({pairs_[k].time, k});
        std::push_heap(meetings_.begin(), meetings_.end());
    }

    void list_pairs_of_bodies() {
        first_pair_.assign(fast_.size() + 1, 0);
        const auto for_each_end = [&](auto&& f) {
            for (std::size_t k = 0; k < pairs_.size(); ++k)
                for (const std::int32_t i : {pairs_[k].first, pairs_[k].second})
                    if (i != none) f(std::size_t(i), k);
        };
        for_each_end([&](std::size_t i, std::size_t) { ++first_pair_[i + 1]; });
        std::partial_sum(first_pair_.begin(), first_pair_.end(), first_pair_.begin());
        pairs_of_.resize(first_pair_.back());
        std::vector<std::size_t>& next = step.solver.sweep.next_pair;
        next = first_pair_;
        for_each_end([&](std::size_t i, std::size_t k) { pairs_of_[next[i]++] = k; });
    }

    // The pairs of what has just stopped, with what still moves.
    void ask_again(std::int32_t i) {
        for (std::size_t k = first_pair_[std::size_t(i)]; k < first_pair_[std::size_t(i) + 1]; ++k) {
            FastPair& pair = pairs_[pairs_of_[k]];
            pair.time = never;
            const bool ends = fast_[std::size_t(pair.first)].has_stopped() &&
                              (pair.second == none || fast_[std::size_t(pair.second)].has_stopped());
            if (ends) continue;
            pair.time = time_of(pair, fast_[std::size_t(i)].until);
            expect(pairs_of_[k]);
        }
    }

    void put_back(std::int32_t fast) {
        make_path(fast);
        const FastBody& f = fast_[std::size_t(fast)];
        BodyMotion& motion = s.bodies.motion[f.body];
        const RigidPath::Pose pose = path(f).at(f.until);
        give_back_work(f.body, motion.x - pose.x);
        motion.x = pose.x;
        if (!turns_over(s, f.body, dt_)) {
            motion.turned = math::to_float(pose.q * math::conjugate(s.bodies.counted[f.body].q));
            motion.q = pose.q;
        }
        place_again(s.bodies, s.shapes, s.broad_phase, f.body, dt_);
        ++s.statistics.stopped_bodies;
    }
    // Of its forces along the way that it has not gone: v^2 / 2 is less by that, per mass.
    void give_back_work(std::int32_t b, DVec3 way) {
        BodyMotion& motion = s.bodies.motion[b];
        const double inverse_mass = double(s.bodies.mass[b].inverse_mass);
        DVec3 a = field_acceleration(s.fields, s.settings, motion.x, s.bodies.settings[b].gravity_scale, inverse_mass);
        if (s.bodies.is_pushed(b)) a += inverse_mass * s.bodies.forces[b].force;
        const DVec3 v = math::to_double(motion.v);
        const double square = math::dot(v, v);
        const double left = std::clamp(square - 2 * math::dot(a, way), 0.0, square); // it gains nothing: it was pushed
        if (square > 0) motion.v = math::to_float(std::sqrt(left / square) * v);
    }

    State& s;

    StepScratch& step;
    const float dt_;
    std::vector<std::int32_t>& place_ = step.solver.sweep.place;
    std::vector<FastBody>& fast_ = step.solver.sweep.bodies;
    std::vector<RigidPath>& paths_ = step.solver.sweep.paths;
    std::vector<FastPair>& pairs_ = step.solver.sweep.pairs;
    std::vector<Meeting>& meetings_ = step.solver.sweep.meetings;
    std::vector<std::size_t>& first_pair_ = step.solver.sweep.first_pair;
    std::vector<std::size_t>& pairs_of_ = step.solver.sweep.pairs_of;
};

} // namespace

void hold_cores(State& s, StepScratch& step, float dt) {
    if (step.solver.fast.empty()) return;
    CoreHolder(s, step, dt).run();
}

} // namespace cairn
