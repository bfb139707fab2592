// Mass properties of rounded solids. A rounded solid consists of the sharp solid, slabs on its faces, cylinder sectors
// along its edges and ball sectors at its corners (Steiner's formula); the integrals over each part have closed forms.
#include "shapes/rounded_mass.h"

#include "math/angle.h"

#include <algorithm>
#include <vector>

namespace cairn {

using math::angle_of;
using math::DSym3;
using math::DVec3;
using math::pi;

namespace {

// Integrals of 1, x and x x^T.
struct Moments {
    double volume = 0;
    DVec3 first;
    DSym3 second;

    void add(double v, DVec3 f) { volume += v, first += f; }
    // weight (a b^T + b a^T) / 2
    void add_product(double weight, DVec3 a, DVec3 b) {
        const auto entry = [&](int i, int j) { return 0.5 * weight * (a[i] * b[j] + b[i] * a[j]); };
        second = second + DSym3{entry(0, 0), entry(0, 1), entry(0, 2), entry(1, 1), entry(1, 2), entry(2, 2)};
    }
    void add_diagonal(double d) { second = second + DSym3{d, 0, 0, d, 0, d}; }

    // Mass properties; x is measured from `origin`.
    MassSum mass(DVec3 origin) const {
        MassSum m;
        m.mass = volume;
        const DVec3 center = (1 / volume) * first;
        m.center = origin + center;
        Moments about = *this;
        about.add_product(-volume, center, center);
        const DSym3& s = about.second;
        m.inertia = {s.yy + s.zz, -s.xy, -s.xz, s.xx + s.zz, -s.yz, s.xx + s.yy};
        return m;
    }
};

} // namespace

// The eight ball sectors at the corners form one ball, and the quarter cylinders along four parallel edges one
// cylinder. A point at the distance |u| from the middle of these has the coordinate a + |u|.
MassSum rounded_box_mass(DVec3 a, double r) {
    const double r2 = r * r, r3 = r2 * r, ball = 4.0 / 3.0 * pi * r3;
    DVec3 square; // integrals of x^2, y^2, z^2
    double volume = 8 * a.x * a.y * a.z;
    for (int i = 0; i < 3; ++i) square[i] = volume / 3 * a[i] * a[i];
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        const double slab = 8 * a[j] * a[k] * r; // both slabs on the faces perpendicular to axis i
        square[i] += slab * (a[i] * a[i] + a[i] * r + r2 / 3);
        square[j] += slab / 3 * a[j] * a[j];
        square[k] += slab / 3 * a[k] * a[k];
        const double length = 2 * a[i], edge = pi * r2 * length; // the four edges along axis i
        square[i] += edge / 3 * a[i] * a[i];
        for (const int across : {j, k})
            square[across] += edge * a[across] * a[across] + length * (8.0 / 3.0 * a[across] * r3 + pi / 4 * r2 * r2);
        square[i] += ball * a[i] * a[i] + pi * a[i] * r2 * r2 + 4.0 / 15.0 * pi * r3 * r2;
        volume += slab + edge;
    }
    MassSum m;
    m.mass = volume + ball;
    m.inertia = {square.y + square.z, 0, 0, square.x + square.z, 0, square.x + square.y};
    return m;
}

namespace {

// Integrals over a solid of revolution about y.
struct Slices {
    double volume = 0, first = 0, second = 0, axial = 0; // integrals of 1, y, y^2 and x^2 + z^2

    // A frustum from y0, where the radius is a, to y0 + height, where it is b (see geometry_mass.cpp).
    void add_frustum(double y0, double height, double a, double b) {
        const double aa = a * a, ab = a * b, bb = b * b;
        const double v = pi * height * (aa + ab + bb) / 3, f = pi * height * height * (aa + 2 * ab + 3 * bb) / 12;
        const double s = pi * height * height * height * (aa / 30 + ab / 10 + bb / 5);
        volume += v;
        first += y0 * v + f;
        second += y0 * y0 * v + 2 * y0 * f + s;
        axial += pi / 2 * height * (aa * aa + aa * ab + aa * bb + ab * bb + bb * bb) / 5;
    }

