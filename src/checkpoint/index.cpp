#include "checkpoint/index.h"

#include "files/checksum.h"

#include <cairn/error.h>

#include <nlohmann/json.hpp>

#include <charconv>
#include <numeric>
#include <type_traits>

namespace cairn::checkpoint {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::uint64_t format = 1;
constexpr std::size_t max_parts = 1u << 20; // far more than any number of ranks; keeps an index small

template <class T> std::string hex_of(T number) {
    char digits[2 * sizeof number];
    const auto end = std::to_chars(digits, digits + sizeof digits, number, 16).ptr;
    std::string text(digits, end);
    return std::string(sizeof digits - text.size(), '0') + text;
}

// Reads required members of a JSON object. Error messages name a member by its path.
class Reader {
  public:
    Reader(const Json& json, std::string path) : json_(json), path_(std::move(path)) {}

    const Json& member(const char* name) const {
        const auto found = json_.is_object() ? json_.find(name) : json_.end();
        if (found == json_.end()) throw Error(ErrorCode::invalid_file, path_ + name, {}, "is missing");
        return *found;
    }
    Reader object(const char* name) const { return {member(name), path_ + name + "."}; }
    std::uint64_t count(const char* name) const {
        const Json& value = member(name);
        if (!value.is_number_unsigned()) fail(name, value, "must be a whole number");
        return value.get<std::uint64_t>();
    }
    double number(const char* name) const {
        const Json& value = member(name);
        if (!value.is_number()) fail(name, value, "must be a number");
        return value.get<double>();
    }
    std::string text(const char* name) const {
        const Json& value = member(name);
        if (!value.is_string()) fail(name, value, "must be a text");
        return value.get<std::string>();
    }
    template <class T> T bits(const char* name) const {
        const std::string digits = text(name);
        T value = 0;
        const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value, 16);
        if (error != std::errc() || end != digits.data() + digits.size() || digits.size() != 2 * sizeof value)
            fail(name, digits, "must be " + std::to_string(2 * sizeof value) + " hexadecimal digits");
        return value;
    }
    const Json& list(const char* name) const {
        const Json& value = member(name);
        if (!value.is_array() || value.size() > max_parts) fail(name, value.type_name(), "must be a list");
        return value;
    }
    [[noreturn]] void fail(const char* name, const Json& value, const std::string& expected) const {
        constexpr std::size_t max_shown = 60;
        throw Error(ErrorCode::invalid_file, path_ + name, value.dump(-1, ' ', true).substr(0, max_shown), expected);
    }

  private:
    const Json& json_;
    std::string path_;
};

Json to_json(const TableProgress& table) {
    const TableExtent& extent = table.extent;
    return {{"file", table.file},
            {"moments", table.moments},
            {"bytes", extent.bytes},
            {"rows", extent.rows},
            {"columns_crc32", hex(extent.columns)},
            {"rows_crc32", hex(extent.rows_crc)}};
}

TableProgress read_table(const Reader& reader) {
    return {reader.text("file"),
            reader.text("moments"),
            {reader.count("bytes"), reader.count("rows"), reader.bits<std::uint32_t>("columns_crc32"),
             reader.bits<std::uint32_t>("rows_crc32")}};
}

// File names may contain any bytes.
std::string dump(const Json& json, int indent) { return json.dump(indent, ' ', false, Json::error_handler_t::replace); }

std::string sum_of(const Json& contents) { return hex(files::crc32(dump(contents, -1))); }

Index read_contents(const Json& contents, const std::string& place) {
    const Reader reader(contents, place + ": ");
    if (reader.count("format") != format)
        throw Error(ErrorCode::unsupported, place + ": format", std::to_string(reader.count("format")),
                    "is of a later version of this program: must be " + std::to_string(format));
    Index index;
    const Reader run = reader.object("run");
    for (const auto& [name, value] : reader.member("run").items())
        index.identity.push_back({name, run.text(name.c_str()), {}});
    index.moment = {reader.count("step"), reader.number("time"), reader.bits<std::uint64_t>("state_hash"),
                    reader.number("max_penetration"), std::nullopt};
    if (contents.contains("table")) index.moment.table = read_table(reader.object("table"));
    std::uint64_t bytes = 0, bytes_of_parts = 0;
    for (const Json& size : reader.list("sections")) {
        if (!size.is_number_unsigned()) reader.fail("sections", size, "must be whole numbers");
        index.sections.push_back(size.get<std::uint64_t>());
        bytes += index.sections.back();
    }
    std::size_t number = 0;
    for (const Json& json : reader.list("parts")) {
        const Reader part(json, place + ": parts[" + std::to_string(number++) + "].");
        index.parts.push_back({part.text("file"), part.count("bytes"), part.bits<std::uint32_t>("crc32")});
        bytes_of_parts += index.parts.back().bytes;
    }
    if (bytes != bytes_of_parts)
        throw Error(ErrorCode::invalid_file, place + ": parts", std::to_string(bytes_of_parts),
                    "must have the " + std::to_string(bytes) + " bytes of the sections");
    return index;
}

} // namespace

std::string hex(std::uint32_t crc) { return hex_of(crc); }

std::string to_text(const Index& index) {
    Json contents{{"format", format}, {"run", Json::object()}};
    for (const Trait& trait : index.identity) contents["run"][trait.name] = trait.value;
    contents["step"] = index.moment.step;
    contents["time"] = index.moment.time;
    contents["state_hash"] = hex_of(index.moment.state_hash);
    contents["max_penetration"] = index.moment.max_penetration;
    if (index.moment.table) contents["table"] = to_json(*index.moment.table);
    contents["sections"] = index.sections;
    contents["parts"] = Json::array();
    for (const Part& part : index.parts)
        contents["parts"].push_back({{"file", part.file}, {"bytes", part.bytes}, {"crc32", hex(part.crc)}});
    const std::string sum = sum_of(contents);
    return dump({{"checkpoint", std::move(contents)}, {"crc32", sum}}, 1) + "\n";
}

Index read_index(std::string_view text, const std::string& place) {
    const Json json = Json::parse(text, nullptr, false);
    if (json.is_discarded()) throw Error(ErrorCode::invalid_file, place, {}, "is no JSON: it is cut off or damaged");
    const Reader reader(json, place + ": ");
    const Json& contents = reader.member("checkpoint");
    const std::string sum = reader.text("crc32");
    const std::string found = sum_of(contents);
    if (found != sum) throw Error(ErrorCode::invalid_file, place + ": checksum", found, "is damaged: must be " + sum);
    return read_contents(contents, place);
}

void require_same(const Identity& here, const Index& index, const std::string& place) {
    for (const Trait& trait : here) {
        std::string there = "none";
        for (const Trait& other : index.identity)
            if (other.name == trait.name) there = other.value;
        if (there != trait.value)
            throw Error(ErrorCode::wrong_state, place + ": " + trait.name, there,
                        trait.difference + ": must be " + trait.value);
    }
}

} // namespace cairn::checkpoint
