// Saving a world and bringing it back.
#include "core/archive.h"
#include "core/hash.h"
#include "world/impl.h"
#include "world/validate.h"

namespace cairn {

namespace {

constexpr std::uint64_t magic = 0x31306e7269616321ull; // "!cairn01"

// Layouts that a snapshot depends on: one from another build is refused rather than misread.
std::uint64_t layout() {
    Hash64 hash;
    for (const std::size_t size :
         {sizeof(State), sizeof(BodyMotion), sizeof(RestingPose), sizeof(BodyMass), sizeof(ContactRecord),
          sizeof(ContactInfo), sizeof(Island), sizeof(ShapePose), sizeof(Geometry), sizeof(ShapeDef), sizeof(WorldDef),
          sizeof(JointInfo), sizeof(JointAxes), sizeof(JointDef)})
        hash.add(size);
    return hash.value();
}

template <class Archive> void serialize_state(Archive& archive, State& s) {
    archive(s.world_id), archive(s.settings), archive(s.steps), archive(s.passes), archive(s.time);
    s.body_slots.serialize(archive);
    archive(s.motion), archive(s.mass), archive(s.body_settings), archive(s.forces), archive(s.bodies),
        archive(s.pushed);
    archive(s.resting), archive(s.left_at), archive(s.near), archive(s.strayed_at), archive(s.kinematics);
    s.shape_slots.serialize(archive);
    archive(s.geometry), archive(s.shape_poses), archive(s.shapes), archive(s.materials), archive(s.shape_traits);
    archive(s.records), archive(s.contacts), archive(s.free_contacts);
    archive(s.islands), archive(s.free_islands), archive(s.awake_islands);
    archive(s.falling_asleep), archive(s.waking);
    s.joint_slots.serialize(archive);
    archive(s.joints), archive(s.joint_axes);
    s.field_slots.serialize(archive);
    archive(s.fields), archive(s.dead_bodies), archive(s.dead_shapes);
    s.broad_phase.serialize(archive);
    archive(s.clamped_speeds), archive(s.statistics), archive(s.next_ends), archive(s.next_triggers),
        archive(s.next_joint_events), archive(s.next_sleeps);
}

template <class Archive, class T> void serialize_joint(Archive& archive, T& joint) { archive(joint); }
template <class Archive> void serialize_joint(Archive& archive, GeneralJoint& joint) {
    archive(joint.limits), archive(joint.drives);
}

// The alternative of that number, counted from `I`.
template <std::size_t I = 0> void select_joint(Joint& joint, std::size_t index) {
    if constexpr (I < std::variant_size_v<Joint>) {
        if (index == I)
            joint.emplace<I>();
        else
            select_joint<I + 1>(joint, index);
    } else {
        throw Error(ErrorCode::invalid_file, "Snapshot", "", "is damaged: a joint is of no kind");
    }
}

template <class Archive> void serialize_joint_def(Archive& archive, JointDef& def) {
    archive(def.body_a), archive(def.body_b), archive(def.frame_a), archive(def.frame_b), archive(def.enable_collision);
    archive(def.break_force), archive(def.break_torque), archive(def.solver), archive(def.name), archive(def.user_data);
    std::uint64_t kind = def.joint.index();
    archive(kind);
    if constexpr (Archive::reading) select_joint(def.joint, std::size_t(kind));
    std::visit([&](auto& joint) { serialize_joint(archive, joint); }, def.joint);
}

template <class Archive, class Impl> void serialize_all(Archive& archive, Impl& impl) {
    serialize_state(archive, impl.state);
    archive(impl.user_data), archive(impl.def_of);
    impl.names.resize(impl.state.body_slots.size());
    for (std::string& name : impl.names) archive(name);
    impl.joint_defs.resize(impl.state.joint_slots.size());
    for (JointDef& def : impl.joint_defs) serialize_joint_def(archive, def);
}

} // namespace

void World::Impl::set_shapes(const std::vector<Shape>& shapes) {
    State& s = state;
    const auto damaged = [] {
        return Error(ErrorCode::invalid_file, "Snapshot.shapes", "", "are not those of its bytes");
    };
    if (shapes.size() != s.geometry.size()) throw damaged();
    for (const Shape& shape : shapes) validate(shape);
    for (std::size_t i = 0; i < shapes.size(); ++i)
        if (s.shape_slots.is_live(std::uint32_t(i)) && make_geometry(shapes[i], {}).type != s.geometry[i].type)
            throw damaged();
    shape_of = shapes;
    s.shape_data.clear();
    for (const Shape& shape : shapes) s.shape_data.push_back(make_shape_data(shape));
}

Snapshot World::save() const {
    impl_->require_idle("World::save");
    impl_->require_whole("World::save");
    Snapshot snapshot;
    ArchiveWriter body(snapshot.bytes);
    body(magic);
    body(layout());
    body(std::uint64_t{0}); // checksum, below
    const std::size_t header = snapshot.bytes.size();
    serialize_all(body, *impl_); // a writer changes nothing
    snapshot.shapes = impl_->shape_of;
    Hash64 sum;
    sum.add_bytes(snapshot.bytes.data() + header, snapshot.bytes.size() - header);
    const std::uint64_t value = sum.value();
    std::memcpy(snapshot.bytes.data() + header - sizeof value, &value, sizeof value);
    return snapshot;
}

void World::restore(const Snapshot& snapshot) {
    impl_->require_idle("World::restore");
    ArchiveReader reader(snapshot.bytes.data(), snapshot.bytes.size());
    std::uint64_t found_magic = 0, found_layout = 0, checksum = 0;
    reader(found_magic), reader(found_layout), reader(checksum);
    if (found_magic != magic) throw Error(ErrorCode::invalid_file, "Snapshot", "", "does not begin as a snapshot does");
    if (found_layout != layout())
        throw Error(ErrorCode::unsupported, "Snapshot", "", "was saved by another build of this library");
    Hash64 sum;
    sum.add_bytes(snapshot.bytes.data() + (snapshot.bytes.size() - reader.bytes_left()), reader.bytes_left());
    if (sum.value() != checksum)
        throw Error(ErrorCode::invalid_file, "Snapshot", "", "is damaged: its checksum does not fit");
    auto fresh = std::make_unique<Impl>(impl_->state.settings);
    serialize_all(reader, *fresh);
    fresh->set_shapes(snapshot.shapes);
    fresh->state.crew = std::move(impl_->state.crew);
    impl_ = std::move(fresh);
}

} // namespace cairn
