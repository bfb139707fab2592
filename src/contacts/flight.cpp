#include "contacts/flight.h"

#include "bodies/bodies.h"
#include "bodies/integrators.h"
#include "bodies/motion_budget.h"
#include "contacts/contact_update.h"
#include "contacts/patches.h"
#include "contacts/record_owners.h"
#include "contacts/round_touch.h"
#include "contacts/shared_tests.h"
#include "contacts/touch.h"

#include <algorithm>

namespace cairn {

namespace {

constexpr int flights_per_chunk = 16; // items per chunk of a parallel loop

// Whether a body is not held by joints or sleep.
bool may_fly(const Bodies& bodies, const Islands& islands, std::int32_t b) {
    return !bodies.is_dynamic(b) || (bodies.links[b].joint_count == 0 && is_on_its_own(bodies, islands, b));
}

// How far forces move the two bodies toward each other in the step along the normal, m.
float fall_of(const NarrowInput& in, const ContactInfo& c, const Manifold& m, float dt) {
    const std::int32_t first = c.flipped ? c.body_b : c.body_a, second = c.flipped ? c.body_a : c.body_b;
    const math::DVec3 a = acceleration_at(in.bodies, in.fields, in.settings, first, in.bodies.motion[first].x) -
                          acceleration_at(in.bodies, in.fields, in.settings, second, in.bodies.motion[second].x);
    const float share = 0.5f * (1 + 1.0f / float(in.substeps)); // forces act in substeps
    return share * dt * dt * float(math::dot(a, math::to_double(math::to_vec(m.normal))));
}

// The motion of a shape's surface at the contact point. A rotation about its axis of symmetry does not move the
// surface.
struct Surface {
    math::Vec3 v, turn, arm; // m/s of the center of mass, rad/s, m from the center of mass
    math::Vec3 turning() const { return math::cross(turn, arm); }
};
Surface surface_of(const Bodies& bodies, const Shapes& shapes, std::uint32_t shape, math::Vec3 arm) {
    const BodyMotion& motion = bodies.motion[shapes.links[shape].body];
    math::Vec3 turn = motion.w;
    const ShapeType type = shapes.geometry[shape].type;
    if (type == ShapeType::sphere) turn = {};
    if (type == ShapeType::capsule || type == ShapeType::cylinder) {
        const math::Vec3 axis = math::rotate(shape_rotation(shapes.poses[shape]), math::Vec3{0, 1, 0});
        turn = turn - math::dot(turn, axis) * axis;
    }
    return {motion.v, turn, arm};
}

// How far a contact that is kept unchanged is off at the end of the step, m, as the surface `under` rotates its normal:
// half of the angle times the displacement of the other body along the surface, plus a third of the square of the angle
// times the displacement of the surface, since a body that moves straight on at the surface's velocity falls behind it.
float lag_of(const Surface& on, const Surface& under, math::Vec3 normal, float dt) {
    const float turn = dt * math::length(math::cross(under.turn, normal));
    const math::Vec3 way = on.v + on.turning() - under.v - under.turning();
    return turn * dt * (0.5f * math::length(way) + turn / 3 * math::length(under.turning()));
}

bool gyrates(const Bodies& bodies, std::int32_t b, float dt) {
    const BodyMotion& motion = bodies.motion[b];
    return bodies.is_dynamic(b) && gyrates(bodies, b, math::to_double(motion.w), motion.q, double(dt));
}

// Whether the solver tracks the contact point of a shape through all of the step: the shape is round about an axis, and
// hardly tilts. Rotation about that axis or about the normal changes nothing. `lag`: the error for an angular velocity,
// m.
template <class Lag>
bool solver_follows(const Bodies& bodies, const Shapes& shapes, PairKind kind, std::uint32_t shape, std::uint32_t other,
                    bool other_is_second, const Manifold& m, float most, float dt, Lag&& lag) {
    const math::Vec3 n = math::to_vec(m.normal);
    if (!is_followed(kind, shapes.geometry[shape], shapes.geometry[other], shapes.poses[other], m, other_is_second))
        return false;
    const std::int32_t body = shapes.links[shape].body;
    const BodyMotion& motion = bodies.motion[body];
    const math::DVec3 w = math::to_double(motion.w);
    if (!keeps_inertia(bodies, body, w, motion.q, double(dt))) return false;
    const math::Vec3 later = motion.w + dt * math::to_float(spin_change(bodies, body, w, motion.q));
    return lag(tilting_part(shapes.geometry[shape], shapes.poses[shape], later, n)) <= most;
}

// Whether one of two shapes rotates so far that their contact cannot stay as it is in a step: because its own spin
// changes (gyration), however deep the shapes overlap; or relative to the other, if they overlap by less than the core
// depth: otherwise the solver pushes them apart, while free flight would keep them as they are. This does not hold
// where the solver tracks the contact point, unless the overlap is so deep that it would throw the shapes apart.
bool turns_away(const Bodies& bodies, const Shapes& shapes, const ContactInfo& c, const Manifold& m, float overlap,
                float dt) {
    const std::uint32_t first = c.flipped ? c.shape_b : c.shape_a, second = c.flipped ? c.shape_a : c.shape_b;
    const math::Vec3 n = math::to_vec(m.normal), arm = shapes.links[first].arm + math::to_vec(m.points[0]);
    const math::DVec3 between = bodies.motion[shapes.links[first].body].x - bodies.motion[shapes.links[second].body].x;
    const Surface a = surface_of(bodies, shapes, first, arm),
                  b = surface_of(bodies, shapes, second, arm + math::to_float(between));
    const double half_width = half_width_between(shapes, c);
    const bool is_pushed = overlap >= float(core_depth_of(half_width)), is_deep = overlap >= float(0.5 * half_width);
    const auto turns = [&](std::uint32_t shape, std::uint32_t other, const Surface& under, const Surface& on) {
        const auto lag = [&](math::Vec3 turn) { return lag_of(on, {under.v, turn, under.arm}, n, dt); };
        if (!is_deep &&
            solver_follows(bodies, shapes, c.kind, shape, other, other == second, m, c.base_margin, dt, lag))
            return false;
        return gyrates(bodies, shapes.links[shape].body, dt) || (!is_pushed && lag(under.turn) > c.base_margin);
    };
    return turns(first, second, a, b) || turns(second, first, b, a);
}

// The number of contacts of a pair that are counted at its bodies so far.
int rows_of(const Contacts& contacts, std::uint32_t id) {
    int rows = 0;
    for_each_patch(contacts, id, [&](std::uint32_t contact) { rows += contacts.info[contact].point_count > 0; });
    return rows;
}

class FlightList {
  public:
    FlightList(const NarrowInput& in, const FollowUpContext& context, ThreadPool& thread_pool, float dt)
        : in(in), s(context), thread_pool_(thread_pool), dt_(dt) {}
    void run() {
        gather();
        if (flights_.empty()) return;
        decide();
        for (const FlightPair& f : flights_)
            if (f.is_free) release(f);
        test_held();
        for (const FlightPair& f : flights_)
            if (!f.is_free) follow(f);
    }

