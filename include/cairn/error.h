/// \file error.h
/// The exception type of the API. A call with an invalid argument throws it before anything changes: the world stays as
/// it was. A step does not throw it once it has begun.
#pragma once

#include <stdexcept>
#include <string>

namespace cairn {

enum class ErrorCode {
    invalid_value,  ///< An argument is NaN, infinite, or out of its range.
    invalid_handle, ///< A handle is null, stale, or belongs to another world.
    /// The call is not allowed in the present state (for example, during a step, or for a body of another type).
    wrong_state,
    invalid_file, ///< A file or a buffer is malformed.
    unsupported,  ///< The request is well formed, but this build does not support it.
    io,           ///< A file could not be read or written.
};

/// Describes an error: `field` names the argument (for example `BodyDef.mass`), `value` is its value as text, and
/// `what()` gives both, and what was expected.
class Error : public std::runtime_error {
  public:
    Error(ErrorCode code, std::string field, std::string value, const std::string& expected)
        : std::runtime_error(field + ": " + expected + (value.empty() ? std::string() : ", got " + value)), code_(code),
          field_(std::move(field)), value_(std::move(value)) {}

    ErrorCode code() const noexcept { return code_; }
    const std::string& field() const noexcept { return field_; }
    const std::string& value() const noexcept { return value_; }

  private:
    ErrorCode code_;
    std::string field_, value_;
};

} // namespace cairn
