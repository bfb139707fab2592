// A sharp box against the front of triangles, in the frame of the box: what collide_surface would say, with a fraction
// of its operations. Most triangles of a mesh are apart from the box, or are touched along the normal of a face of one
// of the two; some where edges cross, and this tells so too; what remains, such as boxes that are sunk in, is left to
// the test of all convex shapes.
#pragma once

#include "collision/convex_contact.h"
#include "collision/triangle_batch.h"
#include "shapes/mesh.h"

namespace cairn {

// Where a box touches a triangle, in the frame of the box.
struct BoxHit {
    struct Point {
        math::DVec3 position; // midway between the surfaces
        double separation;
    };
    // The ends of four cut edges and three corners, or of three edges and four corners; those within the margin.
    Point points[11];
    int count = 0;
    math::DVec3 normal;    // from the box to the triangle
    math::DVec3 foot;      // of the deepest point: where the triangle is
    double separation = 0; // of the deepest point
    bool on_face = false;  // of the triangle: the deepest point is not at its edges
};

class BoxOnTriangles {
  public:
    // beyond_faces: for collide_surface_beyond; unsure: for collide_surface.
    enum class Verdict : std::uint8_t { apart, touching, beyond_faces, unsure };

    // The frame of the triangles, in that in which the box is given.
    BoxOnTriangles(const Convex& box, math::DVec3 center, const math::DMat3& axes, double margin);

    // Triangles are taken in until there are so many, looked at together, and then tested one by one.
    static constexpr int most = TriangleBatch::capacity;
    int count() const { return batch_.count; }
    void add(const Triangle& triangle, std::uint32_t index);
    std::uint32_t index(int i) const { return batch_.index[i]; }
    // Returns how far all are apart from the box at least, where that is more than nothing.
    double look();
    // Writes `hit` where they touch.
    Verdict test(int i, BoxHit& hit);
    void clear() { batch_.count = 0; }

    // After beyond_faces.
    const FaceReach& best_face() const { return best_face_; }

  private:
    struct Face {
        double separation;
        int axis;    // of the box
        double sign; // 1 or -1: the face that looks along the axis or against it
    };
    // A direction from the box to the triangle.
    struct Axis {
        math::DVec3 normal;
        double separation;
        math::DVec3 touch; // midway between the nearest points of the cores
    };

    // As in convex_contact.cpp.
    static constexpr double second_face_tolerance = 1e-4, rounding = 1e-6, downward = 1e-3;
    // At a cosine this near to 1 a contact is on the face of the triangle wherever it is.
    static constexpr double same_direction = 1 - 1e-6;

    void take(int i);
    bool pushes_down(const BoxHit& hit) const { return math::dot(hit.normal, up()) > downward; }
    bool is_beside() const;
    bool border_is_near() const;
    void find_borders();
    double on_triangle(BoxHit& hit) const;
    double on_box(const Face& face, BoxHit& hit) const;
    void choose_deepest(const Face& face, double reached, BoxHit& hit) const;
    bool is_inside(math::DVec3 foot) const;
    void add(BoxHit& hit, const double (&position)[3], double separation) const;

    // Beyond faces (box_triangle_edges.cpp).
    math::DVec3 corner(int i) const { return {corners_[i][0], corners_[i][1], corners_[i][2]}; }
    math::DVec3 up() const { return {normal_[0], normal_[1], normal_[2]}; }
    math::DVec3 half() const { return {half_[0], half_[1], half_[2]}; }
    Verdict beyond_faces(const Face& box_face, BoxHit& hit);
    bool find_axis(double inset, Axis& axis) const;
    bool touches_face(const Face& face, bool is_triangle, double least, BoxHit& hit);
    Verdict on_edges(const Axis& axis, BoxHit& hit) const;
    FaceReach reach_of(const Face& box_face, bool is_triangle, double reached) const {
        return {is_triangle ? 0 : 2 * box_face.axis + (box_face.sign < 0 ? 1 : 0), is_triangle, reached};
    }

    BoxFrame frame_;
    TriangleBatch batch_;
    const double (&half_)[3];
    const double margin_, slack_, extent_, inset_;
    // Of the triangle that is tested.
    double corners_[3][3], normal_[3]; // the normal is unit
    double square_, height_;           // of the normal as a product of edges; of the box's middle over the triangle
    double along_normal_;              // how far they are apart
    FaceReach best_face_;
    double inward_[3][3], lengths_[3]; // across the edges, as long as they are; and their lengths
};

} // namespace cairn
