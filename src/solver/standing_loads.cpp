// A load that contacts do not carry yet spreads by one contact per solver pass: along a tower of 40 boxes, in about 40
// substeps. Until then the tower sinks into itself, and afterwards it springs back. The number of substeps that it
// needs follows from its loads, which have not been measured yet. They are therefore estimated from the weights, from
// top to bottom: a body that stands on several bodies nearer to the ground gives each of them an equal share of its
// load. This is exact where each body stands on one other. A structure that is loaded all at once, for example one just
// created, gets as many substeps as its loads take to reach the ground.
#include "solver/standing_loads.h"

#include "bodies/integrators.h"
#include "contacts/record_owners.h"
#include "core/cache.h"
#include "core/room.h"
#include "islands/slenderness.h"
#include "islands/substep_policy.h"
#include "solver/island_batches.h"

#include <algorithm>
#include <span>

namespace cairn {

namespace {

// Agitated islands are no structures, and a single contact already has the weight of its body (first_load).
bool may_stand(const Island& island, std::int32_t contacts, std::uint8_t weighed_for) {
    return weighed_for != 0 && contacts > 1 && island.joint_count == 0 && island.agitation <= max_agitation;
}

// Lists the contacts of islands that may be structures, grouped by island.
void list_standing(const Contacts& contacts, const Islands& islands, SolverScratch& scratch) {
    StandingLoads& work = scratch.standing;
    work.end_of_island.resize(islands.all.size());
    std::int32_t count = 0;
    for (const std::int32_t i : islands.awake) {
        const std::int32_t own = scratch.contacts_of_island[i];
        work.end_of_island[i] = may_stand(islands.all[i], own, scratch.weighed_for[i]) ? count : none;
        if (work.end_of_island[i] != none) count += own;
    }
    work.contacts.resize(std::size_t(count));
    if (count == 0) return;
    const std::vector<SortedContact>& sorted = scratch.sorted;
    constexpr std::size_t ahead = 2 * contacts_ahead;
    for (std::size_t k = 0; k < sorted.size(); ++k) {
        if (k + ahead < sorted.size()) prefetch(&contacts.info[sorted[k + ahead].id]);
        const SortedContact& c = sorted[k];
        if (std::int32_t& end = work.end_of_island[c.island]; end != none)
            work.contacts[std::size_t(end++)] = {c.id, c.body_a, contacts.info[c.id].b_moves ? c.body_b : none,
                                                 c.begins != 0, c.begins != 0 ? 0 : contacts.info[c.id].force};
    }
}

// The bodies of one island, each of which hands its weight down to bodies nearer to those that do not move.
class Structure {
  public:
    Structure(const Bodies& bodies, const Island& island, std::span<StandingContact> contacts, StandingLoads& work,
              const BodyWeights& weights)
        : contacts_(contacts), work_(work) {
        work.bodies.clear();
        const math::DVec3 origin = bodies.motion[island.first_body].x;
        for (std::int32_t b = island.first_body; b != none; b = bodies.links[b].next_in_island) {
            work.place_of[b] = std::int32_t(work.bodies.size());
            const float weight = weights(b);
            work.bodies.push_back({weight, weight, none, 0});
            weight_ += weight;
            if (bodies.mass[b].inverse_mass > 0)
                add_to_extent(extent_, bodies.mass[b], bodies.motion[b], origin, weights.pull(b));
        }
        work.bodies.push_back({0, 0, none, 0});
        list_contacts();
        find_depths();
    }
    float weight() const { return weight_; } // N
    const Extent& extent() const { return extent_; }

    // Calls f(contact, load in N) for the contacts that lead down. A body with most of its weight carried in the last
    // step is supported, and adds nothing to beginning contacts. With `all` such bodies count as well: this is for
    // islands that take more substeps than usual, where measured loads oscillate with the structure.
    template <class F> void hand_down(bool all, F&& f) {
        for (auto b = work_.from_below.rbegin(); b != work_.from_below.rend(); ++b) {
            const StandingLoads::Body& body = work_.bodies[std::size_t(*b)];
            const std::int32_t below_it = body.depth - 1;
            int below = 0;
            float last_load = 0;
            for (const StandingLoads::ContactOfBody& c : contacts_of(*b))
                if (depth(c.other) == below_it) ++below, last_load += contacts_[c.contact].last_load;
            if (last_load > 0.5f * body.own && !all) continue;
            const float load = body.weight / float(below); // below >= 1, as the body was reached from below
            for (const StandingLoads::ContactOfBody& c : contacts_of(*b)) {
                if (depth(c.other) != below_it) continue;
                if (c.other != none) work_.bodies[std::size_t(c.other)].weight += load;
                f(contacts_[c.contact], load);
            }
        }
    }

  private:
    std::int32_t depth(std::int32_t of) const { return of == none ? 0 : work_.bodies[std::size_t(of)].depth; }
    std::span<const StandingLoads::ContactOfBody> contacts_of(std::int32_t b) const {
        const StandingLoads::Body* const body = work_.bodies.data() + b;
        return {work_.contacts_of_body.data() + body[0].first_contact,
                work_.contacts_of_body.data() + body[1].first_contact};
    }

