// Reads the arguments of a command. Throws Error(invalid_file) for invalid bytes instead of reading past the end.
#pragma once

#include <cairn/commands.h>
#include <cairn/error.h>
#include <cairn/handle.h>
#include <cairn/math.h>
#include <cairn/shape.h>

#include <array>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

namespace cairn::commands {

class CommandReader {
  public:
    // `world`: the world number for handles that are read.
    CommandReader(std::span<const std::byte> bytes, std::uint32_t world, CommandSource& source)
        : bytes_(bytes), world_(world), source_(source) {}

    std::uint8_t byte();
    std::uint64_t number();
    std::uint64_t number_up_to(std::uint64_t most, const char* what);
    template <class T> T little_endian() {
        T value = 0;
        for (std::size_t i = 0; i < sizeof(T); ++i) value |= T(byte()) << (8 * i);
        return value;
    }
    std::string text();
    // The size of a list whose elements take at least one byte each.
    std::size_t count();
    // The member count of a struct that has `known` members in this build.
    std::size_t member_count(std::size_t known, const char* of);
    std::uint64_t choice(std::uint64_t count, const char* of);
    template <class Enum> void enumerator(Enum& x, std::uint64_t last, const char* what) {
        x = Enum(number_up_to(last, what));
    }
    std::uint32_t world() const { return world_; }

    Hull hull();
    Mesh mesh();
    HeightField height_field();
    const Snapshot& snapshot() { return source_.snapshot(number()); }

    void finish() const; // throws if any bytes are left
    [[noreturn]] void refuse_code(std::uint64_t code) const;

  private:
    template <class Kind> const Kind& named(const char* kind);
    std::span<const std::byte> bytes_;
    std::uint32_t world_;
    CommandSource& source_;
};

void read(CommandReader& from, bool& x);
void read(CommandReader& from, int& x);
void read(CommandReader& from, std::uint32_t& x);
void read(CommandReader& from, std::uint64_t& x);
void read(CommandReader& from, float& x);
void read(CommandReader& from, double& x);
void read(CommandReader& from, std::string& x);
void read(CommandReader& from, glm::vec2& x);
void read(CommandReader& from, Vec3& x);
void read(CommandReader& from, Position& x);
void read(CommandReader& from, Quat& x);
template <class Tag> void read(CommandReader& from, Handle<Tag>& x) {
    const std::uint64_t index = from.number_up_to(1u << Handle<Tag>::index_bits, "slot of a handle");
    x = {};
    if (index == 0) return;
    const std::uint64_t last = (1u << Handle<Tag>::generation_bits) - 1;
    x = Handle<Tag>::make(std::uint32_t(index - 1), std::uint32_t(from.number_up_to(last, "generation of a handle")),
                          from.world());
}
template <class T> void read(CommandReader& from, std::optional<T>& x) {
    bool is_there = false;
    read(from, is_there);
    x.reset();
    if (is_there) read(from, x.emplace());
}
template <class T> void read(CommandReader& from, std::vector<T>& x) {
    x.clear();
    for (std::size_t left = from.count(); left > 0; --left) read(from, x.emplace_back());
}
template <class T, std::size_t N> void read(CommandReader& from, std::array<T, N>& x) {
    for (T& element : x) read(from, element);
}

} // namespace cairn::commands
