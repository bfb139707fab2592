#include "recording/readings.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <set>

namespace cairn::recording {

namespace {

// root_frame follows the convention of other programs, z up; in scene_frame y is up.
constexpr const char *root_frame = "world", *scene_frame = "scene";
const Quat y_to_z(0.70710678f, 0.70710678f, 0.0f, 0.0f);
constexpr double whole_interval = 1.0;  // Time between two messages with the poses of all bodies, s.
constexpr float arrow_of_weight = 0.5f; // Length of the arrow for a force that equals the mean weight of a body, m.
const Vec3 still_color(0.6f, 0.62f, 0.64f), force_color(1.0f, 0.62f, 0.08f);
// Distinguishable for color-blind people.
const Vec3 colors[] = {{0.25f, 0.56f, 0.85f}, {0.90f, 0.63f, 0.12f}, {0.44f, 0.85f, 0.78f},
                       {0.75f, 0.31f, 0.48f}, {0.95f, 0.89f, 0.35f}, {0.48f, 0.36f, 0.78f}};

bool is_same(const Transform& a, const Transform& b) { return a.position == b.position && a.rotation == b.rotation; }

std::string short_number(float value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.4g", double(value));
    return text;
}

// The name, with the slot number appended if it is empty or taken.
std::string distinct_name(std::string name, const char* kind, std::uint32_t slot, std::set<std::string>& taken) {
    if (name.empty() || !taken.insert(name).second) {
        name = (name.empty() ? kind : name) + " " + std::to_string(slot);
        while (!taken.insert(name).second) name += "'";
    }
    return name;
}

// Distinct names of joints, in the order of `World::joints`.
std::vector<std::string> joint_names(const World& world) {
    std::set<std::string> taken;
    std::vector<std::string> names;
    for (const JointId joint : world.joints())
        names.push_back(distinct_name(world.joint_def(joint).name, "joint", joint.index(), taken));
    return names;
}

} // namespace

ReadingsWriter::ReadingsWriter(McapWriter& file, const Readings& which, double interval) : interval_(interval) {
    const std::string theirs = foxglove_schemas(), ours = own_schemas();
    const auto channel = [&](std::optional<Channel>& to, bool is_wanted, const char* topic, const std::string& schema) {
        if (!is_wanted) return;
        const std::string& set = schema.starts_with("cairn.") ? ours : theirs;
        to = Channel{file.add_channel(file.add_schema(schema, "protobuf", set), topic, "protobuf")};
    };
    channel(poses_, which.poses, "/tf", "foxglove.FrameTransforms");
    channel(scene_, which.poses, "/scene", "foxglove.SceneUpdate");
    channel(contacts_, which.contacts, "/contacts", "foxglove.SceneUpdate");
    channel(joints_, which.joints, "/joints", "foxglove.JointStates");
    channel(loads_, which.joints, "/joint_loads", "cairn.JointLoads");
    channel(statistics_, which.statistics, "/statistics", "cairn.Statistics");
    channel(events_, which.events, "/events", "foxglove.Log");
}

void ReadingsWriter::send(McapWriter::Chunk& chunk, std::optional<Channel>& channel, const ProtoWriter& message) {
    chunk.add(channel->id, channel->sent++, now_, message.bytes());
}

bool ReadingsWriter::is_due(const World& world, double time) {
    if (time < next_time_ - 1e-9) return false;
    next_time_ = std::max(next_time_ + interval_, time); // intervals shorter than a step yield each step
    is_whole_ = time >= whole_time_;
    if (is_whole_) whole_time_ = time + whole_interval;
    std::vector<ShapeId> shapes;
    for (const BodyId id : world.bodies())
        if (const Body body = world.body(id); body.enabled())
            for (const ShapeId shape : body.shapes()) shapes.push_back(shape);
    if (shapes == shapes_ && frames_.size() == world.bodies().size()) return true;
    shapes_ = std::move(shapes);
    is_whole_ = true;
    find_frames(world);
    return true;
}

// Assigns distinct frame names to the current bodies.
void ReadingsWriter::find_frames(const World& world) {
    frames_.clear(), sent_.clear();
    std::set<std::string> taken{root_frame, scene_frame};
    for (const BodyId id : world.bodies())
        frames_.emplace(id, distinct_name(world.body(id).name(), "body", id.index(), taken));
}

std::string ReadingsWriter::frame_of(BodyId body) const {
    const auto found = frames_.find(body);
    return found == frames_.end() ? "body " + std::to_string(body.index()) : found->second;
}

ProtoWriter ReadingsWriter::scene(const World& world) const {
    ProtoWriter update, deletion;
    update.message(1, deletion.message(1, timestamp_message(now_)).number(2, 1)); // deletes all entities
    for (const auto& [id, frame] : frames_) {
        const Body body = world.body(id);
        EntityWriter entity(now_, frame, frame, true);
        const Vec3 color = body.type() == BodyType::dynamic ? colors[id.index() % std::size(colors)] : still_color;
        for (const ShapeId shape : body.shapes()) {
            const ShapeDef& def = world.shape_def(shape);
            if (!def.is_trigger && body.enabled())
                entity.add_shape(world.shape(shape), def.position, def.rotation, color);
        }
        update.message(2, entity.message());
    }
    return update;
}

ProtoWriter ReadingsWriter::poses(const World& world) {
    ProtoWriter transforms;
    if (is_whole_) transforms.message(1, transform_message(now_, root_frame, scene_frame, Position(0.0), y_to_z));
    for (const auto& [id, frame] : frames_) {
        const Transform pose = world.body(id).transform();
        const auto [known, is_new] = sent_.try_emplace(id, pose);
        if (!is_new && !is_whole_ && is_same(known->second, pose)) continue;
        known->second = pose;
        transforms.message(1, transform_message(now_, scene_frame, frame, pose.position, pose.rotation));
    }
    return transforms;
}

// Draws an arrow at each contact point, with a length proportional to its normal force.
ProtoWriter ReadingsWriter::contacts(const World& world, double step_length) const {
    double mass = 0.0;
    int count = 0;
    for (const BodyId id : world.bodies())
        if (const Body body = world.body(id); body.type() == BodyType::dynamic && std::isfinite(body.mass()))
            mass += double(body.mass()), ++count;
    const float gravity = std::max(glm::length(world.settings().gravity), 0.1f);
    const double weight = count > 0 && mass > 0.0 ? mass / count * double(gravity) : 1.0;
    EntityWriter arrows(now_, scene_frame, "contacts", false);
    for (const Contact& contact : world.contacts()) {
        // towards the dynamic body
        const float up = world.body(contact.body_b).type() == BodyType::dynamic ? 1.0f : -1.0f;
        for (int i = 0; i < contact.point_count; ++i) {
            const double force = double(contact.points[i].normal_impulse) / step_length;
            arrows.add_arrow(contact.points[i].point, contact.normal * (up * arrow_of_weight * float(force / weight)),
                             force_color);
        }
    }
    ProtoWriter update;
    return update.message(2, arrows.message());
}

ProtoWriter ReadingsWriter::statistics(const World& world) const {
    const Statistics now = world.statistics();
    ProtoWriter message;
    message.message(1, timestamp_message(now_)).number(2, now.bodies).number(3, now.awake_bodies);
    message.number(4, now.contacts).number(5, now.islands).real(6, world.kinetic_energy());
    return message.real(7, world.potential_energy()).real(8, now.max_penetration).real(9, now.times.total);
}

ProtoWriter ReadingsWriter::joints(const World& world) const {
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN(); // as Foxglove requires
    ProtoWriter message;
    message.message(1, timestamp_message(now_));
    std::size_t at = 0;
    const std::vector<std::string> names = joint_names(world);
    for (const JointId id : world.joints()) {
        const JointState state = world.joint_state(id);
        const std::string& name = names[at++];
        for (int i = 0; i < state.position_count; ++i) {
            ProtoWriter joint;
            joint.text(1, state.position_count > 1 ? name + " " + std::to_string(i + 1) : name);
            joint.real(2, double(state.positions[std::size_t(i)])).real(3, unknown).real(4, unknown).real(5, unknown);
            message.message(2, joint);
        }
    }
    return message;
}

ProtoWriter ReadingsWriter::loads(const World& world) const {
    ProtoWriter message;
    message.message(1, timestamp_message(now_));
    std::size_t at = 0;
    const std::vector<std::string> names = joint_names(world);
    for (const JointId joint : world.joints()) {
        const JointState state = world.joint_state(joint);
        ProtoWriter load;
        load.text(1, names[at++]).real(2, double(glm::length(state.force)));
        load.real(3, double(glm::length(state.torque))).real(4, double(state.linear_error));
        message.message(2, load);
    }
    return message;
}

void ReadingsWriter::log(McapWriter::Chunk& chunk, const std::string& text, bool is_warning) {
    ProtoWriter message;
    message.message(1, timestamp_message(now_)).number(2, is_warning ? 3 : 2).text(3, text).text(4, "cairn");
    send(chunk, events_, message);
}

void ReadingsWriter::add_events(McapWriter::Chunk& chunk, const World& world) {
    for (const ContactHit& hit : world.contact_hits())
        log(chunk, frame_of(hit.body_a) + " hits " + frame_of(hit.body_b) + " at " + short_number(hit.approach_speed) +
                       " m/s");
    for (const JointEvent& event : world.joint_events()) {
        const std::string joint = "joint " + std::to_string(event.joint.index());
        if (event.broke)
            log(chunk, joint + " breaks at " + short_number(event.force) + " N, " + short_number(event.torque) + " N m",
                true);
        else
            log(chunk, joint + " was removed with its body");
    }
    for (const TriggerEvent& event : world.trigger_events())
        log(chunk,
            frame_of(event.other_body) + (event.inside ? " comes into " : " leaves ") + frame_of(event.trigger_body));
    for (const SleepEvent& event : world.sleep_events())
        log(chunk, frame_of(event.body) + (event.asleep ? " falls asleep" : " wakes up"));
}

void ReadingsWriter::add(McapWriter::Chunk& chunk, const World& world, double time, double step_length) {
    now_ = std::uint64_t(std::llround(time * 1e9));
    const std::vector<ShapeId> before = shapes_;
    if (is_due(world, time)) {
        if (scene_ && before != shapes_) send(chunk, scene_, scene(world));
        if (poses_) send(chunk, poses_, poses(world));
        if (contacts_) send(chunk, contacts_, contacts(world, step_length));
        if (joints_) send(chunk, joints_, joints(world)), send(chunk, loads_, loads(world));
        if (statistics_) send(chunk, statistics_, statistics(world));
    }
    if (events_) add_events(chunk, world);
}

} // namespace cairn::recording
