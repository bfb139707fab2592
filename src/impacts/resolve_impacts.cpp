#include "impacts/resolve_impacts.h"

#include "bodies/bodies.h"
#include "bodies/motion_budget.h"
#include "contacts/pairs.h"
#include "impacts/impact_law.h"
#include "impacts/impact_report.h"
#include "impacts/meeting_points.h"
#include "impacts/movers.h"
#include "impacts/passed_triggers.h"
#include "impacts/rebounds.h"
#include "impacts/swept_pairs.h"
#include "islands/islands.h"

#include <algorithm>

namespace cairn {

using math::dot;
using math::DVec3;
using math::to_double;

namespace {

constexpr int pairs_per_chunk = 16, questions_per_chunk = 4; // for threads: first pass over all pairs; after an impact
// Greatest number of impacts of one body in a step. A body with more is in a narrow space or wedged in; it is stopped.
constexpr int max_impacts = 64;

class ImpactQueue {
  public:
    ImpactQueue(const ImpactContext& s, StepScratch& step, float dt)
        : s(s), step(step), dt_(dt),
          movers_({s.settings, s.islands, s.fields, s.bodies, s.shapes, s.broad_phase, s.clamped_speeds},
                  step.solver.sweep, dt),
          assemblies_(s.bodies, s.joints, step.solver.sweep),
          pairs_({s.bodies, s.shapes, s.contacts, s.islands, s.joints, s.broad_phase, step.narrow,
                  step.solver.of_batches, step.solver.fast, step.solver.strayed, *step.thread_pool, s.ranks},
                 step.solver.sweep, movers_, assemblies_) {
        meetings_.clear(), asked_.clear();
    }
    void run() {
        std::vector<std::int32_t>& bodies = step.solver.sweep.bodies;
        bodies = step.solver.fast;
        for (const std::uint32_t id : step.narrow.in_flight) {
            bodies.push_back(std::int32_t(s.contacts.info[id].body_a));
            if (s.contacts.info[id].b_moves) bodies.push_back(std::int32_t(s.contacts.info[id].body_b));
        }
        movers_.add(bodies, *step.thread_pool);
        for (const std::int32_t b : step.solver.fast) movers_[movers_.of_body(b)].is_fast = true;
        for (const std::int32_t b : step.solver.strayed) movers_[movers_.of_body(b)].has_strayed = true;
        pairs_.find();
        for (std::int32_t i = 0; i < movers_.count(); ++i)
            if (movers_[i].first_pair != none) movers_.follow_parabola(i);
        for (std::int32_t i = 0; i < movers_.count(); ++i)
            if (movers_[i].is_redirected) pairs_.find_near(i, 0);
        s.statistics.swept_pairs += std::size_t(pairs_.count());
        step.thread_pool->for_chunks(int(pairs_.count()), pairs_per_chunk, [&](int begin, int end, int) {
            for (int k = begin; k < end; ++k) pairs_[k].time = pairs_.time_of(pairs_[k], 0);
        });
        for (std::int32_t k = 0; k < pairs_.count(); ++k) expect(k);
        for (std::int32_t i = 0; i < movers_.count(); ++i) expect_renewal(i);
        while (!meetings_.empty()) {
            std::pop_heap(meetings_.begin(), meetings_.end());
            const Meeting m = meetings_.back();
            meetings_.pop_back();
            if (m.pair == none)
                renew(std::int32_t(m.shape), m.time);
            else if (m.time == pairs_[m.pair].time) // otherwise the time was recomputed since then
                meet(m.pair, m.time);
        }
        report_passed_triggers(s.bodies, s.shapes, movers_, step.solver.sweep, scratch_, s.events, dt_);
        s.statistics.stopped_bodies += movers_.write_final_poses();
        std::erase_if(step.solver.escaped, [&](const NewBounds& e) { // the broad phase has their bounds already
            return movers_.is_put_back(s.shapes.links[e.shape].body);
        });
    }

  private:
    void expect(std::int32_t k) {
        const SweptPair& pair = pairs_[k];
        if (!(pair.time < 1)) return;
        meetings_.push_back({pair.time, pair.shape, pair.other, k});
        std::push_heap(meetings_.begin(), meetings_.end());
    }

