// Helpers of the narrow-phase kernels: reading eight poses, and writing eight manifolds.
#pragma once

#include "collision/manifold.h"
#include "collision/one_place.h"
#include "collision/shape_pose.h"
#include "simd/wide_math.h"

namespace cairn::CAIRN_ISA {

// The separation that marks a point of a manifold as unused.
constexpr float unused_separation = 1e30f;

struct ShapePosex8 {
    Vec3x8 high, low;
    Quatx8 q;
    Vec3x8 size;
    f32x8 radius, number;
};

CAIRN_INLINE ShapePosex8 gather_shapes(const ShapePose* poses, const std::uint32_t* index) {
    const float* row[8];
    ShapePosex8 r;
    f32x8 unused;
    for (int i = 0; i < 8; ++i) row[i] = poses[index[i]].high;
    gather4(row, r.high.x, r.high.y, r.high.z, unused);
    for (int i = 0; i < 8; ++i) row[i] = poses[index[i]].low;
    gather4(row, r.low.x, r.low.y, r.low.z, r.number);
    for (int i = 0; i < 8; ++i) row[i] = poses[index[i]].q;
    gather4(row, r.q.v.x, r.q.v.y, r.q.v.z, r.q.w);
    for (int i = 0; i < 8; ++i) row[i] = poses[index[i]].size;
    gather4(row, r.size.x, r.size.y, r.size.z, r.radius);
    return r;
}

// From the center of a to the center of b. This order of operations loses no precision far from the origin.
CAIRN_INLINE Vec3x8 offset_between(const ShapePosex8& a, const ShapePosex8& b) {
    return (b.high - a.high) + (b.low - a.low);
}

// Squared length in m^2 below which a direction counts as undefined: two centers, or a center and a surface, coincide.
constexpr float no_direction = 1e-30f;

inline void separate_coincident_centers(const ShapePosex8& a, const ShapePosex8& b, Vec3x8& offset) {
    const int lanes = bits(dot(offset, offset) <= splat(no_direction));
    alignas(32) float x[8], y[8], z[8], number_a[8], number_b[8], size[8];
    store(x, offset.x), store(y, offset.y), store(z, offset.z);
    store(number_a, a.number), store(number_b, b.number), store(size, a.radius + b.radius);
    for (int i = 0; i < 8; ++i) {
        if ((lanes >> i & 1) == 0) continue;
        float apart[3];
        coincident_center_offset(number_a[i], number_b[i], size[i], apart);
        x[i] = apart[0], y[i] = apart[1], z[i] = apart[2];
    }
    offset = {load(x), load(y), load(z)};
}

// The offset between centers, never zero, for shapes that can be pushed out in any direction.
CAIRN_INLINE Vec3x8 nonzero_center_offset(const ShapePosex8& a, const ShapePosex8& b) {
    Vec3x8 offset = offset_between(a, b);
    if (any(dot(offset, offset) <= splat(no_direction))) separate_coincident_centers(a, b, offset);
    return offset;
}

CAIRN_INLINE Vec3x8 up() { return {zero(), one(), zero()}; }

// v / |v|, and `fallback` where the square of v is not more than `least`; the length is written too.
CAIRN_INLINE Vec3x8 direction(Vec3x8 v, f32x8 least, Vec3x8 fallback, f32x8& length) {
    const f32x8 squared = dot(v, v);
    const mask8 defined = squared > least;
    length = sqrt(squared);
    return select(defined, (one() / select(defined, length, one())) * v, fallback);
}

// A float with the given bits in every lane; only to be copied, never for arithmetic.
CAIRN_INLINE f32x8 splat_bits(std::uint32_t b) {
    float f;
    std::memcpy(&f, &b, sizeof f);
    return splat(f);
}

struct ContactPointx8 {
    Vec3x8 position; // midway between the surfaces, relative to the first shape's center
    f32x8 separation;
    f32x8 feature; // any bits
    mask8 present;
};

// Writes up to four points per lane to *out[lane]. A point may only be present where all before it are. `apart`: a
// lower bound of the shapes' distance, for lanes without points.
CAIRN_INLINE void write_manifolds(Manifold* const* out, Vec3x8 normal, const ContactPointx8 (&points)[4],
                                  f32x8 apart = splat(unused_separation)) {
    float* row[8];
    f32x8 count = splat_bits(0), feature[4];
    for (int k = 0; k < 4; ++k) count = select(points[k].present, splat_bits(static_cast<std::uint32_t>(k + 1)), count);
    normal = select(points[0].present, normal, zero3());
    for (int i = 0; i < 8; ++i) row[i] = out[i]->normal;
    scatter4(row, normal.x, normal.y, normal.z, count);
    for (int k = 0; k < 4; ++k) {
        const Vec3x8 p = select(points[k].present, points[k].position, zero3());
        const f32x8 s = select(points[k].present, points[k].separation, k == 0 ? apart : splat(unused_separation));
        feature[k] = select(points[k].present, points[k].feature, splat_bits(0));
        for (int i = 0; i < 8; ++i) row[i] = out[i]->points[k];
        scatter4(row, p.x, p.y, p.z, s);
    }
    for (int i = 0; i < 8; ++i) row[i] = reinterpret_cast<float*>(out[i]->features);
    scatter4(row, feature[0], feature[1], feature[2], feature[3]);
}

// Writes empty manifolds for the lanes that do not touch; `apart`: a lower bound of the shapes' distance.
CAIRN_INLINE void clear_manifolds(Manifold* out, mask8 touching, f32x8 apart) {
    static constexpr Manifold empty = {{0.0f, 0.0f, 0.0f},
                                       0,
                                       {{0.0f, 0.0f, 0.0f, unused_separation},
                                        {0.0f, 0.0f, 0.0f, unused_separation},
                                        {0.0f, 0.0f, 0.0f, unused_separation},
                                        {0.0f, 0.0f, 0.0f, unused_separation}},
                                       {0, 0, 0, 0}};
    alignas(32) float separation[8];
    store(separation, apart);
    const int touch = bits(touching);
    for (int i = 0; i < 8; ++i) {
        if ((touch >> i & 1) != 0) continue;
        out[i] = empty;
        out[i].points[0][3] = separation[i];
    }
}

// Writes the manifold of a sphere of the given radius (the first shape), whose surface is `separation` away from the
// other shape's along `normal`. `apart`: a lower bound of the distance where they do not touch.
CAIRN_INLINE void write_sphere_manifolds(Manifold* out, mask8 touching, Vec3x8 normal, f32x8 radius, f32x8 separation,
                                         f32x8 apart) {
    Manifold* lane[8];
    for (int i = 0; i < 8; ++i) lane[i] = out + i;
    const mask8 none = zero() > zero();
    const ContactPointx8 unused = {zero3(), zero(), zero(), none};
    const Vec3x8 middle = (radius + splat(0.5f) * separation) * normal;
    write_manifolds(lane, normal, {{middle, separation, zero(), touching}, unused, unused, unused}, apart);
}

} // namespace cairn::CAIRN_ISA
