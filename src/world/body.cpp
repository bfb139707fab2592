// Body: access to a single body of a world.
#include "bodies/bodies.h"
#include "bodies/finalize.h"
#include "contacts/pairs.h"
#include "islands/islands.h"
#include "joints/joints.h"
#include "math/rotation.h"
#include "state/joint_links.h"
#include "state/state.h"
#include "world/impl.h"
#include "world/validate.h"

#include <algorithm>
#include <limits>

namespace cairn {

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

// A body within a state.
struct Access {
    State& s;
    std::size_t b;
    std::int32_t index() const { return std::int32_t(b); }
    BodyType own_type() const { return s.bodies.settings[b].own_type; }
    BodyMotion& motion() const { return s.bodies.motion[b]; }
    BodyMass& mass() const { return s.bodies.mass[b]; }
};

void require_dynamic(const Access& a, const char* call) {
    if (a.own_type() != BodyType::dynamic) throw Error(ErrorCode::wrong_state, call, "", "the body must be dynamic");
}
void require_pushable(const Access& a, const char* call) {
    require_dynamic(a, call);
    if (!a.s.bodies.is_enabled(a.index())) throw Error(ErrorCode::wrong_state, call, "", "the body must be enabled");
}
// The forces on a body in the next step; registers the body as pushed.
BodyForces& pushed(const Access& a) {
    BodyForces& forces = a.s.bodies.forces[a.b];
    if (!forces.any) a.s.bodies.pushed.push_back(a.index());
    forces.any |= pushed_by_user;
    return forces;
}
void require_moving(const Access& a, const char* call) {
    if (a.own_type() == BodyType::static_)
        throw Error(ErrorCode::wrong_state, call, "", "a static body has no velocity");
}

// Adds a change of velocity, clamped to the maximum speed; clamped velocities are counted.
void add_velocity(const Access& a, math::DVec3 dv, math::DVec3 dw) {
    BodyMotion& m = a.motion();
    auto add = [](math::Vec3& v, math::DVec3 d, float most) {
        const math::DVec3 sum = math::to_double(v) + d;
        const double size = math::length(sum);
        if (size <= double(most)) {
            v = math::to_float(sum);
            return false;
        }
        v = std::isfinite(size) ? math::to_float((double(most) / size) * sum) : v;
        return true;
    };
    const bool linear = add(m.v, dv, a.s.settings.max_linear_speed);
    const bool angular = add(m.w, dw, a.s.settings.max_angular_speed);
    if (linear || angular) ++a.s.clamped_speeds;
    wake_body(a.s.bodies, a.s.islands, a.s.events, a.index());
    sweep_proxies(a.s.bodies, a.s.shapes, a.s.broad_phase, a.index());
}

math::DVec3 inverse_inertia_times(const Access& a, math::DVec3 v) {
    const math::Sym3 i = world_inverse_inertia(a.motion(), a.mass());
    const math::DSym3 d{i.xx, i.xy, i.xz, i.yy, i.yz, i.zz};
    return d * v;
}

} // namespace

#define CAIRN_ACCESS                                                                                                   \
    World::Impl& impl = *world_->impl_;                                                                                \
    const Access a{impl.state, std::size_t(impl.index_of(id_))};                                                       \
    [[maybe_unused]] State& s = a.s
#define CAIRN_CHANGE(call, ...)                                                                                        \
    CAIRN_ACCESS;                                                                                                      \
    World::Impl::Change change(impl, commands::call, id_ __VA_OPT__(, ) __VA_ARGS__)

