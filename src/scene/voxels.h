// A voxel grid of a solid: cells that its surface passes through, and cells inside.
#pragma once

#include <cairn/math.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace cairn::scene {

struct VoxelGrid {
    enum State : std::uint8_t { outside, surface, inside };
    glm::dvec3 origin{0.0}; // the corner of the first cell with the least coordinates
    double cell = 0.0;      // m
    std::array<int, 3> size{};
    std::vector<std::uint8_t> states; // x fastest, then y, then z

    std::size_t index(int x, int y, int z) const {
        return (static_cast<std::size_t>(z) * static_cast<std::size_t>(size[1]) + static_cast<std::size_t>(y)) *
                   static_cast<std::size_t>(size[0]) +
               static_cast<std::size_t>(x);
    }
    std::array<int, 3> place(std::size_t index) const;
};

// Voxelizes triangles, three indices each, with `cells` cells along the longest side. Cells that are not reachable from
// outside count as inside. Returns nothing if the extent is zero, or if voxelizing would take too long.
std::optional<VoxelGrid> voxels_of(std::span<const Vec3> vertices, std::span<const std::uint32_t> indices, int cells);

} // namespace cairn::scene
