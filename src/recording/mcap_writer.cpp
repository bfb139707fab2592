#include "recording/mcap_writer.h"

#include "files/checksum.h"
#include "recording/input_bytes.h"
#include "recording/zstd_context.h"

#include <cairn/version.h>

#include <zstd.h>

#include <algorithm>

namespace cairn::recording {

struct McapWriter::Context : ZstdContext {};

namespace {

constexpr int compression_level = 3;     // zstd's default
constexpr std::uint64_t piece = 1 << 20; // bytes copied at a time

std::string map_field(const std::string& content) {
    std::string field;
    RecordWriter(field).text(content);
    return field;
}

} // namespace

McapWriter::McapWriter(const std::filesystem::path& path, bool compress)
    : path_(path), file_(std::make_unique<files::OutputFile>(path, files::Appearance::as_it_grows)),
      compress_(compress), context_(std::make_unique<Context>()) {
    std::string start(mcap_magic), header;
    RecordWriter(header).text("cairn").text("cairn " + std::string(version_string));
    append_record(start, Opcode::header, header);
    put(start);
}

McapWriter::~McapWriter() = default;

void McapWriter::put(std::string_view bytes) {
    file_->write(bytes);
    offset_ += bytes.size();
}

void McapWriter::metadata(std::string_view name, const std::map<std::string, std::string>& values) {
    std::string pairs, content, record;
    for (const auto& [key, value] : values) RecordWriter(pairs).text(key).text(value);
    RecordWriter(content).text(name).text(pairs);
    append_record(record, Opcode::metadata, content);
    metadata_.push_back({offset_, record.size(), std::string(name)});
    put(record);
}

std::uint16_t McapWriter::add_schema(std::string_view name, std::string_view encoding, std::string_view data) {
    std::string content, record;
    RecordWriter(content).number(++schema_count_).text(name).text(encoding).text(data);
    append_record(record, Opcode::schema, content);
    schemas_ += record;
    put(record);
    return schema_count_;
}

std::uint16_t McapWriter::add_channel(std::uint16_t schema, std::string_view topic, std::string_view message_encoding) {
    std::string content, record;
    const std::uint16_t id = channel_count_++;
    RecordWriter(content).number(id).number(schema).text(topic).text(message_encoding).text("");
    append_record(record, Opcode::channel, content);
    channels_ += record;
    put(record);
    return id;
}

void McapWriter::Chunk::add(std::uint16_t channel, std::uint32_t sequence, std::uint64_t nanoseconds,
                            std::string_view data) {
    first_time_ = records_.empty() ? nanoseconds : std::min(first_time_, nanoseconds);
    last_time_ = records_.empty() ? nanoseconds : std::max(last_time_, nanoseconds);
    index_[channel].emplace_back(nanoseconds, records_.size());
    ++counts_[channel];
    RecordWriter to(records_);
    to.number(std::uint8_t(Opcode::message)).number(std::uint64_t(2 + 4 + 8 + 8 + data.size()));
    to.number(channel).number(sequence).number(nanoseconds).number(nanoseconds);
    records_ += data;
}

std::string McapWriter::compressed(std::string_view records) {
    std::string result(ZSTD_compressBound(records.size()), '\0');
    const std::size_t size = ZSTD_compressCCtx(context_->zstd, result.data(), result.size(), records.data(),
                                               records.size(), compression_level);
    if (ZSTD_isError(size) != 0) throw std::bad_alloc(); // the only possible error, given the bound on the size
    result.resize(size);
    return result;
}

void McapWriter::write(Chunk& chunk) {
    if (chunk.is_empty()) return;
    const bool compress = compress_ && chunk.is_compressed_;
    const std::string packed = compress ? compressed(chunk.records_) : std::string();
    const std::string_view records = compress ? packed : chunk.records_;
    std::string content, all;
    RecordWriter(content)
        .number(chunk.first_time_)
        .number(chunk.last_time_)
        .number(std::uint64_t(chunk.records_.size()))
        .number(files::crc32(chunk.records_))
        .text(compress ? "zstd" : "")
        .number(std::uint64_t(records.size()));
    content += records;
    append_record(all, Opcode::chunk, content);
    ChunkPlace place{
        chunk.first_time_, chunk.last_time_, offset_, all.size(), 0, records.size(), chunk.records_.size(), {},
        chunk.counts_,     compress,         false};
    for (const auto& [channel, entries] : chunk.index_) {
        place.index_offsets[channel] = offset_ + all.size();
        std::string pairs, index;
        for (const auto& [time, at] : entries) RecordWriter(pairs).number(time).number(at);
        RecordWriter(index).number(channel).text(pairs);
        append_record(all, Opcode::message_index, index);
    }
    place.index_size = all.size() - place.size;
    put(all);
    chunks_.push_back(std::move(place));
    chunk = {};
}

std::string McapWriter::chunk_index(const ChunkPlace& place) const {
    std::string offsets, content, record;
    for (const auto& [channel, offset] : place.index_offsets) RecordWriter(offsets).number(channel).number(offset);
    RecordWriter(content)
        .number(place.first_time)
        .number(place.last_time)
        .number(place.offset)
        .number(place.size)
        .text(offsets)
        .number(place.index_size)
        .text(place.is_compressed ? "zstd" : "")
        .number(place.compressed)
        .number(place.uncompressed);
    append_record(record, Opcode::chunk_index, content);
    return record;
}

std::string McapWriter::statistics() const {
    std::uint64_t messages = 0, first = 0, last = 0;
    std::string counts, content, record;
    std::map<std::uint16_t, std::uint64_t> of_channels;
    for (std::uint16_t channel = 0; channel < channel_count_; ++channel) of_channels[channel] = 0;
    for (const ChunkPlace& place : chunks_) {
        first = &place == &chunks_.front() ? place.first_time : std::min(first, place.first_time);
        last = std::max(last, place.last_time);
        for (const auto& [channel, count] : place.counts) of_channels[channel] += count;
    }
    for (const auto& [channel, count] : of_channels) {
        messages += count;
        RecordWriter(counts).number(channel).number(count);
    }
    RecordWriter(content)
        .number(messages)
        .number(schema_count_)
        .number(std::uint32_t(channel_count_))
        .number(std::uint32_t{0}) // attachments
        .number(std::uint32_t(metadata_.size()))
        .number(std::uint32_t(chunks_.size()))
        .number(first)
        .number(last);
    content += map_field(counts);
    append_record(record, Opcode::statistics, content);
    return record;
}

std::string McapWriter::summary() const {
    std::string all, offsets;
    const auto group = [&](Opcode opcode, const std::string& records) {
        if (records.empty()) return;
        std::string entry;
        RecordWriter(entry)
            .number(std::uint8_t(opcode))
            .number(offset_ + all.size())
            .number(std::uint64_t(records.size()));
        append_record(offsets, Opcode::summary_offset, entry);
        all += records;
    };
    group(Opcode::schema, schemas_);
    group(Opcode::channel, channels_);
    group(Opcode::statistics, statistics());
    std::string chunks, metadata;
    for (const ChunkPlace& place : chunks_) chunks += chunk_index(place);
    group(Opcode::chunk_index, chunks);
    for (const MetadataPlace& place : metadata_) {
        std::string entry;
        RecordWriter(entry).number(place.offset).number(place.size).text(place.name);
        append_record(metadata, Opcode::metadata_index, entry);
    }
    group(Opcode::metadata_index, metadata);
    const std::uint64_t summary_offsets = offset_ + all.size();
    all += offsets;
    RecordWriter footer(all);
    footer.number(std::uint8_t(Opcode::footer))
        .number(std::uint64_t(8 + 8 + 4))
        .number(offset_)
        .number(summary_offsets);
    footer.number(files::crc32(all));
    return all + std::string(mcap_magic);
}

void McapWriter::leave_out(std::size_t chunk) { chunks_[chunk].is_left_out = true; }

// Continues in a copy without the omitted chunks, which replaces the file when it is closed.
void McapWriter::copy_what_stays() {
    const InputBytes all(path_);
    auto copy = std::make_unique<files::OutputFile>(path_);
    const auto copy_range = [&](std::uint64_t from, std::uint64_t to) {
        for (; from < to; from += std::min(piece, to - from)) copy->write(all.read(from, std::min(piece, to - from)));
    };
    std::vector<ChunkPlace> stays;
    std::uint64_t copied = 0, gone = 0; // bytes
    auto metadata = metadata_.begin();
    for (ChunkPlace& place : chunks_) {
        for (; metadata != metadata_.end() && metadata->offset < place.offset; ++metadata) metadata->offset -= gone;
        if (place.is_left_out) {
            const std::uint64_t size = place.size + place.index_size;
            copy_range(copied, place.offset);
            copied = place.offset + size;
            gone += size;
            continue;
        }
        place.offset -= gone;
        for (auto& [channel, offset] : place.index_offsets) offset -= gone;
        stays.push_back(std::move(place));
    }
    for (; metadata != metadata_.end(); ++metadata) metadata->offset -= gone;
    copy_range(copied, offset_);
    offset_ -= gone;
    chunks_ = std::move(stays);
    file_->close();
    file_ = std::move(copy);
}

void McapWriter::close() {
    const bool lacks_any = std::any_of(chunks_.begin(), chunks_.end(), [](const auto& c) { return c.is_left_out; });
    if (lacks_any && !file_->is_stream()) copy_what_stays();
    std::string end, record;
    RecordWriter(end).number(std::uint32_t{0}); // no checksum of the data section, as each chunk has its own
    append_record(record, Opcode::data_end, end);
    put(record);
    put(summary());
    file_->close();
}

} // namespace cairn::recording
