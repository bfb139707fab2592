/// \file recorder.h
/// Recordings: all that was done to a world, in a file that plays back with the same bits on any machine.
///
///     cairn::recording::Recorder recorder("run.mcap");
///     world.set_command_listener(recorder.listener());
///     for (int i = 0; i < 600; ++i) world.step(1 / 60.0f);
///     recorder.close();
///
/// docs/recordings.md describes the file. What is done to a world is recorded; where the computing of it leads is not,
/// but for a digest of the state after each step.
#pragma once

#include <cairn/commands.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>

namespace cairn::recording {

/// What is written beside the commands for programs that know nothing of Cairn, such as Foxglove, Lichtblick, Rerun and
/// PlotJuggler: in Foxglove's schemas, as Protocol Buffers. It costs time and many times the bytes of the commands.
struct Readings {
    bool poses = false;      ///< Of bodies (/tf), and what they look like (/scene).
    bool contacts = false;   ///< Forces as arrows (/contacts).
    bool joints = false;     ///< Positions (/joints), and forces, torques and gaps (/joint_loads).
    bool statistics = false; ///< Counts and energies (/statistics).
    bool events = false;     ///< Hits, breaks, triggers, sleep, as lines (/events).
    bool any() const { return poses || contacts || joints || statistics || events; }
};

/// How a world is recorded.
struct RecorderOptions {
    bool compress = true; ///< By zstd.
    /// A keyframe is the whole state, to go to any moment without beginning from the start. From one to the next are
    /// steps that take about so long, s of a processor, > 0; more of them where keeping a state would take more than
    /// a quarter of that. It goes by counts of bodies and pairs, not by a clock.
    double keyframe_work = 0.12;
    /// Bytes in the file for all of them; 0: none. Where it is spent, every other one goes, and later ones come half as
    /// often. A file that is not closed still has them, and one that is no regular file.
    std::size_t keyframe_budget = std::size_t{384'000'000};
    std::string source{}; ///< What is recorded, for people: the name of a scene.
    Readings readings{};
    double readings_interval = 0.0; ///< s of simulated time from one to the next, >= 0; 0: after each step.
};

/// Writes what a world does to a file. A world has one listener: one recorder at a time. The recorder may end before or
/// after the world.
class Recorder {
  public:
    /// Opens the file, and replaces what is there. Throws `Error`: io, invalid_value.
    explicit Recorder(const std::filesystem::path& path, const RecorderOptions& options = {});
    /// As `close`, but what cannot be written is lost in silence: call `close` to know.
    ~Recorder();
    Recorder(const Recorder&) = delete;
    Recorder& operator=(const Recorder&) = delete;

    /// For `World::set_command_listener`: recording begins there. Of a world that is new and empty, everything is in
    /// the file, and any build of Cairn with the same arithmetic can replay it; of any other, the first command is a
    /// snapshot, which other builds may refuse.
    /// Where the file cannot be written, the call that changes the world throws `Error` (io) and changes nothing; the
    /// file then ends with what was written before, and later calls are not recorded.
    std::shared_ptr<CommandListener> listener() const;

    /// Notes something about the recording under a name other than "cairn", for `Recording::note`. Throws `Error`: io,
    /// invalid_value for that name. Nothing after `close`.
    void note(const std::string& name, const std::map<std::string, std::string>& values);

    /// Ends the file. What is done later is not recorded. Throws `Error` (io). A second call does nothing.
    void close();

    std::uint64_t steps() const; ///< Recorded so far.

  private:
    class Listener;
    std::shared_ptr<Listener> listener_;
};

} // namespace cairn::recording
