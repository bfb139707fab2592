/// \file bending.h
/// Meshes that bend: several bodies carry them, each a part.
#pragma once

#include "viewer/meshes.h"

#include <cairn/handle.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace cairn::viewer {

/// By how much each of up to four bones carries a vertex. The shares come to 1.
struct BoneWeights {
    std::array<std::uint16_t, 4> bones{}; ///< Indices into the bones of the visual.
    std::array<float, 4> shares{1.0f, 0.0f, 0.0f, 0.0f};
};

/// What carries a part of a mesh.
struct Bone {
    BodyId body; ///< Null: it stands still.
    /// From the coordinates of the mesh to the frame of the body, or to the world.
    glm::dmat3 linear{1.0};
    glm::dvec3 translation{0.0, 0.0, 0.0}; ///< Meters.
};

/// Where a bone carries a vertex, if it alone does.
struct BoneMap {
    glm::mat3 linear{1.0f};
    Vec3 translation{0.0f, 0.0f, 0.0f};
};

/// The mesh with each vertex where its bones carry it on the mean. `weights`: one for each vertex, of bones that are
/// among `bones`.
TriangleMesh bent(const TriangleMesh& mesh, std::span<const BoneWeights> weights, std::span<const BoneMap> bones);

} // namespace cairn::viewer
