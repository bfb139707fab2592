#include "recording/mcap_format.h"

#include <cairn/error.h>

namespace cairn::recording {

void append_record(std::string& out, Opcode opcode, std::string_view content) {
    RecordWriter(out).number(std::uint8_t(opcode)).number(std::uint64_t(content.size()));
    out += content;
}

std::string_view RecordReader::take(std::uint64_t size) {
    if (size > bytes_.size())
        throw Error(ErrorCode::invalid_file, what_, std::to_string(bytes_.size()) + " bytes",
                    "must have " + std::to_string(size) + " bytes more");
    const std::string_view field = bytes_.substr(0, std::size_t(size));
    bytes_.remove_prefix(std::size_t(size));
    return field;
}

std::uint64_t RecordReader::leb128() {
    std::uint64_t value = 0;
    for (unsigned shift = 0; shift < 64; shift += 7) {
        const std::uint8_t next = number<std::uint8_t>();
        if (shift == 63 && next > 1) break;
        value |= std::uint64_t(next & 0x7f) << shift;
        if (next < 0x80) return value;
    }
    throw Error(ErrorCode::invalid_file, what_, "", "has a number that does not fit 64 bits");
}

void append_leb128(std::string& out, std::uint64_t value) {
    for (; value >= 0x80; value >>= 7) out += char(std::uint8_t(value | 0x80));
    out += char(std::uint8_t(value));
}

} // namespace cairn::recording
