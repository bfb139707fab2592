// Quickhull (Barber, Dobkin, Huhdanpaa: The Quickhull Algorithm for Convex Hulls, ACM TOMS 22, 1996), on an integer
// grid.
// The faces visible from a point outside are removed, and replaced by a cone from their border (the horizon) to the
// point. Each face keeps a list of points above it, the farthest of which is added next. With exact orientation tests,
// the faces strictly visible from a point form a disk, and its horizon is one simple loop, because a point moved
// slightly inward sees the same faces and is in general position. New faces have area, as a point collinear with a
// horizon edge would not see the face that was removed. So no special cases or repairs are needed.
#include "shapes/hull_exact.h"

#include "shapes/mass.h"

#include <algorithm>

namespace cairn::hull {

using math::DVec3;
__extension__ typedef __int128 Int128; // not `using`: only this form compiles everywhere without pedantic warnings

namespace {

constexpr std::uint32_t none = ~std::uint32_t{};
// The distance below which the side of a plane is decided by exact arithmetic, in grid units. Distances of grid points
// from planes are computed with an error below 1e-5 (2^30 x a few times 2^-53).
constexpr double doubt = 1e-4;

GridVector difference(GridPoint a, GridPoint b) {
    return {std::int64_t(a.x) - b.x, std::int64_t(a.y) - b.y, std::int64_t(a.z) - b.z};
}

} // namespace

GridVector area_vector(GridPoint a, GridPoint b, GridPoint c) {
    const GridVector u = difference(b, a), v = difference(c, a);
    return {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
}

int side_of(GridPoint a, GridPoint b, GridPoint c, GridPoint p) {
    const GridVector n = area_vector(a, b, c), d = difference(p, a);
    const Int128 side = Int128(n.x) * d.x + Int128(n.y) * d.y + Int128(n.z) * d.z;
    return side > 0 ? 1 : side < 0 ? -1 : 0;
}

Simplex first_simplex(std::span<const GridPoint> points) {
    Simplex r;
    const auto count = std::uint32_t(points.size());
    auto& [a, b, c, d] = r.corners;
    for (std::uint32_t i = 1; i < count; ++i) {
        const GridPoint p = points[i], q = points[a];
        if (p.x < q.x || (p.x == q.x && (p.y < q.y || (p.y == q.y && p.z < q.z)))) a = i;
    }
    std::int64_t length = 0;
    for (std::uint32_t i = 0; i < count; ++i) {
        const GridVector v = difference(points[i], points[a]);
        const std::int64_t square = v.x * v.x + v.y * v.y + v.z * v.z;
        if (square > length) length = square, b = i;
    }
    if (length == 0) return r;
    double area = 0;
    for (std::uint32_t i = 0; i < count; ++i) {
        const DVec3 v = to_double(area_vector(points[a], points[b], points[i]));
        if (const double square = math::dot(v, v); square > area) area = square, c = i;
    }
    if (area == 0) return r;
    r.breadth = std::sqrt(area / double(length));
    const DVec3 normal = math::normalized(to_double(area_vector(points[a], points[b], points[c])));
    const DVec3 origin = to_double(points[a]);
    double above = 0, below = 0;
    std::uint32_t highest = a, lowest = a;
    for (std::uint32_t i = 0; i < count; ++i) {
        const double height = math::dot(normal, to_double(points[i]) - origin);
        if (height > above) above = height, highest = i;
        if (height < below) below = height, lowest = i;
    }
    d = above > -below ? highest : lowest;
    if (side_of(points[a], points[b], points[c], points[d]) != 0) r.thickness = above - below;
    return r;
}

namespace {

struct alignas(64) Face { // the members used most fill one cache line
    DVec3 normal;
    double offset = 0;
    std::uint32_t corners[3], neighbors[3];
    std::uint32_t mark = 0; // the last point whose visibility of the face was tested; the result is in `seen`
    bool seen = false, alive = true;
};

// The points above a face: a linked list, and the farthest of them.
struct Above {
    double height = 0; // of the farthest point
    std::uint32_t head = none, farthest = none;
};

struct FourPlanes {
    double x[4]{}, y[4]{}, z[4]{}, offset[4] = {1e300, 1e300, 1e300, 1e300};
};

class Quickhull {
  public:
    Quickhull(std::span<const GridPoint> points, double tolerance)
        : points_(points), tolerance_(tolerance), next_(points.size(), none), start_(points.size(), none) {
        // an upper bound of the number of faces for small inputs
        const std::size_t most = std::min<std::size_t>(2 * points.size(), 1 << 16);
        faces_.reserve(most), above_.reserve(most);
    }

    Triangulation run(const Simplex& simplex) {
        begin(simplex);
        while (!pending_.empty()) {
            const std::uint32_t face = pending_.back();
            pending_.pop_back();
            if (faces_[face].alive && above_[face].farthest != none) add(face);
        }
        return result();
    }

  private:
    double height(const Face& face, std::uint32_t p) const {
        return math::dot(face.normal, to_double(points_[p])) - face.offset;
    }
    bool sees(std::uint32_t p, const Face& face) const { return sees(p, face, height(face, p)); }
    bool sees(std::uint32_t p, const Face& face, double h) const {
        if (h > doubt || h < -doubt) return h > 0;
        return side_of(points_[face.corners[0]], points_[face.corners[1]], points_[face.corners[2]], points_[p]) > 0;
    }
    // Whether the point is outside the hull expanded by the tolerance.
    bool is_above(std::uint32_t p, const Face& face, double h) const {
        return tolerance_ > 0 ? h > tolerance_ : h > doubt || (h >= -doubt && sees(p, face, h));
    }

    std::uint32_t make_face(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        std::uint32_t index;
        if (free_.empty()) {
            index = std::uint32_t(faces_.size());
            faces_.emplace_back();
            above_.emplace_back();
        } else {
            index = free_.back();
            free_.pop_back();
        }
        above_[index] = {};
        Face& face = faces_[index];
        face.mark = 0, face.alive = true;
        face.corners[0] = a, face.corners[1] = b, face.corners[2] = c;
        face.normal = math::normalized(to_double(area_vector(points_[a], points_[b], points_[c])));
        face.offset = math::dot(face.normal, to_double(points_[a]));
        return index;
    }

    void put_above(std::uint32_t index, std::uint32_t p, double h) {
        Above& above = above_[index];
        next_[p] = above.head;
        above.head = p;
        if (above.farthest == none) pending_.push_back(index);
        if (above.farthest == none || h > above.height || (h == above.height && p < above.farthest))
            above.farthest = p, above.height = h;
    }

    // The distance of a point from a triangle, and the edge that it is farthest beyond (3: none).
    double distance(std::uint32_t p, const Face& face, int& exit) const {
        const DVec3 at = to_double(points_[p]);
        double most = 0, nearest = -1;
        exit = 3;
        for (int k = 0; k < 3; ++k) {
            const DVec3 a = to_double(points_[face.corners[k]]), b = to_double(points_[face.corners[(k + 1) % 3]]);
            const DVec3 edge = b - a, d = at - a;
            const double length = math::length(edge), beyond = math::dot(math::cross(edge, face.normal), d) / length;
            if (beyond > most) most = beyond, exit = k;
            double t = math::dot(d, edge) / (length * length);
            t = t < 0 ? 0 : t > 1 ? 1 : t;
            const double away = math::length(d - t * edge);
            if (nearest < 0 || away < nearest) nearest = away;
        }
        return exit == 3 ? std::fabs(height(face, p)) : nearest;
    }

    // Whether a point slightly above the face is near the surface, there or a few triangles further. The height above a
    // plane does not decide this: near a sharp edge, a point may be slightly above both faces and still far from the
    // body.
    bool is_near(std::uint32_t p, std::uint32_t face) const {
        for (double last = -1;;) {
            int exit;
            const double d = distance(p, faces_[face], exit);
            if (d <= 2 * tolerance_) return true;
            if (exit == 3 || (last >= 0 && d >= last)) return false;
            last = d;
            face = faces_[face].neighbors[exit];
        }
    }

    // Loads the planes of faces for `assign`, four per block; unused lanes have planes above all points.
    void take_planes(std::span<const std::uint32_t> faces) {
        planes_.assign((faces.size() + 3) / 4, {});
        for (std::size_t i = 0; i < faces.size(); ++i) {
            const Face& face = faces_[faces[i]];
            FourPlanes& four = planes_[i / 4];
            four.x[i % 4] = face.normal.x, four.y[i % 4] = face.normal.y, four.z[i % 4] = face.normal.z;
            four.offset[i % 4] = face.offset;
        }
    }

    // Assigns a point to the first face that it is above. A point that saw a removed face and sees none of the new ones
    // is inside the hull. Requires take_planes(faces).
    void assign(std::uint32_t p, std::span<const std::uint32_t> faces) {
        const DVec3 at = to_double(points_[p]);
        std::uint32_t seen = none;
        for (std::size_t i = 0; i < planes_.size(); ++i) {
            const FourPlanes& four = planes_[i];
            double heights[4];
            for (int k = 0; k < 4; ++k) // computed exactly as in height()
                heights[k] = (four.x[k] * at.x + four.y[k] * at.y + four.z[k] * at.z) - four.offset[k];
            for (std::size_t k = 0; k < 4; ++k) {
                const double h = heights[k];
                if (h < -doubt) continue;
                const std::uint32_t index = faces[4 * i + k];
                const Face& face = faces_[index];
                if (is_above(p, face, h)) return put_above(index, p, h);
                if (tolerance_ > 0 && seen == none && h > -doubt && sees(p, face, h)) seen = index;
            }
        }
        if (seen == none) return;
        if (is_near(p, seen))
            left_out_.push_back(p);
        else
            put_above(seen, p, height(faces_[seen], p));
    }

    void begin(const Simplex& simplex) {
        std::uint32_t a = simplex.corners[0], b = simplex.corners[1], c = simplex.corners[2], d = simplex.corners[3];
        if (side_of(points_[a], points_[b], points_[c], points_[d]) > 0) std::swap(b, c);
        const std::uint32_t corners[4][3] = {{a, b, c}, {a, d, b}, {b, d, c}, {c, d, a}};
        const std::uint32_t neighbors[4][3] = {{1, 2, 3}, {3, 2, 0}, {1, 3, 0}, {2, 1, 0}};
        for (int i = 0; i < 4; ++i) {
            make_face(corners[i][0], corners[i][1], corners[i][2]);
            std::copy_n(neighbors[i], 3, faces_[std::size_t(i)].neighbors);
        }
        const std::uint32_t all[] = {0, 1, 2, 3};
        take_planes(all);
        for (std::uint32_t p = 0; p < points_.size(); ++p)
            if (p != a && p != b && p != c && p != d) assign(p, all);
    }

    // Finds the faces visible from p, starting at a visible one, and the horizon.
    void look(std::uint32_t p, std::uint32_t first) {
        ++mark_;
        seen_.assign(1, first);
        horizon_.clear();
        faces_[first].mark = mark_, faces_[first].seen = true;
        for (std::size_t i = 0; i < seen_.size(); ++i)
            for (int k = 0; k < 3; ++k) {
                const Face& face = faces_[seen_[i]];
                const std::uint32_t other = face.neighbors[k];
                Face& neighbor = faces_[other];
                if (neighbor.mark != mark_) {
                    neighbor.mark = mark_;
                    neighbor.seen = sees(p, neighbor);
                    if (neighbor.seen) seen_.push_back(other);
                }
                if (!neighbor.seen) horizon_.push_back({face.corners[k], face.corners[(k + 1) % 3], other});
            }
    }

    void add(std::uint32_t first) {
        const std::uint32_t p = above_[first].farthest;
        look(p, first);
        made_.clear();
        for (const Edge& edge : horizon_) {
            const std::uint32_t index = make_face(edge.from, edge.to, p);
            made_.push_back(index);
            faces_[index].neighbors[0] = edge.beyond;
            Face& beyond = faces_[edge.beyond];
            for (int k = 0; k < 3; ++k)
                if (beyond.corners[k] == edge.to && beyond.corners[(k + 1) % 3] == edge.from)
                    beyond.neighbors[k] = index;
            start_[edge.from] = index;
        }
        for (const std::uint32_t index : made_) {
            const std::uint32_t after = start_[faces_[index].corners[1]];
            faces_[index].neighbors[1] = after;
            faces_[after].neighbors[2] = index;
        }
        take_planes(made_);
        for (const std::uint32_t index : seen_) {
            faces_[index].alive = false;
            for (std::uint32_t q = above_[index].head, after; q != none; q = after) {
                after = next_[q];
                if (q != p) assign(q, made_);
            }
        }
        free_.insert(free_.end(), seen_.begin(), seen_.end());
    }

    Triangulation result() {
        Triangulation r;
        std::vector<std::uint32_t> number(points_.size(), none), triangle_of(faces_.size(), none);
        std::uint32_t count = 0;
        for (std::size_t i = 0; i < faces_.size(); ++i) {
            if (!faces_[i].alive) continue;
            triangle_of[i] = count++;
            for (const std::uint32_t corner : faces_[i].corners) number[corner] = 0;
        }
        for (std::uint32_t p = 0; p < points_.size(); ++p)
            if (number[p] == 0) {
                number[p] = std::uint32_t(r.points.size());
                r.points.push_back(p);
            }
        r.triangles.reserve(count);
        for (const Face& face : faces_) {
            if (!face.alive) continue;
            Triangle triangle;
            for (int k = 0; k < 3; ++k) {
                triangle.corners[k] = number[face.corners[k]];
                triangle.neighbors[k] = triangle_of[face.neighbors[k]];
            }
            r.triangles.push_back(triangle);
        }
        r.left_out = std::move(left_out_);
        return r;
    }

    struct Edge {
        std::uint32_t from, to, beyond;
    };

    std::span<const GridPoint> points_;
    double tolerance_;
    std::vector<Face> faces_;
    std::vector<Above> above_; // per face
    std::vector<std::uint32_t> free_, pending_;
    std::vector<std::uint32_t> next_;  // per point: the next in the list of its face
    std::vector<std::uint32_t> start_; // per horizon point: the new face whose edge starts there
    std::vector<std::uint32_t> left_out_, seen_, made_;
    std::vector<Edge> horizon_;
    std::vector<FourPlanes> planes_; // see take_planes
    std::uint32_t mark_ = 0;
};

} // namespace

Triangulation triangulate(std::span<const GridPoint> points, const Simplex& simplex, double tolerance) {
    return Quickhull(points, tolerance).run(simplex);
}

PointTree::PointTree(std::span<const GridPoint> points, std::span<const std::uint32_t> chosen)
    : points_(points), order_(chosen.begin(), chosen.end()) {
    if (order_.empty()) return;
    std::size_t nodes = 1;
    for (std::size_t leaves = 1; leaves * 8 < order_.size(); leaves *= 2) nodes = 4 * leaves - 1;
    nodes_.resize(nodes);
    build(0, 0, std::uint32_t(order_.size()));
}

void PointTree::build(std::size_t node, std::uint32_t first, std::uint32_t count) {
    DVec3 sum, lo = to_double(points_[order_[first]]), hi = lo;
    for (std::uint32_t i = 0; i < count; ++i) {
        const DVec3 p = to_double(points_[order_[first + i]]);
        sum += p, lo = math::min(lo, p), hi = math::max(hi, p);
    }
    const DVec3 mean = (1.0 / count) * sum;
    math::DSym3 spread;
    for (std::uint32_t i = 0; i < count; ++i) {
        const DVec3 d = to_double(points_[order_[first + i]]) - mean;
        spread = spread + math::DSym3{d.x * d.x, d.x * d.y, d.x * d.z, d.y * d.y, d.y * d.z, d.z * d.z};
    }
    const math::DMat3 axes = math::to_matrix(diagonalize(spread).axes);
    Node& made = nodes_[node] = {mean, {}, first, count};
    for (int k = 0; k < 3; ++k) {
        const DVec3 axis = axes.column(k);
        double least = 0, most = 0;
        for (std::uint32_t i = 0; i < count; ++i) {
            const double d = math::dot(axis, to_double(points_[order_[first + i]]) - mean);
            least = std::min(least, d), most = std::max(most, d);
        }
        made.middle += 0.5 * (least + most) * axis;
        made.edges[k] = 0.5 * (most - least) * axis;
    }
    if (2 * node + 2 >= nodes_.size()) return;
    const DVec3 size = hi - lo;
    const int axis = size.x >= size.y ? (size.x >= size.z ? 0 : 2) : (size.y >= size.z ? 1 : 2);
    const auto begin = order_.begin() + first, half = begin + count / 2;
    std::nth_element(begin, half, begin + count, [&](std::uint32_t a, std::uint32_t b) {
        const double u = to_double(points_[a])[axis], v = to_double(points_[b])[axis];
        return u != v ? u < v : a < b;
    });
    build(2 * node + 1, first, count / 2);
    build(2 * node + 2, first + count / 2, count - count / 2);
}

PointTree::Farthest PointTree::farthest(DVec3 normal, double least) const {
    Farthest best{false, 0, least};
    if (nodes_.empty()) return best;
    std::size_t stack[64], size = 0;
    stack[size++] = 0;
    while (size > 0) {
        const std::size_t index = stack[--size];
        const Node& node = nodes_[index];
        double bound = math::dot(normal, node.middle);
        for (const DVec3 edge : node.edges) bound += std::fabs(math::dot(normal, edge));
        if (bound + doubt < best.reach) continue; // margin, since the bound is rounded differently from the points
        if (2 * index + 2 < nodes_.size()) {
            stack[size++] = 2 * index + 1;
            stack[size++] = 2 * index + 2;
            continue;
        }
        for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
            const double reach = math::dot(normal, to_double(points_[order_[i]]));
            if (reach > best.reach || (best.found && reach == best.reach && order_[i] < best.point))
                best = {true, order_[i], reach};
        }
    }
    return best;
}

} // namespace cairn::hull
