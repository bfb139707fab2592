#include "collision/face_outline.h"

#include <algorithm>

namespace cairn {

using math::dot;
using math::DVec3;

namespace {

// As in kernels/face_clip.h: the reference face is enlarged by this share of its size, and its corners count as inside
// the incident face only where they are inside by as much. So aligned faces of equal size keep all corners in spite of
// rounding.
constexpr double face_tolerance = 1e-4;
// A face whose normal has a cosine below this with the viewing direction is seen edge-on and has no interior.
constexpr double edge_on = 1e-2;
// The first candidate numbers of each kind, so that the features of different kinds differ.
constexpr std::uint32_t from_rim = 0, from_edges = 16, from_corners = 0x8000;

struct Point3 {
    double x, y, z; // z: along the reference normal
};
using Polygon = Buffer<Point3, 16>;

Point3 between(const Point3& p, const Point3& q, double t) {
    return {p.x + t * (q.x - p.x), p.y + t * (q.y - p.y), p.z + t * (q.z - p.z)};
}

DVec3 unit_or(DVec3 v, DVec3 other) {
    const double length = math::length(v);
    return length > 0 ? (1 / length) * v : other;
}

std::uint32_t feature_base(std::uint32_t reference, std::uint32_t incident) {
    return (reference * 64 + incident) << 17;
}

// Signed distances of the corners of a feature from the sides of a face, positive inside.
class Inside {
  public:
    Inside(std::span<const SideBlock> sides, const Polygon& corners, double slack) : blocks_(sides.size()) {
        for (const Point3& p : corners)
            for (const SideBlock& block : sides) {
                Four& four = values_.add_unset();
                four.outside = block.inside(p.x, p.y, slack, four.value);
                any_outside |= four.outside;
            }
    }

    // Clips the edge from corner p to q to the part inside, in edge parameters; false if there is none.
    bool cut(std::size_t p, std::size_t q, double& start, double& end) const {
        start = 0, end = 1;
        const Four *at_p = values_.data() + p * blocks_, *at_q = values_.data() + q * blocks_;
        for (std::size_t i = 0; i < blocks_; ++i) {
            const Four &from = at_p[i], &to = at_q[i];
            if ((from.outside & to.outside) != 0) return false;
            for (unsigned crossed = from.outside | to.outside; crossed != 0; crossed &= crossed - 1) {
                const int k = __builtin_ctz(crossed);
                const double t = from.value[k] / (from.value[k] - to.value[k]);
                if ((from.outside >> k & 1) != 0)
                    start = std::max(start, t);
                else
                    end = std::min(end, t);
            }
        }
        return start <= end;
    }

    unsigned any_outside = 0;

