// The state of shapes: geometry and pose, their body, and what decides about their contacts.
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
    std::int32_t body = none, next = none, previous = none; // the list of the shapes of a body, in order of creation
    float density = 0;
    math::Vec3 arm; // from the body's center of mass to the shape's origin, world axes
    std::uint32_t padding = 0;
};

// Decides which shapes a shape makes contacts with.
struct ShapeTraits {
    CollisionFilter filter;
    math::Vec3 surface_velocity; // m/s, in the frame of the geometry
    math::Vec3 one_way;          // the side from which it is solid, in the frame of the geometry; zero: all sides
    std::uint8_t is_trigger = 0;
    std::uint8_t has_surface_velocity = 0;
    std::uint8_t is_one_way = 0;
    std::uint8_t padding[5] = {};
};
inline bool may_meet(const CollisionFilter& a, const CollisionFilter& b) {
    return (a.layers & b.collides_with) != 0 && (b.layers & a.collides_with) != 0;
}

// All shapes. Vectors are indexed by shape.
struct Shapes {
    SlotPool<ShapeId> slots;
    std::vector<Geometry> geometry;
    std::vector<ShapeData> data;
    std::vector<ShapePose> poses;
    std::vector<ShapeLinks> links;
    std::vector<Material> materials;
    std::vector<ShapeTraits> traits;
    std::vector<std::uint32_t> dead; // shapes whose slots are recycled after the broad phase's update
};

} // namespace cairn
