// What is shot in the cells: random numbers, the kinds of bodies by size, and how far each reaches.
#pragma once

#include "validation/worlds.h"

#include <cstdint>
#include <random>
#include <vector>

namespace cairn_test {

using namespace cairn;
using namespace cairn::validation;

// The same numbers everywhere: the distributions of the standard library are each library's own.
class Random {
  public:
    explicit Random(unsigned seed) : bits_(seed) {}
    double uniform() { return double(bits_()) / 4294967296.0; } // in [0, 1)
    double between(double low, double high) { return low + (high - low) * uniform(); }
    Position direction(); // unit, all alike likely
    // Unit, at most so many degrees from the given one.
    Position direction_near(const Position& axis, double degrees);
    Quat rotation();

  private:
    std::mt19937 bits_;
};

// The plank is a box of three different edges, which tumbles as a cube does not.
enum class Kind : std::uint8_t { sphere, box, capsule, cylinder, cone, hull, compound, plank };
inline constexpr Kind all_kinds[] = {Kind::sphere, Kind::box,  Kind::capsule, Kind::cylinder,
                                     Kind::cone,   Kind::hull, Kind::compound};
const char* name_of(Kind kind);

// A body as the cells need it: its shapes, all in the body's frame, and the measures that judge it.
struct Bullet {
    std::vector<Shape> shapes;
    double inner_radius = 0;  // m: of the largest ball about the center of mass that is inside
    double reach = 0;         // m: of the least ball about the center of mass that has all of it
    Position center{0, 0, 0}; // m: of mass, in the body's frame
};

// `size`, m: half the edge of the box, the radius of all else. The capsule is twice as long as wide; the plank measures
// size, 2/3 and 1/3 of it, halved as the box.
Bullet make_bullet(Kind kind, double size);

BodyId add_bullet(World& world, const Bullet& bullet, const BodyDef& def, const Material& material);

// How far the body reaches from its origin along a direction (unit, in its own frame), m.
double support(const Bullet& bullet, const Position& direction);

// How much smaller than the shape its core is, m.
inline double core_shrink(double inner_radius) { return std::max(0.001, 0.02 * inner_radius); }

// Two unit vectors at right angles to a unit vector, and to each other.
void across(const Position& axis, Position& first, Position& second);

inline constexpr float frame = 1.0f / 60; // s

} // namespace cairn_test
