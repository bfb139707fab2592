// The nearest points lie on an edge of the triangle, or they are a corner of the box and a point inside the triangle.
#include "shapes/box_triangle_distance.h"

#include <algorithm>
#include <limits>

namespace cairn {

using math::dot;
using math::DVec3;

namespace {

double clamped(double x, double half) { return x < -half ? -half : x > half ? half : x; }
DVec3 clamped(DVec3 p, DVec3 half) { return {clamped(p.x, half.x), clamped(p.y, half.y), clamped(p.z, half.z)}; }

// A segment from `from` to `from + way`, to be tested against a box of half extents `half`.
struct Segment {
    DVec3 from, way, half;

    // Half the derivative, by t, of the squared distance between the segment's point at t and the box. It is
    // nondecreasing, and linear between the parameters at which the segment crosses planes of faces.
    double rise(double t) const {
        const DVec3 p = from + t * way;
        return dot(way, p - clamped(p, half));
    }

    // The squared distance between the bounds of the segment and the box: a lower bound.
    double bound() const {
        const DVec3 to = from + way;
        double square = 0;
        for (int i = 0; i < 3; ++i) {
            const double above = std::min(from[i], to[i]) - half[i], below = -std::max(from[i], to[i]) - half[i];
            const double d = std::max(above, below);
            if (d > 0) square += d * d;
        }
        return square;
    }

    double nearest() const {
        double low = 0, high = 1, rise_low = rise(0);
        if (rise_low >= 0) return 0;
        double rise_high = rise(1);
        if (rise_high <= 0) return 1;
        const auto narrow = [&](double t) {
            if (!(t > low && t < high)) return;
            const double r = rise(t);
            if (r < 0)
                low = t, rise_low = r;
            else
                high = t, rise_high = r;
        };
        for (int i = 0; i < 3; ++i) {
            if (way[i] == 0) continue;
            const double scale = 1 / way[i];
            narrow((half[i] - from[i]) * scale);
            narrow((-half[i] - from[i]) * scale);
        }
        return low + (high - low) * (rise_low / (rise_low - rise_high));
    }
};

} // namespace

bool nearest_of_box_and_triangle(DVec3 half, const DVec3 (&corners)[3], DVec3& on_box, DVec3& on_triangle) {
    double least = std::numeric_limits<double>::infinity();
    const auto offer = [&](DVec3 box, DVec3 triangle) {
        const DVec3 d = triangle - box;
        const double square = dot(d, d);
        if (square < least) least = square, on_box = box, on_triangle = triangle;
    };
    const DVec3 edges[3] = {corners[1] - corners[0], corners[2] - corners[1], corners[0] - corners[2]};
    for (int e = 0; e < 3; ++e) {
        const Segment segment{corners[e], edges[e], half};
        if (segment.bound() > least) continue;
        const DVec3 p = segment.from + segment.nearest() * segment.way;
        offer(clamped(p, half), p);
    }
    const DVec3 normal = math::cross(edges[0], edges[1]);
    const double square = dot(normal, normal);
    const auto is_over = [&](DVec3 p) { // whether p is over the triangle, seen along its normal
        for (int e = 0; e < 3; ++e)
            if (!(dot(math::cross(normal, edges[e]), p - corners[e]) > 0)) return false;
        return true;
    };
    // The lowest corner of the box, where up is the side of the triangle's plane that contains the center of the box.
    const DVec3 up = dot(normal, corners[0]) > 0 ? -normal : normal;
    const DVec3 corner{up.x > 0 ? -half.x : half.x, up.y > 0 ? -half.y : half.y, up.z > 0 ? -half.z : half.z};
    const double middle = -dot(up, corners[0]), height = dot(up, corner) + middle;
    if (height > 0) {
        if (is_over(corner)) offer(corner, corner - (height / square) * up);
    } else if (is_over((middle / (middle - height)) * corner)) {
        return false; // the box intersects the plane inside the triangle, or it intersects the edges
    }
    // As in gjk_distance, shapes closer than a ten-billionth of their size count as intersecting.
    const double size = dot(half, half) + dot(on_triangle, on_triangle);
    return least > 1e-20 * size;
}

} // namespace cairn
