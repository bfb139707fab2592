// Results of the ranks' parts, one rank after the other, so that there is room for the largest of them alone.
#include "solver/rank_results.h"

#include "bodies/finalize.h"
#include "contacts/contact_record.h"

#include <cstring>

namespace cairn {

namespace {

constexpr int bodies_per_chunk = 128; // for threads

// Of a contact, all that the solver writes.
struct ContactResult {
    float impulses[4];
    float friction[4]; // and torsion
    float totals[4];   // of friction, and of the first point
    float more_totals[4];
    float center_offset[4]; // and restitution
    float points[4][4];
    ContactReport report;
};
static_assert(offsetof(ContactRecord, torsion_impulse) == offsetof(ContactRecord, friction_impulse) + 12);
static_assert(offsetof(ContactRecord, first_total) == offsetof(ContactRecord, total_friction) + 12);
static_assert(offsetof(ContactRecord, restitution) == offsetof(ContactRecord, center_offset) + 12);
static_assert(offsetof(ContactRecord, more_padding) == offsetof(ContactRecord, more_totals) + 12);

std::size_t size_of(const RankPart& part) {
    return part.bodies.size() * sizeof(BodyMotion) + part.contacts.size() * sizeof(ContactResult);
}

void pack(const Bodies& bodies, const Contacts& contacts, const SolverScratch& solver, const RankPart& part,
          std::byte* out) {
    for (const std::int32_t b : part.bodies) {
        std::memcpy(out, &bodies.motion[b], sizeof(BodyMotion));
        out += sizeof(BodyMotion);
    }
    for (const std::uint32_t id : part.contacts) {
        const ContactRecord& r = contacts.records[id];
        ContactResult result;
        std::memcpy(result.impulses, r.impulses, sizeof result.impulses);
        std::memcpy(result.friction, r.friction_impulse, sizeof result.friction);
        std::memcpy(result.totals, r.total_friction, sizeof result.totals);
        std::memcpy(result.more_totals, r.more_totals, sizeof result.more_totals);
        std::memcpy(result.center_offset, r.center_offset, sizeof result.center_offset);
        for (int i = 0; i < 4; ++i) std::memcpy(result.points[i], point_of(r, i), sizeof result.points[i]);
        result.report = solver.reports[id];
        std::memcpy(out, &result, sizeof result);
        out += sizeof result;
    }
}

void unpack(Bodies& bodies, Contacts& contacts, SolverScratch& solver, const RankPart& part, const std::byte* in) {
    for (const std::int32_t b : part.bodies) {
        std::memcpy(&bodies.motion[b], in, sizeof(BodyMotion));
        in += sizeof(BodyMotion);
    }
    for (const std::uint32_t id : part.contacts) {
        ContactResult result;
        std::memcpy(&result, in, sizeof result);
        in += sizeof result;
        ContactRecord& r = contacts.records[id];
        std::memcpy(r.impulses, result.impulses, sizeof result.impulses);
        std::memcpy(r.friction_impulse, result.friction, sizeof result.friction);
        std::memcpy(r.total_friction, result.totals, sizeof result.totals);
        std::memcpy(r.more_totals, result.more_totals, sizeof result.more_totals);
        std::memcpy(r.center_offset, result.center_offset, sizeof result.center_offset);
        for (int i = 0; i < 4; ++i) std::memcpy(point_of(r, i), result.points[i], sizeof result.points[i]);
        r.touch_time = 0;
        solver.reports[id] = result.report;
    }
}

} // namespace

void exchange_results(Communicator& ranks, Bodies& bodies, Shapes& shapes, Contacts& contacts,
                      const BroadPhase& broad_phase, const WorldDef& settings, SolverScratch& solver,
                      ThreadPool& thread_pool, float dt) {
    const RankCut& cut = solver.cut;
    for (int root = 0; root < cut.size; ++root) {
        const RankPart& part = cut.parts[std::size_t(root)];
        if (part.bodies.empty()) continue;
        solver.results.resize(size_of(part));
        if (root == cut.rank) pack(bodies, contacts, solver, part, solver.results.data());
        ranks.broadcast(root, solver.results);
        if (root == cut.rank) continue;
        unpack(bodies, contacts, solver, part, solver.results.data());
        thread_pool.for_chunks(int(part.bodies.size()), bodies_per_chunk, [&](int begin, int end, int thread) {
            FinalizeScratch& own = solver.at_work[std::size_t(thread)].finalized;
            for (int k = begin; k < end; ++k)
                finalize_body(bodies, shapes, broad_phase, settings, part.bodies[std::size_t(k)], dt, own);
        });
    }
}

} // namespace cairn
