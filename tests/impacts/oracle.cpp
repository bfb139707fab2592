#include "oracle.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace cairn_test {
namespace {

constexpr double fineness = 1e-5; // of the size: greatest motion between two samples
constexpr int most_iterations = 200;

// Up to four points of the Minkowski difference of two solids, and the point of their convex hull closest to the
// origin.
struct Simplex {
    std::array<glm::dvec3, 4> points{};
    std::size_t count = 0;
    glm::dvec3 nearest{0, 0, 0};

    // Reduces to the points whose hull contains the closest point. All subsets are tried: slow, but robust.
    void reduce() {
        double least = std::numeric_limits<double>::infinity();
        Simplex best;
        for (unsigned mask = 1; mask < (1u << count); ++mask) {
            Simplex part;
            for (std::size_t i = 0; i < count; ++i)
                if (mask & (1u << i)) part.points[part.count++] = points[i];
            if (!part.project()) continue;
            const double length2 = glm::dot(part.nearest, part.nearest);
            if (length2 < least) {
                least = length2;
                best = part;
            }
        }
        *this = best;
    }

  private:
    // Sets `nearest` to the projection of the origin on the span of the points; false if it lies outside of their hull.
    bool project() {
        // Normal equations of the edges from the first point, solved by elimination.
        const std::size_t n = count - 1;
        std::array<std::array<double, 4>, 3> rows{};
        for (std::size_t i = 0; i < n; ++i) {
            for (std::size_t j = 0; j < n; ++j)
                rows[i][j] = glm::dot(points[i + 1] - points[0], points[j + 1] - points[0]);
            rows[i][3] = -glm::dot(points[i + 1] - points[0], points[0]);
        }
        for (std::size_t i = 0; i < n; ++i) {
            const double size = glm::dot(points[i + 1] - points[0], points[i + 1] - points[0]);
            if (!(rows[i][i] > 1e-14 * size)) return false; // degenerate: a smaller subset suffices
            for (std::size_t k = 0; k < n; ++k) {
                if (k == i) continue;
                const double factor = rows[k][i] / rows[i][i];
                for (std::size_t j = 0; j < 4; ++j) rows[k][j] -= factor * rows[i][j];
            }
        }
        nearest = points[0];
        double rest = 1;
        for (std::size_t i = 0; i < n; ++i) {
            const double weight = rows[i][3] / rows[i][i];
            if (weight < 0) return false;
            rest -= weight;
            nearest += weight * (points[i + 1] - points[0]);
        }
        return rest >= 0;
    }
};

// The motion of a shape in a step.
struct Way {
    const Moving* moving;
    const Core& core;
    glm::dvec3 start, end; // m, of the center
    double turn;           // rad
    double reach;          // m
};

Pose to_pose(const cairn::Transform& transform) {
    return {transform.position, glm::normalize(glm::dquat(transform.rotation))};
}

// The shorter rotation between two poses: its vector part is the axis times the sine of half the angle.
glm::dquat turn_between(const Pose& from, const Pose& to) {
    const glm::dquat turn = to.rotation * glm::conjugate(from.rotation);
    return turn.w < 0 ? -turn : turn;
}

double angle_of(const glm::dquat& turn) {
    return 2 * std::atan2(glm::length(glm::dvec3(turn.x, turn.y, turn.z)), turn.w);
}

Way way_of(const Moving& moving, const Core& core) {
    const Pose from = to_pose(moving.from), to = to_pose(moving.to);
    Way way{&moving, core, from.apply(moving.center), to.apply(moving.center), 0, 0};
    way.turn = angle_of(turn_between(from, to));
    way.reach = way.core.reach_from(moving.center);
    return way;
}

// The height of a solid above a half-space; negative if it penetrates.
double height_over(const glm::dvec3& normal, const Pose& plane, const CorePiece& piece, const Pose& pose) {
    const glm::dvec3 up = plane.rotation * normal;
    const glm::dvec3 lowest = pose.apply(piece.support(glm::conjugate(pose.rotation) * -up));
    return glm::dot(up, lowest - plane.position);
}

// The distance of two cores at a time of the step, 0 if they overlap.
double distance_at(const Way& a, const Way& b, double time) {
    const Pose pose_a = a.moving->at(time), pose_b = b.moving->at(time);
    double least = std::numeric_limits<double>::infinity();
    if (a.core.half_space)
        for (const CorePiece& piece : b.core.pieces)
            least = std::min(least, height_over(*a.core.half_space, pose_a, piece, pose_b));
    if (b.core.half_space)
        for (const CorePiece& piece : a.core.pieces)
            least = std::min(least, height_over(*b.core.half_space, pose_b, piece, pose_a));
    for (const CorePiece& piece_a : a.core.pieces)
        for (const CorePiece& piece_b : b.core.pieces)
            if (least > 0) least = std::min(least, separation(piece_a, pose_a, piece_b, pose_b));
    return std::max(0.0, least);
}

// An upper bound of the relative motion in the whole step of any points of the two bodies that could meet.
double greatest_motion(const Way& a, const Way& b) {
    const double apart = std::max(glm::length(a.start - b.start), glm::length(a.end - b.end));
    // A meeting point is within reach of both.
    const double arm_a = std::min(a.reach, apart + b.reach), arm_b = std::min(b.reach, apart + a.reach);
    double motion = glm::length((a.end - a.start) - (b.end - b.start));
    if (a.turn > 0) motion += a.turn * arm_a;
    if (b.turn > 0) motion += b.turn * arm_b;
    return motion;
}

const Core& core_of(const Moving& moving, Core& made) {
    if (moving.core) return *moving.core;
    return made = make_core(*moving.shape, moving.shrink);
}

struct Search {
    const Way &a, &b;
    double motion, finest; // m

