// Ray casts at meshes (descending the tree of boxes) and at height fields (walking along the cells). Triangles are hit
// from outside only.
#include "shapes/rays.h"

#include <algorithm>
#include <limits>
#include <type_traits>

namespace cairn {

using math::DVec3;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// S. Woop, C. Benthin, I. Wald: Watertight ray/triangle intersection, JCGT 2(1), 2013. Corners are translated and
// sheared so that the ray starts at the origin and runs along axis z, the axis of its largest direction component. Two
// products then decide on which side of an edge it passes. Their rounded difference has the correct sign or is zero,
// which counts as inside, and both triangles of an edge use the same corners: no ray passes between them.
template <int z> struct TriangleRay {
    static constexpr int x = (z + 1) % 3, y = (z + 2) % 3;
    double origin_x, origin_y, origin_z, shear_x, shear_y, scale, mirror;

    TriangleRay(DVec3 o, DVec3 d)
        : origin_x(o[x]), origin_y(o[y]), origin_z(o[z]), shear_x(d[x] / d[z]), shear_y(d[y] / d[z]), scale(1 / d[z]),
          mirror(d[z] < 0 ? -1 : 1) {}

    struct Corner {
        double right, up, height;
    };
    Corner moved(math::Vec3 v) const {
        const double height = double(v[z]) - origin_z;
        return {(double(v[x]) - origin_x) - shear_x * height, mirror * ((double(v[y]) - origin_y) - shear_y * height),
                height};
    }

    // Whether the line of the ray hits the triangle from outside, and at which distance.
    bool meets(const Triangle& t, double& distance) const {
        const Corner a = moved(t.a), b = moved(t.b), c = moved(t.c);
        // Twice the areas of the triangles formed by the origin and each edge, clockwise.
        const double u = b.up * c.right - b.right * c.up, v = c.up * a.right - c.right * a.up,
                     w = a.up * b.right - a.right * b.up;
        if (u < 0 || v < 0 || w < 0) return false;
        const double sum = u + v + w;
        if (!(sum > 0)) return false;
        distance = scale * ((u * a.height + v * b.height + w * c.height) / sum);
        return true;
    }
};

// The nearest hit so far; of equal distances, the lower triangle index wins, whatever the order of the tests.
struct Nearest {
    double distance;
    std::uint32_t triangle = no_triangle;

    void offer(double at, std::uint32_t index) {
        if (at >= 0 && (at < distance || (at == distance && index < triangle))) distance = at, triangle = index;
    }
};

template <class Data> std::optional<ShapeRayHit> to_hit(const Data& data, const Nearest& nearest) {
    if (nearest.triangle == no_triangle) return std::nullopt;
    const Triangle t = triangle_of(data, nearest.triangle);
    const DVec3 a = math::to_double(t.a), b = math::to_double(t.b), c = math::to_double(t.c);
    return ShapeRayHit{nearest.distance, math::normalized(math::cross(b - a, c - a)), nearest.triangle};
}

// Calls f with the index of the axis along which the direction is longest, as a type.
template <class F> auto with_longest_axis(DVec3 d, F&& f) {
    const DVec3 a = math::abs(d);
    if (a.x >= a.y && a.x >= a.z) return f(std::integral_constant<int, 0>{});
    if (a.y >= a.z) return f(std::integral_constant<int, 1>{});
    return f(std::integral_constant<int, 2>{});
}

// The intersection of a ray with boxes. Each distance has at most three rounding errors, so that widening the far
// distance by a few makes the test conservative (T. Ize: Robust BVH ray traversal, JCGT 2(2), 2013).
struct BoxRay {
    DVec3 origin, inverse;

