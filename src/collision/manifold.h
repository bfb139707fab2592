// The result of one narrow-phase test. Plain data, no functions (see shape_pose.h).
#pragma once

#include <cstdint>

namespace cairn {

// Up to four contact points that share one normal.
struct alignas(32) Manifold {
    float normal[3];    // unit, from the first shape to the second
    std::int32_t count; // 0 if the shapes are farther apart than the margin
    // x y z: the point midway between the two surfaces, relative to the first shape's center, world axes. [3]:
    // separation along the normal in meters, negative if overlapping. Points beyond `count` are {0,0,0,1e30}; but if
    // there are none, [3] of the first is a lower bound of the distance of the shapes, if the test has found one.
    float points[4][4];
    std::uint32_t features[4]; // which features meet; the next step keeps only their lowest bytes (no_features)
};

// Flags in the first point's feature, for pairs of convex shapes that are tested one at a time, and for patches: the
// normal is that of a face of the first shape, or of the second, which is touched there.
inline constexpr std::uint32_t on_first_face = 1u << 30, on_second_face = 1u << 31;
// Flag in the first point's feature: the second shape is a round side with several contact points (flat_side.h).
inline constexpr std::uint32_t on_flat_side = 1u << 29;

// The lowest of the 16 bits in a patch's first feature that hold the material number of its triangles
// (SurfaceMaterials).
inline constexpr int surface_material_bit = 8;

// The kept features of a manifold without points; one byte per point, the first point's lowest.
inline constexpr std::uint32_t no_features = 0xffffffffu;

} // namespace cairn
