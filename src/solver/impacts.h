// Impacts: contacts with a high approach speed are solved at once by separate passes over all nearby constraint rows,
// including the contacts that the impact spreads to. docs/solver.md gives the reasons.
#pragma once

#include "jobs/thread_pool.h"
#include "state/direct_sets.h"
#include "state/solver_scratch.h"
#include "state/state.h"

#include <cairn/communicator.h>

#include <atomic>

namespace cairn {

inline constexpr float impact_speed = 0.75f; // m/s: slower approaches are left to the soft solver
inline constexpr float no_impact_speed = 1e30f;

// Bodies and settings of an impact with restitution. Not used in a batch that is cut, which never has joints.
struct Bouncing {
    const SolverBodies& bodies; // their velocity_correction is changed
    const BounceSettings& settings;
};

// Called after the solver has visited all rows of a batch. `impact_contacts`: nonzero if the solver left contacts of
// any block to be solved here; reset to 0. `bounce`: contacts rebound by their restitution, and the contacts that they
// hit in turn are left to the next bounce pass; null: approaches are stopped. `ranks`: for a batch that is cut. Returns
// whether there was an impact.
bool solve_impacts(const Bodies& bodies, const Joints& joints, const DirectSets& direct, BatchScratch& scratch,
                   ThreadPool* thread_pool, Communicator* ranks, const ContactSoftness& softness,
                   const Bouncing* bounce, std::atomic<int>& impact_contacts);

} // namespace cairn