    // Schedules a new path for a mover whose path ends before the step does.
    void expect_renewal(std::int32_t i) {
        if (!(movers_[i].path.until < 1)) return;
        meetings_.push_back({movers_[i].path.until, std::uint32_t(i), 0, none});
        std::push_heap(meetings_.begin(), meetings_.end());
    }
    void renew(std::int32_t i, double time) {
        if (movers_[i].path.until != time || movers_[i].has_stopped()) return;
        go_to_next_part(i, time);
        expect_renewal(i);
        recompute_times(i, time); // no new pairs: its path was searched up to the end of the step
    }

    // Records the path that a mover took until it is redirected.
    void end_path(std::int32_t i, double time) {
        step.solver.sweep.pieces.push_back({i, movers_[i].path, std::min(time, movers_[i].until)});
    }

    void go_to_next_part(std::int32_t i, double time) {
        end_path(i, time);
        if (movers_[i].is_guided)
            movers_.advance_along_arc(i, time);
        else
            movers_.redirect(i, time, movers_.state_at(i, time));
    }

    void meet(std::int32_t k, double time) {
        if (is_worn_out(pairs_[k].first) || is_worn_out(pairs_[k].second)) return end(k, time);
        if (is_jointed(pairs_[k].shape) || is_jointed(pairs_[k].other)) return meet_jointed(k, time);
        if (collide(k, time)) return;
        if (is_kinematic(pairs_[k].other) && pairs_[k].has_stayed) return carry(k, time);
        // The bodies touch and nothing approaches: the next meeting is when they sink deeper.
        pairs_[k].touches = pairs_[k].has_stayed = true;
        for (const std::int32_t i : {pairs_[k].first, pairs_[k].second})
            if (i != none) ++movers_[i].impacts;
        pairs_[k].time = pairs_.time_of(pairs_[k], time);
        expect(k);
    }
    void meet_jointed(std::int32_t k, double time) {
        if (is_held(pairs_[k].shape) || is_held(pairs_[k].other)) return end(k, time);
        const std::int32_t body_b = s.shapes.links[pairs_[k].other].body;
        if (pairs_[k].second == none && (is_jointed(pairs_[k].other) || can_go_on(body_b)))
            expect_renewal(mover_at(body_b, time));
        go_on_straight(k, time);
    }
    // Whether joints hold a body in place, or together with one that does not move in this step any more.
    bool is_held(std::uint32_t shape) {
        const std::int32_t body = s.shapes.links[shape].body, i = movers_.of_body(body);
        return is_jointed(shape) && !(i == none ? can_move_as_a_whole(body) : can_go_straight(i));
    }
    // The bodies go no farther.
    void end(std::int32_t k, double time) {
        if (is_kinematic(pairs_[k].other)) return carry(k, time);
        for (const std::int32_t i : {pairs_[k].first, pairs_[k].second}) stop(i, time);
    }
    bool is_kinematic(std::uint32_t shape) const {
        return s.bodies.settings[s.shapes.links[shape].body].type == BodyType::kinematic;
    }
    // Joints act in the solver only, so impacts on jointed bodies are left to the next step.
    bool is_jointed(std::uint32_t shape) const {
        const std::int32_t b = s.shapes.links[shape].body;
        return s.bodies.is_dynamic(b) && s.bodies.links[b].joint_count > 0;
    }
    // Whether the first body of a pair was carried along by the other one, and since then nothing has struck it, even
    // if another body carries it by now.
    bool is_carried(const SweptPair& pair) const { return pair.was_carried && movers_[pair.first].carrier != none; }
    // A body that would stop at a kinematic body is carried along by it.
    void carry(std::int32_t k, double time) {
        const std::int32_t i = pairs_[k].first;
        if (movers_[i].has_stopped()) return;
        end_path(i, time);
        movers_.carry(i, time, s.shapes.links[pairs_[k].other].body, pairs_[k].known.axis);
        pairs_[k].was_carried = true;
        expect_renewal(i);
        pairs_.find_near(i, time);
        recompute_times(i, time);
    }
    bool is_worn_out(std::int32_t i) const { return i != none && movers_[i].impacts >= max_impacts; }

    // Stops all bodies of an assembly together, so that its joints stay closed.
    void stop(std::int32_t i, double time) {
        if (i == none || movers_[i].has_stopped()) return;
        assemblies_.for_each_beside(movers_[i].body, [&](std::int32_t body) {
            const std::int32_t k = mover_at(body, time);
            if (movers_[k].has_stopped()) return;
            movers_.stop(k, time);
            recompute_times(k, time);
        });
    }
    // Mover of a body, which is created if necessary and advanced to the time.
    std::int32_t mover_at(std::int32_t body, double time) {
        const std::int32_t i = pairs_.add_mover(body);
        while (movers_[i].path.until < time) go_to_next_part(i, movers_[i].path.until);
        return i;
    }

