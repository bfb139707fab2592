// Contacts of what moves far in a step: at the poses at which the shapes will touch.
#pragma once

#include "contacts/contexts.h"
#include "state/touch.h"

#include <cstdint>
#include <span>

namespace cairn {

// Whether two shapes, which are apart at the start of the step, slide or turn so far before they touch where the
// manifold says that they may touch otherwise, or not at all. Bodies with joints do not move as their velocities say,
// unless they slide by more than the margin in the step.
bool moves_far(const NarrowInput& in, const ContactInfo& contact, const Manifold& manifold, float dt);

// m: the smaller one of the smallest half widths of the two.
double half_width_between(const Shapes& shapes, const ContactInfo& contact);

enum class Approach { passes, now, later };
// When and where the two will touch or be nearest, as their velocities and forces say; `touch` is written unless
// they pass. `axis`: a direction from A to B with which the search begins, or 0. `margin`: how far apart points may be
// at the touch to count.
Approach find_touch(const NarrowInput& in, const ContactInfo& contact, math::DVec3 axis, float dt, float margin,
                    Touch& touch);

// The same with some triangles of a group's surface.
Approach find_touch(const NarrowInput& in, const ContactInfo& group, std::span<const std::uint32_t> triangles, float dt,
                    Touch& touch);

// Likewise of a pair that may touch at once, with A displaced by `lift`, m: how the two would touch then, or be
// nearest; points as far apart as they are without it.
Approach find_lifted_touch(const NarrowInput& in, const ContactInfo& contact, math::DVec3 lift, math::DVec3 axis,
                           float dt, float margin, Touch& touch);
// The same with a group; `own`: working memory.
Approach find_lifted_touch(const NarrowInput& in, const ContactInfo& group, math::DVec3 lift, float dt, float margin,
                           NarrowBatch& own, Touch& touch);

// The outcome of a pair that was tested at the start of the step: what moves far is asked again at the touch.
std::uint8_t take_test(const NarrowInput& in, Contacts& contacts, const NarrowScratch& narrow, std::uint32_t contact,
                       const Manifold& manifold, float dt);

} // namespace cairn
