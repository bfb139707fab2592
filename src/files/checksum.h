// Checksums of data in files: CRC-32 as in zlib.
#pragma once

#include <cstdint>
#include <string_view>

namespace cairn::files {

// `crc`: the checksum of the preceding bytes.
std::uint32_t crc32(std::string_view bytes, std::uint32_t crc = 0);

} // namespace cairn::files
