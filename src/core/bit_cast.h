// std::bit_cast, which the C++ library of Debian 12's emscripten (libc++ 13) does not have. All compilers that the
// engine is built with have the builtin.
#pragma once

namespace cairn {

template <class To, class From> constexpr To bit_cast(const From& from) noexcept {
    static_assert(sizeof(To) == sizeof(From));
    return __builtin_bit_cast(To, from);
}

} // namespace cairn
