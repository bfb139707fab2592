#include "recording/recorder.h"

#include "recording/geometry_codec.h"
#include "recording/keyframe_tree.h"
#include "recording/log_format.h"
#include "recording/mcap_writer.h"
#include "recording/patch.h"
#include "recording/readings.h"

#include <cairn/error.h>
#include <cairn/world.h>
#include <cairn/world_number.h>

#include <bit>
#include <cmath>
#include <cstring>
#include <exception>
#include <optional>
#include <unordered_map>

namespace cairn::recording {

namespace {

constexpr std::size_t batch_bytes = std::size_t{1} << 14, chunk_bytes = std::size_t{1} << 18;
constexpr std::uint64_t batch_steps = 60, chunk_steps = 300;
constexpr double keyframe_share = 0.25; // greatest share of the stepping work for keyframes

} // namespace

class Recorder::Listener final : public CommandListener {
  public:
    Listener(const std::filesystem::path& path, const RecorderOptions& options)
        : options_(options), file_(std::in_place, path, options.compress),
          keyframes_(options.keyframe_work, keyframe_share, options.keyframe_budget) {
        if (!(options.keyframe_work > 0) || !std::isfinite(options.keyframe_work))
            throw Error(ErrorCode::invalid_value, "RecorderOptions.keyframe_work",
                        std::to_string(options.keyframe_work), "must be finite and > 0");
        if (!(options.readings_interval >= 0) || !std::isfinite(options.readings_interval))
            throw Error(ErrorCode::invalid_value, "RecorderOptions.readings_interval",
                        std::to_string(options.readings_interval), "must be finite and >= 0");
        file_->metadata("cairn", {{"encoding", "1"}, {"source", options.source}});
        const std::uint16_t commands = file_->add_schema("cairn.Commands", "cairn", command_encoding());
        const std::uint16_t parts = file_->add_schema("cairn.Parts", "cairn", parts_encoding);
        log_ = file_->add_channel(commands, topic_log, log_encoding);
        geometry_ = file_->add_channel(parts, topic_geometry, log_encoding);
        snapshots_ = file_->add_channel(parts, topic_snapshots, log_encoding);
        states_ = file_->add_channel(parts, topic_states, log_encoding);
        if (options.readings.any()) readings_.emplace(*file_, options.readings, options.readings_interval);
    }

    void on_command(std::span<const std::byte> command) override {
        if (!file_) return;
        try {
            if (error_) std::rethrow_exception(error_);
            if (log_chunk_.size() + readings_chunk_.size() >= chunk_bytes || (is_step(command) && is_chunk_full()))
                write_chunks();
            if (batch_.size() >= batch_bytes) end_batch();
            if (batch_.empty()) append_leb128(batch_, steps_);
            append_leb128(batch_, command.size());
            batch_ += as_text(command);
            if (readings_ && changes_looks(command)) readings_->forget_looks();
        } catch (...) {
            file_.reset(); // including everything buffered
            throw;
        }
        if (is_step(command)) next_time_ = time_ + double(step_length(command));
    }

    void on_step(const World& world) noexcept override {
        if (!file_ || error_) return;
        try {
            ++steps_;
            batch_ += '\0'; // in place of a command size: a digest follows
            for (const std::uint64_t sum : world.state_digest().sums) RecordWriter(batch_).number(sum);
            if (steps_ - batch_start_ >= batch_steps) end_batch();
            const double step_length = next_time_ - time_;
            time_ = next_time_;
            if (keyframes_.is_due(world)) add_keyframe(world);
            if (readings_) readings_->add(readings_chunk_, world, time_, step_length);
        } catch (...) {
            error_ = std::current_exception(); // to be thrown by the next command
        }
    }

    std::uint64_t number_of(const Shape& shape) override {
        std::shared_ptr<const void> data = shared_geometry(shape);
        const auto [found, is_new] = geometry_numbers_.try_emplace(data.get(), geometry_numbers_.size());
        if (is_new && file_) {
            try {
                geometry_kept_.push_back(std::move(data)); // keeps the address unique
                std::string message;
                append_leb128(message, found->second);
                log_chunk_.add(geometry_, std::uint32_t(found->second), nanoseconds(),
                               message + encode_geometry(shape));
            } catch (...) {
                geometry_numbers_.erase(found);
                throw;
            }
        }
        return found->second;
    }

    std::uint64_t number_of(const Snapshot& given) override {
        const std::uint64_t number = snapshot_count_++;
        if (!file_) return number;
        const Snapshot snapshot = without_world(given); // so that the same run gives the same bytes in any world
        const bool has_definitions = given.definitions != last_definitions_;
        if (has_definitions) definitions_number_ = number;
        std::string message;
        append_leb128(message, number), append_leb128(message, definitions_number_);
        append_leb128(message, snapshot.bytes.size());
        message += as_text(snapshot.bytes);
        if (has_definitions) {
            append_leb128(message, snapshot.definitions->bytes.size());
            message += as_text(snapshot.definitions->bytes);
            message += as_text(encode_shapes(snapshot.definitions->shapes, *this));
            last_definitions_ = given.definitions;
        }
        snapshot_chunks_.emplace_back().add(snapshots_, std::uint32_t(number), nanoseconds(), message);
        return number;
    }

