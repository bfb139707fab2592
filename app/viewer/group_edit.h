/// \file group_edit.h
/// What a handle does to several bodies at a time: they move, turn and grow about a common center.
#pragma once

#include "viewer/inspect.h"

#include <span>
#include <utility>
#include <vector>

namespace cairn::viewer {

/// A body, and where it was when the handle was taken.
struct HeldBody {
    BodyId id;
    Transform pose;
};

/// One body in place of several, for handles: at their common center of mass, or without masses at the mean of their
/// places, with the axes of the world.
BodyFacts facts_of_several(const World& world, std::span<const BodyId> bodies);

/// What each of them shall be like, where the body of `facts_of_several` stood at `center` and shall be changed so.
/// Scales are by `scaled` in all since the handle was taken.
std::vector<std::pair<BodyId, BodyEdit>> spread(const BodyEdit& edit, const Position& center, float scaled,
                                                std::span<const HeldBody> held);

} // namespace cairn::viewer
