// Contacts between convex shapes of any kind, and between them and planes, rectangles and triangles.
//
// All shapes are given in one frame whose axes are those of the world and whose origin is near the first shape's
// center. Points are made for surfaces up to `margin` apart. `guess`: a direction from the first to the second, such as
// the normal of the last step, or zero.
#pragma once

#include "collision/contact_memory.h"
#include "collision/manifold.h"
#include "shapes/convex.h"

namespace cairn {

// Where there are no points, the normal is a direction along which the shapes are apart. `memory`: of the last test of
// the two, or nothing_met; then of this one.
void collide_convex(const Convex& a, const Convex& b, double margin, math::DVec3 guess, ContactMemory& memory,
                    Manifold& out);

// Against an infinite half-space with the unit normal `up`; the center of `a` is `height` above it.
void collide_plane(const Convex& a, math::DVec3 up, double height, double margin, Manifold& out);

// Where on a one-sided polygon a contact is.
struct SurfaceContact {
    enum class Part : std::uint8_t { face, edge, corner };
    Part part = Part::face;
    int index = 0;          // of the edge (from corner i to the next) or of the corner
    double cosine = 1;      // between the push on the first shape and the normal of the polygon
    bool is_lifted = false; // the middle of the first shape is behind the polygon
};

// Against one side of a triangle or rectangle (Convex::Kind::polygon): it pushes the first shape only along its normal
// or sideways. A shape whose middle is behind it is pushed out along the normal if the middle is over the polygon and a
// part of the shape is in front.
SurfaceContact collide_surface(const Convex& a, const Convex& polygon, double margin, math::DVec3 guess, Manifold& out);

// What is known of the best face of a pair of shapes.
struct FaceReach {
    int face = -1;          // as in Convex; -1: nothing
    bool is_second = false; // of the second shape
    double reached = 0;     // the least separation of the points between the face and what is opposite
};
// Likewise, where the middle of `a` is in front of the polygon and the faces that are met along the normal of the
// polygon are known not to make the contact.
SurfaceContact collide_surface_beyond(const FaceReach& known, const Convex& a, const Convex& polygon, double margin,
                                      math::DVec3 guess, Manifold& out);

// Pushed out along the normal of the polygon, whatever is nearest: by the points over it; where there are none, by the
// middle of the shape.
void collide_lifted(const Convex& a, const Convex& polygon, double margin, Manifold& out);

// Along the normal of the polygon, whatever is nearest: the points over it that are nearer than the margin.
void collide_front(const Convex& a, const Convex& polygon, double margin, Manifold& out);

} // namespace cairn
