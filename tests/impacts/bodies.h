// The bodies that the cells shoot: random numbers, the kinds of bodies by size, and their support distances.
#pragma once

#include "validation/worlds.h"

#include <cstdint>
#include <random>
#include <vector>

namespace cairn_test {

using namespace cairn;
using namespace cairn::validation;

// Random numbers that are the same everywhere, in contrast to the distributions of the standard library.
class Random {
  public:
    explicit Random(unsigned seed) : bits_(seed) {}
    double uniform() { return double(bits_()) / 4294967296.0; } // in [0, 1)
    double between(double low, double high) { return low + (high - low) * uniform(); }
    Position direction(); // unit vector, uniformly distributed
    // A unit vector within `degrees` of the given one.
    Position direction_near(const Position& axis, double degrees);
    Quat rotation();

  private:
    std::mt19937 bits_;
};

// The plank is a box with three different edges, which tumbles, as a cube does not.
enum class Kind : std::uint8_t { sphere, box, capsule, cylinder, cone, hull, compound, plank };
inline constexpr Kind all_kinds[] = {Kind::sphere, Kind::box,  Kind::capsule, Kind::cylinder,
                                     Kind::cone,   Kind::hull, Kind::compound};
const char* name_of(Kind kind);

// A body for the cells: its shapes, all in the body's frame, and the lengths by which it is judged.
struct Bullet {
    std::vector<Shape> shapes;
    double inner_radius = 0;  // m, of the largest inscribed ball about the center of mass
    double reach = 0;         // m, of the smallest enclosing ball about the center of mass
    Position center{0, 0, 0}; // center of mass in the body's frame, m
};

// `size`, m: half the edge of the box, the radius of all other kinds. The capsule is twice as long as wide; the half
// extents of the plank are size, 2/3 and 1/3 of it.
Bullet make_bullet(Kind kind, double size);

BodyId add_bullet(World& world, const Bullet& bullet, const BodyDef& def, const Material& material);

// The extent of the body from its origin along a direction (unit vector in its own frame), m.
double support(const Bullet& bullet, const Position& direction);

// The inset of the core of a shape, m.
inline double core_shrink(double inner_radius) { return std::max(0.001, 0.02 * inner_radius); }

// Two unit vectors perpendicular to a unit vector and to each other.
void across(const Position& axis, Position& first, Position& second);

inline constexpr float frame = 1.0f / 60; // s

} // namespace cairn_test
