// Contacts between convex shapes of any kind, and between them and planes, rectangles and triangles.
//
// All shapes are given in a common frame with the axes of the world and an origin near the first shape's center.
// Contact points have separations up to `margin`. `guess`: a direction from the first shape to the second, such as the
// normal of the last step, or zero.
#pragma once

#include "collision/contact_memory.h"
#include "collision/manifold.h"
#include "shapes/convex.h"

namespace cairn {

// A manifold without points has a normal along which the shapes are separated. `memory`: from the last test of the two
// shapes, or nothing_met; replaced by that of this test.
void collide_convex(const Convex& a, const Convex& b, double margin, math::DVec3 guess, ContactMemory& memory,
                    Manifold& out);

// Contacts with an infinite half-space with the unit normal `up`; the center of `a` is `height` above it.
void collide_plane(const Convex& a, math::DVec3 up, double height, double margin, Manifold& out);

// The place of a contact on a one-sided polygon.
struct SurfaceContact {
    enum class Part : std::uint8_t { face, edge, corner };
    Part part = Part::face;
    int index = 0;          // of the edge (from corner i to the next) or the corner
    double cosine = 1;      // between the push on the first shape and the polygon's normal
    bool is_lifted = false; // the center of the first shape is behind the polygon
};

// Contacts with one side of a triangle or rectangle (Convex::Kind::polygon): it pushes the first shape only along its
// normal or sideways. A shape whose center is behind the polygon is pushed out along the normal if the center is over
// the polygon and a part of the shape is in front.
SurfaceContact collide_surface(const Convex& a, const Convex& polygon, double margin, math::DVec3 guess, Manifold& out);

// Knowledge about the best face of a pair of shapes.
struct FaceReach {
    int face = -1;          // number as in Convex; -1: nothing known
    bool is_second = false; // the face is the second shape's
    double reached = 0;     // the least separation of the points between this face and the opposite feature
};
// collide_surface for the case that the center of `a` is in front of the polygon, and that the faces that meet along
// the polygon's normal are known not to give the contact.
SurfaceContact collide_surface_beyond(const FaceReach& known, const Convex& a, const Convex& polygon, double margin,
                                      math::DVec3 guess, Manifold& out);

// Pushes the shape out along the polygon's normal, whatever is nearest: by the points over the polygon; if there are
// none, by the center of the shape.
void collide_lifted(const Convex& a, const Convex& polygon, double margin, Manifold& out);

// Contacts along the polygon's normal, whatever is nearest: the points over it with separations up to the margin.
void collide_front(const Convex& a, const Convex& polygon, double margin, Manifold& out);

} // namespace cairn
