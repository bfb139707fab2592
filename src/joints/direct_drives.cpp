// Drives of joints that are solved directly. A drive that is a row of its own sees the two bodies of its joint alone:
// where these are light beside what hangs on them, its impulse turns them by far too much, and the joints pass that on.
// So drives are rows among the equations, each with the softness of its spring (see solver_data of joints: AxisBlock).
#include "joints/direct_view.h"

#include <cmath>

namespace cairn {

using math::DVec3;

namespace {

// m/s or rad/s: what lacks less stays at its bound.
constexpr double settled = 1e-9;

} // namespace

void refresh_drive(const SetView& v, DirectRow& row, double h) {
    DirectDrive& d = row.drive;
    const AxisBlock& b = v.axes[d.lane / 8];
    const std::size_t lane = d.lane % 8;
    const auto block_of = [&](const float(*p)[8]) {
        return math::row_block({double(p[0][lane]), double(p[1][lane]), double(p[2][lane])});
    };
    row.is_plain = false;
    row.linear = block_of(b.linear_b);
    row.angular[0] = block_of(b.angular_a), row.angular[1] = block_of(b.angular_b);
    row.arm_a = row.arm_b = row.error = {};
    d.compliance = 0, d.pull = d.target_velocity;
    if (d.is_rigid) return;
    const double unit = d.is_relative ? double(b.mass[lane]) : 1, k = unit * d.stiffness, c = unit * d.damping;
    d.compliance = 1 / (h * (h * k + c));
    d.pull = d.compliance * h * (k * (d.target_position - double(b.position[lane])) + c * d.target_velocity);
}

double lack_of_drive(const DirectRow& row, double velocity) {
    return row.drive.pull - row.drive.compliance * (row.impulse.x + row.given.x) - velocity;
}

bool bound_drive(DirectRow& row, double velocity, double& change) {
    DirectDrive& d = row.drive;
    const double all = row.impulse.x + row.given.x, lack = lack_of_drive(row, velocity);
    change = 0;
    if (d.bound == 0) {
        if (!(std::fabs(all) > d.most)) return false;
        d.bound = all > 0 ? 1 : -1;
        change = d.bound * d.most - all;
        row.given.x += change;
        return true;
    }
    if (!(d.bound * lack < -settled)) return false;
    d.bound = 0;
    return true;
}

} // namespace cairn