    // The rounded rim: at y0 + side u, 0 <= u0 <= r, the radius is A + w with w = sqrt(r^2 - u^2), for u from u0 to r
    // (u0 may be negative). Uses the integrals of w, u w, u^2 w and w^3 over this range; those of even powers of w are
    // polynomials.
    void add_rim(double y0, double side, double A, double r, double u0, double w0) {
        const double r2 = r * r, angle = angle_of(u0, w0); // of the sector
        const double w = 0.5 * (r2 * angle - u0 * w0), uw = w0 * w0 * w0 / 3;
        const double w3 = 0.25 * (3 * r2 * w - u0 * w0 * w0 * w0), u2w = r2 * w - w3;
        const auto power = [&](int n) { // integral of u^n
            double to = r, from = u0;
            for (int i = 0; i < n; ++i) to *= r, from *= u0;
            return (to - from) / (n + 1);
        };
        const double one = power(0), u = power(1), u2 = power(2), u3 = power(3), u4 = power(4);
        const double R = A * A + r2; // the square of the radius is R - u^2 + 2 A w
        const double v = pi * (R * one - u2 + 2 * A * w), f = side * pi * (R * u - u3 + 2 * A * uw);
        const double s = pi * (R * u2 - u4 + 2 * A * u2w);
        volume += v;
        first += y0 * v + f;
        second += y0 * y0 * v + 2 * y0 * f + s;
        const double ww = r2 * one - u2, wwww = r2 * r2 * one - 2 * r2 * u2 + u4;
        axial += pi / 2 * (A * A * A * A * one + 4 * A * A * A * w + 6 * A * A * ww + 4 * A * w3 + wwww);
    }
};

} // namespace

// The lateral surface moves outward along its normal (c, s); the rims become arcs of radius r from its normal to those
// of the ends.
MassSum rounded_cylinder_mass(DVec3 size, double r) {
    const double a = size.x, h = size.y, b = size.z;
    const double slope = std::sqrt(4 * h * h + (a - b) * (a - b)), c = 2 * h / slope, s = (a - b) / slope;
    Slices sum;
    sum.add_rim(-h, -1, a, r, -s * r, c * r);
    sum.add_frustum(-h + s * r, 2 * h, a + c * r, b + c * r);
    sum.add_rim(h, 1, b, r, s * r, c * r);
    MassSum m;
    m.mass = sum.volume;
    m.center = {0, sum.first / sum.volume, 0};
    const double across = sum.axial / 2 + (sum.second - sum.first * m.center.y);
    m.inertia = {across, 0, 0, sum.axial, 0, across};
    return m;
}

namespace {

// An edge of a hull as part of one of its two faces.
struct HalfEdge {
    std::uint32_t low, high; // its corners
    std::uint32_t face;
};

std::vector<HalfEdge> half_edges_of(const HullData& hull) {
    std::vector<HalfEdge> edges;
    for (std::uint32_t f = 0; f < hull.faces.size(); ++f) {
        const HullFace& face = hull.faces[f];
        for (std::uint32_t i = 0; i < face.count; ++i) {
            const std::uint32_t p = hull.loops[face.first + i], q = hull.loops[face.first + (i + 1) % face.count];
            edges.push_back({std::min(p, q), std::max(p, q), f});
        }
    }
    std::sort(edges.begin(), edges.end(), [](const HalfEdge& x, const HalfEdge& y) {
        return x.low != y.low ? x.low < y.low : x.high != y.high ? x.high < y.high : x.face < y.face;
    });
    return edges;
}

class RoundedHull {
  public:
    RoundedHull(const HullData& hull, double r) : hull_(hull), r_(r), origin_(hull.unit_mass.center) {}

    MassSum mass() {
        const MassSum& core = hull_.unit_mass;
        sum_.volume = core.mass;
        const DSym3& i = core.inertia;
        const double trace = 0.5 * (i.xx + i.yy + i.zz);
        sum_.second = {trace - i.xx, -i.xy, -i.xz, trace - i.yy, -i.yz, trace - i.zz};
        solid_angle_.assign(hull_.vertices.size(), 2 * pi);
        for (std::uint32_t f = 0; f < hull_.faces.size(); ++f) add_face(f);
        const std::vector<HalfEdge> edges = half_edges_of(hull_);
        for (std::size_t e = 0; e + 1 < edges.size(); e += 2) add_edge(edges[e], edges[e + 1].face);
        for (std::uint32_t v = 0; v < hull_.vertices.size(); ++v) add_corner(corner(v), solid_angle_[v]);
        return sum_.mass(origin_);
    }

  private:
    DVec3 corner(std::uint32_t v) const { return math::to_double(hull_.vertices[v]) - origin_; }

