// The pairs of shape types that have wide kernels, listed once: PairKind, KernelTable, the tables that fill it and the
// tests of the narrow phase are all generated from this list, in this order. Plain data, also for kernel translation
// units.
#pragma once

// X(type of the kernel's first shape, type of its second), as ShapeTypes; the kernel is named first_second. Pairs with
// a single contact point come first.
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
