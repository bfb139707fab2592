// Rigid limits of joints that are solved directly. A row of its own sees the two bodies of the joint alone: where one
// is light and carries a heavy one, it stops the light one and the joints push it on, substep after substep, and what
// takes the error back then throws the heavy one. So an impulse of a limit goes through all that hangs together before
// the next is looked for.
#include "joints/direct_view.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace cairn {

using math::DVec3;

namespace {

// Passes over the limits that are at work, each with what the others have given: as they hardly act on each other, few.
constexpr int max_limit_passes = 16;
// m/s or rad/s: what a limit changes by less is settled.
constexpr double settled = 1e-6;

struct LimitRow {
    DVec3 linear[2], angular[2];
    double position;
};

LimitRow row_of(const SetView& v, const DirectLimit& limit) {
    const AxisBlock& b = v.axes[limit.lane / 8];
    const std::size_t lane = limit.lane % 8;
    const auto get = [&](const float(*p)[8]) {
        return DVec3{double(p[0][lane]), double(p[1][lane]), double(p[2][lane])};
    };
    return {{get(b.linear_a), get(b.linear_b)}, {get(b.angular_a), get(b.angular_b)}, double(b.position[lane])};
}

double speed_of(const SetView& v, const DirectLimit& limit, const LimitRow& row) {
    double speed = 0;
    for (int side = 0; side < 2; ++side) {
        const DirectBody& body = v.bodies[limit.body[side]];
        speed += math::dot(row.linear[side], body.v + body.dv) + math::dot(row.angular[side], body.w + body.dw);
    }
    return speed;
}

// Of its own speed, with the two bodies alone.
double own_response(const SetView& v, const DirectLimit& limit, const LimitRow& row) {
    double response = 0;
    for (int side = 0; side < 2; ++side) {
        const DirectBody& body = v.bodies[limit.body[side]];
        response += body.inverse_mass * math::dot(row.linear[side], row.linear[side]);
        response += math::dot(row.angular[side], body.inverse_inertia * row.angular[side]);
    }
    return response;
}

void apply(const SetView& v, const DirectLimit& limit, const LimitRow& row, double impulse) {
    for (int side = 0; side < 2; ++side) {
        DirectBody& body = v.bodies[limit.body[side]];
        body.dv += (impulse * body.inverse_mass) * row.linear[side];
        body.dw += impulse * (body.inverse_inertia * row.angular[side]);
    }
}

// With all that hangs together.
void push(const SetView& v, const DirectLimit& limit, const LimitRow& row, double impulse, double rate, bool keeps) {
    apply(v, limit, row, impulse);
    seek_impulses(v, rate);
    if (!keeps) return;
    for (std::size_t i = 0; i < v.set.nodes.size(); ++i) v.rows[i].impulse += v.sought[i];
}

// One bound. Returns by how much the speed was changed.
double hold_bound(const SetView& v, DirectLimit& limit, const LimitRow& row, int bound, double rate, double h,
                  bool keeps) {
    const double sign = bound == 0 ? 1.0 : -1.0, gap = sign * (row.position - limit.bounds[bound]);
    const double wanted = gap > 0 ? -gap / h : std::min(-rate * gap, fastest_return);
    const double missing = wanted - sign * speed_of(v, limit, row);
    if (missing <= 0 && limit.impulse[bound] == 0) return 0;
    double change = 0;
    if (limit.response == 0) {
        const double own = own_response(v, limit, row);
        if (!(own > 0)) return 0;
        const double trial = missing / own, before = speed_of(v, limit, row);
        push(v, limit, row, sign * trial, rate, keeps);
        limit.impulse[bound] += trial;
        change = sign * (speed_of(v, limit, row) - before);
        limit.response = change / trial;
    }
    if (!(limit.response > 0)) return change; // the joints hold it
    const double left = wanted - sign * speed_of(v, limit, row);
    const double impulse = std::max(left / limit.response, -limit.impulse[bound]);
    if (impulse == 0) return change;
    push(v, limit, row, sign * impulse, rate, keeps);
    limit.impulse[bound] += impulse;
    return change + limit.response * impulse;
}

void hold_all(const SetView& v, double rate, double h, bool keeps) {
    for (int pass = 0; pass < max_limit_passes; ++pass) {
        double greatest = 0;
        for (std::size_t i = 0; i < v.limit_count; ++i) {
            const LimitRow row = row_of(v, v.limits[i]);
            for (int bound = 0; bound < 2; ++bound)
                greatest = std::max(greatest, std::fabs(hold_bound(v, v.limits[i], row, bound, rate, h, keeps)));
        }
        if (greatest <= settled) return;
    }
}

} // namespace

void forget_limits(const SetView& v) {
    for (std::size_t i = 0; i < v.limit_count; ++i) v.limits[i].impulse[0] = v.limits[i].impulse[1] = 0;
}

void begin_limits(const SetView& v) {
    for (std::size_t i = 0; i < v.limit_count; ++i) {
        DirectLimit& limit = v.limits[i];
        limit.response = 0;
        if (const double impulse = limit.impulse[0] - limit.impulse[1]; impulse != 0)
            apply(v, limit, row_of(v, limit), impulse);
    }
}

void hold_limits(const SetView& v, double rate, double h) { hold_all(v, rate, h, true); }

void hold_limits_for_now(const SetView& v, double rate, double h) {
    for (std::size_t i = 0; i < v.limit_count; ++i) std::copy_n(v.limits[i].impulse, 2, v.limits[i].kept);
    hold_all(v, rate, h, false);
    for (std::size_t i = 0; i < v.limit_count; ++i) std::copy_n(v.limits[i].kept, 2, v.limits[i].impulse);
}

void count_limits(const SetView& v) {
    for (std::size_t i = 0; i < v.limit_count; ++i) {
        const DirectLimit& limit = v.limits[i];
        v.axes[limit.lane / 8].total[limit.lane % 8] += float(limit.impulse[0] - limit.impulse[1]);
    }
}

} // namespace cairn
