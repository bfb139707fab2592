#include "c_api/support.h"

#include <cairn/c/cairn.h>
#include <cairn/cairn.h>

#include <exception>
#include <new>

namespace {

// The last failed call on this thread.
struct LastError {
    std::string text, field, value;
};
thread_local LastError last_error;

cairn_result number_of(cairn::ErrorCode code) {
    using enum cairn::ErrorCode;
    switch (code) {
    case invalid_value:
        return CAIRN_ERROR_INVALID_VALUE;
    case invalid_handle:
        return CAIRN_ERROR_INVALID_HANDLE;
    case wrong_state:
        return CAIRN_ERROR_WRONG_STATE;
    case invalid_file:
        return CAIRN_ERROR_INVALID_FILE;
    case unsupported:
        return CAIRN_ERROR_UNSUPPORTED;
    case io:
        return CAIRN_ERROR_IO;
    }
    return CAIRN_ERROR_OTHER;
}

// If there is no memory for the text of an error, its number remains, with an empty text rather than an old one.
void keep(std::string_view text, std::string_view field, std::string_view value) noexcept {
    last_error.text.clear();
    last_error.field.clear();
    last_error.value.clear();
    try {
        last_error.text = text;
        last_error.field = field;
        last_error.value = value;
    } catch (const std::bad_alloc&) {}
}

} // namespace

namespace cairn::c_api {

cairn_result note_error() noexcept {
    try {
        throw;
    } catch (const Error& error) {
        keep(error.what(), error.field(), error.value());
        return number_of(error.code());
    } catch (const std::bad_alloc&) {
        keep("out of memory", {}, {});
        return CAIRN_ERROR_OUT_OF_MEMORY;
    } catch (const std::exception& error) {
        keep(error.what(), {}, {});
    } catch (...) {
        keep("an exception without a text", {}, {});
    }
    return CAIRN_ERROR_OTHER;
}

} // namespace cairn::c_api

int cairn_abi_version(void) { return CAIRN_ABI_VERSION; }
const char* cairn_version(void) { return cairn::version_string; }
const char* cairn_instruction_set(void) { return cairn::instruction_set().data(); }
int cairn_hardware_threads(void) { return cairn::hardware_threads(); }
const char* cairn_last_error(void) { return last_error.text.c_str(); }
const char* cairn_last_error_field(void) { return last_error.field.c_str(); }
const char* cairn_last_error_value(void) { return last_error.value.c_str(); }
