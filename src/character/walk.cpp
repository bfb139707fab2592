#include "character/walk.h"

#include "math/rotation.h"

#include <algorithm>
#include <cmath>

namespace cairn {

using math::dot;
using math::DVec3;

namespace {

constexpr int max_hits = 24, max_recoveries = 4, recovery_rounds = 8;
// Share of the skin: surfaces at this distance or farther are not pushed away from. Casts end at the skin itself.
constexpr double kept_distance = 0.999;
// Cosines of the steepest contact normal at an edge of a walkable surface: for standing on it, and for landing on it.
constexpr double steepest_edge = 0.05, steepest_landing = 0.5;
constexpr double least_motion = 1e-7; // m

double cosine_of(double angle) {
    const double s = math::from_rotation_vector({angle, 0, 0}).x;
    return 1 - 2 * s * s;
}

} // namespace

Walk::Walk(Surroundings& around, Character& self, DVec3 gravity, double max_speed, double recovery_speed, double dt)
    : around_(around), self_(self), up_(math::to_double(self.up)), gravity_(gravity), max_speed_(max_speed),
      recovery_speed_(recovery_speed), dt_(dt), skin_(double(self.skin)),
      least_slope_(cosine_of(double(self.max_slope))) {}

void Walk::run() {
    recover();
    const DVec3 walk = math::to_double(self_.walk);
    if (self_.flies) {
        self_.support = CharacterSupport::none;
        velocity_ = walk, motion_ = dt_ * walk;
    } else if (finds_ground()) {
        start_on_ground();
    } else {
        if (self_.support == CharacterSupport::ground) self_.support = CharacterSupport::none; // the ground is gone
        start_in_air();
    }
    motion_ = within_numbers(motion_), velocity_ = within_numbers(velocity_);
    const double length = math::length(motion_), most = max_speed_ * dt_;
    if (length > most) motion_ = (most / length) * motion_;
    wanted_ = motion_;
    slide();
    if (ground_) stick();
    finish();
}

// --- Recovery from obstacles that are too near.

// Computes the displacement that restores the skin, and returns whether an obstacle is nearer than half the skin.
// Floors push straight up, so that a character does not creep down a slope.
bool Walk::push_out(DVec3& way) const {
    struct Lack {
        DVec3 normal, direction;
        double amount;
    };
    std::array<Lack, 32> lacks;
    std::size_t count = 0;
    bool is_deep = false;
    const double most = skin_ + recovery_speed_ * dt_;
    for (std::size_t i = 0; i < around_.obstacles().size() && count < lacks.size(); ++i) {
        const auto near = around_.gap(i, at_, 0, kept_distance * skin_);
        if (!near) continue;
        const double rise = dot(near->normal, up_);
        const bool is_floor = !self_.flies && rise >= least_slope_;
        lacks[count++] = {near->normal, is_floor ? (1 / rise) * up_ : near->normal,
                          std::min(skin_ - near->distance, most)};
        is_deep |= near->distance < 0.5 * skin_;
    }
    way = {};
    for (int round = 0; round < recovery_rounds; ++round)
        for (std::size_t i = 0; i < count; ++i)
            way += std::max(0.0, lacks[i].amount - dot(way, lacks[i].normal)) * lacks[i].direction;
    return is_deep;
}

void Walk::recover() {
    for (int round = 0; round < max_recoveries; ++round) {
        DVec3 way;
        const bool is_deep = push_out(way);
        if (!(math::length(way) > least_motion)) return;
        const auto hit = around_.cast(at_, 0, way, 0);
        at_ += (hit ? hit->fraction : 1) * way;
        if (!is_deep) return;
    }
}

// --- Ground.

// The motion along a slope with the same horizontal direction as the given one, and the given length.
DVec3 Walk::along_slope(DVec3 motion, DVec3 slope, double length) const {
    const DVec3 flat = level(motion), along = flat - (dot(slope, flat) / dot(slope, up_)) * up_;
    const double size = math::length(along);
    return size > 0 ? (length / size) * along : DVec3{};
}

// Whether the character can stand on a hit surface: it is not too steep, or it is an edge of a surface that is not.
// `least`: the least cosine at an edge.
std::optional<Walk::Footing> Walk::footing(const CharacterHit& hit, double least) const {
    const double rise = dot(hit.normal, up_);
    if (rise >= least_slope_) return Footing{hit.obstacle, hit.normal, hit.normal, hit.point};
    if (!(rise >= least)) return std::nullopt;
    const auto face = around_.face_at(hit, time_, up_);
    if (!face || !(dot(*face, up_) >= least_slope_)) return std::nullopt;
    return Footing{hit.obstacle, hit.normal, *face, hit.point};
}

// Whether an edge that the character touches with its round side is higher than a step.
bool Walk::is_too_high(const Footing& f) const {
    const double height = dot(f.point - at_, up_) - around_.lowest(up_) + skin_; // above its lowest point
    if (!(height > double(self_.step_height) + 1e-3 * around_.size())) return false;
    const auto face = around_.face_at({0, f.contact, f.point, f.obstacle}, time_, up_);
    return face && dot(*face, f.contact) < 0.999;
}

// Finds the ground below the character by moving it down, sliding along walls.
std::optional<Walk::Footing> Walk::drop(DVec3& at, double depth, double least) const {
    DVec3 way = -depth * up_;
    for (int hits = 0; hits < 4; ++hits) {
        const auto hit = around_.cast(at, time_, way, 0);
        if (!hit) return std::nullopt;
        at += hit->fraction * way;
        if (const auto found = footing(*hit, least)) return found;
        if (!(dot(hit->normal, up_) < steepest_edge)) return std::nullopt;
        way = (1 - hit->fraction) * way;
        way -= dot(way, hit->normal) * hit->normal;
    }
    return std::nullopt;
}

void Walk::stand_on(const Footing& f) {
    ground_ = f.obstacle;
    contact_normal_ = f.contact, slope_ = f.slope, contact_point_ = f.point;
    is_steep_ = false;
    planes_.clear();
    planes_.add({slope_, dot(slope_, carry())});
}

// Whether a dynamic body below the character falls faster than the character can follow, so that the character does not
// load it. Kinematic bodies start and stop abruptly, and are followed.
bool Walk::falls_away(const Obstacle& o) const {
    if (o.type != BodyType::dynamic) return false;
    const double fall = dot((1 / dt_) * o.ride, up_);
    if (self_.support != CharacterSupport::ground) return fall < dot(self_.velocity, up_) - 1e-6;
    const double most = std::min(0.0, dt_ * dot(gravity_, up_)); // the most that a standing character falls in a step
    return o.body == self_.ground_body && fall - dot(math::to_double(self_.ground_velocity), up_) < most - 1e-6;
}

// Finds the ground that the character stands on already, or has been placed on.
bool Walk::finds_ground() {
    const bool stood = self_.support == CharacterSupport::ground;
    const double depth = stood ? double(self_.stick_distance) + skin_ : 0.5 * skin_;
    DVec3 at = at_;
    const auto found = drop(at, depth, stood ? steepest_edge : steepest_landing);
    if (!found || falls_away(obstacle(found->obstacle))) return false;
    const double speed = dot(self_.velocity - (1 / dt_) * obstacle(found->obstacle).ride, found->contact);
    if (!stood && !(std::fabs(speed) <= 2 * dt_ * math::length(gravity_))) return false;
    stand_on(*found);
    return true;
}

void Walk::start_on_ground() {
    const DVec3 walk = level(math::to_double(self_.walk));
    if (self_.jump_speed > 0) {
        const DVec3 base = (1 / dt_) * carry();
        self_.base = math::to_float(within_numbers(level(base)));
        self_.velocity = base + walk + double(self_.jump_speed) * up_;
        self_.support = CharacterSupport::none;
        planes_.clear();
        const std::optional<std::size_t> left = ground_;
        ground_.reset();
        start_in_air();
        landing_speed_ = double(self_.jump_speed); // the body below feels the impulse of the jump
        jumped_off_ = left;
        return;
    }
    motion_ = carry() + along_slope(walk, slope_, dt_ * math::length(walk));
}

void Walk::start_in_air() {
    DVec3 change = math::to_double(self_.base) + level(math::to_double(self_.walk)) - level(self_.velocity);
    const double most = dt_ * double(self_.air_acceleration), size = math::length(change);
    if (size > most) change = (most / size) * change;
    if (self_.support == CharacterSupport::steep) { // steering does not lead up a steep slope
        const DVec3 out = level(math::to_double(self_.ground_normal));
        const double square = dot(out, out);
        if (square > 0) change -= (std::min(0.0, dot(change, out)) / square) * out;
    }
    velocity_ = self_.velocity + dt_ * gravity_ + change;
    const double speed = math::length(velocity_);
    if (speed > max_speed_) velocity_ = (max_speed_ / speed) * velocity_;
    motion_ = 0.5 * dt_ * (self_.velocity + velocity_);
}

// --- Motion.

void Walk::slide() {
    for (int hits = 0; hits < max_hits && time_ < 1; ++hits) {
        const double left = 1 - time_;
        const DVec3 way = left * motion_;
        const auto hit = around_.cast(at_, time_, way, left);
        const double part = hit ? hit->fraction : 1;
        at_ += part * way, slid_ += part * way;
        time_ = hit ? time_ + part * left : 1;
        if (!hit) return;
        if (part * math::length(way) > 1e-3 * around_.size()) {
            planes_.clear();
            if (ground_) planes_.add({slope_, dot(slope_, carry())});
        }
        meet(*hit);
    }
}

void Walk::meet(const CharacterHit& hit) {
    const Obstacle& met = obstacle(hit.obstacle);
    if (!self_.flies)
        if (const auto found = footing(hit, ground_ ? 1.0 : steepest_landing))
            if (!ground_ || !is_too_high(*found)) return land(*found);
    if (met.type == BodyType::dynamic) {
        note_push(hit);
        const bool is_ground = ground_ && obstacle(*ground_).body == met.body;
        if (!is_ground) around_.stop_approach(met.body, hit.normal);
    }
    if (ground_ && climb(hit)) return;
    slide_along(hit);
}

void Walk::land(const Footing& f) {
    const DVec3 own_carry = ride_on(obstacle(f.obstacle), f.slope);
    const DVec3 motion = motion_ - own_carry;
    if (!ground_) {
        landing_speed_ = std::max(0.0, -dot(velocity_ - (1 / dt_) * own_carry, f.contact));
        motion_ = own_carry + along_slope(motion, f.slope, math::length(level(motion)));
    } else {
        motion_ = own_carry + along_slope(motion, f.slope, math::length(motion));
    }
    wanted_ = motion_;
    stand_on(f);
}

// Tries to climb a step: up, forward, and down again. It succeeds if that leads farther and higher, to walkable ground.
bool Walk::climb(const CharacterHit& hit) {
    if (!(self_.step_height > 0)) return false;
    const double left = 1 - time_, height = double(self_.step_height);
    const DVec3 own = level(motion_ - carry());
    if (!(dot(own, hit.normal) < 0)) return false;
    const auto above = around_.cast(at_, time_, height * up_, 0);
    const double rise = (above ? above->fraction : 1) * height;
    const DVec3 raised = at_ + rise * up_;
    DVec3 way = left * (level(carry()) + own);
    double part = 0;
    for (int tries = 0; tries < 2; ++tries) { // second try: along a wall
        const auto ahead = around_.cast(raised, time_, way, left);
        part = ahead ? ahead->fraction : 1;
        if (part * math::length(way) > least_motion) break;
        if (!ahead) return false;
        part = 0;
        way -= dot(way, ahead->normal) * ahead->normal;
        way = level(way);
    }
    if (part == 0) return false;
    const double before = time_;
    time_ += part * left;
    DVec3 over = raised + part * way;
    const auto found = drop(over, rise + skin_, steepest_edge);
    const double gain = dot(over - at_, up_);
    if (!found || !(gain > least_motion) || is_too_high(*found)) {
        time_ = before;
        return false;
    }
    at_ = over;
    slid_ += part * way;
    stand_on(*found);
    motion_ = wanted_ = carry() + along_slope(own, slope_, math::length(own));
    return true;
}

void Walk::slide_along(const CharacterHit& hit) {
    const DVec3 its_carry = obstacle(hit.obstacle).carry, flat = level(hit.normal);
    const double rise = dot(hit.normal, up_), width = math::length(flat);
    const bool has_side = width > 1e-2 && !self_.flies;
    const DVec3 side = has_side ? (1 / width) * flat : DVec3{};
    if (!(ground_ && has_side)) planes_.add({hit.normal, dot(hit.normal, its_carry)});
    // A walking character neither climbs surfaces that are too steep, nor is pressed down by overhanging ones.
    if (has_side && (ground_ || rise > 0)) planes_.add({side, dot(side, its_carry)});
    if (!ground_ && rise > steepest_edge && !self_.flies) {
        is_steep_ = true;
        contact_normal_ = hit.normal, contact_point_ = hit.point, steep_ = hit.obstacle;
    }
    if (const auto motion = planes_.nearest(wanted_)) {
        motion_ = *motion;
        if (const auto velocity = planes_.nearest(dt_ * velocity_)) velocity_ = (1 / dt_) * *velocity;
        return;
    }
    // The character is squeezed: the moving obstacle passes through it.
    around_.stop_approach(obstacle(hit.obstacle).body, hit.normal);
    motion_ = wanted_ = velocity_ = {};
    planes_.clear();
    if (is_squeezed_) time_ = 1;
    is_squeezed_ = true;
}

void Walk::note_push(const CharacterHit& hit) {
    const Obstacle& met = obstacle(hit.obstacle);
    DVec3 direction = -1.0 * (self_.flies ? hit.normal : level(hit.normal));
    const double size = math::length(direction);
    if (!(size > 0.1) || push_count_ == most_pushes) return;
    direction = (1 / size) * direction;
    const double speed = dot(motion_ - met.carry, direction) / dt_;
    if (!(speed > 0)) return;
    for (std::size_t i = 0; i < push_count_; ++i)
        if (pushes_[i].body == met.body) return;
    pushes_[push_count_++] = {met.body, direction, hit.point, speed};
}

// --- End of the step.

void Walk::stick() {
    velocity_ = (1 / dt_) * motion_;
    time_ = 1;
    DVec3 at = at_;
    if (const auto found = drop(at, double(self_.stick_distance) + skin_, steepest_edge)) {
        at_ = at;
        return stand_on(*found);
    }
    self_.base = math::to_float(within_numbers(level((1 / dt_) * carry())));
    ground_.reset();
}

void Walk::finish() {
    self_.velocity = within_numbers(velocity_);
    self_.support = ground_ ? CharacterSupport::ground : is_steep_ ? CharacterSupport::steep : CharacterSupport::none;
    self_.jump_speed = 0;
    const std::optional<std::size_t> on = ground_ ? ground_ : is_steep_ ? steep_ : std::nullopt;
    if (!on) {
        self_.ground_body = self_.ground_shape = none;
        return;
    }
    const Obstacle& o = obstacle(*on);
    self_.ground_body = o.body, self_.ground_shape = std::int32_t(o.shape);
    self_.ground_normal = math::to_float(contact_normal_);
    self_.ground_point = around_.origin() + within_numbers(contact_point_);
    self_.ground_velocity = math::to_float(within_numbers((1 / dt_) * ride_on(o, contact_normal_)));
}

} // namespace cairn
