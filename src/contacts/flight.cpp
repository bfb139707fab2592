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
    return !s.is_dynamic(b) || (s.bodies[b].first_joint == none && s.is_awake(b));
}

bool touches(const State& s, const ContactInfo& c) {
    if (!is_group(c)) return c.touching;
    for (std::int32_t p = c.related; p != none; p = s.contacts[p].next)
        if (s.contacts[p].touching) return true;
    return false;
}

// How far forces bring the two together in the step, along the normal.
float fall_of(const State& s, const ContactInfo& c, const Manifold& m, float dt) {
    const std::int32_t first = c.flipped ? c.body_b : c.body_a, second = c.flipped ? c.body_a : c.body_b;
    const math::DVec3 a = acceleration_at(s, first, s.motion[first].x) - acceleration_at(s, second, s.motion[second].x);
    const float share = 0.5f * (1 + 1.0f / float(s.in_pass(s.settings.substeps))); // as in substeps
    return share * dt * dt * float(math::dot(a, math::to_double(math::to_vec(m.normal))));
}

// Rows in the solver that a pair has had so far.
int rows_of(const State& s, std::uint32_t id) {
    int rows = 0;
    for_each_patch(s, id, [&](std::uint32_t contact) { rows += s.contacts[contact].point_count > 0; });
    return rows;
}

class FlightList {
  public:
    explicit FlightList(State& state, float dt) : s(state), dt_(dt) {}
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
        flights_.clear();
        s.narrow.in_flight.clear();
        for (NarrowBatch& own : s.narrow.at_work) {
            flights_.insert(flights_.end(), own.flights.begin(), own.flights.end());
            own.flights.clear();
        }
        std::sort(flights_.begin(), flights_.end(),
                  [](const FlightPair& a, const FlightPair& b) { return a.place < b.place; });
    }

    // A body that has contacts beside those that may be in flight is held by them.
    void decide() {
        std::vector<std::int32_t>& rows = s.narrow.flight_rows;
        rows.resize(s.bodies.size(), 0);
        const auto for_each_body = [&](auto&& f) {
            for (const FlightPair& flight : flights_) {
                const ContactInfo& c = s.contacts[contact_of(flight)];
                const int count = rows_of(s, contact_of(flight));
                f(c.body_a, count);
                if (c.b_moves) f(c.body_b, count);
            }
        };
        for_each_body([&](std::int32_t b, int count) { rows[b] += count; });
        const auto is_free = [&](std::int32_t b) { return s.bodies[b].contact_count <= rows[b]; };
        for (FlightPair& f : flights_) {
            const ContactInfo& c = s.contacts[contact_of(f)];
            f.is_free = is_free(c.body_a) && (!c.b_moves || is_free(c.body_b));
        }
        for_each_body([&](std::int32_t b, int) { rows[b] = 0; });
    }

    void release(const FlightPair& f) {
        const std::uint32_t id = contact_of(f);
        ContactInfo& c = s.contacts[id];
        if (c.point_count > 0 || c.touching) {
            s.narrow.outcomes[f.place] = ended;
            if (is_group(c))
                follow_up_group(s, f.place, dt_);
            else
                follow_up(s, id, ended, dt_);
        }
        s.narrow.outcomes[f.place] = apart;
        drop_answer(s, id);
        if (id < s.narrow.found.size()) s.narrow.found[id] = 0; // each pass of the step asks for it
        s.narrow.in_flight.push_back(id);
    }

    void test_held() {
        begin_groups(s);
        s.thread_pool->for_chunks(int(flights_.size()), flights_per_chunk, [&](int begin, int end, int thread) {
            for (int k = begin; k < end; ++k) {
                const FlightPair& f = flights_[std::size_t(k)];
                if (f.is_free) continue;
                const std::uint32_t id = contact_of(f);
                if (is_group(s.contacts[id]))
                    test_group(s, f.place, s.narrow.at_work[thread], dt_, false);
                else
                    s.narrow.outcomes[f.place] = take_test(s, id, f.manifold, dt_);
            }
        });
        collect_fresh_patches(s);
    }
    void follow(const FlightPair& f) {
        if (is_group(s.contacts[contact_of(f)]))
            follow_up_group(s, f.place, dt_);
        else
            follow_up(s, contact_of(f), s.narrow.outcomes[f.place], dt_);
    }

    State& s;
    const float dt_;
    std::vector<FlightPair>& flights_ = s.narrow.flights;
};

} // namespace

bool may_meet_in_flight(const State& s, const ContactInfo& c, const Manifold& m, float dt) {
    if (c.is_trigger || m.count == 0 || !may_fly(s, c.body_a) || !may_fly(s, c.body_b)) return false;
    float least = m.points[0][3];
    for (int i = 1; i < m.count; ++i) least = std::min(least, m.points[i][3]);
    if (!(least > 0)) return false;
    const float speed = approach_of(s, c, m), way = speed * dt + fall_of(s, c, m, dt);
    if (least > c.base_margin || std::fabs(way) > c.base_margin) return true;
    const bool bounces = c.bounces && speed > s.settings.restitution_speed;
    return (least > way || bounces) && !touches(s, c);
}

void settle_flights(State& s, float dt) { FlightList(s, dt).run(); }

} // namespace cairn
