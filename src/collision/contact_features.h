// The face, edge or point of a convex shape that looks along a direction, and where two of them meet.
#pragma once

#include "collision/contact_points.h"
#include "shapes/convex.h"

namespace cairn {

struct Feature {
    enum class Kind : std::uint8_t { point, segment, polygon, disc };
    Kind kind = Kind::point;
    std::uint32_t index = 0;        // which of its kind
    Buffer<math::DVec3, 16> points; // on the surface of the shape; of a polygon counterclockwise as seen from outside
    math::DVec3 normal;             // of a polygon or disc: unit, outward
    math::DVec3 center, u, v;       // of a disc, and directions that span it
    double radius = 0;
};

// A face as a polygon or disc.
void face_feature(const Convex& c, int face, Feature& out);
// The face, edge or side line that meets a face which looks along -n. `vertex`: of a hull the farthest along n, or
// unknown_vertex.
void incident_feature(const Convex& c, const math::DVec3& n, int vertex, Feature& out);
// The edge or side line across n where there is one within a hundredth, else the farthest point along n.
void edge_feature(const Convex& c, math::DVec3 n, Feature& out);

struct FaceOutline;

// Points between a reference face and an incident feature, measured along the outward normal of the reference face.
// Points outside the face by less than a ten thousandth of it count as over it. `out` is empty before.
// Where the incident feature is no disc:
void outline_points(const FaceOutline& reference, const Feature& incident, ContactPoints& out);
// Where one of them is:
void disc_points(const Feature& reference, const Feature& incident, double extent, ContactPoints& out);
// The plane under a disc, through a point and with that normal, as a square: the rim is found as on any face.
void square_under(const Feature& disc, const math::DVec3& point, const math::DVec3& up, Feature& out);

// A segment, or a point where it leads nowhere.
struct EdgeLine {
    math::DVec3 from, way;
};
struct EdgePoints {
    struct Point {
        math::DVec3 position; // midway
        double separation;
    };
    Point points[2];
    int count = 0;
    double sideways = 0;   // how far a single point of the first is beside that of the second
    bool is_cross = false; // both are between the ends
};
// One or two points between segments or points, `separation` apart along n (from the first to the second); with two
// they are as far apart as the segments are.
EdgePoints edge_points(const EdgeLine& first, const EdgeLine& second, math::DVec3 n, double separation);
// Likewise of features.
EdgePoints edge_points(const Feature& first, const Feature& second, math::DVec3 n, double separation,
                       ContactPoints& out);

} // namespace cairn
