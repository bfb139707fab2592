// Contacts of a sharp box with the front sides of triangles, in the frame of the box: the same results as
// collide_surface with a fraction of its operations. Most triangles of a mesh are either separated from the box or
// touched along a face normal of box or triangle, and some contacts are between crossing edges; all these are handled
// here. The rest, such as deep penetrations, is left to the general convex test.
#pragma once

#include "collision/convex_contact.h"
#include "collision/flat_points.h"
#include "collision/triangle_batch.h"
#include "shapes/mesh.h"

namespace cairn {

// A contact of a box with a triangle, in the frame of the box.
struct BoxHit {
    // At most the ends of four clipped edges and three corners, or of three edges and four corners; only points within
    // the margin.
    SurfacePoint points[11];
    int count = 0;
    math::DVec3 normal;    // from the box to the triangle
    math::DVec3 foot;      // the deepest point, on the triangle
    double separation = 0; // of the deepest point
    bool on_face = false;  // the deepest point is on the triangle's face, not at its edges
};

class BoxOnTriangles {
  public:
    // beyond_faces: collide_surface_beyond must decide; unsure: collide_surface must decide.
    enum class Verdict : std::uint8_t { apart, touching, beyond_faces, unsure };

    // `center` and `axes`: the frame of the triangles, relative to the frame in which the box is given.
    BoxOnTriangles(const TriangleKernels& kernels, const Convex& box, math::DVec3 center, const math::DMat3& axes,
                   double margin);

    // Triangles are added until the batch is full, then classified together by `look`, and tested by `test`.
    static constexpr int most = TriangleBatch::capacity;
    int count() const { return batch_.count; }
    void add(std::uint32_t index) { batch_.index[batch_.count++] = index; }
    // Classifies the batch. Returns a lower bound of the distance of all triangles from the box, or 0.
    // triangle_at(index) is called for all triangles in one loop, because they may be scattered in memory.
    template <class F> double look(F&& triangle_at) {
        for (int i = 0; i < batch_.count; ++i) place(triangle_at(batch_.index[i]), i);
        return look();
    }
    // Calls f(index, verdict, hit) for all triangles that are not separated, with `hit` set for Verdict::touching; then
    // the batch is empty.
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

    // The best face found; valid after Verdict::beyond_faces.
    const FaceReach& best_face() const { return best_face_; }

  private:
    struct Face {
        double separation;
        int axis;    // of the box
        double sign; // 1 or -1: the face's normal points along the axis or against it
    };
    // A separating direction from the box to the triangle.
    struct Axis {
        math::DVec3 normal;
        double separation;
        math::DVec3 touch; // midway between the nearest points of the cores
    };

    // The same values as in convex_contact.cpp.
    static constexpr double second_face_tolerance = 1e-4, rounding = 1e-6, downward = 1e-3;
    // If the cosine between the normals is at least this, the contact is on the face of the triangle, wherever the
    // point is.
    static constexpr double same_direction = 1 - 5e-11;

    struct List {
        int which[most + 3]; // padded to a multiple of four
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
    // Contacts not along a face normal (box_triangle_edges.cpp).
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
    List on_box_, on_triangle_, others_; // indices into the batch, by the test that they need
    FaceTouches touches_;
    const double (&half_)[3];
    const double margin_, slack_, extent_, inset_;
    // State of the triangle being tested.
    int tested_;
    double corners_[3][3], normal_[3]; // the normal is unit
    double along_normal_;              // separation along the triangle's normal
    FaceReach best_face_;
};

} // namespace cairn
