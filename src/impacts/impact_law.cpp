#include "impacts/impact_law.h"

#include <algorithm>
#include <cmath>

namespace cairn {

using math::cross;
using math::dot;
using math::DVec3;

namespace {

constexpr int max_sweeps = 200;            // over all points: each comes nearer to the solution
constexpr double precision = 1e-9;         // of the greatest approach: changes smaller than that end the sweeps
constexpr double min_friction_share = 0.1; // is halved once more before there is none
constexpr double rounding_gain = 1e-9;     // of the energy: what is more has been gained

double velocity_along(const ImpactRow& row, const ImpactBody& a, const ImpactBody& b) {
    return dot(row.direction, b.v - a.v) + (dot(row.arm_b, b.w) - dot(row.arm_a, a.w));
}
void push(const ImpactRow& row, double impulse, ImpactBody& a, ImpactBody& b) {
    a.v = a.v - (impulse * a.inverse_mass) * row.direction;
    a.w = a.w - impulse * row.turn_a;
    b.v = b.v + (impulse * b.inverse_mass) * row.direction;
    b.w = b.w + impulse * row.turn_b;
}

ImpactRow finished(ImpactRow row, double inverse_mass, const ImpactBody& a, const ImpactBody& b) {
    row.turn_a = a.inverse_inertia * row.arm_a;
    row.turn_b = b.inverse_inertia * row.arm_b;
    row.inverse_effective_mass = inverse_mass + (dot(row.arm_a, row.turn_a) + dot(row.arm_b, row.turn_b));
    return row;
}
ImpactRow row_along(DVec3 direction, DVec3 position, const ImpactBody& a, const ImpactBody& b) {
    const ImpactRow row{direction, cross(position - a.x, direction), cross(position - b.x, direction), {}, {}, 0, 0, 0};
    return finished(row, a.inverse_mass + b.inverse_mass, a, b);
}
ImpactRow couple_about(DVec3 axis, const ImpactBody& a, const ImpactBody& b) {
    return finished({{}, axis, axis, {}, {}, 0, 0, 0}, 0, a, b);
}

DVec3 any_tangent(DVec3 n) {
    const DVec3 axis = std::fabs(n.x) < 0.5 ? DVec3{1, 0, 0} : DVec3{0, 1, 0};
    return math::normalized(cross(n, axis));
}

// Rows of a point: the normal, two tangents, and couples about all three.
constexpr std::size_t rows_per_point = 6;

// `share`: of friction and couples that acts. Gauss-Seidel from the velocities of `a` and `b`, which get those after
// it. Returns the energy that the impulses have added, by their work: half of the velocities before and after.
double solve(ImpactBody& a, ImpactBody& b, std::vector<ImpactRow>& rows, const ImpactMaterial& material, double share,
             double scale) {
    const ImpactBody before_a = a, before_b = b;
    for (ImpactRow& row : rows) row.impulse = 0;
    for (int sweep = 0; sweep < max_sweeps; ++sweep) {
        double change = 0;
        const auto apply = [&](ImpactRow& row, double next) {
            const double by = next - row.impulse;
            push(row, by, a, b);
            row.impulse = next;
            change = std::max(change, std::fabs(by) * row.inverse_effective_mass);
        };
        // What stops the motion along rows, or as much of it as the limit allows.
        const auto stop = [&](const ImpactRow& row) {
            const double mass = row.inverse_effective_mass;
            return mass > 0 ? row.impulse - velocity_along(row, a, b) / mass : 0.0;
        };
        const auto resist_one = [&](ImpactRow& row, double limit) {
            if (limit > 0) apply(row, std::clamp(stop(row), -limit, limit));
        };
        const auto resist = [&](ImpactRow& first, ImpactRow& second, double limit) {
            if (!(limit > 0)) return;
            const double p1 = stop(first), p2 = stop(second), size = std::sqrt(p1 * p1 + p2 * p2);
            const double share = size > limit ? limit / size : 1;
            apply(first, share * p1);
            apply(second, share * p2);
        };
        for (std::size_t k = 0; k < rows.size(); k += rows_per_point) {
            ImpactRow& normal = rows[k];
            apply(normal, std::max(normal.impulse +
                                       (normal.target - velocity_along(normal, a, b)) / normal.inverse_effective_mass,
                                   0.0));
            const double load = share * normal.impulse, friction = material.friction * load;
            resist(rows[k + 1], rows[k + 2], friction);
            resist_one(rows[k + 3], friction * material.torsion_radius);
            resist(rows[k + 4], rows[k + 5], material.rolling_radius * load);
        }
        if (!(change > precision * scale)) break;
    }
    double work = 0;
    for (const ImpactRow& row : rows)
        work += 0.5 * row.impulse * (velocity_along(row, before_a, before_b) + velocity_along(row, a, b));
    return work;
}

} // namespace

ImpactOutcome collide(ImpactBody& a, ImpactBody& b, const std::vector<ImpactPoint>& points,
                      const ImpactMaterial& material, std::vector<ImpactRow>& rows) {
    ImpactOutcome outcome;
    rows.clear();
    for (const ImpactPoint& point : points) {
        ImpactRow normal = row_along(point.normal, point.position, a, b);
        const double approach = -velocity_along(normal, a, b);
        if (!(approach > 0) || !(normal.inverse_effective_mass > 0)) continue;
        const bool bounces = material.restitution > 0 && approach > material.restitution_speed;
        normal.target = std::max(bounces ? material.restitution * approach : 0.0, point.rebound);
        outcome.bounces |= bounces;
        if (approach > outcome.approach)
            outcome.approach = approach, outcome.position = point.position, outcome.normal = point.normal;
        const DVec3 first = any_tangent(point.normal), second = cross(point.normal, first);
        rows.push_back(normal);
        for (const DVec3 tangent : {first, second}) rows.push_back(row_along(tangent, point.position, a, b));
        for (const DVec3 axis : {point.normal, first, second}) rows.push_back(couple_about(axis, a, b));
    }
    if (rows.empty()) return outcome;
    const ImpactBody before_a = a, before_b = b;
    for (double share = 1;; share = share > min_friction_share ? 0.5 * share : 0) {
        a = before_a, b = before_b;
        const double work = solve(a, b, rows, material, share, outcome.approach);
        double scale = 0, given = 0; // of the energies along the normals; what rebounds add
        outcome.impulse = 0;
        for (std::size_t k = 0; k < rows.size(); k += rows_per_point) {
            outcome.impulse += rows[k].impulse;
            const double approach = std::fabs(velocity_along(rows[k], before_a, before_b));
            scale += rows[k].impulse * approach;
            given += 0.5 * rows[k].impulse * std::max(rows[k].target - approach, 0.0);
        }
        if (work <= given + rounding_gain * scale || share == 0) return outcome;
    }
}

} // namespace cairn
