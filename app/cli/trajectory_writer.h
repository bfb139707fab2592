// Trajectories as comma-separated values: one line for each body and moment.
#pragma once

#include "files/output_file.h"

#include <cairn/world.h>

#include <filesystem>
#include <string>
#include <vector>

namespace cairn::cli {

// Columns: time (s), body (its place in the list of bodies, from 0), name, position of the body's origin (m),
// rotation as a quaternion, velocity of the center of mass (m/s), angular velocity (rad/s); all in world axes, with
// as many digits as are needed to read back the same number.
class TrajectoryWriter {
  public:
    // Throws Error (io). The bodies must outlive the writing.
    TrajectoryWriter(const std::filesystem::path& path, const World& world);

    void add(const World& world); // all bodies, now; throws Error (io)
    void close();                 // throws Error (io); a file that is not closed is not written

  private:
    files::OutputFile file_;
    std::vector<BodyId> bodies_;
    std::vector<std::string> names_; // quoted
};

} // namespace cairn::cli
