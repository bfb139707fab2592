#include "cli/activity.h"
#include "cli/commands.h"
#include "cli/interrupt.h"
#include "cli/outputs.h"
#include "cli/progress.h"
#include "cli/viewer_scene.h"

#include "recording/recorder.h"
#include "scene/scene.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace cairn::cli {

namespace {

std::uint64_t steps_to_record(const RecordOptions& options, double time_step) {
    if (options.frames) return static_cast<std::uint64_t>(*options.frames);
    const double steps = std::round(options.seconds.value_or(10.0) / time_step);
    if (steps > 1e9) throw Error(ErrorCode::invalid_value, "--seconds", {}, "is more than a billion steps");
    return std::max<std::uint64_t>(1, static_cast<std::uint64_t>(steps));
}

recording::Readings readings_of(const std::vector<std::string>& names) {
    const auto has = [&](const char* name) {
        return std::any_of(names.begin(), names.end(),
                           [&](const std::string& given) { return given == name || given == "all"; });
    };
    return {has("poses"), has("contacts"), has("joints"), has("statistics"), has("events")};
}

} // namespace

int record_command(const RecordOptions& options) {
    check_outputs(std::vector<Output>{{"--output", options.output}});
    const std::filesystem::path path = scene::find_scene(options.scene);
    // Loads the scene before the recording is opened, so that an unreadable scene does not destroy an existing
    // recording.
    print_warnings(options.read.load(path).warnings);
    recording::RecorderOptions how;
    how.compress = options.compress;
    how.keyframe_budget = static_cast<std::size_t>(options.keyframes * 1e6);
    how.readings = readings_of(options.readings);
    if (options.readings_rate) how.readings_interval = 1.0 / *options.readings_rate;
    how.source = path.filename().generic_string();
    const InterruptGuard interrupt; // until all files are written
    recording::Recorder recorder(options.output, how);
    scene::Scene scene = options.read.load(path, recorder.listener());
    if (options.time_step) scene.info.time_step = static_cast<float>(*options.time_step);
    const std::vector<viewer::Visual> visuals = visuals_of(scene);
    recorder.note(looks_note,
                  note_of({how.source, camera_of(scene, visuals), lights_of(scene), appearances_of(scene), visuals},
                          scene.world));
    scene.world.set_threads(options.threads.value_or(hardware_threads()));
    const std::uint64_t steps = steps_to_record(options, static_cast<double>(scene.info.time_step));
    set_activity("recording", options.scene);
    {
        ProgressLine progress(steps, "steps", static_cast<double>(scene.info.time_step));
        for (std::uint64_t i = 0; i < steps && !interrupt.requested(); ++i) {
            set_activity_count(i, steps);
            scene.world.step(scene.info.time_step);
            progress.show(i + 1);
        }
    }
    set_activity("writing", options.output.generic_string());
    recorder.close();
    print(fmt::format("{}: {} steps of {:.6g} s of {}{}, state {:016x}\n", options.output.generic_string(),
                      recorder.steps(), scene.info.time_step, path.generic_string(),
                      interrupt.requested() ? ", interrupted" : "", scene.world.state_hash()));
    return 0;
}

} // namespace cairn::cli
