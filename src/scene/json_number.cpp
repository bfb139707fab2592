#include "scene/json_number.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace cairn::scene {

namespace {

// Writes the fewest digits that identify a float, with an exponent, and returns their end. Emscripten's library lacks
// std::to_chars for floating point; its snprintf does not depend on a locale, and 9 digits identify every float.
char* write_digits(char (&digits)[32], float value) {
#ifndef __EMSCRIPTEN__
    return std::to_chars(digits, digits + sizeof digits, value, std::chars_format::scientific).ptr;
#else
    int length = 0;
    for (int after_point = 0; after_point <= 8; ++after_point) {
        length = std::snprintf(digits, sizeof digits, "%.*e", after_point, static_cast<double>(value));
        if (std::strtof(digits, nullptr) == value) break;
    }
    return digits + length;
#endif
}

} // namespace

double shortest(float value) {
    if (value == 0.0f) return 0.0;
    char digits[32];
    const char* const end = write_digits(digits, value);
    const double decimal = nlohmann::json::parse(static_cast<const char*>(digits), end).get<double>();
    // Reading rounds twice, to double and then to float, which could in principle give an adjacent float.
    return static_cast<float>(decimal) == value ? decimal : static_cast<double>(value);
}

nlohmann::ordered_json number_array(const Vec3& v) {
    return nlohmann::ordered_json::array({shortest(v.x), shortest(v.y), shortest(v.z)});
}

nlohmann::ordered_json number_array(const Position& v) {
    return nlohmann::ordered_json::array({v.x + 0.0, v.y + 0.0, v.z + 0.0});
}

glm::dquat written_rotation(const Quat& q) {
    const auto rounded = [](float v) { return std::round(static_cast<double>(v) * 1e7) / 1e7 + 0.0; };
    return {rounded(q.w), rounded(q.x), rounded(q.y), rounded(q.z)};
}

nlohmann::ordered_json number_array(const Quat& q) {
    const glm::dquat written = written_rotation(q);
    return nlohmann::ordered_json::array({written.x, written.y, written.z, written.w});
}

std::string json_text(const nlohmann::ordered_json& json) {
    return json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

std::string short_number(double value) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.6g", value);
    return text.data();
}

} // namespace cairn::scene