BodyType Body::type() const {
    CAIRN_ACCESS;
    return a.own_type();
}
const std::string& Body::name() const {
    CAIRN_ACCESS;
    return impl.names[a.b];
}
std::uint64_t Body::user_data() const {
    CAIRN_ACCESS;
    return impl.user_data[a.b];
}
Position Body::position() const {
    CAIRN_ACCESS;
    return to_public(body_origin(s.bodies, a.index()));
}
Quat Body::rotation() const {
    CAIRN_ACCESS;
    return to_public(math::to_float(a.motion().q));
}
Transform Body::transform() const { return {position(), rotation()}; }
Position Body::center_of_mass() const {
    CAIRN_ACCESS;
    return to_public(a.motion().x);
}
Vec3 Body::linear_velocity() const {
    CAIRN_ACCESS;
    return to_public(a.motion().v);
}
Vec3 Body::angular_velocity() const {
    CAIRN_ACCESS;
    return to_public(a.motion().w);
}
Vec3 Body::velocity_at(const Position& point) const {
    CAIRN_ACCESS;
    require_position("Body::velocity_at point", point);
    const math::Vec3 arm = math::to_float(to_math(point) - a.motion().x);
    return to_public(a.motion().v + math::cross(a.motion().w, arm));
}
float Body::mass() const {
    CAIRN_ACCESS;
    return a.own_type() == BodyType::dynamic ? a.mass().mass : infinity;
}
MassProperties Body::mass_properties() const {
    CAIRN_ACCESS;
    const BodyMass& m = a.mass();
    return {m.mass, to_public(m.center), to_public(m.inertia), to_public(m.principal)};
}
Mat3 Body::world_inertia() const {
    CAIRN_ACCESS;
    const math::DSym3 i = cairn::world_inertia(a.motion(), a.mass());
    return Mat3(Vec3(i.xx, i.xy, i.xz), Vec3(i.xy, i.yy, i.yz), Vec3(i.xz, i.yz, i.zz));
}
Vec3 Body::angular_momentum() const {
    CAIRN_ACCESS;
    return to_public(math::to_float(cairn::world_inertia(a.motion(), a.mass()) * math::to_double(a.motion().w)));
}
double Body::kinetic_energy() const {
    CAIRN_ACCESS;
    return cairn::kinetic_energy(s.bodies, a.index());
}
float Body::gravity_scale() const {
    CAIRN_ACCESS;
    return s.bodies.settings[a.b].gravity_scale;
}
float Body::linear_damping() const {
    CAIRN_ACCESS;
    return s.bodies.settings[a.b].linear_damping;
}
float Body::angular_damping() const {
    CAIRN_ACCESS;
    return s.bodies.settings[a.b].angular_damping;
}
bool Body::is_awake() const {
    CAIRN_ACCESS;
    if (!s.bodies.is_enabled(a.index())) return false;
    if (s.bodies.is_dynamic(a.index())) return cairn::is_awake(s.bodies, s.islands, a.index());
    return !(a.motion().v == math::Vec3{} && a.motion().w == math::Vec3{});
}
bool Body::allow_sleep() const {
    CAIRN_ACCESS;
    return s.bodies.settings[a.b].allow_sleep;
}
bool Body::enabled() const {
    CAIRN_ACCESS;
    return s.bodies.is_enabled(a.index());
}
std::vector<ShapeId> Body::shapes() const {
    CAIRN_ACCESS;
    std::vector<ShapeId> ids;
    for (std::int32_t i = s.bodies.links[a.b].first_shape; i != none; i = s.shapes.links[i].next)
        ids.push_back(s.shapes.slots.id(std::uint32_t(i)));
    return ids;
}

namespace {

void move_body(const Access& a, math::DVec3 origin, const math::DQuat& rotation) {
    wake_around(a.s.bodies, a.s.shapes, a.s.islands, a.s.broad_phase, a.s.events, a.index());
    wake_body(a.s.bodies, a.s.islands, a.s.events, a.index());
    if (a.s.bodies.is_enabled(a.index())) wake_joined(a.s.bodies, a.s.islands, a.s.joints, a.s.events, a.index());
    set_pose(a.s.bodies, a.index(), origin, rotation);
    update_proxies(a.s.bodies, a.s.shapes, a.s.broad_phase, a.index());
    wake_around(a.s.bodies, a.s.shapes, a.s.islands, a.s.broad_phase, a.s.events, a.index());
}

} // namespace

void Body::set_transform(const Position& position, const Quat& rotation) {
    CAIRN_CHANGE(body_set_transform, position, rotation);
    require_position("Body::set_transform position", position);
    const Quat q = checked_rotation("Body::set_transform rotation", rotation);
    change.begin();
    move_body(a, to_math(position), math::to_double(to_math(q)));
}
void Body::set_position(const Position& position) {
    CAIRN_CHANGE(body_set_position, position);
    require_position("Body::set_position", position);
    change.begin();
    move_body(a, to_math(position), a.motion().q);
}
void Body::set_rotation(const Quat& rotation) {
    CAIRN_CHANGE(body_set_rotation, rotation);
    const Quat q = checked_rotation("Body::set_rotation", rotation);
    change.begin();
    move_body(a, body_origin(s.bodies, a.index()), math::to_double(to_math(q)));
}

