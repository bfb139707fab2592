// How many substeps a step takes if its islands need no more.
#pragma once

#include <cairn/world.h>

#include <algorithm>
#include <cmath>

namespace cairn {

inline constexpr int max_substeps = 256; // upper limit of WorldDef::substeps

// The usual length of a step, s. Decisions between two steps use it, as the next step's length is not known yet.
inline constexpr float usual_step = 1.0f / 60;

// The number of substeps in a step of dt seconds that corresponds to a number in the usual step: substeps are at most
// as long as there, within a thousandth.
inline int substeps_in(float dt, int in_usual_step) {
    const double count = std::ceil(double(in_usual_step) * double(dt) / double(usual_step) - 1e-3);
    return int(std::clamp(count, 1.0, double(max_substeps)));
}

constexpr int usual_substeps = 6; // per usual step

// The number that the world's settings give, or else the usual number for a step of dt seconds.
inline int substeps_of(const WorldDef& settings, float dt) {
    return settings.substeps > 0 ? settings.substeps : substeps_in(dt, usual_substeps);
}

// s: shorter substeps neither make contacts and joints stiffer nor close gaps faster.
inline constexpr float stiffest_substep = 1e-4f;

// Converts impulses of a substep of `before` seconds (0: none) to a substep of h. Impulses act as forces, in proportion
// to the length; but many of the impulses of a far shorter substep are rounding errors and unconverged residuals, which
// would grow with h. is_known: whether the result may be used.
struct CarriedShare {
    float factor;
    bool is_known;
};
inline CarriedShare carried_share(float before, float h) {
    constexpr float most = 4;
    if (!(before > 0)) return {0, false};
    return {std::min(h / before, most), h <= most * before};
}

} // namespace cairn
