// A load that contacts have not borne yet grows by what passes reach: along a tower of 40 boxes, in about 40 substeps.
// Until then the tower sinks into itself, and then it springs back. How many substeps it needs follows from its load,
// which nobody has measured yet. Where each body stands on one other, the weights alone tell it.
#include "solver/standing_loads.h"

#include "bodies/integrators.h"
#include "islands/substep_policy.h"
#include "solver/island_batches.h"

#include <algorithm>
#include <span>

namespace cairn {

namespace {

// Whether the contacts of an island may be such a tree: as many as bodies. What is agitated is no structure.
bool may_stand(const Island& island, std::int32_t contacts) {
    return contacts > 1 && contacts == island.body_count && island.joint_count == 0 &&
           island.agitation <= max_agitation;
}

// Their contacts, those of an island side by side.
void list_standing(const Contacts& contacts, const Islands& islands, SolverScratch& scratch) {
    StandingLoads& work = scratch.standing;
    work.end_of_island.resize(islands.all.size());
    std::int32_t count = 0;
    for (const std::int32_t i : islands.awake) {
        const std::int32_t own = scratch.contacts_of_island[i];
        work.end_of_island[i] = may_stand(islands.all[i], own) ? count : none;
        if (work.end_of_island[i] != none) count += own;
    }
    work.contacts.resize(std::size_t(count));
    if (count == 0) return;
    for (const SortedContact& c : scratch.sorted)
        if (std::int32_t& end = work.end_of_island[c.island]; end != none)
            work.contacts[std::size_t(end++)] = {c.id, c.body_a, contacts.info[c.id].b_moves ? c.body_b : none, 0};
}

// The loads of the contacts of one island, from the outermost bodies inward. Whether they hang together as a tree.
bool find_loads(const Bodies& bodies, const Island& island, std::span<StandingContact> contacts, StandingLoads& work,
                const BodyWeights& weights) {
    work.bodies.clear();
    for (std::int32_t b = island.first_body; b != none; b = bodies.links[b].next_in_island) {
        work.place_of[b] = std::int32_t(work.bodies.size());
        work.bodies.push_back({weights(b), 0, 0});
    }
    const auto body = [&](std::int32_t b) -> StandingLoads::Body& { return work.bodies[work.place_of[b]]; };
    int held = 0;
    for (std::uint32_t k = 0; k < contacts.size(); ++k)
        for (const std::int32_t b : {contacts[k].a, contacts[k].b})
            if (b == none)
                ++held;
            else
                ++body(b).contacts, body(b).places ^= k;
    if (held != 1) return false;
    std::size_t found = 0;
    for (std::int32_t b = island.first_body; b != none; b = bodies.links[b].next_in_island)
        for (std::int32_t outermost = b; outermost != none && body(outermost).contacts == 1;) {
            StandingLoads::Body& holder = body(outermost);
            StandingContact& c = contacts[holder.places];
            if (c.b == none) break; // the last one, when all others are found
            c.load = holder.weight;
            ++found;
            holder.contacts = 0;
            outermost = c.a == outermost ? c.b : c.a;
            StandingLoads::Body& next = body(outermost);
            next.weight += c.load;
            --next.contacts, next.places ^= std::uint32_t(&c - contacts.data());
        }
    if (found + 1 != contacts.size()) return false;
    for (StandingContact& c : contacts)
        if (c.b == none) c.load = body(c.a).weight;
    return true;
}

} // namespace

void count_standing_loads(const Bodies& bodies, Contacts& contacts, Islands& islands, const ForceFields& fields,
                          const WorldDef& settings, SolverScratch& scratch, float dt) {
    if (!settings.adaptive_substeps) return;
    StandingLoads& work = scratch.standing;
    list_standing(contacts, islands, scratch);
    work.place_of.resize(bodies.links.size());
    const BodyWeights weights(bodies, fields, settings);
    for (const std::int32_t i : islands.awake) {
        if (work.end_of_island[i] == none) continue;
        Island& island = islands.all[i];
        const auto count = std::size_t(scratch.contacts_of_island[i]);
        const std::span<StandingContact> own(work.contacts.data() + work.end_of_island[i] - count, count);
        if (!find_loads(bodies, island, own, work, weights)) continue;
        float demand = 0;
        for (const StandingContact& c : own) {
            const float inverse_mass =
                bodies.mass[c.a].inverse_mass + (c.b == none ? 0 : bodies.mass[c.b].inverse_mass);
            demand = std::max(demand, demand_of(contacts.info[c.id], c.load, inverse_mass));
        }
        const int wanted = wanted_substeps(settings, {false, 1, demand}, dt);
        if (wanted <= island.substeps) continue;
        island.substeps = wanted;
        for (const StandingContact& c : own)
            rescale_impulses(contacts.info[c.id], contacts.records, c.id, dt / float(wanted));
    }
}

} // namespace cairn
