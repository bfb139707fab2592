#include "cli/recorders.h"

#include "cli/activity.h"
#include "cli/outputs.h"

#include "files/output_file.h"

#include <cairn/error.h>

#include <fmt/format.h>

namespace cairn::cli {

namespace {

// The range of written moments; a resumed table must have the same.
std::string moments_of(const RunOptions& options) {
    return fmt::format("--every {} --from {} --until {}", options.every, options.from,
                       options.until ? fmt::format("{}", *options.until) : "the end");
}

std::string whole_path(const std::filesystem::path& path) {
    std::error_code ignored; // on failure the name is used as it is
    return std::filesystem::weakly_canonical(std::filesystem::absolute(path, ignored), ignored).generic_string();
}

} // namespace

bool is_in_window(const RunOptions& options, double time, double time_step) {
    const double tolerance = 1e-3 * time_step;
    return time >= options.from - tolerance && !(options.until && time > *options.until + tolerance);
}

Recorders::Recorders(const RunOptions& options, const scene::Scene& scene, const checkpoint::Moment* resumed)
    : options_(options), resumed_(resumed) {
    if (!options.csv.empty()) open_table(scene);
    if (!options.png.empty() || !options.video.empty()) {
        pictures_ = std::make_unique<PictureRecorder>(scene, options.png, options.video, options.width, options.height);
    }
    if (!options.animate.empty()) animation_.emplace(scene);
    if (resumed_) warn_late_outputs();
}

void Recorders::open_table(const scene::Scene& scene) {
    const bool is_file = files::destination_of(options_.csv).kind == files::Destination::Kind::file;
    const std::optional<checkpoint::TableProgress> before = resumed_ ? resumed_->table : std::nullopt;
    TableStart start;
    if (is_file && before && before->file == whole_path(options_.csv)) {
        if (before->moments != moments_of(options_)) {
            throw Error(ErrorCode::wrong_state, options_.csv.generic_string(), moments_of(options_),
                        "was begun with other times, and is to be continued: must be " + before->moments);
        }
        start.from = before->extent;
    }
    is_table_resumed_ = start.from.has_value();
    is_table_resumable_ = is_file && (is_table_resumed_ || !options_.checkpoint.empty());
    start.is_resumable = is_table_resumable_;
    csv_ = std::make_unique<TrajectoryWriter>(options_.csv, scene.world, options_.columns, start);
}

void Recorders::warn_late_outputs() const {
    const auto tell = [this](const std::filesystem::path& path) {
        if (path.empty()) return;
        complain(fmt::format("warning: {} begins after step {}, from which the run continues", path.generic_string(),
                             resumed_->step));
    };
    if (!is_table_resumed_) tell(options_.csv);
    tell(options_.video);
    tell(options_.animate);
}

void Recorders::add(const World& world, std::uint64_t step, float time_step) {
    if (!is_in_window(options_, world.time(), static_cast<double>(time_step))) return;
    if (pictures_) pictures_->add(world);
    if (step % static_cast<std::uint64_t>(options_.every) != 0) return;
    const bool is_there = is_table_resumed_ && step == resumed_->step; // written before the checkpoint
    if (csv_ && !is_there) csv_->add(world);
    if (animation_) animation_->add(world);
}

std::optional<checkpoint::TableProgress> Recorders::table_progress() {
    if (!csv_ || !is_table_resumable_) return std::nullopt;
    return checkpoint::TableProgress{whole_path(options_.csv), moments_of(options_), csv_->extent()};
}

void Recorders::finish(const scene::Scene& scene) {
    const auto writing = [](const std::filesystem::path& path) { set_activity("writing", path.generic_string()); };
    writing(options_.csv);
    if (csv_) csv_->close();
    writing(options_.png.empty() ? options_.video : options_.png);
    if (pictures_) pictures_->finish(scene.world);
    writing(options_.animate);
    if (animation_) animation_->write(options_.animate);
    writing(options_.save);
    if (!options_.save.empty()) scene::save(scene, options_.save);
    set_activity("summing up what happened");
}

} // namespace cairn::cli
