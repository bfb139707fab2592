#include "character/move_characters.h"

#include "bodies/bodies.h"
#include "bodies/finalize.h"
#include "bodies/integrators.h"
#include "character/walk.h"
#include "islands/islands.h"

#include <algorithm>
#include <cmath>

namespace cairn {

using math::dot;
using math::DVec3;

namespace {

// The change of velocity that an impulse of 1 N s at a point gives there, both along `direction`, 1/kg.
double inverse_mass_at(const Bodies& bodies, std::int32_t b, DVec3 point, DVec3 direction) {
    const DVec3 turn = math::cross(point - bodies.motion[b].x, direction);
    const math::Sym3 i = world_inverse_inertia(bodies.motion[b], bodies.mass[b]);
    const math::DSym3 inverse{i.xx, i.xy, i.xz, i.yy, i.yz, i.zz};
    return double(bodies.mass[b].inverse_mass) + dot(turn, inverse * turn);
}

void push(const CharacterContext& c, std::int32_t b, DVec3 force, DVec3 point) {
    BodyForces& forces = c.bodies.forces[b];
    if (!forces.any) c.bodies.pushed.push_back(b);
    forces.any |= pushed_by_user;
    forces.force += force;
    forces.torque += math::cross(point - c.bodies.motion[b].x, force);
}

void wake(const CharacterContext& c, std::int32_t b) { wake_body(c.bodies, c.islands, c.events, b); }

// Applies the character's weight, and the impulse of landing or jumping off, to the body below it. A character that
// stands still lets that body sleep.
void press_ground(const CharacterContext& c, const Character& self, const Walk& walk, const Surroundings& around,
                  std::int32_t last_ground, DVec3 gravity, double dt) {
    if (last_ground != none && last_ground != self.ground_body && c.bodies.is_dynamic(last_ground))
        wake(c, last_ground);
    const auto on = walk.jumped_off() ? walk.jumped_off() : walk.ground();
    if (!on || !(self.mass > 0)) return;
    const Obstacle& o = around.obstacles()[*on];
    if (o.type != BodyType::dynamic) return;
    const DVec3 point = self.ground_point, up = math::to_double(self.up);
    const bool is_still = o.body == last_ground && math::length(walk.at()) < 1e-4 && !(walk.landing_speed() > 0);
    if (!is_still) wake(c, o.body);
    if (!is_awake(c.bodies, c.islands, o.body)) return;
    const double inverse = inverse_mass_at(c.bodies, o.body, point, up);
    const double impulse = walk.landing_speed() / (1 / double(self.mass) + inverse);
    push(c, o.body, double(self.mass) * gravity - (impulse / dt) * up, point);
}

void push_others(const CharacterContext& c, const Character& self, const Walk& walk, DVec3 origin, double dt) {
    for (const CharacterPush& p : walk.pushes()) {
        const DVec3 point = origin + p.point;
        const double inverse = inverse_mass_at(c.bodies, p.body, point, p.direction);
        if (!(inverse > 0)) continue;
        const double force = std::min(double(self.max_push_force), p.speed / (inverse * dt));
        wake(c, p.body);
        push(c, p.body, force * p.direction, point);
    }
}

// Gives the character's body the velocity with which the step moves it to its destination. The part of the displacement
// that is a correction (climbing a step, sticking to the ground) is applied before, so that nothing is hit with that
// speed.
void place(const CharacterContext& c, Character& self, const Walk& walk, double dt) {
    const std::int32_t b = self.body;
    BodyMotion& motion = c.bodies.motion[b];
    DVec3 way = within_numbers(walk.at()), slid = within_numbers(walk.slid());
    if (math::length(way) < 1e-7) way = slid = {};
    const bool is_corrected = math::length(way - slid) > 1e-7;
    math::Vec3 v = math::to_float(within_numbers((1 / dt) * (is_corrected ? slid : way))), w;
    if (self.ground_body != none && self.support == CharacterSupport::ground) {
        const math::Vec3 turn = c.bodies.motion[self.ground_body].w;
        w = math::dot(turn, self.up) * self.up;
    }
    clamp_velocity(c.settings, v, w);
    motion.v = v, motion.w = w;
    motion.v_rest = motion.w_rest = {};
    self.written = v;
    if (is_corrected) {
        wake_around(c.bodies, c.shapes, c.islands, c.broad_phase, c.events, b);
        motion.x += within_numbers(way - dt * math::to_double(v));
        update_proxies(c.bodies, c.shapes, c.broad_phase, b);
        wake_around(c.bodies, c.shapes, c.islands, c.broad_phase, c.events, b);
    } else {
        sweep_proxies(c.bodies, c.shapes, c.broad_phase, b);
    }
}

void move_character(const CharacterContext& c, std::size_t index, CharacterScratch& scratch, double dt) {
    Character& self = c.characters.all[index];
    const BodyMotion& motion = c.bodies.motion[self.body];
    if (!(motion.v == self.written)) { // the velocity was changed from outside
        self.velocity = math::to_double(motion.v);
        self.base = {};
        if (math::dot(motion.v, self.up) > 0) self.support = CharacterSupport::none;
    }
    const DVec3 gravity = within_numbers(pull_at(c.bodies, c.fields, c.settings, self.body));
    const double speed = math::length(self.velocity) + double(math::length(self.walk)) + double(self.jump_speed) +
                         double(math::length(self.base)) + dt * math::length(gravity);
    const double most = 1e12; // m
    const double reach = std::min(most, dt * (speed + double(c.settings.recovery_speed)) + double(self.step_height) +
                                            double(self.stick_distance) + 4 * double(self.skin));
    const CharacterInput input{c.settings, c.bodies, c.shapes, c.broad_phase, c.characters, dt};
    const DVec3 origin = motion.x;
    const std::int32_t last_ground = self.ground_body;
    Surroundings around(input, index, reach, scratch);
    Walk walk(around, self, gravity, double(c.settings.max_linear_speed), double(c.settings.recovery_speed), dt);
    walk.run();
    press_ground(c, self, walk, around, last_ground, gravity, dt);
    push_others(c, self, walk, origin, dt);
    place(c, self, walk, dt);
}

} // namespace

void move_characters(const CharacterContext& context, CharacterScratch& scratch, float dt) {
    for (std::size_t i = 0; i < context.characters.all.size(); ++i)
        if (context.bodies.is_enabled(context.characters.all[i].body)) move_character(context, i, scratch, double(dt));
}

} // namespace cairn
