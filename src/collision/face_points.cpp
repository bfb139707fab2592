#include "collision/face_points.h"

namespace cairn {

using math::dot;
using math::DVec3;

void FacePoints::find(const Convex& c, const Convex& other, const FaceAxis& axis, double extent) {
    is_found = true;
    known.face = axis.face, known.is_second = axis.is_second;
    Feature incident;
    incident_feature(other, axis.is_second ? axis.normal : -axis.normal, axis.opposite, incident);
    points.list.clear();
    const bool is_disc = c.kind == Convex::Kind::cylinder;
    if (is_disc || incident.kind == Feature::Kind::disc) {
        disc.emplace();
        face_feature(c, axis.face, *disc);
        disc_points(*disc, incident, extent, points);
    }
    if (!is_disc) {
        outline.find(c, axis.face, axis.is_second ? -axis.normal : axis.normal, axis.on_face);
        if (incident.kind != Feature::Kind::disc) outline_points(outline, incident, points);
    }
    known.reached = std::numeric_limits<double>::infinity();
    for (const ContactPoint& p : points.list)
        if (p.separation < known.reached) known.reached = p.separation;
}

bool FacePoints::are_amid(const Convex& c, double reach, double distance) const {
    double x = 0, y = 0, z = 0, count = 0;
    for (const ContactPoint& p : points.list)
        if (p.separation <= reach) x += p.x, y += p.y, z += p.separation, count += 1;
    if (!(count > 0)) return false;
    const double part = 1 / count;
    const DVec3 middle = points.position(part * x, part * y, part * z);
    if (c.kind != Convex::Kind::cylinder) return outline.holds(middle, distance);
    const DVec3 d = middle - disc->center, across = d - dot(d, disc->normal) * disc->normal;
    return math::length(across) < disc->radius - distance;
}

bool face_manifold(const Convex& a, const Convex& b, const FaceAxis& axis, double least, double tolerance,
                   double extent, double margin, FacePoints& found, Manifold& out) {
    const Convex &c = axis.is_second ? b : a, &other = axis.is_second ? a : b;
    if (!found.is_of(axis)) found.find(c, other, axis, extent);
    if (!(found.known.reached <= least + tolerance)) return false;
    if (!found.is_found) found.find(c, other, axis, extent);
    write_manifold(found.points, axis.normal, other.center, extent, margin, least, out);
    return out.count > 0;
}

} // namespace cairn
