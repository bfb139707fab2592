#include "impacts/impact_law.h"

#include <algorithm>
#include <cmath>

namespace cairn {

using math::cross;
using math::dot;
using math::DVec3;

namespace {

constexpr int max_sweeps = 200;            // over all points; each sweep approaches the solution
constexpr double precision = 1e-9;         // of the greatest approach speed: smaller changes end the sweeps
constexpr double min_friction_share = 0.1; // a smaller share of friction is set to 0 rather than halved
constexpr double rounding_gain = 1e-9;     // of the energy: a greater gain does not come from rounding

double velocity_along(const ImpactRow& row, std::span<const ImpactBody> bodies) {
    const ImpactBody &a = bodies[std::size_t(row.a)], &b = bodies[std::size_t(row.b)];
    return dot(row.direction, b.v - a.v) + (dot(row.arm_b, b.w) - dot(row.arm_a, a.w));
}
void push(const ImpactRow& row, double impulse, std::span<ImpactBody> bodies) {
    ImpactBody &a = bodies[std::size_t(row.a)], &b = bodies[std::size_t(row.b)];
    a.v = a.v - (impulse * a.inverse_mass) * row.direction;
    a.w = a.w - impulse * row.turn_a;
    b.v = b.v + (impulse * b.inverse_mass) * row.direction;
    b.w = b.w + impulse * row.turn_b;
}

// Makes the rows of one pair after another.
class RowMaker {
  public:
    RowMaker(std::span<const ImpactBody> bodies, std::span<const ImpactPair> pairs, std::int32_t pair)
        : pair_(pairs[std::size_t(pair)]), index_(pair), a_(bodies[std::size_t(pair_.a)]),
          b_(bodies[std::size_t(pair_.b)]) {}
    ImpactRow row_along(DVec3 direction, DVec3 position) const {
        return finished(direction, cross(position - a_.x, direction), cross(position - b_.x, direction),
                        a_.inverse_mass + b_.inverse_mass);
    }
    ImpactRow couple_about(DVec3 axis) const { return finished({}, axis, axis, 0); }

