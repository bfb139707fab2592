#include "character/planes.h"

#include <algorithm>
#include <cmath>

namespace cairn {

using math::dot;
using math::DVec3;

void MotionPlanes::add(const MotionPlane& plane) {
    if (count_ == max_count) {
        for (std::size_t i = 2; i < max_count; ++i) planes_[i - 1] = planes_[i];
        --count_;
    }
    planes_[count_++] = plane;
}

bool MotionPlanes::allows(DVec3 motion, double tolerance) const {
    for (std::size_t i = 0; i < count_; ++i)
        if (dot(planes_[i].normal, motion) < planes_[i].least - tolerance) return false;
    return true;
}

namespace {

// The point on the intersection line of two planes that is nearest to `wanted`.
std::optional<DVec3> on_both(const MotionPlane& a, const MotionPlane& b, DVec3 wanted) {
    const double c = dot(a.normal, b.normal), determinant = 1 - c * c;
    if (!(determinant > 1e-9)) return std::nullopt;
    const double off_a = a.least - dot(a.normal, wanted), off_b = b.least - dot(b.normal, wanted);
    const double x = (off_a - c * off_b) / determinant, y = (off_b - c * off_a) / determinant;
    return wanted + x * a.normal + y * b.normal;
}

// The intersection point of three planes.
std::optional<DVec3> on_all(const MotionPlane& a, const MotionPlane& b, const MotionPlane& c) {
    const DVec3 bc = math::cross(b.normal, c.normal);
    const double volume = dot(a.normal, bc);
    if (!(std::fabs(volume) > 1e-6)) return std::nullopt;
    return (1 / volume) *
           (a.least * bc + b.least * math::cross(c.normal, a.normal) + c.least * math::cross(a.normal, b.normal));
}

} // namespace

// The nearest point of a convex polyhedron is the wanted point itself, or on a face, an edge or a vertex: all are
// tried.
std::optional<DVec3> MotionPlanes::nearest(DVec3 wanted) const {
    const double tolerance = 1e-9 * (1 + math::length(wanted));
    if (allows(wanted, tolerance)) return wanted;
    std::optional<DVec3> best;
    double least = 0, most = tolerance + math::length(wanted);
    for (std::size_t i = 0; i < count_; ++i) most += std::max(0.0, planes_[i].least);
    const auto consider = [&](const std::optional<DVec3>& motion) {
        if (!motion || !allows(*motion, tolerance) || math::length(*motion) > most) return;
        const DVec3 off = *motion - wanted;
        const double square = dot(off, off);
        if (!best || square < least) best = motion, least = square;
    };
    for (std::size_t i = 0; i < count_; ++i) {
        const MotionPlane& a = planes_[i];
        consider(wanted + (a.least - dot(a.normal, wanted)) * a.normal);
        for (std::size_t j = i + 1; j < count_; ++j) {
            consider(on_both(a, planes_[j], wanted));
            for (std::size_t k = j + 1; k < count_; ++k) consider(on_all(a, planes_[j], planes_[k]));
        }
    }
    return best;
}

} // namespace cairn
