#include "collision/contact_features.h"

namespace cairn {

using math::dot;
using math::DVec3;

namespace {

// As in kernels/face_clip.h: the reference face is widened by this part of its size, and its corners count as inside
// the incident one only where they are inside by as much. Aligned faces of equal size stay whole under rounding.
constexpr double face_tolerance = 1e-4;
// A face seen at less than this cosine is seen edge-on and has no inside.
constexpr double edge_on = 1e-2;
// Candidates are numbered from these on, so that features differ by their kind.
constexpr std::uint32_t from_rim = 0, from_edges = 16, from_corners = 0x8000;

struct Point3 {
    double x, y, z; // z: along the reference normal
};
using Polygon = Buffer<Point3, 16>;

// The part of p + t (q - p), 0 <= t <= 1, within a polygon that is counterclockwise in x and y.
struct Part {
    double start = 0, end = 1;
    bool is_empty() const { return start > end; }
    void cut(double at_p, double at_q) { // heights inside a border
        if (at_p < 0 && at_q < 0)
            start = 2;
        else if (at_p < 0)
            start = std::max(start, at_p / (at_p - at_q));
        else if (at_q < 0)
            end = std::min(end, at_p / (at_p - at_q));
    }
};

double size_of(const Polygon& polygon) {
    double size = 0;
    for (const Point3& p : polygon) size = std::max(size, std::max(std::fabs(p.x), std::fabs(p.y)));
    return size;
}

// The side of a polygon: how far a point is inside is nx x + ny y + offset. Sides without length hold everything.
struct Border {
    double nx, ny, offset;
    double inside(const Point3& p) const { return nx * p.x + ny * p.y + offset; }
};
using Borders = Buffer<Border, 16>;

void find_borders(const Polygon& polygon, Borders& out) {
    const std::size_t n = polygon.size();
    for (std::size_t i = 0; i < n; ++i) {
        const Point3 &a = polygon[i], &b = polygon[i + 1 < n ? i + 1 : 0];
        const double dx = b.x - a.x, dy = b.y - a.y, square = dx * dx + dy * dy;
        const double s = square > 0 ? 1 / std::sqrt(square) : 0;
        out.add({-s * dy, s * dx, s * (dy * a.x - dx * a.y)});
    }
}

bool is_within(const Borders& borders, const Point3& p, double slack) {
    for (const Border& b : borders)
        if (b.inside(p) < -slack) return false;
    return true;
}

// How far points are inside each border of a polygon, with the slack: of the first point, of the second and so on.
struct Heights {
    Heights(const Borders& borders, const Polygon& points, double slack) : border_count(borders.size()) {
        for (const Point3& p : points)
            for (const Border& b : borders) values.add(b.inside(p) + slack);
    }
    Part cut(std::size_t p, std::size_t q) const {
        Part part;
        const double *at_p = values.data() + p * border_count, *at_q = values.data() + q * border_count;
        for (std::size_t k = 0; k < border_count; ++k) part.cut(at_p[k], at_q[k]);
        return part;
    }
    std::size_t border_count;
    Buffer<double, 64> values;
};

Point3 between(const Point3& p, const Point3& q, double t) {
    return {p.x + t * (q.x - p.x), p.y + t * (q.y - p.y), p.z + t * (q.z - p.z)};
}

// The frame of a face: its corner or center, two directions along it and the normal.
struct Frame {
    DVec3 origin, e1, e2, normal;
    std::uint32_t feature; // added to that of each point
    Point3 to_frame(DVec3 p) const {
        const DVec3 d = p - origin;
        return {dot(d, e1), dot(d, e2), dot(d, normal)};
    }
    void add(ContactPoints& out, const Point3& p, std::uint32_t number) const {
        out.add({origin + p.x * e1 + p.y * e2 + (0.5 * p.z) * normal, p.z, feature + number});
    }
};

DVec3 unit_or(DVec3 v, DVec3 other) {
    const double length = math::length(v);
    return length > 0 ? (1 / length) * v : other;
}

std::uint32_t feature_base(const Feature& reference, const Feature& incident) {
    return (reference.index * 64 + incident.index) << 17;
}

void polygon_points(const Feature& reference, const Feature& incident, ContactPoints& out) {
    Frame frame;
    frame.origin = reference.points[0];
    frame.normal = reference.normal;
    frame.e1 = unit_or(reference.points[1] - reference.points[0], {});
    if (frame.e1 == DVec3{}) frame.e1 = math::to_double(math::any_orthogonal(math::to_float(frame.normal)));
    frame.e2 = math::cross(frame.normal, frame.e1);
    frame.feature = feature_base(reference, incident);
    Polygon face, other;
    for (const DVec3& p : reference.points) face.add(frame.to_frame(p));
    for (const DVec3& p : incident.points) other.add(frame.to_frame(p));
    const double slack = face_tolerance * size_of(face);
    Borders borders;
    find_borders(face, borders);
    const std::size_t n = other.size();
    if (n == 1) {
        if (is_within(borders, other[0], slack)) frame.add(out, other[0], from_edges);
        return;
    }
    const Heights heights(borders, other, slack);
    for (std::size_t i = 0; i < (n == 2 ? 1 : n); ++i) {
        const std::size_t next = i + 1 < n ? i + 1 : 0;
        const Point3 &p = other[i], &q = other[next];
        const Part part = heights.cut(i, next);
        if (part.is_empty()) continue;
        const auto number = static_cast<std::uint32_t>(from_edges + 2 * i);
        frame.add(out, between(p, q, part.start), number);
        // The end of an edge is the start of the next.
        if (part.end < 1 || n == 2) frame.add(out, between(p, q, part.end), number + 1);
    }
    const DVec3 m{dot(incident.normal, frame.e1), dot(incident.normal, frame.e2), dot(incident.normal, frame.normal)};
    if (n == 2 || !(m.z < -edge_on)) return;
    std::swap(other[0], other[n - 1]); // the other way round: counterclockwise from this side
    for (std::size_t i = 1; i < n - 1 - i; ++i) std::swap(other[i], other[n - 1 - i]);
    borders.clear();
    find_borders(other, borders);
    for (std::size_t i = 0; i < face.size(); ++i) {
        Point3 p = face[i];
        if (!is_within(borders, p, -slack)) continue;
        p.z = other[0].z - ((p.x - other[0].x) * m.x + (p.y - other[0].y) * m.y) / m.z;
        frame.add(out, p, static_cast<std::uint32_t>(from_corners + i));
    }
}

// A disc leans when one side of its rim is lower than its center by this.
double lean(double extent) { return 0.5 * flat_contact_part * extent; }

// A disc seen as a polygon that has its lowest point over the reference disc as a corner, or if it does not lean, the
// four points of that.
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

// In the plane of the disc. m: the contact normal, from the disc to the other feature, along which points of the two
// surfaces face each other.
class DiscPoints {
  public:
    DiscPoints(const Feature& disc, const Feature& other, DVec3 m, double extent, ContactPoints& out)
        : disc_(disc), other_(other), m_(m), cosine_(dot(m, disc.normal)), extent_(extent), out_(out),
          base_(feature_base(disc, other)) {
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
    void add(const Point3& p, std::uint32_t number) {
        out_.add({disc_.center + p.x * disc_.u + p.y * disc_.v + (0.5 * p.z) * m_, p.z, base_ + number});
    }

    // Four points of the rim. They do not turn with the disc: on a face they keep to its first edge, and as soon as the
    // disc leans to one side the first is the lowest.
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
        Polygon polygon; // counterclockwise as the disc sees it
        for (std::size_t i = corners_.size(); i-- > 0;) polygon.add(corners_[i]);
        Borders borders;
        find_borders(polygon, borders);
        const Point3 directions[4] = {{x, y, 0}, {-x, -y, 0}, {-y, x, 0}, {y, -x, 0}};
        for (std::uint32_t i = 0; i < 4; ++i) {
            Point3 p{disc_.radius * directions[i].x, disc_.radius * directions[i].y, 0};
            p.z = z0 + gx * p.x + gy * p.y;
            if (is_within(borders, p, face_tolerance * disc_.radius)) add(p, from_rim + (leans ? 4 : 0) + i);
        }
    }

