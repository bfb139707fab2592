// Physical invariants of each scene, which hold whatever the last bits are, and which its golden hash cannot show.
#pragma once

#include "scene_run.h"

#include <span>

namespace cairn_test {

// A quantity measured on a run, and its bounds. Bounds follow from the scene where possible (a count, a height, a law);
// the others allow at most twice the measured value.
struct Invariant {
    const char* scene;
    const char* what; // with unit
    double (*measure)(const SceneRun&);
    double lowest, highest;

    bool holds(double value) const { return lowest <= value && value <= highest; } // false for NaN
};

std::span<const Invariant> invariants_of_bodies(); // scenes of scenes_of_bodies.cpp
std::span<const Invariant> invariants_of_others();

} // namespace cairn_test
