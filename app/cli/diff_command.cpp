#include "cli/activity.h"
#include "cli/commands.h"
#include "cli/outputs.h"
#include "cli/progress.h"

#include "recording/recording.h"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

namespace cairn::cli {

namespace {

constexpr std::size_t most_named = 8;

// The bodies that differ between two worlds, or that only one of them has; empty if there are none.
std::string differing_bodies(const World& a, const World& b) {
    const auto row = [](const World& world, BodyId id) {
        const Body body = world.body(id);
        const Transform t = body.transform();
        return std::tuple(t.position, t.rotation, body.linear_velocity(), body.angular_velocity());
    };
    const std::vector<BodyId> in_a = a.bodies(), in_b = b.bodies();
    std::vector<std::string> names;
    std::size_t count = 0, i = 0, k = 0;
    const auto name = [&](const World& world, BodyId id, const char* remark) {
        if (++count > most_named) return;
        const std::string& text = world.body(id).name();
        names.push_back(fmt::format("body {}{}{}", id.index(), text.empty() ? "" : " \"" + text + "\"", remark));
    };
    while (i < in_a.size() || k < in_b.size()) {
        const std::uint32_t at_a = i < in_a.size() ? in_a[i].index() : ~0u,
                            at_b = k < in_b.size() ? in_b[k].index() : ~0u;
        if (at_a < at_b)
            name(a, in_a[i++], " only in the first recording");
        else if (at_b < at_a)
            name(b, in_b[k++], " only in the second recording");
        else if (const BodyId x = in_a[i++], y = in_b[k++]; row(a, x) != row(b, y))
            name(a, x, "");
    }
    std::string text;
    for (const std::string& one : names) text += (text.empty() ? "" : ", ") + one;
    if (count > most_named) text += fmt::format(" and {} more", count - most_named);
    return text;
}

} // namespace

int diff_command(const DiffOptions& options) {
    const std::string first = options.first.generic_string(), second = options.second.generic_string();
    set_activity("comparing", first);
    const recording::Recording recording_a(options.first), recording_b(options.second);
    const int threads = options.threads.value_or(hardware_threads());
    recording::Replay a(recording_a, threads), b(recording_b, threads);
    const std::uint64_t steps = std::min(recording_a.info().steps, recording_b.info().steps);
    {
        ProgressLine progress(steps, "steps");
        while (a.steps() < steps) {
            set_activity_count(a.steps(), steps);
            a.step(), b.step();
            progress.show(a.steps());
            const World &in_a = std::as_const(a).world(), &in_b = std::as_const(b).world();
            if (in_a.state_digest() == in_b.state_digest()) continue;
            print(fmt::format("they differ from step {} on: {}\n", a.steps(), differing_bodies(in_a, in_b)));
            return 1;
        }
    }
    if (recording_a.info().steps != recording_b.info().steps) {
        print(fmt::format("the same for {} steps; {} has {}, {} has {}\n", steps, first, recording_a.info().steps,
                          second, recording_b.info().steps));
        return 1;
    }
    print(fmt::format("the same: {} steps\n", steps));
    return 0;
}

} // namespace cairn::cli
