// The kernels for boxes and triangles of one instruction set.
#pragma once

#include "collision/triangle_batch.h"

namespace cairn::CAIRN_ISA {

void classify_triangles(const BoxFrame& box, TriangleBatch& batch);
void touch_on_box(const BoxFrame& box, const TriangleBatch& batch, const int* which, FaceTouches& out);
void touch_on_triangle(const BoxFrame& box, const TriangleBatch& batch, const int* which, FaceTouches& out);

} // namespace cairn::CAIRN_ISA