  private:
    std::uint32_t contact_of(const FlightPair& f) const { return s.narrow.candidates[f.place]; }

    void gather() {
        FlightPairs& all = s.narrow.flights;
        all.clear();
        s.narrow.in_flight.clear();
        for (NarrowBatch& own : s.narrow.at_work) {
            for (const FlightPair& f : own.flights.pairs)
                all.add(f.place, own.flights.hits.data() + f.first_hit, f.hit_count);
            own.flights.clear();
        }
        std::sort(flights_.begin(), flights_.end(),
                  [](const FlightPair& a, const FlightPair& b) { return a.place < b.place; });
    }

    // Decides which pairs are in free flight. A body with contacts besides those that may be in free flight is
    // constrained by them. Pairs of a gyrating body are in free flight even if the other body is constrained: the
    // solver would get them wrong.
    void decide() {
        std::vector<std::int32_t>& rows = s.narrow.flight_rows;
        rows.resize(s.bodies.links.size(), 0);
        const auto for_each_body = [&](auto&& f) {
            for (const FlightPair& flight : flights_) {
                const ContactInfo& c = s.contacts.info[contact_of(flight)];
                const int count = rows_of(s.contacts, contact_of(flight));
                f(c.body_a, count);
                if (c.b_moves) f(c.body_b, count);
            }
        };
        for_each_body([&](std::int32_t b, int count) { rows[b] += count; });
        const auto is_free = [&](std::int32_t b) { return s.bodies.links[b].contact_count <= rows[b]; };
        for (FlightPair& f : flights_) {
            const ContactInfo& c = s.contacts.info[contact_of(f)];
            f.is_free = (is_free(c.body_a) && (!c.b_moves || is_free(c.body_b))) ||
                        (may_turn_away(s.bodies, c, dt_) &&
                         (gyrates(s.bodies, c.body_a, dt_) || gyrates(s.bodies, c.body_b, dt_)));
        }
        for_each_body([&](std::int32_t b, int) { rows[b] = 0; });
    }

