#include "scene/buffers.h"

#include "scene/document.h"
#include "scene/gltf_file.h"
#include "scene/nearby_files.h"

#include <string_view>
#include <utility>

namespace cairn::scene {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view data_scheme = "data:";

int hex_digit(char c) {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    return -1;
}

// Decodes percent encoding: "%20" is a space (RFC 3986, section 2.1).
std::string percent_decoded(const Value& uri) {
    const std::string text = uri.text();
    std::string result;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] != '%') {
            result += text[i];
            continue;
        }
        const int high = i + 2 < text.size() ? hex_digit(text[i + 1]) : -1;
        const int low = high >= 0 ? hex_digit(text[i + 2]) : -1;
        if (low < 0) uri.fail("must have two hexadecimal digits after each %");
        result += static_cast<char>(high * 16 + low);
        i += 2;
    }
    return result;
}

} // namespace

fs::path file_of_uri(const Value& uri, const fs::path& folder) {
    const std::string name = percent_decoded(uri);
    constexpr const char* expected = "must name a file in the folder of the scene or below it";
    if (name.empty() || name.find_first_of(std::string_view(":\\\0", 3)) != std::string::npos) uri.fail(expected);
    const fs::path relative(name);
    if (relative.is_absolute() || relative.has_root_path()) uri.fail(expected);
    for (const fs::path& part : relative) {
        if (part == "..") uri.fail(expected);
    }
    const fs::path base = folder_on_disk(folder);
    const NearbyFile file = nearby_file(name, base, base);
    switch (file.verdict) {
    case NearbyFile::Verdict::found:
        return file.path;
    case NearbyFile::Verdict::outside:
        uri.fail(std::string(expected) + ", also where links lead");
    case NearbyFile::Verdict::not_a_file:
        uri.fail("must name a file, not a folder or a device");
    case NearbyFile::Verdict::missing:
        break;
    }
    throw Error(ErrorCode::io, (folder / relative).generic_string(), {}, "cannot be read: " + file.reason);
}

Buffers::Buffers(const Value& document, std::optional<std::span<const std::byte>> binary,
                 std::optional<fs::path> folder)
    : buffers_(document.find("buffers")), views_(document.find("bufferViews")), binary_(binary),
      folder_(std::move(folder)) {}

Buffers::View Buffers::view(const Value& index) {
    const Value here = element(views_, index, max_buffer_views, "buffer views");
    if (extension(here, "EXT_meshopt_compression")) here.refuse("is compressed, which is not supported");
    const std::span<const std::byte> bytes = buffer(here.require("buffer"));
    View view;
    std::size_t offset = 0;
    if (const auto given = here.find("byteOffset")) {
        offset = static_cast<std::size_t>(given->whole(0, max_buffer_bytes));
        if (offset > bytes.size()) {
            given->fail("must lie in the buffer, which has " + std::to_string(bytes.size()) + " bytes");
        }
    }
    const Value given = here.require("byteLength");
    const std::size_t length = static_cast<std::size_t>(given.whole(1, max_buffer_bytes));
    if (length > bytes.size() - offset) {
        given.fail("must end in the buffer, which has " + std::to_string(bytes.size() - offset) +
                   " bytes from the offset on");
    }
    view.bytes = bytes.subspan(offset, length);
    if (const auto stride = here.find("byteStride")) view.stride = static_cast<std::size_t>(stride->whole(4, 252));
    return view;
}

std::span<const std::byte> Buffers::buffer(const Value& index) {
    const Value here = element(buffers_, index, max_buffers, "buffers");
    loaded_.resize(buffers_->size(max_buffers, "buffers"));
    const std::size_t number = index.index(loaded_.size(), "buffers");
    const Value size = here.require("byteLength");
    const std::size_t length = static_cast<std::size_t>(size.whole(1, max_buffer_bytes));
    const auto uri = here.find("uri");
    if (!uri && (number != 0 || !binary_)) {
        here.fail("must have a member \"uri\", or be the first buffer of a .glb file with a binary chunk");
    }
    if (uri && !loaded_[number]) loaded_[number] = file(*uri);
    const std::span<const std::byte> bytes = uri ? std::span<const std::byte>(*loaded_[number]) : *binary_;
    if (length > bytes.size()) {
        size.fail("must be at most the " + std::to_string(bytes.size()) + " bytes that there are");
    }
    return bytes.first(length);
}

std::vector<std::byte> Buffers::file(const Value& uri) {
    std::vector<std::byte> bytes = read(uri);
    loaded_bytes_ += bytes.size();
    if (loaded_bytes_ > max_buffer_bytes) {
        uri.fail("must be one of buffers of at most " + std::to_string(max_buffer_bytes) + " bytes altogether");
    }
    return bytes;
}

std::vector<std::byte> Buffers::read(const Value& uri) const {
    const std::string& text = uri.long_text();
    if (std::string_view(text).substr(0, data_scheme.size()) == data_scheme) return decode_data_uri(uri);
    if (!folder_) uri.refuse("other files cannot be read by a scene that comes from memory");
    return read_file(file_of_uri(uri, *folder_));
}

} // namespace cairn::scene