void Body::set_linear_velocity(const Vec3& velocity) {
    CAIRN_CHANGE(body_set_linear_velocity, velocity);
    require_finite("Body::set_linear_velocity", velocity);
    require_moving(a, "Body::set_linear_velocity");
    change.begin();
    a.motion().v = to_math(velocity);
    a.motion().v_rest = {};
    if (clamp_velocity(s.settings, a.motion().v, a.motion().w)) ++s.clamped_speeds;
    wake_body(s.bodies, s.islands, s.events, a.index());
    sweep_proxies(s.bodies, s.shapes, s.broad_phase, a.index());
}
void Body::set_angular_velocity(const Vec3& velocity) {
    CAIRN_CHANGE(body_set_angular_velocity, velocity);
    require_finite("Body::set_angular_velocity", velocity);
    require_moving(a, "Body::set_angular_velocity");
    change.begin();
    a.motion().w = to_math(velocity);
    a.motion().w_rest = {};
    if (clamp_velocity(s.settings, a.motion().v, a.motion().w)) ++s.clamped_speeds;
    wake_body(s.bodies, s.islands, s.events, a.index());
    sweep_proxies(s.bodies, s.shapes, s.broad_phase, a.index());
}

void Body::move_to(const Transform& target, float seconds) {
    CAIRN_CHANGE(body_move_to, target, seconds);
    require_position("Body::move_to target.position", target.position);
    const Quat rotation = checked_rotation("Body::move_to target.rotation", target.rotation);
    require_above("Body::move_to seconds", seconds, 0);
    if (a.own_type() != BodyType::kinematic)
        throw Error(ErrorCode::wrong_state, "Body::move_to", "", "the body must be kinematic");
    const math::DQuat q = math::normalized(math::to_double(to_math(rotation)));
    const math::DVec3 x = to_math(target.position) + math::rotate(q, math::to_double(a.mass().center));
    const math::DVec3 turn = math::to_rotation_vector(q * math::conjugate(a.motion().q));
    change.begin();
    a.motion().v = math::to_float((1 / double(seconds)) * (x - a.motion().x));
    a.motion().w = math::to_float((1 / double(seconds)) * turn);
    if (clamp_velocity(s.settings, a.motion().v, a.motion().w)) ++s.clamped_speeds;
    sweep_proxies(s.bodies, s.shapes, s.broad_phase, a.index());
}

void Body::set_gravity_scale(float scale) {
    CAIRN_CHANGE(body_set_gravity_scale, scale);
    require_finite("Body::set_gravity_scale", scale);
    change.begin();
    s.bodies.settings[a.b].gravity_scale = scale;
    wake_body(s.bodies, s.islands, s.events, a.index());
}
void Body::set_damping(float linear, float angular) {
    CAIRN_CHANGE(body_set_damping, linear, angular);
    require_at_least("Body::set_damping linear", linear, 0);
    require_at_least("Body::set_damping angular", angular, 0);
    change.begin();
    s.bodies.settings[a.b].linear_damping = linear;
    s.bodies.settings[a.b].angular_damping = angular;
    wake_body(s.bodies, s.islands, s.events, a.index());
}
void Body::set_allow_sleep(bool allow) {
    CAIRN_CHANGE(body_set_allow_sleep, allow);
    change.begin();
    s.bodies.settings[a.b].allow_sleep = allow;
    wake_body(s.bodies, s.islands, s.events, a.index());
}

