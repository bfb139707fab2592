// The commands of the program. Each returns the program's exit code, and throws std::exception for what went
// wrong at run time, which `main` prints in one line.
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

// Of files that are read: robots above all.
struct ReadOptions {
    bool fixed_base = false, floor = false, decompose = false;
    // `listener`: is told of all that makes the world.
    scene::Scene load(const std::filesystem::path& path, std::shared_ptr<CommandListener> listener = nullptr) const;
};

struct RunOptions {
    std::string scene;
    ReadOptions read;
    std::optional<double> seconds;   // simulated; at most one of seconds and frames
    std::optional<int> frames;       // steps
    std::optional<double> time_step; // s; the scene's own otherwise
    std::optional<int> substeps;     // the scene's own otherwise
    std::optional<Integrator> integrator;
    std::optional<int> threads;                           // all otherwise
    std::filesystem::path csv, png, video, save, animate; // empty: do not write
    int width = 1280, height = 720;                       // of pictures, pixels
    std::vector<Quantity> columns = default_quantities;   // of the csv
    int every = 1;                                        // steps, of csv and animation
    double from = 0.0;                                    // s; csv, animation and video begin there
    std::optional<double> until;                          // s; and end there
    std::filesystem::path targets;                        // of joints; empty: none
    std::optional<double> servo_frequency;    // Hz, of motors that follow them; else of those without a stiffness: 10
    std::filesystem::path checkpoint, resume; // folders; empty: no checkpoints, from the beginning
    std::optional<int> checkpoint_every;      // steps; at most one of this and the next
    std::optional<double> checkpoint_seconds; // s of the clock; 600 otherwise
    int keep = 2;                             // checkpoints
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
    std::optional<bool> as_hull;         // of meshes; a hull otherwise
    std::optional<double> scale;         // m of one unit of a mesh; 1 otherwise
    std::optional<double> density;       // kg/m^3; 1000 otherwise
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
    std::filesystem::path out;           // a folder; empty: named after the plan
    std::optional<int> threads;          // all otherwise; one for each process under mpirun
    std::uint64_t shard = 0, shards = 0; // 0 of 0: all of it; else the part of that number, from 1
    std::optional<std::uint64_t> row;    // that row alone
    bool resume = false, check = false, json = false;
};

// 1 if it is not complete at the end.
int sweep_command(const SweepOptions& options);

struct FitOptions {
    std::filesystem::path plan, data;
    std::optional<int> threads; // all otherwise
    std::optional<std::uint64_t> evaluations;
    bool json = false;
};

int fit_command(const FitOptions& options);

struct ValidateOptions {
    std::vector<std::string> cases; // names or numbers; empty: all
    std::filesystem::path report;   // a folder; empty: do not write
    bool json = false;
};

struct RecordOptions {
    std::string scene;
    ReadOptions read;
    std::filesystem::path output;    // .mcap
    std::optional<double> seconds;   // simulated; at most one of seconds and frames
    std::optional<int> frames;       // steps
    std::optional<double> time_step; // s; the scene's own otherwise
    std::optional<int> threads;      // all otherwise
    double keyframes = 128.0;        // MB, for all of them
    bool compress = true;
    std::vector<std::string> readings;   // poses, contacts, joints, statistics, events, all
    std::optional<double> readings_rate; // Hz; each step otherwise
};

int record_command(const RecordOptions& options);

struct ReplayOptions {
    std::filesystem::path recording, save; // save: empty: do not write
    bool verify = false, json = false;
    std::optional<int> threads; // all otherwise
    std::optional<double> at;   // s
    std::vector<std::string> what_if;
};

// 1 if it led elsewhere than recorded.
int replay_command(const ReplayOptions& options);

struct InfoOptions {
    std::filesystem::path recording;
    bool json = false;
};

int info_command(const InfoOptions& options);

struct DiffOptions {
    std::filesystem::path first, second;
    std::optional<int> threads; // all otherwise
};

// 1 if they differ.
int diff_command(const DiffOptions& options);

// 1 if any row fails.
int validate_command(const ValidateOptions& options);

} // namespace cairn::cli
