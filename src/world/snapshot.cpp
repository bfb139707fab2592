// Saving and restoring worlds.
#include "bodies/bodies.h"
#include "core/archive.h"
#include "core/fields.h"
#include "core/hash.h"
#include "core/image_archive.h"
#include "core/set_aside.h"
#include "world/definition_archive.h"
#include "world/impl.h"
#include "world/snapshot_header.h"
#include "world/state_archive.h"
#include "world/state_check.h"
#include "world/validate.h"

#include <cairn/world_number.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <mutex>
#include <type_traits>

namespace cairn {

namespace {

using Header = SnapshotHeader;

// Hashes the member counts of structs that are archived as raw memory: a new member may fit into padding without a
// change of size.
template <class... Plain> void add_field_counts(Hash64& hash) { (hash.add(field_count<Plain>()), ...); }

// A hash of the memory layouts that a snapshot depends on, so that a snapshot of another build is refused rather than
// misread.
std::uint64_t layout() {
    Hash64 hash;
    add_field_counts<BodyMotion, CountedPose, BodyMass, BodySettings, BodyForces, BodyLinks, ShapeLinks, ShapePose,
                     ContactRecord, ContactInfo, SeparationBudget, Island, JointInfo, JointAxisRule, JointAxisState,
                     Character>(hash);
    for (const std::size_t size : {sizeof(State), sizeof(BodyMotion), sizeof(CountedPose), sizeof(BodyMass),
                                   sizeof(ContactRecord), sizeof(ContactInfo), sizeof(SeparationBudget), sizeof(Island),
                                   sizeof(ShapePose), sizeof(Geometry), sizeof(ShapeDef), sizeof(WorldDef),
                                   sizeof(JointInfo), sizeof(JointAxes), sizeof(JointDef), sizeof(Character)})
        hash.add(size);
    return hash.value();
}

// --- Definitions, which steps do not change.

template <class Archive> void serialize_defined_joints(Archive& archive, Joints& joints) {
    struct Defined {
        math::DVec3 anchor_a, anchor_b, ground_a, ground_b;
        math::DQuat frame_a, frame_b;
    };
    std::vector<Defined> defined(joints.info.size());
    std::vector<std::array<JointAxisRule, max_joint_axes>> rules(joints.axes.size());
    if constexpr (!Archive::reading) {
        for (std::size_t i = 0; i < defined.size(); ++i) {
            const JointInfo& joint = joints.info[i];
            defined[i] = {joint.anchor_a, joint.anchor_b, joint.ground_a, joint.ground_b, joint.frame_a, joint.frame_b};
        }
        for (std::size_t i = 0; i < rules.size(); ++i)
            std::copy_n(joints.axes[i].rules, max_joint_axes, rules[i].begin());
    }
    archive(defined), archive(rules);
    if constexpr (Archive::reading) {
        joints.info.resize(defined.size()), joints.axes.resize(rules.size());
        for (std::size_t i = 0; i < defined.size(); ++i) {
            JointInfo& joint = joints.info[i];
            joint.anchor_a = defined[i].anchor_a, joint.anchor_b = defined[i].anchor_b;
            joint.ground_a = defined[i].ground_a, joint.ground_b = defined[i].ground_b;
            joint.frame_a = defined[i].frame_a, joint.frame_b = defined[i].frame_b;
        }
        for (std::size_t i = 0; i < rules.size(); ++i)
            std::copy_n(rules[i].begin(), max_joint_axes, joints.axes[i].rules);
    }
}

CAIRN_ARCHIVES_MEMBERS(12, WorldDef);
template <class Archive> void serialize_settings(Archive& archive, WorldDef& d) {
    archive(d.gravity), archive(d.substeps), archive(d.adaptive_substeps), archive(d.integrator);
    archive(d.enable_sleep), archive(d.sleep_speed), archive(d.sleep_time);
    archive(d.restitution_speed), archive(d.hit_speed), archive(d.recovery_speed);
    archive(d.max_linear_speed), archive(d.max_angular_speed);
}

#undef CAIRN_ARCHIVES_MEMBERS

template <class Archive, class Impl> void serialize_definitions(Archive& archive, Impl& impl) {
    State& s = impl.state;
    std::uint32_t world = s.bodies.slots.world();
    archive(world); // must be first: see least_world in snapshot_header.h
    if constexpr (Archive::reading) s.set_world(world);
    serialize_settings(archive, s.settings);
    s.bodies.slots.serialize(archive), s.shapes.slots.serialize(archive);
    s.joints.slots.serialize(archive), s.fields.slots.serialize(archive);
    archive(s.bodies.mass), archive(s.bodies.settings), archive(s.bodies.kinematics), archive(s.bodies.dead),
        archive(s.shapes.dead);
    archive(s.shapes.geometry), serialize_fields(archive, s.shapes.materials), archive(s.shapes.traits);
    serialize_fields(archive, s.fields.all);
    serialize_defined_joints(archive, s.joints);
    archive(impl.user_data), serialize_fields(archive, impl.def_of);
    impl.names.resize(s.bodies.slots.size());
    for (std::string& name : impl.names) archive(name);
    impl.joint_defs.resize(s.joints.slots.size());
    for (JointDef& def : impl.joint_defs) serialize_joint_def(archive, def, world);
}

bool is_same(const Sphere& a, const Sphere& b) { return a.radius == b.radius; }
bool is_same(const Box& a, const Box& b) { return a.half_extents == b.half_extents && a.rounding == b.rounding; }
bool is_same(const Plane& a, const Plane& b) {
    return a.normal == b.normal && a.tangent == b.tangent && a.half_extents == b.half_extents &&
           a.double_sided == b.double_sided;
}
bool is_same(const Capsule& a, const Capsule& b) {
    return a.half_height == b.half_height && a.radius == b.radius && a.radius_top == b.radius_top;
}
bool is_same(const Cylinder& a, const Cylinder& b) {
    return a.half_height == b.half_height && a.radius == b.radius && a.radius_top == b.radius_top &&
           a.rounding == b.rounding;
}
bool is_same(const Hull& a, const Hull& b) { return a.data() == b.data() && a.rounding == b.rounding; }
bool is_same(const Mesh& a, const Mesh& b) { return a.data() == b.data(); }
bool is_same(const HeightField& a, const HeightField& b) { return a.data() == b.data(); }
bool is_same(const Shape& a, const Shape& b) {
    return a.index() == b.index() &&
           std::visit([&](const auto& shape) { return is_same(shape, std::get<std::decay_t<decltype(shape)>>(b)); }, a);
}

} // namespace

void World::Impl::set_shapes(const std::vector<Shape>& shapes) {
    State& s = state;
    const auto damaged = [] {
        return Error(ErrorCode::invalid_file, "Snapshot.definitions", "", "has other shapes than its bytes state");
    };
    if (shapes.size() != s.shapes.geometry.size()) throw damaged();
    for (const Shape& shape : shapes) validate(shape);
    if (def_of.size() != shapes.size()) throw damaged();
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        if (!s.shapes.slots.is_live(std::uint32_t(i))) continue;
        const Geometry own = make_geometry(shapes[i], {Position(def_of[i].position), def_of[i].rotation});
        if (std::memcmp(&own, &s.shapes.geometry[i], sizeof own) != 0) throw damaged();
    }
    shape_of = shapes;
    s.shapes.data.clear();
    for (const Shape& shape : shapes) s.shapes.data.push_back(make_shape_data(shape));
}

