// The `cairn` command: reads the command line and hands over. A wrong call ends with one line on stderr and exit
// code 2, an error at run time with one line and exit code 1.
#include "cli/commands.h"
#include "cli/outputs.h"
#include "files/output_file.h"
#include "validation/validation.h"
#include "viewer/headless.h"

#include <cairn/version.h>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <csignal>
#include <exception>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace {

using cairn::cli::ConvertOptions;
using cairn::cli::RunOptions;
using cairn::cli::ScenesOptions;
using cairn::cli::ValidateOptions;
using cairn::cli::ViewOptions;

// CLI11's own range check lets NaN through.
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

// The name of an output file. Where there are two formats, that of a pipe is the first.
CLI::Validator file_of(const std::vector<std::string_view>& extensions) {
    return CLI::Validator(
        [extensions](std::string& text) {
            if (text.empty()) return std::string("must be the name of a file");
            if (cairn::cli::has_format(text, extensions)) return std::string();
            return fmt::format("must end in {}, got {}", fmt::join(extensions, ", "), text);
        },
        "");
}

cairn::Integrator integrator_of(const std::string& name) {
    if (name == "rk4") return cairn::Integrator::rk4;
    return name == "explicit" ? cairn::Integrator::explicit_euler : cairn::Integrator::semi_implicit_euler;
}

void add_reading(CLI::App& command, cairn::cli::ReadOptions& options) {
    command.add_flag("--fixed-base", options.fixed_base, "Of a robot in URDF: its root link does not move");
    command.add_flag("--floor", options.floor, "Put a floor below the lowest point of the scene");
}

// A list of names, separated by commas.
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
    csv->check(file_of(cairn::cli::table_extensions()));
    run.add_option_function<std::string>(
           "--columns",
           [&options](const std::string& text) {
               options.columns.clear();
               std::istringstream list(text);
               for (std::string name; std::getline(list, name, ',');)
                   options.columns.push_back(cairn::cli::quantity_of(name));
           },
           fmt::format("Of the table (default position,rotation,velocity,angular_velocity): some of {}",
                       fmt::join(cairn::cli::quantity_names(), ", ")))
        ->check(list_of(cairn::cli::quantity_names()))
        ->needs(csv);
    run.add_option("--every", options.every, "Write every so many steps only (table, animation)")
        ->check(between(1, 1e9));
    run.add_option("--from", options.from, "Begin writing there, s (table, animation, video)")->check(between(0, 1e9));
    run.add_option("--until", options.until, "End writing there, s (table, animation, video)")->check(between(0, 1e9));
}

void add_outputs(CLI::App& run, RunOptions& options) {
    add_table(run, options);
    run.add_option("--png", options.png, "Write a picture of the end (.png, .jpg)")
        ->check(file_of(cairn::viewer::picture_extensions()));
    run.add_option("--video", options.video,
                   "Write a video, 60 frames a second (.mp4, .mkv, .mov, .webm, .gif; needs ffmpeg)")
        ->check(file_of(cairn::viewer::video_extensions()));
    run.add_option("--save", options.save, "Write the scene as it stands at the end (.gltf, .glb)")
        ->check(file_of(scene_extensions));
    run.add_option("--animate", options.animate,
                   "Write the run as an animated glTF file, for viewers without physics (.glb, .gltf)")
        ->check(file_of({".glb", ".gltf"}));
    run.add_option("--width", options.width, "Of pictures and videos, pixels")->check(between(16, 8192));
    run.add_option("--height", options.height, "Of pictures and videos, pixels")->check(between(16, 8192));
    run.add_flag("--json", options.json, "Print the summary as one JSON object");
}

void add_run(CLI::App& app, RunOptions& options) {
    CLI::App* run = app.add_subcommand("run", "Simulate a scene without a window; write numbers, pictures, videos.");
    run->add_option("scene", options.scene, "A file, or the name of a scene (see `cairn scenes`)")->required();
    auto* seconds = run->add_option("--seconds", options.seconds, "Simulated time, s (default 10)");
    seconds->check(between(1e-4, 1e6));
    run->add_option("--frames", options.frames, "Number of steps instead")->check(between(1, 1e9))->excludes(seconds);
    run->add_option("--dt", options.time_step, "Time step, s (default: the scene's)")->check(between(1e-4, 1.0));
    run->add_option("--substeps", options.substeps, "Substeps of a step (default: the scene's)")
        ->check(between(1, 256));
    run->add_option("--threads", options.threads, "Number of threads (default: all; results do not depend on it)")
        ->check(between(1, 256));
    run->add_option_function<std::string>(
           "--integrator", [&options](const std::string& name) { options.integrator = integrator_of(name); },
           "Of free motion: semi-implicit, explicit or rk4 (default: the scene's)")
        ->check(one_of({"semi-implicit", "explicit", "rk4"}));
    add_reading(*run, options.read);
    auto* targets = run->add_option("--targets", options.targets,
                                    "Move joints as a table says (.csv: time, and joints by their names)");
    run->add_option("--servo-frequency", options.servo_frequency,
                    "Of joints with targets whose motors have no stiffness, Hz (default 10)")
        ->check(between(0.01, 1000))
        ->needs(targets);
    add_outputs(*run, options);
}

