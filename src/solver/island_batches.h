// Packs islands into batches, which are solved one after another or in parallel.
#pragma once

#include "state/state.h"
#include "state/step_scratch.h"

namespace cairn {

// Decides how many substeps each awake island takes, packs islands into batches and lists the contacts of
// StepScratch::solved by batch (SolverScratch::of_batches). Rescales the stored impulses of contacts whose substep has
// another length than in the last step.
void pack_batches(const Bodies& bodies, Contacts& contacts, Islands& islands, const ForceFields& fields,
                  const WorldDef& settings, StepScratch& step, Communicator* ranks, float dt);

// Rescales stored impulses, which are those of one substep, to a substep of `h` seconds.
void rescale_impulses(ContactInfo& c, ContactRecords& records, std::uint32_t id, float h);

} // namespace cairn
