// From bytes to JSON: plain .gltf text or the JSON chunk of a .glb container, with limits on size and depth; and back
// to a file.
#pragma once

#include <nlohmann/json.hpp>

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace cairn::scene {

inline constexpr std::size_t max_file_bytes = std::size_t{512} << 20;
inline constexpr int max_json_depth = 64;

// The whole file. Throws Error (io) if it cannot be read, or is larger than max_file_bytes.
std::vector<std::byte> read_file(const std::filesystem::path& path);

// Writes to a temporary beside the file first, which then takes its name. Throws Error (io).
void write_file(const std::filesystem::path& path, std::string_view text);

// The JSON of a scene file; `file` stands for it in messages. Throws Error (invalid_file).
nlohmann::json parse_gltf(std::span<const std::byte> bytes, const std::string& file);

} // namespace cairn::scene
