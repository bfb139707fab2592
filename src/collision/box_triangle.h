// A sharp box against the front of triangles, in the frame of the box: what collide_surface would say, with a fraction
// of its operations. Most triangles of a mesh are apart from the box, or are touched along the normal of a face of one
// of the two, and this tells so; what remains, such as edges that cross, is left to the test of all convex shapes.
#pragma once

#include "collision/convex_contact.h"
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

    // Writes `hit` where they touch.
    Verdict test(const Triangle& triangle, BoxHit& hit);
    // After beyond_faces.
    const FaceReach& best_face() const { return best_face_; }

  private:
    struct Face {
        double separation;
        int axis;    // of the box
        double sign; // 1 or -1: the face that looks along the axis or against it
    };

    void to_box(math::Vec3 vertex, double (&out)[3]) const;
    bool is_beside() const;
    bool border_is_near() const;
    Face best_box_face() const;
    void find_borders();
    double on_triangle(BoxHit& hit) const;
    double on_box(const Face& face, BoxHit& hit) const;
    void choose_deepest(const Face& face, double reached, BoxHit& hit) const;
    bool is_inside(math::DVec3 foot) const;
    void add(BoxHit& hit, const double (&position)[3], double separation) const;

    double half_[3];                   // of the box
    double origin_[3], axes_[3][3];    // of the triangles' frame, as the box sees it
    double margin_, slack_;            // slack: what rounding may do
    double extent_, inset_;            // as in Convex
    double corners_[3][3], normal_[3]; // of the triangle; the normal has any length until the triangle is near
    double square_, height_;           // of the normal; of the box's middle over the triangle
    FaceReach best_face_;
    double inward_[3][3], lengths_[3]; // across the edges, as long as they are; and their lengths
};

} // namespace cairn