namespace {

// Turns the body into a static one without contacts, from the simulation's view: its contacts and joints end.
void leave_simulation(const Access& a) {
    State& s = a.s;
    wake_around(s.bodies, s.shapes, s.islands, s.broad_phase, s.events, a.index());
    wake_body(s.bodies, s.islands, s.events, a.index());
    for (std::int32_t i = s.bodies.links[a.b].first_shape; i != none; i = s.shapes.links[i].next)
        s.broad_phase.remove(std::uint32_t(i));
    update_pairs(s.bodies, s.shapes, s.contacts, s.islands, s.joints, s.broad_phase, s.events);
    for_each_joint(s.bodies, s.joints, a.index(),
                   [&](std::uint32_t joint, int) { deactivate_joint(s.bodies, s.islands, s.joints, s.events, joint); });
    if (s.bodies.is_dynamic(a.index())) remove_from_island(s.bodies, s.islands, a.index());
    std::erase(s.bodies.kinematics, a.index());
    s.bodies.settings[a.b].type = BodyType::static_;
}

// Gives the body its own type back unless it is disabled; its contacts are found at the next step.
void enter_simulation(const Access& a) {
    State& s = a.s;
    if (!s.bodies.is_enabled(a.index())) return;
    s.bodies.settings[a.b].type = a.own_type();
    if (a.own_type() == BodyType::dynamic) create_island(s.bodies, s.islands, a.index());
    for_each_joint(s.bodies, s.joints, a.index(),
                   [&](std::uint32_t joint, int) { activate_joint(s.bodies, s.islands, s.joints, s.events, joint); });
    if (a.own_type() == BodyType::kinematic) s.bodies.kinematics.push_back(a.index());
    a.motion().turned = {};
    for (std::int32_t i = s.bodies.links[a.b].first_shape; i != none; i = s.shapes.links[i].next)
        add_proxy(s.bodies, s.shapes, s.broad_phase, std::uint32_t(i));
    wake_around(s.bodies, s.shapes, s.islands, s.broad_phase, s.events, a.index());
}

} // namespace

void Body::set_type(BodyType type) {
    CAIRN_CHANGE(body_set_type, type);
    if (type > BodyType::dynamic) refuse("Body::set_type", std::to_string(int(type)), "must be one of the enumerators");
    if (a.own_type() == type) return;
    if (find_character(s.characters, a.index()))
        throw Error(ErrorCode::wrong_state, "Body::set_type", "",
                    "a character must stay kinematic: remove_character first");
    for (std::int32_t i = s.bodies.links[a.b].first_shape; i != none; i = s.shapes.links[i].next) {
        if (type == BodyType::dynamic && is_surface(s.shapes.geometry[i].type))
            throw Error(ErrorCode::wrong_state, "Body::set_type", "dynamic",
                        "a body with a plane, mesh or height field cannot be dynamic");
        if (type == BodyType::dynamic && s.shapes.traits[i].has_surface_velocity)
            throw Error(ErrorCode::wrong_state, "Body::set_type", "dynamic",
                        "a body with a surface velocity cannot be dynamic");
        if (type == BodyType::dynamic && s.shapes.traits[i].is_one_way)
            throw Error(ErrorCode::wrong_state, "Body::set_type", "dynamic",
                        "a body with a one-way shape cannot be dynamic");
    }
    change.begin();
    if (s.bodies.is_enabled(a.index())) leave_simulation(a);
    s.bodies.settings[a.b].own_type = type;
    if (type == BodyType::static_) a.motion().v = a.motion().w = {};
    refresh_mass(s.bodies, s.shapes, s.joints, a.index());
    place_shapes(s.bodies, s.shapes, a.index());
    enter_simulation(a);
}

void Body::set_enabled(bool enabled) {
    CAIRN_CHANGE(body_set_enabled, enabled);
    if (s.bodies.is_enabled(a.index()) == enabled) return;
    change.begin();
    if (enabled) {
        s.bodies.settings[a.b].enabled = 1;
        return enter_simulation(a);
    }
    leave_simulation(a);
    for (std::int32_t i = s.bodies.links[a.b].first_shape; i != none; i = s.shapes.links[i].next)
        forget_ground(s.characters, std::uint32_t(i));
    s.bodies.settings[a.b].enabled = 0;
    s.bodies.forces[a.b] = {};
    std::erase(s.bodies.pushed, a.index());
    for_each_joint(s.bodies, s.joints, a.index(), [&](std::uint32_t joint, int) {
        JointInfo& info = s.joints.info[joint];
        info.force = info.torque = {};
        info.substep_time = 0; // no warm start from impulses of before
    });
}

