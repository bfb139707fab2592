// How stiff contacts and joints are: one law for both.
//
// They are Catto's soft constraints ("Soft Constraints", GDC 2011), damped springs of a frequency f and a damping
// ratio. With h the substep,
//
//     f = factor / (h clamp(1/60 s / h, 6, 8))
//
// so that a period takes 6 to 8 substeps (in fewer the sweeps do not settle) and with substeps shorter than an eighth
// of 1/60 s everything becomes stiffer in proportion. It follows the substep without a cap in hertz: a soft contact
// sinks under a load F by F / (m omega^2) whatever the number of sweeps; but in substeps shorter than 0.1 ms, as
// between two of a usual length, what is apart would come together within one, faster than all that moves. The factor
// is 1 for contacts of two bodies that move, and 2 for contacts with what does not and for joints. Softer joints lag
// behind, harder ones gain energy: a hanging net from f h = 0.35 on, an arm that servos hold from 0.28 on with 8
// substeps or more, planks on balls at rest from 0.45 on.
#pragma once

#include "islands/substep_policy.h"
#include "kernels/solve/joint_data.h"
#include "kernels/solve/solver_data.h"

#include <algorithm>

namespace cairn {

inline constexpr float contact_damping_ratio = 10, joint_damping_ratio = 2;

// omega h: the phase that a spring of that factor goes through in a substep, of so many in a step of dt seconds.
inline float substep_phase(float dt, int substeps, float factor) {
    constexpr float pi = 3.14159265358979f;
    const float in_usual_step = float(substeps) * (usual_step / dt);
    const float longer = std::min(dt / float(substeps) / stiffest_substep, 1.0f);
    return 2 * pi * factor * longer / std::clamp(in_usual_step, min_substeps_per_period, max_substeps_per_period);
}

// In one of so many substeps of a step of dt seconds; `recovery_speed`: WorldDef::recovery_speed.
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