  private:
    struct Four {
        double value[SideBlock::width];
        unsigned outside; // one bit per side
    };
    std::size_t blocks_;
    Buffer<Four, 16> values_; // all blocks of the first corner, then of the second and so on
};

// Which of four corners of the reference face are outside of the side p q of the incident face, or inside by less than
// `slack`, as bits; seen from the front of the reference face, the incident face is clockwise.
unsigned beyond_side(const SideBlock& corners, const Point3& p, const Point3& q, double slack) {
    using namespace sides;
    const double dx = q.x - p.x, dy = q.y - p.y;
    // Scaled by the sum of the components instead of the length of the side, which needs a root: up to 1.4 times as
    // large.
    const D2 least = splat(slack * (std::fabs(dx) + std::fabs(dy)));
    unsigned beyond = 0;
    for (std::size_t k = 0; k < SideBlock::width; k += 2) {
        const D2 x = load(corners.x + k) - splat(p.x), y = load(corners.y + k) - splat(p.y);
        beyond |= negative(splat(dy) * x - splat(dx) * y - least) << k;
    }
    return beyond;
}

// Adds the corners of the face that are over the incident polygon.
void add_corners(const FaceOutline& face, const Feature& incident, const Polygon& other, double slack,
                 ContactPoints& out) {
    const ContactFrame& frame = face.frame;
    const DVec3 m{dot(incident.normal, frame.e1), dot(incident.normal, frame.e2), dot(incident.normal, frame.normal)};
    if (!(m.z < -edge_on)) return;
    const std::size_t n = other.size();
    const double slope_x = m.x / m.z, slope_y = m.y / m.z;
    for (std::size_t first = 0; first < face.corner_count; first += SideBlock::width) {
        const SideBlock& corners = face.sides[first / SideBlock::width];
        const std::size_t count = std::min(face.corner_count - first, SideBlock::width);
        unsigned over = (1u << count) - 1;
        for (std::size_t i = 0; i < n && over != 0; ++i)
            over &= ~beyond_side(corners, other[i], other[i + 1 < n ? i + 1 : 0], slack);
        for (; over != 0; over &= over - 1) {
            const auto k = static_cast<std::size_t>(__builtin_ctz(over));
            const double x = corners.x[k], y = corners.y[k];
            const double z = other[0].z - ((x - other[0].x) * slope_x + (y - other[0].y) * slope_y);
            out.list.add({x, y, z, frame.feature + static_cast<std::uint32_t>(from_corners + first + k)});
        }
    }
}

// A disc counts as tilted when one side of its rim is lower than its center by this.
double lean(double extent) { return 0.5 * flat_contact_part * extent; }

// Approximates a disc by a polygon that has its lowest point over the reference disc as a corner, or, if it is not
// tilted, the four points that the reference disc uses.
void disc_polygon(const Feature& disc, const Feature& reference, double extent, Feature& out) {
    constexpr double half = 0.70710678118654752, c = 0.92387953251128676, s = 0.38268343236508977;
    constexpr double circle[16][2] = {{1, 0},        {c, s},  {half, half},  {s, c},   {0, 1},         {-s, c},
                                      {-half, half}, {-c, s}, {-1, 0},       {-c, -s}, {-half, -half}, {-s, -c},
                                      {0, -1},       {s, -c}, {half, -half}, {c, -s}};
    DVec3 u = reference.normal - dot(reference.normal, disc.normal) * disc.normal;
    if (!(math::length(u) * disc.radius > lean(extent))) u = reference.u - dot(reference.u, disc.normal) * disc.normal;
    const DVec3 e1 = unit_or(u, disc.u), e2 = math::cross(disc.normal, e1);
    out.kind = Feature::Kind::polygon;
    out.index = disc.index;
    out.normal = disc.normal;
    for (const auto& p : circle) out.points.add(disc.center + (disc.radius * p[0]) * e1 + (disc.radius * p[1]) * e2);
}

// Contact points of a disc and another feature, computed in the plane of the disc. m: the contact normal, from the disc
// to the other feature, along which points of the two surfaces are matched.
class DiscPoints {
  public:
    DiscPoints(const Feature& disc, const Feature& other, DVec3 m, double extent, ContactPoints& out)
        : disc_(disc), other_(other), m_(m), cosine_(dot(m, disc.normal)), extent_(extent), out_(out) {
        out.frame = {disc.center, disc.u, disc.v, m, feature_base(disc.index, other.index), true};
        for (const DVec3& p : other.points) {
            const DVec3 d = p - disc.center;
            const double z = dot(d, disc.normal) / cosine_;
            const DVec3 flat = d - z * m;
            corners_.add({dot(flat, disc.u), dot(flat, disc.v), z});
        }
    }

    void find() {
        const std::size_t n = corners_.size();
        if (n == 1) {
            if (square(corners_[0]) <= wide() * wide()) add(corners_[0], from_edges);
            return;
        }
        const double facing = other_.kind == Feature::Kind::polygon ? dot(m_, other_.normal) : 0;
        if (facing < -edge_on) rim(facing);
        for (std::size_t i = 0; i < (n == 2 ? 1 : n); ++i)
            edge(corners_[i], corners_[(i + 1) % n], n == 2, static_cast<std::uint32_t>(from_edges + 2 * i));
        if (n == 2) return;
        for (std::size_t i = 0; i < n; ++i)
            if (square(corners_[i]) < disc_.radius * disc_.radius)
                add(corners_[i], static_cast<std::uint32_t>(from_corners + i));
    }

  private:
    static double square(const Point3& p) { return p.x * p.x + p.y * p.y; }
    double wide() const { return (1 + face_tolerance) * disc_.radius; }
    void add(const Point3& p, std::uint32_t number) { out_.list.add({p.x, p.y, p.z, out_.frame.feature + number}); }

