// Spheres against spheres, boxes, planes and rectangles, 8 pairs at a time.
#include "kernels/collide/collide.h"
#include "kernels/collide/collide_common.h"

namespace cairn::CAIRN_ISA {

void sphere_sphere(CAIRN_COLLIDE_PARAMETERS) {
    for (int k = 0; k < count; k += 8) {
        const ShapePosex8 a = gather_shapes(poses, first + k), b = gather_shapes(poses, second + k);
        f32x8 distance;
        const Vec3x8 normal = direction(nonzero_center_offset(a, b), splat(no_direction), up(), distance);
        const f32x8 separation = distance - (a.radius + b.radius);
        write_sphere_manifolds(out + k, separation <= load_unaligned(margin + k), normal, a.radius, separation,
                               separation);
    }
}

// The contact is at the closest point of the box. A center inside the box is pushed out through the nearest face (of
// equally near ones through the first of x, y, z; from the exact center along the positive axis).
void sphere_box(CAIRN_COLLIDE_PARAMETERS) {
    for (int k = 0; k < count; k += 8) {
        const ShapePosex8 a = gather_shapes(poses, first + k), b = gather_shapes(poses, second + k);
        const Vec3x8 h = b.size, p = rotate_back(b.q, -nonzero_center_offset(a, b));
        const Vec3x8 closest = {clamp(p.x, -h.x, h.x), clamp(p.y, -h.y, h.y), clamp(p.z, -h.z, h.z)};
        const Vec3x8 outward = p - closest;
        const mask8 outside = dot(outward, outward) > splat(no_direction);

        const f32x8 gx = h.x - abs(p.x), gy = h.y - abs(p.y), gz = h.z - abs(p.z);
        const mask8 by_x = (gx <= gy) & (gx <= gz), by_y = and_not(gy <= gz, by_x);
        const auto toward = [](f32x8 coordinate) { return select(coordinate < zero(), -one(), one()); };
        const Vec3x8 face = {select(by_x, toward(p.x), zero()), select(by_y, toward(p.y), zero()),
                             select(by_x | by_y, zero(), toward(p.z))};
        const f32x8 face_distance = -max(select(by_x, gx, select(by_y, gy, gz)), zero());

        f32x8 distance;
        const Vec3x8 normal = -rotate(b.q, direction(outward, splat(no_direction), face, distance));
        const f32x8 separation = select(outside, distance, face_distance) - a.radius;
        write_sphere_manifolds(out + k, separation <= load_unaligned(margin + k), normal, a.radius, separation,
                               separation);
    }
}

void sphere_plane(CAIRN_COLLIDE_PARAMETERS) {
    for (int k = 0; k < count; k += 8) {
        const ShapePosex8 a = gather_shapes(poses, first + k), b = gather_shapes(poses, second + k);
        const Vec3x8 normal = -rotate(b.q, up());
        const f32x8 separation = dot(normal, offset_between(a, b)) - a.radius;
        write_sphere_manifolds(out + k, separation <= load_unaligned(margin + k), normal, a.radius, separation,
                               separation);
    }
}

// The rectangle is one-sided. A center on or above its plane touches the closest point of the rectangle, edges and
// corners included. A center below the plane is pushed up along the rectangle's normal while it is over the rectangle
// and a part of the sphere is above the plane. Any other sphere below does not touch.
void sphere_rectangle(CAIRN_COLLIDE_PARAMETERS) {
    for (int k = 0; k < count; k += 8) {
        const ShapePosex8 a = gather_shapes(poses, first + k), b = gather_shapes(poses, second + k);
        const f32x8 hx = b.size.x, hz = b.size.z;
        const Vec3x8 p = rotate_back(b.q, -offset_between(a, b));
        const mask8 above = p.y >= zero();
        const mask8 sunk = (abs(p.x) < hx) & (abs(p.z) < hz) & (-p.y < a.radius);
        const Vec3x8 outward = {p.x - clamp(p.x, -hx, hx), p.y, p.z - clamp(p.z, -hz, hz)};
        f32x8 distance;
        const Vec3x8 away = direction(outward, splat(no_direction), up(), distance);
        const Vec3x8 normal = -rotate(b.q, select(above, away, up()));
        const f32x8 separation = select(above, distance, p.y) - a.radius;
        const mask8 touching = (above | sunk) & (separation <= load_unaligned(margin + k));
        write_sphere_manifolds(out + k, touching, normal, a.radius, separation,
                               select(above, separation, splat(unused_separation)));
    }
}

} // namespace cairn::CAIRN_ISA
