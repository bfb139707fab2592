// Working memory of the stage that moves characters.
#pragma once

#include "math/bounds.h"
#include "shapes/convex.h"

#include <cairn/body.h>

#include <cstdint>
#include <vector>

namespace cairn {

// An obstacle near a character: a convex shape, a triangle or an infinite plane, in world axes relative to the place
// where the character starts.
struct Obstacle {
    Convex convex; // of a plane: only `center` and `axes.c1`
    DBounds bounds;
    math::DVec3 carry; // m: its displacement in the step, at the place of the character
    math::DVec3 ride;  // m: what stands on it moves by that: `carry`, except on characters, which count as at rest
    math::DVec3 belt;  // m: the displacement of its surface relative to itself, where it is tangential
    std::int32_t body = -1;
    std::uint32_t shape = 0;
    BodyType type = BodyType::static_;
    bool is_plane = false;
    bool is_one_sided = false; // touched only from the side of axes.c1
};

// A shape of a character at the start of the step.
struct CharacterPart {
    Convex sharp;  // without the skin
    Convex padded; // with the skin
    DBounds bounds;
    std::uint32_t shape = 0;
};

struct CharacterScratch {
    std::vector<Obstacle> obstacles;
    std::vector<CharacterPart> parts;
    std::vector<std::uint32_t> found; // shapes nearby
};

} // namespace cairn