    // Adds up to four points of the rim. They do not rotate with the disc: on a face they are aligned with its first
    // edge, and as soon as the disc is tilted, the first is the lowest.
    void rim(double facing) {
        // z = z0 + gx x + gy y in the plane of the disc.
        const double z0 = dot(other_.points[0] - disc_.center, other_.normal) / facing;
        const double gx = -dot(disc_.u, other_.normal) / facing, gy = -dot(disc_.v, other_.normal) / facing;
        const double slope = std::sqrt(gx * gx + gy * gy);
        const bool leans = slope * disc_.radius > lean(extent_);
        double x = -gx, y = -gy;
        if (!leans) x = corners_[1].x - corners_[0].x, y = corners_[1].y - corners_[0].y;
        const double length = std::sqrt(x * x + y * y);
        x = length > 0 ? x / length : 1, y = length > 0 ? y / length : 0;
        Buffer<double, 16 + SideBlock::width> xs, ys; // counterclockwise as seen from the disc
        for (std::size_t i = corners_.size(); i-- > 0;) xs.add(corners_[i].x), ys.add(corners_[i].y);
        for (std::size_t k = 0; k < SideBlock::width; ++k) xs.add_unset(), ys.add_unset();
        Buffer<SideBlock, 4> sides;
        for (std::size_t k = 0; k < blocks_of(corners_.size()); ++k) sides.add_unset();
        make_sides(xs.data(), ys.data(), corners_.size(), sides.data());
        const auto is_within = [&](const Point3& p) {
            double inside[SideBlock::width];
            for (const SideBlock& block : sides)
                if (block.inside(p.x, p.y, face_tolerance * disc_.radius, inside) != 0) return false;
            return true;
        };
        const Point3 directions[4] = {{x, y, 0}, {-x, -y, 0}, {-y, x, 0}, {y, -x, 0}};
        for (std::uint32_t i = 0; i < 4; ++i) {
            Point3 p{disc_.radius * directions[i].x, disc_.radius * directions[i].y, 0};
            p.z = z0 + gx * p.x + gy * p.y;
            if (is_within(p)) add(p, from_rim + (leans ? 4 : 0) + i);
        }
    }

    // Adds the points where an edge crosses the rim; with `both`, also its ends inside.
    void edge(const Point3& p, const Point3& q, bool both, std::uint32_t number) {
        const double r = both ? wide() : disc_.radius;
        const double dx = q.x - p.x, dy = q.y - p.y, square_length = dx * dx + dy * dy;
        if (!(square_length > 0)) return;
        const double middle = -(p.x * dx + p.y * dy) / square_length;
        const Point3 nearest = between(p, q, middle);
        const double room = (r * r - square(nearest)) / square_length;
        if (!(room > 0)) return;
        double start = middle - std::sqrt(room), end = middle + std::sqrt(room);
        if (!(start < 1 && end > 0)) return;
        if (both) start = std::max(start, 0.0), end = std::min(end, 1.0);
        if (start >= 0) add(between(p, q, start), number);
        if (end <= 1) add(between(p, q, end), number + 1);
    }

