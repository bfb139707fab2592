// The table of wide kernels. Each kernel source is compiled once per instruction set; the table of the best
// set that the machine has (or that CAIRN_ISA names) is picked once, at start-up.
// Kernel translation units include only simd/ and plain-data headers, so that no code compiled for one
// instruction set leaks into another through shared inline functions.
#pragma once

#include "bvh/tree.h"
#include "collision/manifold.h"
#include "collision/shape_pose.h"
#include "collision/triangle_batch.h"
#include "collision/wide_pairs.h"
#include "kernels/solve/joint_data.h"
#include "kernels/solve/solver_data.h"

#include <cstdint>

namespace cairn {

// Tests `count` pairs (a multiple of 8; pad by repeating any valid pair) of the shapes poses[first[i]] and
// poses[second[i]], and writes out[i]. Contact points are generated up to a separation of margin[i] meters. kept[i],
// used by box_box only: the features of the last step (see ContactRecord), which are preferred; null: none.
using CollideKernel = void (*)(const ShapePose* poses, const std::uint32_t* first, const std::uint32_t* second,
                               const float* margin, const std::uint32_t* kept, int count, Manifold* out);

struct KernelTable {
    const char* name; // "avx512", "avx2", "sse2", "neon", "simd128", "scalar"

    SolverKernels solver;
    JointKernels joints;
    BroadKernels broad;
    TriangleKernels triangles;

    // Named after the types of the first and the second shape. Planes are infinite, rectangles finite; capsules have
    // ends of equal radius.
#define CAIRN_COLLIDE_KERNEL(first, second) CollideKernel first##_##second;
    CAIRN_WIDE_PAIRS(CAIRN_COLLIDE_KERNEL)
#undef CAIRN_COLLIDE_KERNEL
};

// The chosen table.
const KernelTable& kernels() noexcept;

// The table of a named instruction set, or null when this build or this machine does not have it.
const KernelTable* kernels_named(const char* name) noexcept;

} // namespace cairn
