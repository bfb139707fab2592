// What the test of two convex shapes leaves for that of the next step: which features met. A number, so that it fits
// into the record of a contact; any number is allowed, as the shapes may have been changed in between.
#pragma once

#include "shapes/gjk.h"

#include <cstdint>

namespace cairn {

struct Axis;

using ContactMemory = std::uint32_t;
inline constexpr ContactMemory nothing_met = 0;

// A face, of the second shape or of the first. Faces beyond 2^28 are not kept.
ContactMemory memory_of_face(int face, bool is_second);
// Puts its number into `axis`; false when it is no face of these shapes.
bool face_of_memory(ContactMemory memory, const Convex& a, const Convex& b, Axis& axis);

// Two edges of the cores of hulls, if they are nearest to each other. Corners beyond 127 are not kept.
ContactMemory memory_of_edges(const CorePair& cores, const GjkResult& found);
// The direction between them, and `touch`; false when they are not nearest to each other anymore.
bool axis_of_edges(ContactMemory memory, const CorePair& cores, Axis& axis);

} // namespace cairn
