// The pairs of shapes that have wide kernels, listed once: PairKind, KernelTable, the tables that fill it and the tests
// of the narrow phase are all made from this, in this order. Plain data, for kernel translation units too.
#pragma once

// X(type of the kernel's first shape, type of its second): ShapeTypes; the kernel is named first_second. Those that
// make one point come first, see has_one_point.
#define CAIRN_WIDE_PAIRS(X)                                                                                            \
    X(sphere, sphere)                                                                                                  \
    X(sphere, box)                                                                                                     \
    X(sphere, plane)                                                                                                   \
    X(sphere, rectangle)                                                                                               \
    X(sphere, capsule)                                                                                                 \
    X(box, box)                                                                                                        \
    X(box, plane)                                                                                                      \
    X(box, rectangle)                                                                                                  \
    X(capsule, capsule)                                                                                                \
    X(box, capsule)
