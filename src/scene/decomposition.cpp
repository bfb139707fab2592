// Approximate convex decomposition: the voxels of a solid are cut repeatedly by planes of the grid. The part whose hull
// has the most empty volume ("air") is cut first, by the plane that leaves the least air in its two sides, as in V-HACD
// (Mamou 2016). The final hulls are made from the exact surface, as in CoACD (Wei et al. 2022). Nothing depends on the
// clock, so that equal meshes give equal parts.
#include "scene/decomposition.h"

#include "scene/voxels.h"

#include <cairn/error.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace cairn::scene {

namespace {

using Cell = std::array<int, 3>;
constexpr int planes_per_axis = 7;   // planes tried first along an axis; the neighbors of the best one are tried next
constexpr double balance = 0.02;     // cost of sides of unequal volume, as a share of the difference of their volumes
constexpr double worth = 0.9;        // a cut must reduce the air to at most this share
constexpr double merge_share = 0.25; // the air that merging two parts may add, as a share of the concavity limit
constexpr std::size_t most_pieces = 64;

struct Piece {
    std::vector<std::size_t> cells;
    Cell low{}, high{}; // bounds of the cells, both inclusive
    double hull = 0.0;  // volume of the hull in cells
    bool is_final = false;
    double air() const { return hull - static_cast<double>(cells.size()); }
};

// Adds the corners of cells that are extreme in their rows along all three axes; all vertices of the hull are among
// them.
void add_corners(const VoxelGrid& grid, const std::vector<std::size_t>& cells, const Cell& low, const Cell& high,
                 std::vector<Vec3>& points) {
    const auto extent = [&](std::size_t k) { return static_cast<std::size_t>(high[k] - low[k] + 1); };
    struct Ends {
        int low = std::numeric_limits<int>::max(), high = std::numeric_limits<int>::min();
    };
    std::array<std::vector<Ends>, 3> rows;
    const auto row = [&](std::size_t axis, const Cell& at) -> Ends& {
        const std::size_t a = (axis + 1) % 3, b = (axis + 2) % 3;
        return rows[axis]
                   [static_cast<std::size_t>(at[a] - low[a]) * extent(b) + static_cast<std::size_t>(at[b] - low[b])];
    };
    for (std::size_t k = 0; k < 3; ++k) rows[k].resize(extent((k + 1) % 3) * extent((k + 2) % 3));
    for (const std::size_t cell : cells) {
        const Cell at = grid.place(cell);
        for (std::size_t k = 0; k < 3; ++k) {
            Ends& ends = row(k, at);
            ends.low = std::min(ends.low, at[k]), ends.high = std::max(ends.high, at[k]);
        }
    }
    for (const std::size_t cell : cells) {
        const Cell at = grid.place(cell);
        bool is_outermost = true;
        for (std::size_t k = 0; k < 3 && is_outermost; ++k) {
            const Ends& ends = row(k, at);
            is_outermost = at[k] == ends.low || at[k] == ends.high;
        }
        if (!is_outermost) continue;
        const glm::vec3 low_corner(at[0], at[1], at[2]);
        for (int corner = 0; corner < 8; ++corner) {
            points.push_back(low_corner + glm::vec3(corner & 1, corner >> 1 & 1, corner >> 2 & 1));
        }
    }
}

double hull_volume(const VoxelGrid& grid, const Piece& piece) {
    if (piece.cells.empty()) return 0.0;
    std::vector<Vec3> points;
    add_corners(grid, piece.cells, piece.low, piece.high, points);
    return Hull(points).volume();
}

Piece make_piece(const VoxelGrid& grid, std::vector<std::size_t> cells) {
    Piece piece;
    piece.cells = std::move(cells);
    piece.low = {std::numeric_limits<int>::max(), std::numeric_limits<int>::max(), std::numeric_limits<int>::max()};
    piece.high = {-1, -1, -1};
    for (const std::size_t cell : piece.cells) {
        const Cell at = grid.place(cell);
        for (std::size_t k = 0; k < 3; ++k) {
            piece.low[k] = std::min(piece.low[k], at[k]), piece.high[k] = std::max(piece.high[k], at[k]);
        }
    }
    piece.hull = hull_volume(grid, piece);
    return piece;
}

class Decomposer {
  public:
    Decomposer(std::span<const Vec3> vertices, std::span<const std::uint32_t> indices, VoxelGrid grid,
               const DecompositionLimits& limits)
        : vertices_(vertices), indices_(indices), grid_(std::move(grid)), limits_(limits),
          owner_(grid_.states.size(), nobody) {}

