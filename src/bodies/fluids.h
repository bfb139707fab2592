// The effect of fluids on bodies: buoyancy, drag and added mass. All of them are integrals over the wetted surface,
// whatever the shape is.
//
// Buoyancy. A surface element of area dA with the normal n, at the depth d below the surface, carries a column of the
// volume -d (n . u) dA, with u upward. Over a closed surface the columns sum to the displaced volume and its moments:
// the buoyancy is the weight of that volume, at its centroid (Archimedes).
//
// Drag. Newton's law of resistance: an element that moves with s = n . v > 0 relative to the fluid is pushed back by
// c/2 rho s^2 dA along its normal, which gives a plate a drag coefficient of c and a ball one of c / 2. Skin friction
// acts along the surface with c_f/2 rho |t|^2 dA, where t is the tangential part of v. A bobbing body loses energy to
// waves: by a share of the critical damping, computed from the stiffness of the waterline, S, and the displaced volume.
//
// Added mass: a share of the mass of the displaced fluid, as if it rotated with the body. It is part of the body's mass
// during the step, so that contacts and joints account for it. Without it, light bodies would be thrown out of the
// water: with it, a ball of foam accelerates by 2 g, not by 100 g.
//
// Time integration. The forces are constant over a step, and implicit in the motion in it: with the velocity change dv
// that all forces except contacts and joints give in the step, drag is that of v + dv with the coefficients of the
// start, and buoyancy includes the change due to dv, S dt^2 dv / 4. So neither overshoots, however light the body and
// long the step. Buoyancy is evaluated at the pose where the body will be on average, which conserves the energy of a
// bobbing body: the map of a step is symplectic for a linear force.
#pragma once

#include "jobs/thread_pool.h"
#include "state/fluid_scratch.h"
#include "state/state.h"

namespace cairn {

struct FluidContext {
    const WorldDef& settings;
    const ForceFields& fields;
    Bodies& bodies;
    const Shapes& shapes;
    const Islands& islands;
};

// Adds the fluid forces to the step's forces of all awake bodies, and the added mass to their masses. A second call in
// a step handles only bodies that have woken since.
void push_by_fluids(const FluidContext& c, FluidScratch& scratch, ThreadPool& threads, float dt);
// Removes the added mass from the bodies.
void unload(Bodies& bodies, FluidScratch& scratch);

} // namespace cairn