std::unique_ptr<World::Impl> World::Impl::defined_by(const std::shared_ptr<const SnapshotDefinitions>& definitions,
                                                     const WorldDef& settings) {
    auto fresh = std::make_unique<Impl>(settings);
    ArchiveReader defined(definitions->bytes.data(), definitions->bytes.size());
    serialize_definitions(defined, *fresh);
    fresh->set_shapes(definitions->shapes);
    fresh->last_definitions = definitions;
    fresh->last_definitions_hash = hash_of(definitions->bytes);
    return fresh;
}

void World::Impl::restore_in_place(ImageReader& reader) {
    gather_records();
    state.contacts.owners = {};
    failed_call = "World::restore"; // until this function succeeds: memory may run out
    state.statistics = {};
    serialize_state(reader, state, [](StatePart) {});
    name_world_in_events(state);
    state.events.forget();
    ++state.joints.changes; // cached results about joints belong to the replaced state
    failed_call = nullptr;
}

template <class F> void World::Impl::restore_in_place(ArchiveReader& reader, F&& notify_listener) {
    gather_records();
    state.contacts.owners = {};
    const auto go_through = [&](SetAside::Mode mode) {
        set_aside.begin(mode);
        serialize_state(set_aside, state, [](StatePart) {});
    };
    const auto exchange = [&] { go_through(SetAside::Mode::exchange); };
    go_through(SetAside::Mode::make_room);
    const Statistics before = state.statistics;
    exchange();
    try {
        state.statistics = {};
        serialize_state(reader, state, [](StatePart) {});
        name_world_in_events(state);
        reader.end();
        check_state(state);
        state.bodies.pushed.reserve(state.bodies.forces.capacity()); // so that adding to it never allocates
    } catch (...) {
        exchange();
        state.statistics = before;
        throw;
    }
    if (listener) {
        const Statistics found = state.statistics;
        exchange();
        state.statistics = before;
        notify_listener();
        exchange();
        state.statistics = found;
    }
    state.events.forget();
    ++state.joints.changes;
}

