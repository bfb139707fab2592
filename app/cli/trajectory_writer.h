// Trajectories as comma-separated values: one line for each body and moment.
#pragma once

#include <cairn/world.h>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace cairn::cli {

// Columns: time (s), body (its place in the list of bodies, from 0), name, position of the body's origin (m),
// rotation as a quaternion, velocity of the center of mass (m/s), angular velocity (rad/s); all in world axes, with
// as many digits as are needed to read back the same number.
// The file is written beside `path` under another name, and takes its name when `close` is called; without that,
// it is removed.
class TrajectoryWriter {
  public:
    // Throws Error (io). The bodies must outlive the writing.
    TrajectoryWriter(const std::filesystem::path& path, const World& world);
    ~TrajectoryWriter();
    TrajectoryWriter(const TrajectoryWriter&) = delete;
    TrajectoryWriter& operator=(const TrajectoryWriter&) = delete;

    void add(const World& world); // all bodies, now; throws Error (io)
    void close();                 // throws Error (io)

  private:
    void write(const std::string& text);

    std::filesystem::path path_, temporary_;
    std::FILE* file_ = nullptr;
    std::vector<BodyId> bodies_;
    std::vector<std::string> names_; // quoted
};

} // namespace cairn::cli
