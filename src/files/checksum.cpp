#include "files/checksum.h"

#include <array>
#include <bit>
#include <cstddef>
#include <cstring>

namespace cairn::files {

namespace {

// Number of bytes processed at a time (Kounavis and Berry 2005); table k has the effect of a byte that is followed by k
// others.
constexpr std::size_t width = 8;
using Tables = std::array<std::array<std::uint32_t, 256>, width>;

constexpr Tables make_tables() {
    Tables tables{};
    for (std::uint32_t i = 0; i < 256; ++i) {
        std::uint32_t value = i;
        for (int bit = 0; bit < 8; ++bit) value = (value >> 1) ^ ((value & 1) != 0 ? 0xedb88320u : 0u);
        tables[0][i] = value;
    }
    for (std::size_t k = 1; k < width; ++k)
        for (std::size_t i = 0; i < 256; ++i)
            tables[k][i] = (tables[k - 1][i] >> 8) ^ tables[0][tables[k - 1][i] & 0xff];
    return tables;
}
constexpr Tables tables = make_tables();

static_assert(std::endian::native == std::endian::little, "words are read as they lie in memory");

} // namespace

std::uint32_t crc32(std::string_view bytes, std::uint32_t crc) {
    crc = ~crc;
    for (; bytes.size() >= width; bytes.remove_prefix(width)) {
        std::uint32_t low = 0, high = 0;
        std::memcpy(&low, bytes.data(), 4);
        std::memcpy(&high, bytes.data() + 4, 4);
        low ^= crc;
        crc = tables[7][low & 0xff] ^ tables[6][(low >> 8) & 0xff] ^ tables[5][(low >> 16) & 0xff] ^
              tables[4][low >> 24] ^ tables[3][high & 0xff] ^ tables[2][(high >> 8) & 0xff] ^
              tables[1][(high >> 16) & 0xff] ^ tables[0][high >> 24];
    }
    for (const char c : bytes) crc = tables[0][(crc ^ static_cast<std::uint8_t>(c)) & 0xff] ^ (crc >> 8);
    return ~crc;
}

} // namespace cairn::files
