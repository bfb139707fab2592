#include "scene/decimal.h"
#include "scene/xml_file.h"

#include <cairn/error.h>

#include <algorithm>
#include <cmath>

namespace cairn::scene {

namespace {

constexpr std::string_view spaces = " \t\r\n\f\v";

std::string shown(std::string_view text) {
    std::string result = "\"";
    for (const char c : text.substr(0, 80)) result += c >= ' ' && c <= '~' ? c : '?';
    return result + (text.size() > 80 ? "...\"" : "\"");
}

std::string_view trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(spaces);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(spaces) - first + 1);
}

std::string plain(double value) {
    std::string text = std::to_string(value);
    text.erase(text.find_last_not_of('0') + 1);
    if (!text.empty() && text.back() == '.') text.pop_back();
    return text;
}

} // namespace

void XmlText::fail(const std::string& expected) const {
    throw Error(ErrorCode::invalid_file, place, shown(text), expected);
}

double XmlText::number(double least, double most) const {
    const std::optional<double> value = parse_decimal(trimmed(text));
    if (!value) fail("must be a number");
    if (!(*value >= least && *value <= most)) {
        if (most >= 1e30) fail(least <= -1e30 ? "must fit a float" : "must be at least " + plain(least));
        fail("must be from " + plain(least) + " to " + plain(most));
    }
    return *value;
}

long XmlText::whole(long least, long most) const {
    const double value = number(static_cast<double>(least), static_cast<double>(most));
    if (value != std::floor(value)) fail("must be a whole number");
    return static_cast<long>(value);
}

std::vector<double> XmlText::numbers(std::size_t least, std::size_t most) const {
    std::vector<double> result;
    std::string_view rest = text;
    for (;;) {
        const std::size_t first = rest.find_first_not_of(spaces);
        if (first == std::string_view::npos) break;
        rest.remove_prefix(first);
        const std::string_view word = rest.substr(0, rest.find_first_of(spaces));
        rest.remove_prefix(word.size());
        const std::optional<double> value = parse_decimal(word);
        if (!value || !(std::fabs(*value) <= 1e30)) fail("must have numbers only, which fit a float");
        if (result.size() == most) fail("must have at most " + std::to_string(most) + " numbers");
        result.push_back(*value);
    }
    if (result.size() < least) {
        fail("must have " + std::string(least == most ? "" : "at least ") + std::to_string(least) + " numbers");
    }
    return result;
}

glm::dvec3 XmlText::vector3() const {
    const std::vector<double> values = numbers(3, 3);
    return {values[0], values[1], values[2]};
}

bool XmlText::boolean() const {
    const std::string_view word = trimmed(text);
    if (word == "true" || word == "1") return true;
    if (word == "false" || word == "0") return false;
    fail("must be true or false");
}

std::size_t XmlText::choice(std::initializer_list<std::string_view> words) const {
    const std::string_view word = trimmed(text);
    const auto found = std::find(words.begin(), words.end(), word);
    if (found != words.end()) return static_cast<std::size_t>(found - words.begin());
    std::string list;
    for (const std::string_view each : words) list += (list.empty() ? "" : ", ") + std::string(each);
    fail("must be one of " + list);
}

} // namespace cairn::scene
