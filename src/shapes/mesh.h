// Triangle meshes and height fields: the immutable data that Mesh and HeightField shapes share.
#pragma once

#include "core/cache.h"
#include "math/bounds.h"
#include "math/vec.h"
#include "shapes/columns.h"

#include <cairn/shape.h>

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace cairn {

inline constexpr std::uint32_t no_triangle = 0xffffffff;

// Eight bounding boxes that are tested together. Unused boxes are NaN, and so overlap nothing.
struct BoxBlock {
    float lo[3][8], hi[3][8]; // by axis

    BoxBlock() {
        for (int axis = 0; axis < 3; ++axis)
            for (int i = 0; i < 8; ++i) lo[axis][i] = hi[axis][i] = std::numeric_limits<float>::quiet_NaN();
    }
    void set(std::size_t i, math::Vec3 least, math::Vec3 greatest) {
        for (int axis = 0; axis < 3; ++axis) lo[axis][i] = least[axis], hi[axis][i] = greatest[axis];
    }
    math::Vec3 lo_of(std::size_t i) const { return {lo[0][i], lo[1][i], lo[2][i]}; }
    math::Vec3 hi_of(std::size_t i) const { return {hi[0][i], hi[1][i], hi[2][i]}; }
    // Prefetches all cache lines of the block.
    void ask() const {
        for (const float* p : {&lo[0][0], &lo[2][0], &hi[1][0], &hi[2][7]}) prefetch(p);
    }
    // One bit per box that overlaps the box from `least` to `greatest` (touching counts).
    unsigned meets(math::Vec3 least, math::Vec3 greatest) const {
        using I4 = std::int32_t __attribute__((vector_size(16)));
        const auto half = [&](int from) {
            I4 all = {-1, -1, -1, -1};
            for (int axis = 0; axis < 3; ++axis)
                all &= (columns::load(&lo[axis][from]) <= columns::splat(greatest[axis])) &
                       (columns::load(&hi[axis][from]) >= columns::splat(least[axis]));
            return all;
        };
        using Pair = std::uint64_t __attribute__((vector_size(16)));
        const auto bits = reinterpret_cast<Pair>((half(0) & I4{1, 2, 4, 8}) | (half(4) & I4{16, 32, 64, 128}));
        const std::uint64_t all = bits[0] | bits[1];
        return unsigned((all | all >> 32) & 255);
    }
};

// Triangles are stored in kd-tree order, with an implicit tree above them: box i of a level contains boxes 8 i to 8 i +
// 7 of the level below, which form block i of that level. Level 0 has the boxes of triangles.
struct MeshData {
    std::vector<math::Vec3> vertices; // distinct, in the order of first use by the triangles
    std::vector<std::uint32_t> indices;
    // The triangle across each edge (0: a-b, 1: b-c, 2: c-a), three per triangle; no_triangle at borders, at edges
    // shared by more than two triangles, and where the neighbor has the opposite winding.
    std::vector<std::uint32_t> neighbors;
    std::vector<std::vector<BoxBlock>> levels; // the last level has one block
    std::uint64_t dropped = 0;                 // number of triangles without area, which are left out
    SurfaceMaterials materials;
    math::Vec3 lo, hi;
    float bounding_radius = 0; // about the origin of the shape's frame
};

// Cell (column, row) has triangles 2 (row (columns - 1) + column), on its side of lesser x, and the next one, on its
// side of greater x. Triangles with a corner of infinite height are holes: they have an index, but do not exist.
struct HeightFieldData {
    int columns = 0, rows = 0;
    float spacing_x = 0, spacing_z = 0;
    std::vector<float> heights;
    SurfaceMaterials materials;
    float least = 0, greatest = 0; // of the finite heights
    float bounding_radius = 0;
};

// Throws Error(invalid_value) with fields "Mesh vertices" and "Mesh indices" (see Mesh in shape.h).
MeshData build_mesh(std::span<const math::Vec3> vertices, std::span<const std::uint32_t> indices,
                    const SurfaceMaterials& materials = {});
// Throws Error(invalid_value) with fields "HeightField columns" and so on (see HeightField in shape.h).
HeightFieldData build_height_field(int columns, int rows, float spacing_x, float spacing_z,
                                   std::span<const float> heights, const SurfaceMaterials& materials = {});

struct Triangle {
    math::Vec3 a, b, c; // counterclockwise as seen from outside
};

inline std::uint32_t triangle_count(const MeshData& mesh) { return std::uint32_t(mesh.indices.size() / 3); }
inline std::uint32_t triangle_count(const HeightFieldData& field) {
    return 2 * std::uint32_t(field.columns - 1) * std::uint32_t(field.rows - 1);
}

// Half the extent of the grid along an axis, and the coordinate of a grid line, rounded to float as in the corners of
// triangles.
inline double grid_half(int lines, float spacing) { return 0.5 * (lines - 1) * double(spacing); }
inline float grid_line(int lines, float spacing, int line) {
    return float((line - 0.5 * (lines - 1)) * double(spacing));
}

inline Triangle triangle_of(const MeshData& mesh, std::uint32_t index) {
    const std::uint32_t* corner = mesh.indices.data() + 3 * std::size_t(index);
    return {mesh.vertices[corner[0]], mesh.vertices[corner[1]], mesh.vertices[corner[2]]};
}

// The cell that contains a triangle of a height field, and which of its halves the triangle is.
struct FieldCell {
    int column, row;
    bool is_second;
};
inline FieldCell cell_of(const HeightFieldData& field, std::uint32_t index) {
    const std::uint32_t cell = index / 2, width = std::uint32_t(field.columns - 1);
    return {int(cell % width), int(cell / width), (index & 1) != 0};
}

// Whether a triangle of a height field is a hole.
inline bool is_hole(const HeightFieldData& field, std::uint32_t index) {
    const FieldCell cell = cell_of(field, index);
    const float* const near = field.heights.data() + std::size_t(cell.row) * std::size_t(field.columns) + cell.column;
    const float* const far = near + field.columns;
    constexpr float none = std::numeric_limits<float>::infinity();
    return near[0] == none || far[1] == none || (cell.is_second ? near[1] : far[0]) == none;
}

inline Triangle triangle_of(const HeightFieldData& field, std::uint32_t index) {
    const FieldCell cell = cell_of(field, index);
    auto corner = [&](int right, int down) -> math::Vec3 {
        const int column = cell.column + right, row = cell.row + down;
        return {grid_line(field.columns, field.spacing_x, column),
                field.heights[std::size_t(row) * std::size_t(field.columns) + std::size_t(column)],
                grid_line(field.rows, field.spacing_z, row)};
    };
    if (cell.is_second) return {corner(0, 0), corner(1, 1), corner(1, 0)};
    return {corner(0, 0), corner(0, 1), corner(1, 1)};
}

// The triangle across an edge (0: a-b, 1: b-c, 2: c-a), or no_triangle.
inline std::uint32_t neighbor_of(const MeshData& mesh, std::uint32_t index, int edge) {
    return mesh.neighbors[3 * std::size_t(index) + std::size_t(edge)];
}
inline std::uint32_t neighbor_of(const HeightFieldData& field, std::uint32_t index, int edge) {
    const FieldCell cell = cell_of(field, index);
    const std::uint32_t row_of_triangles = 2 * std::uint32_t(field.columns - 1);
    const auto across = [&]() -> std::uint32_t {
        if (cell.is_second) {
            if (edge == 0) return index - 1;
            if (edge == 1) return cell.column + 1 < field.columns - 1 ? index + 1 : no_triangle;
            return cell.row > 0 ? index - 1 - row_of_triangles : no_triangle;
        }
        if (edge == 2) return index + 1;
        if (edge == 0) return cell.column > 0 ? index - 1 : no_triangle;
        return cell.row + 1 < field.rows - 1 ? index + 1 + row_of_triangles : no_triangle;
    }();
    return across != no_triangle && is_hole(field, across) ? no_triangle : across;
}

// Calls f(index of triangle), in ascending order, for each triangle whose bounds overlap the box from lo to hi in the
// shape's frame (touching counts).
template <class F> void for_each_triangle(const MeshData& mesh, math::Vec3 lo, math::Vec3 hi, F&& f) {
    constexpr std::size_t max_levels = 11; // with eight children per box, as there are fewer than 2^32 triangles
    unsigned left[max_levels];             // boxes still to visit in the current block of each level
    std::size_t blocks[max_levels];
    const std::size_t top = mesh.levels.size() - 1;
    std::size_t level = top;
    blocks[top] = 0, left[top] = mesh.levels[top][0].meets(lo, hi);
    for (;;) {
        if (left[level] == 0) {
            if (level++ == top) return;
            continue;
        }
        const std::size_t box = 8 * blocks[level] + std::size_t(__builtin_ctz(left[level]));
        left[level] &= left[level] - 1;
        if (level == 0) {
            f(std::uint32_t(box));
            continue;
        }
        --level;
        blocks[level] = box, left[level] = mesh.levels[level][box].meets(lo, hi);
        if (level == 0) continue;
        for (unsigned ahead = left[level]; ahead != 0; ahead &= ahead - 1) // prefetch all of them at once
            mesh.levels[level - 1][8 * box + std::size_t(__builtin_ctz(ahead))].ask();
    }
}

// First and last cell along an axis that may overlap an interval; first > last if there are none.
struct CellRange {
    int first, last;
};
// Cells within rounding error of the interval count.
CellRange cells_between(int lines, float spacing, double lo, double hi);

template <class F> void for_each_triangle(const HeightFieldData& field, math::Vec3 lo, math::Vec3 hi, F&& f) {
    if (!(field.least <= hi.y && field.greatest >= lo.y)) return;
    constexpr float none = std::numeric_limits<float>::infinity();
    const CellRange across = cells_between(field.columns, field.spacing_x, lo.x, hi.x);
    const CellRange along = cells_between(field.rows, field.spacing_z, lo.z, hi.z);
    auto meets = [](int lines, float spacing, int cell, float least, float greatest) {
        return grid_line(lines, spacing, cell) <= greatest && grid_line(lines, spacing, cell + 1) >= least;
    };
    for (int row = along.first; row <= along.last; ++row) {
        if (!meets(field.rows, field.spacing_z, row, lo.z, hi.z)) continue;
        const float* near = field.heights.data() + std::size_t(row) * std::size_t(field.columns);
        const float* far = near + field.columns;
        for (int column = across.first; column <= across.last; ++column) {
            // The corners of the diagonal belong to both halves.
            const float p = near[column], q = far[column + 1], low = p < q ? p : q, high = p < q ? q : p;
            const float others[2] = {far[column], near[column + 1]};
            const std::uint32_t index =
                2 * (std::uint32_t(row) * std::uint32_t(field.columns - 1) + std::uint32_t(column));
            if (!meets(field.columns, field.spacing_x, column, lo.x, hi.x)) continue;
            for (std::uint32_t half = 0; half < 2; ++half)
                if ((low <= hi.y || others[half] <= hi.y) && (high >= lo.y || others[half] >= lo.y) && high < none &&
                    others[half] < none)
                    f(index + half);
        }
    }
}

} // namespace cairn
