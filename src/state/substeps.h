// How many substeps a step takes where nothing asks for more.
#pragma once

#include <cairn/world.h>

#include <algorithm>
#include <cmath>

namespace cairn {

inline constexpr int max_substeps = 256; // that a world may ask for

// s: how long a step usually is. What comes between two steps does not know how long the next one will be.
inline constexpr float usual_step = 1.0f / 60;

// What takes so many substeps in the usual step takes so many in one of dt seconds: what counts is how long they are,
// which is at most as long as there, to a thousandth.
inline int substeps_in(float dt, int in_usual_step) {
    const double count = std::ceil(double(in_usual_step) * double(dt) / double(usual_step) - 1e-3);
    return int(std::clamp(count, 1.0, double(max_substeps)));
}

constexpr int usual_substeps = 6; // in the usual step

// The world's own number, or as many as are usual in a step of dt seconds.
inline int substeps_of(const WorldDef& settings, float dt) {
    return settings.substeps > 0 ? settings.substeps : substeps_in(dt, usual_substeps);
}

// s: with a substep shorter than that nothing becomes stiffer, nor is anything that is apart brought together faster.
inline constexpr float stiffest_substep = 1e-4f;

// What the impulses of a substep of `before` seconds (0: none) are in one of h. They are forces; but a good part of
// what a far shorter one gave is what its rounding and its passes left over, and would grow with h. What is not known
// is not asked for: is_known.
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
