// Writes the arguments of a command as bytes. Structs and variants are in generated/codec.h.
#pragma once

#include "core/bit_cast.h"

#include <cairn/commands.h>
#include <cairn/handle.h>
#include <cairn/math.h>
#include <cairn/shape.h>

#include <array>
#include <optional>
#include <string_view>
#include <type_traits>
#include <vector>

namespace cairn::commands {

class CommandWriter {
  public:
    // `out` is emptied first. `listener` assigns numbers to objects too large for a command.
    CommandWriter(std::vector<std::byte>& out, CommandListener& listener) : out_(out), listener_(listener) {
        out_.clear();
    }

    void byte(std::uint8_t value) { out_.push_back(std::byte(value)); }
    void number(std::uint64_t value) { // LEB128
        for (; value >= 0x80; value >>= 7) byte(std::uint8_t(value | 0x80));
        byte(std::uint8_t(value));
    }
    template <class T> void little_endian(T value) {
        for (std::size_t i = 0; i < sizeof(T); ++i) byte(std::uint8_t(value >> (8 * i)));
    }
    template <class Named> void named(const Named& value) { number(listener_.number_of(value)); }

  private:
    std::vector<std::byte>& out_;
    CommandListener& listener_;
};

inline void write(CommandWriter& to, bool x) { to.byte(x ? 1 : 0); }
inline void write(CommandWriter& to, int x) {
    to.number((std::uint32_t(x) << 1) ^ (x < 0 ? ~std::uint32_t{} : 0u)); // zigzag
}
inline void write(CommandWriter& to, std::uint32_t x) { to.number(x); }
inline void write(CommandWriter& to, std::uint64_t x) { to.number(x); }
inline void write(CommandWriter& to, float x) { to.little_endian(bit_cast<std::uint32_t>(x)); }
inline void write(CommandWriter& to, double x) { to.little_endian(bit_cast<std::uint64_t>(x)); }
inline void write(CommandWriter& to, std::string_view x) {
    to.number(x.size());
    for (const char c : x) to.byte(std::uint8_t(c));
}
inline void write(CommandWriter& to, const glm::vec2& x) { write(to, x.x), write(to, x.y); }
inline void write(CommandWriter& to, const Vec3& x) { write(to, x.x), write(to, x.y), write(to, x.z); }
inline void write(CommandWriter& to, const Position& x) { write(to, x.x), write(to, x.y), write(to, x.z); }
inline void write(CommandWriter& to, const Quat& x) { write(to, x.x), write(to, x.y), write(to, x.z), write(to, x.w); }
// Handles are written without their world number, which differs in the world that executes the command.
template <class Tag> void write(CommandWriter& to, Handle<Tag> x) {
    to.number(x.is_null() ? 0 : std::uint64_t{x.index()} + 1);
    if (!x.is_null()) to.number(x.generation());
}
template <class Enum>
requires std::is_enum_v<Enum>
void write(CommandWriter& to, Enum x) { to.number(std::uint64_t(x)); }
template <class T> void write(CommandWriter& to, const std::optional<T>& x) {
    write(to, x.has_value());
    if (x) write(to, *x);
}
template <class T> void write(CommandWriter& to, const std::vector<T>& x) {
    to.number(x.size());
    for (const T& element : x) write(to, element);
}
template <class T, std::size_t N> void write(CommandWriter& to, const std::array<T, N>& x) {
    for (const T& element : x) write(to, element);
}
inline void write(CommandWriter& to, const Hull& x) { to.named(Shape(x)), write(to, x.rounding); }
inline void write(CommandWriter& to, const Mesh& x) { to.named(Shape(x)); }
inline void write(CommandWriter& to, const HeightField& x) { to.named(Shape(x)); }
inline void write(CommandWriter& to, const Snapshot& x) { to.named(x); }

} // namespace cairn::commands
