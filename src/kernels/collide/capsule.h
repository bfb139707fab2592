// Helpers of the kernels for capsules with ends of equal radius: reading them, and writing the two contact points of a
// capsule that lies along something.
#pragma once

#include "kernels/collide/face_clip.h"

namespace cairn::CAIRN_ISA {

// Axes whose distance is less than this fraction of the sizes cross: the direction between them is mostly rounding.
constexpr float crossing = 1e-5f;
// Axes are parallel where the squared sine of the angle between them is less, as in collision/contact_clip.cpp.
constexpr float side_by_side = 1e-4f;

struct Capsulex8 {
    Vec3x8 axis; // unit
    f32x8 half, radius;
    f32x8 length() const { return half + radius; } // half of the total length, with the ends
};

CAIRN_INLINE Capsulex8 capsule_of(const ShapePosex8& shape) {
    return {to_matrix(shape.q).c1, shape.size.y, shape.size.x};
}

CAIRN_INLINE f32x8 square(f32x8 a) { return a * a; }

CAIRN_INLINE ContactPointx8 select(mask8 m, const ContactPointx8& a, const ContactPointx8& b) {
    return {select(m, a.position, b.position), select(m, a.separation, b.separation), select(m, a.feature, b.feature),
            (m & a.present) | and_not(b.present, m)};
}

// Writes those of two points that are present; `apart`: a lower bound of the shapes' distance where neither is.
CAIRN_INLINE void write_two(Manifold* out, Vec3x8 normal, const ContactPointx8& first, const ContactPointx8& second,
                            f32x8 apart) {
    Manifold* lane[8];
    for (int i = 0; i < 8; ++i) lane[i] = out + i;
    const mask8 none = zero() > zero();
    const ContactPointx8 unused = {zero3(), zero(), zero(), none};
    ContactPointx8 last = second;
    last.present = second.present & first.present;
    write_manifolds(lane, normal, {select(first.present, first, second), last, unused, unused}, apart);
}

} // namespace cairn::CAIRN_ISA
