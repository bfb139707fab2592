// The features that met in the last test of two convex shapes, kept for the next step. Encoded as a number, so that it
// fits into the contact; any number is valid, as the shapes may have changed since.
#pragma once

#include "shapes/gjk.h"

#include <cstdint>

namespace cairn {

struct Axis;

using ContactMemory = std::uint32_t;
inline constexpr ContactMemory nothing_met = 0;

// Encodes a face of the second or first shape. Faces beyond 2^28 are not kept.
ContactMemory memory_of_face(int face, bool is_second);
// Decodes a face into `axis`; false if these shapes have no such face.
bool face_of_memory(ContactMemory memory, const Convex& a, const Convex& b, Axis& axis);

// Encodes the two nearest edges of the cores of hulls, if edges are nearest. Vertices beyond 127 are not kept.
ContactMemory memory_of_edges(const CorePair& cores, const GjkResult& found);
// Computes the direction between the two edges, and `touch`; false if they are not nearest to each other now.
bool axis_of_edges(ContactMemory memory, const CorePair& cores, Axis& axis);

} // namespace cairn
