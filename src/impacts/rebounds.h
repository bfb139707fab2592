// Rebound speeds. Bodies that touch without bouncing are kept apart by successive impacts, between which they sink into
// each other: each impact lets them separate at the speed that brings them back to where they touch.
#pragma once

#include "impacts/movers.h"

#include <span>

namespace cairn {

// A body in contact, and its feature that touches: a point on a rim about `middle` with the unit vector `axis` and the
// radius, or a part of a sphere about `middle`. A corner is a rim with a radius of 0, the side of a cylinder a rim
// whose axis is perpendicular to the normal.
struct TouchingBody {
    const MovingState& now;
    math::DVec3 middle;
    math::DVec3 axis{};
    double radius = 0;         // m
    bool is_flat = false;      // its surface is a face with the normal of the contact
    math::DVec3 pull{};        // m/s^2: acceleration of its center of mass
    math::DVec3 spin_change{}; // rad/s^2
};

// Acceleration (m/s^2) at which two bodies approach along `normal`, from the first to the second, while both move
// freely. Points of a rotating body are accelerated toward its center, w x (w x r), and rims tilt; a rotating face
// moves away from, or follows, a body that slides over it, by 2 normal . (w x slip). Where neither or both of the
// bodies have a face with that normal (crossing edges are partly faces), the greater value is taken.
double closing_acceleration(const TouchingBody& a, const TouchingBody& b, math::DVec3 normal);

// Sets the `rebound` of the points of a pair that has met, from their depth and the acceleration that presses the
// bodies together. The energy added to that of the approach is at most the work of the forces while the bodies sank.
void set_rebounds(const Movers& movers, const Shapes& shapes, const SweptPair& pair, const MovingState& now_a,
                  const MovingState& now_b, std::span<ImpactPoint> points);

} // namespace cairn
