// The checksum of what lies in files: CRC-32 as in zlib.
#pragma once

#include <cstdint>
#include <string_view>

namespace cairn::files {

// `crc`: of what came before.
std::uint32_t crc32(std::string_view bytes, std::uint32_t crc = 0);

} // namespace cairn::files
