// Height fields: checks, bounds, and the public HeightField.
#include "shapes/mesh.h"
#include "shapes/refuse.h"

#include <cairn/shape.h>

#include <algorithm>
#include <cmath>

namespace cairn {

namespace {

constexpr float min_spacing = 1e-6f, max_spacing = 1e9f; // m
constexpr float farthest = 1e6f;                         // m
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
        if (!(std::fabs(heights[i]) <= farthest))
            refuse("HeightField heights[" + std::to_string(i) + "]", number_text(double(heights[i])),
                   "must be finite and within 1e6 m");
}

} // namespace

HeightFieldData build_height_field(int columns, int rows, float spacing_x, float spacing_z,
                                   std::span<const float> heights) {
    check(columns, rows, spacing_x, spacing_z, heights);
    HeightFieldData field;
    field.columns = columns;
    field.rows = rows;
    field.spacing_x = spacing_x;
    field.spacing_z = spacing_z;
    field.heights.assign(heights.begin(), heights.end());
    field.least = *std::min_element(heights.begin(), heights.end());
    field.greatest = *std::max_element(heights.begin(), heights.end());
    const double x = grid_half(columns, spacing_x), z = grid_half(rows, spacing_z);
    const double y = std::max(std::fabs(double(field.least)), std::fabs(double(field.greatest)));
    field.bounding_radius = float(std::sqrt(x * x + y * y + z * z) * (1 + 1e-7)); // rounded outward
    return field;
}

CellRange cells_between(int lines, float spacing, double lo, double hi) {
    // Lines lie where float puts them: up to half a unit in the last place of the outermost away.
    const double half = grid_half(lines, spacing), slack = 1.2e-7 * half;
    if (!(lo <= half + slack && hi >= -half - slack)) return {0, -1};
    auto cell = [&](double at) {
        const double place = (at + half) / double(spacing);
        if (!(place > 0)) return 0;
        return place >= lines - 2 ? lines - 2 : int(place);
    };
    return {cell(lo - slack), cell(hi + slack)};
}

HeightField::HeightField(int columns, int rows, const glm::vec2& spacing, std::span<const float> heights)
    : data_(std::make_shared<const HeightFieldData>(build_height_field(columns, rows, spacing.x, spacing.y, heights))) {
}

int HeightField::columns() const { return data_->columns; }
int HeightField::rows() const { return data_->rows; }
glm::vec2 HeightField::spacing() const { return {data_->spacing_x, data_->spacing_z}; }
std::span<const float> HeightField::heights() const { return data_->heights; }

} // namespace cairn
