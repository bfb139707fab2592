// Mass, center of mass and inertia.
#pragma once

#include "math/vec.h"

namespace cairn {

// Mass, center of mass and inertia tensor about it, in double for the sums over shapes.
struct MassSum {
    double mass = 0;
    math::DVec3 center;
    math::DSym3 inertia; // about `center`, in the axes that positions are given in
};

// Both together (parallel-axis theorem).
MassSum combine(const MassSum& a, const MassSum& b);

// Principal moments (eigenvalues) and axes of an inertia tensor, by Jacobi rotations.
struct PrincipalInertia {
    math::DVec3 moments;
    math::DQuat axes; // rotation from principal axes
};
PrincipalInertia diagonalize(const math::DSym3& inertia);

} // namespace cairn
