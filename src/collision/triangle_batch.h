// A batch of triangles near a box in SIMD layout, as the kernel that classifies them reads and writes it. Plain data,
// no functions (see shape_pose.h).
#pragma once

#include <cstdint>

namespace cairn {

// A sharp box, and the frame of the triangles relative to it.
struct BoxFrame {
    double half[3];
    double origin[3], axes[3][3]; // of the triangles' frame
    double margin, slack;         // slack: tolerance for rounding errors
    double extent, inset;         // as in Convex
};

// How a triangle must be treated after the classification.
enum class TriangleView : std::uint8_t {
    apart,       // separated: nothing to do
    behind,      // the center of the box is behind the triangle
    level,       // the center of the box is too near to the triangle's plane to tell the side
    on_box,      // they may touch at the face of the box
    on_triangle, // they may touch at the face of the triangle
    deep,        // they overlap more deeply than faces can decide
};

struct TriangleBatch {
    static constexpr int capacity = 64; // a multiple of four

    int count;
    float vertices[3][3][capacity]; // by corner and axis, in the triangles' frame; counterclockwise from outside
    std::uint32_t index[capacity];

    // In the frame of the box:
    double corners[3][3][capacity];
    double normal[3][capacity];                         // unit
    double square[capacity];                            // squared length of the normal as a cross product of two edges
    double height[capacity];                            // of the center of the box above the triangle's plane
    double along_normal[capacity], along_box[capacity]; // separation along the normal, and along the box's axes
    std::uint8_t box_face[capacity];                    // the box's face towards the triangle, as in Convex
    TriangleView view[capacity];
    double distance; // a lower bound of the distance of all triangles
};

// The contact points of four triangles with a face of the box or with their own face, whichever was chosen.
struct FaceTouches {
    static constexpr int max_points = 11; // ends of four clipped edges and three corners, or of three and four

    // Axes are numbered from that of the box's face, or from that along which the triangle's normal is greatest.
    int axis[4];
    double position[max_points][3][4]; // midway between the surfaces
    double separation[max_points][4];
    std::int64_t present[4]; // a bit per point: those within the margin
    double reached[4];       // the least separation of all points
    std::int64_t deepest[4]; // index of the deepest point; only for the box's face
    std::int64_t on_face[4]; // the deepest point is not at the triangle's edges; only for the box's face
};

struct TriangleKernels {
    // Classifies triangles and a box by their faces alone.
    void (*see)(const BoxFrame& box, TriangleBatch& batch);
    // Contact points of four triangles of the batch with the face of the box that faces them, or of the box with their
    // faces.
    void (*touch_on_box)(const BoxFrame& box, const TriangleBatch& batch, const int* which, FaceTouches& out);
    void (*touch_on_triangle)(const BoxFrame& box, const TriangleBatch& batch, const int* which, FaceTouches& out);
};

} // namespace cairn
