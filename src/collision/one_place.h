// Shapes that share their middle. A declaration only: kernels of every instruction set include it.
#pragma once

namespace cairn {

// From the middle of one shape to that of another where the two coincide, in meters: as if each were up to a
// ten-thousandth of `size` beside that place, where its number says. So what is made in one place parts in all
// directions, each in one of its own. Were it the same for all pairs, the last of n would be pushed out n times as fast
// as one. (Symbolic perturbation: Edelsbrunner and Mücke, "Simulation of Simplicity", 1990.)
void offset_in_one_place(float number_a, float number_b, float size, float offset[3]);

} // namespace cairn
