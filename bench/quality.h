// Simulation quality, computed from poses and velocities alone, so that no engine judges itself.
#pragma once

#include "bench/engine.h"
#include "bench/overlap.h"
#include "bench/scenes.h"

#include <span>

namespace cairn::bench {

struct Penetrations {
    double greatest = 0; // m
    double p99 = 0;      // over the overlapping pairs, m
    double mean = 0;     // over the overlapping pairs, m
    std::size_t overlaps = 0;
};

// Measures all pairs of parts of two bodies that can move relative to each other and collide. Bodies with non-finite
// states are omitted.
Penetrations measure_penetrations(const Scene& scene, std::span<const BodyState> states);

struct JointErrors {
    double greatest = 0, mean = 0; // m
};

// Distances between the two anchors of each joint. Joints of bodies with non-finite states are omitted.
JointErrors measure_joint_errors(const Scene& scene, std::span<const BodyState> states);

struct Displacement {
    double drift = 0; // greatest horizontal distance of a dynamic body from its initial position, m
    double sag = 0;   // greatest drop of a dynamic body below its initial position, m
};

// Bodies with non-finite states are omitted.
Displacement measure_displacement(const Scene& scene, std::span<const BodyState> states);

// The number of dynamic bodies with non-finite states or outside the bounds of the scene.
std::size_t count_lost(const Scene& scene, std::span<const BodyState> states);

// Linear and rotational kinetic energy of all finite dynamic bodies, J.
double measure_kinetic_energy(const Scene& scene, std::span<const BodyState> states);

// A hash that depends on every bit of every state.
std::uint64_t hash_of(std::span<const BodyState> states);

} // namespace cairn::bench
