// Numbers as they are written to files: the shortest decimal that reads back as the same float or double.
#pragma once

#include <cairn/math.h>

#include <nlohmann/json.hpp>

namespace cairn::scene {

// The double whose shortest decimal is also the float's: 0.1f becomes 0.1, not 0.10000000149011612.
// Zero loses its sign, which says nothing in a file.
double shortest(float value);

nlohmann::ordered_json number_array(const Vec3 &v);
nlohmann::ordered_json number_array(const Position &v);
// In the order of glTF: x, y, z, w.
nlohmann::ordered_json number_array(const Quat &q);

} // namespace cairn::scene