void add_scenes(CLI::App& app, ScenesOptions& options) {
    CLI::App* scenes = app.add_subcommand("scenes", "List the scenes.");
    scenes->add_option("folder", options.folder, "Where to look (default: the scenes that come with Cairn)");
    scenes->add_flag("--json", options.json, "Print one JSON array");
}

void add_convert(CLI::App& app, ConvertOptions& options) {
    CLI::App* convert = app.add_subcommand("convert", "Write a scene in another form, or make one of a mesh.");
    convert
        ->add_option("in", options.input, "A scene (.gltf, .glb or its name), a robot (.urdf), or a mesh (.obj, .stl)")
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
        ->check(one_of({"hull", "mesh"}, "; there is no decomposition into convex parts"));
    add_reading(*convert, options.read);
    convert->add_option("--scale", options.scale, "Meters of one unit of a mesh (default 1)")
        ->check(between(1e-9, 1e9));
    convert->add_option("--density", options.density, "Of a mesh's hull, kg/m^3 (default 1000)")
        ->check(between(1e-6, 1e9));
}

void add_view(CLI::App& app, ViewOptions& options) {
    CLI::App* view = app.add_subcommand("view", "Open a scene in a window. F1 shows the keys.");
    view->add_option("scene", options.scene, "A file, or the name of a scene (default: welcome)");
    add_reading(*view, options.read);
    view->add_option("--width", options.width, "Of the window")->check(between(200, 16384));
    view->add_option("--height", options.height, "Of the window")->check(between(150, 16384));
    view->add_option("--exit-after", options.exit_after, "Close by itself after so many seconds")
        ->check(between(0, 1e6));
    view->add_option("--report", options.report, "Write the state at the end (.json)")->check(file_of({".json"}));
    view->add_option("--script", options.script, "Play inputs from a file");
}

CLI::Validator case_name() {
    return CLI::Validator(
        [](std::string& text) {
            if (cairn::validation::find_case(text) != nullptr) return std::string();
            std::vector<std::string> names;
            for (const cairn::validation::Case& entry : cairn::validation::cases())
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

constexpr int failed = 1, called_wrongly = 2;

int fail(const std::string& text, int code) {
    cairn::cli::complain(text);
    return code;
}

// As every program ends that writes to a pipe whose reader has gone: quietly, by that signal. Its files are closed.
int end_without_reader() {
    std::signal(SIGPIPE, SIG_DFL);
    std::raise(SIGPIPE);
    return 128 + SIGPIPE; // if it is blocked
}

// Also --version.
int print_help(const CLI::App& app, const CLI::ParseError& error) {
    std::ostringstream text;
    app.exit(error, text, text);
    try {
        cairn::cli::print(text.str());
        return 0;
    } catch (const cairn::files::ReaderGone&) {
        return end_without_reader();
    } catch (const std::exception& problem) {
        return fail(problem.what(), failed);
    }
}

} // namespace

int main(int argc, char** argv) {
    std::signal(SIGPIPE, SIG_IGN); // writing says it, too
    CLI::App app("Cairn, a rigid-body physics engine.", "cairn");
    app.set_version_flag("--version", std::string("cairn ") + cairn::version_string);
    app.require_subcommand(1);
    RunOptions run;
    ScenesOptions scenes;
    ConvertOptions convert;
    ValidateOptions validate;
    ViewOptions view;
    add_run(app, run);
    add_scenes(app, scenes);
    add_convert(app, convert);
    add_validate(app, validate);
    add_view(app, view);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) return print_help(app, error);
        if (argc > 1 && argv[1][0] != '-' && app.get_subcommands().empty()) {
            return fail(fmt::format("there is no command \"{}\" (see cairn --help)", argv[1]), called_wrongly);
        }
        return fail(std::string(error.what()) + " (see cairn --help)", called_wrongly);
    }
    try {
        if (app.got_subcommand("run")) return cairn::cli::run_command(run);
        if (app.got_subcommand("scenes")) return cairn::cli::scenes_command(scenes);
        if (app.got_subcommand("convert")) return cairn::cli::convert_command(convert);
        if (app.got_subcommand("validate")) return cairn::cli::validate_command(validate);
        return cairn::cli::view_command(view);
    } catch (const cairn::files::ReaderGone&) {
        return end_without_reader();
    } catch (const std::exception& error) {
        return fail(error.what(), failed);
    }
}
