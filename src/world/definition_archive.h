// Serialization of user definitions (joints, shapes, materials, force fields, events), member by member rather than as
// raw memory: padding between members and the storage of an empty optional contain arbitrary bytes, and two equal
// worlds must save equal bytes.
#pragma once

#include "core/archive.h"
#include "core/fields.h"
#include "core/set_aside.h"
#include "state/state.h"
#include "world/impl.h"

#include <cairn/world.h>

#include <optional>
#include <type_traits>
#include <variant>
#include <vector>

namespace cairn {

// Fails to compile when a struct that is archived member by member gains or loses a member.
#define CAIRN_ARCHIVES_MEMBERS(count, type)                                                                            \
    static_assert(class_field_count<type>() == (count), #type " has another member: archive it here, and count it")

// Handles are saved without their world number, so that the same run gives the same bytes in any world.
template <class Tag> Handle<Tag> without_world(Handle<Tag> id) {
    return Handle<Tag>::make(id.index(), id.generation(), 0);
}
template <class Tag> void name_world(Handle<Tag>& id, std::uint32_t world) {
    if (!id.is_null()) id = Handle<Tag>::make(id.index(), id.generation(), world);
}

// --- Joints.

#define CAIRN_DEFINED(count, type, ...)                                                                                \
    CAIRN_ARCHIVES_MEMBERS(count, type);                                                                               \
    template <class F> void for_members([[maybe_unused]] type& d, [[maybe_unused]] F&& f) { __VA_ARGS__; }

CAIRN_DEFINED(3, JointSpring, f(d.stiffness), f(d.damping), f(d.is_acceleration))
CAIRN_DEFINED(3, JointRange, f(d.lower), f(d.upper), f(d.spring))
CAIRN_DEFINED(4, JointMotor, f(d.velocity), f(d.position), f(d.spring), f(d.max_force))
CAIRN_DEFINED(3, JointControl, f(d.limits), f(d.motor), f(d.friction))
CAIRN_DEFINED(0, FixedJoint)
CAIRN_DEFINED(3, BallJoint, f(d.cone_angle), f(d.twist), f(d.friction))
CAIRN_DEFINED(1, HingeJoint, f(d.angle))
CAIRN_DEFINED(1, SliderJoint, f(d.translation))
CAIRN_DEFINED(2, CylindricalJoint, f(d.translation), f(d.angle))
CAIRN_DEFINED(2, UniversalJoint, f(d.first), f(d.second))
CAIRN_DEFINED(1, DistanceJoint, f(d.distance))
CAIRN_DEFINED(3, WheelJoint, f(d.suspension), f(d.steering), f(d.spin))
CAIRN_DEFINED(6, ServoJoint, f(d.position), f(d.rotation), f(d.linear), f(d.angular), f(d.max_force), f(d.max_torque))
CAIRN_DEFINED(1, GearJoint, f(d.ratio))
CAIRN_DEFINED(1, RackJoint, f(d.radius))
CAIRN_DEFINED(4, PulleyJoint, f(d.ground_a), f(d.ground_b), f(d.ratio), f(d.length))
CAIRN_DEFINED(6, JointLimit, f(d.kind), f(d.axes), f(d.min), f(d.max), f(d.stiffness), f(d.damping))
CAIRN_DEFINED(8, JointDrive, f(d.kind), f(d.is_acceleration), f(d.axis), f(d.max_force), f(d.position_target),
              f(d.velocity_target), f(d.stiffness), f(d.damping))
CAIRN_DEFINED(2, GeneralJoint, f(d.limits), f(d.drives))
#undef CAIRN_DEFINED

// Archives a value and, recursively, its members.
template <class Archive> struct DefinitionArchive {
    Archive& archive;

    template <class T> void operator()(T& value) {
        if constexpr (requires { for_members(value, *this); })
            for_members(value, *this);
        else
            archive(value);
    }
    template <class T> void operator()(std::optional<T>& value) {
        bool has_value = value.has_value();
        archive(has_value);
        if constexpr (Archive::reading) has_value ? void(value.emplace()) : value.reset();
        if (value) (*this)(*value);
    }
    template <class T> void operator()(std::vector<T>& values) {
        std::uint64_t count = values.size();
        archive(count);
        if constexpr (Archive::reading) values.clear();
        for (std::uint64_t i = 0; i < count; ++i) {
            // one at a time: a wrong count fails at the end of the bytes
            if constexpr (Archive::reading) values.emplace_back();
            (*this)(values[std::size_t(i)]);
        }
    }
};

// Sets the joint to the alternative with this index, counted from `I`. Returns whether there is such an alternative.
template <std::size_t I = 0> bool select_joint(Joint& joint, std::uint64_t index) {
    if constexpr (I < std::variant_size_v<Joint>) {
        if (index != I) return select_joint<I + 1>(joint, index);
        joint.emplace<I>();
        return true;
    }
    return false;
}

CAIRN_ARCHIVES_MEMBERS(12, JointDef);
template <class Archive> void serialize_joint_def(Archive& archive, JointDef& def, std::uint32_t world) {
    for (BodyId* id : {&def.body_a, &def.body_b}) {
        BodyId kept = without_world(*id);
        archive(kept);
        if constexpr (Archive::reading) name_world(*id = kept, world);
    }
    archive(def.enable_collision);
    for (Transform* frame : {&def.frame_a, &def.frame_b}) archive(frame->position), archive(frame->rotation);
    archive(def.break_force), archive(def.break_torque), archive(def.solver), archive(def.name), archive(def.user_data);
    archive(def.enabled);
    std::uint64_t kind = def.joint.index();
    archive(kind);
    if constexpr (Archive::reading)
        if (!select_joint(def.joint, kind))
            throw Error(ErrorCode::invalid_file, "Snapshot.definitions", std::to_string(kind), "is no kind of joint");
    std::visit([&](auto& joint) { DefinitionArchive<Archive>{archive}(joint); }, def.joint);
}

// --- Vectors of structs, archived as structs with the same members and no implicit padding.

CAIRN_ARCHIVES_MEMBERS(7, Material);
struct MaterialFields {
    float numbers[5];
    CombineRule friction_combine, restitution_combine;
    std::uint8_t padding[2];
};
inline MaterialFields fields_of(const Material& m) {
    return {{m.static_friction, m.dynamic_friction, m.restitution, m.rolling_friction, m.torsional_friction},
            m.friction_combine,
            m.restitution_combine,
            {}};
}
inline Material from_fields(const MaterialFields& f) {
    return {f.numbers[0], f.numbers[1],       f.numbers[2],         f.numbers[3],
            f.numbers[4], f.friction_combine, f.restitution_combine};
}

CAIRN_ARCHIVES_MEMBERS(9, ShapeDef);
struct ShapeDefFields {
    CollisionFilter filter;
    std::uint64_t user_data;
    math::Vec3 position;
    math::Quat rotation;
    float density;
    MaterialFields material;
    math::Vec3 surface_velocity;
    std::uint32_t is_trigger, padding;
    math::Vec3 one_way;
};
inline ShapeDefFields fields_of(const ShapeDef& d) {
    return {d.filter,  d.user_data,           to_math(d.position),         to_math(d.rotation),
            d.density, fields_of(d.material), to_math(d.surface_velocity), d.is_trigger ? 1u : 0u,
            0u,        to_math(d.one_way)};
}
inline ShapeDef from_fields(const ShapeDefFields& f) {
    return {to_public(f.position), to_public(f.rotation),         f.density,   from_fields(f.material), f.filter,
            f.is_trigger != 0,     to_public(f.surface_velocity), f.user_data, to_public(f.one_way)};
}

CAIRN_ARCHIVES_MEMBERS(12, ForceField);
struct ForceFieldFields {
    math::DVec3 center;
    math::Vec3 direction, half_extents;
    float strength, exponent, density, drag, skin_friction, added_mass, wave_damping;
    ForceField::Kind kind;
    std::uint8_t is_force, padding[2];
};
inline ForceFieldFields fields_of(const ForceField& f) {
    return {to_math(f.center),
            to_math(f.direction),
            to_math(f.half_extents),
            f.strength,
            f.exponent,
            f.density,
            f.drag,
            f.skin_friction,
            f.added_mass,
            f.wave_damping,
            f.kind,
            std::uint8_t(f.is_force),
            {}};
}
inline ForceField from_fields(const ForceFieldFields& f) {
    return {f.kind,
            to_public(f.direction),
            to_public(f.center),
            f.strength,
            f.exponent,
            f.is_force != 0,
            to_public(f.half_extents),
            f.density,
            f.drag,
            f.skin_friction,
            f.added_mass,
            f.wave_damping};
}

CAIRN_ARCHIVES_MEMBERS(4, ContactEnd);
inline ContactEnd fields_of(const ContactEnd& e) {
    return {without_world(e.shape_a), without_world(e.shape_b), without_world(e.body_a), without_world(e.body_b)};
}
inline ContactEnd from_fields(const ContactEnd& e) { return e; }

CAIRN_ARCHIVES_MEMBERS(6, TriggerEvent);
struct TriggerEventFields {
    ShapeId trigger, other;
    BodyId trigger_body, other_body;
    std::uint32_t inside;
    float time;
};
inline TriggerEventFields fields_of(const TriggerEvent& e) {
    return {without_world(e.trigger),
            without_world(e.other),
            without_world(e.trigger_body),
            without_world(e.other_body),
            e.inside,
            e.time};
}
inline TriggerEvent from_fields(const TriggerEventFields& f) {
    return {f.trigger, f.other, f.trigger_body, f.other_body, f.inside != 0, f.time};
}

CAIRN_ARCHIVES_MEMBERS(7, JointEvent);
struct JointEventFields {
    JointId joint;
    BodyId body_a, body_b;
    std::uint64_t broke;
    float force, torque;
    std::uint64_t user_data;
};
inline JointEventFields fields_of(const JointEvent& e) {
    return {without_world(e.joint),
            without_world(e.body_a),
            without_world(e.body_b),
            e.broke,
            e.force,
            e.torque,
            e.user_data};
}
inline JointEvent from_fields(const JointEventFields& f) {
    return {f.joint, f.body_a, f.body_b, f.broke != 0, f.force, f.torque, f.user_data};
}

CAIRN_ARCHIVES_MEMBERS(2, SleepEvent);
struct SleepEventFields {
    BodyId body;
    std::uint64_t asleep;
};
inline SleepEventFields fields_of(const SleepEvent& e) { return {without_world(e.body), e.asleep}; }
inline SleepEvent from_fields(const SleepEventFields& f) { return {f.body, f.asleep != 0}; }

template <class Archive, class T> void serialize_fields(Archive& archive, std::vector<T>& values) {
    if constexpr (std::is_same_v<Archive, SetAside>) {
        archive(values);
    } else {
        std::vector<decltype(fields_of(values[0]))> fields;
        if constexpr (!Archive::reading)
            for (const T& value : values) fields.push_back(fields_of(value));
        archive(fields);
        if constexpr (Archive::reading) {
            values.clear();
            for (const auto& f : fields) values.push_back(from_fields(f));
        }
    }
}

} // namespace cairn
