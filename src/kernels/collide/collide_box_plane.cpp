// Box against an infinite plane, 8 pairs at a time. The contact points are, of the eight corners within the margin, the
// deepest and up to three with the widest spread.
#include "kernels/collide/collide.h"
#include "kernels/collide/face_clip.h"

namespace cairn::CAIRN_ISA {

void box_plane(CAIRN_COLLIDE_PARAMETERS) {
    for (int k = 0; k < count; k += 8) {
        const ShapePosex8 a = gather_shapes(poses, first + k), b = gather_shapes(poses, second + k);
        const Mat3x8 box = to_matrix(a.q), plane = to_matrix(b.q);
        const Vec3x8 up = plane.c1;
        const f32x8 height = -dot(up, offset_between(a, b)), limit = load_unaligned(margin + k);
        // Half axes in the plane's frame, the most vertical one first: the lower face's corners then come before the
        // upper face's, which are above them when a thin box rests on the plane.
        const auto to_frame = [&](f32x8 h, Vec3x8 axis) {
            return h * Vec3x8{dot(axis, plane.c0), dot(axis, plane.c2), dot(axis, up)};
        };
        Vec3x8 u = to_frame(a.size.x, box.c0), v = to_frame(a.size.y, box.c1), w = to_frame(a.size.z, box.c2);
        const f32x8 ux = abs(dot(box.c0, up)), uy = abs(dot(box.c1, up)), uz = abs(dot(box.c2, up));
        const mask8 x_up = (ux >= uy) & (ux >= uz), y_up = and_not(uy >= uz, x_up);
        const Vec3x8 vertical = select(x_up, u, select(y_up, v, w));
        const Vec3x8 s = select(vertical.z < zero(), -vertical, vertical);
        const Vec3x8 e1 = select(x_up, v, select(y_up, w, u)), e2 = select(x_up, w, select(y_up, u, v));

        CandidatePoints<8> corners;
        for (int i = 0; i < 8; ++i) {
            const Vec3x8 c = (i < 4 ? -s : s) + ((i & 1) != 0 ? e1 : -e1) + ((i & 2) != 0 ? e2 : -e2);
            corners.x[i] = c.x;
            corners.y[i] = c.y;
            corners.z[i] = height + c.z;
            corners.valid[i] = corners.z[i] <= limit;
        }
        const f32x8 smallest = min(min(a.size.x, a.size.y), a.size.z);
        const f32x8 error = splat(5e-7f) * (a.size.x + a.size.y + a.size.z);
        const ReducedPoints points =
            reduce(corners, splat(same_point) * smallest + error, splat(flat_contact) * smallest);
        ContactPointx8 contact[4];
        for (int i = 0; i < 4; ++i) {
            const f32x8 middle = splat(0.5f) * points.z[i] - height;
            contact[i].position = points.x[i] * plane.c0 + points.y[i] * plane.c2 + middle * up;
            contact[i].separation = points.z[i];
            contact[i].feature = points.index[i] + splat(8388608.0f); // the index as mantissa bits of 2^23
            contact[i].present = points.present[i];
        }
        Manifold* lane[8];
        for (int i = 0; i < 8; ++i) lane[i] = out + k + i;
        write_manifolds(lane, -up, contact);
    }
}

} // namespace cairn::CAIRN_ISA
