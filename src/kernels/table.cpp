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

extern const KernelTable table;
const KernelTable table = {
    CAIRN_STRING(CAIRN_ISA),
    sphere_sphere,
    sphere_box,
    sphere_plane,
    sphere_rectangle,
    sphere_capsule,
    box_box,
    box_plane,
    box_rectangle,
    capsule_capsule,
    box_capsule,
    solver_kernels(),
    joint_kernels(),
    broad_kernels(),
    {see_triangles, touch_on_box, touch_on_triangle},
};

} // namespace cairn::CAIRN_ISA
