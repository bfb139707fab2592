// Shapes with coincident centers. Only a declaration: kernels of every instruction set include it.
#pragma once

namespace cairn {

// The offset between the centers of two coincident shapes, in meters: as if each were displaced by up to 1e-4 of
// `size`, depending on its number. So bodies that are created at one position separate in all directions, each in its
// own. With the same direction for all pairs, the last of n bodies would be pushed out n times as fast as one.
// (Symbolic perturbation: Edelsbrunner and Muecke, "Simulation of Simplicity", 1990.)
void coincident_center_offset(float number_a, float number_b, float size, float offset[3]);

} // namespace cairn
