/// \file scaling.h
/// Scaling of bodies.
#pragma once

#include <cairn/world.h>

namespace cairn::viewer {

/// Whether a body can be scaled along one axis alone: all of its shapes are boxes without rounding along the axes of
/// the body, hulls without rounding, or meshes.
bool can_be_stretched(const World& world, BodyId body);

/// Scales a body about its origin by factors > 0 along its axes, which must be equal unless it can be stretched. Its
/// mass is recomputed from its shapes, or, if it had been set explicitly, scales with its volume. Throws what the
/// world's calls throw, and `Error` (unsupported) for infinite planes.
void scale_body(World& world, BodyId body, const Vec3& factors);

} // namespace cairn::viewer
