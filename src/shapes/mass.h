// Mass, center of mass and inertia.
#pragma once

#include "math/vec.h"

namespace cairn {

// Mass, center of mass and inertia tensor, in double precision for sums over shapes.
struct MassSum {
    double mass = 0;
    math::DVec3 center;
    math::DSym3 inertia; // about `center`, in the axes of the frame of `center`
};

// The sum of two masses (parallel-axis theorem).
MassSum combine(const MassSum& a, const MassSum& b);

// Principal moments (eigenvalues) and axes of an inertia tensor, by Jacobi rotations.
struct PrincipalInertia {
    math::DVec3 moments;
    math::DQuat axes; // rotation from the principal axes to those of the tensor
};
PrincipalInertia diagonalize(const math::DSym3& inertia);

} // namespace cairn
