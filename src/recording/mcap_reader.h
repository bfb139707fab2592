// Reads MCAP files by their index; a truncated file without one by its complete chunks.
#pragma once

#include "recording/input_bytes.h"
#include "recording/mcap_format.h"

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace cairn::recording {

struct McapMessage {
    std::uint16_t channel = 0;
    std::uint32_t sequence = 0;
    std::uint64_t nanoseconds = 0;
    std::string_view data;
};

class McapReader {
  public:
    // Throws Error: invalid_file, unsupported, io.
    explicit McapReader(InputBytes bytes);

    struct ChunkPlace {
        std::uint64_t offset = 0, size = 0; // of the chunk's record in the file
        std::set<std::uint16_t> channels;   // channels that have messages in the chunk
    };
    const std::vector<ChunkPlace>& chunks() const { return chunks_; }
    const std::string& name() const { return bytes_.name(); }
    std::uint64_t size() const { return bytes_.size(); }
    bool is_cut_off() const { return is_cut_off_; }
    std::uint64_t whole_bytes() const { return whole_bytes_; } // up to the end of the last complete record
    std::optional<std::uint16_t> channel(std::string_view topic) const;
    // The merged values of all metadata records of this name.
    const std::map<std::string, std::string>& metadata(const std::string& name) const;

    // The records of a chunk. Throws Error(invalid_file) if they are damaged.
    std::string load(std::size_t chunk) const;
    // For an uncompressed chunk, its first bytes, unchecked, as many as `start_of_message` needs; for a compressed one,
    // all records.
    std::string load_start(std::size_t chunk) const;
    // The available data of the first message in `records`. Throws Error(invalid_file) if the first record is not a
    // message.
    std::string_view start_of_message(std::string_view records) const;
    // Calls f(message) for each message in the records of a chunk, in the order of writing.
    template <class F> void for_each_message(std::string_view records, F&& f) const {
        RecordReader from(records, what_);
        while (!from.is_empty()) {
            const std::uint8_t opcode = from.number<std::uint8_t>();
            RecordReader record(from.take(from.number<std::uint64_t>()), what_);
            if (Opcode(opcode) != Opcode::message) continue;
            McapMessage message;
            message.channel = record.number<std::uint16_t>();
            message.sequence = record.number<std::uint32_t>();
            message.nanoseconds = record.number<std::uint64_t>();
            record.number<std::uint64_t>(); // publish time
            message.data = record.rest();
            f(message);
        }
    }

  private:
    bool read_index();
    void scan();
    void add_record(Opcode opcode, std::string_view content, std::uint64_t offset, std::uint64_t size);
    void read_metadata(std::string_view content);
    std::string record_at(std::uint64_t offset, std::uint64_t size, Opcode opcode) const;
    std::string unpacked(std::string_view compression, std::string_view records, std::uint64_t size,
                         const std::string& where) const;

    InputBytes bytes_;
    std::string what_; // the subject in messages
    std::vector<ChunkPlace> chunks_;
    std::map<std::string, std::uint16_t, std::less<>> channels_; // by topic
    std::map<std::string, std::map<std::string, std::string>> metadata_;
    bool is_cut_off_ = false;
    std::uint64_t whole_bytes_ = 0;
};

} // namespace cairn::recording
