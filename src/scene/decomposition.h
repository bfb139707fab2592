/// \file decomposition.h
/// Concave meshes as several convex parts (docs/decisions/decomposition.md).
#pragma once

#include "scene/scene.h"

#include <cairn/shape.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <vector>

namespace cairn::scene {

/// How fine a mesh is cut.
struct DecompositionLimits {
    std::size_t max_parts = 32; ///< 1 to 64.
    int cells = 48;             ///< Of a grid along the longest side, 8 to 128: what is thinner is not told apart.
    double concavity = 0.01; ///< A part is cut if its hull has that much more volume, as a share of the whole's; > 0.
};

/// Convex hulls that together come near the solid that triangles enclose, three indices each, all in range. One if it
/// is convex, or too intricate for the bounds of time. Equal meshes give equal parts. Throws `Error` (invalid_value)
/// for a mesh that has no hull.
std::vector<Hull> decompose(std::span<const Vec3> vertices, std::span<const std::uint32_t> indices,
                            const DecompositionLimits& limits = {});

/// The parts of the surfaces of one file, each cut once. Of more surfaces than anybody waits for, the rest are hulls.
class SurfaceParts {
  public:
    /// Throws `Error` like `decompose`.
    const std::vector<Hull>& of(const std::shared_ptr<const Surface>& surface);

  private:
    static constexpr std::size_t max_surfaces = 256;
    std::map<std::shared_ptr<const Surface>, std::vector<Hull>> parts_;
};

} // namespace cairn::scene
