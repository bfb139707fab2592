// Reads plain .gltf text or a .glb container into JSON, with limits on size and depth; and writes containers.
#pragma once

#include "scene/json_value.h"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace cairn::scene {

inline constexpr std::size_t max_file_bytes = std::size_t{512} << 20;
inline constexpr int max_json_depth = 64;

// Reads the whole file. Throws Error (io) if it cannot be read, or is larger than max_file_bytes.
std::vector<std::byte> read_file(const std::filesystem::path& path);

struct GltfFile {
    nlohmann::json json;
    // The binary chunk of a .glb file: a view into the bytes that were parsed.
    std::optional<std::span<const std::byte>> binary;
};

// Parses a scene file; `file` stands for it in messages. Throws Error (invalid_file).
GltfFile parse_gltf(std::span<const std::byte> bytes, const std::string& file);

// Returns a .glb container of JSON and binary data. Throws Error (io) when they are too long for one.
std::string glb_container(std::string_view json, std::string_view binary);

// Returns `bytes` as the text of a data URI.
std::string data_uri(std::string_view bytes);
// Decodes the data URI at `place`. Throws Error through `place` if it is not well-formed.
std::vector<std::byte> decode_data_uri(const Value& place);

} // namespace cairn::scene
