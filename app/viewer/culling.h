/// \file culling.h
/// Frustum culling of the parts of a large mesh.
#pragma once

#include "viewer/render_frame.h"

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace cairn::viewer {

/// The four side planes of the view frustum: x, y and z of a plane are its inward unit normal. Points behind the eye
/// lie outside at least one of them.
using SidePlanes = std::array<glm::vec4, 4>;
SidePlanes side_planes(const glm::mat4& clip_from_world);

/// Indices `first` to `first + count - 1` of a mesh.
struct IndexRange {
    std::size_t first = 0, count = 0;
};

/// The parts of a mesh that may be visible in any of its instances, in order, with adjacent ranges merged.
/// Conservative: a few invisible parts may be included.
std::vector<IndexRange> visible_ranges(const ShapeMesh& mesh, std::span<const Instance> instances,
                                       const SidePlanes& planes);

} // namespace cairn::viewer
