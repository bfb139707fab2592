// The face, edge or point of a convex shape that supports a direction, and the contact points of two of them.
#pragma once

#include "collision/contact_points.h"
#include "shapes/convex.h"

namespace cairn {

struct Feature {
    enum class Kind : std::uint8_t { point, segment, polygon, disc };
    Kind kind = Kind::point;
    std::uint32_t index = 0;        // number among its kind
    Buffer<math::DVec3, 16> points; // on the surface of the shape; polygons counterclockwise as seen from outside
    math::DVec3 normal;             // of a polygon or disc, unit, outward
    math::DVec3 center, u, v;       // of a disc: its center and two unit vectors in its plane
    double radius = 0;
};

// A face as a polygon or disc.
void face_feature(const Convex& c, int face, Feature& out);
// The face, edge or side line opposite a face with the normal -n. `vertex`: the vertex of a hull that is farthest along
// n, or unknown_vertex.
void incident_feature(const Convex& c, const math::DVec3& n, int vertex, Feature& out);
// The edge or side line perpendicular to n, if there is one within a cosine of 0.01, else the farthest point along n.
void edge_feature(const Convex& c, math::DVec3 n, Feature& out);

struct FaceOutline;

// Contact points between a reference face and an incident feature, with separations along the outward normal of the
// reference face. Points outside the face by less than 1e-4 of its size count as over it. `out` is empty before.
// For incident features that are not discs:
void outline_points(const FaceOutline& reference, const Feature& incident, ContactPoints& out);
// If at least one of the two is a disc:
void disc_points(const Feature& reference, const Feature& incident, double extent, ContactPoints& out);
// A square in the plane below a disc, through a point and with the given normal: contact points of the rim with a plane
// are then found as with a face.
void square_under(const Feature& disc, const math::DVec3& point, const math::DVec3& up, Feature& out);

// A segment, or a point if `way` is 0.
struct EdgeLine {
    math::DVec3 from, way;
};
struct EdgePoints {
    struct Point {
        math::DVec3 position; // midway between the segments
        double separation;
    };
    Point points[2];
    int count = 0;
    double sideways = 0;   // lateral distance between the two nearest points, if there is only one contact point
    bool is_cross = false; // both nearest points are between the ends of their segments
};
// One or two contact points of two segments or points, `separation` apart along n (from the first to the second); if
// there are two, each has the separation of the segments there.
EdgePoints edge_points(const EdgeLine& first, const EdgeLine& second, math::DVec3 n, double separation);
// The same for two features.
EdgePoints edge_points(const Feature& first, const Feature& second, math::DVec3 n, double separation,
                       ContactPoints& out);

} // namespace cairn
