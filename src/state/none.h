// The index that stands for "no element".
#pragma once

#include <cstdint>

namespace cairn {

inline constexpr std::int32_t none = -1;

} // namespace cairn
