#include "scene/json_value.h"

#include <algorithm>
#include <cmath>

namespace cairn::scene {

namespace {

// 0.5 rather than 0.500000, as nlohmann-json writes numbers.
std::string plain(double v) {
    return v == std::floor(v) && std::fabs(v) < 1e15 ? std::to_string(static_cast<long long>(v))
                                                     : nlohmann::json(v).dump();
}

} // namespace

std::string Range::text() const {
    const bool low_bound = low > -largest_float, high_bound = high < largest_float;
    if (low_bound && high_bound) {
        return low_excluded ? "must be > " + plain(low) + " and <= " + plain(high)
                            : "must be " + plain(low) + " to " + plain(high);
    }
    if (low_bound) return (low_excluded ? "must be > " : "must be >= ") + plain(low);
    if (high_bound) return "must be <= " + plain(high);
    return high <= largest_float ? "must fit a float" : "must be a number";
}

std::optional<Value> Value::find(const char* key) const {
    must_be_object();
    const auto found = json_->find(key);
    if (found == json_->end()) return std::nullopt;
    return Value(*found, file_, path_.empty() ? std::string(key) : path_ + "." + key);
}

Value Value::require(const char* key) const {
    if (std::optional<Value> found = find(key)) return *found;
    raise(ErrorCode::invalid_file, std::string("must have a member \"") + key + "\"", {});
}

void Value::must_be_object() const {
    if (!json_->is_object()) fail("must be an object");
}

std::vector<std::string> Value::other_members(const std::vector<std::string>& known, std::size_t limit) const {
    must_be_object();
    std::vector<std::string> others;
    for (auto member = json_->begin(); member != json_->end() && others.size() < limit; ++member) {
        if (std::find(known.begin(), known.end(), member.key()) == known.end()) {
            others.push_back(member.key().substr(0, max_text_length));
        }
    }
    return others;
}

std::size_t Value::size(std::size_t limit, const char* what) const {
    if (!json_->is_array()) fail("must be an array");
    if (json_->size() > limit) {
        raise(ErrorCode::invalid_file, "must have at most " + std::to_string(limit) + " " + what,
              std::to_string(json_->size()));
    }
    return json_->size();
}

Value Value::operator[](std::size_t index) const {
    return Value((*json_)[index], file_, path_ + "[" + std::to_string(index) + "]");
}

double Value::number(const Range& range) const {
    if (!json_->is_number()) fail("must be a number");
    const double value = json_->get<double>();
    if (!range.contains(value)) fail(range.text());
    return value;
}

bool Value::boolean() const {
    if (!json_->is_boolean()) fail("must be true or false");
    return json_->get<bool>();
}

std::string Value::text() const {
    if (!json_->is_string()) fail("must be a string");
    const std::string& text = json_->get_ref<const std::string&>();
    if (text.size() > max_text_length) fail("must have at most " + std::to_string(max_text_length) + " bytes");
    return text;
}

const std::string& Value::long_text() const {
    if (!json_->is_string()) fail("must be a string");
    return json_->get_ref<const std::string&>();
}

std::uint64_t Value::whole(std::uint64_t low, std::uint64_t high) const {
    const double value = number();
    if (value != std::floor(value) || value < static_cast<double>(low) || value > static_cast<double>(high)) {
        fail("must be a whole number from " + std::to_string(low) + " to " + std::to_string(high));
    }
    return static_cast<std::uint64_t>(value);
}

std::size_t Value::index(std::size_t count, const char* what) const {
    if (!json_->is_number_unsigned()) fail(std::string("must be the index of one of the ") + what);
    const std::size_t value = json_->get<std::size_t>();
    if (value >= count) {
        fail(std::string("must be the index of one of the ") + std::to_string(count) + " " + what);
    }
    return value;
}

int Value::integer(int low, int high) const {
    const double value = number();
    if (value != std::floor(value) || value < low || value > high) {
        fail("must be a whole number from " + std::to_string(low) + " to " + std::to_string(high));
    }
    return static_cast<int>(value);
}

void Value::numbers(double* out, std::size_t count, const Range& range) const {
    if (!json_->is_array() || json_->size() != count) fail("must be an array of " + std::to_string(count) + " numbers");
    for (std::size_t i = 0; i < count; ++i) out[i] = (*this)[i].number(range);
}

glm::dvec3 Value::vector3(const Range& range) const {
    double v[3];
    numbers(v, 3, range);
    return {v[0], v[1], v[2]};
}

glm::dquat Value::rotation() const {
    double v[4];
    numbers(v, 4, Range{-1.5, 1.5, false});
    const double square = v[0] * v[0] + v[1] * v[1] + v[2] * v[2] + v[3] * v[3];
    if (square < 0.25 || square > 2.25) fail("must be a unit quaternion");
    // Deviations within float precision are no error, and normalizing them would make files drift from save to save.
    const bool is_unit = std::fabs(square - 1.0) < 1e-6;
    const double s = is_unit ? 1.0 : 1.0 / std::sqrt(square);
    return {v[3] * s, v[0] * s, v[1] * s, v[2] * s};
}

std::string Value::place() const { return std::string(file_) + ": " + (path_.empty() ? "" : path_ + ": "); }

std::string Value::shown() const {
    constexpr std::size_t longest = 60;
    if (json_->is_object()) return "an object";
    if (json_->is_array() && json_->size() > 8) return "an array of " + std::to_string(json_->size());
    if (json_->is_array()) {
        for (const nlohmann::json& element : *json_) {
            if (element.is_structured()) return "an array of " + std::to_string(json_->size());
        }
    }
    if (json_->is_string() && json_->get_ref<const std::string&>().size() > longest) {
        // Text is cut before it is escaped, because buffers are long. A letter that the cut splits is left out.
        const nlohmann::json start = json_->get_ref<const std::string&>().substr(0, longest);
        return start.dump(-1, ' ', true, nlohmann::json::error_handler_t::ignore) + "...";
    }
    std::string text = json_->dump(-1, ' ', true); // ASCII only, so that it can be cut anywhere
    if (text.size() > longest) text = text.substr(0, longest) + "...";
    return text;
}

void Value::raise(ErrorCode code, const std::string& expected, std::string value) const {
    throw Error(code, path_.empty() ? std::string(file_) : std::string(file_) + ": " + path_, std::move(value),
                expected);
}

} // namespace cairn::scene
