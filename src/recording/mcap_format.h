// Elements of MCAP files (https://mcap.dev/spec): records of an opcode, a length and little-endian fields.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace cairn::recording {

inline constexpr std::string_view mcap_magic{"\x89MCAP0\r\n", 8};

enum class Opcode : std::uint8_t {
    header = 1,
    footer,
    schema,
    channel,
    message,
    chunk,
    message_index,
    chunk_index,
    attachment,
    attachment_index,
    statistics,
    metadata,
    metadata_index,
    summary_offset,
    data_end,
};

inline constexpr std::size_t record_start = 9; // size of opcode and length, bytes

// Appends consecutive fields.
class RecordWriter {
  public:
    explicit RecordWriter(std::string& out) : out_(out) {}
    template <class T> RecordWriter& number(T value) {
        for (std::size_t i = 0; i < sizeof(T); ++i) out_ += char(std::uint8_t(std::uint64_t(value) >> (8 * i)));
        return *this;
    }
    RecordWriter& text(std::string_view value) {
        number(std::uint32_t(value.size()));
        out_ += value;
        return *this;
    }

  private:
    std::string& out_;
};

// Appends a record with this content.
void append_record(std::string& out, Opcode opcode, std::string_view content);

// Reads consecutive fields. Throws Error(invalid_file) instead of reading past the end. `what`: the subject in
// messages.
class RecordReader {
  public:
    RecordReader(std::string_view bytes, const std::string& what) : bytes_(bytes), what_(what) {}

    template <class T> T number() {
        const std::string_view field = take(sizeof(T));
        std::uint64_t value = 0;
        for (std::size_t i = 0; i < sizeof(T); ++i) value |= std::uint64_t(std::uint8_t(field[i])) << (8 * i);
        return T(value);
    }
    std::uint64_t leb128();
    std::string_view text() { return take(number<std::uint32_t>()); }
    std::string_view take(std::uint64_t size);
    std::string_view rest() const { return bytes_; }
    bool is_empty() const { return bytes_.empty(); }

  private:
    std::string_view bytes_;
    const std::string& what_;
};

void append_leb128(std::string& out, std::uint64_t value);

inline std::string_view as_text(std::span<const std::byte> bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}
inline std::span<const std::byte> as_bytes(std::string_view text) {
    return {reinterpret_cast<const std::byte*>(text.data()), text.size()};
}

} // namespace cairn::recording
