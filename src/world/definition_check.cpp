// Validation of the definitions of a snapshot.
#include "core/sound.h"
#include "world/joint_rules.h"
#include "world/state_check.h"
#include "world/validate.h"

#include <cmath>

namespace cairn {

namespace {

template <class... Values> bool are_finite(Values... values) { return (std::isfinite(values) && ...); }
bool is_finite(math::Vec3 v) { return are_finite(v.x, v.y, v.z); }

// A mass or moment of inertia and its inverse. An infinite value (inverse 0) means immovable.
bool are_inverse(float value, float inverse) {
    return value >= 0 && inverse >= 0 && std::isfinite(inverse) && (std::isfinite(value) || inverse == 0);
}

// Values that users pass to calls are validated there; these come from a file.
template <class T> void validate_definition(const char* list, std::size_t at, const T& value) {
    try {
        validate(value);
    } catch (const Error& error) {
        throw Error(ErrorCode::invalid_file, std::string("Snapshot.") + list + "[" + std::to_string(at) + "]", "",
                    error.what());
    }
}

void check_bodies(const Bodies& bodies, const CheckedDefinitions& definitions) {
    bodies.slots.check("bodies", bodies.dead);
    const std::size_t count = bodies.slots.size();
    require_count("bodies.mass", bodies.mass.size(), count);
    require_count("bodies.settings", bodies.settings.size(), count);
    require_count("bodies.names", definitions.names.size(), count);
    require_count("bodies.user_data", definitions.user_data.size(), count);
    std::size_t kinematic = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const BodySettings& own = bodies.settings[i];
        require_sound(own.own_type <= BodyType::dynamic && own.enabled <= 1, {"bodies", i, "own_type"},
                      int(own.own_type), "must be 0 to 2, and enabled or not");
        require_sound(own.type == (own.enabled ? own.own_type : BodyType::static_), {"bodies", i, "type"},
                      int(own.type), "must be the body's own type, or static if it is disabled");
        const BodyMass& mass = bodies.mass[i];
        const math::Vec3 moments = mass.inertia, inverse = mass.inverse_inertia;
        const math::Quat q = mass.principal;
        require_sound(is_finite(mass.center), {"bodies", i, "center"}, 0, "must be finite");
        require_sound(are_inverse(mass.mass, mass.inverse_mass) && are_inverse(moments.x, inverse.x) &&
                          are_inverse(moments.y, inverse.y) && are_inverse(moments.z, inverse.z),
                      {"bodies", i, "mass"}, 0, "must be >= 0, with a finite inverse; the inverse of infinity is 0");
        const float square = q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w;
        require_sound(square > 0.5f && square < 2, {"bodies", i, "principal"}, 0, "must be a unit quaternion");
        kinematic += bodies.slots.is_live(std::uint32_t(i)) && bodies.settings[i].type == BodyType::kinematic;
    }
    std::vector<std::uint8_t> listed(count);
    require_count("bodies.kinematic", bodies.kinematics.size(), kinematic);
    for (std::size_t k = 0; k < bodies.kinematics.size(); ++k) {
        const std::int32_t b = bodies.kinematics[k];
        require_sound(bodies.slots.is_live(std::uint32_t(b)) && bodies.settings[b].type == BodyType::kinematic &&
                          !listed[std::size_t(b)],
                      {"bodies.kinematic", k}, b, "must be a kinematic body, once");
        listed[std::size_t(b)] = 1;
    }
}

void check_shapes(const Shapes& shapes, const CheckedDefinitions& definitions) {
    shapes.slots.check("shapes", shapes.dead);
    const std::size_t count = shapes.slots.size();
    require_count("shapes.geometry", shapes.geometry.size(), count);
    require_count("shapes.materials", shapes.materials.size(), count);
    require_count("shapes.traits", shapes.traits.size(), count);
    require_count("shapes.definitions", definitions.shape_defs.size(), count);
    for (std::size_t i = 0; i < count; ++i) {
        const Geometry& g = shapes.geometry[i];
        require_sound(g.type <= ShapeType::height_field, {"shapes", i, "type"}, int(g.type), "must be a type of shape");
        require_sound(
            is_finite(g.size) && is_finite(g.middle) && is_finite(g.position) &&
                are_finite(g.bounding_radius, g.rounding, g.rotation.x, g.rotation.y, g.rotation.z, g.rotation.w),
            {"shapes", i, "geometry"}, 0, "must be finite");
    }
}

void check_joints(const Joints& joints, const CheckedDefinitions& definitions) {
    joints.slots.check("joints", {});
    const std::size_t count = joints.slots.size();
    require_count("joints.info", joints.info.size(), count);
    require_count("joints.axes", joints.axes.size(), count);
    require_count("joints.definitions", definitions.joint_defs.size(), count);
    for (std::size_t i = 0; i < count; ++i) {
        if (joints.slots.is_live(std::uint32_t(i))) validate_definition("joints", i, definitions.joint_defs[i]);
        for (const JointAxisRule& rule : joints.axes[i].rules) {
            require_sound(rule.kind <= AxisKind::pulley, {"joints", i, "kind"}, int(rule.kind),
                          "must be a kind of axis");
            require_sound(rule.column_a <= 2 && rule.column_b <= 2, {"joints", i, "column"},
                          std::max(rule.column_a, rule.column_b), "must be 0 to 2");
        }
    }
}

} // namespace

void check_definitions(const State& s, const CheckedDefinitions& definitions) {
    validate_definition("settings", 0, s.settings);
    check_bodies(s.bodies, definitions);
    check_shapes(s.shapes, definitions);
    check_joints(s.joints, definitions);
    s.fields.slots.check("fields", {});
    require_count("fields", s.fields.all.size(), s.fields.slots.size());
    for (std::size_t i = 0; i < s.fields.all.size(); ++i)
        if (s.fields.slots.is_live(std::uint32_t(i))) validate_definition("fields", i, s.fields.all[i]);
}

} // namespace cairn
