#include "scene/pictures.h"

#include "scene/gltf_file.h"

#include "files/checksum.h"

#include <cairn/error.h>

#include <algorithm>
#include <vector>

namespace cairn::scene {

namespace {

std::string big_endian(std::uint32_t word) {
    return {static_cast<char>(word >> 24), static_cast<char>(word >> 16), static_cast<char>(word >> 8),
            static_cast<char>(word)};
}

std::string png_chunk(std::string_view name, std::string_view data) {
    const std::string body = std::string(name) + std::string(data);
    return big_endian(static_cast<std::uint32_t>(data.size())) + body + big_endian(files::crc32(body));
}

// A zlib stream of uncompressed blocks (RFC 1950; RFC 1951, section 3.2.4).
std::string zlib_stream(std::string_view bytes) {
    constexpr std::size_t most = 65535;
    constexpr std::uint32_t adler_modulus = 65521;
    std::string stream = "\x78\x01";
    for (std::size_t at = 0; at < bytes.size(); at += most) {
        const std::string_view part = bytes.substr(at, most);
        const auto size = static_cast<std::uint16_t>(part.size()), inverse = static_cast<std::uint16_t>(~size);
        stream += static_cast<char>(at + most >= bytes.size()); // marks the last block
        for (const std::uint16_t word : {size, inverse})
            stream += static_cast<char>(word & 255), stream += static_cast<char>(word >> 8);
        stream += part;
    }
    std::uint32_t a = 1, b = 0;
    for (const char c : bytes) a = (a + static_cast<std::uint8_t>(c)) % adler_modulus, b = (b + a) % adler_modulus;
    return stream + big_endian(b << 16 | a);
}

} // namespace

bool is_picture(std::string_view file) {
    using namespace std::string_view_literals;
    return file.substr(0, 8) == "\x89PNG\r\n\x1A\n"sv || file.substr(0, 3) == "\xFF\xD8\xFF"sv;
}

std::shared_ptr<const std::string> Pictures::read(const std::filesystem::path& file, const std::string& place,
                                                  const std::string& shown) {
    std::shared_ptr<const std::string>& found = read_[file];
    if (found) return found;
    const std::vector<std::byte> bytes = read_file(file);
    std::string text(reinterpret_cast<const char*>(bytes.data()), bytes.size()); // bytes as characters
    if (!is_picture(text))
        throw Error(ErrorCode::unsupported, place, "\"" + shown + "\"", "must be a picture, PNG or JPEG");
    return found = std::make_shared<const std::string>(std::move(text));
}

std::string png_file(std::size_t width, std::size_t height, std::span<const std::uint8_t> pixels,
                     std::span<const std::array<std::uint8_t, 3>> colors) {
    using namespace std::string_literals;
    std::string rows, palette;
    for (std::size_t y = 0; y < height; ++y) {
        rows += '\0'; // no filter
        for (const std::uint8_t pixel : pixels.subspan(y * width, width)) rows += static_cast<char>(pixel);
    }
    for (const auto& color : colors)
        for (const std::uint8_t part : color) palette += static_cast<char>(part);
    const std::string size =
        big_endian(static_cast<std::uint32_t>(width)) + big_endian(static_cast<std::uint32_t>(height));
    return "\x89PNG\r\n\x1A\n"s + png_chunk("IHDR", size + "\x08\x03\0\0\0"s) + // 8 bits per pixel, with a palette
           png_chunk("PLTE", palette) + png_chunk("IDAT", zlib_stream(rows)) + png_chunk("IEND", "");
}

} // namespace cairn::scene
