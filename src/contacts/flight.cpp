#include "contacts/flight.h"

#include "bodies/integrators.h"
#include "bodies/motion_budget.h"
#include "contacts/contact_update.h"
#include "contacts/patches.h"
#include "contacts/touch.h"

#include <algorithm>

namespace cairn {

namespace {

constexpr int flights_per_chunk = 16; // for threads

bool may_fly(const State& s, std::int32_t b) {
    return !s.bodies.is_dynamic(b) || (s.bodies.links[b].first_joint == none && is_awake(s.bodies, s.islands, b));
}

bool touches(const State& s, const ContactInfo& c) {
    if (!is_group(c)) return c.touching;
    for (std::int32_t p = c.related; p != none; p = s.contacts.info[p].next)
        if (s.contacts.info[p].touching) return true;
    return false;
}

// How far forces bring the two together in the step, along the normal.
float fall_of(const State& s, const StepPasses& passes, const ContactInfo& c, const Manifold& m, float dt) {
    const std::int32_t first = c.flipped ? c.body_b : c.body_a, second = c.flipped ? c.body_a : c.body_b;
    const math::DVec3 a = acceleration_at(s.bodies, s.fields, s.settings, first, s.bodies.motion[first].x) -
                          acceleration_at(s.bodies, s.fields, s.settings, second, s.bodies.motion[second].x);
    const float share = 0.5f * (1 + 1.0f / float(passes.in_pass(s.settings.substeps))); // as in substeps
    return share * dt * dt * float(math::dot(a, math::to_double(math::to_vec(m.normal))));
}

// How far a contact that stays as it is in the step is off at its end, as its surface, of `under`, turns its normal: by
// half of the turn times the way that what is on it goes along it, and, as what goes straight on at the surface's speed
// gets behind it, by a third of the square of the turn times the way of the surface.
float lag_of(const BodyMotion& on, const BodyMotion& under, math::Vec3 normal, float dt) {
    const float turn = dt * math::length(math::cross(under.w, normal));
    const math::Vec3 surface = math::cross(under.w, math::to_float(on.x - under.x));
    return turn * dt * (0.5f * math::length(on.v - under.v - surface) + turn / 3 * math::length(surface));
}

// Whether a kinematic body or what is on it turns so far that a contact between them cannot stay as it is in a step.
bool turns_away(const State& s, const ContactInfo& c, const Manifold& m, float dt) {
    if (s.bodies.settings[c.body_b].type != BodyType::kinematic) return false;
    const BodyMotion &a = s.bodies.motion[c.body_a], &b = s.bodies.motion[c.body_b];
    const math::Vec3 n = math::to_vec(m.normal);
    return lag_of(a, b, n, dt) > c.base_margin || lag_of(b, a, n, dt) > c.base_margin;
}

// Flight keeps two as deep in each other as they are: the solver pushes those apart that are deeper than this.
float core_depth_between(const State& s, const ContactInfo& c) {
    const std::vector<Geometry>& geometry = s.shapes.geometry;
    const std::vector<ShapeData>& data = s.shapes.data;
    return float(
        core_depth_of(half_width_of(geometry[c.shape_a], data[c.shape_a], geometry[c.shape_b], data[c.shape_b])));
}

// Rows in the solver that a pair has had so far.
int rows_of(const State& s, std::uint32_t id) {
    int rows = 0;
    for_each_patch(s.contacts, id, [&](std::uint32_t contact) { rows += s.contacts.info[contact].point_count > 0; });
    return rows;
}

class FlightList {
  public:
    explicit FlightList(State& state, StepScratch& step, float dt) : s(state), step(step), dt_(dt) {}
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
    std::uint32_t contact_of(const FlightPair& f) const { return step.narrow.candidates[f.place]; }

    void gather() {
        FlightPairs& all = step.narrow.flights;
        all.clear();
        step.narrow.in_flight.clear();
        for (NarrowBatch& own : step.narrow.at_work) {
            for (const FlightPair& f : own.flights.pairs)
                all.add(f.place, own.flights.hits.data() + f.first_hit, f.hit_count);
            own.flights.clear();
        }
        std::sort(flights_.begin(), flights_.end(),
                  [](const FlightPair& a, const FlightPair& b) { return a.place < b.place; });
    }

