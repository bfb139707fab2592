// What is around a character, and when it meets that.
#pragma once

#include "state/character_state.h"
#include "state/character_work.h"
#include "state/state.h"

#include <optional>
#include <span>

namespace cairn {

struct CharacterInput {
    const WorldDef& settings;
    const Bodies& bodies;
    const Shapes& shapes;
    const BroadPhase& broad_phase;
    const Characters& characters;
    double dt;
};

// What steps, gravities and places beyond measure come to is none: 0.
inline math::DVec3 within_numbers(math::DVec3 v) {
    constexpr double most = 1e30;
    return math::dot(v, v) <= most * most ? v : math::DVec3{};
}

// Where a character and an obstacle are nearest.
struct CharacterGap {
    double distance;    // m; < 0: they overlap
    math::DVec3 normal; // unit, out of the obstacle
    math::DVec3 point;  // of the obstacle
};

struct CharacterHit {
    double fraction; // of the way
    math::DVec3 normal, point;
    std::size_t obstacle;
};

// The surroundings of one character. Places are relative to where it was at the start of the step; `time` is the part
// of the step that has gone by.
class Surroundings {
  public:
    // All that it can meet when nothing of it gets farther than `reach` from where it is. `index`: of the character.
    Surroundings(const CharacterInput& input, std::size_t index, double reach, CharacterScratch& scratch);

    std::span<const Obstacle> obstacles() const { return scratch_.obstacles; }
    bool has_shape() const { return !scratch_.parts.empty(); }
    math::DVec3 origin() const { return origin_; }
    double size() const { return size_; } // m, across
    double lowest(math::DVec3 up) const;  // of it, along a direction, from its origin

    // Beyond `most` nothing is told.
    std::optional<CharacterGap> gap(std::size_t obstacle, math::DVec3 at, double time, double most) const;
    // The first meeting, at the distance of the skin, on the way from `at` by `way`, while the part `duration` of the
    // step goes by. What is nearer than that at once is met if the way leads on into it.
    std::optional<CharacterHit> cast(math::DVec3 at, double time, math::DVec3 way, double duration) const;
    // Of the surfaces of an obstacle at a point, the one that faces most along `up`: its normal, if there is one.
    std::optional<math::DVec3> face_at(const CharacterHit& hit, double time, math::DVec3 up) const;
    // The body moves towards the character no more: it is no longer pushed by it.
    void stop_approach(std::int32_t body, math::DVec3 normal);

  private:
    void gather_parts(std::int32_t body, double skin);
    void gather(std::int32_t body, double reach);
    void add_shape(std::uint32_t shape, const DBounds& near);
    void set_motion(std::size_t obstacle);
    std::optional<CharacterHit> cast_at(const CharacterPart& part, std::size_t obstacle, math::DVec3 at, double time,
                                        math::DVec3 way, double duration, double limit) const;

    const CharacterInput& input_;
    const Character& self_;
    std::size_t index_;
    CharacterScratch& scratch_;
    math::DVec3 origin_;
    double size_ = 0;
};

} // namespace cairn