    void list_contacts() {
        std::vector<StandingLoads::Body>& bodies = work_.bodies;
        for (StandingContact& c : contacts_) {
            ++bodies[std::size_t(c.a = work_.place_of[c.a])].first_contact;
            if (c.b != none) ++bodies[std::size_t(c.b = work_.place_of[c.b])].first_contact;
        }
        std::uint32_t count = 0;
        for (StandingLoads::Body& body : bodies) count = body.first_contact += count; // end of the body's contacts
        set_size_anew(work_.contacts_of_body, count);
        for (std::uint32_t k = 0; k < contacts_.size(); ++k) {
            const StandingContact& c = contacts_[k];
            work_.contacts_of_body[--bodies[std::size_t(c.a)].first_contact] = {c.b, k};
            if (c.b != none) work_.contacts_of_body[--bodies[std::size_t(c.b)].first_contact] = {c.a, k};
        }
    }

    // Finds the number of contacts between each body and the ground. Bodies without support keep the depth none.
    void find_depths() {
        std::vector<std::int32_t>& order = work_.from_below;
        order.clear();
        const auto reach = [&](std::int32_t b, std::int32_t depth) {
            StandingLoads::Body& body = work_.bodies[std::size_t(b)];
            if (body.depth != none) return;
            body.depth = depth;
            order.push_back(b);
        };
        for (const StandingContact& c : contacts_)
            if (c.b == none) reach(c.a, 1);
        for (std::size_t i = 0; i < order.size(); ++i) {
            const std::int32_t next = depth(order[i]) + 1;
            for (const StandingLoads::ContactOfBody& c : contacts_of(order[i]))
                if (c.other != none) reach(c.other, next);
        }
    }

    const std::span<StandingContact> contacts_;
    StandingLoads& work_;
    float weight_ = 0;
    Extent extent_;
};

// How far the contacts of an island may sink under it without buckling, m.
float stable_sinking_of(const Bodies& bodies, const Contacts& contacts, const Island& island,
                        std::span<const StandingContact> own, const BodyWeights& weights,
                        std::vector<ContactNormal>& sides, Communicator* ranks) {
    StandingColumn column = column_of(bodies, island, weights);
    sides.clear();
    for (const StandingContact& c : own)
        if (may_hold_from_side(contacts.info[c.id])) sides.push_back({c.id, {}});
    find_normals(contacts, sides, ranks);
    for (const ContactNormal& side : sides)
        add_side_support(column, bodies.motion[contacts.info[side.contact].body_a].x, side.normal);
    return stable_sinking(column);
}

} // namespace

void count_standing_loads(const Bodies& bodies, Contacts& contacts, Islands& islands, const ForceFields& fields,
                          const WorldDef& settings, SolverScratch& scratch, Communicator* ranks, float dt) {
    if (!settings.adaptive_substeps) return;
    StandingLoads& work = scratch.standing;
    list_standing(contacts, islands, scratch);
    if (work.contacts.empty()) return;
    work.place_of.resize(bodies.links.size());
    const BodyWeights weights(bodies, fields, settings);
    for (const std::int32_t i : islands.awake) {
        if (work.end_of_island[i] == none) continue;
        Island& island = islands.all[i];
        const auto count = std::size_t(scratch.contacts_of_island[i]);
        const std::span<StandingContact> own(work.contacts.data() + work.end_of_island[i] - count, count);
        Structure structure(bodies, island, own, work, weights);
        IslandLoad greatest{false, 0, 0, min_buckling_penetration(structure.extent()), island.pull_by_width};
        structure.hand_down((scratch.weighed_for[i] & for_its_substeps) != 0,
                            [&](const StandingContact& c, float load) {
                                ContactInfo& info = contacts.info[c.id];
                                if (c.begins) info.load = info.force = std::max(info.load, load);
                                const float inverse_mass = bodies.mass[info.body_a].inverse_mass +
                                                           (c.b == none ? 0 : bodies.mass[info.body_b].inverse_mass);
                                const float weight = structure.weight();
                                greatest.share = std::max(greatest.share, weight > 0 ? load / weight : 0.0f);
                                greatest.demand = std::max(greatest.demand, demand_of(info, load, inverse_mass));
                            });
        // The bound is exact, so the costlier exact value is needed only where the bound asks for more substeps.
        if (wanted_substeps(settings, greatest, dt) <= island.substeps) continue;
        greatest.stable_sinking =
            stable_sinking_of(bodies, contacts, island, own, weights, scratch.columns.sides, ranks);
        const int wanted = wanted_substeps(settings, greatest, dt);
        if (wanted <= island.substeps) continue;
        island.substeps = wanted;
        for (const StandingContact& c : own)
            rescale_impulses(contacts.info[c.id], contacts.records, c.id, dt / float(wanted));
    }
}

} // namespace cairn
