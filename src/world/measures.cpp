// Energies, momenta, contacts, counts and the state hash.
#include "bodies/bodies.h"
#include "contacts/contact_record.h"
#include "contacts/prefetch.h"
#include "contacts/record_owners.h"
#include "core/digest.h"
#include "core/hash.h"
#include "islands/coloring.h"
#include "state/state.h"
#include "world/impl.h"

#include <algorithm>

namespace cairn {

namespace {

template <class F> void for_each_dynamic(const Bodies& bodies, F&& f) {
    for (std::uint32_t i = 0; i < bodies.slots.size(); ++i)
        if (bodies.slots.is_live(i) && bodies.is_dynamic(std::int32_t(i))) f(std::int32_t(i));
}

// The mass of a body for sums over masses; immovable bodies count as zero.
double summed_mass(const Bodies& bodies, std::int32_t b) {
    const BodyMass& mass = bodies.mass[b];
    return mass.inverse_mass > 0 ? double(mass.mass) : 0.0;
}

bool is_touching(const ContactInfo& c) { return c.in_use && c.touching && !c.is_trigger; }

Contact make_contact(const Bodies& bodies, const Shapes& shapes, const Contacts& contacts, std::uint32_t id) {
    const ContactInfo& c = contacts.info[id];
    const ContactRecord& r = contacts.records[id];
    Contact out{shapes.slots.id(c.shape_a),
                shapes.slots.id(c.shape_b),
                bodies.id(c.body_a),
                bodies.id(c.body_b),
                {r.normal[0], r.normal[1], r.normal[2]},
                {r.total_friction[0], r.total_friction[1], r.total_friction[2]},
                // an impact has one point, stored in the record but not counted by the solver
                std::max(int(c.point_count), 1),
                {},
                c.surface_material};
    for (int i = 0; i < out.point_count; ++i) {
        const math::DVec3 p = bodies.motion[c.body_a].x + math::to_double(math::to_vec(point_of(r, i)));
        out.points[i] = {to_public(p), point_of(r, i)[3], total_of(r, i)};
    }
    return out;
}

} // namespace

double World::kinetic_energy() const {
    const State& s = impl_->intact("World::kinetic_energy");
    double sum = 0;
    for_each_dynamic(s.bodies, [&](std::int32_t b) { sum += cairn::kinetic_energy(s.bodies, b); });
    return sum;
}

double World::potential_energy() const {
    const State& s = impl_->intact("World::potential_energy");
    const math::DVec3 g = math::to_double(to_math(s.settings.gravity));
    double sum = 0;
    for_each_dynamic(s.bodies, [&](std::int32_t b) {
        sum -=
            summed_mass(s.bodies, b) * double(s.bodies.settings[b].gravity_scale) * math::dot(g, s.bodies.motion[b].x);
    });
    return sum;
}

glm::dvec3 World::linear_momentum() const {
    const State& s = impl_->intact("World::linear_momentum");
    math::DVec3 sum;
    for_each_dynamic(s.bodies,
                     [&](std::int32_t b) { sum += summed_mass(s.bodies, b) * math::to_double(s.bodies.motion[b].v); });
    return {sum.x, sum.y, sum.z};
}

glm::dvec3 World::angular_momentum() const {
    const State& s = impl_->intact("World::angular_momentum");
    math::DVec3 sum;
    for_each_dynamic(s.bodies, [&](std::int32_t b) {
        const BodyMotion& m = s.bodies.motion[b];
        sum += math::cross(m.x, summed_mass(s.bodies, b) * math::to_double(m.v));
        if (!(s.bodies.mass[b].inverse_inertia == math::Vec3{}))
            sum += world_inertia(m, s.bodies.mass[b]) * math::to_double(m.w);
    });
    return {sum.x, sum.y, sum.z};
}

std::uint64_t World::state_hash() const {
    const State& s = impl_->intact("World::state_hash");
    Hash64 hash;
    for (std::uint32_t i = 0; i < s.bodies.slots.size(); ++i) {
        if (!s.bodies.slots.is_live(i)) continue;
        hash.add(i);
        hash.add_bytes(&s.bodies.motion[i], sizeof(BodyMotion));
    }
    return hash.value();
}

StateDigest World::state_digest() const {
    const State& s = impl_->intact("World::state_digest");
    StateDigest digest;
    for (std::uint32_t i = 0; i < s.bodies.slots.size(); ++i)
        if (s.bodies.slots.is_live(i)) add_to_digest(digest, i, &s.bodies.motion[i], sizeof(BodyMotion));
    return digest;
}

std::vector<BodyId> World::bodies_that_differ(const StateDigest& other) const {
    const State& s = impl_->intact("World::bodies_that_differ");
    std::vector<BodyId> ids;
    for (const std::uint32_t i : differing_slots(state_digest(), other, std::uint32_t(s.bodies.slots.size())))
        if (s.bodies.slots.is_live(i)) ids.push_back(s.bodies.id(std::int32_t(i)));
    return ids;
}

void World::Impl::gather_records() {
    if (communicator) cairn::gather_records(state.contacts, *communicator);
}

std::vector<Contact> World::contacts() const {
    const State& s = impl_->intact("World::contacts");
    impl_->gather_records();
    std::vector<Contact> all;
    for (std::uint32_t id = 0; id < s.contacts.info.size(); ++id)
        if (is_touching(s.contacts.info[id])) all.push_back(make_contact(s.bodies, s.shapes, s.contacts, id));
    return all;
}

std::vector<Contact> World::contacts(BodyId body) const {
    const std::int32_t b = impl_->index_of(body);
    const State& s = impl_->intact("World::contacts");
    impl_->gather_records();
    std::vector<Contact> all;
    for (std::uint32_t id = 0; id < s.contacts.info.size(); ++id) {
        const ContactInfo& c = s.contacts.info[id];
        if (is_touching(c) && (c.body_a == b || c.body_b == b))
            all.push_back(make_contact(s.bodies, s.shapes, s.contacts, id));
    }
    return all;
}

std::vector<SolverContact> World::solver_contacts() const {
    const State& s = impl_->intact("World::solver_contacts");
    std::vector<SolverContact> all;
    for (const ContactInfo& c : s.contacts.info) {
        if (!is_touching(c)) continue;
        std::int32_t island = s.bodies.links[c.body_a].island;
        if (island == none) island = s.bodies.links[c.body_b].island;
        all.push_back({s.shapes.slots.id(c.shape_a), s.shapes.slots.id(c.shape_b), s.bodies.id(c.body_a),
                       s.bodies.id(c.body_b), c.color < overflow_color ? int(c.color) : -1,
                       island == none ? 0 : s.islands.all[std::size_t(island)].substeps});
    }
    return all;
}

Statistics World::statistics() const {
    const State& s = impl_->intact("World::statistics");
    Statistics t = s.statistics;
    t.steps = s.steps;
    t.time = s.time;
    t.bodies = s.bodies.slots.live_count();
    t.shapes = s.shapes.slots.live_count();
    for_each_dynamic(s.bodies, [&](std::int32_t b) {
        ++t.dynamic_bodies;
        t.awake_bodies += is_awake(s.bodies, s.islands, b);
    });
    std::uint64_t colors = 0;
    for (const ContactInfo& c : s.contacts.info) {
        if (!c.in_use) continue;
        t.candidate_pairs += c.kind != PairKind::patch;
        if (c.is_trigger) continue;
        if (c.color < 64) colors |= std::uint64_t(1) << c.color, t.overflow_contacts += c.color == 63;
        if (!c.touching) continue;
        ++t.contacts;
        t.contact_points += c.point_count;
    }
    t.colors = std::size_t(__builtin_popcountll(colors));
    t.islands = s.islands.awake.size();
    for (const Island& island : s.islands.all) {
        t.sleeping_islands += island.in_use && island.position == none;
        if (island.in_use && island.position != none) t.max_substeps = std::max(t.max_substeps, island.substeps);
    }
    t.clamped_speeds = s.clamped_speeds;
    return t;
}

} // namespace cairn