    // Where an edge crosses the rim; with `both`, also its ends inside.
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
    std::uint32_t base_;
    Polygon corners_; // of the other feature, seen along m in the plane of the disc
};

} // namespace

void face_points(const Feature& reference, const Feature& incident, double extent, ContactPoints& out) {
    using Kind = Feature::Kind;
    if (reference.kind == Kind::disc) {
        Feature polygon;
        if (incident.kind == Kind::disc) disc_polygon(incident, reference, extent, polygon);
        const Feature& other = incident.kind == Kind::disc ? polygon : incident;
        DiscPoints(reference, other, reference.normal, extent, out).find();
    } else if (incident.kind == Kind::disc) {
        DiscPoints(incident, reference, -reference.normal, extent, out).find();
    } else {
        polygon_points(reference, incident, out);
    }
}

EdgePoints edge_points(const EdgeLine& first, const EdgeLine& second, DVec3 n, double separation) {
    constexpr double parallel = 1e-2;
    const DVec3 a = first.from, b = second.from, da = first.way, db = second.way, w = b - a;
    const double aa = dot(da, da), bb = dot(db, db), ab = dot(da, db);
    const bool is_a = aa > 0, is_b = bb > 0;
    EdgePoints out;
    if (is_a && is_b && aa * bb - ab * ab < parallel * parallel * aa * bb) {
        // Side by side: the part of the first that the second covers. All points are exactly under the second, for
        // seams.
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
    return out;
}

double edge_points(const Feature& first, const Feature& second, DVec3 n, double separation, ContactPoints& out) {
    const auto line = [](const Feature& f) {
        return EdgeLine{f.points[0], f.kind == Feature::Kind::segment ? f.points[1] - f.points[0] : DVec3{}};
    };
    const std::uint32_t base = (first.index * 64 + second.index) << 17;
    const EdgePoints found = edge_points(line(first), line(second), n, separation);
    for (int i = 0; i < found.count; ++i)
        out.add({found.points[i].position, found.points[i].separation,
                 found.count == 1 ? base : base + 1 + static_cast<std::uint32_t>(i)});
    return found.sideways;
}

} // namespace cairn