    std::vector<Hull> run() {
        std::vector<std::size_t> all;
        for (std::size_t i = 0; i < grid_.states.size(); ++i) {
            if (grid_.states[i] != VoxelGrid::outside) all.push_back(i);
        }
        whole_ = static_cast<double>(all.size());
        add_connected(all);
        // Slanted faces look like steps in the grid, and are therefore cut more than necessary; superfluous cuts are
        // merged again.
        while (pieces_.size() < std::min(most_pieces, 2 * limits_.max_parts) && cut_the_worst()) {}
        std::vector<Hull> parts = hulls();
        merge(parts);
        return parts;
    }

  private:
    static constexpr std::uint32_t nobody = std::numeric_limits<std::uint32_t>::max();

    // Makes a piece of each set of cells that are connected by faces, edges or corners. If there are too many sets, the
    // smallest ones are combined.
    void add_connected(const std::vector<std::size_t>& cells) {
        constexpr std::uint32_t waiting = nobody - 1;
        for (const std::size_t cell : cells) owner_[cell] = waiting;
        std::vector<std::vector<std::size_t>> found;
        for (const std::size_t first : cells) {
            if (owner_[first] != waiting) continue;
            std::vector<std::size_t> open{first}, inside;
            owner_[first] = nobody;
            while (!open.empty()) {
                const std::size_t cell = open.back();
                open.pop_back();
                inside.push_back(cell);
                const Cell at = grid_.place(cell);
                for (int n = 0; n < 27; ++n) {
                    const Cell next{at[0] + n % 3 - 1, at[1] + n / 3 % 3 - 1, at[2] + n / 9 - 1};
                    if (next[0] < 0 || next[1] < 0 || next[2] < 0 || next[0] >= grid_.size[0] ||
                        next[1] >= grid_.size[1] || next[2] >= grid_.size[2]) {
                        continue;
                    }
                    const std::size_t index = grid_.index(next[0], next[1], next[2]);
                    if (owner_[index] != waiting) continue;
                    owner_[index] = nobody;
                    open.push_back(index);
                }
            }
            std::sort(inside.begin(), inside.end());
            found.push_back(std::move(inside));
        }
        std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.size() > b.size(); });
        while (found.size() > 1 && pieces_.size() + found.size() > most_pieces) {
            std::vector<std::size_t>& last = found[found.size() - 2];
            last.insert(last.end(), found.back().begin(), found.back().end());
            found.pop_back();
        }
        for (std::vector<std::size_t>& inside : found) pieces_.push_back(make_piece(grid_, std::move(inside)));
    }

    bool cut_the_worst() {
        Piece* worst = nullptr;
        for (Piece& piece : pieces_) {
            if (!piece.is_final && (worst == nullptr || piece.air() > worst->air())) worst = &piece;
        }
        if (worst == nullptr || worst->air() < limits_.concavity * whole_) return false;
        const std::optional<std::pair<std::size_t, int>> cut = best_cut(*worst);
        if (!cut) {
            worst->is_final = true;
            return true;
        }
        const auto [low, high] = sides(*worst, cut->first, cut->second);
        pieces_.erase(pieces_.begin() + (worst - pieces_.data()));
        add_connected(low.cells);
        add_connected(high.cells);
        return true;
    }

    // Returns the parts of a piece below the plane, and from the plane on.
    std::pair<Piece, Piece> sides(const Piece& piece, std::size_t axis, int plane) const {
        std::vector<std::size_t> low, high;
        for (const std::size_t cell : piece.cells) (grid_.place(cell)[axis] < plane ? low : high).push_back(cell);
        return {make_piece(grid_, std::move(low)), make_piece(grid_, std::move(high))};
    }

    // Returns an axis and a plane; nothing if no cut is worthwhile.
    std::optional<std::pair<std::size_t, int>> best_cut(const Piece& piece) const {
        double least = std::numeric_limits<double>::max(), least_air = 0.0;
        std::pair<std::size_t, int> best{0, 0};
        const auto attempt = [&](std::size_t axis, int plane) {
            if (plane <= piece.low[axis] || plane > piece.high[axis]) return;
            const auto [low, high] = sides(piece, axis, plane);
            if (low.cells.empty() || high.cells.empty()) return;
            const double air = low.air() + high.air();
            const double unlike =
                std::fabs(static_cast<double>(low.cells.size()) - static_cast<double>(high.cells.size()));
            if (air + balance * unlike >= least) return;
            least = air + balance * unlike;
            least_air = air;
            best = {axis, plane};
        };
        std::array<int, 3> step{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const int extent = piece.high[axis] - piece.low[axis] + 1;
            step[axis] = std::max(1, extent / (planes_per_axis + 1));
            for (int plane = piece.low[axis] + step[axis]; plane <= piece.high[axis]; plane += step[axis]) {
                attempt(axis, plane);
            }
        }
        if (least == std::numeric_limits<double>::max()) return std::nullopt;
        for (int finer = step[best.first] / 2; finer >= 1; finer /= 2) {
            const auto [axis, plane] = best;
            attempt(axis, plane - finer);
            attempt(axis, plane + finer);
        }
        // Thin walls gain only after several cuts: half of a bowl is a bowl. Hence only small pieces are given up here.
        if (least_air > worth * piece.air() && piece.cells.size() < 64) return std::nullopt;
        return best;
    }

    // Merges parts whose common hull has hardly more air, or the cheapest ones if there are too many.
    void merge(std::vector<Hull>& parts) const {
        const double whole = whole_ * grid_.cell * grid_.cell * grid_.cell;
        const auto both = [&](std::size_t a, std::size_t b) {
            std::vector<Vec3> points(parts[a].vertices().begin(), parts[a].vertices().end());
            points.insert(points.end(), parts[b].vertices().begin(), parts[b].vertices().end());
            return Hull(points);
        };
        std::vector<std::vector<double>> cost(parts.size(), std::vector<double>(parts.size(), 0.0));
        const auto price = [&](std::size_t a, std::size_t b) {
            cost[a][b] = both(a, b).volume() - parts[a].volume() - parts[b].volume();
        };
        for (std::size_t a = 0; a < parts.size(); ++a) {
            for (std::size_t b = a + 1; b < parts.size(); ++b) price(a, b);
        }
        while (parts.size() > 1) {
            std::size_t first = 0, second = 1;
            for (std::size_t a = 0; a < parts.size(); ++a) {
                for (std::size_t b = a + 1; b < parts.size(); ++b) {
                    if (cost[a][b] < cost[first][second]) first = a, second = b;
                }
            }
            const bool is_cheap = cost[first][second] < merge_share * limits_.concavity * whole;
            if (!is_cheap && parts.size() <= limits_.max_parts) return;
            parts[first] = both(first, second);
            const auto last = static_cast<std::ptrdiff_t>(second);
            parts.erase(parts.begin() + last);
            cost.erase(cost.begin() + last);
            for (std::vector<double>& row : cost) row.erase(row.begin() + last);
            for (std::size_t k = 0; k < parts.size(); ++k) {
                if (k != first) price(std::min(k, first), std::max(k, first));
            }
        }
    }

    // Makes the hulls from the surface itself, clipped at the bounds of each piece.
    std::vector<Hull> hulls() {
        for (std::size_t i = 0; i < pieces_.size(); ++i) {
            for (const std::size_t cell : pieces_[i].cells) owner_[cell] = static_cast<std::uint32_t>(i);
        }
        std::vector<Hull> result;
        for (std::size_t i = 0; i < pieces_.size(); ++i) {
            std::vector<Vec3> points;
            for (std::size_t t = 0; t + 2 < indices_.size(); t += 3) add_clipped(i, t, points);
            add_inner_corners(i, points);
            try {
                result.push_back(Hull(points));
            } catch (const Error&) { // a sliver without volume
            }
        }
        return result;
    }

    // Adds the portion of a triangle in the box of a piece, unless it belongs to another piece in the same box.
    void add_clipped(std::size_t index, std::size_t t, std::vector<Vec3>& points) const {
        const Piece& piece = pieces_[index];
        std::vector<glm::dvec3> polygon;
        for (std::size_t k = 0; k < 3; ++k) {
            polygon.push_back((glm::dvec3(vertices_[indices_[t + k]]) - grid_.origin) / grid_.cell);
        }
        for (int axis = 0; axis < 3; ++axis) {
            const std::size_t k = static_cast<std::size_t>(axis);
            const double a = polygon[0][axis], b = polygon[1][axis], c = polygon[2][axis];
            if (std::max({a, b, c}) < piece.low[k] || std::min({a, b, c}) > piece.high[k] + 1) return;
        }
        for (int axis = 0; axis < 3; ++axis) {
            const std::size_t k = static_cast<std::size_t>(axis);
            cut(polygon, axis, piece.low[k], 1.0);
            cut(polygon, axis, piece.high[k] + 1, -1.0);
            if (polygon.empty()) return;
        }
        glm::dvec3 middle(0.0);
        for (const glm::dvec3& corner : polygon) middle += corner / static_cast<double>(polygon.size());
        Cell at{};
        for (std::size_t k = 0; k < 3; ++k) {
            at[k] = std::clamp(static_cast<int>(std::floor(middle[static_cast<int>(k)])), piece.low[k], piece.high[k]);
        }
        if (owner_[grid_.index(at[0], at[1], at[2])] != index) return;
        for (const glm::dvec3& corner : polygon) points.push_back(Vec3(grid_.origin + grid_.cell * corner));
    }

    // Keeps the portion of the polygon on the side of `sign`.
    static void cut(std::vector<glm::dvec3>& polygon, int axis, int plane, double sign) {
        std::vector<glm::dvec3> kept;
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const glm::dvec3 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
            const double from = sign * (a[axis] - plane), to = sign * (b[axis] - plane);
            if (from >= 0.0) kept.push_back(a);
            if ((from < 0.0) != (to < 0.0)) {
                glm::dvec3 crossing = a + (b - a) * (from / (from - to));
                crossing[axis] = plane;
                kept.push_back(crossing);
            }
        }
        polygon = std::move(kept);
    }

    // Adds the corners of the box that are inside the solid, which no triangle reaches.
    void add_inner_corners(std::size_t index, std::vector<Vec3>& points) const {
        const Piece& piece = pieces_[index];
        for (int corner = 0; corner < 8; ++corner) {
            Cell at{};
            glm::dvec3 place;
            for (int k = 0; k < 3; ++k) {
                const bool is_high = (corner >> k & 1) != 0;
                const std::size_t i = static_cast<std::size_t>(k);
                at[i] = is_high ? piece.high[i] : piece.low[i];
                place[k] = at[i] + (is_high ? 1 : 0);
            }
            const std::size_t cell = grid_.index(at[0], at[1], at[2]);
            if (grid_.states[cell] != VoxelGrid::inside || owner_[cell] != index) continue;
            points.push_back(Vec3(grid_.origin + grid_.cell * place));
        }
    }

    std::span<const Vec3> vertices_;
    std::span<const std::uint32_t> indices_;
    VoxelGrid grid_;
    DecompositionLimits limits_;
    std::vector<std::uint32_t> owner_; // the piece of each cell
    std::vector<Piece> pieces_;
    double whole_ = 0.0;
};

} // namespace

std::vector<Hull> decompose(std::span<const Vec3> vertices, std::span<const std::uint32_t> indices,
                            const DecompositionLimits& limits) {
    std::vector<Vec3> used;
    std::vector<bool> is_used(vertices.size(), false);
    for (const std::uint32_t i : indices) is_used[i] = true;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        if (is_used[i]) used.push_back(vertices[i]);
    }
    const Hull whole(used);
    if (limits.max_parts <= 1) return {whole};
    std::optional<VoxelGrid> grid = voxels_of(vertices, indices, limits.cells);
    if (!grid) return {whole};
    std::vector<Hull> parts = Decomposer(vertices, indices, std::move(*grid), limits).run();
    if (parts.size() <= 1) return {whole};
    return parts;
}

const std::vector<Hull>& SurfaceParts::of(const std::shared_ptr<const Surface>& surface) {
    const auto known = parts_.find(surface);
    if (known != parts_.end()) return known->second;
    DecompositionLimits limits;
    if (parts_.size() >= max_surfaces) limits.max_parts = 1;
    return parts_.emplace(surface, decompose(surface->vertices, surface->indices, limits)).first->second;
}

} // namespace cairn::scene
