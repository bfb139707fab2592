// The candidate points of a contact, and the selection of at most four that represent them.
#pragma once

#include "collision/manifold.h"
#include "core/buffer.h"
#include "math/vec.h"

namespace cairn {

// A frame in the plane of a face or at an edge. Heights are measured along the contact normal, which is the normal of
// the plane except for tilted discs.
struct ContactFrame {
    math::DVec3 origin, e1, e2; // orthogonal unit vectors
    math::DVec3 normal;
    std::uint32_t feature = 0; // added to the features of all points
    bool leans = false;        // the normal is not perpendicular to the plane

    math::DVec3 to_frame(math::DVec3 p) const {
        const math::DVec3 d = p - origin;
        return {math::dot(d, e1), math::dot(d, e2), math::dot(d, normal)};
    }
};

struct ContactPoint {
    double x, y, separation;
    std::uint32_t feature;
};

struct ContactPoints {
    ContactFrame frame;
    Buffer<ContactPoint, 32> list;

    // The point midway between the surfaces.
    math::DVec3 position(double x, double y, double separation) const {
        return frame.origin + x * frame.e1 + y * frame.e2 + (0.5 * separation) * frame.normal;
    }
    math::DVec3 position(const ContactPoint& p) const { return position(p.x, p.y, p.separation); }
};

void clear_manifold(Manifold& out);

// Writes the points with separations up to `margin`, reduced to four. `center`: near the middle of the possible
// contact; `extent`: the size of the smaller shape, for the tolerances; separations below `least` are raised to it.
void write_manifold(const ContactPoints& points, const math::DVec3& normal, const math::DVec3& center, double extent,
                    double margin, double least, Manifold& out);

// Share of the extent: points closer to each other than this count as one point.
constexpr double same_point_part = 1e-3;
// Share of the extent: depths that differ by less than this count as equal.
constexpr double flat_contact_part = 1e-4;

} // namespace cairn
