// Islands packed into batches, which are solved one by one or side by side.
#pragma once

#include "state/state.h"
#include "state/step_scratch.h"

namespace cairn {

// Decides how many substeps each awake island takes, packs islands into batches and lists the contacts of
// StepScratch::solved by batch (SolverScratch::of_batches). Impulses of contacts whose substeps have another length
// than in the last step are scaled.
void pack_batches(const Bodies& bodies, Contacts& contacts, Islands& islands, const ForceFields& fields,
                  const WorldDef& settings, StepScratch& step, Communicator* ranks, float dt);

// Impulses are those of one substep: with another length of it, `h` in s, they are others.
void rescale_impulses(ContactInfo& c, ContactRecords& records, std::uint32_t id, float h);

} // namespace cairn
