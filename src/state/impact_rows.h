// Input and rows of one impact (impacts/impact_law.h).
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
    double depth = 0;                   // m: penetration of the shapes
    std::uint16_t surface_material = 0; // of a mesh or height field: number of the material (SurfaceMaterials)
    double rebound = 0;                 // m/s: lower bound of the speed at which the bodies separate there
    ImpactMaterial material{};          // of both bodies combined
};

// A body at the time of an impact. With inverse mass and inertia 0 it does not react.
struct ImpactBody {
    math::DVec3 x; // center of mass
    math::DVec3 v, w;
    double inverse_mass = 0;
    math::DSym3 inverse_inertia; // world axes
};

// Identifies an impact body: a mover, or a body that impacts do not move.
struct StruckBody {
    std::int32_t mover, body; // `mover`: none if impacts do not move the body
    math::DQuat rotation;
    math::DVec3 v, w; // before the impact
    math::DVec3 belt; // m/s: surface velocity
};

// Two bodies that touch at some points; `a`, `b`: their places among the impact's bodies.
struct ImpactPair {
    std::int32_t a, b;
    int points;
    bool rests = false; // the pair has met before: nothing bounces, and impulses may act at points that do not approach
};

struct ImpactRow {
    math::DVec3 direction, arm_a, arm_b; // arms: r x direction; for a couple the direction is 0, and the arm its axis
    math::DVec3 turn_a, turn_b;          // inverse inertia times arm
    double inverse_effective_mass, target, impulse;
    std::int32_t a, b, pair, point; // places in the impact's lists
};

// Working memory of an impact.
struct ImpactBuffer {
    std::vector<ImpactRow> rows;
    std::vector<ImpactBody> before;
};

} // namespace cairn
