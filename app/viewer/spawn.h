/// \file spawn.h
/// Creating new bodies by hand.
#pragma once

#include "viewer/camera.h"

#include <cairn/cairn.h>

#include <map>
#include <utility>

namespace cairn::viewer {

/// Settings of the spawn tool.
struct SpawnSettings {
    enum class Kind {
        box,
        sphere,
        capsule,
        cylinder,
        cone,
        tetrahedron,
        octahedron,
        dodecahedron,
        icosahedron,
        rock,
    };
    Kind kind = Kind::box;
    /// Meters, > 0: edge of the box; diameter of the sphere; height of the others, of which capsules are half as wide,
    /// cylinders and cones as wide as high. Polyhedra fit into a sphere of 1.3 times that diameter.
    float size = 0.6f;
    float density = 1000.0f;  ///< kg/m^3, > 0.
    float friction = 0.6f;    ///< Static and dynamic, >= 0.
    float restitution = 0.2f; ///< 0 to 1.
    float speed = 20.0f; ///< Launch speed of a body shot at the cursor, m/s; increased if the body would fall short.

    bool operator==(const SpawnSettings&) const = default;
};
// End of the slider and limit of the launch speed, m/s: targets beyond its range are not reached.
inline constexpr float greatest_shot_speed = 60.0f;
inline constexpr int spawn_kind_count = 10;
const char* name_of(SpawnSettings::Kind kind);

/// The kinds that are convex hulls of points; the key for polyhedra picks one at random.
inline constexpr SpawnSettings::Kind polyhedron_kinds[]{
    SpawnSettings::Kind::tetrahedron, SpawnSettings::Kind::octahedron, SpawnSettings::Kind::dodecahedron,
    SpawnSettings::Kind::icosahedron, SpawnSettings::Kind::rock};

/// The bodies that the keys U, I and O create.
SpawnSettings box_preset();
SpawnSettings large_sphere_preset();
SpawnSettings small_sphere_preset();
/// The bodies that the other keys create: of that kind, in the default size.
SpawnSettings preset_of(SpawnSettings::Kind kind);

/// The launch velocity of a projectile for the displacement `way`: on the lower of the two possible trajectories, or,
/// if `speed` is too low, with the least sufficient speed.
Vec3 velocity_to_reach(const Vec3& way, float speed, const Vec3& gravity);

/// Creates bodies. Polyhedra of one kind and size share their data.
class Spawner {
  public:
    /// Adds a body at that place. Throws `Error` for settings out of range; the world is unchanged then.
    BodyId spawn(World& world, const SpawnSettings& settings, const Position& position, const Vec3& velocity);
    /// The lowest position at or above `wanted` at which a new body of this size overlaps nothing.
    Position free_place(const World& world, const SpawnSettings& settings, const Position& wanted);

  private:
    Shape shape_of(const SpawnSettings& settings);
    const Hull& hull_of(SpawnSettings::Kind kind, float size);

    std::map<std::pair<SpawnSettings::Kind, float>, Hull> hulls_;
};

} // namespace cairn::viewer
