#include "cli/command_line.h"

#include "cli/outputs.h"
#include "validation/validation.h"
#include "viewer/headless.h"

#include <cairn/version.h>

#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <string_view>
#include <vector>

namespace cairn::cli {

namespace {

// A range check; CLI11's own accepts NaN.
CLI::Validator between(double low, double high) {
    const std::string range = fmt::format("{} to {}", low, high);
    return CLI::Validator(
        [low, high, range](std::string& text) {
            double value = 0.0;
            const bool is_number = CLI::detail::lexical_cast(text, value);
            if (is_number && value >= low && value <= high) return std::string();
            return "must be a number from " + range + ", got " + text;
        },
        "(" + range + ")");
}

CLI::Validator one_of(std::vector<std::string> names, const std::string& remark = {}) {
    return CLI::Validator(
        [names, remark](std::string& text) {
            if (std::find(names.begin(), names.end(), text) != names.end()) return std::string();
            return fmt::format("must be one of {}, got {}{}", fmt::join(names, ", "), text, remark);
        },
        "");
}

const std::vector<std::string_view> scene_extensions{".gltf", ".glb"};

// Validates an output file name. With two formats, a pipe gets the first one.
CLI::Validator file_of(const std::vector<std::string_view>& extensions) {
    return CLI::Validator(
        [extensions](std::string& text) {
            if (text.empty()) return std::string("must be the name of a file");
            if (has_format(text, extensions)) return std::string();
            return fmt::format("must end in {}, got {}", fmt::join(extensions, ", "), text);
        },
        "");
}

Integrator integrator_of(const std::string& name) {
    if (name == "rk4") return Integrator::rk4;
    return name == "explicit" ? Integrator::explicit_euler : Integrator::semi_implicit_euler;
}

void add_reading(CLI::App& command, ReadOptions& options) {
    command.add_flag("--fixed-base", options.fixed_base, "Fix the base of a robot (URDF, MJCF or SDF)");
    command.add_flag("--floor", options.floor, "Put a floor below the lowest point of the scene");
    command.add_flag("--decompose", options.decompose,
                     "Decompose moving meshes into convex parts, instead of taking their convex hulls");
}

// Validates a comma-separated list of names.
CLI::Validator list_of(const std::vector<std::string_view>& names) {
    return CLI::Validator(
        [names](std::string& text) {
            std::istringstream list(text);
            bool is_empty = true;
            for (std::string name; std::getline(list, name, ',');) {
                is_empty = false;
                if (std::find(names.begin(), names.end(), name) == names.end())
                    return fmt::format("must be some of {}, separated by commas, got {}", fmt::join(names, ", "), name);
            }
            return is_empty ? fmt::format("must be some of {}", fmt::join(names, ", ")) : std::string();
        },
        "");
}

void add_table(CLI::App& run, RunOptions& options) {
    auto* csv = run.add_option("--csv", options.csv,
                               "Write a table: positions and velocities of every body after every step (.csv, .npy)");
    csv->check(file_of(table_extensions()));
    run.add_option_function<std::string>(
           "--columns",
           [&options](const std::string& text) {
               options.columns.clear();
               std::istringstream list(text);
               for (std::string name; std::getline(list, name, ',');) options.columns.push_back(quantity_of(name));
           },
           fmt::format("Columns of the table (default position,rotation,velocity,angular_velocity): some of {}",
                       fmt::join(quantity_names(), ", ")))
        ->check(list_of(quantity_names()))
        ->needs(csv);
    run.add_option("--every", options.every, "Write every N-th step only (table, animation)")->check(between(1, 1e9));
    run.add_option("--from", options.from, "Time at which writing begins, s (table, animation, video)")
        ->check(between(0, 1e9));
    run.add_option("--until", options.until, "Time at which writing ends, s (table, animation, video)")
        ->check(between(0, 1e9));
}

void add_outputs(CLI::App& run, RunOptions& options) {
    add_table(run, options);
    run.add_option("--png", options.png, "Write a picture of the final state (.png, .jpg)")
        ->check(file_of(viewer::picture_extensions()));
    run.add_option("--video", options.video,
                   "Write a video, 60 frames a second (.mp4, .mkv, .mov, .webm, .gif; needs ffmpeg)")
        ->check(file_of(viewer::video_extensions()));
    run.add_option("--save", options.save, "Write the scene in its final state (.gltf, .glb)")
        ->check(file_of(scene_extensions));
    run.add_option("--animate", options.animate,
                   "Write the run as an animated glTF file, for viewers without physics (.glb, .gltf)")
        ->check(file_of({".glb", ".gltf"}));
    run.add_option("--width", options.width, "Of pictures and videos, pixels")->check(between(16, 8192));
    run.add_option("--height", options.height, "Of pictures and videos, pixels")->check(between(16, 8192));
    run.add_flag("--json", options.json, "Print the summary as one JSON object");
}

// Validates the name of a folder that exists or can be created.
CLI::Validator folder() {
    return CLI::Validator(
        [](std::string& text) { return text.empty() ? std::string("must be the name of a folder") : std::string(); },
        "");
}

void add_checkpoints(CLI::App& run, RunOptions& options) {
    auto* checkpoint = run.add_option("--checkpoint", options.checkpoint,
                                      "Write the complete state into this folder at intervals, and at the end; under "
                                      "mpirun each process writes a part");
    checkpoint->check(folder());
    auto* every =
        run.add_option("--checkpoint-every", options.checkpoint_every, "Interval between checkpoints, in steps");
    every->check(between(1, 1e9))->needs(checkpoint);
    run.add_option("--checkpoint-seconds", options.checkpoint_seconds,
                   "Interval in seconds of wall-clock time instead (default: 600)")
        ->check(between(0.01, 1e7))
        ->needs(checkpoint)
        ->excludes(every);
    run.add_option("--keep", options.keep, "Number of checkpoints to keep (default: 2)")
        ->check(between(1, 1e6))
        ->needs(checkpoint);
    run.add_option("--resume", options.resume,
                   "Continue from the last complete checkpoint in this folder, with any number of processes and "
                   "threads; give the other options as before")
        ->check(folder());
}

void add_run(CLI::App& app, RunOptions& options) {
    CLI::App* run = app.add_subcommand("run", "Simulate a scene without a window; write numbers, pictures, videos.");
    run->add_option("scene", options.scene, "A file, or the name of a scene (see `cairn scenes`)")->required();
    auto* seconds = run->add_option("--seconds", options.seconds, "Simulated time, s (default 10)");
    seconds->check(between(1e-4, 1e6));
    run->add_option("--frames", options.frames, "Number of steps instead")->check(between(1, 1e9))->excludes(seconds);
    run->add_option("--dt", options.time_step, "Time step, s (default: the scene's)")->check(between(1e-4, 1.0));
    run->add_option("--substeps", options.substeps,
                    "Substeps of a step; 0: chosen by the length of the step (default: the scene's)")
        ->check(between(0, 256));
    run->add_option("--threads", options.threads, "Number of threads (default: all; results do not depend on it)")
        ->check(between(1, 256));
    run->add_option_function<std::string>(
           "--integrator", [&options](const std::string& name) { options.integrator = integrator_of(name); },
           "Integrator of free motion: semi-implicit, explicit or rk4 (default: the scene's)")
        ->check(one_of({"semi-implicit", "explicit", "rk4"}));
    add_reading(*run, options.read);
    auto* targets = run->add_option("--targets", options.targets,
                                    "Move joints to targets from a table (.csv: time, and joints by their names)");
    run->add_option("--servo-frequency", options.servo_frequency,
                    "Stiffness of joints with targets, Hz (default: 10 for those whose motors have no stiffness)")
        ->check(between(0.01, 1000))
        ->needs(targets);
    add_checkpoints(*run, options);
    add_outputs(*run, options);
}

const std::vector<std::string_view> recording_extensions{".mcap"};

void add_record(CLI::App& app, RecordOptions& options) {
    CLI::App* record = app.add_subcommand("record", "Simulate a scene and record all commands to its world.");
    record->add_option("scene", options.scene, "A file, or the name of a scene (see `cairn scenes`)")->required();
    record->add_option("-o,--output", options.output, "The recording to write (.mcap)")
        ->required()
        ->check(file_of(recording_extensions));
    auto* seconds = record->add_option("--seconds", options.seconds, "Simulated time, s (default 10)");
    seconds->check(between(1e-4, 1e6));
    record->add_option("--frames", options.frames, "Number of steps instead")
        ->check(between(1, 1e9))
        ->excludes(seconds);
    record->add_option("--dt", options.time_step, "Time step, s (default: the scene's)")->check(between(1e-4, 1.0));
    record->add_option("--threads", options.threads, "Number of threads (default: all; results do not depend on it)")
        ->check(between(1, 256));
    record
        ->add_option("--keyframes", options.keyframes,
                     "Megabytes for keyframes, for fast access to any time (default 128; 0: none)")
        ->check(between(0, 1e6));
    record->add_flag(
        "--uncompressed", [&options](std::int64_t) { options.compress = false; },
        "Do not compress the file, for readers without zstd");
    record
        ->add_option("--with", options.readings,
                     "For Foxglove, Rerun and others: poses, contacts, joints, statistics, events, or all")
        ->delimiter(',')
        ->check(CLI::IsMember({"poses", "contacts", "joints", "statistics", "events", "all"}));
    record->add_option("--with-rate", options.readings_rate, "Rate of these messages, Hz (default: after each step)")
        ->check(between(1e-3, 1e6));
    add_reading(*record, options.read);
}

void add_replay(CLI::App& app, ReplayOptions& options) {
    CLI::App* replay = app.add_subcommand("replay", "Replay a recording, and compare every step.");
    replay->add_option("recording", options.recording, "A recording (.mcap)")->required();
    replay->add_flag("--verify", options.verify, "Stop at the first step that differs");
    replay->add_option("--threads", options.threads, "Number of threads (default: all; results do not depend on it)")
        ->check(between(1, 256));
    auto* at = replay->add_option("--at", options.at, "Go to this time, s, and stop there");
    at->check(between(0, 1e9));
    replay
        ->add_option("--what-if", options.what_if,
                     "Change a value there and continue to the end: gravity=X,Y,Z, substeps=N, friction=F, "
                     "restitution=R; may be given several times")
        ->allow_extra_args(false);
    replay->add_option("--save", options.save, "Write the scene in its final state (.gltf, .glb)")
        ->check(file_of(scene_extensions));
    replay->add_flag("--json", options.json, "Print the summary as one JSON object");
}

void add_info_and_diff(CLI::App& app, InfoOptions& info_options, DiffOptions& diff_options) {
    CLI::App* info = app.add_subcommand("info", "Print the contents of a recording.");
    info->add_option("recording", info_options.recording, "A recording (.mcap)")->required();
    info->add_flag("--json", info_options.json, "Print one JSON object");
    CLI::App* diff =
        app.add_subcommand("diff", "Print where two recordings differ: at which step, and in which bodies.");
    diff->add_option("first", diff_options.first, "A recording (.mcap)")->required();
    diff->add_option("second", diff_options.second, "Another one (.mcap)")->required();
    diff->add_option("--threads", diff_options.threads, "Number of threads (default: all; results do not depend on it)")
        ->check(between(1, 256));
}

void add_scenes(CLI::App& app, ScenesOptions& options) {
    CLI::App* scenes = app.add_subcommand("scenes", "List the scenes.");
    scenes->add_option("folder", options.folder, "Folder to list (default: the scenes that come with Cairn)");
    auto* json = scenes->add_flag("--json", options.json, "Print one JSON array");
    scenes->add_flag("--names", options.names, "Print names only, one per line, without reading the files")
        ->excludes(json);
}

void add_convert(CLI::App& app, ConvertOptions& options) {
    CLI::App* convert = app.add_subcommand("convert", "Write a scene in another format, or make a scene of a mesh.");
    convert
        ->add_option("in", options.input,
                     "A scene (.gltf, .glb or its name), a model (.urdf, .xml, .sdf, .usda), or a mesh (.obj, .stl)")
        ->required();
    convert->add_option("out", options.output, "The scene to write (.gltf, .glb)")
        ->required()
        ->check(file_of(scene_extensions));
    convert
        ->add_option_function<std::string>(
            "--as", [&options](const std::string& name) { options.as_hull = name == "hull"; },
            "What a mesh becomes: a dynamic body with its convex hull, or a static one with its triangles (hull or "
            "mesh; "
            "default hull)")
        ->check(one_of({"hull", "mesh"}, "; --decompose makes a hull several convex parts"));
    add_reading(*convert, options.read);
    convert->add_option("--scale", options.scale, "Length of one unit of a mesh, m (default 1)")
        ->check(between(1e-9, 1e9));
    convert->add_option("--density", options.density, "Density of a mesh's hull, kg/m^3 (default 1000)")
        ->check(between(1e-6, 1e9));
}

void add_view(CLI::App& app, ViewOptions& options) {
    CLI::App* view = app.add_subcommand("view", "Open a scene in a window. F1 shows the keys.");
    view->add_option("scene", options.scene, "A file, or the name of a scene (default: welcome)");
    add_reading(*view, options.read);
    view->add_option("--width", options.width, "Of the window")->check(between(200, 16384));
    view->add_option("--height", options.height, "Of the window")->check(between(150, 16384));
    view->add_option("--exit-after", options.exit_after, "Close automatically after this time, s")
        ->check(between(0, 1e6));
    view->add_option("--report", options.report, "Write the state at the end (.json)")->check(file_of({".json"}));
    view->add_option("--script", options.script, "Play inputs from a file");
}

CLI::Validator case_name() {
    return CLI::Validator(
        [](std::string& text) {
            if (validation::find_case(text) != nullptr) return std::string();
            std::vector<std::string> names;
            for (const validation::Case& entry : validation::cases())
                names.push_back(fmt::format("{} {}", entry.number, entry.name));
            return fmt::format("must be the name or number of a case ({}), got {}", fmt::join(names, ", "), text);
        },
        "");
}

void add_validate(CLI::App& app, ValidateOptions& options) {
    CLI::App* validate = app.add_subcommand("validate", "Measure the physics against closed forms.");
    validate->add_option("--case", options.cases, "Only this case, by name or number; may be given several times")
        ->allow_extra_args(false)
        ->check(case_name());
    validate->add_option("--report", options.report, "Write a page with plots into this folder");
    validate->add_flag("--json", options.json, "Print one JSON object");
}

// Parses "3/8": the third of eight parts.
void read_shard(const std::string& text, SweepOptions& options) {
    std::istringstream stream(text);
    char slash = ' ', rest = ' ';
    const bool is_whole = static_cast<bool>(stream >> options.shard >> slash >> options.shards) && !(stream >> rest);
    if (!is_whole || slash != '/' || options.shard < 1 || options.shard > options.shards) {
        throw CLI::ValidationError("--shard", "must be I/N with I from 1 to N, got " + text);
    }
}

void add_sweep(CLI::App& app, SweepOptions& options) {
    CLI::App* sweep = app.add_subcommand("sweep", "Run a scene many times with other parameters; see docs/sweep.md.");
    sweep->add_option("plan", options.plan, "What to vary and what to measure (.json)")->required();
    sweep->add_option("--out", options.out, "The folder for results (default: named after the plan)");
    sweep
        ->add_option("--threads", options.threads,
                     "Number of threads (default: all, or 1 in each process of mpirun; results do not depend on it)")
        ->check(between(1, 256));
    sweep->add_flag("--resume", options.resume, "Continue with the rows that are in the folder");
    sweep
        ->add_option_function<std::string>(
            "--shard", [&options](const std::string& text) { read_shard(text, options); },
            "Run part I of N only, as 3/8; the part that finishes last combines the results")
        ->type_name("I/N");
    auto* check = sweep->add_flag("--check", options.check, "Check the plan only, with its first row");
    sweep->add_option("--row", options.row, "Run that row only, and print it")->excludes(check);
    sweep->add_flag("--json", options.json, "Print the summary as one JSON object");
}

void add_fit(CLI::App& app, FitOptions& options) {
    CLI::App* fit =
        app.add_subcommand("fit", "Find parameters with which a scene matches measurements; see docs/sweep.md.");
    fit->add_option("plan", options.plan, "A plan of `cairn sweep`; parameters with a range are fitted (.json)")
        ->required();
    fit->add_option("data", options.data, "Measurements: one row per experiment (.csv)")->required();
    fit->add_option("--threads", options.threads, "Number of threads (default: all; results do not depend on it)")
        ->check(between(1, 256));
    fit->add_option("--evaluations", options.evaluations,
                    "Maximum number of runs of all experiments (default: 300 for each parameter)")
        ->check(between(1, 1e9));
    fit->add_flag("--json", options.json, "Print one JSON object");
}

void add_doctor(CLI::App& app, DoctorOptions& options) {
    CLI::App* doctor = app.add_subcommand("doctor", "Print what this machine has for Cairn, and what it lacks.");
    doctor->add_flag("--json", options.json, "Print one JSON object");
}

void add_completion(CLI::App& app, CompletionOptions& options) {
    CLI::App* completion = app.add_subcommand("completion", "Print the completion script for a shell.");
    completion->add_option("shell", options.shell, "bash, zsh or fish")
        ->required()
        ->check(one_of({"bash", "zsh", "fish"}));
}

} // namespace

CommandLine::CommandLine() : app("Cairn, a rigid-body physics engine.", "cairn") {
    app.set_version_flag("--version", std::string("cairn ") + version_string);
    app.require_subcommand(1);
    add_run(app, run);
    add_record(app, record);
    add_replay(app, replay);
    add_info_and_diff(app, info, diff);
    add_view(app, view);
    add_scenes(app, scenes);
    add_convert(app, convert);
    add_sweep(app, sweep);
    add_fit(app, fit);
    add_validate(app, validate);
    add_doctor(app, doctor);
    add_completion(app, completion);
    app.add_subcommand("manual", "Print the manual page, for man(1): cairn manual | man -l -");
}

int CommandLine::execute() const {
    if (app.got_subcommand("run")) return run_command(run);
    if (app.got_subcommand("record")) return record_command(record);
    if (app.got_subcommand("replay")) return replay_command(replay);
    if (app.got_subcommand("info")) return info_command(info);
    if (app.got_subcommand("diff")) return diff_command(diff);
    if (app.got_subcommand("scenes")) return scenes_command(scenes);
    if (app.got_subcommand("convert")) return convert_command(convert);
    if (app.got_subcommand("sweep")) return sweep_command(sweep);
    if (app.got_subcommand("fit")) return fit_command(fit);
    if (app.got_subcommand("validate")) return validate_command(validate);
    if (app.got_subcommand("doctor")) return doctor_command(doctor);
    if (app.got_subcommand("completion")) return completion_command(completion, app);
    if (app.got_subcommand("manual")) return manual_command(app);
    return view_command(view);
}

} // namespace cairn::cli
