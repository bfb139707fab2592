// What a recording is made of, in its file.
#pragma once

#include "recording/mcap_reader.h"
#include "recording/recording.h"

#include <cairn/commands.h>

#include <deque>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace cairn::recording {

struct Recording::Contents {
    explicit Contents(InputBytes bytes);

    struct LogPlace {
        std::size_t chunk = 0, message = 0; // in `log_chunks`, and of its messages of the log
    };
    struct Keyframe {
        std::uint64_t step = 0, number = 0; // of its state, or of its snapshot, as older versions have them
        bool is_snapshot = false;
        LogPlace next; // what follows
    };
    struct Batch { // a message of the log
        std::uint64_t first_step = 0;
        LogPlace place;
    };
    struct StatePlace {
        std::size_t chunk = 0;    // of the file
        std::uint64_t parent = 0; // 0: none
    };
    struct GeometryPlace {
        std::size_t chunk = 0, offset = 0, size = 0; // in the records of a chunk of the file
    };
    struct StepRun {
        std::uint64_t first = 0; // step
        double time = 0;         // s: when it begins
        float length = 0;        // s, of all of them
    };
    McapReader file;
    std::optional<std::uint16_t> log, geometry, keyframe, snapshot, state; // channels
    std::vector<std::size_t> log_chunks, snapshot_chunks;                  // of the file
    std::vector<GeometryPlace> geometries;                                 // by number
    std::vector<Keyframe> keyframes;                                       // by step
    std::vector<Batch> batches;                                            // by step
    std::map<std::uint64_t, StatePlace> states;                            // by number
    std::vector<StepRun> runs;                                             // of steps of one length
    RecordingInfo info;

    std::string where(const std::string& what) const { return file.name() + ": " + what; }

  private:
    void read_chunk(std::size_t chunk);
    void read_batch(std::string_view message);
    void read_keyframe(std::string_view message, std::size_t log_messages);
    void read_state(std::size_t chunk);
    LogPlace place_after(std::uint64_t step) const;
};

// What a log has, one after the other.
struct LogEntry {
    enum class Kind { command, digest, end };
    Kind kind = Kind::end;
    std::span<const std::byte> command; // valid until the next entry is asked for
    StateDigest digest;
};

// The entries of one message.
class BatchReader {
  public:
    BatchReader(std::string_view message, const std::string& where) : from_(message, where) {
        first_step_ = from_.leb128();
    }
    std::uint64_t first_step() const { return first_step_; }
    LogEntry next();

  private:
    RecordReader from_;
    std::uint64_t first_step_;
};

class LogCursor {
  public:
    explicit LogCursor(const Recording::Contents& contents) : contents_(contents), what_(contents.where("log")) {}
    void move_to(Recording::Contents::LogPlace place);
    const LogEntry& peek();
    void take() { entry_.reset(); }

  private:
    const Recording::Contents& contents_;
    std::string what_;
    std::size_t chunk_ = 0;                  // the next one to load
    std::string records_;                    // of the one before
    std::vector<std::string_view> messages_; // of the log, in it
    std::size_t message_ = 0;                // the next one
    std::optional<BatchReader> batch_;
    std::optional<LogEntry> entry_;
};

// Geometry, snapshots and states by their numbers; what was asked for once is kept, of snapshots and states the last
// one.
class Parts final : public CommandSource {
  public:
    explicit Parts(const Recording::Contents& contents)
        : contents_(contents), shapes_(contents.geometries.size()), definitions_(contents.snapshot_chunks.size()) {}
    const Shape& shape(std::uint64_t number) override;
    const Snapshot& snapshot(std::uint64_t number) override;
    const Snapshot& state_of(const Recording::Contents::Keyframe& keyframe);

  private:
    std::string snapshot_message(std::uint64_t number) const;
    std::string state_bytes(std::uint64_t number) const;
    std::shared_ptr<const SnapshotDefinitions> definitions(std::uint64_t number);

    const Recording::Contents& contents_;
    std::vector<std::optional<Shape>> shapes_;
    std::vector<std::shared_ptr<const SnapshotDefinitions>> definitions_;
    Snapshot snapshot_;
    std::string defined_by_; // what `snapshot_.definitions` were read from, of a state
};

} // namespace cairn::recording