    // Recomputes the times of all pairs of a mover.
    void recompute_times(std::int32_t i, double time) {
        pairs_.for_each_of(i, [&](std::int32_t k) { ask(k); });
        answer(time);
    }
    // Notes that the time of a pair must be recomputed, unless it cannot meet any more.
    void ask(std::int32_t k) {
        SweptPair& pair = pairs_[k];
        if (pair.is_asked) return;
        pair.time = never;
        const bool ends =
            movers_[pair.first].has_stopped() && (pair.second == none || movers_[pair.second].has_stopped());
        if (ends || is_carried(pair)) return;
        pair.is_asked = true;
        asked_.push_back(k);
    }
    // Recomputes the noted times. Each computation reads only the two bodies of its pair.
    void answer(double time) {
        step.thread_pool->for_chunks(int(asked_.size()), questions_per_chunk, [&](int begin, int end, int) {
            for (int n = begin; n < end; ++n) {
                SweptPair& pair = pairs_[asked_[std::size_t(n)]];
                pair.time = pairs_.time_of(pair, time);
                pair.is_asked = false;
            }
        });
        for (const std::int32_t k : asked_) expect(k);
        asked_.clear();
    }

    bool can_go_on(std::int32_t b) const {
        return s.bodies.is_dynamic(b) && is_on_its_own(s.bodies, s.islands, b) && s.bodies.links[b].joint_count == 0;
    }

    MovingState state_of(std::int32_t mover, std::int32_t body, double time) const {
        if (mover != none) {
            MovingState now = movers_.state_at(mover, time);
            if (movers_[mover].has_stopped()) now.v = now.w = {};
            return now;
        }
        const RigidPath::Pose pose = movers_.path_of(body).at(time);
        const BodyMotion& motion = s.bodies.motion[body];
        return {pose.x, pose.q, to_double(motion.v), to_double(motion.w)};
    }
    // The same with the velocities along the path.
    MovingState on_path(std::int32_t mover, std::int32_t body, double time) const {
        MovingState now = state_of(mover, body, time);
        if (mover != none && movers_[mover].has_stopped()) return now;
        const RigidPath path = mover != none ? movers_[mover].path : movers_.path_of(body);
        now.v = (1 / double(dt_)) * path.translation, now.w = (1 / double(dt_)) * path.turn;
        return now;
    }
    ImpactBody impact_body(std::int32_t mover, std::int32_t body, const MovingState& now) const {
        ImpactBody b{now.x, now.v, now.w, 0, {}};
        if (!s.bodies.is_dynamic(body) || (mover != none && movers_[mover].has_stopped())) return b;
        const BodyMass& mass = s.bodies.mass[body];
        b.inverse_mass = double(mass.inverse_mass);
        const math::DMat3 axes = math::to_matrix(now.q * to_double(mass.principal));
        b.inverse_inertia = math::rotated_diagonal(axes, to_double(mass.inverse_inertia));
        return b;
    }

