/// \file recorder.h
/// Recordings: all changes made to a world, in a file that can be replayed with the same bits on any machine.
///
///     cairn::recording::Recorder recorder("run.mcap");
///     world.set_command_listener(recorder.listener());
///     for (int i = 0; i < 600; ++i) world.step(1 / 60.0f);
///     recorder.close();
///
/// docs/recordings.md describes the file. It contains the commands given to the world, but not the resulting states,
/// except for a digest of the state after each step.
#pragma once

#include <cairn/commands.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>

namespace cairn::recording {

/// Readings: messages written in addition to the commands, for programs that know nothing of Cairn, such as Foxglove,
/// Lichtblick, Rerun and PlotJuggler: in Foxglove's schemas, as Protocol Buffers. They cost time, and many times the
/// bytes of the commands.
struct Readings {
    bool poses = false;      ///< Poses of bodies (/tf), and their appearance (/scene).
    bool contacts = false;   ///< Contact forces as arrows (/contacts).
    bool joints = false;     ///< Joint positions (/joints), and forces, torques and gaps (/joint_loads).
    bool statistics = false; ///< Counts and energies (/statistics).
    bool events = false;     ///< Hits, breaks, trigger and sleep events, as lines of text (/events).
    bool any() const { return poses || contacts || joints || statistics || events; }
};

/// How a world is recorded.
struct RecorderOptions {
    bool compress = true; ///< With zstd.
    /// A keyframe is the full state of the world, which allows seeking to any step without starting from the beginning.
    /// The steps between two keyframes take about this long, s of processor time, > 0; longer where keeping a state
    /// would take more than a quarter of that time. The time is estimated from counts of bodies and pairs, not
    /// measured.
    double keyframe_work = 0.12;
    /// Bytes in the file for all keyframes; 0: no keyframes. When the budget is exceeded, every other keyframe is
    /// dropped, and the distance of later ones doubles. Dropped keyframes remain in files that are not closed, or not
    /// regular.
    std::size_t keyframe_budget = std::size_t{384'000'000};
    std::string source{}; ///< A description for people, such as the name of a scene.
    Readings readings{};
    double readings_interval = 0.0; ///< Simulated time between two readings, s, >= 0; 0: after each step.
};

/// Records the changes of a world to a file. A world has one listener, and so one recorder at a time. The recorder may
/// be destroyed before or after the world.
class Recorder {
  public:
    /// Opens the file, replacing an existing one. Throws `Error`: io, invalid_value.
    explicit Recorder(const std::filesystem::path& path, const RecorderOptions& options = {});
    /// As `close`, but write errors are ignored: call `close` to get them.
    ~Recorder();
    Recorder(const Recorder&) = delete;
    Recorder& operator=(const Recorder&) = delete;

    /// For `World::set_command_listener`: the recording begins there. If the world is new and empty, the file contains
    /// everything, and any build of Cairn with the same arithmetic can replay it; otherwise the first command is a
    /// snapshot, which other builds may refuse.
    /// If the file cannot be written, the call that changes the world throws `Error` (io) and changes nothing. The file
    /// then ends with what was written before, and later calls are not recorded.
    std::shared_ptr<CommandListener> listener() const;

    /// Writes a note about the recording under a name other than "cairn", to be read by `Recording::note`. Throws
    /// `Error`: io, invalid_value for the name. Does nothing after `close`.
    void note(const std::string& name, const std::map<std::string, std::string>& values);

    /// Finishes the file. Later changes are not recorded. Throws `Error` (io). A second call does nothing.
    void close();

    std::uint64_t steps() const; ///< Number of recorded steps.

  private:
    class Listener;
    std::shared_ptr<Listener> listener_;
};

} // namespace cairn::recording
