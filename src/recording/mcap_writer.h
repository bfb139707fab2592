// Writes MCAP files: schemas, channels, messages in chunks, and an index at the end. A truncated file has all chunks
// that were written completely, including those that `close` would leave out.
#pragma once

#include "files/output_file.h"
#include "recording/mcap_format.h"

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace cairn::recording {

struct McapChannel {
    std::uint16_t id = 0, schema = 0;
    std::string topic, message_encoding;
};

class McapWriter {
  public:
    // `compress`: compresses chunks with zstd. Throws Error(io).
    McapWriter(const std::filesystem::path& path, bool compress);
    ~McapWriter();
    McapWriter(const McapWriter&) = delete;
    McapWriter& operator=(const McapWriter&) = delete;

    void metadata(std::string_view name, const std::map<std::string, std::string>& values);
    std::uint16_t add_schema(std::string_view name, std::string_view encoding, std::string_view data);
    std::uint16_t add_channel(std::uint16_t schema, std::string_view topic, std::string_view message_encoding);

    // Messages collected to be written as one chunk.
    class Chunk {
      public:
        // `nanoseconds`: since the beginning of the recording.
        void add(std::uint16_t channel, std::uint32_t sequence, std::uint64_t nanoseconds, std::string_view data);
        // for data that is already compressed; holds until the chunk is written
        void leave_uncompressed() { is_compressed_ = false; }
        std::size_t size() const { return records_.size(); }
        bool is_empty() const { return records_.empty(); }

      private:
        friend class McapWriter;
        std::string records_;
        bool is_compressed_ = true;
        std::uint64_t first_time_ = 0, last_time_ = 0;
        std::map<std::uint16_t, std::vector<std::pair<std::uint64_t, std::uint64_t>>>
            index_; // time, offset; by channel
        std::map<std::uint16_t, std::uint32_t> counts_;
    };
    // Writes a chunk to the file at once, and empties it; does nothing if it is empty. Throws Error(io).
    void write(Chunk& chunk);
    std::size_t chunk_count() const { return chunks_.size(); }
    // Omits a chunk, counted from 0, from the closed file. In files that are not regular, all chunks stay.
    void leave_out(std::size_t chunk);
    // Writes the index and the end of the file. Throws Error(io).
    void close();
    std::uint64_t bytes_written() const { return offset_; }

  private:
    struct ChunkPlace {
        std::uint64_t first_time, last_time, offset, size, index_size, compressed, uncompressed;
        std::map<std::uint16_t, std::uint64_t> index_offsets;
        std::map<std::uint16_t, std::uint32_t> counts;
        bool is_compressed, is_left_out;
    };
    void put(std::string_view bytes);
    std::string compressed(std::string_view records);
    void copy_what_stays();
    std::string summary() const;
    std::string chunk_index(const ChunkPlace& place) const;
    std::string statistics() const;

    std::filesystem::path path_;
    std::unique_ptr<files::OutputFile> file_;
    bool compress_;
    std::uint64_t offset_ = 0;
    struct Context; // of zstd
    std::unique_ptr<Context> context_;
    std::string schemas_, channels_; // serialized records
    std::uint16_t schema_count_ = 0;
    std::uint16_t channel_count_ = 0;
    std::vector<ChunkPlace> chunks_;
    struct MetadataPlace {
        std::uint64_t offset, size;
        std::string name;
    };
    std::vector<MetadataPlace> metadata_;
};

} // namespace cairn::recording
