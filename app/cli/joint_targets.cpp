#include "cli/joint_targets.h"

#include "files/csv_reader.h"
#include "scene/gltf_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <utility>

namespace cairn::cli {

namespace {

constexpr double greatest_target = 1e6;  // rad or m, greatest magnitude in a table
constexpr double usual_frequency = 10.0; // Hz, default of servos

// The controls of a joint that can follow a table, in the order of its positions.
std::vector<JointControl*> controls_of(Joint& joint) {
    if (auto* hinge = std::get_if<HingeJoint>(&joint)) return {&hinge->angle};
    if (auto* slider = std::get_if<SliderJoint>(&joint)) return {&slider->translation};
    if (auto* universal = std::get_if<UniversalJoint>(&joint)) return {&universal->first, &universal->second};
    return {};
}

// The column names of a joint.
std::vector<std::string> axis_names(const JointDef& def) {
    Joint joint = def.joint;
    const std::size_t count = controls_of(joint).size();
    if (count < 2) return std::vector<std::string>(count, def.name);
    return {def.name + ".position1", def.name + ".position2"};
}

struct JointAxis {
    JointId joint;
    std::size_t number = 0;
};

std::optional<JointAxis> find_axis(const World& world, const std::string& column) {
    for (const char* ending : {"", ".position1", ".position2"}) {
        const std::size_t length = std::string_view(ending).size();
        if (column.size() < length || column.compare(column.size() - length, length, ending) != 0) continue;
        const std::optional<JointId> id = world.find_joint(column.substr(0, column.size() - length));
        if (!id) continue;
        const std::vector<std::string> names = axis_names(world.joint_def(*id));
        const auto found = std::find(names.begin(), names.end(), column);
        if (found != names.end()) return JointAxis{*id, static_cast<std::size_t>(found - names.begin())};
    }
    return std::nullopt;
}

// The mass, or the moment of inertia about an axis, of the bodies attached to each side of a joint; infinite if one of
// them is not dynamic.
class AttachedMass {
  public:
    AttachedMass(const World& world, JointAxis axis) : world_(world), joint_(axis.joint) {
        const JointDef& def = world.joint_def(joint_);
        const Body b = world.body(def.body_b.is_null() ? def.body_a : def.body_b);
        const Transform frame = def.body_b.is_null() ? def.frame_a : def.frame_b;
        anchor_ = b.position() + Position(b.rotation() * Vec3(frame.position));
        Quat rotation = b.rotation() * frame.rotation;
        if (std::holds_alternative<UniversalJoint>(def.joint) && axis.number == 0) {
            rotation = (def.body_a.is_null() ? Quat(1.0f, 0.0f, 0.0f, 0.0f) : world.body(def.body_a).rotation()) *
                       def.frame_a.rotation;
        }
        axis_ = glm::normalize(glm::dquat(rotation)) * glm::dvec3(axis.number == 0, axis.number == 1, 0.0);
        turns_ = !std::holds_alternative<SliderJoint>(def.joint);
    }

    // The reduced mass or inertia of both sides, which a motor between them accelerates.
    double reduced() const {
        const JointDef& def = world_.joint_def(joint_);
        return 1.0 / (1.0 / side(def.body_a, def.body_b) + 1.0 / side(def.body_b, def.body_a));
    }

  private:
    double side(BodyId first, BodyId other) const {
        std::set<std::uint64_t> seen;
        std::vector<BodyId> open{first};
        double sum = 0.0;
        while (!open.empty()) {
            const BodyId id = open.back();
            open.pop_back();
            if (id.is_null() || world_.body(id).type() != BodyType::dynamic) return infinite;
            if (id == other) continue; // a kinematic loop
            if (!seen.insert(id.bits).second) continue;
            sum += of_body(world_.body(id));
            for (const JointId next : world_.joints(id)) {
                if (next == joint_) continue;
                const JointDef& def = world_.joint_def(next);
                open.push_back(def.body_a == id ? def.body_b : def.body_a);
            }
        }
        return sum;
    }
    double of_body(const Body& body) const {
        const double mass = static_cast<double>(body.mass_properties().mass);
        if (!turns_) return mass;
        const glm::dvec3 arm = glm::cross(glm::dvec3(body.center_of_mass() - anchor_), axis_);
        return glm::dot(axis_, glm::dmat3(body.world_inertia()) * axis_) + mass * glm::dot(arm, arm);
    }

