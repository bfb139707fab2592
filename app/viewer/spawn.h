/// \file spawn.h
/// Making new bodies by hand.
#pragma once

#include "viewer/camera.h"

#include <cairn/cairn.h>

#include <map>
#include <utility>

namespace cairn::viewer {

/// What the spawn tool makes.
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
    /// Meters, > 0: edge of the box; diameter of the sphere; height of the others, of which capsules are half as thick,
    /// cylinders and cones as thick as high. Polyhedra fit into a ball of 1.3 times that diameter.
    float size = 0.6f;
    float density = 1000.0f;  ///< kg/m^3, > 0.
    float friction = 0.6f;    ///< Static and dynamic, >= 0.
    float restitution = 0.2f; ///< 0 to 1.
    float speed = 20.0f;      ///< m/s, of what is shot at the cursor; more if it would fall short.

    bool operator==(const SpawnSettings&) const = default;
};
inline constexpr float greatest_shot_speed = 60.0f; // m/s, of the slider: what is farther off is not reached
inline constexpr int spawn_kind_count = 10;
const char* name_of(SpawnSettings::Kind kind);

/// The kinds that are convex hulls of points: one of them at random is what the key for polyhedra makes.
inline constexpr SpawnSettings::Kind polyhedron_kinds[]{
    SpawnSettings::Kind::tetrahedron, SpawnSettings::Kind::octahedron, SpawnSettings::Kind::dodecahedron,
    SpawnSettings::Kind::icosahedron, SpawnSettings::Kind::rock};

/// The bodies of the keys U, I and O.
SpawnSettings box_preset();
SpawnSettings large_sphere_preset();
SpawnSettings small_sphere_preset();
/// Those of the other keys: of that kind, in the default size.
SpawnSettings preset_of(SpawnSettings::Kind kind);

/// The velocity with which something that flies freely goes `way`: on the lower one of its two paths, or, if it is too
/// slow for that, with the least speed that reaches so far.
Vec3 velocity_to_reach(const Vec3& way, float speed, const Vec3& gravity);

/// Makes bodies. Polyhedra of one kind and size share their data.
class Spawner {
  public:
    /// Adds a body at that place. Throws `Error` for settings out of range; the world is unchanged then.
    BodyId spawn(World& world, const SpawnSettings& settings, const Position& position, const Vec3& velocity);
    /// A place near `wanted` where a new body of this size overlaps nothing: the first free one going upwards.
    Position free_place(const World& world, const SpawnSettings& settings, const Position& wanted);

  private:
    Shape shape_of(const SpawnSettings& settings);
    const Hull& hull_of(SpawnSettings::Kind kind, float size);

    std::map<std::pair<SpawnSettings::Kind, float>, Hull> hulls_;
};

} // namespace cairn::viewer
