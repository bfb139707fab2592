// The narrow-phase kernels of one instruction set (see CollideKernel in kernels.h).
#pragma once

#include "collision/manifold.h"
#include "collision/shape_pose.h"

#include <cstdint>

namespace cairn::CAIRN_ISA {

#define CAIRN_COLLIDE_PARAMETERS                                                                                       \
    const ShapePose *poses, const std::uint32_t *first, const std::uint32_t *second, const float *margin,              \
        [[maybe_unused]] const std::uint32_t *kept, int count, Manifold *out

void sphere_sphere(CAIRN_COLLIDE_PARAMETERS);
void sphere_box(CAIRN_COLLIDE_PARAMETERS);
void sphere_plane(CAIRN_COLLIDE_PARAMETERS);
void sphere_rectangle(CAIRN_COLLIDE_PARAMETERS);
void sphere_capsule(CAIRN_COLLIDE_PARAMETERS);
void box_box(CAIRN_COLLIDE_PARAMETERS);
void box_plane(CAIRN_COLLIDE_PARAMETERS);
void box_rectangle(CAIRN_COLLIDE_PARAMETERS);
void capsule_capsule(CAIRN_COLLIDE_PARAMETERS);
void box_capsule(CAIRN_COLLIDE_PARAMETERS);

} // namespace cairn::CAIRN_ISA
