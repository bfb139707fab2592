// Joints that follow a table: `cairn run robot.urdf --targets poses.csv`.
#pragma once

#include "scene/scene.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace cairn::cli {

// A table of numbers as comma-separated values (RFC 4180).
struct TargetTable {
    std::vector<std::string> names; // of the columns after the first
    std::vector<double> times;      // s, each later than the one before
    std::vector<double> values;     // row after row
    double value(std::size_t row, std::size_t column) const { return values[row * names.size() + column]; }
};

// Its first line names the columns: `time`, and joints. `file` stands for it in messages, which name line and column.
// Throws Error (invalid_file).
TargetTable read_targets(std::string_view text, const std::string& file);

// Turns the motors of hinges, sliders and universal joints into servos, and moves what they aim at.
class JointTargets {
  public:
    // Motors get a critically damped spring of that frequency (Hz), reckoned with all that hangs on the joint as it
    // stands; without a frequency those alone that have no stiffness, of 10 Hz. Throws Error (invalid_file, io), also
    // for names of joints that are not there.
    JointTargets(const std::filesystem::path& path, scene::Scene& scene, std::optional<double> frequency);

    // Before each step: aims at where the table is at its end, on a straight line between the rows, and before the
    // first and after the last of them at these; no faster than the joint's limit of speed. What follows does not
    // sleep.
    void apply(World& world, float time_step);

    // Where they have come to, to be restored into targets of the same table and scene. `place` stands for the bytes
    // in messages. Throws Error (invalid_file).
    std::vector<std::byte> save() const;
    void restore(std::span<const std::byte> bytes, const std::string& place);

  private:
    struct Follower {
        JointId joint;
        std::size_t axis = 0; // of the joint
        std::size_t column = 0;
        double speed = 0.0;    // rad/s or m/s; infinite: no limit
        double position = 0.0; // that it aims at now
        double velocity = 0.0;
    };
    double target(std::size_t column, double time) const;

    TargetTable table_;
    std::vector<Follower> followers_;
    double start_ = 0.0;
};

} // namespace cairn::cli
