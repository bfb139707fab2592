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

// The face of the box or of the triangle along whose normal four triangles may touch, and the points where they do.
struct FaceTouches {
    static constexpr int max_points = 11; // the ends of four cut edges and three corners, or of three and four

    // Axes are numbered from that of the face of the box, or from that along which the triangle's normal is greatest.
    int axis[4];
    double position[max_points][3][4]; // midway between the surfaces
    double separation[max_points][4];
    std::int64_t present[4]; // a bit for each point: those within the margin
    double reached[4];       // the least separation of all points
    std::int64_t deepest[4]; // which one that is; of the box's face
    std::int64_t on_face[4]; // likewise: it is not at the edges of the triangle
};

struct TriangleKernels {
    // What can be said of triangles and a box by their faces alone.
    void (*see)(const BoxFrame& box, TriangleBatch& batch);
    // Where four triangles of the batch touch the face of the box that looks at them, or the box their own.
    void (*touch_on_box)(const BoxFrame& box, const TriangleBatch& batch, const int* which, FaceTouches& out);
    void (*touch_on_triangle)(const BoxFrame& box, const TriangleBatch& batch, const int* which, FaceTouches& out);
};

} // namespace cairn
