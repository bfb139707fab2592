// The broad-phase kernels of one instruction set (see BroadKernels in bvh/tree.h).
#pragma once

#include "bvh/tree.h"

namespace cairn::CAIRN_ISA {

BroadKernels broad_kernels();

} // namespace cairn::CAIRN_ISA
