// The kernel table of one instruction set.
#include "kernels/broad/broad.h"
#include "kernels/collide/box_triangles.h"
#include "kernels/collide/collide.h"
#include "kernels/kernels.h"
#include "kernels/solve/joint.h"
#include "kernels/solve/solver.h"

namespace cairn::CAIRN_ISA {

#define CAIRN_STRING2(text) #text
#define CAIRN_STRING(text) CAIRN_STRING2(text)

#define CAIRN_COLLIDE_KERNEL(first, second) .first##_##second = first##_##second,

extern const KernelTable table;
const KernelTable table = {
    .name = CAIRN_STRING(CAIRN_ISA),
    .solver = solver_kernels(),
    .joints = joint_kernels(),
    .broad = broad_kernels(),
    .triangles = {classify_triangles, touch_on_box, touch_on_triangle},
    CAIRN_WIDE_PAIRS(CAIRN_COLLIDE_KERNEL) // designated by name, so that no kernel can take another's place
};

} // namespace cairn::CAIRN_ISA
