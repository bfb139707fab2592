// Creating and commanding characters.
#include "bodies/finalize.h"
#include "state/state.h"
#include "world/character_rules.h"
#include "world/impl.h"
#include "world/validate.h"

#include <cmath>

namespace cairn {

namespace {

// Ranges of CharacterDef: max_slope up to greatest_slope (rad), skin from least_skin to greatest_skin (m).
constexpr float greatest_slope = 1.57f, least_skin = 1e-4f, greatest_skin = 1.0f;
constexpr float greatest_length = 1e6f; // greatest step height and stick distance, m
constexpr float greatest_walk = 1e15f;  // greatest speed of a walking command, m/s

void require_within(std::string_view field, float value, float least, float most) {
    if (value >= least && value <= most) return;
    refuse(field, to_text(value), "must be from " + to_text(least) + " to " + to_text(most));
}

CharacterDef def_of(const Character& c) {
    CharacterDef def;
    def.up = to_public(c.up);
    def.max_slope = c.max_slope, def.step_height = c.step_height, def.stick_distance = c.stick_distance;
    def.skin = c.skin, def.mass = c.mass, def.max_push_force = c.max_push_force;
    def.air_acceleration = c.air_acceleration;
    def.flies = c.flies != 0;
    return def;
}

void define(Character& c, const CharacterDef& def) {
    c.up = math::to_float(math::normalized(math::to_double(to_math(def.up))));
    c.max_slope = def.max_slope, c.step_height = def.step_height, c.stick_distance = def.stick_distance;
    c.skin = def.skin, c.mass = def.mass, c.max_push_force = def.max_push_force;
    c.air_acceleration = def.air_acceleration;
    c.flies = def.flies;
}

Character& character_of(State& s, std::int32_t body, const char* call) {
    if (Character* found = find_character(s.characters, body)) return *found;
    throw Error(ErrorCode::wrong_state, call, "", "the body must be a character: set_character makes it one");
}

void require_speed(std::string_view field, float speed) {
    if (!(speed <= greatest_walk)) refuse(field, to_text(speed), "must be finite, and at most 1e15 m/s");
}

} // namespace

void validate(const CharacterDef& def) {
    require_finite("CharacterDef.up", def.up);
    if (!(math::length(math::to_double(to_math(def.up))) > 1e-30))
        refuse("CharacterDef.up", to_text(def.up), "must not be zero");
    require_within("CharacterDef.max_slope", def.max_slope, 0, greatest_slope);
    require_within("CharacterDef.step_height", def.step_height, 0, greatest_length);
    require_within("CharacterDef.stick_distance", def.stick_distance, 0, greatest_length);
    require_within("CharacterDef.skin", def.skin, least_skin, greatest_skin);
    require_within("CharacterDef.mass", def.mass, 0, largest_mass);
    require_at_least("CharacterDef.max_push_force", def.max_push_force, 0);
    require_at_least("CharacterDef.air_acceleration", def.air_acceleration, 0);
}

bool is_sound_character(const Character& c) {
    const double sum = (c.velocity.x + c.velocity.y + c.velocity.z) +
                       (c.ground_point.x + c.ground_point.y + c.ground_point.z) +
                       double(c.walk.x + c.walk.y + c.walk.z) + double(c.base.x + c.base.y + c.base.z) +
                       double(c.written.x + c.written.y + c.written.z) + double(c.jump_speed) +
                       double(c.ground_normal.x + c.ground_normal.y + c.ground_normal.z) +
                       double(c.ground_velocity.x + c.ground_velocity.y + c.ground_velocity.z);
    const float length = math::length(c.up);
    if (!std::isfinite(sum) || !(length > 0.99f && length < 1.01f) || c.flies > 1) return false;
    try {
        validate(def_of(c));
    } catch (const Error&) {
        return false;
    }
    return true;
}

#define CAIRN_CHARACTER(call)                                                                                          \
    World::Impl& impl = *world_->impl_;                                                                                \
    const std::int32_t b = impl.index_of(id_);                                                                         \
    Character& c = character_of(impl.state, b, call)

bool Body::is_character() const {
    World::Impl& impl = *world_->impl_;
    return find_character(impl.state.characters, impl.index_of(id_)) != nullptr;
}

CharacterDef Body::character() const {
    CAIRN_CHARACTER("Body::character");
    return def_of(c);
}

void Body::set_character(const CharacterDef& def) {
    World::Impl& impl = *world_->impl_;
    const std::int32_t b = impl.index_of(id_);
    World::Impl::Change change(impl, commands::body_set_character, id_, def);
    validate(def);
    State& s = impl.state;
    if (s.bodies.settings[b].own_type != BodyType::kinematic)
        throw Error(ErrorCode::wrong_state, "Body::set_character", "", "the body must be kinematic");
    change.begin();
    if (Character* found = find_character(s.characters, b)) return define(*found, def);
    Character c;
    c.body = b;
    c.velocity = math::to_double(s.bodies.motion[b].v);
    c.written = s.bodies.motion[b].v;
    define(c, def);
    const auto after = std::find_if(s.characters.all.begin(), s.characters.all.end(),
                                    [&](const Character& other) { return other.body > b; });
    s.characters.all.insert(after, c);
}

void Body::remove_character() {
    CAIRN_CHARACTER("Body::remove_character");
    World::Impl::Change change(impl, commands::body_remove_character, id_);
    change.begin();
    State& s = impl.state;
    s.characters.all.erase(s.characters.all.begin() + (&c - s.characters.all.data()));
    BodyMotion& motion = s.bodies.motion[b];
    motion.v = motion.w = motion.v_rest = motion.w_rest = {};
}

Vec3 Body::walk_velocity() const {
    CAIRN_CHARACTER("Body::walk_velocity");
    return to_public(c.walk);
}

void Body::set_walk_velocity(const Vec3& velocity) {
    require_finite("Body::set_walk_velocity", velocity);
    require_speed("Body::set_walk_velocity", math::length(to_math(velocity)));
    CAIRN_CHARACTER("Body::set_walk_velocity");
    World::Impl::Change change(impl, commands::body_set_walk_velocity, id_, velocity);
    change.begin();
    c.walk = to_math(velocity);
}

void Body::jump(float speed) {
    require_above("Body::jump speed", speed, 0);
    require_speed("Body::jump speed", speed);
    CAIRN_CHARACTER("Body::jump");
    World::Impl::Change change(impl, commands::body_jump, id_, speed);
    change.begin();
    c.jump_speed = speed;
}

CharacterState Body::character_state() const {
    CAIRN_CHARACTER("Body::character_state");
    CharacterState state;
    state.support = c.support;
    state.velocity = to_public(math::to_float(c.velocity));
    if (c.support == CharacterSupport::none) return state;
    if (c.ground_shape != none) {
        state.ground_shape = impl.state.shapes.slots.id(std::uint32_t(c.ground_shape));
        state.ground_body = impl.state.bodies.id(c.ground_body);
    }
    state.ground_point = to_public(c.ground_point);
    state.ground_normal = to_public(c.ground_normal);
    state.ground_velocity = to_public(c.ground_velocity);
    return state;
}

} // namespace cairn
