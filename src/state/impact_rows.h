// What an impact is computed from (impacts/impact_law.h).
#pragma once

#include "math/vec.h"

#include <cstdint>
#include <vector>

namespace cairn {

struct ImpactMaterial {
    double restitution = 0, friction = 0;
    double torsion_radius = 0, rolling_radius = 0; // m
    double restitution_speed = 0;                  // m/s: slower approaches do not bounce
};

struct ImpactPoint {
    math::DVec3 position, normal;       // normal: from the first body to the second
    double depth = 0;                   // m: by which the shapes overlap there
    std::uint16_t surface_material = 0; // of a mesh or height field there: its number (SurfaceMaterials)
    double rebound = 0;                 // m/s: as fast as that it leaves, at least
    ImpactMaterial material{};          // of both
};

// A body at the moment of an impact; with an inverse mass and inertia of 0 it does not react.
struct ImpactBody {
    math::DVec3 x; // center of mass
    math::DVec3 v, w;
    double inverse_mass = 0;
    math::DSym3 inverse_inertia; // world axes
};

// Of which body that is: of a mover, or of what does not move by impacts.
struct StruckBody {
    std::int32_t mover, body; // `mover`: or none
    math::DQuat rotation;
    math::DVec3 v, w; // before the impact
    math::DVec3 belt; // m/s: of its surface
};

// Two bodies, by their places, that touch at some points.
struct ImpactPair {
    std::int32_t a, b;
    int points;
    bool rests = false; // it has met before: nothing bounces, and what does not approach may come to
};

struct ImpactRow {
    math::DVec3 direction, arm_a, arm_b; // arms: r x direction; of a couple, no direction, and its axis
    math::DVec3 turn_a, turn_b;          // inverse inertia times arm
    double inverse_effective_mass, target, impulse;
    std::int32_t a, b, pair, point; // by their places
};

// Working memory of an impact.
struct ImpactBuffer {
    std::vector<ImpactRow> rows;
    std::vector<ImpactBody> before;
};

} // namespace cairn