    // Adds a slab of thickness r, one triangle at a time. Also subtracts the angles of the face at its corners from
    // their solid angles: 2 pi minus the face angles is the solid angle of a corner's ball sector (Descartes).
    void add_face(std::uint32_t index) {
        const HullFace& face = hull_.faces[index];
        const DVec3 n = hull_.unit_normal(index);
        const auto at = [&](std::uint32_t i) { return corner(hull_.loops[face.first + i % face.count]); };
        const DVec3 a = at(0);
        for (std::uint32_t i = 1; i + 1 < face.count; ++i) {
            const DVec3 b = at(i), c = at(i + 1), three = a + b + c;
            const double area = 0.5 * math::dot(n, math::cross(b - a, c - a));
            // The points p + t n with p in the triangle and t from 0 to r.
            const DVec3 first = (area / 3) * three;
            sum_.add(area * r_, r_ * first + (0.5 * r_ * r_ * area) * n);
            for (const DVec3& p : {a, b, c, three}) sum_.add_product(r_ * area / 12, p, p);
            sum_.add_product(r_ * r_, first, n);
            sum_.add_product(r_ * r_ * r_ / 3 * area, n, n);
        }
        for (std::uint32_t i = 0; i < face.count; ++i) {
            const DVec3 p = at(i), to = at(i + 1) - p, from = at(i + face.count - 1) - p;
            solid_angle_[hull_.loops[face.first + i]] -=
                angle_of(math::dot(to, from), math::length(math::cross(to, from)));
        }
    }

    // Adds a cylinder sector between the normals of both faces, and the contribution of the arc between these normals
    // to the spherical polygons at both ends.
    void add_edge(const HalfEdge& edge, std::uint32_t other_face) {
        const DVec3 m1 = hull_.unit_normal(edge.face), m2 = hull_.unit_normal(other_face);
        const DVec3 p = corner(edge.low), q = corner(edge.high), along = q - p;
        const double length = math::length(along), cosine = math::dot(m1, m2);
        const double angle = angle_of(cosine, math::length(math::cross(m1, m2)));
        const DVec3 middle = math::normalized(m1 + m2), d = (1 / length) * along;
        const DVec3 side = math::cross(d, middle);
        // Directions u at angles from -angle / 2 to angle / 2 about the middle one: integrals of u and u u^T.
        const double half_sine = std::sqrt(std::max(0.0, 0.5 * (1 - cosine))),
                     sine = std::sqrt(1 - half_sine * half_sine) * half_sine;
        const DVec3 u = (2 * half_sine) * middle;
        const double uu = 0.5 * angle + sine, vv = 0.5 * angle - sine;
        const double r2 = r_ * r_, volume = 0.5 * r2 * angle * length, third = r2 * r_ / 3 * length;
        const DVec3 mean = 0.5 * (p + q);
        sum_.add(volume, volume * mean + third * u);
        sum_.add_product(volume / 3, p, p);
        sum_.add_product(volume / 3, q, q);
        sum_.add_product(volume / 3, p, q);
        sum_.add_product(2 * third, mean, u);
        sum_.add_product(0.25 * r2 * r2 * length * uu, middle, middle);
        sum_.add_product(0.25 * r2 * r2 * length * vv, side, side);
        // The spherical polygon at corner p is on the side of -d, that at q on the side of d.
        add_arc(p, d, u, angle);
        add_arc(q, -d, u, angle);
    }

    // Adds the contribution of one side of a spherical polygon to a ball sector at p, whose directions w fill the
    // polygon: to the integral of w, -1/2 sum angle n, and to that of w w^T, -1/3 sum u n^T, where n is the outward
    // normal of the side and u the integral of w along it (Arvo, "Applications of Irradiance Tensors to the Simulation
    // of Non-Lambertian Phenomena", 1995).
    void add_arc(DVec3 p, DVec3 n, DVec3 u, double angle) {
        const double r4 = r_ * r_ * r_ * r_;
        const DVec3 w = (-0.5 * angle) * n;
        sum_.add(0, 0.25 * r4 * w);
        sum_.add_product(0.5 * r4, p, w);
        sum_.add_product(-r4 * r_ / 15, u, n);
    }
    void add_corner(DVec3 p, double solid_angle) {
        const double volume = r_ * r_ * r_ / 3 * solid_angle;
        sum_.add(volume, volume * p);
        sum_.add_product(volume, p, p);
        sum_.add_diagonal(0.2 * r_ * r_ * volume);
    }

    const HullData& hull_;
    double r_;
    DVec3 origin_;
    Moments sum_;
    std::vector<double> solid_angle_; // per corner: the solid angle of its outward normals
};

} // namespace

MassSum rounded_hull_mass(const HullData& hull, double radius) { return RoundedHull(hull, radius).mass(); }

} // namespace cairn
