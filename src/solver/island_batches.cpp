// Packing islands into batches and sorting their contacts.
#include "solver/island_batches.h"

#include "contacts/contact_update.h"
#include "core/cache.h"
#include "islands/substep_policy.h"
#include "solver/contact_order.h"
#include "state/joint_links.h"
#include "state/state.h"

#include <algorithm>

namespace cairn {

namespace {

constexpr std::int32_t batch_contacts = 300; // enough to fill lanes, and few, so that threads end together
constexpr std::int32_t batch_bodies = 4096;
constexpr int contacts_per_chunk = 512; // for threads

// Impulses are those of one substep: with another length of substep they are others.
void rescale_impulses(ContactInfo& c, ContactRecord& r, float h) {
    if (c.substep_time > 0) {
        const float ratio = h / c.substep_time;
        const float factor = ratio > 1e-3f && ratio < 1e3f ? ratio : 0.0f; // too different to say anything
        for (float& impulse : r.impulses) impulse *= factor;
        for (float& impulse : r.friction_impulse) impulse *= factor;
        r.torsion_impulse *= factor;
    }
    c.substep_time = h;
}

void open_batch(SolverScratch& scratch, const Island& island) {
    IslandBatch batch;
    batch.substeps = island.substeps;
    scratch.batches.push_back(batch);
}

// All that is needed of the contacts to be solved, side by side: they lie scattered.
void collect_contacts(const Bodies& bodies, Contacts& contacts, const Islands& islands,
                      const std::vector<std::uint32_t>& solved, std::vector<SortedContact>& unsorted,
                      ThreadPool& thread_pool, float dt) {
    unsorted.resize(solved.size());
    thread_pool.for_chunks(int(solved.size()), contacts_per_chunk, [&](int begin, int end, int) {
        ContactInfo* const info = contacts.info.data();
        const BodyLinks* const links = bodies.links.data();
        const BodySettings* const settings = bodies.settings.data();
        const Island* const all = islands.all.data();
        const std::uint32_t* const ids = solved.data();
        SortedContact* const out = unsorted.data();
        constexpr int ahead = 2 * int(contacts_ahead);
        for (int k = begin; k < end; ++k) {
            if (k + 2 * ahead < end) ask_cache(&info[ids[k + 2 * ahead]]);
            if (k + ahead < end) ask_cache(&links[info[ids[k + ahead]].body_a].island);
            const std::uint32_t id = ids[k];
            ContactInfo& c = info[id];
            const bool moves = c.b_moves || settings[c.body_b].type == BodyType::kinematic;
            const std::int32_t island = links[c.body_a].island;
            const float h = dt / float(all[island].substeps);
            if (c.substep_time != h) rescale_impulses(c, contacts.records[id], h);
            out[k] = {id, c.body_a, moves ? c.body_b : none, island, key_of(c), c.bounces, c.is_conveyor};
        }
    });
}

// Contacts of one island mostly follow each other: they are counted in registers.
void count_contacts(SolverScratch& scratch) {
    const std::vector<SortedContact>& contacts = scratch.unsorted;
    for (std::size_t k = 0; k < contacts.size();) {
        const std::int32_t island = contacts[k].island;
        std::int32_t count = 0;
        for (; k < contacts.size() && contacts[k].island == island; ++k) ++count;
        scratch.contacts_of_island[island] += count;
    }
}

} // namespace

void pack_batches(const Bodies& bodies, Contacts& contacts, Islands& islands, const WorldDef& settings,
                  StepScratch& step, float dt) {
    SolverScratch& scratch = step.solver;
    scratch.batches.clear();
    // Of awake islands only: there may be many more that sleep.
    scratch.contacts_of_island.resize(islands.all.size());
    scratch.batch_of_island.resize(islands.all.size());
    for (const std::int32_t i : islands.awake) {
        scratch.contacts_of_island[i] = 0;
        islands.all[i].substeps = island_substeps(settings, step.passes, islands.all[i]);
    }
    collect_contacts(bodies, contacts, islands, step.solved, scratch.unsorted, *step.thread_pool, dt);
    count_contacts(scratch);

    // One batch is open for each number of substeps; it closes when it is full.
    scratch.open_batches.assign(std::size_t(max_substeps) + 1, none);
    for (const std::int32_t i : islands.awake) {
        const Island& island = islands.all[i];
        std::int32_t& open = scratch.open_batches[island.substeps];
        if (open == none) {
            open = std::int32_t(scratch.batches.size());
            open_batch(scratch, island);
        }
        IslandBatch& batch = scratch.batches[open];
        scratch.batch_of_island[i] = open;
        ++batch.island_count;
        batch.body_count += island.body_count;
        batch.contact_count += scratch.contacts_of_island[i];
        batch.joint_count += island.joint_count;
        if (batch.contact_count + batch.joint_count >= batch_contacts || batch.body_count >= batch_bodies) open = none;
    }

    // Islands and contacts in batch order (counting sorts, stable).
    std::int32_t island_count = 0, contact_count = 0;
    for (IslandBatch& batch : scratch.batches) {
        batch.first_island = island_count;
        batch.first_contact = contact_count;
        island_count += batch.island_count;
        contact_count += batch.contact_count;
        batch.island_count = 0;
    }
    scratch.batch_islands.resize(std::size_t(island_count));
    for (const std::int32_t i : islands.awake) {
        IslandBatch& batch = scratch.batches[scratch.batch_of_island[i]];
        scratch.batch_islands[batch.first_island + batch.island_count++] = i;
    }
    scratch.key_counts.assign(scratch.batches.size() * keys_per_batch + 1, 0);
    scratch.keys.resize(scratch.unsorted.size());
    for (std::size_t k = 0; k < scratch.unsorted.size(); ++k) {
        const SortedContact& c = scratch.unsorted[k];
        const std::uint32_t key = std::uint32_t(scratch.batch_of_island[c.island]) * keys_per_batch + c.key;
        scratch.keys[k] = key;
        ++scratch.key_counts[key + 1];
    }
    for (std::size_t k = 1; k < scratch.key_counts.size(); ++k) scratch.key_counts[k] += scratch.key_counts[k - 1];
    scratch.sorted.resize(std::size_t(contact_count));
    for (std::size_t k = 0; k < scratch.unsorted.size(); ++k) {
        const SortedContact& c = scratch.unsorted[k];
        const std::uint32_t key = scratch.keys[k];
        scratch.batches[key / keys_per_batch].bounces |= c.bounces != 0;
        scratch.sorted[scratch.key_counts[key]++] = c;
    }
}

} // namespace cairn
