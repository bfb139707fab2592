// Numbers as they are written to files: the shortest decimal that reads back as the same float or double.
#pragma once

#include <cairn/math.h>

#include <nlohmann/json.hpp>

#include <string>

namespace cairn::scene {

// The double whose shortest decimal is also the float's: 0.1f becomes 0.1, not 0.10000000149011612.
// Zero loses its sign, which says nothing in a file.
double shortest(float value);

nlohmann::ordered_json number_array(const Vec3& v);
nlohmann::ordered_json number_array(const Position& v);

// A rotation as it is written. Whoever reads it normalizes it, which in float leaves the large components as they are
// but shrinks small ones a little every time; seven decimals, about the precision of a float near one, make an end
// of that.
glm::dquat written_rotation(const Quat& q);
// In the order of glTF: x, y, z, w.
nlohmann::ordered_json number_array(const Quat& q);

// Six digits at most, for messages.
std::string short_number(double value);

// As text on one line. Names are any bytes: what is not UTF-8 in them becomes U+FFFD.
std::string json_text(const nlohmann::ordered_json& json);

} // namespace cairn::scene
