// The edges of shapes, for pictures of them.
#pragma once

#include <cairn/shape.h>

#include <vector>

namespace cairn {

struct Edge {
    Vec3 from, to; // m, in the shape's frame
};

// Round surfaces have some circles, what is rounded the outlines of its flat faces, infinite planes a square of 20 m
// with a grid. Empties the list before.
void list_edges(const Shape& shape, std::vector<Edge>& edges);

} // namespace cairn
