#include "recording/contents.h"

#include "recording/geometry_codec.h"
#include "recording/log_format.h"
#include "recording/patch.h"

#include <cairn/error.h>

#include <algorithm>

namespace cairn::recording {

namespace {

std::vector<std::byte> take_bytes(RecordReader& from) {
    const std::span<const std::byte> bytes = as_bytes(from.take(from.leb128()));
    return {bytes.begin(), bytes.end()};
}

// A snapshot, with its definitions if the message contains them.
struct SnapshotMessage {
    std::uint64_t number, definitions;
    std::vector<std::byte> bytes, definition_bytes;
    std::string_view shapes;
};
SnapshotMessage read_snapshot(std::string_view message, const std::string& where) {
    RecordReader from(message, where);
    SnapshotMessage result{};
    result.number = from.leb128(), result.definitions = from.leb128();
    result.bytes = take_bytes(from);
    if (result.number == result.definitions) {
        result.definition_bytes = take_bytes(from);
        result.shapes = from.rest();
    }
    return result;
}

} // namespace

Recording::Contents::Contents(InputBytes bytes)
    : file(std::move(bytes)), log(file.channel(topic_log)), geometry(file.channel(topic_geometry)),
      keyframe(file.channel(topic_keyframes)), snapshot(file.channel(topic_snapshots)),
      state(file.channel(topic_states)) {
    if (!log) {
        if (!file.is_cut_off())
            throw Error(ErrorCode::invalid_file, file.name(), "",
                        "is an MCAP file, but has no " + std::string(topic_log));
    }
    const auto has = [&](std::size_t chunk, const std::optional<std::uint16_t>& channel) {
        return channel && file.chunks()[chunk].channels.count(*channel) != 0;
    };
    const auto& values = file.metadata("cairn");
    if (const auto found = values.find("source"); found != values.end()) info.source = found->second;
    info.bytes = file.size(), info.whole_bytes = file.whole_bytes(), info.is_cut_off = file.is_cut_off();
    for (std::size_t i = 0; i < file.chunks().size(); ++i) {
        if (has(i, snapshot)) snapshot_chunks.push_back(i);
        if (has(i, state)) read_state(i);
        if (has(i, snapshot) || has(i, state)) info.keyframe_bytes += file.chunks()[i].size;
        if (has(i, log) || has(i, geometry) || has(i, keyframe)) read_chunk(i);
    }
    std::erase_if(keyframes, [&](const Keyframe& k) { // truncated
        return k.step > info.steps || (k.is_snapshot && k.number >= snapshot_chunks.size());
    });
    for (Keyframe& k : keyframes)
        if (!k.is_snapshot) k.next = place_after(k.step);
    for (const Keyframe& k : keyframes) info.keyframes.push_back(k.step);
}

void Recording::Contents::read_chunk(std::size_t chunk) {
    const std::string records = file.load(chunk);
    std::size_t log_messages = 0;
    log_chunks.push_back(chunk);
    file.for_each_message(records, [&](const McapMessage& message) {
        if (message.channel == log) {
            batches.push_back({info.steps, {log_chunks.size() - 1, log_messages}});
            read_batch(message.data);
            ++log_messages;
        } else if (message.channel == geometry) {
            const std::string name = where("geometry");
            RecordReader from(message.data, name);
            const std::uint64_t number = from.leb128();
            if (number != geometries.size())
                throw Error(ErrorCode::invalid_file, name, std::to_string(number),
                            "must have number " + std::to_string(geometries.size()));
            geometries.push_back({chunk, std::size_t(from.rest().data() - records.data()), from.rest().size()});
        } else if (message.channel == keyframe) {
            read_keyframe(message.data, log_messages);
        }
    });
}

void Recording::Contents::read_batch(std::string_view message) {
    const std::string name = where("log");
    BatchReader batch(message, name);
    if (batch.first_step() != info.steps)
        throw Error(ErrorCode::invalid_file, name, std::to_string(batch.first_step()),
                    "must continue after " + std::to_string(info.steps) + " steps");
    for (;;) {
        const LogEntry entry = batch.next();
        if (entry.kind == LogEntry::Kind::end) break;
        if (entry.kind == LogEntry::Kind::digest) continue;
        const std::string call(command_name(entry.command));
        if (info.commands.empty()) info.is_from_start = call != "World::restore";
        ++info.commands[call.empty() ? "unknown" : call];
        if (!is_step(entry.command)) continue;
        if (runs.empty() || runs.back().length != step_length(entry.command))
            runs.push_back({info.steps, info.seconds, step_length(entry.command)});
        ++info.steps;
        info.seconds += double(step_length(entry.command));
    }
}

void Recording::Contents::read_keyframe(std::string_view message, std::size_t log_messages) {
    const std::string name = where("keyframe");
    RecordReader from(message, name);
    Keyframe k{from.leb128(), from.leb128(), true, {log_chunks.size() - 1, log_messages}};
    if (k.step != info.steps)
        throw Error(ErrorCode::invalid_file, name, std::to_string(k.step),
                    "must be the number of steps before the keyframe, " + std::to_string(info.steps));
    keyframes.push_back(k);
}

// Notes where a state is, without reading it.
void Recording::Contents::read_state(std::size_t chunk) {
    const std::string name = where("state"), records = file.load_start(chunk);
    RecordReader from(file.start_of_message(records), name);
    if (const std::uint64_t version = from.leb128(); version != states_version)
        throw Error(ErrorCode::unsupported, name, "version " + std::to_string(version),
                    "was written by a later version");
    Keyframe k;
    k.step = from.leb128(), k.number = from.leb128();
    const std::uint64_t parent = from.leb128();
    if (k.number <= parent || (parent != 0 && states.count(parent) == 0) ||
        (!keyframes.empty() && keyframes.back().step >= k.step) ||
        !states.try_emplace(k.number, StatePlace{chunk, parent}).second)
        throw Error(ErrorCode::invalid_file, name, std::to_string(k.number),
                    "must come after the keyframe from which it differs, " + std::to_string(parent));
    keyframes.push_back(k);
}

// The place in the log after this many steps, which is always the beginning of a message.
Recording::Contents::LogPlace Recording::Contents::place_after(std::uint64_t step) const {
    const auto found =
        std::lower_bound(batches.begin(), batches.end(), step,
                         [](const Batch& batch, std::uint64_t value) { return batch.first_step < value; });
    if (found == batches.end()) return {log_chunks.size(), 0};
    if (found->first_step != step)
        throw Error(ErrorCode::invalid_file, where("state after " + std::to_string(step) + " steps"), "",
                    "must be at the start of a message of the log");
    return found->place;
}

LogEntry BatchReader::next() {
    LogEntry entry;
    if (from_.is_empty()) return entry;
    const std::uint64_t size = from_.leb128();
    if (size == 0) {
        entry.kind = LogEntry::Kind::digest;
        for (std::uint64_t& sum : entry.digest.sums) sum = from_.number<std::uint64_t>();
        return entry;
    }
    entry.kind = LogEntry::Kind::command;
    entry.command = as_bytes(from_.take(size));
    return entry;
}

void LogCursor::move_to(Recording::Contents::LogPlace place) {
    entry_.reset(), batch_.reset(), messages_.clear();
    chunk_ = place.chunk;
    message_ = 0;
    if (place.message == 0) return;
    records_ = contents_.file.load(contents_.log_chunks[chunk_++]);
    contents_.file.for_each_message(records_, [&](const McapMessage& m) {
        if (m.channel == contents_.log) messages_.push_back(m.data);
    });
    message_ = place.message;
}

const LogEntry& LogCursor::peek() {
    while (!entry_) {
        if (batch_) {
            const LogEntry entry = batch_->next();
            if (entry.kind == LogEntry::Kind::end)
                batch_.reset();
            else
                entry_ = entry;
        } else if (message_ < messages_.size()) {
            batch_.emplace(messages_[message_++], what_);
        } else if (chunk_ < contents_.log_chunks.size()) {
            messages_.clear();
            message_ = 0;
            records_ = contents_.file.load(contents_.log_chunks[chunk_++]);
            contents_.file.for_each_message(records_, [&](const McapMessage& m) {
                if (m.channel == contents_.log) messages_.push_back(m.data);
            });
        } else {
            entry_.emplace();
        }
    }
    return *entry_;
}

const Shape& Parts::shape(std::uint64_t number) {
    const std::string name = contents_.where("geometry " + std::to_string(number));
    if (number >= shapes_.size()) throw Error(ErrorCode::invalid_file, name, "", "is not in the recording");
    std::optional<Shape>& shape = shapes_[std::size_t(number)];
    if (!shape) {
        const Recording::Contents::GeometryPlace& place = contents_.geometries[std::size_t(number)];
        const std::string records = contents_.file.load(place.chunk);
        shape = decode_geometry(std::string_view(records).substr(place.offset, place.size), name);
    }
    return *shape;
}

std::string Parts::snapshot_message(std::uint64_t number) const {
    const std::string name = contents_.where("snapshot " + std::to_string(number));
    if (number >= contents_.snapshot_chunks.size())
        throw Error(ErrorCode::invalid_file, name, "", "is not in the recording");
    const std::string records = contents_.file.load(contents_.snapshot_chunks[std::size_t(number)]);
    std::string message;
    contents_.file.for_each_message(records, [&](const McapMessage& m) {
        if (m.channel == contents_.snapshot) message = m.data;
    });
    return message;
}

std::shared_ptr<const SnapshotDefinitions> Parts::definitions(std::uint64_t number) {
    const std::string name = contents_.where("snapshot " + std::to_string(number));
    const std::string message = snapshot_message(number);
    std::shared_ptr<const SnapshotDefinitions>& kept = definitions_[std::size_t(number)];
    if (kept) return kept;
    SnapshotMessage read = read_snapshot(message, name);
    if (read.number != number || read.definitions != number)
        throw Error(ErrorCode::invalid_file, name, "", "must have definitions, and its own number");
    auto made = std::make_shared<SnapshotDefinitions>();
    made->bytes = std::move(read.definition_bytes);
    made->shapes = decode_shapes(as_bytes(read.shapes), *this);
    return kept = std::move(made);
}

const Snapshot& Parts::snapshot(std::uint64_t number) {
    const std::string message = snapshot_message(number);
    SnapshotMessage read = read_snapshot(message, contents_.where("snapshot " + std::to_string(number)));
    snapshot_.definitions = definitions(read.definitions);
    defined_by_.clear();
    snapshot_.bytes = std::move(read.bytes);
    return snapshot_;
}

// Restores the bytes of a state from its patch and those of its ancestors.
std::string Parts::state_bytes(std::uint64_t number) const {
    std::vector<std::uint64_t> way; // from the state to an ancestor without parent; parents have lower numbers
    for (std::uint64_t at = number; at != 0; at = contents_.states.at(at).parent) way.push_back(at);
    std::string bytes;
    for (; !way.empty(); way.pop_back()) {
        const std::string name = contents_.where("state " + std::to_string(way.back()));
        const std::string records = contents_.file.load(contents_.states.at(way.back()).chunk);
        contents_.file.for_each_message(records, [&](const McapMessage& message) {
            if (message.channel != contents_.state) return;
            RecordReader from(message.data, name);
            for (int field = 0; field < 4; ++field) from.leb128(); // version, step, number, parent
            bytes = patched(bytes, from.rest(), name);
        });
    }
    return bytes;
}

const Snapshot& Parts::state_of(const Recording::Contents::Keyframe& keyframe) {
    if (keyframe.is_snapshot) return snapshot(keyframe.number);
    const std::string name = contents_.where("state " + std::to_string(keyframe.number));
    const std::string bytes = state_bytes(keyframe.number);
    RecordReader from(bytes, name);
    snapshot_.bytes = take_bytes(from);
    if (const std::string_view defined_by = from.rest(); !snapshot_.definitions || defined_by_ != defined_by) {
        auto made = std::make_shared<SnapshotDefinitions>();
        made->bytes = take_bytes(from);
        made->shapes = decode_shapes(as_bytes(from.rest()), *this);
        defined_by_ = defined_by;
        snapshot_.definitions = std::move(made);
    }
    return snapshot_;
}

} // namespace cairn::recording
