/// \file scaling.h
/// Bodies of another size.
#pragma once

#include <cairn/world.h>

namespace cairn::viewer {

/// Whether it can be scaled along one axis alone: all of its shapes are sharp boxes along the axes of the body, sharp
/// hulls, or meshes.
bool can_be_stretched(const World& world, BodyId body);

/// Scales a body about its origin by factors > 0 along its axes, which must be equal unless it can be stretched. Its
/// mass follows its shapes, or, if it had been given, its volume. Throws what the world's calls throw, and `Error`
/// (unsupported) for infinite planes.
void scale_body(World& world, BodyId body, const Vec3& factors);

} // namespace cairn::viewer
