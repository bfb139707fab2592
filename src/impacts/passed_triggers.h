// Triggers that a body passes through within a step: it is outside at the beginning and at the end, so that the narrow
// phase never sees the overlap.
#pragma once

#include "impacts/movers.h"
#include "state/events.h"

namespace cairn {

// Reports the bodies that have entered and left a trigger near their path: both events with their times, sorted by
// time. Changes only the lists of `scratch` and `narrow`.
void report_passed_triggers(const Bodies& bodies, const Shapes& shapes, const Movers& movers, SweepScratch& scratch,
                            NarrowBatch& narrow, StepEvents& events, float dt);

} // namespace cairn
