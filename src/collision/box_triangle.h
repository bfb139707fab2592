// A sharp box against the front of triangles, in the frame of the box: what collide_surface would say, with a fraction
// of its operations. Most triangles of a mesh are apart from the box, or are touched along the normal of a face of one
// of the two; some where edges cross, and this tells so too; what remains, such as boxes that are sunk in, is left to
// the test of all convex shapes.
#pragma once

#include "collision/convex_contact.h"
#include "collision/flat_points.h"
#include "collision/triangle_batch.h"
#include "shapes/mesh.h"

namespace cairn {

// Where a box touches a triangle, in the frame of the box.
struct BoxHit {
    // The ends of four cut edges and three corners, or of three edges and four corners; those within the margin.
    SurfacePoint points[11];
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
    BoxOnTriangles(const TriangleKernels& kernels, const Convex& box, math::DVec3 center, const math::DMat3& axes,
                   double margin);

    // Triangles are taken in until there are so many, looked at together, and then tested.
    static constexpr int most = TriangleBatch::capacity;
    int count() const { return batch_.count; }
    void add(std::uint32_t index) { batch_.index[batch_.count++] = index; }
    // Returns how far all are apart from the box at least, where that is more than nothing. triangle_at(index): they
    // are read all together, as they may lie anywhere in memory.
    template <class F> double look(F&& triangle_at) {
        for (int i = 0; i < batch_.count; ++i) place(triangle_at(batch_.index[i]), i);
        return look();
    }
    // f(index, verdict, hit) for all that are not apart; there is a hit where they touch. They are gone then.
    template <class F> void test(F&& f) {
        BoxHit hit;
        const auto tell = [&](int i, Verdict verdict) {
            if (verdict != Verdict::apart) f(batch_.index[i], verdict, hit);
        };
        for (const bool is_triangle : {false, true}) {
            const List& list = is_triangle ? on_triangle_ : on_box_;
            for (int first = 0; first < list.count; first += 4) {
                touch(is_triangle, list.which + first, touches_);
                for (int lane = 0; lane < 4 && first + lane < list.count; ++lane)
                    tell(list.which[first + lane], on_face(is_triangle, list.which[first + lane], lane, hit));
            }
        }
        for (int k = 0; k < others_.count; ++k) tell(others_.which[k], on_no_face(others_.which[k], hit));
        batch_.count = 0;
    }

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
    static constexpr double same_direction = 1 - 5e-11;

    struct List {
        int which[most + 3]; // filled up to a multiple of four
        int count = 0;
    };

    void place(const Triangle& triangle, int i);
    double look();
    void take(int i);
    void touch(bool is_triangle, const int* which, FaceTouches& out) const;
    Verdict on_face(bool is_triangle, int i, int lane, BoxHit& hit);
    Verdict on_no_face(int i, BoxHit& hit);
    void write(const FaceTouches& touches, bool is_triangle, int i, int lane, BoxHit& hit) const;
    Face box_face(int i) const {
        return {batch_.along_box[i], batch_.box_face[i] / 2, batch_.box_face[i] % 2 == 0 ? 1.0 : -1.0};
    }
    bool pushes_down(const BoxHit& hit) const { return math::dot(hit.normal, up()) > downward; }
    bool is_beside() const;
    bool border_is_near() const;
    // Beyond faces (box_triangle_edges.cpp).
    math::DVec3 corner(int i) const { return {corners_[i][0], corners_[i][1], corners_[i][2]}; }
    math::DVec3 up() const { return {normal_[0], normal_[1], normal_[2]}; }
    math::DVec3 half() const { return {half_[0], half_[1], half_[2]}; }
    bool is_inside(math::DVec3 foot) const;
    bool is_on_face(const BoxHit& hit) const {
        return -math::dot(hit.normal, up()) >= same_direction || is_inside(hit.foot);
    }
    Verdict beyond_faces(BoxHit& hit);
    bool find_axis(double inset, Axis& axis) const;
    bool touches_face(bool is_triangle, double least, BoxHit& hit);
    Verdict on_edges(const Axis& axis, BoxHit& hit) const;
    FaceReach reach_of(bool is_triangle, double reached) const {
        return {is_triangle ? 0 : int(batch_.box_face[tested_]), is_triangle, reached};
    }

    const TriangleKernels& kernels_;
    BoxFrame frame_;
    TriangleBatch batch_;
    List on_box_, on_triangle_, others_; // of the batch, by what is to be done with them
    FaceTouches touches_;
    const double (&half_)[3];
    const double margin_, slack_, extent_, inset_;
    // Of the triangle that is tested.
    int tested_;
    double corners_[3][3], normal_[3]; // the normal is unit
    double along_normal_;              // how far they are apart
    FaceReach best_face_;
};

} // namespace cairn
