#include "impacts/impact_law.h"

#include <algorithm>
#include <cmath>

namespace cairn {

using math::cross;
using math::dot;
using math::DVec3;

namespace {

constexpr int max_sweeps = 1000;       // over all points: each comes nearer to the solution
constexpr double precision = 1e-12;    // of the greatest approach: changes smaller than that end the sweeps
constexpr double rounding_gain = 1e-9; // of the energy: what is more has been gained

double velocity_along(const ImpactRow& row, const ImpactBody& a, const ImpactBody& b) {
    return dot(row.direction, b.v - a.v) + (dot(row.arm_b, b.w) - dot(row.arm_a, a.w));
}
void push(const ImpactRow& row, double impulse, ImpactBody& a, ImpactBody& b) {
    a.v = a.v - (impulse * a.inverse_mass) * row.direction;
    a.w = a.w - impulse * row.turn_a;
    b.v = b.v + (impulse * b.inverse_mass) * row.direction;
    b.w = b.w + impulse * row.turn_b;
}

ImpactRow row_along(DVec3 direction, DVec3 position, const ImpactBody& a, const ImpactBody& b) {
    ImpactRow row{direction, cross(position - a.x, direction), cross(position - b.x, direction), {}, {}, 0, 0, 0};
    row.turn_a = a.inverse_inertia * row.arm_a;
    row.turn_b = b.inverse_inertia * row.arm_b;
    row.inverse_effective_mass =
        (a.inverse_mass + b.inverse_mass) + (dot(row.arm_a, row.turn_a) + dot(row.arm_b, row.turn_b));
    return row;
}

DVec3 any_tangent(DVec3 n) {
    const DVec3 axis = std::fabs(n.x) < 0.5 ? DVec3{1, 0, 0} : DVec3{0, 1, 0};
    return math::normalized(cross(n, axis));
}

// Three rows a point: the normal, and two tangents.
constexpr std::size_t rows_per_point = 3;

// Gauss-Seidel from the velocities of `a` and `b`, which get those after it. Returns the energy that the impulses have
// added, by their work: half of the velocities before and after.
double solve(ImpactBody& a, ImpactBody& b, std::vector<ImpactRow>& rows, double friction, double scale) {
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
        for (std::size_t k = 0; k < rows.size(); k += rows_per_point) {
            ImpactRow& normal = rows[k];
            apply(normal, std::max(normal.impulse +
                                       (normal.target - velocity_along(normal, a, b)) / normal.inverse_effective_mass,
                                   0.0));
            if (!(friction > 0)) continue;
            ImpactRow &first = rows[k + 1], &second = rows[k + 2];
            const double p1 = first.impulse - velocity_along(first, a, b) / first.inverse_effective_mass;
            const double p2 = second.impulse - velocity_along(second, a, b) / second.inverse_effective_mass;
            const double size = std::sqrt(p1 * p1 + p2 * p2), limit = friction * normal.impulse;
            const double share = size > limit ? limit / size : 1;
            apply(first, share * p1);
            apply(second, share * p2);
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
        normal.target = bounces ? material.restitution * approach : 0;
        outcome.bounces |= bounces;
        if (approach > outcome.approach)
            outcome.approach = approach, outcome.position = point.position, outcome.normal = point.normal;
        const DVec3 tangent = any_tangent(point.normal);
        rows.push_back(normal);
        rows.push_back(row_along(tangent, point.position, a, b));
        rows.push_back(row_along(cross(point.normal, tangent), point.position, a, b));
    }
    if (rows.empty()) return outcome;
    const ImpactBody before_a = a, before_b = b;
    const double work = solve(a, b, rows, material.friction, outcome.approach);
    double approaching = 0; // energy scale of what happens along the normals
    for (std::size_t k = 0; k < rows.size(); k += rows_per_point)
        approaching += rows[k].impulse * std::fabs(velocity_along(rows[k], before_a, before_b));
    if (!(work > rounding_gain * approaching)) return outcome;
    a = before_a, b = before_b;
    for (ImpactRow& row : rows) row.target = 0;
    solve(a, b, rows, material.friction, outcome.approach);
    const auto scaled = [&](DVec3 before, DVec3 compressed) {
        return before + (1 + (outcome.bounces ? material.restitution : 0)) * (compressed - before);
    };
    a.v = scaled(before_a.v, a.v), a.w = scaled(before_a.w, a.w);
    b.v = scaled(before_b.v, b.v), b.w = scaled(before_b.w, b.w);
    return outcome;
}

} // namespace cairn
