// The candidate points of a contact, and the choice of at most four that represent them.
#pragma once

#include "collision/manifold.h"
#include "core/buffer.h"
#include "math/vec.h"

namespace cairn {

// A frame in the plane of a face or at an edge. Heights are measured along the normal of the contact, which is that of
// the plane but for discs that lean.
struct ContactFrame {
    math::DVec3 origin, e1, e2; // unit vectors, at right angles
    math::DVec3 normal;
    std::uint32_t feature = 0; // added to that of each point
    bool leans = false;        // the normal is not at right angles to the plane

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

    // Midway between the surfaces.
    math::DVec3 position(double x, double y, double separation) const {
        return frame.origin + x * frame.e1 + y * frame.e2 + (0.5 * separation) * frame.normal;
    }
    math::DVec3 position(const ContactPoint& p) const { return position(p.x, p.y, p.separation); }
};

void clear_manifold(Manifold& out);

// Writes the points that are not farther apart than `margin`, reduced to four. `center`: near the middle of where the
// contact may be; `extent`: the size of the smaller shape, for the tolerances; no separation is given as deeper than
// `least`.
void write_manifold(const ContactPoints& points, const math::DVec3& normal, const math::DVec3& center, double extent,
                    double margin, double least, Manifold& out);

// Points closer than this part of the extent are one point.
constexpr double same_point_part = 1e-3;
// Depths that differ by less than this part of it are equal.
constexpr double flat_contact_part = 1e-4;

} // namespace cairn
