#include "cli/trajectory_writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <set>
#include <utility>

namespace cairn::cli {

namespace {

constexpr std::array<std::string_view, 8> names_of_quantities{"position", "rotation", "velocity", "angular_velocity",
                                                              "energy",   "momentum", "contacts", "joints"};

bool has(const std::vector<Quantity>& quantities, Quantity quantity) {
    return std::find(quantities.begin(), quantities.end(), quantity) != quantities.end();
}

bool is_of_bodies(const std::vector<Quantity>& quantities) {
    return std::any_of(quantities.begin(), quantities.end(), [](Quantity q) { return q < Quantity::energy; });
}

void name_joints(const World& world, std::vector<Column>& columns) {
    std::set<std::string> taken;
    for (const JointId id : world.joints()) {
        std::string name = world.joint_def(id).name;
        if (name.empty()) name = "joint";
        const std::string first = name;
        for (int number = 2; !taken.insert(name).second; ++number) name = fmt::format("{}_{}", first, number);
        const int positions = world.joint_state(id).position_count;
        for (int i = 0; i < positions; ++i)
            columns.push_back(
                {name + (positions == 1 ? ".position" : fmt::format(".position{}", i + 1)), Column::Kind::real32});
        for (const char* of : {".force_x", ".force_y", ".force_z", ".torque_x", ".torque_y", ".torque_z"})
            columns.push_back({name + of, Column::Kind::real32});
    }
}

template <class Vector> void add_vector(TableWriter& table, const Vector& v) {
    for (int i = 0; i < 3; ++i) table.add(v[i]);
}

} // namespace

std::vector<std::string_view> quantity_names() { return {names_of_quantities.begin(), names_of_quantities.end()}; }

Quantity quantity_of(std::string_view name) {
    const auto found = std::find(names_of_quantities.begin(), names_of_quantities.end(), name);
    return static_cast<Quantity>(found - names_of_quantities.begin());
}

std::vector<Column> TrajectoryWriter::columns(const World& world, const std::vector<Quantity>& quantities) {
    std::vector<Column> columns{{"time", Column::Kind::real64}};
    const auto add = [&](Quantity quantity, Column::Kind kind, std::vector<std::string> names) {
        if (!has(quantities, quantity)) return;
        for (std::string& name : names) columns.push_back({std::move(name), kind});
    };
    if (is_of_bodies(quantities)) {
        columns.push_back({"body", Column::Kind::integer});
        columns.push_back({"name", Column::Kind::text});
    }
    add(Quantity::position, Column::Kind::real64, {"px", "py", "pz"});
    add(Quantity::rotation, Column::Kind::real32, {"qx", "qy", "qz", "qw"});
    add(Quantity::velocity, Column::Kind::real32, {"vx", "vy", "vz"});
    add(Quantity::angular_velocity, Column::Kind::real32, {"wx", "wy", "wz"});
    add(Quantity::energy, Column::Kind::real64, {"kinetic", "potential"});
    add(Quantity::momentum, Column::Kind::real64, {"mx", "my", "mz", "lx", "ly", "lz"});
    add(Quantity::contacts, Column::Kind::integer, {"contacts", "contact_points"});
    add(Quantity::contacts, Column::Kind::real64, {"max_penetration"});
    if (has(quantities, Quantity::joints)) name_joints(world, columns);
    return columns;
}

TrajectoryWriter::TrajectoryWriter(const std::filesystem::path& path, const World& world,
                                   const std::vector<Quantity>& quantities, const TableStart& start)
    : quantities_(quantities), table_(path, columns(world, quantities), start) {
    if (is_of_bodies(quantities)) bodies_ = world.bodies();
    for (const BodyId id : bodies_) names_.push_back(world.body(id).name());
    if (!shows(Quantity::joints)) return;
    for (const JointId id : world.joints()) joints_.push_back({id, world.joint_state(id).position_count});
}

bool TrajectoryWriter::shows(Quantity quantity) const { return has(quantities_, quantity); }

void TrajectoryWriter::add_body(const World& world, std::size_t index) {
    const Body body = world.body(bodies_[index]);
    table_.add(static_cast<std::int64_t>(index));
    table_.add(names_[index]);
    if (shows(Quantity::position)) add_vector(table_, body.position());
    if (shows(Quantity::rotation)) {
        const Quat q = body.rotation();
        for (const float part : {q.x, q.y, q.z, q.w}) table_.add(part);
    }
    if (shows(Quantity::velocity)) add_vector(table_, body.linear_velocity());
    if (shows(Quantity::angular_velocity)) add_vector(table_, body.angular_velocity());
}

TrajectoryWriter::Shared TrajectoryWriter::shared(const World& world) const {
    Shared result;
    if (shows(Quantity::energy)) {
        result.kinetic = world.kinetic_energy();
        result.potential = world.potential_energy();
    }
    if (shows(Quantity::momentum)) {
        result.momentum = world.linear_momentum();
        result.angular_momentum = world.angular_momentum();
    }
    if (shows(Quantity::contacts)) result.statistics = world.statistics();
    for (const Watched& watched : joints_) {
        JointState state;
        constexpr float none = std::numeric_limits<float>::quiet_NaN();
        state.force = state.torque = {none, none, none};
        state.positions.fill(none);
        result.joints.push_back(world.is_valid(watched.joint) ? world.joint_state(watched.joint) : state);
    }
    return result;
}

void TrajectoryWriter::add_shared(const Shared& shared) {
    if (shows(Quantity::energy)) {
        table_.add(shared.kinetic);
        table_.add(shared.potential);
    }
    if (shows(Quantity::momentum)) {
        add_vector(table_, shared.momentum);
        add_vector(table_, shared.angular_momentum);
    }
    if (shows(Quantity::contacts)) {
        table_.add(static_cast<std::int64_t>(shared.statistics.contacts));
        table_.add(static_cast<std::int64_t>(shared.statistics.contact_points));
        table_.add(shared.statistics.max_penetration);
    }
    for (std::size_t k = 0; k < joints_.size(); ++k) {
        const JointState& state = shared.joints[k];
        for (int i = 0; i < joints_[k].positions; ++i) table_.add(state.positions[static_cast<std::size_t>(i)]);
        add_vector(table_, state.force);
        add_vector(table_, state.torque);
    }
}

void TrajectoryWriter::add(const World& world) {
    const Shared all = shared(world);
    const std::size_t rows = is_of_bodies(quantities_) ? bodies_.size() : 1;
    for (std::size_t i = 0; i < rows; ++i) {
        table_.add(world.time());
        if (!bodies_.empty()) add_body(world, i);
        add_shared(all);
        table_.end_row();
    }
    table_.flush();
}

} // namespace cairn::cli