    // A body that has contacts beside those that may be in flight is held by them.
    void decide() {
        std::vector<std::int32_t>& rows = step.narrow.flight_rows;
        rows.resize(s.bodies.links.size(), 0);
        const auto for_each_body = [&](auto&& f) {
            for (const FlightPair& flight : flights_) {
                const ContactInfo& c = s.contacts.info[contact_of(flight)];
                const int count = rows_of(s, contact_of(flight));
                f(c.body_a, count);
                if (c.b_moves) f(c.body_b, count);
            }
        };
        for_each_body([&](std::int32_t b, int count) { rows[b] += count; });
        const auto is_free = [&](std::int32_t b) { return s.bodies.links[b].contact_count <= rows[b]; };
        for (FlightPair& f : flights_) {
            const ContactInfo& c = s.contacts.info[contact_of(f)];
            f.is_free = is_free(c.body_a) && (!c.b_moves || is_free(c.body_b));
        }
        for_each_body([&](std::int32_t b, int) { rows[b] = 0; });
    }

    void release(const FlightPair& f) {
        const std::uint32_t id = contact_of(f);
        ContactInfo& c = s.contacts.info[id];
        if (c.point_count > 0 || c.touching) {
            step.narrow.outcomes[f.place] = ended;
            if (is_group(c))
                follow_up_group(s, step.narrow, step.solved, f.place, dt_);
            else
                follow_up(s, step.narrow, step.solved, id, ended, dt_);
        }
        step.narrow.outcomes[f.place] = apart;
        drop_answer(s.bodies, s.contacts, id);
        if (id < step.narrow.found.size()) step.narrow.found[id] = 0; // each pass of the step asks for it
        step.narrow.in_flight.push_back(id);
    }

    void test_held() {
        begin_groups(s.contacts, step.narrow);
        step.thread_pool->for_chunks(int(flights_.size()), flights_per_chunk, [&](int begin, int end, int thread) {
            for (int k = begin; k < end; ++k) {
                const FlightPair& f = flights_[std::size_t(k)];
                if (f.is_free) continue;
                const std::uint32_t id = contact_of(f);
                const Manifold* const first = step.narrow.flights.hits.data() + f.first_hit;
                NarrowBatch& own = step.narrow.at_work[thread];
                if (is_group(s.contacts.info[id])) {
                    own.hits.assign(first, first + f.hit_count);
                    take_group(s, s.contacts, step, f.place, own, dt_);
                } else {
                    step.narrow.outcomes[f.place] = take_test(s, s.contacts, step, id, *first, dt_);
                }
            }
        });
        collect_fresh_patches(step.narrow);
    }
    void follow(const FlightPair& f) {
        if (is_group(s.contacts.info[contact_of(f)]))
            follow_up_group(s, step.narrow, step.solved, f.place, dt_);
        else
            follow_up(s, step.narrow, step.solved, contact_of(f), step.narrow.outcomes[f.place], dt_);
    }

    State& s;
    StepScratch& step;
    const float dt_;
    std::vector<FlightPair>& flights_ = step.narrow.flights.pairs;
};

} // namespace

bool may_meet_in_flight(const State& s, const StepPasses& passes, const ContactInfo& c, const Manifold& m, float dt) {
    if (c.is_trigger || m.count == 0) return false;
    float least = m.points[0][3];
    for (int i = 1; i < m.count; ++i) least = std::min(least, m.points[i][3]);
    const bool bends = -least < core_depth_between(s, c) && turns_away(s, c, m, dt);
    if (!(least > 0 || bends) || !may_fly(s, c.body_a) || !may_fly(s, c.body_b)) return false;
    if (bends) return true;
    const float speed = approach_of(s.bodies, s.shapes, c, m), way = speed * dt + fall_of(s, passes, c, m, dt);
    if (least > c.base_margin || std::fabs(way) > c.base_margin) return true;
    const bool bounces = c.bounces && speed > s.settings.restitution_speed;
    return (least > way || bounces) && !touches(s, c);
}

void settle_flights(State& s, StepScratch& step, float dt) { FlightList(s, step, dt).run(); }

} // namespace cairn