    double half_width_of(std::uint32_t shape, std::uint32_t other) const {
        return cairn::half_width_of(s.shapes.geometry[shape], s.shapes.data[shape], s.shapes.geometry[other],
                                    s.shapes.data[other]);
    }
    // Index of a body in the lists of the impact. A body that no impact moves has an entry for each pair, because its
    // surface velocity differs.
    std::int32_t add_struck(std::int32_t mover, std::int32_t body, double time) {
        for (std::size_t i = 0; mover != none && i < struck_.size(); ++i)
            if (struck_[i].mover == mover) return std::int32_t(i);
        const MovingState now = state_of(mover, body, time);
        struck_.push_back({mover, body, now.q, now.v, now.w, {}});
        bodies_.push_back(impact_body(mover, body, now));
        return std::int32_t(struck_.size()) - 1;
    }
    MovingState state_of_struck(std::int32_t i) const {
        const StruckBody& body = struck_[std::size_t(i)];
        return {bodies_[std::size_t(i)].x, body.rotation, body.v, body.w};
    }
    void add_touching(const SweptPair& pair, double time, bool rests) {
        const std::int32_t a = add_struck(pair.first, s.shapes.links[pair.shape].body, time),
                           b = add_struck(pair.second, s.shapes.links[pair.other].body, time);
        const MovingState now_a = state_of_struck(a), now_b = state_of_struck(b);
        const std::size_t before = points_.size();
        find_meeting_points(s.bodies, s.shapes, pair.shape, now_a, pair.other, now_b, pair.known.axis, scratch_,
                            points_);
        const std::span<ImpactPoint> points = std::span(points_).subspan(before);
        if (!rests) set_rebounds(movers_, s.shapes, pair, now_a, now_b, points);
        for (ImpactPoint& point : points)
            point.material =
                material_at(s.shapes, pair.shape, pair.other, point.surface_material, s.settings.restitution_speed);
        touching_.push_back({a, b, int(points.size()), rests});
        for (const auto& [place, shape] : {std::pair(a, pair.shape), std::pair(b, pair.other)}) {
            const DVec3 belt = surface_velocity(s.bodies, s.shapes, shape, points);
            struck_[std::size_t(place)].belt += belt, bodies_[std::size_t(place)].v += belt;
        }
    }
    // Gathers the two bodies that meet, and those that they have met in this step and rest on.
    void gather_struck(const SweptPair& pair, std::int32_t k, double time) {
        struck_.clear(), bodies_.clear(), touching_.clear(), points_.clear();
        add_touching(pair, time, false);
        if (points_.empty()) return;
        for (const std::int32_t i : {pair.first, pair.second}) {
            if (i == none || movers_[i].has_stopped()) continue;
            pairs_.for_each_of(i, [&](std::int32_t other) {
                const SweptPair& p = pairs_[other];
                const bool is_listed = i == pair.second && (p.first == pair.first || p.second == pair.first);
                if (other != k && !is_listed && p.rests && p.touches) add_touching(p, time, true);
            });
        }
    }

    // Resolves an impact. Returns false if nothing approaches.
    bool collide(std::int32_t k, double time) {
        const std::int32_t body_b = s.shapes.links[pairs_[k].other].body;
        if (pairs_[k].second == none && can_go_on(body_b)) expect_renewal(mover_at(body_b, time));
        const SweptPair pair = pairs_[k];
        gather_struck(pair, k, time);
        ImpactOutcome outcome = cairn::collide(bodies_, touching_, points_, buffer_);
        // An approach too small to be noticed in the rest of the step is due to forces, and is no impact. For a pair
        // that meets for the first time it is measured over a whole step, as the rest of this one may be very short.
        const double time_to_see = pair.has_begun || pair.rests ? (1 - time) * double(dt_) : double(dt_);
        const bool is_impact = outcome.approach * time_to_see > impact_tolerance(half_width_of(pair.shape, pair.other));
        // Spins beyond the world's limit are clamped; linear velocities alone then stop the approach that remains.
        if (is_impact) {
            bool was_cut = false;
            for (ImpactBody& body : bodies_) was_cut |= cut_spin(body, double(s.settings.max_angular_speed));
            if (was_cut) cairn::collide(bodies_, touching_, points_, buffer_);
        }
        if (is_impact) pairs_[k].touches = !outcome.bounces;
        changed_.clear();
        if (!is_impact && (!(outcome.approach > 0) || pair.rests)) {
            if (!separate_paths(k, time)) return false;
            follow(time);
            return true;
        }
        if (is_impact) {
            ++s.statistics.impacts;
            report_impact(s, step.solver, pair, outcome, time * double(dt_));
            pairs_[k].has_begun = true;
        } else {
            outcome.normal = points_.front().normal;
        }
        if (!outcome.bounces) {
            pairs_[k].rests = true;
            movers_.rest_on(pair.first, outcome.normal);
            if (pair.second != none) movers_.rest_on(pair.second, -outcome.normal);
        }
        for (std::size_t i = 0; i < struck_.size(); ++i) go_on(i, time);
        separate_paths(k, time);
        follow(time);
        return true;
    }

