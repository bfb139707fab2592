// Islands packed into batches, which are solved one by one or side by side.
#pragma once

#include "state/state.h"
#include "state/step_scratch.h"

namespace cairn {

// Decides how many substeps each awake island takes, packs islands into batches and sorts StepScratch::solved by batch,
// color and number of points. Impulses of contacts whose substeps have another length than in the last step are scaled.
void pack_batches(const Bodies& bodies, Contacts& contacts, Islands& islands, const WorldDef& settings,
                  StepScratch& step, float dt);

} // namespace cairn