void Body::set_name(std::string_view name) {
    CAIRN_CHANGE(body_set_name, name);
    std::string own(name);
    change.begin();
    impl.names[a.b] = std::move(own);
}
void Body::set_mass_properties(const MassProperties& properties) {
    CAIRN_CHANGE(body_set_mass_properties, properties);
    validate("MassProperties", properties);
    require_dynamic(a, "Body::set_mass_properties");
    change.begin();
    a.mass().follows_shapes = 0;
    set_mass(s.bodies, s.joints, a.index(), properties);
    place_shapes(s.bodies, s.shapes, a.index());
    wake_body(s.bodies, s.islands, s.events, a.index());
}
void Body::set_mass_from_shapes(std::optional<float> mass) {
    CAIRN_CHANGE(body_set_mass_from_shapes, mass);
    if (mass) {
        MassProperties check;
        check.mass = *mass;
        validate("Body::set_mass_from_shapes", check);
    }
    require_dynamic(a, "Body::set_mass_from_shapes");
    change.begin();
    a.mass().follows_shapes = 1;
    a.mass().has_given_mass = mass.has_value();
    s.bodies.settings[a.b].given_mass = mass.value_or(0.0f);
    refresh_mass(s.bodies, s.shapes, s.joints, a.index());
    place_shapes(s.bodies, s.shapes, a.index());
    wake_body(s.bodies, s.islands, s.events, a.index());
}
void Body::wake() {
    CAIRN_CHANGE(body_wake);
    change.begin();
    wake_body(s.bodies, s.islands, s.events, a.index());
}

void Body::sleep() {
    CAIRN_CHANGE(body_sleep);
    change.begin();
    const bool may_sleep = s.settings.enable_sleep && s.bodies.is_dynamic(a.index());
    if (!may_sleep || !cairn::is_awake(s.bodies, s.islands, a.index())) return;
    BodyMotion& motion = a.motion();
    motion.v = motion.w = motion.v_rest = motion.w_rest = {};
    s.bodies.forces[a.b] = {};
    std::erase(s.bodies.pushed, a.index());
    if (s.bodies.links[a.b].quiet_time == sleep_requested) return;
    s.bodies.links[a.b].quiet_time = sleep_requested;
    s.islands.sleep_requests.push_back(a.index());
}

void Body::add_force(const Vec3& force) {
    CAIRN_CHANGE(body_add_force, force);
    require_finite("Body::add_force force", force);
    require_pushable(a, "Body::add_force");
    change.begin();
    pushed(a).force += math::to_double(to_math(force));
    wake_body(s.bodies, s.islands, s.events, a.index());
}
void Body::add_force_at(const Vec3& force, const Position& point) {
    CAIRN_CHANGE(body_add_force_at, force, point);
    require_finite("Body::add_force_at force", force);
    require_position("Body::add_force_at point", point);
    require_pushable(a, "Body::add_force_at");
    const math::DVec3 f = math::to_double(to_math(force));
    change.begin();
    pushed(a).force += f;
    pushed(a).torque += math::cross(to_math(point) - a.motion().x, f);
    wake_body(s.bodies, s.islands, s.events, a.index());
}
void Body::add_torque(const Vec3& torque) {
    CAIRN_CHANGE(body_add_torque, torque);
    require_finite("Body::add_torque torque", torque);
    require_pushable(a, "Body::add_torque");
    change.begin();
    pushed(a).torque += math::to_double(to_math(torque));
    wake_body(s.bodies, s.islands, s.events, a.index());
}
void Body::apply_impulse(const Vec3& impulse) {
    CAIRN_CHANGE(body_apply_impulse, impulse);
    require_finite("Body::apply_impulse impulse", impulse);
    require_pushable(a, "Body::apply_impulse");
    change.begin();
    add_velocity(a, double(a.mass().inverse_mass) * math::to_double(to_math(impulse)), {});
}
void Body::apply_impulse_at(const Vec3& impulse, const Position& point) {
    CAIRN_CHANGE(body_apply_impulse_at, impulse, point);
    require_finite("Body::apply_impulse_at impulse", impulse);
    require_position("Body::apply_impulse_at point", point);
    require_pushable(a, "Body::apply_impulse_at");
    const math::DVec3 p = math::to_double(to_math(impulse));
    change.begin();
    add_velocity(a, double(a.mass().inverse_mass) * p,
                 inverse_inertia_times(a, math::cross(to_math(point) - a.motion().x, p)));
}
void Body::apply_angular_impulse(const Vec3& impulse) {
    CAIRN_CHANGE(body_apply_angular_impulse, impulse);
    require_finite("Body::apply_angular_impulse impulse", impulse);
    require_pushable(a, "Body::apply_angular_impulse");
    change.begin();
    add_velocity(a, {}, inverse_inertia_times(a, math::to_double(to_math(impulse))));
}

} // namespace cairn