    const Feature &disc_, &other_;
    DVec3 m_;
    double cosine_, extent_;
    ContactPoints& out_;
    Polygon corners_; // corners of the other feature, projected along m to the plane of the disc
};

// Whether a disc is completely over another one.
bool lies_over(const Feature& disc, const Feature& face) {
    const DVec3 d = disc.center - face.center, across = d - dot(d, face.normal) * face.normal;
    return math::length(across) + disc.radius <= face.radius;
}

} // namespace

void outline_points(const FaceOutline& face, const Feature& incident, ContactPoints& out) {
    out.frame = face.frame;
    out.frame.feature = feature_base(face.index, incident.index);
    Polygon other;
    for (const DVec3& p : incident.points) {
        const DVec3 q = face.frame.to_frame(p);
        Point3& to = other.add_unset();
        to.x = q.x, to.y = q.y, to.z = q.z;
    }
    const auto add = [&](const Point3& p, std::size_t number) {
        out.list.add({p.x, p.y, p.z, out.frame.feature + static_cast<std::uint32_t>(number)});
    };
    const double slack = face_tolerance * face.size;
    const Inside inside(face.sides, other, slack);
    const std::size_t n = other.size();
    if (n == 1) {
        if (inside.any_outside == 0) add(other[0], from_edges);
        return;
    }
    for (std::size_t i = 0; i < (n == 2 ? 1 : n); ++i) {
        const std::size_t next = i + 1 < n ? i + 1 : 0;
        double start, end;
        if (!inside.cut(i, next, start, end)) continue;
        add(between(other[i], other[next], start), from_edges + 2 * i);
        // The end of an edge is the start of the next.
        if (end < 1 || n == 2) add(between(other[i], other[next], end), from_edges + 2 * i + 1);
    }
    // A polygon completely inside the face has none of the face's corners inside.
    if (n > 2 && inside.any_outside != 0) add_corners(face, incident, other, slack, out);
}

void square_under(const Feature& disc, const DVec3& point, const DVec3& up, Feature& out) {
    const DVec3 e1 = math::to_double(math::any_orthogonal(math::to_float(up)));
    const DVec3 x = (8 * disc.radius) * math::normalized(e1 - dot(e1, up) * up), z = math::cross(x, up);
    const DVec3 under = disc.center - dot(disc.center - point, up) * up;
    out.kind = Feature::Kind::polygon;
    out.normal = up;
    for (const DVec3& p : {under - x - z, under - x + z, under + x + z, under + x - z}) out.points.add(p);
}

void disc_points(const Feature& reference, const Feature& incident, double extent, ContactPoints& out) {
    using Kind = Feature::Kind;
    if (reference.kind != Kind::disc) {
        DiscPoints(incident, reference, -reference.normal, extent, out).find();
    } else if (incident.kind == Kind::disc && lies_over(incident, reference)) {
        Feature square; // the part of the reference face below the disc
        square_under(incident, reference.center, reference.normal, square);
        DiscPoints(incident, square, -square.normal, extent, out).find();
    } else if (incident.kind == Kind::disc) {
        Feature polygon;
        disc_polygon(incident, reference, extent, polygon);
        DiscPoints(reference, polygon, reference.normal, extent, out).find();
    } else {
        DiscPoints(reference, incident, reference.normal, extent, out).find();
    }
}

EdgePoints edge_points(const EdgeLine& first, const EdgeLine& second, DVec3 n, double separation) {
    constexpr double parallel = 1e-2;
    const DVec3 a = first.from, b = second.from, da = first.way, db = second.way, w = b - a;
    const double aa = dot(da, da), bb = dot(db, db), ab = dot(da, db);
    const bool is_a = aa > 0, is_b = bb > 0;
    EdgePoints out;
    if (is_a && is_b && aa * bb - ab * ab < parallel * parallel * aa * bb) {
        // Parallel edges: the part of the first that the second covers. All points are exactly below the second edge,
        // which internal edges rely on.
        const double t0 = dot(w, da) / aa, t1 = t0 + ab / aa;
        const double start = std::max(0.0, std::min(t0, t1)), end = std::min(1.0, std::max(t0, t1));
        if (start < end) {
            out.count = 2;
            for (int k = 0; k < 2; ++k) {
                const double t = k == 0 ? start : end, s = (t - t0) / (t1 - t0);
                const DVec3 p = a + t * da, q = b + s * db;
                const double gap = dot(q - p, n);
                out.points[k] = {q - (0.5 * gap) * n, gap};
            }
            return out;
        }
    }
    const auto unit = [](double t) { return t < 0 ? 0.0 : t > 1 ? 1.0 : t; };
    const double aw = dot(da, w), bw = dot(db, w), determinant = aa * bb - ab * ab;
    double s = 0, t = 0;
    if (is_a && is_b) s = determinant > 0 ? unit((aw * bb - ab * bw) / determinant) : 0.5;
    if (is_b) t = unit((s * ab - bw) / bb);
    if (is_a) s = unit((t * ab + aw) / aa);
    const DVec3 p = a + s * da, q = b + t * db;
    out.count = 1;
    out.points[0] = {q - (0.5 * separation) * n, separation};
    out.sideways = math::length((q - p) - dot(q - p, n) * n);
    out.is_cross = is_a && is_b && s > 0 && s < 1 && t > 0 && t < 1;
    return out;
}

EdgePoints edge_points(const Feature& first, const Feature& second, DVec3 n, double separation, ContactPoints& out) {
    const auto line = [](const Feature& f) {
        return EdgeLine{f.points[0], f.kind == Feature::Kind::segment ? f.points[1] - f.points[0] : DVec3{}};
    };
    const std::uint32_t base = feature_base(first.index, second.index);
    const EdgePoints found = edge_points(line(first), line(second), n, separation);
    const auto on_first = [&](int i) { return found.points[i].position - (0.5 * found.points[i].separation) * n; };
    out.list.clear();
    out.frame.origin = on_first(0), out.frame.normal = n;
    out.list.add({0, 0, found.points[0].separation, found.count == 1 ? base : base + 1});
    if (found.count == 2) {
        const DVec3 way = on_first(1) - on_first(0);
        out.frame.e1 = unit_or(way, {}), out.frame.e2 = math::cross(n, out.frame.e1);
        out.list.add({math::length(way), 0, found.points[1].separation, base + 2});
    }
    return found;
}

} // namespace cairn
