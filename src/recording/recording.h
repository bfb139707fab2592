/// \file recording.h
/// Reading recordings (recorder.h), and going to any moment of them.
///
///     const cairn::recording::Recording recording("run.mcap");
///     cairn::recording::Replay replay(recording);
///     while (replay.step()) {}
///     if (replay.divergence()) std::puts(replay.divergence()->text().c_str());
///
/// Everything here throws `cairn::Error`: `invalid_file` for what is damaged, `unsupported` for what a later version
/// has written, `io` for what cannot be read. The message names the file and the place in it.
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

/// What a recording has.
struct RecordingInfo {
    std::string source;                            ///< What was recorded, as the recorder was told.
    std::uint64_t bytes = 0;                       ///< Of the file.
    std::uint64_t whole_bytes = 0;                 ///< Up to the end of what is whole; `bytes`, unless it was cut off.
    bool is_cut_off = false;                       ///< It has no end: the program that wrote it did not close it.
    bool is_from_start = false;                    ///< It begins with an empty world: other builds can replay it.
    std::uint64_t steps = 0;                       ///< That it has.
    double seconds = 0;                            ///< Simulated, the sum of all steps.
    std::map<std::string, std::uint64_t> commands; ///< How many of each call, such as "World::step".
    std::vector<std::uint64_t> keyframes;          ///< The steps after which there is one.
    std::uint64_t keyframe_bytes = 0;              ///< Of them in the file.
};

/// A recording in a file, which must stay as it is. Opening reads all commands once; what is large is read when it is
/// needed.
class Recording {
  public:
    explicit Recording(const std::filesystem::path& path);
    ~Recording();
    Recording(Recording&&) noexcept;
    Recording& operator=(Recording&&) = delete;

    /// A recording in memory. `name` stands for the file in messages.
    static Recording from_memory(std::string bytes, const std::string& name);

    const RecordingInfo& info() const;
    /// What `Recorder::note` wrote under that name; empty if nothing.
    const std::map<std::string, std::string>& note(const std::string& name) const;
    /// How many steps are made by that time, s since the recording began; the last one may end a thousandth of a step
    /// later. All of them if it has no such time.
    std::uint64_t steps_until(double seconds) const;

    struct Contents; ///< For the library.

  private:
    friend class Replay;
    friend class CallReader;
    explicit Recording(std::unique_ptr<Contents> contents);
    std::unique_ptr<Contents> contents_;
};

/// One of the calls that were recorded.
struct RecordedCall {
    std::vector<std::byte> command; ///< For `World::execute`.
    bool is_step = false;
    std::optional<StateDigest> digest; ///< Of the state after a step, as it was recorded.
};

/// What was done to the recorded world, call by call, for who does it to a world of their own. `Replay` does that by
/// itself.
class CallReader {
  public:
    explicit CallReader(const Recording& recording); ///< `recording` must live as long, and longer than `source()`.
    ~CallReader();
    /// False at the end. Where a digest stands alone, the command is empty.
    bool next(RecordedCall& call);
    /// Of all of these commands; any thread may ask it.
    std::shared_ptr<CommandSource> source() const;
    /// The last keyframe after more than `after` steps and no more than `until`, and the number of its steps. Keyframes
    /// of another build are refused by `World::restore` (unsupported).
    std::optional<std::pair<std::uint64_t, Snapshot>> keyframe(std::uint64_t after, std::uint64_t until);

  private:
    struct State;
    std::unique_ptr<State> state_;
};

/// Where a replay came to something else than was recorded.
struct Divergence {
    std::uint64_t step = 0;     ///< The first step after which the states differ, counted from 1.
    std::vector<BodyId> bodies; ///< Those that differ, if they are one or two; else empty.
    std::string names;          ///< Of these, with their numbers.
    std::string text() const;   ///< "step 12: body 3 \"crate\" differs", and the like.
};

/// A world to which is done what was done to the recorded one.
class Replay {
  public:
    /// `recording` must live as long. `threads`: of the world, 1 to 256; results do not depend on it.
    explicit Replay(const Recording& recording, int threads = 1);
    ~Replay();
    Replay(Replay&&) noexcept;
    Replay& operator=(Replay&&) = delete;

    /// Executes the commands up to the next step, and that step. Where no step is left: the commands after the last
    /// one; the answer is false. A command that cannot be executed throws what it throws, with the number of the step;
    /// then the world is as it was before that command.
    bool step();
    /// Goes to the moment after so many steps, before the commands that follow, from the nearest keyframe before it or
    /// from the start. Throws `Error` (invalid_value) if there are not as many. Keyframes of another build of Cairn
    /// cannot be used: then the way is longer.
    void seek(std::uint64_t step);
    std::uint64_t steps() const; ///< How many are behind.
    /// The first step that led elsewhere than recorded, since the start or the last `seek`.
    const std::optional<Divergence>& divergence() const;

    World& world();
    const World& world() const;
    /// Changes made to the world by the user count from now on: digests are compared no longer.
    void branch();
    /// Calls that could not be made since `branch`, as what they were about is no more; at most the first of them is
    /// kept.
    std::uint64_t refused_calls() const;
    const std::string& first_refusal() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace cairn::recording
