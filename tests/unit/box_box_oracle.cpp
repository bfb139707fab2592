#include "box_box_oracle.h"

#include <algorithm>

namespace collide_test {

double separation_along(const Frame& a, const Frame& b, const Vec& n) {
    double s = dot(n, b.center - a.center);
    for (std::size_t i = 0; i < 3; ++i) {
        s -= a.half[i] * std::fabs(dot(n, a.axis[i]));
        s -= b.half[i] * std::fabs(dot(n, b.axis[i]));
    }
    return s;
}

SeparatingAxis greatest_separation(const Frame& a, const Frame& b) {
    SeparatingAxis best = {-1e300, {0, 0, 0}, false, 1.0};
    const auto consider = [&](Vec n, bool edges, double sine) {
        if (dot(n, b.center - a.center) < 0) n = -1.0 * n;
        const double s = separation_along(a, b, n);
        if (s > best.separation) best = {s, n, edges, sine};
    };
    for (std::size_t i = 0; i < 3; ++i) consider(a.axis[i], false, 1.0);
    for (std::size_t j = 0; j < 3; ++j) consider(b.axis[j], false, 1.0);
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) {
            const Vec n = cross(a.axis[i], b.axis[j]);
            const double l = length(n);
            if (l > 1e-7) consider((1.0 / l) * n, true, l);
        }
    return best;
}

double distance_to_box(const Frame& box, const Vec& p) {
    const Vec local = box.to_local(p);
    Vec outside;
    double inside = -1e300;
    for (std::size_t i = 0; i < 3; ++i) {
        const double d = std::fabs(local[i]) - box.half[i];
        outside[i] = std::max(d, 0.0);
        inside = std::max(inside, d);
    }
    const double l = length(outside);
    return l > 0 ? l : inside;
}

double area_of(const Polygon& p) {
    double twice = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const auto &u = p[i], &v = p[(i + 1) % p.size()];
        twice += u[0] * v[1] - u[1] * v[0];
    }
    return std::fabs(twice) / 2;
}

Polygon convex_hull(Polygon points) {
    if (points.size() < 3) return points;
    std::sort(points.begin(), points.end());
    Polygon hull;
    for (int pass = 0; pass < 2; ++pass) {
        const std::size_t start = hull.size();
        for (const auto& p : points) {
            while (hull.size() >= start + 2) {
                const auto &u = hull[hull.size() - 2], &v = hull.back();
                if ((v[0] - u[0]) * (p[1] - u[1]) - (v[1] - u[1]) * (p[0] - u[0]) > 0) break;
                hull.pop_back();
            }
            hull.push_back(p);
        }
        hull.pop_back();
        std::reverse(points.begin(), points.end());
    }
    return hull;
}

std::array<double, 2> across(const Vec& normal, const Vec& p) {
    Vec other = {0, 0, 0};
    std::size_t smallest = 0;
    for (std::size_t i = 1; i < 3; ++i)
        if (std::fabs(normal[i]) < std::fabs(normal[smallest])) smallest = i;
    other[smallest] = 1;
    Vec u = cross(normal, other);
    u = (1.0 / length(u)) * u;
    return {dot(u, p), dot(cross(normal, u), p)};
}

namespace {

// The vertices of the box face whose normal is closest to the given direction, in order.
std::vector<Vec> face_along(const Frame& box, const Vec& direction) {
    std::size_t k = 0;
    for (std::size_t i = 1; i < 3; ++i)
        if (std::fabs(dot(box.axis[i], direction)) > std::fabs(dot(box.axis[k], direction))) k = i;
    const std::size_t u = (k + 1) % 3, v = (k + 2) % 3;
    std::vector<Vec> corners;
    for (const auto& sign : {std::array<double, 2>{1, 1}, {-1, 1}, {-1, -1}, {1, -1}}) {
        Vec local;
        local[k] = dot(box.axis[k], direction) > 0 ? box.half[k] : -box.half[k];
        local[u] = sign[0] * box.half[u];
        local[v] = sign[1] * box.half[v];
        corners.push_back(box.to_world(local));
    }
    return corners;
}

// Sutherland-Hodgman clipping: the part of a polygon where n . p <= limit.
std::vector<Vec> cut(const std::vector<Vec>& polygon, const Vec& n, double limit) {
    std::vector<Vec> r;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
        const double dp = dot(n, p) - limit, dq = dot(n, q) - limit;
        if (dp <= 0) r.push_back(p);
        if ((dp < 0 && dq > 0) || (dp > 0 && dq < 0)) r.push_back(p + (dp / (dp - dq)) * (q - p));
    }
    return r;
}

} // namespace

FaceContact face_contact(const Frame& a, const Frame& b, const Vec& normal, double margin) {
    for (int swap = 0; swap < 2; ++swap) {
        const Frame &reference = swap ? b : a, &incident = swap ? a : b;
        const Vec out = swap ? -1.0 * normal : normal;
        for (std::size_t k = 0; k < 3; ++k) {
            if (std::fabs(dot(reference.axis[k], out)) < 1 - 1e-9) continue;
            std::vector<Vec> polygon = face_along(incident, -1.0 * out);
            for (std::size_t s = 1; s < 3; ++s) {
                const std::size_t i = (k + s) % 3;
                const double c = dot(reference.axis[i], reference.center);
                polygon = cut(polygon, reference.axis[i], c + reference.half[i]);
                polygon = cut(polygon, -1.0 * reference.axis[i], -c + reference.half[i]);
            }
            const double face = dot(out, reference.center) + reference.half[k];
            FaceContact r = {true, {}};
            for (const Vec& p : polygon)
                if (dot(out, p) - face <= margin) r.polygon.push_back(across(normal, p));
            r.polygon = convex_hull(r.polygon);
            return r;
        }
    }
    return {false, {}};
}

} // namespace collide_test
