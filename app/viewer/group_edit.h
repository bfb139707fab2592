/// \file group_edit.h
/// Editing several bodies with one handle: they move, rotate and scale about a common center.
#pragma once

#include "viewer/inspect.h"

#include <span>
#include <utility>
#include <vector>

namespace cairn::viewer {

/// A body, and its pose when the handle was grabbed.
struct HeldBody {
    BodyId id;
    Transform pose;
};

/// A stand-in for several bodies, for the handles: at their common center of mass, or without masses at the mean of
/// their positions, with the world's axes.
BodyFacts facts_of_several(const World& world, std::span<const BodyId> bodies);

/// The edits of the single bodies that correspond to an edit of their stand-in (`facts_of_several`), whose position was
/// `center` when the handle was grabbed. `scaled`: total scale factor since then.
std::vector<std::pair<BodyId, BodyEdit>> spread(const BodyEdit& edit, const Position& center, float scaled,
                                                std::span<const HeldBody> held);

} // namespace cairn::viewer
