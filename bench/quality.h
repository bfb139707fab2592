// How well a scene was simulated, measured from poses and velocities alone, so that no engine is its own judge.
#pragma once

#include "bench/engine.h"
#include "bench/scenes.h"

#include <span>

namespace cairn::bench {

// A part where its body has put it.
struct PlacedPart {
    PartShape shape = PartShape::box;
    Position center{0.0, 0.0, 0.0};
    glm::dvec3 axes[3];                     // box: its unit axes in the world
    glm::dvec3 half_extents{0.0, 0.0, 0.0}; // box, m
    double radius = 0;                      // sphere, m
    double bounding_radius = 0;             // m
};

PlacedPart place(const Part& part, const BodyState& body);

// How deep two parts overlap: the least distance, in m, by which one would have to be moved so that they only touch.
// Exact where they overlap; where they do not, it is negative and at most as far from zero as they are apart.
double penetration(const PlacedPart& a, const PlacedPart& b);

struct Penetrations {
    double greatest = 0; // m
    double p99 = 0;      // of the overlapping pairs, m
    double mean = 0;     // of the overlapping pairs, m
    std::size_t overlaps = 0;
};

// Over all pairs of parts that may move against each other. Bodies that are not finite are left out.
Penetrations measure_penetrations(const Scene& scene, std::span<const BodyState> states);

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
