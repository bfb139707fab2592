// Triggers that something flies through within a step: at its beginning and at its end it is outside, so that the
// narrow phase never sees it in there.
#pragma once

#include "impacts/movers.h"
#include "state/events.h"

namespace cairn {

// What came into one of the triggers near its way and left it again: both events, with their times, all in the order of
// those. Changes the lists of `scratch` and `narrow` alone.
void report_passed_triggers(const Bodies& bodies, const Shapes& shapes, const Movers& movers, SweepScratch& scratch,
                            NarrowBatch& narrow, StepEvents& events, float dt);

} // namespace cairn
