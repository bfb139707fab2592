// Broadcasts the results of one rank after another, so that the buffer needs to hold only the largest of them.
#include "solver/rank_results.h"

#include "bodies/finalize.h"
#include "bodies/motion_budget.h"

#include <cstring>

namespace cairn {

namespace {

constexpr int bodies_per_chunk = 128; // for threads

std::size_t size_of(const RankPart& part) {
    return part.bodies.size() * (sizeof(BodyMotion) + sizeof(Travel)) + part.contacts.size() * sizeof(ContactReport);
}

void pack(const Bodies& bodies, const SolverScratch& solver, const RankPart& part, std::byte* out) {
    for (const std::int32_t b : part.bodies) {
        std::memcpy(out, &bodies.motion[b], sizeof(BodyMotion));
        out += sizeof(BodyMotion);
        std::memcpy(out, &bodies.travel[b], sizeof(Travel));
        out += sizeof(Travel);
    }
    for (const std::uint32_t id : part.contacts) {
        std::memcpy(out, &solver.reports[id], sizeof(ContactReport));
        out += sizeof(ContactReport);
    }
}

void unpack(Bodies& bodies, SolverScratch& solver, const RankPart& part, const std::byte* in) {
    for (const std::int32_t b : part.bodies) {
        std::memcpy(&bodies.motion[b], in, sizeof(BodyMotion));
        in += sizeof(BodyMotion);
        Travel travel;
        std::memcpy(&travel, in, sizeof(Travel));
        in += sizeof(Travel);
        if (travel != bodies.travel[b]) spend_separations(bodies, b); // its displacement was limited, or it was stopped
    }
    for (const std::uint32_t id : part.contacts) {
        std::memcpy(&solver.reports[id], in, sizeof(ContactReport));
        in += sizeof(ContactReport);
    }
}

} // namespace

void exchange_results(Communicator& ranks, Bodies& bodies, Shapes& shapes, const BroadPhase& broad_phase,
                      const WorldDef& settings, SolverScratch& solver, ThreadPool& thread_pool, float dt) {
    const RankCut& cut = solver.cut;
    for (int root = 0; root < cut.size; ++root) {
        const RankPart& part = cut.parts[std::size_t(root)];
        if (part.bodies.empty()) continue;
        solver.results.resize(size_of(part));
        if (root == cut.rank) pack(bodies, solver, part, solver.results.data());
        ranks.broadcast(root, solver.results);
        if (root == cut.rank) continue;
        unpack(bodies, solver, part, solver.results.data());
        thread_pool.for_chunks(int(part.bodies.size()), bodies_per_chunk, [&](int begin, int end, int thread) {
            FinalizeScratch& own = solver.at_work[std::size_t(thread)].finalized;
            for (int k = begin; k < end; ++k)
                finalize_body(bodies, shapes, broad_phase, settings, part.bodies[std::size_t(k)], dt, own);
        });
    }
}

} // namespace cairn
