// Triangles near a box, side by side, as the kernel that looks at them reads and writes them. Plain data, no functions
// (see shape_pose.h).
#pragma once

#include <cstdint>

namespace cairn {

// A sharp box, and the frame of the triangles as it sees it.
struct BoxFrame {
    double half[3];
    double origin[3], axes[3][3]; // of the triangles' frame
    double margin, slack;         // slack: what rounding may do
    double extent, inset;         // as in Convex
};

// What is to be done with a triangle after all have been looked at.
enum class TriangleView : std::uint8_t {
    apart,       // nothing
    behind,      // the middle of the box is behind it
    level,       // too near its plane to tell on which side
    on_box,      // the face of the box is where they may touch
    on_triangle, // its own is
    deep,        // they overlap by more than faces tell of
};

struct TriangleBatch {
    static constexpr int capacity = 64; // a multiple of four

    int count;
    float vertices[3][3][capacity]; // by corner and axis, in the triangles' frame; counterclockwise from outside
    std::uint32_t index[capacity];

    // In the frame of the box.
    double corners[3][3][capacity];
    double normal[3][capacity]; // unit
    double square[capacity];    // of the length that the normal had as a cross product of two edges
    double height[capacity];    // of the middle of the box over the plane
    double along_normal[capacity], along_box[capacity]; // how far apart they are along it, and along the box's axes
    std::uint8_t box_face[capacity];                    // that looks at it, as in Convex
    TriangleView view[capacity];
    double distance; // that all are apart at least
};

} // namespace cairn
