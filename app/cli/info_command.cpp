#include "cli/activity.h"
#include "cli/commands.h"
#include "cli/outputs.h"

#include "recording/recording.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

namespace cairn::cli {

namespace {

std::string info_text(const std::string& name, const recording::RecordingInfo& info) {
    std::string text = fmt::format("{}: {} steps, {:.6g} s{}\n", name, info.steps, info.seconds,
                                   info.source.empty() ? "" : " of " + info.source);
    text +=
        fmt::format("{} bytes, of which {} for {} keyframes\n", info.bytes, info.keyframe_bytes, info.keyframes.size());
    if (info.is_cut_off)
        text += fmt::format("cut off: {} bytes after its last complete record\n", info.bytes - info.whole_bytes);
    text += info.is_from_start ? "starts with an empty world: any build with the same arithmetic can replay it\n"
                               : "starts with a snapshot: other builds may be unable to replay it\n";
    for (const auto& [call, count] : info.commands) text += fmt::format("{:>10}  {}\n", count, call);
    return text;
}

} // namespace

int info_command(const InfoOptions& options) {
    const std::string name = options.recording.generic_string();
    set_activity("reading", name);
    const recording::Recording recording(options.recording);
    const recording::RecordingInfo& info = recording.info();
    if (!options.json) {
        print(info_text(name, info));
        return 0;
    }
    nlohmann::ordered_json json{{"recording", name},
                                {"source", info.source},
                                {"steps", info.steps},
                                {"seconds", info.seconds},
                                {"bytes", info.bytes},
                                {"cut_off", info.is_cut_off},
                                {"whole_bytes", info.whole_bytes},
                                {"from_start", info.is_from_start},
                                {"keyframes", info.keyframes},
                                {"keyframe_bytes", info.keyframe_bytes},
                                {"commands", info.commands}};
    print(json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n");
    return 0;
}

} // namespace cairn::cli
