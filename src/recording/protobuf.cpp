#include "recording/protobuf.h"

#include <bit>
#include <map>
#include <set>
#include <sstream>

namespace cairn::recording {

void ProtoWriter::varint(std::uint64_t value) {
    for (; value >= 0x80; value >>= 7) bytes_ += char(std::uint8_t(value | 0x80));
    bytes_ += char(std::uint8_t(value));
}

void ProtoWriter::tag(int field, int wire_type) { varint(std::uint64_t(field) << 3 | std::uint64_t(wire_type)); }

ProtoWriter& ProtoWriter::number(int field, std::uint64_t value) {
    if (value != 0) tag(field, 0), varint(value);
    return *this;
}

namespace {

template <class T> void append_fixed(std::string& bytes, T value) {
    for (std::size_t i = 0; i < sizeof(T); ++i) bytes += char(std::uint8_t(value >> (8 * i)));
}

} // namespace

ProtoWriter& ProtoWriter::real(int field, double value) {
    if (value != 0.0) tag(field, 1), append_fixed(bytes_, std::bit_cast<std::uint64_t>(value));
    return *this;
}

ProtoWriter& ProtoWriter::text(int field, std::string_view value) {
    if (value.empty()) return *this;
    tag(field, 2), varint(value.size());
    bytes_ += value;
    return *this;
}

ProtoWriter& ProtoWriter::message(int field, const ProtoWriter& value) {
    tag(field, 2), varint(value.bytes_.size());
    bytes_ += value.bytes_;
    return *this;
}

ProtoWriter& ProtoWriter::fixed(int field, std::span<const std::uint32_t> values) {
    if (values.empty()) return *this;
    tag(field, 2), varint(4 * values.size());
    for (const std::uint32_t value : values) append_fixed(bytes_, value);
    return *this;
}

namespace {

// Numbers from google/protobuf/descriptor.proto.
enum Label { optional = 1, repeated = 3 };
constexpr int type_int32 = 5, type_int64 = 3, type_message = 11, type_enum = 14;
const std::map<std::string_view, int> scalar_types{{"double", 1},         {"uint64", 4},        {"fixed32", 7},
                                                   {"bool", 8},           {"string", 9},        {"bytes", 12},
                                                   {"int64", type_int64}, {"int32", type_int32}};

ProtoWriter field(std::string_view name, int number, Label label, int type, const std::string& type_name = {}) {
    ProtoWriter result;
    result.text(1, name).number(3, std::uint64_t(number)).number(4, label).number(5, std::uint64_t(type));
    return result.text(6, type_name);
}

// The file descriptor of google.protobuf.Timestamp or Duration: one message of seconds and nanoseconds.
ProtoWriter time_file(const std::string& file, std::string_view name) {
    ProtoWriter message, result;
    message.text(1, name);
    message.message(2, field("seconds", 1, optional, type_int64)).message(2, field("nanos", 2, optional, type_int32));
    return result.text(1, file).text(2, "google.protobuf").message(4, message).text(12, "proto3");
}

ProtoWriter enum_of(std::istringstream& words, const std::string& name) {
    ProtoWriter result;
    result.text(1, name);
    std::string value;
    for (std::uint64_t number = 0; words >> value; ++number)
        result.message(2, ProtoWriter().text(1, value).number(2, number));
    return result;
}

} // namespace

std::string describe_messages(std::string_view package, std::string_view lines) {
    constexpr const char *timestamp = "google/protobuf/timestamp.proto", *duration = "google/protobuf/duration.proto";
    ProtoWriter file, message, set;
    file.text(1, std::string(package) + ".proto").text(2, package).text(3, timestamp).text(3, duration);
    std::string message_name, line, word;
    std::set<std::string> enums; // of the current message
    std::istringstream all{std::string(lines)};
    const auto end_message = [&] {
        if (!message_name.empty()) file.message(4, message);
        message = {}, enums.clear();
    };
    while (std::getline(all, line)) {
        std::istringstream words(line);
        if (!(words >> word)) continue;
        if (word == "message") {
            end_message();
            words >> message_name;
            message.text(1, message_name);
            continue;
        }
        if (word == "enum") {
            words >> word;
            enums.insert(word);
            message.message(4, enum_of(words, word));
            continue;
        }
        const Label label = word == "repeated" ? repeated : optional;
        if (label == repeated) words >> word;
        std::string name;
        int number = 0;
        words >> name >> number;
        const auto scalar = scalar_types.find(word);
        const std::string own = "." + std::string(package) + ".";
        if (scalar != scalar_types.end())
            message.message(2, field(name, number, label, scalar->second));
        else if (enums.count(word) != 0)
            message.message(2, field(name, number, label, type_enum, own + message_name + "." + word));
        else if (word == "Timestamp" || word == "Duration")
            message.message(2, field(name, number, label, type_message, ".google.protobuf." + word));
        else
            message.message(2, field(name, number, label, type_message, own + word));
    }
    end_message();
    file.text(12, "proto3");
    set.message(1, time_file(timestamp, "Timestamp")).message(1, time_file(duration, "Duration")).message(1, file);
    return set.bytes();
}

} // namespace cairn::recording
