// The state of characters: their orders, their motion and the ground that they stand on.
#pragma once

#include "math/vec.h"
#include "state/none.h"

#include <cairn/character.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace cairn {

struct Character {
    math::DVec3 velocity; // m/s: with which the next step begins
    math::DVec3 ground_point;
    std::int32_t body = none;
    std::int32_t ground_body = none, ground_shape = none;
    CharacterSupport support = CharacterSupport::none;
    std::uint8_t flies = 0;
    std::uint8_t padding[2] = {};
    math::Vec3 up{0, 1, 0};
    float max_slope = 0, step_height = 0, stick_distance = 0, skin = 0, mass = 0, max_push_force = 0;
    float air_acceleration = 0;
    math::Vec3 walk;      // m/s: the wanted velocity
    float jump_speed = 0; // m/s, in the next step
    math::Vec3 base;      // m/s: the velocity of the ground that it left
    math::Vec3 written;   // m/s: the velocity that the last step gave its body; any other one was set by the user
    math::Vec3 ground_normal{0, 1, 0}, ground_velocity;
};

struct Characters {
    std::vector<Character> all; // ordered by the slots of their bodies
};

// Null if the body is no character.
inline Character* find_character(Characters& characters, std::int32_t body) {
    const auto found = std::lower_bound(characters.all.begin(), characters.all.end(), body,
                                        [](const Character& c, std::int32_t b) { return c.body < b; });
    return found != characters.all.end() && found->body == body ? &*found : nullptr;
}

} // namespace cairn
