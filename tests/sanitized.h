// Whether tests run under an address or thread sanitizer. Both keep freed memory for a while; the thread sanitizer also
// has an operator new of its own, which counts nothing and never fails.
#pragma once

namespace cairn_test {

#if defined(__SANITIZE_THREAD__)
inline constexpr bool is_thread_sanitized = true;
#elif defined(__has_feature)
inline constexpr bool is_thread_sanitized = __has_feature(thread_sanitizer);
#else
inline constexpr bool is_thread_sanitized = false;
#endif

#if defined(__SANITIZE_ADDRESS__)
inline constexpr bool is_sanitized = true;
#elif defined(__has_feature)
inline constexpr bool is_sanitized = is_thread_sanitized || __has_feature(address_sanitizer);
#else
inline constexpr bool is_sanitized = is_thread_sanitized;
#endif

} // namespace cairn_test
