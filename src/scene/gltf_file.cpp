#include "scene/gltf_file.h"

#include <cairn/error.h>

#include <algorithm>
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

constexpr std::uint32_t glb_magic = 0x46546C67;  // "glTF"
constexpr std::uint32_t json_chunk = 0x4E4F534A; // "JSON"

// The JSON chunk of a .glb file: a header of 12 bytes (magic, version, length), then chunks, each of a header
// of 8 bytes (length, type) and its data, the JSON one first (glTF 2.0, section 4.4).
std::span<const std::byte> json_of_container(std::span<const std::byte> bytes, const std::string& file) {
    if (bytes.size() < 12) fail(file, "is a .glb file cut off in its header");
    if (const std::uint32_t version = little_endian_word(bytes, 4); version != 2) {
        throw Error(ErrorCode::unsupported, file, std::to_string(version), "must be a .glb file of version 2");
    }
    const std::uint32_t length = little_endian_word(bytes, 8);
    if (length > bytes.size()) {
        fail(file, "is a .glb file cut off: its header says " + std::to_string(length) + " bytes, and there are " +
                       std::to_string(bytes.size()));
    }
    bytes = bytes.first(length);
    if (bytes.size() < 20) fail(file, "is a .glb file without a JSON chunk");
    const std::uint32_t chunk_length = little_endian_word(bytes, 12);
    if (little_endian_word(bytes, 16) != json_chunk) fail(file, "is a .glb file whose first chunk is not JSON");
    if (chunk_length > bytes.size() - 20) {
        fail(file,
             "is a .glb file whose JSON chunk of " + std::to_string(chunk_length) + " bytes is longer than the file");
    }
    return bytes.subspan(20, chunk_length);
}

// Counts brackets outside of strings. (The parser's own hook for this takes quadratic time on long arrays.)
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

// nlohmann's messages begin with "[json.exception.parse_error.101] parse error at line 1, column 2: ".
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
    // Read in pieces rather than by the size that the file system reports, which pipes and devices do not have.
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

void write_file(const std::filesystem::path& path, std::string_view text) {
    std::filesystem::path temporary = path;
    temporary += ".partial";
    std::error_code code;
    {
        std::ofstream stream(temporary, std::ios::binary | std::ios::trunc);
        stream.write(text.data(), static_cast<std::streamsize>(text.size()));
        stream.close();
        if (!stream) {
            std::filesystem::remove(temporary, code);
            throw Error(ErrorCode::io, path.generic_string(), {}, "cannot be written");
        }
    }
    std::filesystem::rename(temporary, path, code);
    if (code) {
        const std::string reason = code.message();
        std::filesystem::remove(temporary, code);
        throw Error(ErrorCode::io, path.generic_string(), {}, "cannot be written: " + reason);
    }
}

nlohmann::json parse_gltf(std::span<const std::byte> bytes, const std::string& file) {
    if (bytes.empty()) fail(file, "is empty");
    if (bytes.size() >= 4 && little_endian_word(bytes, 0) == glb_magic) bytes = json_of_container(bytes, file);
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    if (is_deeper_than(text, max_json_depth)) {
        fail(file, "is nested more than " + std::to_string(max_json_depth) + " levels deep");
    }
    try {
        return nlohmann::json::parse(text);
    } catch (const nlohmann::json::exception& error) {
        // Malformed text, a number beyond double's range, or invalid UTF-8.
        fail(file, "is not valid JSON: " + without_prefix(error.what()));
    }
}

} // namespace cairn::scene