  private:
    ImpactRow finished(DVec3 direction, DVec3 arm_a, DVec3 arm_b, double inverse_mass) const {
        const DVec3 turn_a = a_.inverse_inertia * arm_a, turn_b = b_.inverse_inertia * arm_b;
        return {direction, arm_a, arm_b,   turn_a,  turn_b, inverse_mass + (dot(arm_a, turn_a) + dot(arm_b, turn_b)),
                0,         0,     pair_.a, pair_.b, index_, 0};
    }
    const ImpactPair& pair_;
    const std::int32_t index_;
    const ImpactBody &a_, &b_;
};

DVec3 any_tangent(DVec3 n) {
    const DVec3 axis = std::fabs(n.x) < 0.5 ? DVec3{1, 0, 0} : DVec3{0, 1, 0};
    return math::normalized(cross(n, axis));
}

// Rows per point: the normal, two tangents, and couples about all three.
constexpr std::size_t rows_per_point = 6;

// Gauss-Seidel iteration from the velocities before the impact to those in `bodies`. `share`: the fraction of friction
// and couples that acts. Returns the energy added, which is the work of the impulses with the mean of the velocities
// before and after.
double solve(std::span<ImpactBody> bodies, std::span<const ImpactPoint> points, ImpactBuffer& buffer, double share,
             double scale) {
    std::vector<ImpactRow>& rows = buffer.rows;
    std::copy(buffer.before.begin(), buffer.before.end(), bodies.begin());
    for (ImpactRow& row : rows) row.impulse = 0;
    for (int sweep = 0; sweep < max_sweeps; ++sweep) {
        double change = 0;
        const auto apply = [&](ImpactRow& row, double next) {
            const double by = next - row.impulse;
            push(row, by, bodies);
            row.impulse = next;
            change = std::max(change, std::fabs(by) * row.inverse_effective_mass);
        };
        // Total impulse that stops the motion along a row; resist_one and resist limit it.
        const auto stop = [&](const ImpactRow& row) {
            const double mass = row.inverse_effective_mass;
            return mass > 0 ? row.impulse - velocity_along(row, bodies) / mass : 0.0;
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
            const ImpactMaterial& material = points[std::size_t(normal.point)].material;
            apply(normal, std::max(normal.impulse +
                                       (normal.target - velocity_along(normal, bodies)) / normal.inverse_effective_mass,
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
        work += 0.5 * row.impulse * (velocity_along(row, buffer.before) + velocity_along(row, bodies));
    return work;
}

// Creates rows for the approaching points; for a resting pair, for all points, as they may come to approach.
ImpactOutcome make_rows(std::span<const ImpactBody> bodies, std::span<const ImpactPair> pairs,
                        std::span<const ImpactPoint> points, std::vector<ImpactRow>& rows, double& greatest) {
    ImpactOutcome outcome;
    rows.clear();
    auto next = points.begin();
    for (std::size_t p = 0; p < pairs.size(); ++p) {
        const ImpactPair& pair = pairs[p];
        const RowMaker make(bodies, pairs, std::int32_t(p));
        for (const auto end = next + pair.points; next != end; ++next) {
            ImpactRow normal = make.row_along(next->normal, next->position);
            const double approach = -velocity_along(normal, bodies);
            if (!(approach > 0 || pair.rests) || !(normal.inverse_effective_mass > 0)) continue;
            const ImpactMaterial& material = next->material;
            const bool bounces = !pair.rests && material.restitution > 0 && approach > material.restitution_speed;
            normal.target = std::max(bounces ? material.restitution * approach : 0.0, next->rebound);
            normal.point = std::int32_t(next - points.begin());
            greatest = std::max(greatest, approach);
            if (p == 0) {
                outcome.bounces |= bounces;
                if (approach > outcome.approach) {
                    outcome.approach = approach, outcome.position = next->position, outcome.normal = next->normal;
                    outcome.surface_material = next->surface_material;
                }
            }
            const DVec3 first = any_tangent(next->normal), second = cross(next->normal, first);
            rows.push_back(normal);
            for (const DVec3 tangent : {first, second}) rows.push_back(make.row_along(tangent, next->position));
            for (const DVec3 axis : {next->normal, first, second}) rows.push_back(make.couple_about(axis));
        }
    }
    return outcome;
}

} // namespace

ImpactOutcome collide(std::span<ImpactBody> bodies, std::span<const ImpactPair> pairs,
                      std::span<const ImpactPoint> points, ImpactBuffer& buffer) {
    double greatest = 0; // approach
    std::vector<ImpactRow>& rows = buffer.rows;
    ImpactOutcome outcome = make_rows(bodies, pairs, points, rows, greatest);
    if (!(outcome.approach > 0)) return outcome;
    buffer.before.assign(bodies.begin(), bodies.end());
    for (double share = 1;; share = share > min_friction_share ? 0.5 * share : 0) {
        const double work = solve(bodies, points, buffer, share, greatest);
        double scale = 0, given = 0; // sum of the energies along the normals; energy that rebounds may add
        outcome.impulse = 0;
        for (std::size_t k = 0; k < rows.size(); k += rows_per_point) {
            if (rows[k].pair == 0) outcome.impulse += rows[k].impulse;
            const double approach = std::fabs(velocity_along(rows[k], buffer.before));
            scale += rows[k].impulse * approach;
            given += 0.5 * rows[k].impulse * std::max(rows[k].target - approach, 0.0);
        }
        if (work <= given + rounding_gain * scale) return outcome;
        if (share > 0) continue;
        if (pairs.size() == 1) return outcome;
        // A bounce off a supported body that is leaving may gain energy: the bodies beneath are then pushed later.
        std::copy(buffer.before.begin(), buffer.before.end(), bodies.begin());
        return collide(bodies, pairs.first(1), points.first(std::size_t(pairs.front().points)), buffer);
    }
}

bool cut_spin(ImpactBody& body, double most) {
    const double speed = math::length(body.w);
    if (!(body.inverse_mass > 0) || !(speed > most)) return false;
    body.w = (most / speed) * body.w;
    body.inverse_inertia = {};
    return true;
}

} // namespace cairn
