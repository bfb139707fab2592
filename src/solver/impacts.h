// Impacts: what hits a contact is stopped at once, by passes over all rows near it, and what that hits in turn.
// docs/solver.md says why.
#pragma once

#include "jobs/thread_pool.h"
#include "state/direct_sets.h"
#include "state/solver_scratch.h"
#include "state/state.h"

#include <cairn/communicator.h>

#include <atomic>

namespace cairn {

inline constexpr float impact_speed = 0.75f; // m/s: slower approaches are left to the solver
inline constexpr float no_impact_speed = 1e30f;

// Where bodies bounce at what they hit: not in a batch that is cut, as none with joints is.
struct Bouncing {
    const SolverBodies& bodies; // their velocity_correction changes
    const BounceSettings& settings;
};

// After the solver has gone over all rows of a batch. `struck_contacts`: whether it left any block's to be solved here;
// it is set back to 0. `bounce`: what arrives at a contact leaves it by its restitution, and what that hits is left to
// the next bounce; null: it stops. `ranks`: of a batch that is cut. Returns whether there was an impact.
bool solve_impacts(const Bodies& bodies, const Joints& joints, const DirectSets& direct, BatchScratch& scratch,
                   ThreadPool* thread_pool, Communicator* ranks, const ContactSoftness& softness,
                   const Bouncing* bounce, std::atomic<int>& struck_contacts);

} // namespace cairn
