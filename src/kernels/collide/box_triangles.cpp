// Separating axis test of the planes of triangles and the faces of a box, four triangles at a time, in the frame of the
// box: which triangles are apart, and which normal gives the greatest separation for the others. In double, so that
// triangles of a kilometer are as precise.
#include "kernels/collide/box_triangles.h"

#include "simd/f64x4.h"

namespace cairn::CAIRN_ISA {

namespace {

// As in collision/convex_contact.cpp: the triangle's face is the reference only where its separation is greater by this
// fraction of the extent.
constexpr double second_face_tolerance = 1e-4;

struct Point4 {
    f64x4 x, y, z;
};
CAIRN_INLINE Point4 operator-(const Point4& a, const Point4& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
CAIRN_INLINE f64x4 dot(const Point4& a, const Point4& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
CAIRN_INLINE Point4 cross(const Point4& a, const Point4& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

CAIRN_INLINE Point4 corner_of(const BoxFrame& box, TriangleBatch& batch, int corner, int first) {
    const auto& v = batch.vertices[corner];
    const f64x4 x = load4(&v[0][first]), y = load4(&v[1][first]), z = load4(&v[2][first]);
    f64x4 at[3];
    for (int i = 0; i < 3; ++i) {
        at[i] = splat4(box.origin[i]) + x * splat4(box.axes[0][i]) + y * splat4(box.axes[1][i]) +
                z * splat4(box.axes[2][i]);
        store4(&batch.corners[corner][i][first], at[i]);
    }
    return {at[0], at[1], at[2]};
}

struct BoxFace4 {
    f64x4 separation, face;
};

// The face of the box along whose normal the separation from the triangle is greatest.
CAIRN_INLINE BoxFace4 best_box_face(const BoxFrame& box, const Point4& a, const Point4& b, const Point4& c) {
    BoxFace4 best = {splat4(-1e300), splat4(0)};
    const auto offer = [&](int axis, f64x4 p, f64x4 q, f64x4 r) {
        const f64x4 above = min(min(p, q), r) - splat4(box.half[axis]);
        const f64x4 below = -max(max(p, q), r) - splat4(box.half[axis]);
        best.face = select(above > best.separation, splat4(2 * axis), best.face);
        best.separation = max(above, best.separation);
        best.face = select(below > best.separation, splat4(2 * axis + 1), best.face);
        best.separation = max(below, best.separation);
    };
    offer(0, a.x, b.x, c.x);
    offer(1, a.y, b.y, c.y);
    offer(2, a.z, b.z, c.z);
    return best;
}

CAIRN_INLINE f64x4 code(TriangleView view) { return splat4(static_cast<double>(view)); }

// Tests four triangles and writes the results to the batch; returns lower bounds of their distances.
CAIRN_INLINE f64x4 classify_four(const BoxFrame& box, TriangleBatch& batch, int first) {
    const Point4 a = corner_of(box, batch, 0, first), b = corner_of(box, batch, 1, first),
                 c = corner_of(box, batch, 2, first);
    const Point4 up = cross(b - a, c - a);
    const f64x4 square = dot(up, up), length = sqrt(square), scale = splat4(1) / length;
    // Multiplied by the length of the normal: the height of the box's center over the plane, and half the size of the
    // box along the normal.
    const f64x4 long_height = -dot(up, a);
    const f64x4 size =
        splat4(box.half[0]) * abs(up.x) + splat4(box.half[1]) * abs(up.y) + splat4(box.half[2]) * abs(up.z);
    const f64x4 height = long_height * scale, along_normal = height - size * scale, below = -height - size * scale;
    const BoxFace4 face = best_box_face(box, a, b, c);

    const f64x4 inset = splat4(box.inset), doubt = splat4(box.slack);
    const mask4 is_box_face = (face.separation > along_normal - inset) &
                              ~(along_normal > face.separation + splat4(second_face_tolerance) * splat4(box.extent));
    const f64x4 least = select(is_box_face, face.separation, along_normal);
    const mask4 is_level = long_height * long_height <= doubt * doubt * square, is_behind = long_height < splat4(0);
    const f64x4 farthest = max(face.separation, along_normal);
    f64x4 view = select(is_box_face, code(TriangleView::on_box), code(TriangleView::on_triangle));
    view = select(least < -inset, code(TriangleView::deep), view);
    view = select(max(least, along_normal) > splat4(box.margin), code(TriangleView::apart), view);
    view = select(is_behind, select(below > doubt, code(TriangleView::apart), code(TriangleView::behind)), view);
    view = select(is_level, code(TriangleView::apart), view);
    view = select(is_level & (face.separation <= splat4(box.margin)), code(TriangleView::level), view);

    store4(&batch.normal[0][first], up.x * scale);
    store4(&batch.normal[1][first], up.y * scale);
    store4(&batch.normal[2][first], up.z * scale);
    store4(&batch.square[first], square);
    store4(&batch.height[first], height);
    store4(&batch.along_normal[first], along_normal);
    store4(&batch.along_box[first], face.separation);
    for (int i = 0; i < 4; ++i) {
        batch.view[first + i] = static_cast<TriangleView>(static_cast<int>(view[i]));
        batch.box_face[first + i] = static_cast<std::uint8_t>(static_cast<int>(face.face[i]));
    }
    return select(is_level, face.separation, select(is_behind, below, farthest));
}

} // namespace

void classify_triangles(const BoxFrame& box, TriangleBatch& batch) {
    f64x4 least = splat4(1e30);
    for (int first = 0; first < batch.count; first += 4) least = min(classify_four(box, batch, first), least);
    batch.distance = min(min(splat4(least[0]), splat4(least[1])), min(splat4(least[2]), splat4(least[3])))[0];
}

} // namespace cairn::CAIRN_ISA