    void release(const FlightPair& f) {
        const std::uint32_t id = contact_of(f);
        ContactInfo& c = s.contacts.info[id];
        if (c.point_count > 0 || c.touching) {
            s.narrow.outcomes[f.place] = ended;
            if (is_group(c))
                follow_up_group(s, f.place, dt_);
            else
                follow_up(s, id, ended, dt_);
        }
        s.narrow.outcomes[f.place] = apart;
        forget_separation(s.bodies, s.contacts, id);
        s.narrow.in_flight.push_back(id);
    }

    void test_held() {
        begin_groups(s.contacts, s.narrow);
        thread_pool_.for_chunks(int(flights_.size()), flights_per_chunk, [&](int begin, int end, int thread) {
            for (int k = begin; k < end; ++k) {
                const FlightPair& f = flights_[std::size_t(k)];
                if (f.is_free) continue;
                const std::uint32_t id = contact_of(f);
                if (!s.contacts.records.has(id)) continue; // its owner reports it
                const Manifold* const first = s.narrow.flights.hits.data() + f.first_hit;
                if (is_group(s.contacts.info[id]))
                    test_held_group(in, s.contacts, s.narrow, f.place, s.narrow.at_work[thread], dt_);
                else
                    s.narrow.outcomes[f.place] = take_test(in, s.contacts, s.narrow, id, *first, dt_);
            }
        });
        collect_fresh_patches(s.narrow);
        if (!s.ranks) return;
        std::vector<std::uint32_t>& shared = s.narrow.shared;
        shared.clear();
        for (const FlightPair& f : flights_)
            if (!f.is_free && owner_of(s.contacts, contact_of(f)) != every_rank) shared.push_back(f.place);
        exchange_tests(in, s, shared, dt_);
    }
    void follow(const FlightPair& f) {
        if (is_group(s.contacts.info[contact_of(f)]))
            follow_up_group(s, f.place, dt_);
        else
            follow_up(s, contact_of(f), s.narrow.outcomes[f.place], dt_);
    }

    const NarrowInput& in;
    const FollowUpContext& s;
    ThreadPool& thread_pool_;
    const float dt_;
    std::vector<FlightPair>& flights_ = s.narrow.flights.pairs;
};

} // namespace

bool may_turn_away(const Bodies& bodies, const ContactInfo& c, float dt) {
    float turn = 0, way = dt * math::length(bodies.motion[c.body_a].v - bodies.motion[c.body_b].v);
    for (const std::int32_t b : {c.body_a, c.body_b}) {
        const float own = dt * math::length(bodies.motion[b].w);
        if (own > 0) turn += own, way += own * bodies.links[b].radius;
    }
    return turn * way > c.base_margin;
}

bool may_meet_in_flight(const NarrowInput& in, const Contacts& contacts, const ContactInfo& c, const Manifold& m,
                        float dt) {
    if (c.is_trigger || m.count == 0) return false;
    const float least = least_separation(m);
    if (!may_fly(in.bodies, in.islands, c.body_a) || !may_fly(in.bodies, in.islands, c.body_b)) return false;
    if (may_turn_away(in.bodies, c, dt) && turns_away(in.bodies, in.shapes, c, m, -least, dt)) return true;
    if (least > c.base_margin) return true;
    if (!(least > 0)) return false;
    const float speed = approach_of(in.bodies, in.shapes, c, m), way = speed * dt + fall_of(in, c, m, dt);
    // Separations below this tolerance count as touching: what presses the shapes together brings them no nearer.
    const auto is_off = [&] { return least > float(touch_tolerance(half_width_between(in.shapes, c))); };
    if (std::fabs(way) > c.base_margin && (std::fabs(speed * dt) > c.base_margin || is_off())) return true;
    const bool bounces = c.bounces && speed > in.settings.restitution_speed;
    // A shape that slides before it touches may be past the other by then: the plane of a contact, which has no end,
    // would stop it.
    const math::Vec3 n = math::to_vec(m.normal), v = in.bodies.motion[c.body_b].v - in.bodies.motion[c.body_a].v;
    const bool slides = dt * math::length(v - math::dot(v, n) * n) > c.base_margin && is_off();
    // A pair that bounced in the step before counts as touching, but is separated by now. (On bodies that no force
    // moves, the solver brings bouncing bodies to rest.)
    const bool has_bounced = c.b_moves && c.bounces && is_off();
    return ((least > way && is_off()) || bounces || slides) && (has_bounced || !touches(contacts, c));
}

void settle_flights(const NarrowInput& in, const FollowUpContext& s, ThreadPool& thread_pool, float dt) {
    FlightList(in, s, thread_pool, dt).run();
}

} // namespace cairn
