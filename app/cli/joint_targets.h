// Joint targets from a table: `cairn run robot.urdf --targets poses.csv`.
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
    std::vector<std::string> names; // of the columns after the time
    std::vector<double> times;      // s, strictly increasing
    std::vector<double> values;     // row-major
    double value(std::size_t row, std::size_t column) const { return values[row * names.size() + column]; }
};

// Parses a table. The first line names the columns: `time`, and joints. `file` is its name in messages, which state
// line and column. Throws Error (invalid_file).
TargetTable read_targets(std::string_view text, const std::string& file);

// Turns the motors of hinges, sliders and universal joints into servos, and moves their targets.
class JointTargets {
  public:
    // Motors get a critically damped spring of that frequency (Hz), computed from the effective mass of all bodies
    // attached to the joint in the initial pose; without a frequency, only motors without stiffness get one, of 10 Hz.
    // Throws Error (invalid_file, io), also for unknown joint names.
    JointTargets(const std::filesystem::path& path, scene::Scene& scene, std::optional<double> frequency);

    // To be called before each step: sets the targets to the table's values at the end of the step, interpolated
    // linearly between rows and constant before the first and after the last one, no faster than the joint's speed
    // limit. Joints with targets are kept awake.
    void apply(World& world, float time_step);

    // The present targets, to be restored with the same table and scene. `place` names the bytes in messages. Throws
    // Error (invalid_file).
    std::vector<std::byte> save() const;
    void restore(std::span<const std::byte> bytes, const std::string& place);

  private:
    struct Follower {
        JointId joint;
        std::size_t axis = 0; // index of the joint's axis
        std::size_t column = 0;
        double speed = 0.0;    // speed limit, rad/s or m/s; infinite: none
        double position = 0.0; // present target
        double velocity = 0.0;
    };
    double target(std::size_t column, double time) const;

    TargetTable table_;
    std::vector<Follower> followers_;
    double start_ = 0.0;
};

} // namespace cairn::cli
