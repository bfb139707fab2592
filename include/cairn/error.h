/// \file error.h
/// The one exception type of the API. It is thrown at the call that was given a bad argument, before
/// anything changes: the world is as it was. Nothing throws from inside a step.
#pragma once

#include <stdexcept>
#include <string>

namespace cairn {

enum class ErrorCode {
    invalid_value,  ///< An argument is NaN, infinite, or out of its range.
    invalid_handle, ///< A handle is null, stale, or of another world.
    wrong_state,    ///< The call is not allowed now (for example, from inside a step or a query callback).
    invalid_file,   ///< A file or a buffer is malformed.
    unsupported,    ///< A well-formed request for something that this build does not do.
    io,             ///< A file could not be read or written.
};

/// What went wrong: `field` names the argument (for example `BodyDef.mass`), `value` is what it was,
/// and `what()` says both together with what was expected.
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