    // A body moved by the solver goes straight from its first to its last pose, not at its final velocity: two bodies
    // whose velocities do not approach may still come nearer on their paths. The paths are then separated as by an
    // impact without bounce. Returns false if they do not come nearer.
    bool separate_paths(std::int32_t k, double time) {
        const SweptPair pair = pairs_[k];
        if (points_.empty() || (!is_moved_by_solver(pair.first) && !is_moved_by_solver(pair.second))) return false;
        const auto moving_body = [&](std::int32_t mover, std::uint32_t shape) {
            const std::int32_t body = s.shapes.links[shape].body;
            return impact_body(mover, body, on_path(mover, body, time));
        };
        const ImpactBody before[] = {moving_body(pair.first, pair.shape), moving_body(pair.second, pair.other)};
        ImpactBody after[] = {before[0], before[1]};
        const ImpactPair smooth{0, 1, touching_.front().points};
        for (int i = 0; i < smooth.points; ++i)
            points_[std::size_t(i)].rebound = 0, points_[std::size_t(i)].material = {};
        const ImpactOutcome outcome = cairn::collide(after, std::span(&smooth, 1), points_, buffer_);
        if (!(outcome.approach * (1 - time) * double(dt_) > impact_tolerance(half_width_of(pair.shape, pair.other))))
            return false;
        pairs_[k].touches = true;
        // A free body has the same velocity on its path and at the end, so its change must be taken from the other
        // body.
        const bool one_is_free = is_free(pair.first) || is_free(pair.second);
        push(pair.first, time, after[0].v - before[0].v, after[0].w - before[0].w, one_is_free);
        push(pair.second, time, after[1].v - before[1].v, after[1].w - before[1].w, one_is_free);
        return true;
    }
    bool is_free(std::int32_t i) const { return i != none && movers_[i].is_free; }
    bool is_moved_by_solver(std::int32_t i) const {
        return i != none && !movers_[i].is_free && !movers_[i].is_guided && !movers_[i].has_stopped();
    }
    void push(std::int32_t i, double time, DVec3 dv, DVec3 dw, bool and_velocity) {
        if (i == none || movers_[i].has_stopped()) return;
        end_path(i, time);
        movers_.push_path(i, time, dv, dw, and_velocity);
        ++movers_[i].impacts;
        note_changed(i);
    }
    void note_changed(std::int32_t i) {
        expect_renewal(i);
        if (std::find(changed_.begin(), changed_.end(), i) == changed_.end()) changed_.push_back(i);
    }

    // Searches near the new paths of redirected movers, and recomputes their pairs: all, or those that are not known to
    // stay apart.
    void follow(double time, bool only_unknown = false) {
        for (const std::int32_t i : changed_) pairs_.find_near(i, time);
        for (const std::int32_t i : changed_)
            pairs_.for_each_of(i, [&](std::int32_t k) {
                if (!only_unknown || !(pairs_[k].known.slack > 0)) ask(k);
            });
        answer(time);
    }

