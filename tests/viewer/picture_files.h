// Small PNG and JPEG files for tests.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

namespace cairn::viewer::test {

inline std::shared_ptr<const std::string> shared(std::string text) {
    return std::make_shared<const std::string>(std::move(text));
}

inline std::string big_endian(std::uint32_t word) {
    return {char(word >> 24), char(word >> 16), char(word >> 8), char(word)};
}

// A PNG chunk (PNG specification, section 5.3): length, name, data, checksum.
inline std::string png_chunk(const std::string& name, const std::string& data) {
    std::uint32_t crc = 0xFFFFFFFFu;
    for (const char c : name + data) {
        crc ^= std::uint8_t(c);
        for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ (crc & 1 ? 0xEDB88320u : 0u);
    }
    return big_endian(std::uint32_t(data.size())) + name + data + big_endian(~crc);
}

// A file that ends after its header.
inline std::string png_header(std::uint32_t width, std::uint32_t height) {
    using namespace std::string_literals;
    return "\x89PNG\r\n\x1A\n"s + png_chunk("IHDR", big_endian(width) + big_endian(height) + "\x08\x06\0\0\0"s);
}

// A PNG file; `texel(x, y)` returns red, green, blue, alpha. The data are not compressed (RFC 1951, section 3.2.4).
template <class Texel> std::string png_of(int width, int height, const Texel& texel) {
    std::string rows, data = "\x78\x01";
    for (int y = 0; y < height; ++y) {
        rows += '\0';
        for (int x = 0; x < width; ++x)
            for (const std::uint8_t byte : texel(x, y)) rows += char(byte);
    }
    constexpr std::size_t most = 65535;
    for (std::size_t at = 0; at < rows.size(); at += most) {
        const std::string part = rows.substr(at, most);
        const auto size = std::uint32_t(part.size());
        data += char(at + most >= rows.size());
        data += {char(size), char(size >> 8), char(~size), char(~size >> 8)};
        data += part;
    }
    std::uint32_t a = 1, b = 0;
    for (const char c : rows) a = (a + std::uint8_t(c)) % 65521, b = (b + a) % 65521;
    return png_header(std::uint32_t(width), std::uint32_t(height)) + png_chunk("IDAT", data + big_endian(b << 16 | a)) +
           png_chunk("IEND", "");
}

// Two by two texels: red and green above blue and a fully transparent white.
inline std::string four_texels() {
    return png_of(2, 2, [](int x, int y) {
        using Texel = std::array<std::uint8_t, 4>;
        if (y == 0) return x == 0 ? Texel{255, 0, 0, 255} : Texel{0, 255, 0, 255};
        return x == 0 ? Texel{0, 0, 255, 255} : Texel{255, 255, 255, 0};
    });
}

// A JPEG of 16 x 8 pixels; its left half is red and its right half blue.
inline std::string red_and_blue_jpeg() {
    constexpr std::string_view text =
        "/9j/4AAQSkZJRgABAgAAAQABAAD//gAQTGF2YzU5LjM3LjEwMAD/2wBDAAgEBAQEBAUFBQUFBQYGBgYGBgYGBgYGBgYHBwcICAgH"
        "BwcGBgcHCAgICAkJCQgICAgJCQoKCgwMCwsODg4RERT/xABYAAEBAAAAAAAAAAAAAAAAAAAABgEBAQEBAQAAAAAAAAAAAAAAAAgB"
        "BgcQAQAAAAAAAAAAAAAAAAAAAAARAAEDBQEAAAAAAAAAAAAAAAM0AASydHMBswL/wAARCAAIABADARIAAhIAAxIA/9oADAMBAAIR"
        "AxEAPwCLHLAVRLmP18sBVEuY/Xy/e5aU+IlO2lpT4iU7cgKkho4+EVGmho4+EVGnOJlMm4P09PTKZNwfpt//2Q==";
    constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string bytes;
    std::uint32_t bits = 0;
    int count = 0;
    for (const char c : text) {
        if (c == '=') break;
        bits = bits << 6 | std::uint32_t(digits.find(c));
        if ((count += 6) < 8) continue;
        count -= 8;
        bytes += char(bits >> count & 255);
    }
    return bytes;
}

} // namespace cairn::viewer::test