void World::Impl::take_over(Impl& other) {
    if (other.failed_call) { // in the middle of a step, whose scratch memory is inconsistent
        step.thread_pool = std::move(other.step.thread_pool);
    } else {
        step = std::move(other.step);
        step.forget_world();
    }
    communicator = std::move(other.communicator);
    listener = std::move(other.listener);
    command_bytes = std::move(other.command_bytes);
}

std::shared_ptr<const SnapshotDefinitions> World::Impl::definitions() {
    const std::lock_guard lock(last_definitions_mutex);
    if (are_definitions_known) return last_definitions;
    auto now = std::make_shared<SnapshotDefinitions>();
    ArchiveWriter archive(now->bytes);
    serialize_definitions(archive, *this); // writing changes nothing
    const bool is_unchanged =
        last_definitions && last_definitions->bytes == now->bytes &&
        std::equal(shape_of.begin(), shape_of.end(), last_definitions->shapes.begin(), last_definitions->shapes.end(),
                   [](const Shape& a, const Shape& b) { return is_same(a, b); });
    if (!is_unchanged) {
        now->shapes = shape_of;
        last_definitions = std::move(now);
        last_definitions_hash = hash_of(last_definitions->bytes);
    }
    are_definitions_known = true;
    return last_definitions;
}

Snapshot World::save() const {
    impl_->require_idle("World::save");
    impl_->require_usable("World::save");
    impl_->gather_records();
    Snapshot snapshot;
    snapshot.definitions = impl_->definitions();
    Header header;
    const std::size_t last_size = impl_->last_snapshot_size;
    snapshot.bytes.reserve(last_size + last_size / 8); // avoids repeated reallocation
    snapshot.bytes.resize(sizeof header);
    ArchiveWriter archive(snapshot.bytes);
    std::size_t last = snapshot.bytes.size();
    std::array<std::uint64_t, 5> sizes{};
    serialize_state(archive, impl_->state, [&](StatePart part) { // writing changes nothing
        sizes[std::size_t(part)] = snapshot.bytes.size() - last;
        last = snapshot.bytes.size();
    });
    header.bodies = sizes[0], header.contacts = sizes[1], header.joints = sizes[2], header.broad_phase = sizes[3];
    header.magic = snapshot_magic;
    header.layout = layout();
    header.definitions = impl_->last_definitions_hash;
    header.checksum = checksum_of(header, snapshot.bytes);
    std::memcpy(snapshot.bytes.data(), &header, sizeof header);
    impl_->last_snapshot_size = snapshot.bytes.size();
    if (snapshot.bytes.capacity() > snapshot.bytes.size() + snapshot.bytes.size() / 4) snapshot.bytes.shrink_to_fit();
    return snapshot;
}

