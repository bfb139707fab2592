// Messages in the encoding of Protocol Buffers (https://protobuf.dev/programming-guides/encoding), and descriptions of
// them that readers can do without files of their own.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace cairn::recording {

// Fields of one message. What is zero or empty is left out, as proto3 has it.
class ProtoWriter {
  public:
    ProtoWriter& number(int field, std::uint64_t value);
    ProtoWriter& real(int field, double value);
    ProtoWriter& text(int field, std::string_view value);
    ProtoWriter& message(int field, const ProtoWriter& value); // also one without fields
    ProtoWriter& fixed(int field, std::span<const std::uint32_t> values);
    const std::string& bytes() const { return bytes_; }

  private:
    void tag(int field, int wire_type);
    void varint(std::uint64_t value);
    std::string bytes_;
};

// A FileDescriptorSet, the data of MCAP schemas of the encoding "protobuf": Timestamp and Duration of google.protobuf,
// and a file of that package, from lines of
//     message NAME          the fields of which follow
//     [repeated] TYPE NAME NUMBER
//     enum NAME VALUE ...   in the message, numbered from 0; stands before the fields of its type
// TYPE is one of double, uint64, fixed32, bool, string, bytes, Timestamp, Duration, the enum, or a message of the file.
std::string describe_messages(std::string_view package, std::string_view lines);

} // namespace cairn::recording
