// The motion of one character in one step (docs/decisions/characters.md). Motions are in meters per step; positions are
// relative to the character's at the start of the step.
#pragma once

#include "character/obstacles.h"
#include "character/planes.h"

#include <array>
#include <cstdint>
#include <optional>

namespace cairn {

// A push of a character on a dynamic body.
struct CharacterPush {
    std::int32_t body;
    math::DVec3 direction, point; // unit; relative to the character's position at the start
    double speed;                 // m/s, of the character towards the body along `direction`
};

class Walk {
  public:
    // `gravity`: m/s^2.
    Walk(Surroundings& around, Character& self, math::DVec3 gravity, double max_speed, double recovery_speed,
         double dt);
    void run();

    math::DVec3 at() const { return at_; }     // the final position
    math::DVec3 slid() const { return slid_; } // the part of the displacement that is motion, not correction
    // Indices of obstacles: the ground, and the ground that the character has jumped off.
    std::optional<std::size_t> ground() const { return ground_; }
    std::optional<std::size_t> jumped_off() const { return jumped_off_; }
    double landing_speed() const { return landing_speed_; } // m/s; after a jump its speed
    std::span<const CharacterPush> pushes() const { return {pushes_.data(), push_count_}; }

  private:
    struct Footing {
        std::size_t obstacle;
        math::DVec3 contact, slope, point; // normals of the contact and of the walked surface; position of the contact
    };
    void recover();
    bool push_out(math::DVec3& way) const;
    bool finds_ground();
    bool falls_away(const Obstacle& obstacle) const;
    void start_on_ground();
    void start_in_air();
    void slide();
    void meet(const CharacterHit& hit);
    void land(const Footing& footing);
    bool climb(const CharacterHit& hit);
    void slide_along(const CharacterHit& hit);
    void stick();
    void finish();
    void note_push(const CharacterHit& hit);

    std::optional<Footing> footing(const CharacterHit& hit, double least) const;
    std::optional<Footing> drop(math::DVec3& at, double depth, double least) const;
    bool is_too_high(const Footing& footing) const;
    void stand_on(const Footing& footing);
    math::DVec3 level(math::DVec3 v) const { return v - math::dot(v, up_) * up_; }
    math::DVec3 along_slope(math::DVec3 motion, math::DVec3 slope, double length) const;
    const Obstacle& obstacle(std::size_t i) const { return around_.obstacles()[i]; }
    math::DVec3 ride_on(const Obstacle& o, math::DVec3 normal) const {
        return o.ride + (o.belt - math::dot(o.belt, normal) * normal);
    }
    math::DVec3 carry() const { return ground_ ? ride_on(obstacle(*ground_), slope_) : math::DVec3{}; }

    static constexpr std::size_t most_pushes = 8;
    Surroundings& around_;
    Character& self_;
    math::DVec3 up_, gravity_;
    double max_speed_, recovery_speed_, dt_, skin_, least_slope_; // least_slope_: cosine of the steepest walkable slope
    math::DVec3 at_, slid_;
    math::DVec3 wanted_, motion_; // m per step: without, and with the constraints of obstacles
    math::DVec3 velocity_;        // m/s, at the end of the step
    double time_ = 0, landing_speed_ = 0;
    std::optional<std::size_t> ground_, steep_, jumped_off_;
    math::DVec3 contact_normal_, slope_, contact_point_;
    bool is_steep_ = false, is_squeezed_ = false;
    MotionPlanes planes_;
    std::array<CharacterPush, most_pushes> pushes_;
    std::size_t push_count_ = 0;
};

} // namespace cairn
