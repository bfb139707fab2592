// What must be true of each scene whatever the last bits are: the physics that its golden hash cannot tell.
#pragma once

#include "scene_run.h"

#include <span>

namespace cairn_test {

// A number that is measured on a run, and between what it must be. Bounds follow from the scene where they can (a
// count, a height, a law); the others allow at most twice what was seen.
struct Invariant {
    const char* scene;
    const char* what; // with its unit
    double (*measure)(const SceneRun&);
    double lowest, highest;

    bool holds(double value) const { return lowest <= value && value <= highest; } // of no NaN
};

std::span<const Invariant> invariants_of_bodies(); // the scenes of scenes_of_bodies.cpp
std::span<const Invariant> invariants_of_others();

} // namespace cairn_test
