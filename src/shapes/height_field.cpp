// Height fields: validation, bounds, and the public class HeightField.
#include "shapes/mesh.h"
#include "shapes/refuse.h"
#include "shapes/surface_materials.h"

#include <cairn/shape.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace cairn {

namespace {

constexpr float min_spacing = 1e-6f, max_spacing = 1e9f; // Range of the grid spacing, m.
constexpr float farthest = 1e6f;                         // greatest absolute height, m
constexpr std::int64_t max_heights = std::int64_t(1) << 28;

void check_spacing(const char* field, float spacing) {
    if (!(spacing >= min_spacing && spacing <= max_spacing))
        refuse(field, number_text(double(spacing)), "must be a size in meters from 1e-6 to 1e9");
}

void check(int columns, int rows, float spacing_x, float spacing_z, std::span<const float> heights) {
    if (columns < 2) refuse("HeightField columns", std::to_string(columns), "must be at least 2");
    if (rows < 2) refuse("HeightField rows", std::to_string(rows), "must be at least 2");
    const std::int64_t count = std::int64_t(columns) * rows;
    if (count > max_heights)
        refuse("HeightField columns x rows", std::to_string(count), "must be at most 2^28 heights");
    check_spacing("HeightField spacing.x", spacing_x);
    check_spacing("HeightField spacing.y", spacing_z);
    if (heights.size() != std::size_t(count))
        refuse("HeightField heights", std::to_string(heights.size()),
               "there must be columns x rows of them, " + std::to_string(count));
    for (std::size_t i = 0; i < heights.size(); ++i)
        if (!(std::fabs(heights[i]) <= farthest) && heights[i] != HeightField::hole)
            refuse("HeightField heights[" + std::to_string(i) + "]", number_text(double(heights[i])),
                   "must be within 1e6 m, or +infinity for a hole");
}

// Finds the range of the finite heights.
void find_extent(HeightFieldData& field) {
    bool any = false;
    for (std::uint32_t t = 0; t < triangle_count(field) && !any; ++t) any = !is_hole(field, t);
    if (!any) refuse("HeightField heights", "holes alone", "must have a triangle whose corners have heights");
    field.least = std::numeric_limits<float>::infinity(), field.greatest = -field.least;
    for (const float height : field.heights)
        if (height != HeightField::hole)
            field.least = std::min(field.least, height), field.greatest = std::max(field.greatest, height);
}

} // namespace

HeightFieldData build_height_field(int columns, int rows, float spacing_x, float spacing_z,
                                   std::span<const float> heights, const SurfaceMaterials& materials) {
    check(columns, rows, spacing_x, spacing_z, heights);
    check_materials("HeightField", materials, std::size_t(columns - 1) * std::size_t(rows - 1));
    HeightFieldData field;
    field.columns = columns;
    field.rows = rows;
    field.spacing_x = spacing_x;
    field.spacing_z = spacing_z;
    field.heights.assign(heights.begin(), heights.end());
    field.materials = materials;
    find_extent(field);
    const double x = grid_half(columns, spacing_x), z = grid_half(rows, spacing_z);
    const double y = std::max(std::fabs(double(field.least)), std::fabs(double(field.greatest)));
    field.bounding_radius = float(std::sqrt(x * x + y * y + z * z) * (1 + 1e-7)); // rounded up
    return field;
}

CellRange cells_between(int lines, float spacing, double lo, double hi) {
    // Grid lines are rounded to float: they deviate by up to half a unit in the last place of the outermost.
    const double half = grid_half(lines, spacing), slack = 1.2e-7 * half;
    if (!(lo <= half + slack && hi >= -half - slack)) return {0, -1};
    auto cell = [&](double at) {
        const double place = (at + half) / double(spacing);
        if (!(place > 0)) return 0;
        return place >= lines - 2 ? lines - 2 : int(place);
    };
    return {cell(lo - slack), cell(hi + slack)};
}

HeightField::HeightField(int columns, int rows, const glm::vec2& spacing, std::span<const float> heights,
                         const SurfaceMaterials& materials)
    : data_(std::make_shared<const HeightFieldData>(
          build_height_field(columns, rows, spacing.x, spacing.y, heights, materials))) {}

int HeightField::columns() const { return data_->columns; }
int HeightField::rows() const { return data_->rows; }
glm::vec2 HeightField::spacing() const { return {data_->spacing_x, data_->spacing_z}; }
std::span<const float> HeightField::heights() const { return data_->heights; }
const SurfaceMaterials& HeightField::materials() const { return data_->materials; }

std::vector<Vec3> HeightField::vertices() const {
    std::vector<Vec3> vertices;
    vertices.reserve(heights().size());
    for (int row = 0; row < rows(); ++row)
        for (int column = 0; column < columns(); ++column)
            vertices.emplace_back(grid_line(columns(), data_->spacing_x, column), heights()[vertices.size()],
                                  grid_line(rows(), data_->spacing_z, row));
    return vertices;
}

std::vector<std::uint32_t> HeightField::indices() const {
    std::vector<std::uint32_t> indices;
    indices.reserve(3 * std::size_t(triangle_count(*data_)));
    for (std::uint32_t t = 0; t < triangle_count(*data_); ++t) {
        if (is_hole(*data_, t)) continue;
        const FieldCell cell = cell_of(*data_, t);
        const std::uint32_t row = std::uint32_t(columns()),
                            at = std::uint32_t(cell.row) * row + std::uint32_t(cell.column);
        if (cell.is_second)
            indices.insert(indices.end(), {at, at + row + 1, at + 1});
        else
            indices.insert(indices.end(), {at, at + row, at + row + 1});
    }
    return indices;
}

} // namespace cairn
