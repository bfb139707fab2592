// The result of one narrow-phase test. Plain data, no functions (see shape_pose.h).
#pragma once

#include <cstdint>

namespace cairn {

// Up to four contact points that share one normal.
struct alignas(32) Manifold {
    float normal[3];    // unit, from the first shape to the second
    std::int32_t count; // 0 when the shapes are further apart than the margin
    // x y z: the point midway between the two surfaces, relative to the first shape's center, world axes.
    // [3]: separation along the normal in meters, negative when overlapping. Points beyond `count` are {0,0,0,1e30};
    // but where there are none, [3] of the first is how far apart the shapes are at least, if the test has found that.
    float points[4][4];
    std::uint32_t features[4]; // which features meet; their lowest bytes are what the next step knows (no_features)
};

// Beside the feature of the first point, of pairs of convex shapes that are tested one at a time, and of patches:
// whether the normal is that of a face of the first shape, or of the second, which is touched there.
inline constexpr std::uint32_t on_first_face = 1u << 30, on_second_face = 1u << 31;
// Likewise: whether the second is a round side that has several places of touch (flat_side.h).
inline constexpr std::uint32_t on_flat_side = 1u << 29;

// Likewise, of patches: the number of the material of their triangles (SurfaceMaterials), in 16 bits from this one on.
inline constexpr int surface_material_bit = 8;

// The features of no point, as they are kept for the next step: a byte of each point, the first point's lowest.
inline constexpr std::uint32_t no_features = 0xffffffffu;

} // namespace cairn
