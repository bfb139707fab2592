// The stiffness of contacts and joints, which follows one law for both.
//
// Contacts and joints are Catto's soft constraints ("Soft Constraints", GDC 2011): damped springs of a frequency f and
// a damping ratio. With the substep h,
//
//     f = factor / (h clamp(1/60 s / h, 6, 8))
//
// so that a period takes 6 to 8 substeps (with fewer, the sweeps do not converge), and all constraints become stiffer
// in proportion when substeps are shorter than an eighth of 1/60 s. The frequency follows the substep without a cap in
// hertz: a soft contact sinks under a load F by F / (m omega^2) whatever the number of sweeps. In substeps shorter than
// 0.1 ms, however, as in a very short step between two of usual length, the frequency stays that of 0.1 ms: otherwise a
// gap would be closed within one substep, faster than anything else moves. The factor is 1 for contacts between two
// moving bodies, and 2 for joints and for contacts with bodies that do not move. Softer joints lag behind, stiffer ones
// gain energy: a hanging net from f h = 0.35 on, an arm held by servos from 0.28 on with 8 substeps or more, planks on
// balls at rest from 0.45 on.
#pragma once

#include "islands/substep_policy.h"
#include "kernels/solve/joint_data.h"
#include "kernels/solve/solver_data.h"

#include <algorithm>

namespace cairn {

inline constexpr float contact_damping_ratio = 10, joint_damping_ratio = 2;

// omega h: the phase angle (rad) that a spring with this factor passes through in one of `substeps` substeps of a step
// of dt seconds.
inline float substep_phase(float dt, int substeps, float factor) {
    constexpr float pi = 3.14159265358979f;
    const float in_usual_step = float(substeps) * (usual_step / dt);
    const float longer = std::min(dt / float(substeps) / stiffest_substep, 1.0f);
    return 2 * pi * factor * longer / std::clamp(in_usual_step, min_substeps_per_period, max_substeps_per_period);
}

// Contact softness for one of `substeps` substeps of a step of dt seconds; `recovery_speed`: WorldDef::recovery_speed.
inline ContactSoftness contact_softness(float dt, int substeps, float recovery_speed) {
    const float h = dt / float(substeps);
    const auto spring = [&](float factor) {
        const float omega_h = substep_phase(dt, substeps, factor);
        const float a1 = 2 * contact_damping_ratio + omega_h, a2 = omega_h * a1;
        const float scale = a2 / (1 + a2);
        return ContactSoftness::Spring{scale, omega_h / (a1 * h), recovery_speed / scale};
    };
    ContactSoftness s;
    s.h = h;
    s.inverse_h = 1 / h;
    s.inverse_elapsed = s.inverse_h;
    s.middle = 0.5f * h;
    s.on_movable = spring(1);
    s.on_immovable = spring(stiff_factor);
    return s;
}

inline JointSoftness joint_softness(float dt, int substeps) {
    const float h = dt / float(substeps);
    const float omega_h = substep_phase(dt, substeps, stiff_factor);
    const float a1 = 2 * joint_damping_ratio + omega_h, a2 = omega_h * a1;
    return {h, 1 / h, a2 / (1 + a2), omega_h / (a1 * h)};
}

} // namespace cairn