    void note(const std::string& name, const std::map<std::string, std::string>& values) {
        if (name == "cairn") throw Error(ErrorCode::invalid_value, "Recorder::note name", name, "is taken");
        if (file_) file_->metadata(name, values);
    }

    void close() {
        if (!file_) return;
        try {
            if (error_) std::rethrow_exception(error_);
            write_chunks();
            file_->close();
        } catch (...) {
            file_.reset();
            throw;
        }
        file_.reset();
        geometry_kept_.clear();
        last_definitions_.reset();
        kept_definitions_.reset();
    }

    std::uint64_t steps() const { return steps_; }

  private:
    std::uint64_t nanoseconds() const { return std::uint64_t(std::llround(time_ * 1e9)); }
    bool is_chunk_full() const {
        return steps_ - chunk_start_ >= chunk_steps || !snapshot_chunks_.empty() || !state_chunk_.is_empty();
    }

    void end_batch() {
        if (batch_.empty()) return;
        log_chunk_.add(log_, std::uint32_t(batch_start_), batch_time_, batch_);
        batch_.clear();
        batch_start_ = steps_;
        batch_time_ = nanoseconds();
    }

    // The log comes first, so that a file truncated after it lacks only a keyframe, not commands.
    void write_chunks() {
        end_batch();
        file_->write(log_chunk_);
        chunk_start_ = steps_;
        for (McapWriter::Chunk& chunk : snapshot_chunks_) file_->write(chunk);
        snapshot_chunks_.clear();
        if (!state_chunk_.is_empty()) {
            const std::uint64_t before = file_->bytes_written();
            const std::size_t number = file_->chunk_count();
            file_->write(state_chunk_);
            for (const std::size_t gone : keyframes_.settle(number, file_->bytes_written() - before))
                file_->leave_out(gone);
        }
        file_->write(readings_chunk_);
    }

    void add_keyframe(const World& world) {
        end_batch(); // the log continues after the keyframe with a new message, which Contents::place_after relies on
        const Snapshot saved = world.save(), snapshot = without_world(saved);
        std::string state;
        append_leb128(state, snapshot.bytes.size());
        state += as_text(snapshot.bytes);
        if (saved.definitions != kept_definitions_) {
            kept_definitions_ = saved.definitions;
            shapes_ = encode_shapes(snapshot.definitions->shapes, *this);
        }
        append_leb128(state, snapshot.definitions->bytes.size());
        state += as_text(snapshot.definitions->bytes);
        state += as_text(shapes_);
        const auto shared = std::make_shared<const std::string>(std::move(state));
        const KeyframeTree::Difference kept = keyframes_.add({shared, *shared});
        std::string message;
        for (const std::uint64_t number : {states_version, steps_, kept.id, kept.parent})
            append_leb128(message, number);
        state_chunk_.leave_uncompressed();
        state_chunk_.add(states_, std::uint32_t(kept.id), nanoseconds(),
                         message + patcher_.patch(kept.before ? kept.before->bytes : std::string_view(), *shared));
    }

    RecorderOptions options_;
    std::optional<McapWriter> file_; // empty: closed
    std::exception_ptr error_;       // of a step that could not be recorded
    std::uint16_t log_ = 0, geometry_ = 0, snapshots_ = 0, states_ = 0;

    std::string batch_;
    std::uint64_t steps_ = 0, batch_start_ = 0, chunk_start_ = 0, batch_time_ = 0;
    double time_ = 0, next_time_ = 0; // s since the beginning of the recording
    McapWriter::Chunk log_chunk_;
    std::vector<McapWriter::Chunk> snapshot_chunks_;
    std::optional<ReadingsWriter> readings_; // empty: not requested
    McapWriter::Chunk readings_chunk_;
    KeyframeTree keyframes_;
    Patcher patcher_;
    McapWriter::Chunk state_chunk_; // the last keyframe, until it is written
    std::shared_ptr<const SnapshotDefinitions> kept_definitions_;
    std::vector<std::byte> shapes_; // shapes of kept_definitions_

    std::unordered_map<const void*, std::uint64_t> geometry_numbers_;
    std::vector<std::shared_ptr<const void>> geometry_kept_;
    std::uint64_t snapshot_count_ = 0, definitions_number_ = 0;
    std::shared_ptr<const SnapshotDefinitions> last_definitions_;
};

Recorder::Recorder(const std::filesystem::path& path, const RecorderOptions& options)
    : listener_(std::make_shared<Listener>(path, options)) {}

Recorder::~Recorder() {
    try {
        close();
    } catch (const std::exception&) { // documented in the header
    }
}

std::shared_ptr<CommandListener> Recorder::listener() const { return listener_; }
void Recorder::note(const std::string& name, const std::map<std::string, std::string>& values) {
    listener_->note(name, values);
}
void Recorder::close() { listener_->close(); }
std::uint64_t Recorder::steps() const { return listener_->steps(); }

} // namespace cairn::recording
