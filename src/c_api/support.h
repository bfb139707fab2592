// Helpers of all C functions: exceptions turned into error numbers, and checks of pointers.
#pragma once

#include "c_api/world_object.h"

#include <cairn/c/base.h>

#include <cstddef>
#include <cstring>
#include <string>
#include <string_view>

namespace cairn::c_api {

// Stores the description of the current exception for cairn_last_error, and returns its number.
cairn_result note_error() noexcept;

// Calls f, and turns exceptions into error numbers.
template <class F> cairn_result guarded(F&& f) noexcept {
    try {
        f();
        return CAIRN_OK;
    } catch (...) {
        return note_error();
    }
}

[[noreturn]] inline void refuse(const std::string& field, const std::string& value, const std::string& expected) {
    throw Error(ErrorCode::invalid_value, field, value, expected);
}

// Dereferences a pointer, which must not be null.
template <class T> T& required(T* pointer, const char* field) {
    if (!pointer) refuse(field, "null", "must not be null");
    return *pointer;
}

inline std::string_view required_text(const char* text, const char* field) { return &required(text, field); }

inline World& world_of(cairn_world* world) {
    if (!world) throw Error(ErrorCode::invalid_handle, "world", "null", "must be a world");
    return world->world();
}
inline const World& world_of(const cairn_world* world) { return world_of(const_cast<cairn_world*>(world)); }

// Checks a list argument: it may be null only if count is 0.
inline void require_list(const void* list, std::size_t count, const char* field) {
    if (!list && count > 0) refuse(field, "null", "must not be null with a count of " + std::to_string(count));
}

// Checks the output arguments for a list: an array of `capacity` elements, and a pointer for the number of results.
inline void require_room(const void* out, std::size_t capacity, const std::size_t* count, const char* field) {
    if (!out && capacity > 0) refuse(field, "null", "must not be null with a capacity of " + std::to_string(capacity));
    if (!count) refuse(std::string(field) + ": its number", "null", "must not be null");
}

template <class List, class C, class Convert>
void write_list(const List& list, C* out, std::size_t capacity, std::size_t* count, Convert&& convert) {
    for (std::size_t i = 0; i < list.size() && i < capacity; ++i) out[i] = convert(list[i]);
    *count = list.size();
}

inline void write_text(std::string_view text, char* out, std::size_t capacity, std::size_t* length) {
    *length = text.size();
    if (capacity == 0) return;
    const std::size_t written = text.size() < capacity ? text.size() : capacity - 1;
    std::memcpy(out, text.data(), written);
    out[written] = '\0';
}

// Checks struct_size, the first member of a structure: its size when the program was compiled. Structures may grow in
// later versions of the library, but never shrink; `first` is the size in the first version.
template <class C> void require_size(const C& c, const char* field, std::size_t first) {
    if (c.struct_size >= first && c.struct_size <= sizeof(C)) return;
    std::string allowed = std::to_string(sizeof(C));
    if (first < sizeof(C)) allowed = std::to_string(first) + " to " + allowed;
    refuse(std::string(field) + ".struct_size", std::to_string(c.struct_size),
           "must be " + allowed + ", as the function with its defaults sets it");
}

// The structure, with defaults in the members that the program does not know.
template <class C> C versioned(const C& c, const char* field, const C& defaults, std::size_t first = sizeof(C)) {
    require_size(c, field, first);
    C whole = defaults;
    std::memcpy(&whole, &c, c.struct_size);
    whole.struct_size = sizeof(C);
    return whole;
}

template <class C> void require_versioned(C* out, const char* field, std::size_t first = sizeof(C)) {
    require_size(required(out, field), field, first);
}

// Writes only the members that the program knows.
template <class C> void write_versioned(const C& c, C* out) {
    const auto size = out->struct_size;
    std::memcpy(out, &c, size);
    out->struct_size = size;
}

} // namespace cairn::c_api