    static constexpr double infinite = std::numeric_limits<double>::infinity();
    const World& world_;
    JointId joint_;
    Position anchor_{};
    glm::dvec3 axis_{};
    bool turns_ = false;
};

void wake(World& world, JointId joint) {
    const JointDef& def = world.joint_def(joint);
    for (const BodyId id : {def.body_a, def.body_b}) {
        if (!id.is_null() && world.body(id).type() == BodyType::dynamic) return world.body(id).wake();
    }
}

std::string names_of_columns(const World& world) {
    std::string names;
    for (const JointId id : world.joints()) {
        if (world.joint_def(id).name.empty()) continue;
        for (const std::string& name : axis_names(world.joint_def(id))) {
            names += (names.empty() ? "" : ", ") + name;
            if (names.size() > 400) return names + ", ...";
        }
    }
    return names.empty() ? "none" : names;
}

} // namespace

TargetTable read_targets(std::string_view text, const std::string& file) {
    files::CsvReader reader(text, file);
    if (text.empty()) reader.fail("must have a first line: time, and names of joints");
    TargetTable table;
    table.names = reader.row();
    if (table.names[0] != "time") reader.fail(0, table.names[0], "must be named \"time\"");
    if (table.names.size() < 2) reader.fail("must name a joint after the time");
    std::set<std::string> seen;
    for (std::size_t i = 1; i < table.names.size(); ++i) {
        if (!seen.insert(table.names[i]).second) reader.fail(i, table.names[i], "must be named once only");
    }
    while (!reader.at_end()) {
        const std::vector<std::string> fields = reader.row();
        if (fields.size() == 1 && fields[0].empty()) continue;
        if (fields.size() != table.names.size()) {
            reader.fail(
                fmt::format("must have {} fields as the first line, has {}", table.names.size(), fields.size()));
        }
        const double time = reader.number(0, fields[0]);
        if (!table.times.empty() && !(time > table.times.back())) {
            reader.fail(0, fields[0], "must be a later time than that of the line before");
        }
        table.times.push_back(time);
        for (std::size_t i = 1; i < fields.size(); ++i) {
            const double value = reader.number(i, fields[i]);
            if (std::fabs(value) > greatest_target) reader.fail(i, fields[i], "must be within 1000000");
            table.values.push_back(value);
        }
    }
    if (table.times.empty()) reader.fail("must have a line of numbers after the first");
    table.names.erase(table.names.begin());
    return table;
}

JointTargets::JointTargets(const std::filesystem::path& path, scene::Scene& scene, std::optional<double> frequency)
    : start_(scene.world.time()) {
    const std::string file = path.generic_string();
    const std::vector<std::byte> bytes = scene::read_file(path);
    table_ = read_targets({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, file);
    for (std::size_t column = 0; column < table_.names.size(); ++column) {
        const std::string& name = table_.names[column];
        const std::string place = fmt::format("{}:1: column {}", file, column + 2);
        const std::optional<JointAxis> axis = find_axis(scene.world, name);
        if (!axis) {
            const bool is_other = scene.world.find_joint(name).has_value();
            throw Error(ErrorCode::invalid_file, place, "\"" + name.substr(0, 60) + "\"",
                        std::string(is_other ? "is another joint; must be" : "must be the name of") +
                            " a hinge, a slider or an axis of a universal joint (" + names_of_columns(scene.world) +
                            ")");
        }
        const JointId id = axis->joint;
        Joint joint = scene.world.joint_def(id).joint;
        JointControl* control = controls_of(joint)[axis->number];
        if (!control->motor) control->motor.emplace();
        JointMotor& motor = *control->motor;
        if (frequency || !motor.spring || !(motor.spring->stiffness > 0.0f)) {
            const double omega = 2.0 * 3.14159265358979324 * frequency.value_or(usual_frequency),
                         burden = AttachedMass(scene.world, *axis).reduced();
            double damping = motor.spring ? static_cast<double>(motor.spring->damping) : 0.0; // from the file
            if (motor.spring && motor.spring->is_acceleration) damping *= burden;
            motor.spring = JointSpring{static_cast<float>(burden * omega * omega),
                                       static_cast<float>(2.0 * burden * omega + damping), false};
        }
        Follower follower{id, axis->number, column, std::numeric_limits<double>::infinity(), 0.0, 0.0};
        follower.position = static_cast<double>(scene.world.joint_state(id).positions[axis->number]);
        for (const scene::JointSpeedLimit& limit : scene.speed_limits) {
            if (limit.joint == id) follower.speed = static_cast<double>(limit.speed);
        }
        motor.position = static_cast<float>(follower.position);
        motor.velocity = 0.0f;
        scene.world.set_joint(id, joint);
        followers_.push_back(follower);
    }
}

double JointTargets::target(std::size_t column, double time) const {
    const auto after = std::upper_bound(table_.times.begin(), table_.times.end(), time);
    const auto row = static_cast<std::size_t>(after - table_.times.begin());
    if (row == 0) return table_.value(0, column);
    if (row == table_.times.size()) return table_.value(row - 1, column);
    const double from = table_.times[row - 1], share = (time - from) / (table_.times[row] - from);
    return table_.value(row - 1, column) * (1.0 - share) + table_.value(row, column) * share;
}

std::vector<std::byte> JointTargets::save() const {
    std::vector<double> numbers;
    for (const Follower& follower : followers_) numbers.insert(numbers.end(), {follower.position, follower.velocity});
    const std::span<const std::byte> bytes = std::as_bytes(std::span<const double>(numbers));
    return {bytes.begin(), bytes.end()};
}

void JointTargets::restore(std::span<const std::byte> bytes, const std::string& place) {
    std::vector<double> numbers(2 * followers_.size());
    const std::span<std::byte> to = std::as_writable_bytes(std::span(numbers));
    if (bytes.size() != to.size()) {
        throw Error(ErrorCode::invalid_file, place + ": targets", fmt::format("{} bytes", bytes.size()),
                    fmt::format("must have {} bytes, for {} joints", to.size(), followers_.size()));
    }
    std::copy(bytes.begin(), bytes.end(), to.begin());
    for (std::size_t i = 0; i < followers_.size(); ++i)
        followers_[i].position = numbers[2 * i], followers_[i].velocity = numbers[2 * i + 1];
}

void JointTargets::apply(World& world, float time_step) {
    const double step = static_cast<double>(time_step), time = world.time() - start_ + step;
    for (Follower& follower : followers_) {
        if (!world.is_valid(follower.joint)) continue; // broken
        const double most = follower.speed * step;
        const double change = std::clamp(target(follower.column, time) - follower.position, -most, most);
        const double velocity = change / step;
        if (change == 0.0 && velocity == follower.velocity) {
            wake(world, follower.joint); // a sleeping body would report outdated joint forces
            continue;
        }
        follower.position += change;
        follower.velocity = velocity;
        Joint joint = world.joint_def(follower.joint).joint;
        JointMotor& motor = *controls_of(joint)[follower.axis]->motor;
        motor.position = static_cast<float>(follower.position);
        motor.velocity = static_cast<float>(velocity);
        world.set_joint(follower.joint, joint);
    }
}

} // namespace cairn::cli
