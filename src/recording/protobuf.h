// The Protocol Buffers encoding (https://protobuf.dev/programming-guides/encoding), with schemas that readers need no
// files of their own for.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace cairn::recording {

// Writes the fields of one message. Zero and empty values are omitted, as in proto3.
class ProtoWriter {
  public:
    ProtoWriter& number(int field, std::uint64_t value);
    ProtoWriter& real(int field, double value);
    ProtoWriter& text(int field, std::string_view value);
    ProtoWriter& message(int field, const ProtoWriter& value); // written even if it has no fields
    ProtoWriter& fixed(int field, std::span<const std::uint32_t> values);
    const std::string& bytes() const { return bytes_; }

  private:
    void tag(int field, int wire_type);
    void varint(std::uint64_t value);
    std::string bytes_;
};

// A FileDescriptorSet, as required by MCAP schemas of encoding "protobuf": Timestamp and Duration of google.protobuf,
// and a file of this package, described by lines of
//     message NAME          followed by its fields
//     [repeated] TYPE NAME NUMBER
//     enum NAME VALUE ...   within the message, numbered from 0; precedes fields of its type
// TYPE is one of double, uint64, fixed32, bool, string, bytes, Timestamp, Duration, the enum, or a message of the file.
std::string describe_messages(std::string_view package, std::string_view lines);

} // namespace cairn::recording
