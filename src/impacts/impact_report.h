// Reports impacts: events, and what the contact's record must know of them.
#pragma once

#include "impacts/impact_law.h"
#include "impacts/resolve_impacts.h"

namespace cairn {

// The shapes count as touching until the narrow phase tests them in the next step. `moment`: time of the impact, s
// after the start of the step.
void report_impact(const ImpactContext& context, SolverScratch& solver, const SweptPair& pair,
                   const ImpactOutcome& outcome, double moment);

} // namespace cairn
