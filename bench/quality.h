// How well a scene was simulated, measured from poses and velocities alone, so that no engine is its own judge.
#pragma once

#include "bench/engine.h"
#include "bench/overlap.h"
#include "bench/scenes.h"

#include <span>

namespace cairn::bench {

struct Penetrations {
    double greatest = 0; // m
    double p99 = 0;      // of the overlapping pairs, m
    double mean = 0;     // of the overlapping pairs, m
    std::size_t overlaps = 0;
};

// Over all pairs of parts of two bodies that may move against each other and collide. Bodies that are not finite are
// left out.
Penetrations measure_penetrations(const Scene& scene, std::span<const BodyState> states);

struct JointErrors {
    double greatest = 0, mean = 0; // m
};

// How far the two anchors of joints are apart. Joints of bodies that are not finite are left out.
JointErrors measure_joint_errors(const Scene& scene, std::span<const BodyState> states);

struct Displacement {
    double drift = 0; // greatest horizontal distance of any dynamic body from where it was built, m
    double sag = 0;   // greatest drop of any dynamic body below where it was built, m
};

// Bodies that are not finite are left out.
Displacement measure_displacement(const Scene& scene, std::span<const BodyState> states);

// Dynamic bodies that are not finite or have left the bounds of the scene.
std::size_t count_lost(const Scene& scene, std::span<const BodyState> states);

// Of all finite dynamic bodies, linear and rotational, J.
double measure_kinetic_energy(const Scene& scene, std::span<const BodyState> states);

// Changes with any bit of any state.
std::uint64_t hash_of(std::span<const BodyState> states);

} // namespace cairn::bench
