// The binary data that a document refers to: in its own text (data URIs), in files beside it, or in the binary chunk of
// a .glb file. Each buffer is read at its first use.
#pragma once

#include "scene/json_value.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <vector>

namespace cairn::scene {

inline constexpr std::size_t max_buffers = 10'000;
inline constexpr std::size_t max_buffer_views = 1'000'000;
inline constexpr std::size_t max_buffer_bytes = std::size_t{512} << 20; // of all buffers together

class Buffers {
  public:
    // `binary` is the binary chunk of a .glb file; `folder` is that of the scene file. Without a folder, buffers in
    // other files are refused.
    Buffers(const Value& document, std::optional<std::span<const std::byte>> binary,
            std::optional<std::filesystem::path> folder);

    struct View {
        std::span<const std::byte> bytes;
        std::size_t stride = 0; // bytes from one element to the next; 0: elements are tightly packed
    };
    // Returns the buffer view that `index` refers to. Throws Error naming the place of the fault.
    View view(const Value& index);
    // Returns the data of a URI: embedded in it, or the content of a file beside the document. Throws as `view` does.
    std::vector<std::byte> file(const Value& uri);

  private:
    std::span<const std::byte> buffer(const Value& index);
    std::vector<std::byte> read(const Value& uri) const;

    std::optional<Value> buffers_, views_;
    std::optional<std::span<const std::byte>> binary_;
    std::optional<std::filesystem::path> folder_;
    std::vector<std::optional<std::vector<std::byte>>> loaded_;
    std::size_t loaded_bytes_ = 0;
};

// Returns the file that a URI of a scene names. The path must be relative and stay in the scene's folder or below it,
// also after links are followed. Throws Error through `uri` for anything else.
std::filesystem::path file_of_uri(const Value& uri, const std::filesystem::path& folder);

} // namespace cairn::scene
