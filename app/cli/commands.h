// The commands of the program. Each returns the program's exit code, and throws std::exception for errors at run time,
// which `main` prints in one line.
#pragma once

#include "cli/trajectory_writer.h"
#include "scene/scene.h"

#include <cairn/world.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace cairn::cli {

// Options for reading input files, mainly robot models.
struct ReadOptions {
    bool fixed_base = false, floor = false, decompose = false;
    // `listener`: receives all commands that build the world.
    scene::Scene load(const std::filesystem::path& path, std::shared_ptr<CommandListener> listener = nullptr) const;
};

struct RunOptions {
    std::string scene;
    ReadOptions read;
    std::optional<double> seconds;   // simulated; at most one of seconds and frames
    std::optional<int> frames;       // steps
    std::optional<double> time_step; // s; the scene's own otherwise
    std::optional<int> substeps;     // default: the scene's own
    std::optional<Integrator> integrator;
    std::optional<int> threads;                           // default: all
    std::filesystem::path csv, png, video, save, animate; // empty: not written
    int width = 1280, height = 720;                       // of pictures, pixels
    std::vector<Quantity> columns = default_quantities;   // of the table
    int every = 1;                                        // steps between rows of table and animation
    double from = 0.0;                                    // s; start of table, animation and video
    std::optional<double> until;                          // s; end of these outputs
    std::filesystem::path targets;                        // joint targets; empty: none
    // Hz, for all motors that follow targets; default: 10, for those without stiffness only
    std::optional<double> servo_frequency;
    std::filesystem::path checkpoint, resume; // folders; empty: no checkpoints; start from the beginning
    std::optional<int> checkpoint_every;      // steps; excludes checkpoint_seconds
    std::optional<double> checkpoint_seconds; // s of wall-clock time; default 600
    int keep = 2;                             // number of checkpoints to keep
    bool json = false;
};

int run_command(const RunOptions& options);

struct ScenesOptions {
    std::filesystem::path folder; // empty: the scenes that come with Cairn
    bool json = false, names = false;
};

int scenes_command(const ScenesOptions& options);

struct DoctorOptions {
    bool json = false;
};

int doctor_command(const DoctorOptions& options);

struct CompletionOptions {
    std::string shell;
};

struct ConvertOptions {
    ReadOptions read;
    std::filesystem::path input, output; // a scene, a model or a mesh; .gltf or .glb
    std::optional<bool> as_hull;         // for meshes; default: a hull
    std::optional<double> scale;         // m per unit of a mesh; default 1
    std::optional<double> density;       // kg/m^3; default 1000
};

int convert_command(const ConvertOptions& options);

struct ViewOptions {
    std::string scene;
    ReadOptions read;
    int width = 1280, height = 720;   // of the window
    std::optional<double> exit_after; // s
    std::filesystem::path report, script;
};

int view_command(const ViewOptions& options);

struct SweepOptions {
    std::filesystem::path plan;
    std::filesystem::path out;           // folder; empty: named after the plan
    std::optional<int> threads;          // default: all; under mpirun one per process
    std::uint64_t shard = 0, shards = 0; // 1-based part number and number of parts; 0 of 0: all rows
    std::optional<std::uint64_t> row;    // run this row only
    bool resume = false, check = false, json = false;
};

// Returns 1 if the sweep is incomplete at the end.
int sweep_command(const SweepOptions& options);

struct FitOptions {
    std::filesystem::path plan, data;
    std::optional<int> threads; // default: all
    std::optional<std::uint64_t> evaluations;
    bool json = false;
};

int fit_command(const FitOptions& options);

struct ValidateOptions {
    std::vector<std::string> cases; // names or numbers; empty: all
    std::filesystem::path report;   // folder; empty: not written
    bool json = false;
};

struct RecordOptions {
    std::string scene;
    ReadOptions read;
    std::filesystem::path output;    // .mcap
    std::optional<double> seconds;   // simulated; at most one of seconds and frames
    std::optional<int> frames;       // steps
    std::optional<double> time_step; // s; the scene's own otherwise
    std::optional<int> threads;      // default: all
    double keyframes = 128.0;        // MB for all keyframes
    bool compress = true;
    std::vector<std::string> readings;   // poses, contacts, joints, statistics, events, all
    std::optional<double> readings_rate; // Hz; default: after each step
};

int record_command(const RecordOptions& options);

struct ReplayOptions {
    std::filesystem::path recording, save; // empty `save`: not written
    bool verify = false, json = false;
    std::optional<int> threads; // default: all
    std::optional<double> at;   // s
    std::vector<std::string> what_if;
};

// Returns 1 if the replay diverges from the recording.
int replay_command(const ReplayOptions& options);

struct InfoOptions {
    std::filesystem::path recording;
    bool json = false;
};

int info_command(const InfoOptions& options);

struct DiffOptions {
    std::filesystem::path first, second;
    std::optional<int> threads; // default: all
};

// Returns 1 if the recordings differ.
int diff_command(const DiffOptions& options);

// Returns 1 if any row fails.
int validate_command(const ValidateOptions& options);

} // namespace cairn::cli
