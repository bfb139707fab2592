// The obstacles around a character, and when it hits them.
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

// Replaces vectors of absurd length, which huge steps, gravities or positions can give, by 0.
inline math::DVec3 within_numbers(math::DVec3 v) {
    constexpr double most = 1e30;
    return math::dot(v, v) <= most * most ? v : math::DVec3{};
}

// The nearest points of a character and an obstacle.
struct CharacterGap {
    double distance;    // m; negative if they overlap
    math::DVec3 normal; // unit, out of the obstacle
    math::DVec3 point;  // on the obstacle
};

struct CharacterHit {
    double fraction; // of the motion
    math::DVec3 normal, point;
    std::size_t obstacle;
};

// The surroundings of one character. Positions are relative to the character's at the start of the step; `time` is the
// share of the step that has passed.
class Surroundings {
  public:
    // Collects all obstacles that the character can hit if none of its points moves by more than `reach`. `index`: of
    // the character.
    Surroundings(const CharacterInput& input, std::size_t index, double reach, CharacterScratch& scratch);

    std::span<const Obstacle> obstacles() const { return scratch_.obstacles; }
    bool has_shape() const { return !scratch_.parts.empty(); }
    math::DVec3 origin() const { return origin_; }
    double size() const { return size_; } // m, of the largest bounding box diagonal of its shapes
    double lowest(math::DVec3 up) const;  // the lowest point of the character along `up`, from its origin

    // The gap to an obstacle, if it is at most `most`.
    std::optional<CharacterGap> gap(std::size_t obstacle, math::DVec3 at, double time, double most) const;
    // The first hit, at the distance of the skin, on the motion `way` from `at`, during the share `duration` of the
    // step. An obstacle that is nearer than that from the start is hit if the motion leads farther into it.
    std::optional<CharacterHit> cast(math::DVec3 at, double time, math::DVec3 way, double duration) const;
    // The normal of the obstacle's surface that is most nearly along `up`, among those at the hit point, if there is
    // one.
    std::optional<math::DVec3> face_at(const CharacterHit& hit, double time, math::DVec3 up) const;
    // Removes the body's motion towards the character, so that it does not push it.
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
