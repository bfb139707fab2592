// Edges of shapes, for debug drawing.
#pragma once

#include <cairn/shape.h>

#include <vector>

namespace cairn {

struct Edge {
    Vec3 from, to; // m, in the shape's frame
};

// Clears `edges` first. Curved surfaces are drawn as a few circles, rounded shapes by the outlines of their flat faces,
// and an infinite plane as a square of 20 m with a grid.
void list_edges(const Shape& shape, std::vector<Edge>& edges);

} // namespace cairn