    // The distance at which the ray enters the box (at least 0), or infinity.
    double enter(math::Vec3 least, math::Vec3 greatest, double max_distance) const {
        double near = 0, far = max_distance;
        auto cut = [&](double lo, double hi, double o, double scale) {
            const double a = (lo - o) * scale, b = (hi - o) * scale;
            const double first = scale < 0 ? b : a, last = scale < 0 ? a : b;
            // For a ray within a side's plane the distances are 0 x infinity = NaN, which cuts nothing in these
            // comparisons.
            if (first > near) near = first;
            if (last < far) far = last;
        };
        cut(double(least.x), double(greatest.x), origin.x, inverse.x);
        cut(double(least.y), double(greatest.y), origin.y, inverse.y);
        cut(double(least.z), double(greatest.z), origin.z, inverse.z);
        constexpr double few_roundings = 1e-14;
        return near <= far + few_roundings * (near + std::fabs(far)) ? near : infinity;
    }
};

template <int z> Nearest search_mesh(const MeshData& mesh, const LocalRay& ray) {
    const TriangleRay<z> at(ray.origin, ray.direction);
    const DVec3 d = ray.direction;
    const BoxRay boxes{ray.origin, {1 / d.x, 1 / d.y, 1 / d.z}};
    Nearest nearest{ray.max_distance};
    struct Entry {
        double enter;
        std::uint32_t level, block; // child block: of boxes, or of triangles at level 0
    };
    Entry stack[8 * 12]; // up to 8 entries per level, and there are fewer than 12 levels
    int depth = 0;
    const std::uint32_t top = std::uint32_t(mesh.levels.size()) - 1;
    stack[depth++] = {boxes.enter(mesh.lo, mesh.hi, nearest.distance), top, 0};
    while (depth > 0) {
        const Entry entry = stack[--depth];
        if (entry.enter > nearest.distance * (1 + 1e-14) || entry.enter == infinity) continue;
        if (entry.level == 0) {
            const std::uint32_t first = 8 * entry.block, last = std::min(first + 8, triangle_count(mesh));
            for (std::uint32_t i = first; i < last; ++i)
                if (double distance; at.meets(triangle_of(mesh, i), distance)) nearest.offer(distance, i);
            continue;
        }
        const BoxBlock& block = mesh.levels[entry.level][entry.block];
        const std::uint32_t first = 8 * entry.block, below = std::uint32_t(mesh.levels[entry.level - 1].size());
        const int bottom = depth;
        for (std::uint32_t i = first; i < std::min(first + 8, below); ++i) {
            const double enter = boxes.enter(block.lo_of(i - first), block.hi_of(i - first), nearest.distance);
            if (enter == infinity) continue;
            int place = depth++; // sorted so that the nearest is on top of the stack
            for (; place > bottom && stack[place - 1].enter < enter; --place) stack[place] = stack[place - 1];
            stack[place] = {enter, entry.level - 1, i};
        }
    }
    return nearest;
}

// A horizontal axis of a height field's grid.
struct GridAxis {
    int lines;
    float spacing;
    double half, origin, direction;
    double slack; // bound of the rounding error of a position: of lines rounded to float, and of the ray

    GridAxis(int lines_, float spacing_, double o, double d, double reach)
        : lines(lines_), spacing(spacing_), half(grid_half(lines_, spacing_)), origin(o), direction(d),
          slack(1.2e-7 * half + 1e-14 * reach) {}

