// From bytes to JSON: plain .gltf text or a .glb container, with limits on size and depth; and back to a file.
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

// The whole file. Throws Error (io) if it cannot be read, or is larger than max_file_bytes.
std::vector<std::byte> read_file(const std::filesystem::path& path);

struct GltfFile {
    nlohmann::json json;
    std::optional<std::span<const std::byte>> binary; // the binary chunk of a .glb file, in the bytes it was read from
};

// Takes a scene file apart; `file` stands for it in messages. Throws Error (invalid_file).
GltfFile parse_gltf(std::span<const std::byte> bytes, const std::string& file);

// A .glb container of the two. Throws Error (io) when they are too long for one.
std::string glb_container(std::string_view json, std::string_view binary);

// `bytes` as the text of a URI of its own.
std::string data_uri(std::string_view bytes);
// What such a URI holds. Throws Error through `place`, the URI itself, if it is not well-formed.
std::vector<std::byte> decode_data_uri(const Value& place);

} // namespace cairn::scene
