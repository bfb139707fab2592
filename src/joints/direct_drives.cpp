// Drives, friction and soft limits of directly solved joints. A drive that is a separate row acts on the two bodies of
// its joint alone: where these are light compared to the bodies attached to them, its impulse turns them by far too
// much, and the joints pass that on. Drives are therefore rows of the joint system, each with the softness of its
// spring. Their Jacobians and positions are those of the axis blocks (kernels/solve/joint_axis.cpp).
#include "joints/direct_view.h"

#include <algorithm>
#include <limits>

namespace cairn {

using math::DVec3;

namespace {

// m/s or rad/s: a drive whose speed falls short by less stays at its bound.
constexpr double settled = 1e-9;

// Selects the nearer bound of a soft limit. A limit with zero impulse starts inactive.
void choose_limit(DirectDrive& d, double position, double impulse) {
    const double all = std::numeric_limits<double>::infinity();
    const bool is_lower = position - d.lower < d.upper - position;
    d.target_position = is_lower ? d.lower : d.upper;
    d.least = is_lower ? 0 : -all, d.most = is_lower ? all : 0;
    d.bound = impulse != 0 ? 0 : is_lower ? -1 : 1;
}

// Limits a motor's velocity to what reaches the rigid limits of its axis: as an equation, the motor would resist them.
double motor_velocity(const DirectDrive& d, double position, double h) {
    const double least = std::min((d.least_position - position) / h, fastest_return),
                 most = std::max((d.most_position - position) / h, -fastest_return);
    return std::clamp(d.target_velocity, least, most);
}

} // namespace

double refresh_from_lane(const SetView& v, std::size_t node) {
    DirectRow& row = v.rows[node];
    const AxisBlock& b = v.axes[row.drive.lane / 8];
    const std::size_t lane = row.drive.lane % 8;
    const auto block_of = [&](const float(*p)[8]) {
        return math::row_block({double(p[0][lane]), double(p[1][lane]), double(p[2][lane])});
    };
    row.is_plain = false;
    row.linear = block_of(b.linear_b);
    row.angular[0] = block_of(b.angular_a), row.angular[1] = block_of(b.angular_b);
    row.arm_a = row.arm_b = row.error = {};
    return double(b.position[lane]);
}

void refresh_drive(const SetView& v, std::size_t node, double h) {
    DirectDrive& d = v.rows[node].drive;
    const AxisBlock& b = v.axes[d.lane / 8];
    const std::size_t lane = d.lane % 8;
    if (!v.set.nodes[node].is_driven) refresh_from_lane(v, node);
    const double position = double(b.position[lane]);
    d.compliance = 0, d.pull = motor_velocity(d, position, h);
    if (d.is_rigid) return;
    const bool is_range = v.set.nodes[node].rows == DirectRows::soft_limit && d.lower < d.upper;
    if (is_range) choose_limit(d, position, d.impulse);
    const double missing = d.target_position - position;
    if (is_range && (d.most > 0 ? missing < 0 : missing > 0)) {
        d.pull = missing / h; // not reached: the position may go no farther than the bound
        return;
    }
    const double unit = d.is_relative ? double(b.moved_mass[lane]) : 1, k = unit * d.stiffness, c = unit * d.damping;
    d.compliance = 1 / (h * (h * k + c));
    d.pull = d.compliance * h * (k * missing + c * d.target_velocity);
}

void aim_driven_turn(DirectRow& row) {
    row.angular[1] = row.drive.bound == 0 ? math::identity_block() : math::across_block(row.axis);
    row.angular[0] = -row.angular[1];
}

double lack_of_drive(const DirectDrive& d, double velocity) {
    return d.pull - d.compliance * (d.impulse + d.given) - velocity;
}

bool bound_drive(DirectDrive& d, double velocity, double& change) {
    const double all = d.impulse + d.given;
    change = 0;
    if (d.bound != 0) {
        if (!(d.bound * lack_of_drive(d, velocity) < -settled)) return false;
        d.bound = 0;
        return true;
    }
    if (!(all > d.most || all < d.least)) return false;
    d.bound = all > d.most ? 1 : -1;
    change = (d.bound == 1 ? d.most : d.least) - all;
    d.given += change;
    return true;
}

} // namespace cairn
