/// \file recording.h
/// Reading recordings (recorder.h), and seeking to any of their steps.
///
///     const cairn::recording::Recording recording("run.mcap");
///     cairn::recording::Replay replay(recording);
///     while (replay.step()) {}
///     if (replay.divergence()) std::puts(replay.divergence()->text().c_str());
///
/// Everything here throws `cairn::Error`: `invalid_file` for damaged files, `unsupported` for files written by a later
/// version, `io` for read errors. The message names the file and the place in it.
#pragma once

#include <cairn/world.h>

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace cairn::recording {

/// Properties of a recording.
struct RecordingInfo {
    std::string source;            ///< `RecorderOptions::source`.
    std::uint64_t bytes = 0;       ///< Size of the file.
    std::uint64_t whole_bytes = 0; ///< Up to the end of the last complete record; equal to `bytes` unless truncated.
    bool is_cut_off = false;       ///< The file was not closed by the program that wrote it.
    bool is_from_start = false;    ///< It begins with an empty world, so that other builds can replay it.
    std::uint64_t steps = 0;       ///< Number of recorded steps.
    double seconds = 0;            ///< Simulated time, the sum of all step lengths.
    std::map<std::string, std::uint64_t> commands; ///< Number of commands by call, such as "World::step".
    std::vector<std::uint64_t> keyframes;          ///< The steps after which there is a keyframe.
    std::uint64_t keyframe_bytes = 0;              ///< Size of all keyframes in the file.
};

/// A recording in a file, which must not change. The constructor reads all commands once; large data is read on demand.
class Recording {
  public:
    explicit Recording(const std::filesystem::path& path);
    ~Recording();
    Recording(Recording&&) noexcept;
    Recording& operator=(Recording&&) = delete;

    /// A recording in memory. `name` replaces the file name in messages.
    static Recording from_memory(std::string bytes, const std::string& name);

    const RecordingInfo& info() const;
    /// The values written by `Recorder::note` under this name; empty if there are none.
    const std::map<std::string, std::string>& note(const std::string& name) const;
    /// The number of steps that end by this time, s since the beginning of the recording, with a tolerance of a
    /// thousandth of a step for the last one; all steps if the recording is shorter.
    std::uint64_t steps_until(double seconds) const;

    struct Contents; ///< For internal use.

  private:
    friend class Replay;
    friend class CallReader;
    explicit Recording(std::unique_ptr<Contents> contents);
    std::unique_ptr<Contents> contents_;
};

/// One recorded call.
struct RecordedCall {
    std::vector<std::byte> command; ///< For `World::execute`.
    bool is_step = false;
    std::optional<StateDigest> digest; ///< Of the state after a step, as recorded.
};

/// Reads the recorded calls one by one, for users who execute them on a world of their own; `Replay` does so by itself.
class CallReader {
  public:
    explicit CallReader(const Recording& recording); ///< `recording` must outlive this object and `source()`.
    ~CallReader();
    /// Reads the next call; returns false at the end. For a digest that follows no step, the command is empty.
    bool next(RecordedCall& call);
    /// The source for all of these commands; thread-safe.
    std::shared_ptr<CommandSource> source() const;
    /// The last keyframe after more than `after` and at most `until` steps, with the number of its steps.
    /// `World::restore` refuses keyframes of other builds (unsupported).
    std::optional<std::pair<std::uint64_t, Snapshot>> keyframe(std::uint64_t after, std::uint64_t until);

  private:
    struct State;
    std::unique_ptr<State> state_;
};

/// The first difference between a replay and its recording.
struct Divergence {
    std::uint64_t step = 0;     ///< The first step after which the states differ, counted from 1.
    std::vector<BodyId> bodies; ///< The bodies that differ if they are one or two; otherwise empty.
    std::string names;          ///< Names and numbers of these bodies.
    std::string text() const;   ///< For example "step 12: body 3 \"crate\" differs".
};

/// A world that executes the commands of a recording.
class Replay {
  public:
    /// `recording` must outlive this object. `threads`: of the world, 1 to 256; results do not depend on it.
    explicit Replay(const Recording& recording, int threads = 1);
    ~Replay();
    Replay(Replay&&) noexcept;
    Replay& operator=(Replay&&) = delete;

    /// Executes the commands up to and including the next step. If no step is left, executes the remaining commands and
    /// returns false. If a command cannot be executed, its exception is thrown, with the number of the step, and the
    /// world is as it was before that command.
    bool step();
    /// Goes to the state after `step` steps, before the commands that follow, from the nearest keyframe before it or
    /// from the beginning. Throws `Error` (invalid_value) if the recording has fewer steps. Keyframes of another build
    /// of Cairn cannot be used; seeking then takes longer.
    void seek(std::uint64_t step);
    std::uint64_t steps() const; ///< Number of steps executed.
    /// The first step whose result differs from the recording, since the beginning or the last `seek`.
    const std::optional<Divergence>& divergence() const;

    World& world();
    const World& world() const;
    /// Allows changes of the world by the user: digests are not compared from now on.
    void branch();
    /// Number of calls that failed since `branch`, because their objects do not exist in the changed world;
    /// `first_refusal` describes the first of them.
    std::uint64_t refused_calls() const;
    const std::string& first_refusal() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace cairn::recording
