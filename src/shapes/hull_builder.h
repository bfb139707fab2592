// Declarations shared by the parts of build_hull.
#pragma once

#include "shapes/hull.h"

#include <span>
#include <vector>

namespace cairn::hull {

// Finds support vertices of a convex polyhedron by hill climbing along the edges of its triangles: as the polyhedron is
// convex, a vertex without a higher neighbor is the highest.
class Climber {
  public:
    // Edges between vertices, in any order, each listed once per direction.
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

// Computes `unit_mass` from vertices and faces.
void measure_mass(HullData& hull);
// Computes `inset` and `core` from faces, mass and width.
void inset_core(HullData& hull);

} // namespace cairn::hull
