// What is known of a shape: its geometry and pose, its body, and with whom it makes contacts.
#pragma once

#include "collision/shape_pose.h"
#include "core/slot_pool.h"
#include "math/vec.h"
#include "shapes/geometry.h"
#include "state/none.h"

#include <cairn/world.h>

#include <cstdint>
#include <vector>

namespace cairn {

struct alignas(32) ShapeLinks {
    std::int32_t body = none, next = none, previous = none; // the shapes of a body, in order of creation
    float density = 0;
    math::Vec3 arm; // from the body's center of mass to the shape's origin, world axes
    std::uint32_t padding = 0;
};

// What decides with whom a shape makes contacts.
struct ShapeTraits {
    CollisionFilter filter;
    math::Vec3 surface_velocity; // in the frame of its geometry, m/s
    math::Vec3 one_way;          // likewise, the direction from where it holds things; zero: from all
    std::uint8_t is_trigger = 0;
    std::uint8_t has_surface_velocity = 0;
    std::uint8_t is_one_way = 0;
    std::uint8_t padding[5] = {};
};
inline bool may_meet(const CollisionFilter& a, const CollisionFilter& b) {
    return (a.layers & b.collides_with) != 0 && (b.layers & a.collides_with) != 0;
}

// All shapes; vectors are by shape.
struct Shapes {
    SlotPool<ShapeId> slots;
    std::vector<Geometry> geometry;
    std::vector<ShapeData> data;
    std::vector<ShapePose> poses;
    std::vector<ShapeLinks> links;
    std::vector<Material> materials;
    std::vector<ShapeTraits> traits;
    std::vector<std::uint32_t> dead; // those that are recycled after the broad phase's update
};

} // namespace cairn
