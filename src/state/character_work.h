// What the moving of characters works with.
#pragma once

#include "math/bounds.h"
#include "shapes/convex.h"

#include <cairn/body.h>

#include <cstdint>
#include <vector>

namespace cairn {

// Something that a character may meet: a convex shape, a triangle or an infinite plane, in axes of the world about the
// place where the character starts.
struct Obstacle {
    Convex convex; // of a plane: `center` and `axes.c1`
    DBounds bounds;
    math::DVec3 carry; // m, by how much it moves in the step where the character is
    math::DVec3 ride;  // m, by how much what stands on it moves: as far, but of other characters, which stand still
    math::DVec3 belt;  // m, by how much its surface moves beside that, where it is along the surface
    std::int32_t body = -1;
    std::uint32_t shape = 0;
    BodyType type = BodyType::static_;
    bool is_plane = false;
    bool is_one_sided = false; // met from the side of axes.c1 only
};

// A shape of a character where the step begins.
struct CharacterPart {
    Convex sharp;  // as it is
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
