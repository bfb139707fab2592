#include "scene/gltf_file.h"

#include <cairn/error.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <system_error>

namespace cairn::scene {

namespace {

[[noreturn]] void fail(const std::string& file, const std::string& what) {
    throw Error(ErrorCode::invalid_file, file, {}, what);
}

std::uint32_t little_endian_word(std::span<const std::byte> bytes, std::size_t offset) {
    std::uint32_t word = 0;
    for (std::size_t i = 0; i < 4; ++i) word |= std::to_integer<std::uint32_t>(bytes[offset + i]) << (8 * i);
    return word;
}

constexpr std::uint32_t glb_magic = 0x46546C67;    // "glTF"
constexpr std::uint32_t json_chunk = 0x4E4F534A;   // "JSON"
constexpr std::uint32_t binary_chunk = 0x004E4942; // "BIN\0"

// The chunks of a .glb file. The file has a header of 12 bytes (magic, version, length), then chunks, each with a
// header of 8 bytes (length, type) and its data: first the JSON, then at most one of binary data (glTF 2.0, section
// 4.4).
struct Container {
    std::span<const std::byte> json;
    std::optional<std::span<const std::byte>> binary;
};

Container open_container(std::span<const std::byte> bytes, const std::string& file) {
    if (bytes.size() < 12) fail(file, "is a .glb file that ends within its header");
    if (const std::uint32_t version = little_endian_word(bytes, 4); version != 2) {
        throw Error(ErrorCode::unsupported, file, std::to_string(version), "must be a .glb file of version 2");
    }
    const std::uint32_t length = little_endian_word(bytes, 8);
    if (length > bytes.size()) {
        fail(file, "is an incomplete .glb file: its header says " + std::to_string(length) + " bytes, and there are " +
                       std::to_string(bytes.size()));
    }
    bytes = bytes.first(length);
    if (bytes.size() < 20) fail(file, "is a .glb file without a JSON chunk");
    if (little_endian_word(bytes, 16) != json_chunk) fail(file, "is a .glb file whose first chunk is not JSON");
    Container container;
    std::size_t next = 12;
    for (int i = 0; next < bytes.size(); ++i) {
        if (bytes.size() - next < 8) fail(file, "is a .glb file that ends within the header of a chunk");
        const std::uint32_t size = little_endian_word(bytes, next), type = little_endian_word(bytes, next + 4);
        next += 8;
        const char* name = type == json_chunk ? "JSON chunk" : type == binary_chunk ? "binary chunk" : "chunk";
        if (size > bytes.size() - next) {
            fail(file, std::string("is a .glb file whose ") + name + " of " + std::to_string(size) +
                           " bytes is longer than the file");
        }
        if (i == 0) container.json = bytes.subspan(next, size);
        if (i == 1 && type == binary_chunk) container.binary = bytes.subspan(next, size); // other chunks are ignored
        next += size;
    }
    return container;
}

// Counts brackets outside of strings. (The JSON parser's callback for this takes quadratic time on long arrays.)
bool is_deeper_than(std::string_view text, int limit) {
    int depth = 0;
    bool in_string = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (in_string) {
            if (c == '\\') ++i;
            if (c == '"') in_string = false;
        } else if (c == '"') {
            in_string = true;
        } else if (c == '[' || c == '{') {
            if (++depth > limit) return true;
        } else if (c == ']' || c == '}') {
            --depth;
        }
    }
    return false;
}

// Strips the prefix of nlohmann's messages: "[json.exception.parse_error.101] parse error at line 1, column 2: ".
std::string without_prefix(const char* message) {
    const char* end = std::strchr(message, ']');
    return end != nullptr && end[1] == ' ' ? end + 2 : message;
}

} // namespace

std::vector<std::byte> read_file(const std::filesystem::path& path) {
    const std::string file = path.generic_string();
    std::error_code code;
    const std::filesystem::file_status status = std::filesystem::status(path, code);
    if (!std::filesystem::exists(status)) throw Error(ErrorCode::io, file, {}, "there is no such file");
    if (std::filesystem::is_directory(status)) throw Error(ErrorCode::io, file, {}, "is a folder, not a file");
    std::ifstream stream(path, std::ios::binary);
    if (!stream) throw Error(ErrorCode::io, file, {}, "cannot be opened for reading");
    // The file is read in pieces rather than by the size that the file system reports, which pipes and devices do not
    // have.
    std::vector<std::byte> bytes;
    constexpr std::size_t piece = std::size_t{1} << 20;
    while (stream) {
        const std::size_t filled = bytes.size();
        bytes.resize(filled + piece);
        stream.read(reinterpret_cast<char*>(bytes.data() + filled), static_cast<std::streamsize>(piece));
        bytes.resize(filled + static_cast<std::size_t>(stream.gcount()));
        if (bytes.size() > max_file_bytes) {
            throw Error(ErrorCode::io, file, {}, "must have at most " + std::to_string(max_file_bytes) + " bytes");
        }
    }
    if (stream.bad()) throw Error(ErrorCode::io, file, {}, "cannot be read");
    return bytes;
}