    std::optional<double> within(double from, double to) const {
        const double middle = 0.5 * (from + to), around = 0.5 * motion * (to - from);
        const double distance = distance_at(a, b, middle);
        if (distance > around) return {};
        if (around < finest) return distance > 0 ? std::nullopt : std::optional(middle);
        if (const auto first = within(from, middle)) return first;
        return distance > 0 ? within(middle, to) : std::optional(middle);
    }
};

} // namespace

Pose Moving::at(double time) const {
    const Pose start = to_pose(from), end = to_pose(to);
    const glm::dquat turn = turn_between(start, end);
    const glm::dvec3 sine_axis(turn.x, turn.y, turn.z);
    const double sine = glm::length(sine_axis), half = 0.5 * angle_of(turn) * time;
    glm::dquat part(1, 0, 0, 0);
    if (sine > 0) {
        const glm::dvec3 axis = sine_axis / sine * std::sin(half);
        part = glm::dquat(std::cos(half), axis.x, axis.y, axis.z);
    }
    Pose pose;
    pose.rotation = part * start.rotation;
    const glm::dvec3 middle = (1 - time) * start.apply(center) + time * end.apply(center);
    pose.position = middle - pose.rotation * center;
    return pose;
}

double separation(const CorePiece& a, const Pose& pose_a, const CorePiece& b, const Pose& pose_b) {
    const auto support = [&](const glm::dvec3& direction) {
        return pose_a.apply(a.support(glm::conjugate(pose_a.rotation) * direction)) -
               pose_b.apply(b.support(glm::conjugate(pose_b.rotation) * -direction));
    };
    Simplex simplex;
    simplex.nearest = support({1, 0, 0});
    simplex.points[simplex.count++] = simplex.nearest;
    double bound = 0;
    for (int i = 0; i < most_iterations; ++i) {
        const double length = glm::length(simplex.nearest);
        // The closest point is the origin within the precision of the poses.
        if (length <= 1e-14 * (1 + glm::length(simplex.points[0]))) return 0;
        const glm::dvec3 direction = -simplex.nearest / length, next = support(direction);
        // No point is farther in this direction, so the difference lies beyond this plane.
        bound = std::max(bound, -glm::dot(next, direction));
        if (length - bound <= 1e-9 * length) break;
        const glm::dvec3 before = simplex.nearest;
        simplex.points[simplex.count++] = next;
        simplex.reduce();
        if (simplex.count == 4) return 0; // contains the origin
        if (!(glm::dot(simplex.nearest, simplex.nearest) < glm::dot(before, before))) break;
    }
    return bound;
}

std::optional<double> cores_meet(const Moving& a, const Moving& b) {
    Core made_a, made_b;
    const Way way_a = way_of(a, core_of(a, made_a)), way_b = way_of(b, core_of(b, made_b));
    const double size = std::min(way_a.reach, way_b.reach);
    if (!(size > 0) || !std::isfinite(size)) return {}; // one has no core, or both are planes
    const Search search{way_a, way_b, greatest_motion(way_a, way_b), fineness * size};
    if (distance_at(way_a, way_b, 0) <= 0) return 0.0;
    if (const auto time = search.within(0, 1)) return time;
    return distance_at(way_a, way_b, 1) > 0 ? std::nullopt : std::optional(1.0);
}

bool cores_overlap_at_start(const Moving& a, const Moving& b) {
    Core made_a, made_b;
    return distance_at(way_of(a, core_of(a, made_a)), way_of(b, core_of(b, made_b)), 0) <= 0;
}

bool cores_meet(const cairn::Shape& shape_a, const cairn::Transform& from_a, const cairn::Transform& to_a,
                const cairn::Shape& shape_b, const cairn::Transform& from_b, const cairn::Transform& to_b,
                double core_shrink) {
    const Moving a{&shape_a, from_a, to_a, {0, 0, 0}, core_shrink};
    const Moving b{&shape_b, from_b, to_b, {0, 0, 0}, core_shrink};
    return cores_meet(a, b).has_value();
}

} // namespace cairn_test
