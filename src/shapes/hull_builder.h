// What the parts of build_hull share.
#pragma once

#include "shapes/hull.h"

#include <span>
#include <vector>

namespace cairn::hull {

// The farthest of a convex polyhedron's vertices in a direction, by walking uphill along the edges of triangles: where
// no neighbor is higher, none is (the polyhedron is convex).
class Climber {
  public:
    // `edges` start and end in vertices, in any order, each once in either direction.
    struct Edge {
        std::uint32_t from, to;
    };
    Climber(std::vector<math::DVec3> vertices, std::span<const Edge> edges);
    std::uint32_t farthest(math::DVec3 direction, std::uint32_t start) const;
    const std::vector<math::DVec3>& vertices() const { return vertices_; }

  private:
    std::vector<math::DVec3> vertices_;
    std::vector<std::uint32_t> start_, neighbors_;
};

// Fills `unit_mass` from vertices and faces.
void measure_mass(HullData& hull);
// Fills `inset` and `core` from faces, mass and width.
void inset_core(HullData& hull);

} // namespace cairn::hull
