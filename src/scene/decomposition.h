/// \file decomposition.h
/// Approximate convex decomposition of concave meshes (docs/decisions/decomposition.md).
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

/// How finely a mesh is decomposed.
struct DecompositionLimits {
    std::size_t max_parts = 32; ///< 1 to 64.
    int cells = 48;             ///< Voxels along the longest side, 8 to 128; thinner features are not resolved.
    /// A part is cut if its hull has that much more volume than the part, as a share of the whole mesh's volume; > 0.
    double concavity = 0.01;
};

/// Returns convex hulls that together approximate the solid enclosed by the triangles, which have three indices each,
/// all in range. There is one hull if the solid is convex, or too intricate for the limit of computing time. Equal
/// meshes give equal parts. Throws `Error` (invalid_value) for a mesh that has no hull.
std::vector<Hull> decompose(std::span<const Vec3> vertices, std::span<const std::uint32_t> indices,
                            const DecompositionLimits& limits = {});

/// The convex parts of the surfaces of one file, each decomposed once. Surfaces beyond `max_surfaces`, which would take
/// too long, become their convex hulls.
class SurfaceParts {
  public:
    /// Throws `Error` like `decompose`.
    const std::vector<Hull>& of(const std::shared_ptr<const Surface>& surface);

  private:
    static constexpr std::size_t max_surfaces = 256;
    std::map<std::shared_ptr<const Surface>, std::vector<Hull>> parts_;
};

} // namespace cairn::scene
