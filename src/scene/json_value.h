// A read-only view of a JSON value that knows its place in its file, so that every error message names the place.
// Values are cheap to copy; the document must outlive them.
#pragma once

#include <cairn/error.h>
#include <cairn/math.h>

#include <nlohmann/json.hpp>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cairn::scene {

// Maximum length of a name, title or other text that is read, in bytes.
inline constexpr std::size_t max_text_length = 4096;

// The interval of numbers that a field may hold.
struct Range {
    double low = -std::numeric_limits<double>::max(), high = std::numeric_limits<double>::max();
    bool low_excluded = false;
    bool contains(double v) const { return (low_excluded ? v > low : v >= low) && v <= high; }
    std::string text() const; // "must be > 0", "must be 0 to 1", ...
};
inline constexpr double largest_float = std::numeric_limits<float>::max();
inline constexpr Range any_float{-largest_float, largest_float, false};
inline constexpr Range positive_float{0.0, largest_float, true};
inline constexpr Range nonnegative_float{0.0, largest_float, false};

class Value {
  public:
    // `file` stands for the file in messages.
    Value(const nlohmann::json& json, std::string_view file) : json_(&json), file_(file) {}

    bool is_object() const { return json_->is_object(); }
    bool is_array() const { return json_->is_array(); }
    bool is_string() const { return json_->is_string(); }
    bool is_null() const { return json_->is_null(); }
    const std::string& path() const { return path_; }

    // Objects. `find` is empty if there is no such member; `require` throws.
    std::optional<Value> find(const char* key) const;
    Value require(const char* key) const;
    void must_be_object() const;
    // Returns the names of members that are not among `known`, at most `limit` of them.
    std::vector<std::string> other_members(const std::vector<std::string>& known, std::size_t limit) const;

    // Arrays. `size` throws if the value is not an array, or has more than `limit` elements.
    std::size_t size(std::size_t limit, const char* what) const;
    Value operator[](std::size_t index) const;

    // Scalars.
    double number(const Range& range = {}) const;
    float real(const Range& range = any_float) const { return static_cast<float>(number(range)); }
    bool boolean() const;
    std::string text() const;
    // Returns a text of any length without copying it: the data of a buffer, for example.
    const std::string& long_text() const;
    // Returns an index into an array of `count` elements, called `what` in messages.
    std::size_t index(std::size_t count, const char* what) const;
    // Returns an integer from `low` to `high`.
    int integer(int low, int high) const;
    // Returns an unsigned integer from `low` to `high`, for sizes and offsets; `high` is at most 2^53.
    std::uint64_t whole(std::uint64_t low, std::uint64_t high) const;

    // Arrays of numbers of fixed length.
    glm::dvec3 vector3(const Range& range = any_float) const;
    Vec3 float_vector3(const Range& range = any_float) const { return Vec3(vector3(range)); }
    // Reads a quaternion in the order x, y, z, w; normalized unless it is a unit quaternion to float precision already.
    glm::dquat rotation() const;

    [[noreturn]] void fail(const std::string& expected) const { raise(ErrorCode::invalid_file, expected, shown()); }
    [[noreturn]] void refuse(const std::string& why) const { raise(ErrorCode::unsupported, why, {}); }
    // Rethrows an error of the engine about the value, with the place of the value.
    [[noreturn]] void fail(const Error& error) const { raise(ErrorCode::invalid_file, error.what(), {}); }
    // The place of the value in the file, for a warning.
    std::string place() const;

  private:
    Value(const nlohmann::json& json, std::string_view file, std::string path)
        : json_(&json), file_(file), path_(std::move(path)) {}
    void numbers(double* out, std::size_t count, const Range& range) const;
    std::string shown() const; // the value as the file has it, shortened
    [[noreturn]] void raise(ErrorCode code, const std::string& expected, std::string value) const;

    const nlohmann::json* json_;
    std::string_view file_;
    std::string path_;
};

} // namespace cairn::scene
