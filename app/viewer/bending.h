/// \file bending.h
/// Skinned meshes: several bodies each carry a part of one mesh.
#pragma once

#include "viewer/meshes.h"

#include <cairn/handle.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace cairn::viewer {

/// The bones of a vertex, up to four, and their weights, which sum to 1.
struct BoneWeights {
    std::array<std::uint16_t, 4> bones{}; ///< Indices into the bones of the visual.
    std::array<float, 4> shares{1.0f, 0.0f, 0.0f, 0.0f};
};

/// A body that carries part of a mesh.
struct Bone {
    BodyId body; ///< Null: the bone is fixed in the world.
    /// Map from mesh coordinates to the frame of the body, or to the world.
    glm::dmat3 linear{1.0};
    glm::dvec3 translation{0.0, 0.0, 0.0}; ///< Meters.
};

/// The map by which a bone alone would transform a vertex.
struct BoneMap {
    glm::mat3 linear{1.0f};
    Vec3 translation{0.0f, 0.0f, 0.0f};
};

/// The skinned mesh: each vertex at the weighted mean of its positions under its bones. `weights`: one for each vertex,
/// with bones that exist in `bones`.
TriangleMesh bent(const TriangleMesh& mesh, std::span<const BoneWeights> weights, std::span<const BoneMap> bones);

} // namespace cairn::viewer
