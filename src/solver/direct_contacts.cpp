#include "solver/direct_contacts.h"

#include "kernels/kernels.h"
#include "solver/batch_lanes.h"
#include "state/state.h"

#include <algorithm>
#include <cstddef>

namespace cairn {

namespace {

constexpr int contacts_per_chunk = 16; // for threads

// Calls `f` for each dynamic body of a set that contacts touch.
template <class F> void for_touched_bodies(const DirectSets& direct, const DirectWork& work, F&& f) {
    for (const DirectSolve& solve : work.sets) {
        if (!solve.is_touched) continue;
        const DirectBody* const bodies = work.bodies.data() + solve.first_body;
        for (std::size_t i = 0; i < direct.sets[solve.set].bodies.size(); ++i)
            if (bodies[i].by_forces) f(bodies[i]);
    }
}

} // namespace

void list_direct_contacts(const DirectSets& direct, BatchScratch& scratch) {
    DirectWork& work = scratch.direct;
    work.contacts.clear();
    if (std::none_of(work.sets.begin(), work.sets.end(), [](const DirectSolve& s) { return s.is_touched; })) return;
    work.is_touched_row.assign(scratch.row_count(), 0);
    for_touched_bodies(direct, work, [&](const DirectBody& b) { work.is_touched_row[std::size_t(b.row)] = 1; });
    const auto is_touched = [&](std::int32_t row) { return work.is_touched_row[std::size_t(row)] != 0; };
    const auto list = [&](const LaneLists& lanes, bool four_points) {
        for_lanes_of(lanes, is_touched, [&](std::size_t block, std::uint8_t bits) {
            work.contacts.push_back({std::int32_t(block), four_points, bits});
        });
    };
    list(scratch.one_lanes, false);
    list(scratch.four_lanes, true);
}

void share_inertia(const DirectSets& direct, BatchScratch& scratch) {
    for_touched_bodies(direct, scratch.direct, [&](const DirectBody& b) {
        const math::DSym3& m = b.inverse_inertia;
        scratch.inertia[std::size_t(b.row)] = {float(b.inverse_mass), float(m.xx), float(m.xy), float(m.xz),
                                               float(m.yy),           float(m.yz), float(m.zz), 0};
    });
}

void renew_direct_contacts(BatchScratch& scratch, ThreadPool* thread_pool) {
    const std::vector<DirectContacts>& contacts = scratch.direct.contacts;
    if (contacts.empty()) return;
    const SolverKernels& k = kernels().solver;
    for_chunks(thread_pool, int(contacts.size()), contacts_per_chunk, [&](int begin, int end, int) {
        for (int i = begin; i < end; ++i) {
            const DirectContacts& c = contacts[std::size_t(i)];
            if (c.four_points)
                k.four_points.renew_masses(&scratch.four_blocks[std::size_t(c.block)], &c.lanes, 1,
                                           scratch.inertia.data());
            else
                k.one_point.renew_masses(&scratch.one_blocks[std::size_t(c.block)], &c.lanes, 1,
                                         scratch.inertia.data());
        }
    });
}

} // namespace cairn
