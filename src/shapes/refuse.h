// Errors for invalid arguments of shapes.
#pragma once

#include "math/vec.h"

#include <cairn/error.h>

#include <cstdio>
#include <string>

namespace cairn {

inline std::string number_text(double value) {
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, "%g", value);
    return buffer;
}
inline std::string number_text(math::Vec3 v) {
    char buffer[96];
    std::snprintf(buffer, sizeof buffer, "(%g, %g, %g)", double(v.x), double(v.y), double(v.z));
    return buffer;
}

[[noreturn]] inline void refuse(const std::string& field, const std::string& value, const std::string& expected) {
    throw Error(ErrorCode::invalid_value, field, value, expected);
}

} // namespace cairn
