#include "commands/command_reader.h"

#include "core/bit_cast.h"

namespace cairn::commands {

namespace {

[[noreturn]] void refuse(const std::string& what, const std::string& value, const std::string& expected) {
    throw Error(ErrorCode::invalid_file, "command: " + what, value, expected);
}

} // namespace

std::uint8_t CommandReader::byte() {
    if (bytes_.empty()) refuse("bytes", "", "end before its arguments do");
    const std::uint8_t value = std::uint8_t(bytes_.front());
    bytes_ = bytes_.subspan(1);
    return value;
}

std::uint64_t CommandReader::number() {
    std::uint64_t value = 0;
    for (unsigned shift = 0; shift < 64; shift += 7) {
        const std::uint8_t next = byte();
        if (shift == 63 && next > 1) break;
        value |= std::uint64_t(next & 0x7f) << shift;
        if (next < 0x80) return value;
    }
    refuse("number", "", "must fit 64 bits");
}

std::uint64_t CommandReader::number_up_to(std::uint64_t most, const char* what) {
    const std::uint64_t value = number();
    if (value > most) refuse(what, std::to_string(value), "must be at most " + std::to_string(most));
    return value;
}

std::string CommandReader::text() {
    const std::size_t size = count();
    std::string result(reinterpret_cast<const char*>(bytes_.data()), size);
    bytes_ = bytes_.subspan(size);
    return result;
}

std::size_t CommandReader::count() { return std::size_t(number_up_to(bytes_.size(), "count")); }

std::size_t CommandReader::member_count(std::size_t known, const char* of) {
    const std::uint64_t members = number();
    if (members > known)
        throw Error(ErrorCode::unsupported, std::string("command: ") + of, std::to_string(members) + " members",
                    "has at most " + std::to_string(known) + " in this version of Cairn");
    return std::size_t(members);
}

std::uint64_t CommandReader::choice(std::uint64_t count, const char* of) {
    const std::uint64_t index = number();
    if (index >= count)
        throw Error(ErrorCode::unsupported, std::string("command: ") + of, std::to_string(index),
                    "is one of 0 to " + std::to_string(count - 1) + " in this version of Cairn");
    return index;
}

template <class Kind> const Kind& CommandReader::named(const char* kind) {
    const std::uint64_t number = this->number();
    const Kind* const shape = std::get_if<Kind>(&source_.shape(number));
    if (!shape) refuse("geometry", std::to_string(number), std::string("must be that of a ") + kind);
    return *shape;
}

Hull CommandReader::hull() {
    Hull hull = named<Hull>("hull");
    read(*this, hull.rounding);
    return hull;
}
Mesh CommandReader::mesh() { return named<Mesh>("mesh"); }
HeightField CommandReader::height_field() { return named<HeightField>("height field"); }

void CommandReader::finish() const {
    if (!bytes_.empty()) refuse("bytes", std::to_string(bytes_.size()), "must not be left after its arguments");
}

void CommandReader::refuse_code(std::uint64_t code) const {
    throw Error(ErrorCode::unsupported, "command", std::to_string(code), "is no call that this version of Cairn knows");
}

void read(CommandReader& from, bool& x) { x = from.number_up_to(1, "bool") != 0; }
void read(CommandReader& from, int& x) {
    const std::uint32_t value = std::uint32_t(from.number_up_to(0xffffffffu, "int"));
    x = int((value >> 1) ^ (value & 1 ? ~std::uint32_t{} : 0u));
}
void read(CommandReader& from, std::uint32_t& x) { x = std::uint32_t(from.number_up_to(0xffffffffu, "u32")); }
void read(CommandReader& from, std::uint64_t& x) { x = from.number(); }
void read(CommandReader& from, float& x) { x = bit_cast<float>(from.little_endian<std::uint32_t>()); }
void read(CommandReader& from, double& x) { x = bit_cast<double>(from.little_endian<std::uint64_t>()); }
void read(CommandReader& from, std::string& x) { x = from.text(); }
void read(CommandReader& from, glm::vec2& x) { read(from, x.x), read(from, x.y); }
void read(CommandReader& from, Vec3& x) { read(from, x.x), read(from, x.y), read(from, x.z); }
void read(CommandReader& from, Position& x) { read(from, x.x), read(from, x.y), read(from, x.z); }
void read(CommandReader& from, Quat& x) { read(from, x.x), read(from, x.y), read(from, x.z), read(from, x.w); }

} // namespace cairn::commands