    CellRange cells(double a, double b) const {
        return cells_between(lines, spacing, std::min(a, b) - slack, std::max(a, b) + slack);
    }
    double at(double distance) const { return origin + distance * direction; }
    double line(int i) const { return (i - 0.5 * (lines - 1)) * double(spacing); }
};

struct Stretch {
    double from, to;
    // The part of the stretch that is between lo and hi along an axis.
    Stretch within(double lo, double hi, double o, double d) const {
        if (d == 0) return o >= lo && o <= hi ? *this : Stretch{infinity, -infinity};
        const double a = (lo - o) / d, b = (hi - o) / d;
        return {std::max(from, std::min(a, b)), std::min(to, std::max(a, b))};
    }
};

// Walks along the cells as in J. Amanatides and A. Woo (A fast voxel traversal algorithm for ray tracing, Eurographics
// 1987), but one column of cells across the ray's main axis at a time, testing all cells within rounding error of the
// ray: an extra cell costs little, a missing one is a hole.
template <int z> class FieldWalk {
  public:
    FieldWalk(const HeightFieldData& field, const LocalRay& ray)
        : field_(field), ray_(ray), at_(ray.origin, ray.direction), nearest_{ray.max_distance} {}

    Nearest walk() {
        const DVec3 o = ray_.origin, d = ray_.direction;
        const double half_x = grid_half(field_.columns, field_.spacing_x);
        const double half_z = grid_half(field_.rows, field_.spacing_z);
        const double tallest = std::max(std::fabs(double(field_.least)), std::fabs(double(field_.greatest)));
        const double reach = std::fabs(o.x) + std::fabs(o.y) + std::fabs(o.z) + half_x + half_z + tallest;
        const GridAxis x(field_.columns, field_.spacing_x, o.x, d.x, reach);
        const GridAxis rows(field_.rows, field_.spacing_z, o.z, d.z, reach);
        height_slack_ = 1e-14 * reach;
        const Stretch inside =
            Stretch{0, ray_.max_distance}
                .within(-half_x - x.slack, half_x + x.slack, o.x, d.x)
                .within(-half_z - rows.slack, half_z + rows.slack, o.z, d.z)
                .within(double(field_.least) - height_slack_, double(field_.greatest) + height_slack_, o.y, d.y);
        if (!(inside.from <= inside.to)) return nearest_;
        if (std::fabs(d.x) * double(field_.spacing_z) >= std::fabs(d.z) * double(field_.spacing_x))
            along(x, rows, inside, [&](int i, int j) { test(i, j); });
        else
            along(rows, x, inside, [&](int i, int j) { test(j, i); });
        return nearest_;
    }

  private:
    template <class Test> void along(const GridAxis& main, const GridAxis& other, Stretch inside, Test&& test_cell) {
        const CellRange range = main.cells(main.at(inside.from), main.at(inside.to));
        const bool forward = !(main.direction < 0), other_forward = !(other.direction < 0);
        for (int n = 0; n <= range.last - range.first; ++n) {
            const int i = forward ? range.first + n : range.last - n;
            const Stretch here =
                inside.within(main.line(i) - main.slack, main.line(i + 1) + main.slack, main.origin, main.direction);
            if (!(here.from <= here.to)) continue;
            if (here.from > nearest_.distance) return;
            const double first = ray_.origin.y + here.from * ray_.direction.y;
            const double last = ray_.origin.y + here.to * ray_.direction.y;
            low_ = std::min(first, last) - height_slack_;
            high_ = std::max(first, last) + height_slack_;
            const CellRange across = other.cells(other.at(here.from), other.at(here.to));
            for (int m = 0; m <= across.last - across.first; ++m)
                test_cell(i, other_forward ? across.first + m : across.last - m);
        }
    }

    void test(int column, int row) {
        const float* near = field_.heights.data() + std::size_t(row) * std::size_t(field_.columns) + column;
        const float* far = near + field_.columns;
        const float least = std::min(std::min(near[0], near[1]), std::min(far[0], far[1]));
        // infinite next to a hole
        const float greatest = std::max(std::max(near[0], near[1]), std::max(far[0], far[1]));
        if (double(least) > high_ || double(greatest) < low_) return;
        const std::uint32_t index =
            2 * (std::uint32_t(row) * std::uint32_t(field_.columns - 1) + std::uint32_t(column));
        for (std::uint32_t i = index; i < index + 2; ++i)
            if (double distance; !is_hole(field_, i) && at_.meets(triangle_of(field_, i), distance))
                nearest_.offer(distance, i);
    }

    const HeightFieldData& field_;
    const LocalRay& ray_;
    TriangleRay<z> at_;
    Nearest nearest_;
    double low_ = 0, high_ = 0; // range of the ray's height over the column of cells
    double height_slack_ = 0;
};

} // namespace

std::optional<ShapeRayHit> cast_at_mesh(const MeshData& mesh, const LocalRay& ray) {
    return with_longest_axis(ray.direction, [&](auto axis) { return to_hit(mesh, search_mesh<axis()>(mesh, ray)); });
}

std::optional<ShapeRayHit> cast_at_height_field(const HeightFieldData& field, const LocalRay& ray) {
    return with_longest_axis(ray.direction,
                             [&](auto axis) { return to_hit(field, FieldWalk<axis()>(field, ray).walk()); });
}

} // namespace cairn
