/// \file spawn.h
/// Making new bodies by hand.
#pragma once

#include "viewer/camera.h"

#include <cairn/cairn.h>

namespace cairn::viewer {

/// What the spawn tool makes.
struct SpawnSettings {
    enum class Kind { box, sphere };
    Kind kind = Kind::box;
    float size = 0.6f;        ///< Edge of the box or diameter of the sphere, meters, > 0.
    float density = 1000.0f;  ///< kg/m^3, > 0.
    float friction = 0.6f;    ///< Static and dynamic, >= 0.
    float restitution = 0.2f; ///< 0 to 1.
    float speed = 12.0f;      ///< m/s, of what is shot along the cursor's ray.

    bool operator==(const SpawnSettings&) const = default;
};

/// The three bodies of the keys U, I and O.
SpawnSettings box_preset();
SpawnSettings large_sphere_preset();
SpawnSettings small_sphere_preset();

/// Adds a body at that place. Throws `Error` for settings out of range; the world is unchanged then.
BodyId spawn(World& world, const SpawnSettings& settings, const Position& position, const Vec3& velocity);

/// A place near `wanted` where a new body of this size overlaps nothing: the first free one going upwards.
Position free_place(const World& world, const SpawnSettings& settings, const Position& wanted);

} // namespace cairn::viewer