namespace {

Header read_header(const Snapshot& snapshot) {
    Header header;
    ArchiveReader(snapshot.bytes.data(), snapshot.bytes.size())(header);
    if (header.magic != snapshot_magic)
        throw Error(ErrorCode::invalid_file, "Snapshot", "", "does not begin like a snapshot");
    if (header.layout != layout())
        throw Error(ErrorCode::unsupported, "Snapshot", "", "was saved by another build of this library");
    return header;
}

} // namespace

SnapshotSizes Snapshot::sizes() const {
    const Header header = read_header(*this);
    SnapshotSizes sizes;
    sizes.bodies = std::size_t(header.bodies), sizes.contacts = std::size_t(header.contacts);
    sizes.joints = std::size_t(header.joints), sizes.broad_phase = std::size_t(header.broad_phase);
    sizes.other = bytes.size() - sizes.bodies - sizes.contacts - sizes.joints - sizes.broad_phase;
    if (definitions) sizes.definitions = definitions->bytes.size() + definitions->shapes.size() * sizeof(Shape);
    return sizes;
}

Snapshot without_world(const Snapshot& snapshot) {
    Snapshot result = snapshot;
    Header header = read_header(result);
    if (!snapshot.definitions || snapshot.definitions->bytes.size() < sizeof least_world) throw_damaged();
    auto renumbered = std::make_shared<SnapshotDefinitions>(*snapshot.definitions);
    std::memcpy(renumbered->bytes.data(), &least_world, sizeof least_world);
    header.definitions = hash_of(renumbered->bytes);
    header.checksum = checksum_of(header, result.bytes);
    std::memcpy(result.bytes.data(), &header, sizeof header);
    result.definitions = std::move(renumbered);
    return result;
}

void World::restore(const Snapshot& snapshot) {
    impl_->require_idle("World::restore");
    impl_->require_not_notifying("World::restore");
    Header header = read_header(snapshot);
    if (checksum_of(header, snapshot.bytes) != header.checksum) throw_damaged();
    const std::shared_ptr<const SnapshotDefinitions>& definitions = snapshot.definitions;
    const bool are_the_same = definitions && !impl_->failed_call && impl_->definitions() == definitions;
    if (!definitions ||
        (are_the_same ? impl_->last_definitions_hash : hash_of(definitions->bytes)) != header.definitions)
        throw Error(ErrorCode::invalid_file, "Snapshot.definitions", "", "do not match its bytes");
    ArchiveReader reader(snapshot.bytes.data() + sizeof header, snapshot.bytes.size() - sizeof header);
    const auto notify_listener = [&] { impl_->notify(commands::world_restore, snapshot); };
    if (are_the_same) return impl_->restore_in_place(reader, notify_listener);
    std::unique_ptr<Impl> fresh = Impl::defined_by(definitions, impl_->state.settings);
    check_definitions(fresh->state, {fresh->names, fresh->user_data, fresh->def_of, fresh->joint_defs});
    serialize_state(reader, fresh->state, [](StatePart) {});
    name_world_in_events(fresh->state);
    reader.end();
    check_state(fresh->state);
    notify_listener();
    fresh->take_over(*impl_);
    impl_ = std::move(fresh);
}

// Restores a state from a SnapshotRing.
void World::restore_image(const StateImage& image, const std::shared_ptr<const SnapshotDefinitions>& definitions) {
    ImageReader reader(image);
    if (!impl_->listener && !impl_->failed_call && impl_->definitions() == definitions)
        return impl_->restore_in_place(reader);
    World made;
    made.impl_ = Impl::defined_by(definitions, impl_->state.settings);
    serialize_state(reader, made.impl_->state, [](StatePart) {});
    name_world_in_events(made.impl_->state);
    if (impl_->listener) return restore(made.save());
    made.impl_->take_over(*impl_);
    impl_ = std::move(made.impl_);
}

} // namespace cairn
