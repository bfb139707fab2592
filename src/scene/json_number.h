// Numbers are written to files as the shortest decimal that reads back as the same float or double.
#pragma once

#include <cairn/math.h>

#include <nlohmann/json.hpp>

#include <string>

namespace cairn::scene {

// Returns the double whose shortest decimal is also the float's: 0.1f becomes 0.1, not 0.10000000149011612. Negative
// zero loses its sign, which means nothing in a file.
double shortest(float value);

nlohmann::ordered_json number_array(const Vec3& v);
nlohmann::ordered_json number_array(const Position& v);

// Rounds a rotation to seven decimals for a file. Readers normalize rotations, which in float leaves large components
// as they are but shrinks small ones a little every time; rounding to about the precision of a float near one stops
// this drift.
glm::dquat written_rotation(const Quat& q);
// The components are in the order of glTF: x, y, z, w.
nlohmann::ordered_json number_array(const Quat& q);

// At most six digits, for messages.
std::string short_number(double value);

// Returns JSON text on one line. Names may be any bytes; bytes that are not UTF-8 become U+FFFD.
std::string json_text(const nlohmann::ordered_json& json);

} // namespace cairn::scene
