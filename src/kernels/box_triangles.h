// The kernel for boxes and triangles of one instruction set.
#pragma once

#include "collision/triangle_batch.h"

namespace cairn::CAIRN_ISA {

void see_triangles(const BoxFrame& box, TriangleBatch& batch);

} // namespace cairn::CAIRN_ISA
