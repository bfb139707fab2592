// Checks of arguments. Each throws Error(invalid_value) naming the field, its value and what was expected.
#pragma once

#include <cairn/world.h>

#include <string>
#include <string_view>

namespace cairn {

inline constexpr float smallest_mass = 1e-32f, largest_mass = 1e32f; // The range of a finite mass, kg.

[[noreturn]] void refuse(std::string_view field, const std::string& value, const std::string& expected);
std::string to_text(double value);
std::string to_text(const Vec3& value);
std::string to_text(const Position& value);
std::string to_text(const Quat& value);

void require_finite(std::string_view field, double value);
void require_finite(std::string_view field, const Vec3& value);
void require_position(std::string_view field, const Position& value);      // finite, each coordinate within 1e15 m
void require_at_least(std::string_view field, double value, double least); // and finite
void require_above(std::string_view field, double value, double limit);    // and finite

// The normalized rotation; refuses zero and non-finite quaternions.
Quat checked_rotation(std::string_view field, const Quat& rotation);

void validate(const WorldDef& def);
void validate(const BodyDef& def);
void validate(const Shape& shape);
const char* shape_name(const Shape& shape); // the name of its type in the public headers
void validate(const ShapeDef& def);
void validate(const ForceField& field);
void validate(std::string_view field, const MassProperties& properties);

} // namespace cairn
