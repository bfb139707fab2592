#include "recording/mcap_writer.h"

#include "files/checksum.h"

#include <cairn/version.h>

#include <zstd.h>

#include <algorithm>

namespace cairn::recording {

struct McapWriter::Context {
    Context() : zstd(ZSTD_createCCtx()) {
        if (zstd == nullptr) throw std::bad_alloc();
    }
    ~Context() { ZSTD_freeCCtx(zstd); }
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;
    ZSTD_CCtx* zstd;
};

namespace {

constexpr int compression_level = 3; // zstd's own default

std::string map_field(const std::string& content) {
    std::string field;
    RecordWriter(field).text(content);
    return field;
}

} // namespace

McapWriter::McapWriter(const std::filesystem::path& path, bool compress)
    : file_(path, files::Appearance::as_it_grows), compress_(compress), context_(std::make_unique<Context>()) {
    std::string start(mcap_magic), header;
    RecordWriter(header).text("cairn").text("cairn " + std::string(version_string));
    append_record(start, Opcode::header, header);
    put(start);
}

McapWriter::~McapWriter() = default;

void McapWriter::put(std::string_view bytes) {
    file_.write(bytes);
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
    message_counts_[id] = 0;
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
    if (ZSTD_isError(size) != 0) throw std::bad_alloc(); // the bound leaves no other reason
    result.resize(size);
    return result;
}

void McapWriter::write(Chunk& chunk) {
    if (chunk.is_empty()) return;
    const std::string packed = compress_ ? compressed(chunk.records_) : std::string();
    const std::string_view records = compress_ ? packed : chunk.records_;
    std::string content, all;
    RecordWriter(content)
        .number(chunk.first_time_)
        .number(chunk.last_time_)
        .number(std::uint64_t(chunk.records_.size()))
        .number(files::crc32(chunk.records_))
        .text(compress_ ? "zstd" : "")
        .number(std::uint64_t(records.size()));
    content += records;
    append_record(all, Opcode::chunk, content);
    ChunkPlace place{chunk.first_time_, chunk.last_time_,      offset_, all.size(), 0,
                     records.size(),    chunk.records_.size(), {}};
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
    for (const auto& [channel, count] : chunk.counts_) message_counts_[channel] += count;
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
        .text(compress_ ? "zstd" : "")
        .number(place.compressed)
        .number(place.uncompressed);
    append_record(record, Opcode::chunk_index, content);
    return record;
}

std::string McapWriter::statistics() const {
    std::uint64_t messages = 0, first = 0, last = 0;
    std::string counts, content, record;
    for (const auto& [channel, count] : message_counts_) {
        messages += count;
        RecordWriter(counts).number(channel).number(count);
    }
    for (const ChunkPlace& place : chunks_) {
        first = &place == &chunks_.front() ? place.first_time : std::min(first, place.first_time);
        last = std::max(last, place.last_time);
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

void McapWriter::close() {
    std::string end, record;
    RecordWriter(end).number(std::uint32_t{0}); // no checksum of the data section: each chunk has its own
    append_record(record, Opcode::data_end, end);
    put(record);
    put(summary());
    file_.close();
}

} // namespace cairn::recording
