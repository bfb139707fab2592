#include "scene/decimal.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdint>
#include <string>

namespace cairn::scene {

namespace {

constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }

// Powers of ten by exponent, all of which are exact in double.
constexpr double powers[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                             1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

} // namespace

// Up to 15 digits with an exponent of up to 22 are one exact product or quotient (Clinger 1990, "How to read floating
// point numbers accurately"). The few others go through the JSON parser, which rounds correctly in every locale.
std::optional<double> parse_decimal(std::string_view text) {
    std::size_t at = 0;
    const bool is_negative = !text.empty() && text[0] == '-';
    if (!text.empty() && (text[0] == '-' || text[0] == '+')) ++at;
    std::string digits;
    long exponent = 0;
    std::size_t seen = 0;
    for (bool after_point = false; at < text.size() && (is_digit(text[at]) || (!after_point && text[at] == '.'));
         ++at) {
        if (text[at] == '.') {
            after_point = true;
            continue;
        }
        ++seen;
        if (digits != "0") digits += text[at];
        if (digits == "0" && text[at] != '0') digits = text[at];
        if (after_point) --exponent;
    }
    if (seen == 0) return std::nullopt;
    if (at < text.size() && (text[at] == 'e' || text[at] == 'E')) {
        ++at;
        const bool shrinks = at < text.size() && text[at] == '-';
        if (at < text.size() && (text[at] == '-' || text[at] == '+')) ++at;
        if (at == text.size()) return std::nullopt;
        long given = 0;
        for (; at < text.size() && is_digit(text[at]); ++at)
            given = given < 100000 ? given * 10 + (text[at] - '0') : given;
        exponent += shrinks ? -given : given;
    }
    if (at != text.size()) return std::nullopt;
    double value = 0.0;
    if (digits.size() <= 15 && exponent >= -22 && exponent <= 22) {
        std::uint64_t whole = 0;
        for (const char c : digits) whole = whole * 10 + static_cast<std::uint64_t>(c - '0');
        value = exponent < 0 ? static_cast<double>(whole) / powers[-exponent]
                             : static_cast<double>(whole) * powers[exponent];
    } else {
        const nlohmann::json parsed = nlohmann::json::parse(digits + ".0e" + std::to_string(exponent), nullptr, false);
        if (!parsed.is_number()) return std::nullopt;
        value = parsed.get<double>();
    }
    return is_negative ? -value : value;
}

} // namespace cairn::scene
