// Packs islands and their contacts into batches.
#include "solver/island_batches.h"

#include "contacts/contact_update.h"
#include "contacts/record_owners.h"
#include "core/cache.h"
#include "core/room.h"
#include "islands/slenderness.h"
#include "islands/substep_policy.h"
#include "jobs/ordered_list.h"
#include "solver/contact_order.h"
#include "solver/standing_loads.h"
#include "state/joint_links.h"
#include "state/state.h"
#include "state/substeps.h"

#include <algorithm>

namespace cairn {

namespace {

constexpr std::int32_t batch_contacts = 300; // enough to fill lanes, few enough for threads to finish together
constexpr std::int32_t batch_bodies = 4096;
constexpr int contacts_per_chunk = 512, max_chunks = 64; // for threads

void open_batch(SolverScratch& scratch, const Island& island) {
    IslandBatch batch;
    batch.substeps = island.substeps;
    scratch.batches.push_back(batch);
}

// Counts the contacts of islands, and notes whether any of them bounces or begins. Contacts of one island are mostly
// adjacent, so they are counted in registers.
void count_contacts(const SortedContact* begin, const SortedContact* end, SolverScratch& scratch) {
    while (begin != end) {
        const std::int32_t island = begin->island;
        std::int32_t count = 0;
        bool bounces = false, begins = false;
        for (; begin != end && begin->island == island; ++begin)
            ++count, bounces |= begin->bounces != 0, begins |= begin->begins != 0;
        __atomic_fetch_add(&scratch.contacts_of_island[island], count, __ATOMIC_RELAXED);
        if (bounces) __atomic_store_n(&scratch.island_bounces[island], std::uint8_t(1), __ATOMIC_RELAXED);
        if (begins) __atomic_fetch_or(&scratch.weighed_for[island], std::uint8_t(for_begun_contact), __ATOMIC_RELAXED);
    }
}

// Copies the data needed of the contacts to be solved, which are scattered in memory, into a dense list.
void collect_contacts(const Bodies& bodies, Contacts& contacts, const Islands& islands,
                      const std::vector<std::uint32_t>& solved, SolverScratch& scratch, ThreadPool& thread_pool,
                      float dt) {
    std::vector<SortedContact>& unsorted = scratch.sorted; // until sort_by_batch
    set_size_anew(unsorted, solved.size());
    thread_pool.for_chunks(int(solved.size()), contacts_per_chunk, [&](int begin, int end, int) {
        ContactInfo* const info = contacts.info.data();
        const BodyLinks* const links = bodies.links.data();
        const BodySettings* const settings = bodies.settings.data();
        const Island* const all = islands.all.data();
        const std::uint32_t* const ids = solved.data();
        SortedContact* const out = unsorted.data();
        constexpr int ahead = 2 * int(contacts_ahead);
        for (int k = begin; k < end; ++k) {
            if (k + 2 * ahead < end) prefetch(&info[ids[k + 2 * ahead]]);
            if (k + ahead < end) prefetch(&links[info[ids[k + ahead]].body_a].island);
            const std::uint32_t id = ids[k];
            ContactInfo& c = info[id];
            const bool moves = c.b_moves || settings[c.body_b].type == BodyType::kinematic;
            const std::int32_t island = links[c.body_a].island;
            const float h = dt / float(all[island].substeps);
            const bool begins = c.substep_time == 0;
            if (c.substep_time != h) rescale_impulses(c, contacts.records, id, h);
            out[k] = {id, c.body_a, moves ? c.body_b : none, island, key_of(c), c.bounces, c.is_conveyor, begins};
        }
        count_contacts(out + begin, out + end, scratch);
    });
}

// Sorts contacts by batch, without changing their order within a batch: a stable counting sort in chunks.
void sort_by_batch(SolverScratch& scratch, ThreadPool& thread_pool) {
    const std::vector<SortedContact>& unsorted = scratch.sorted;
    const int count = int(unsorted.size());
    const std::size_t batches = scratch.batches.size();
    if (batches <= 1) return scratch.of_batches.swap(scratch.sorted);
    set_size_anew(scratch.of_batches, unsorted.size());
    // Few chunks, because each has a counter for every batch.
    const int size = std::max(contacts_per_chunk, count / max_chunks + 1);
    sort_in_order(
        &thread_pool, count, size, batches, 0, nullptr, scratch.batch_counts,
        [&](int k) { return std::size_t(scratch.batch_of_island[unsorted[std::size_t(k)].island]); },
        [&](int k, std::uint32_t place) { scratch.of_batches[place] = unsorted[std::size_t(k)]; });
}

// Chooses the substeps of each awake island by its loads, and so that it does not buckle.
void choose_substeps(const Bodies& bodies, const Contacts& contacts, Islands& islands, const BodyWeights& weights,
                     const WorldDef& settings, StepScratch& step, Communicator* ranks, float dt) {
    StandingColumns& columns = step.solver.columns;
    columns.all.clear();
    for (const std::int32_t i : islands.awake) {
        Island& island = islands.all[i];
        const IslandLoad load = load_of(island);
        island.substeps = wanted_substeps(settings, load, dt);
        if (!may_be_slender(settings, island, load, dt)) continue;
        columns.all.push_back(column_of(bodies, island, weights));
        columns.all.back().island = i;
    }
    if (!columns.all.empty()) { // in most worlds there are no slender columns
        columns.of_island.assign(islands.all.size(), none);
        for (std::size_t k = 0; k < columns.all.size(); ++k)
            columns.of_island[std::size_t(columns.all[k].island)] = std::int32_t(k);
        const auto column_of_contact = [&](std::uint32_t id) {
            return columns.of_island[std::size_t(bodies.links[contacts.info[id].body_a].island)];
        };
        columns.sides.clear();
        for (const std::uint32_t id : step.solved)
            if (may_hold_from_side(contacts.info[id]) && column_of_contact(id) != none)
                columns.sides.push_back({id, {}});
        find_normals(contacts, columns.sides, ranks);
        for (const ContactNormal& side : columns.sides)
            add_side_support(columns.all[std::size_t(column_of_contact(side.contact))],
                             bodies.motion[contacts.info[side.contact].body_a].x, side.normal);
    }
    for (const StandingColumn& column : columns.all) {
        Island& island = islands.all[column.island];
        IslandLoad load = load_of(island);
        load.stable_sinking = stable_sinking(column);
        island.substeps = wanted_substeps(settings, load, dt);
    }
    for (const std::int32_t i : islands.awake) forget_load(islands.all[i]);
}

} // namespace

void rescale_impulses(ContactInfo& c, ContactRecords& records, std::uint32_t id, float h) {
    if (c.substep_time > 0 && records.has(id)) {
        ContactRecord& r = records[id];
        const float factor = carried_share(c.substep_time, h).factor;
        for (float& impulse : r.impulses) impulse *= factor;
        for (float& impulse : r.friction_impulse) impulse *= factor;
        r.torsion_impulse *= factor;
    }
    c.substep_time = h;
}

void pack_batches(const Bodies& bodies, Contacts& contacts, Islands& islands, const ForceFields& fields,
                  const WorldDef& settings, StepScratch& step, Communicator* ranks, float dt) {
    SolverScratch& scratch = step.solver;
    scratch.batches.clear();
    // Only entries of awake islands are used: there may be many more sleeping ones.
    scratch.contacts_of_island.resize(islands.all.size());
    scratch.island_bounces.resize(islands.all.size());
    scratch.weighed_for.resize(islands.all.size());
    scratch.batch_of_island.resize(islands.all.size());
    const int usual = substeps_of(settings, dt);
    const BodyWeights weights(bodies, fields, settings);
    for (const std::int32_t i : islands.awake) {
        scratch.contacts_of_island[i] = 0;
        scratch.island_bounces[i] = 0;
        scratch.weighed_for[i] = std::uint8_t(islands.all[i].substeps > usual ? for_its_substeps : 0);
    }
    choose_substeps(bodies, contacts, islands, weights, settings, step, ranks, dt);
    collect_contacts(bodies, contacts, islands, step.solved, scratch, *step.thread_pool, dt);
    count_standing_loads(bodies, contacts, islands, fields, settings, scratch, ranks, dt);

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
        batch.bounces |= scratch.island_bounces[i] != 0;
        batch.joint_count += island.joint_count;
        if (batch.contact_count + batch.joint_count >= batch_contacts || batch.body_count >= batch_bodies) open = none;
    }

    // Lists the islands in the order of their batches, then the contacts.
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
    sort_by_batch(scratch, *step.thread_pool);
    set_size_anew(scratch.sorted, std::size_t(contact_count));
    scratch.key_ends.resize(scratch.batches.size() * std::size_t(keys_per_batch));
}

} // namespace cairn