    // Joints act in the solver only, so an impact on jointed bodies is left to the next step. Until then what joints
    // connect goes on as a whole without turning, so that the joints stay closed, with the velocity of its center of
    // mass after an impact of two masses. Does nothing if the two come nearer by less than the depth of a core.
    void go_on_straight(std::int32_t k, double time) {
        const SweptPair pair = pairs_[k];
        const std::int32_t body_a = s.shapes.links[pair.shape].body, body_b = s.shapes.links[pair.other].body;
        points_.clear();
        find_meeting_points(s.bodies, s.shapes, pair.shape, state_of(pair.first, body_a, time), pair.other,
                            state_of(pair.second, body_b, time), pair.known.axis, scratch_, points_);
        const MovingState a = on_path(pair.first, body_a, time), b = on_path(pair.second, body_b, time);
        double approach = 0;
        for (const ImpactPoint& p : points_)
            approach = std::max(approach, dot(p.normal, a.v - b.v + math::cross(a.w, p.position - a.x) -
                                                            math::cross(b.w, p.position - b.x)));
        pairs_[k].touches = true;
        const double nearer = approach * (1 - time) * double(dt_);
        if (!(nearer > core_depth_of(half_width_of(pair.shape, pair.other)))) return;
        const auto moving_body = [&](std::int32_t mover, std::int32_t body, const MovingState& now) {
            if (!can_go_straight(mover)) return ImpactBody{now.x, now.v, now.w, 0, {}};
            return ImpactBody{now.x, velocity_of_assembly(body, time), {}, assemblies_.inverse_mass(body), {}};
        };
        ImpactBody both[] = {moving_body(pair.first, body_a, a), moving_body(pair.second, body_b, b)};
        const ImpactPair smooth{0, 1, int(points_.size())};
        cairn::collide(both, std::span(&smooth, 1), points_, buffer_);
        changed_.clear();
        go_on_straight(pair.first, time, both[0].v);
        go_on_straight(pair.second, time, both[1].v);
        follow(time, true);
    }
    bool can_go_straight(std::int32_t i) {
        return i != none && !movers_[i].has_stopped() && movers_[i].carrier == none &&
               can_move_as_a_whole(movers_[i].body);
    }
    // Whether a body and those that joints connect with it are free to move.
    bool can_move_as_a_whole(std::int32_t body) {
        return is_awake(s.bodies, s.islands, body) && assemblies_.inverse_mass(body) > 0;
    }
    // Mean velocity of the center of mass of what joints connect with a body, on the rest of the paths.
    DVec3 velocity_of_assembly(std::int32_t body, double time) {
        DVec3 momentum{};
        assemblies_.for_each_beside(body, [&](std::int32_t member) {
            const double mass = 1 / double(s.bodies.mass[member].inverse_mass);
            momentum += mass * movers_.mean_velocity(mover_at(member, time), time);
        });
        return assemblies_.inverse_mass(body) * momentum;
    }
    void go_on_straight(std::int32_t i, double time, DVec3 velocity) {
        if (!can_go_straight(i)) return;
        ++movers_[i].impacts;
        assemblies_.for_each_beside(movers_[i].body, [&](std::int32_t body) {
            const std::int32_t member = mover_at(body, time);
            end_path(member, time);
            const DVec3 more = ((1 - time) * double(dt_)) * (velocity - movers_.mean_velocity(member, time));
            const bool keeps_shape = movers_.go_straight(member, time, velocity);
            pairs_.for_each_of(member, [&](std::int32_t k) {
                Separation& known = pairs_[k].known;
                const double nearer = dot(known.axis, pairs_[k].first == member ? more : -more);
                known.slack = keeps_shape ? std::max(known.slack - std::max(nearer, 0.0), 0.0) : 0;
            });
            note_changed(member);
        });
    }

    // Continues a body with its velocities after the impact.
    void go_on(std::size_t struck, double time) {
        const std::int32_t mover = struck_[struck].mover, body = struck_[struck].body;
        if (!s.bodies.is_dynamic(body) || (mover != none && movers_[mover].has_stopped())) return;
        MovingState now = state_of_struck(std::int32_t(struck));
        const DVec3 v = bodies_[struck].v - struck_[struck].belt, w = bodies_[struck].w;
        const bool is_of_the_two = struck < 2;
        if (!is_of_the_two && v == now.v && w == now.w) return;
        now.v = v, now.w = w;
        if (!is_awake(s.bodies, s.islands, body)) wake_body(s.bodies, s.islands, s.events, body);
        if (mover == none) { // asleep, or on joints, which act in the next step
            s.bodies.motion[body].v = math::to_float(now.v), s.bodies.motion[body].w = math::to_float(now.w);
            s.bodies.links[body].quiet_time = 0;
            return;
        }
        end_path(mover, time);
        movers_.redirect(mover, time, now);
        if (is_of_the_two) ++movers_[mover].impacts;
        note_changed(mover);
    }

    const ImpactContext s;
    StepScratch& step;
    const float dt_;
    Movers movers_;
    Assemblies assemblies_;
    SweptPairs pairs_;
    std::vector<std::int32_t>& asked_ = step.solver.sweep.asked;
    std::vector<Meeting>& meetings_ = step.solver.sweep.meetings;
    NarrowBatch& scratch_ = step.narrow.at_work.front();
    std::vector<ImpactPoint>& points_ = step.solver.sweep.points;
    std::vector<StruckBody>& struck_ = step.solver.sweep.struck; // the first two are the bodies that meet
    std::vector<ImpactBody>& bodies_ = step.solver.sweep.struck_motions;
    std::vector<ImpactPair>& touching_ = step.solver.sweep.touching;
    std::vector<std::int32_t>& changed_ = step.solver.sweep.changed;
    ImpactBuffer& buffer_ = step.solver.sweep.impact;
};

} // namespace

void resolve_impacts(const ImpactContext& s, StepScratch& step, float dt) {
    if (!step.solver.fast.empty() || !step.narrow.in_flight.empty() || !s.bodies.kinematics.empty())
        ImpactQueue(s, step, dt).run();
    s.broad_phase.set_bounds(step.solver.escaped, *step.thread_pool);
}

} // namespace cairn
