// The contents of a recording, and where they are in its file.
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
        std::size_t chunk = 0, message = 0; // index into `log_chunks`, and of a log message in that chunk
    };
    struct Keyframe {
        std::uint64_t step = 0, number = 0; // number: of the state, or of the snapshot in files of older versions
        bool is_snapshot = false;
        LogPlace next; // where the log continues
    };
    struct Batch { // one message of the log
        std::uint64_t first_step = 0;
        LogPlace place;
    };
    struct StatePlace {
        std::size_t chunk = 0;    // index of a chunk of the file
        std::uint64_t parent = 0; // 0: none
    };
    struct GeometryPlace {
        std::size_t chunk = 0, offset = 0, size = 0; // chunk of the file, and range in its records
    };
    struct StepRun {             // consecutive steps of equal length
        std::uint64_t first = 0; // number of its first step
        double time = 0;         // s: at its beginning
        float length = 0;        // s, of each step
    };
    McapReader file;
    std::optional<std::uint16_t> log, geometry, keyframe, snapshot, state; // channel numbers
    std::vector<std::size_t> log_chunks, snapshot_chunks;                  // chunks of the file
    std::vector<GeometryPlace> geometries;                                 // by number
    std::vector<Keyframe> keyframes;                                       // by step
    std::vector<Batch> batches;                                            // by step
    std::map<std::uint64_t, StatePlace> states;                            // by number
    std::vector<StepRun> runs;                                             // consecutive
    RecordingInfo info;

    std::string where(const std::string& what) const { return file.name() + ": " + what; }

  private:
    void read_chunk(std::size_t chunk);
    void read_batch(std::string_view message);
    void read_keyframe(std::string_view message, std::size_t log_messages);
    void read_state(std::size_t chunk);
    LogPlace place_after(std::uint64_t step) const;
};

// One entry of the log.
struct LogEntry {
    enum class Kind { command, digest, end };
    Kind kind = Kind::end;
    std::span<const std::byte> command; // valid until the next entry is read
    StateDigest digest;
};

// Reads the entries of one log message.
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
    std::size_t chunk_ = 0;                  // the next chunk to load
    std::string records_;                    // records of the chunk loaded last
    std::vector<std::string_view> messages_; // its log messages
    std::size_t message_ = 0;                // the next message
    std::optional<BatchReader> batch_;
    std::optional<LogEntry> entry_;
};

// Reads geometry, snapshots and states by number. Geometry is cached; of snapshots and states, only the last one.
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
    std::string defined_by_; // for a state: the bytes that `snapshot_.definitions` were read from
};

} // namespace cairn::recording
