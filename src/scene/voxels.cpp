#include "scene/voxels.h"

#include <algorithm>
#include <cmath>

namespace cairn::scene {

namespace {

constexpr std::size_t max_box_tests = 100'000'000; // about a second

// Whether a triangle and a box around the origin are disjoint: separating axis test with the 13 axes of Akenine-Moller,
// "Fast 3D triangle-box overlap testing" (2001).
bool are_apart(const std::array<glm::dvec3, 3>& t, const glm::dvec3& half) {
    const auto parts = [&](const glm::dvec3& axis) {
        const double reach = std::fabs(axis.x) * half.x + std::fabs(axis.y) * half.y + std::fabs(axis.z) * half.z;
        const double a = glm::dot(axis, t[0]), b = glm::dot(axis, t[1]), c = glm::dot(axis, t[2]);
        return std::min({a, b, c}) > reach || std::max({a, b, c}) < -reach;
    };
    glm::dvec3 axes[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (const glm::dvec3& axis : axes) {
        if (parts(axis)) return true;
    }
    const glm::dvec3 edges[3] = {t[1] - t[0], t[2] - t[1], t[0] - t[2]};
    if (parts(glm::cross(edges[0], edges[1]))) return true;
    for (const glm::dvec3& edge : edges) {
        for (const glm::dvec3& axis : axes) {
            if (parts(glm::cross(axis, edge))) return true;
        }
    }
    return false;
}

class SurfaceMarker {
  public:
    explicit SurfaceMarker(VoxelGrid& grid) : grid_(grid) {}

    // Marks the cells that a triangle passes through; returns false if that takes too long.
    bool mark(const std::array<glm::dvec3, 3>& triangle) {
        std::array<int, 3> low{}, high{};
        for (int k = 0; k < 3; ++k) {
            const double least = std::min({triangle[0][k], triangle[1][k], triangle[2][k]}),
                         most = std::max({triangle[0][k], triangle[1][k], triangle[2][k]});
            const std::size_t i = static_cast<std::size_t>(k);
            low[i] = std::clamp(static_cast<int>(std::floor(least)), 0, grid_.size[i] - 1);
            high[i] = std::clamp(static_cast<int>(std::floor(most)), 0, grid_.size[i] - 1);
        }
        triangle_ = triangle;
        descend(low, high);
        return tests_ <= max_box_tests;
    }

  private:
    void descend(const std::array<int, 3>& low, const std::array<int, 3>& high) {
        if (++tests_ > max_box_tests) return;
        glm::dvec3 middle, half;
        std::size_t longest = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            middle[static_cast<int>(k)] = 0.5 * (low[k] + high[k] + 1);
            half[static_cast<int>(k)] = 0.5 * (high[k] + 1 - low[k]);
            if (high[k] - low[k] > high[longest] - low[longest]) longest = k;
        }
        if (are_apart({triangle_[0] - middle, triangle_[1] - middle, triangle_[2] - middle}, half)) return;
        if (high[longest] == low[longest]) {
            grid_.states[grid_.index(low[0], low[1], low[2])] = VoxelGrid::surface;
            return;
        }
        std::array<int, 3> cut_high = high, cut_low = low;
        cut_high[longest] = (low[longest] + high[longest]) / 2;
        cut_low[longest] = cut_high[longest] + 1;
        descend(low, cut_high);
        descend(cut_low, high);
    }

    VoxelGrid& grid_;
    std::array<glm::dvec3, 3> triangle_{}; // in units of cells
    std::size_t tests_ = 0;
};

// Flood fill from outside: cells that it does not reach stay inside. All cells are initially inside.
void flood(VoxelGrid& grid) {
    std::vector<std::size_t> open{0}; // a corner cell, which the margin keeps free of the surface
    grid.states[0] = VoxelGrid::outside;
    while (!open.empty()) {
        const std::array<int, 3> at = grid.place(open.back());
        open.pop_back();
        for (std::size_t k = 0; k < 3; ++k) {
            for (const int step : {-1, 1}) {
                std::array<int, 3> next = at;
                next[k] += step;
                if (next[k] < 0 || next[k] >= grid.size[k]) continue;
                const std::size_t index = grid.index(next[0], next[1], next[2]);
                if (grid.states[index] != VoxelGrid::inside) continue;
                grid.states[index] = VoxelGrid::outside;
                open.push_back(index);
            }
        }
    }
}

} // namespace

std::array<int, 3> VoxelGrid::place(std::size_t index) const {
    const std::size_t x = static_cast<std::size_t>(size[0]), y = static_cast<std::size_t>(size[1]);
    return {static_cast<int>(index % x), static_cast<int>(index / x % y), static_cast<int>(index / x / y)};
}

std::optional<VoxelGrid> voxels_of(std::span<const Vec3> vertices, std::span<const std::uint32_t> indices, int cells) {
    glm::dvec3 low(1e30), high(-1e30);
    for (const std::uint32_t i : indices) {
        low = glm::min(low, glm::dvec3(vertices[i])), high = glm::max(high, glm::dvec3(vertices[i]));
    }
    const glm::dvec3 extent = high - low;
    VoxelGrid grid;
    grid.cell = std::max({extent.x, extent.y, extent.z}) / cells;
    if (!(grid.cell > 0.0 && grid.cell < 1e12)) return std::nullopt;
    // The margin is not a whole number of cells, so that axis-aligned faces lie inside cells, not on their boundaries.
    constexpr double margin = 1.37;
    grid.origin = low - margin * grid.cell;
    std::size_t count = 1;
    for (int k = 0; k < 3; ++k) {
        grid.size[static_cast<std::size_t>(k)] = static_cast<int>(std::ceil(extent[k] / grid.cell + 2.0 * margin));
        count *= static_cast<std::size_t>(grid.size[static_cast<std::size_t>(k)]);
    }
    grid.states.assign(count, VoxelGrid::inside);
    SurfaceMarker marker(grid);
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
        const auto corner = [&](std::size_t k) {
            return (glm::dvec3(vertices[indices[i + k]]) - grid.origin) / grid.cell;
        };
        if (!marker.mark({corner(0), corner(1), corner(2)})) return std::nullopt;
    }
    flood(grid);
    return grid;
}

} // namespace cairn::scene
