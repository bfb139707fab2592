#include "recording/recording.h"

#include "recording/contents.h"

#include <algorithm>

namespace cairn::recording {

Recording::Recording(const std::filesystem::path& path) : contents_(std::make_unique<Contents>(InputBytes(path))) {}
Recording::Recording(std::unique_ptr<Contents> contents) : contents_(std::move(contents)) {}
Recording::~Recording() = default;
Recording::Recording(Recording&&) noexcept = default;

Recording Recording::from_memory(std::string bytes, const std::string& name) {
    return Recording(std::make_unique<Contents>(InputBytes(std::move(bytes), name)));
}

std::uint64_t Recording::steps_until(double seconds) const {
    const auto& runs = contents_->runs;
    std::uint64_t steps = 0;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const std::uint64_t end = i + 1 < runs.size() ? runs[i + 1].first : contents_->info.steps;
        const double length = double(runs[i].length), count = (seconds - runs[i].time) / length + 1e-3;
        if (!(count >= 1)) break;
        steps = runs[i].first + std::uint64_t(std::min(count, double(end - runs[i].first)));
        if (steps < end) break;
    }
    return steps;
}

const RecordingInfo& Recording::info() const { return contents_->info; }
const std::map<std::string, std::string>& Recording::note(const std::string& name) const {
    return contents_->file.metadata(name);
}

} // namespace cairn::recording
