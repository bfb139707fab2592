// Packing islands into bins and sorting their contacts.
#include "dynamics/coloring.h"
#include "dynamics/solver.h"

#include <algorithm>

namespace cairn {

namespace {

constexpr std::int32_t bin_contacts = 300; // enough to fill lanes, and few, so that threads end together
constexpr std::int32_t bin_bodies = 4096;
constexpr std::uint32_t keys_per_bin = 128; // color, and one point or more

// Overflow first, then moving pairs by color, then pairs with what does not move.
std::uint32_t order_key(const ContactInfo& c) {
    const std::uint32_t rank = c.color == overflow_color ? 0u : c.color + 1u;
    return 2 * rank + (c.point_count == 1 ? 1u : 0u);
}

// Impulses are those of one substep: with another length of substep they are others.
void rescale_impulses(ContactInfo& c, ContactRecord& r, float h) {
    if (c.substep_time == h) return;
    if (c.substep_time > 0) {
        const float ratio = h / c.substep_time;
        const float factor = ratio > 1e-3f && ratio < 1e3f ? ratio : 0.0f; // too different to say anything
        for (float& impulse : r.impulses) impulse *= factor;
        for (float& impulse : r.friction_impulse) impulse *= factor;
        r.torsion_impulse *= factor;
    }
    c.substep_time = h;
}

void open_bin(SolverScratch& scratch, std::int32_t substeps) {
    Bin bin;
    bin.substeps = substeps;
    scratch.bins.push_back(bin);
}

} // namespace

void pack_bins(State& s, float dt) {
    SolverScratch& scratch = s.solver;
    scratch.bins.clear();
    scratch.contacts_of_island.assign(s.islands.size(), 0);
    scratch.bin_of_island.assign(s.islands.size(), none);
    for (const std::uint32_t id : s.solved)
        ++scratch.contacts_of_island[std::size_t(s.bodies[std::size_t(s.contacts[id].body_a)].island)];

    // One bin is open for each number of substeps; it closes when it is full.
    scratch.open_bins.assign(std::size_t(most_substeps) + 1, none);
    for (const std::int32_t i : s.awake_islands) {
        Island& island = s.islands[std::size_t(i)];
        island.substeps = island_substeps(s, island);
        std::int32_t& open = scratch.open_bins[std::size_t(island.substeps)];
        if (open == none) {
            open = std::int32_t(scratch.bins.size());
            open_bin(scratch, island.substeps);
        }
        Bin& bin = scratch.bins[std::size_t(open)];
        scratch.bin_of_island[std::size_t(i)] = open;
        ++bin.island_count;
        bin.body_count += island.body_count;
        bin.contact_count += scratch.contacts_of_island[std::size_t(i)];
        if (bin.contact_count >= bin_contacts || bin.body_count >= bin_bodies) open = none;
    }

    // Islands and contacts in bin order (counting sorts, stable).
    std::int32_t islands = 0, contacts = 0;
    for (Bin& bin : scratch.bins) {
        bin.first_island = islands;
        bin.first_contact = contacts;
        islands += bin.island_count;
        contacts += bin.contact_count;
        bin.island_count = 0;
    }
    scratch.bin_islands.resize(std::size_t(islands));
    for (const std::int32_t i : s.awake_islands) {
        Bin& bin = scratch.bins[std::size_t(scratch.bin_of_island[std::size_t(i)])];
        scratch.bin_islands[std::size_t(bin.first_island + bin.island_count++)] = i;
    }
    scratch.key_counts.assign(scratch.bins.size() * keys_per_bin + 1, 0);
    scratch.keys.resize(s.solved.size());
    for (std::size_t k = 0; k < s.solved.size(); ++k) {
        const ContactInfo& c = s.contacts[s.solved[k]];
        const std::int32_t island = s.bodies[std::size_t(c.body_a)].island;
        const std::uint32_t key =
            std::uint32_t(scratch.bin_of_island[std::size_t(island)]) * keys_per_bin + order_key(c);
        scratch.keys[k] = key;
        ++scratch.key_counts[key + 1];
    }
    for (std::size_t k = 1; k < scratch.key_counts.size(); ++k) scratch.key_counts[k] += scratch.key_counts[k - 1];
    scratch.sorted.resize(s.solved.size());
    for (std::size_t k = 0; k < s.solved.size(); ++k) {
        const std::uint32_t id = s.solved[k], key = scratch.keys[k];
        ContactInfo& c = s.contacts[id];
        Bin& bin = scratch.bins[key / keys_per_bin];
        rescale_impulses(c, s.records[id], dt / float(bin.substeps));
        bin.bounces |= c.bounces != 0;
        const bool moves = c.b_moves || s.body_settings[std::size_t(c.body_b)].type == BodyType::kinematic;
        scratch.sorted[scratch.key_counts[key]++] = {id, c.body_a, moves ? c.body_b : none, c.color,
                                                     std::uint8_t(c.point_count != 1)};
    }
}

} // namespace cairn
