/// \file culling.h
/// Which parts of a large mesh a picture can show.
#pragma once

#include "viewer/render_frame.h"

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace cairn::viewer {

/// The four planes through the sides of a picture: x, y and z of a plane point inwards, with unit length. What lies
/// behind the eye lies outside of one of them too.
using SidePlanes = std::array<glm::vec4, 4>;
SidePlanes side_planes(const glm::mat4& clip_from_world);

/// Indices `first` to `first + count - 1` of a mesh.
struct IndexRange {
    std::size_t first = 0, count = 0;
};

/// The parts of a mesh that may be seen of any of its instances, in order, neighbors joined. A few that are not seen
/// may be among them.
std::vector<IndexRange> visible_ranges(const ShapeMesh& mesh, std::span<const Instance> instances,
                                       const SidePlanes& planes);

} // namespace cairn::viewer