GltfFile parse_gltf(std::span<const std::byte> bytes, const std::string& file) {
    if (bytes.empty()) fail(file, "is empty");
    Container parts{bytes, std::nullopt};
    if (bytes.size() >= 4 && little_endian_word(bytes, 0) == glb_magic) parts = open_container(bytes, file);
    std::string_view text(reinterpret_cast<const char*>(parts.json.data()), parts.json.size());
    // Chunks are padded with spaces, or by nonconforming writers with zeros. Anywhere else a zero byte would end the
    // parser's input.
    const bool is_container = parts.json.size() != bytes.size();
    while (is_container && !text.empty() && text.back() == '\0') text.remove_suffix(1);
    if (const std::size_t zero = text.find('\0'); zero != std::string_view::npos) {
        fail(file, "is not valid JSON: has a zero byte at " + std::to_string(zero));
    }
    if (is_deeper_than(text, max_json_depth)) {
        fail(file, "is nested more than " + std::to_string(max_json_depth) + " levels deep");
    }
    try {
        return {nlohmann::json::parse(text), parts.binary};
    } catch (const nlohmann::json::exception& error) {
        // Malformed text, a number beyond double's range, or invalid UTF-8.
        fail(file, "is not valid JSON: " + without_prefix(error.what()));
    }
}

std::string glb_container(std::string_view json, std::string_view binary) {
    const auto padding = [](std::size_t size) { return (4 - size % 4) % 4; };
    const std::size_t json_size = json.size() + padding(json.size());
    const std::size_t binary_size = binary.size() + padding(binary.size());
    const std::size_t total = 12 + 8 + json_size + (binary.empty() ? 0 : 8 + binary_size);
    if (total > 0xFFFFFFFFu) {
        throw Error(ErrorCode::io, "scene", std::to_string(total), "must be shorter than 4 GiB to be a .glb file");
    }
    std::string file;
    file.reserve(total);
    const auto word = [&file](std::size_t value) {
        for (int i = 0; i < 4; ++i) file += static_cast<char>(value >> (8 * i) & 0xFFu);
    };
    word(glb_magic), word(2), word(total);
    word(json_size), word(json_chunk);
    file.append(json).append(padding(json.size()), ' ');
    if (binary.empty()) return file;
    word(binary_size), word(binary_chunk);
    return file.append(binary).append(padding(binary.size()), '\0');
}

namespace {

constexpr std::string_view base64_digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
constexpr std::string_view base64_mark = ";base64";

} // namespace

std::string data_uri(std::string_view bytes) {
    std::string text = "data:application/octet-stream;base64,";
    text.reserve(text.size() + (bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
        std::uint32_t group = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            group = group << 8 | (k < count ? static_cast<std::uint8_t>(bytes[i + k]) : 0u);
        }
        for (std::size_t k = 0; k < 4; ++k) {
            text += k <= count ? base64_digits[group >> (18 - 6 * k) & 63u] : '=';
        }
    }
    return text;
}

std::vector<std::byte> decode_data_uri(const Value& place) {
    const std::string& uri = place.long_text();
    const std::size_t comma = uri.find(',');
    const bool is_base64 = comma != std::string::npos && comma >= base64_mark.size() &&
                           uri.compare(comma - base64_mark.size(), base64_mark.size(), base64_mark) == 0;
    if (!is_base64) place.fail("must be a data URI in base64");
    std::string_view digits = std::string_view(uri).substr(comma + 1);
    for (int i = 0; i < 2 && !digits.empty() && digits.back() == '='; ++i) digits.remove_suffix(1);
    if (digits.size() % 4 == 1) place.fail("must be a data URI in base64, and is incomplete");
    std::array<std::uint8_t, 256> values{};
    values.fill(255);
    for (std::size_t i = 0; i < 64; ++i) {
        values[static_cast<std::uint8_t>(base64_digits[i])] = static_cast<std::uint8_t>(i);
    }
    std::vector<std::byte> bytes;
    bytes.reserve(digits.size() / 4 * 3 + 2);
    std::uint32_t group = 0;
    for (std::size_t i = 0; i < digits.size(); ++i) {
        const std::uint8_t value = values[static_cast<std::uint8_t>(digits[i])];
        if (value == 255) {
            place.fail("must be a data URI in base64, and has another character at " + std::to_string(comma + 1 + i));
        }
        group = group << 6 | value;
        if (i % 4 != 0) bytes.push_back(static_cast<std::byte>(group >> (6 - 2 * (i % 4)) & 0xFFu));
    }
    return bytes;
}

} // namespace cairn::scene
