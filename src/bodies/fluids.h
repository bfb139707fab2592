// What fluids do to the bodies in them: they lift them by the weight of what these displace, resist their motion, and
// some of the fluid moves along. All of that are sums over the wetted surface, whatever the shape is.
//
// Lift. A piece of the surface of area dA with the normal n, at the depth d below the surface, carries a column of the
// volume -d (n . u) dA, with u upward. Over a closed surface the columns are what is displaced, with its moments: the
// lift is its weight, at its middle (Archimedes).
//
// Drag. Newton's law of resistance: a piece that moves with s = n . v > 0 against the fluid is pushed back by
// c/2 rho s^2 dA along its normal, which gives a plate a coefficient of c and a ball one of c / 2; and along its
// surface by c_f/2 rho |t|^2 dA, with t the part of v in that. What bobs gives its motion to waves: by a share of the
// critical damping, taken with the stiffness of the waterline, S, and the volume displaced.
//
// Mass that is moved along (added mass): a share of that of the displaced fluid, as if it turned with the body. In the
// step the body has it as its own, so that contacts and joints know it. Without it, what is light would be thrown out
// of the water: a ball of foam accelerates by 2 g in it, not by 100.
//
// In time. Forces hold for a step, and take what the body would do in it into account: with the velocity change dv that
// all forces but contacts and joints give in the step, drag is that of v + dv with the coefficients of the start, and
// lift that of a body by S dt^2 dv / 4 farther on. So neither overshoots, however light the body and long the step.
// Lift is taken at the pose where the body will be on average, which is what keeps the energy of what bobs: the map of
// a step is symplectic for a linear force.
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

// Adds the forces of fluids on all awake bodies to those of the step, and what moves along to their masses. Once more
// for what has woken since.
void push_by_fluids(const FluidContext& c, FluidScratch& scratch, ThreadPool& threads, float dt);
// Gives the bodies their own masses back.
void unload(Bodies& bodies, FluidScratch& scratch);

} // namespace cairn
