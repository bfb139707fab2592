// Contacts of bodies that move far in a step are found at the poses at which the shapes will touch.
#pragma once

#include "contacts/contexts.h"
#include "state/touch.h"

#include <cstdint>
#include <span>

namespace cairn {

// Whether two shapes, separated at the start of the step, slide or rotate so far before they touch at the points of the
// manifold that they may touch elsewhere or not at all. Bodies with joints count only if they slide by more than the
// margin in the step, as they do not move exactly as their velocities predict.
bool moves_far(const NarrowInput& in, const ContactInfo& contact, const Manifold& manifold, float dt);

// The smaller of the smallest half widths of the two shapes, m.
double half_width_between(const Shapes& shapes, const ContactInfo& contact);

enum class Approach { passes, now, later };
// Finds when and where the shapes will touch or be nearest, as velocities and forces predict, and writes it to `touch`
// unless they pass each other. `axis`: the direction from A to B in which the search begins, or 0. `margin`: the
// greatest separation of contact points at the touch.
Approach find_touch(const NarrowInput& in, const ContactInfo& contact, math::DVec3 axis, float dt, float margin,
                    Touch& touch);

// The same for some triangles of a mesh contact's surface.
Approach find_touch(const NarrowInput& in, const ContactInfo& group, std::span<const std::uint32_t> triangles, float dt,
                    Touch& touch);

// The same for a pair that may touch at once, with A displaced by `lift`, m: how the shapes would touch then, or be
// nearest. The separations are those without the displacement.
Approach find_lifted_touch(const NarrowInput& in, const ContactInfo& contact, math::DVec3 lift, math::DVec3 axis,
                           float dt, float margin, Touch& touch);
// The same for a mesh contact; `own`: working memory.
Approach find_lifted_touch(const NarrowInput& in, const ContactInfo& group, math::DVec3 lift, float dt, float margin,
                           NarrowBatch& own, Touch& touch);

// Takes the result of a test at the start of the step: a pair that moves far is tested again at its touch.
std::uint8_t take_test(const NarrowInput& in, Contacts& contacts, const NarrowScratch& narrow, std::uint32_t contact,
                       const Manifold& manifold, float dt);

} // namespace cairn
