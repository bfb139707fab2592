#include "recording/mcap_reader.h"

#include "files/checksum.h"

#include <cairn/error.h>

#include <zstd.h>

#include <algorithm>

namespace cairn::recording {

namespace {

// The greatest accepted size of a chunk, bytes: more than any writer collects; larger values indicate damage.
constexpr std::uint64_t largest_chunk = std::uint64_t{1} << 31;
constexpr std::uint64_t looked_at = 256; // bytes read from the start of a chunk to find its first message
constexpr std::uint64_t footer_size = record_start + 8 + 8 + 4;

[[noreturn]] void damaged(const std::string& where, const std::string& value, const std::string& expected) {
    throw Error(ErrorCode::invalid_file, where, value, expected);
}

} // namespace

McapReader::McapReader(InputBytes bytes) : bytes_(std::move(bytes)), what_(bytes_.name()) {
    const std::uint64_t magic = mcap_magic.size();
    if (bytes_.size() < magic || bytes_.read(0, magic) != mcap_magic)
        damaged(what_, "", "is not a recording: it does not begin like an MCAP file");
    if (read_index()) {
        whole_bytes_ = bytes_.size();
    } else {
        is_cut_off_ = true;
        scan();
    }
}

// Reads the index. Returns false if the file lacks a regular end.
bool McapReader::read_index() {
    const std::uint64_t magic = mcap_magic.size(), end = footer_size + magic;
    if (bytes_.size() < magic + end || bytes_.read(bytes_.size() - magic, magic) != mcap_magic) return false;
    const std::uint64_t footer_at = bytes_.size() - end;
    const std::string footer = record_at(footer_at, footer_size, Opcode::footer);
    RecordReader fields(footer, what_);
    const auto summary_start = fields.number<std::uint64_t>();
    fields.number<std::uint64_t>(); // start of the summary offsets
    const auto checksum = fields.number<std::uint32_t>();
    if (summary_start == 0) return false; // written without an index
    if (summary_start < magic || summary_start > footer_at)
        damaged(what_ + ": footer: summary_start", std::to_string(summary_start), "must lie within the file");
    const std::string summary = bytes_.read(summary_start, footer_at + footer_size - summary_start);
    if (checksum != 0 && files::crc32(std::string_view(summary).substr(0, summary.size() - 4)) != checksum)
        damaged(what_ + ": summary", "", "is damaged: its checksum does not fit");
    RecordReader records(std::string_view(summary).substr(0, std::size_t(footer_at - summary_start)), what_);
    while (!records.is_empty()) {
        const auto opcode = Opcode(records.number<std::uint8_t>());
        const std::string_view content = records.take(records.number<std::uint64_t>());
        RecordReader record(content, what_);
        if (opcode == Opcode::channel) add_record(opcode, content, 0, 0);
        if (opcode == Opcode::chunk_index) {
            ChunkPlace place;
            record.take(8 + 8); // times
            place.offset = record.number<std::uint64_t>();
            place.size = record.number<std::uint64_t>();
            if (place.size < record_start || place.offset > bytes_.size() || place.size > bytes_.size() - place.offset)
                damaged(what_ + ": chunk index", std::to_string(place.offset),
                        "must refer to a position within the file");
            RecordReader offsets(record.text(), what_);
            while (!offsets.is_empty()) {
                place.channels.insert(offsets.number<std::uint16_t>());
                offsets.number<std::uint64_t>();
            }
            chunks_.push_back(std::move(place));
        }
        if (opcode == Opcode::metadata_index) {
            const auto offset = record.number<std::uint64_t>(), size = record.number<std::uint64_t>();
            read_metadata(record_at(offset, size, Opcode::metadata));
        }
    }
    std::sort(chunks_.begin(), chunks_.end(),
              [](const ChunkPlace& a, const ChunkPlace& b) { return a.offset < b.offset; });
    return true;
}

// Reads all complete records from the start.
void McapReader::scan() {
    std::uint64_t at = mcap_magic.size();
    whole_bytes_ = at;
    while (bytes_.size() - at >= record_start) {
        const std::string start = bytes_.read(at, record_start);
        RecordReader fields(start, what_);
        const auto opcode = Opcode(fields.number<std::uint8_t>());
        const auto size = fields.number<std::uint64_t>();
        if (size > bytes_.size() - at - record_start) break;
        const bool is_read = opcode == Opcode::channel || opcode == Opcode::metadata || opcode == Opcode::message_index;
        add_record(opcode, is_read ? bytes_.read(at + record_start, size) : std::string(), at, record_start + size);
        at += record_start + size;
        whole_bytes_ = at;
        if (opcode == Opcode::data_end) break;
    }
    for (std::size_t i = 0; i < chunks_.size(); ++i) { // the message index after the last chunk may be missing
        if (i + 1 < chunks_.size() && !chunks_[i].channels.empty()) continue;
        const std::string records = load(i);
        for_each_message(records, [&](const McapMessage& m) { chunks_[i].channels.insert(m.channel); });
    }
}

void McapReader::add_record(Opcode opcode, std::string_view content, std::uint64_t offset, std::uint64_t size) {
    RecordReader record(content, what_);
    if (opcode == Opcode::channel) {
        const auto id = record.number<std::uint16_t>();
        record.number<std::uint16_t>(); // schema number
        channels_.emplace(record.text(), id);
    }
    if (opcode == Opcode::metadata) read_metadata(content);
    if (opcode == Opcode::chunk) chunks_.push_back({offset, size, {}});
    if (opcode == Opcode::message_index && !chunks_.empty())
        chunks_.back().channels.insert(record.number<std::uint16_t>());
}

void McapReader::read_metadata(std::string_view content) {
    RecordReader record(content, what_);
    std::map<std::string, std::string>& values = metadata_[std::string(record.text())];
    RecordReader pairs(record.text(), what_);
    while (!pairs.is_empty()) {
        std::string key(pairs.text());
        values[std::move(key)] = pairs.text();
    }
}

// The content of the record at an offset, which must have this opcode.
std::string McapReader::record_at(std::uint64_t offset, std::uint64_t size, Opcode opcode) const {
    const std::string where = what_ + ": record at byte " + std::to_string(offset);
    if (size < record_start || offset > bytes_.size() || size > bytes_.size() - offset)
        damaged(where, "", "must lie within the file");
    std::string record = bytes_.read(offset, size);
    RecordReader fields(record, what_);
    const auto found = fields.number<std::uint8_t>();
    if (Opcode(found) != opcode)
        damaged(where, std::to_string(found), "must have opcode " + std::to_string(int(opcode)));
    if (fields.number<std::uint64_t>() != size - record_start)
        damaged(where, "", "has another length than its index states");
    record.erase(0, record_start);
    return record;
}

std::optional<std::uint16_t> McapReader::channel(std::string_view topic) const {
    const auto found = channels_.find(topic);
    return found == channels_.end() ? std::nullopt : std::optional(found->second);
}

const std::map<std::string, std::string>& McapReader::metadata(const std::string& name) const {
    static const std::map<std::string, std::string> none;
    const auto found = metadata_.find(name);
    return found == metadata_.end() ? none : found->second;
}

std::string McapReader::unpacked(std::string_view compression, std::string_view records, std::uint64_t size,
                                 const std::string& where) const {
    if (size > largest_chunk) damaged(where, std::to_string(size) + " bytes", "must not be larger than 2 GiB");
    if (compression.empty()) {
        if (records.size() != size) damaged(where, std::to_string(records.size()), "has another size than it states");
        return std::string(records);
    }
    if (compression != "zstd")
        throw Error(ErrorCode::unsupported, where, std::string(compression),
                    "must be compressed by zstd, or not at all");
    // Memory for the claimed size is allocated only if the compressed frame claims the same size, since the size of the
    // compressed bytes limits it.
    if (ZSTD_getFrameContentSize(records.data(), records.size()) != size)
        damaged(where, "", "has another size than its compressed data states");
    std::string result(std::size_t(size), '\0');
    const std::size_t count = ZSTD_decompress(result.data(), result.size(), records.data(), records.size());
    if (ZSTD_isError(count) != 0 || count != result.size())
        damaged(where, ZSTD_isError(count) != 0 ? ZSTD_getErrorName(count) : "", "cannot be decompressed");
    return result;
}

std::string McapReader::load_start(std::size_t chunk) const {
    const ChunkPlace& place = chunks_[chunk];
    const std::string where = what_ + ": chunk at byte " + std::to_string(place.offset);
    const std::string start = bytes_.read(place.offset, std::min(place.size, looked_at));
    RecordReader fields(start, where);
    fields.take(record_start + 8 + 8 + 8 + 4); // times, size, checksum
    if (!fields.text().empty()) return load(chunk);
    fields.number<std::uint64_t>(); // size
    return std::string(fields.rest());
}

std::string_view McapReader::start_of_message(std::string_view records) const {
    RecordReader from(records, what_);
    const auto opcode = from.number<std::uint8_t>();
    if (Opcode(opcode) != Opcode::message)
        damaged(what_ + ": chunk", std::to_string(opcode), "must begin with a message");
    from.take(8 + 2 + 4 + 8 + 8); // size, channel, sequence, times
    return from.rest();
}

std::string McapReader::load(std::size_t chunk) const {
    const ChunkPlace& place = chunks_[chunk];
    const std::string where = what_ + ": chunk at byte " + std::to_string(place.offset);
    const std::string content = record_at(place.offset, place.size, Opcode::chunk);
    RecordReader fields(content, where);
    fields.take(8 + 8); // times
    const auto size = fields.number<std::uint64_t>();
    const auto checksum = fields.number<std::uint32_t>();
    const std::string_view compression = fields.text();
    std::string records = unpacked(compression, fields.take(fields.number<std::uint64_t>()), size, where);
    if (checksum != 0 && files::crc32(records) != checksum) damaged(where, "", "is damaged: its checksum does not fit");
    return records;
}

} // namespace cairn::recording
