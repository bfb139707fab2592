#include "cli/checkpoints.h"

#include "cli/activity.h"
#include "cli/outputs.h"

#include "files/checksum.h"
#include "scene/gltf_file.h"

#include <cairn/version.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <set>
#include <utility>

namespace cairn::cli {

namespace {

constexpr double default_seconds_between = 600.0;

// The sections of a checkpoint, in order.
enum Section : std::size_t { state, definitions, targets_of_joints, sections };

template <class T> std::string_view as_text(std::span<const T> values) {
    return {reinterpret_cast<const char*>(values.data()), values.size_bytes()};
}

// Checksum of shape data that snapshots share and only refer to.
class ShapeSum {
  public:
    explicit ShapeSum(std::uint32_t start) : sum_(start) {}
    std::uint32_t value() const { return sum_; }

    void add(const Shape& shape) {
        std::visit([this](const auto& one) { add_data(one); }, shape);
    }

  private:
    template <class T> void add_numbers(std::span<const T> values) { sum_ = files::crc32(as_text(values), sum_); }
    void add_data(const Hull& hull) {
        if (is_new(hull.data().get())) add_numbers(hull.vertices());
    }
    void add_data(const Mesh& mesh) {
        if (!is_new(mesh.data().get())) return;
        add_numbers(mesh.vertices());
        add_numbers(mesh.indices());
    }
    void add_data(const HeightField& field) {
        if (is_new(field.data().get())) add_numbers(field.heights());
    }
    template <class T> void add_data(const T&) {} // fully contained in the snapshot
    bool is_new(const void* data) { return seen_.insert(data).second; }

    std::uint32_t sum_;
    std::set<const void*> seen_;
};

std::uint32_t checksum_of(const Snapshot& snapshot) {
    ShapeSum sum(files::crc32(as_text(std::span<const std::byte>(snapshot.definitions->bytes)),
                              files::crc32(as_text(std::span<const std::byte>(snapshot.bytes)))));
    for (const Shape& shape : snapshot.definitions->shapes) sum.add(shape);
    return sum.value();
}

// Identifies the snapshot format by its first bytes.
std::string form_of(const Snapshot& snapshot) {
    constexpr std::size_t size = 16;
    std::string text;
    for (std::size_t i = 0; i < size; ++i) text += fmt::format("{:02x}", std::to_integer<unsigned>(snapshot.bytes[i]));
    return text;
}

checkpoint::Identity identity_of(const RunOptions& options, const scene::Scene& scene, const Snapshot& start) {
    std::string targets = "none";
    if (!options.targets.empty()) {
        const std::vector<std::byte> bytes = scene::read_file(options.targets);
        targets = checkpoint::hex(files::crc32(as_text(std::span<const std::byte>(bytes))));
    }
    return {{"version", version_string, "was written by another version of this program"},
            {"snapshots", form_of(start),
             "was written by another build of this program, whose snapshots have another format"},
            {"time_step", fmt::format("{}", scene.info.time_step), "is of a run with another time step"},
            {"targets", targets, "is of a run with other --targets (by checksum)"},
            {"start", checkpoint::hex(checksum_of(start)),
             "is of a run with another initial state, from another scene or other options (by checksum)"}};
}

} // namespace

Checkpoints::Checkpoints(const RunOptions& options, const Ranks& ranks, const scene::Scene& scene)
    : options_(options), communicator_(ranks.communicator()), last_time_(std::chrono::steady_clock::now()) {
    if (options.checkpoint.empty() && options.resume.empty()) return;
    const Snapshot start = scene.world.save();
    definitions_ = start.definitions;
    identity_ = identity_of(options, scene, start);
    if (!options.resume.empty()) {
        set_activity("reading a checkpoint", options.resume.generic_string());
        last_ = checkpoint::read_last(options.resume, identity_, communicator_.get(), [](const std::string& line) {
            complain("warning: " + line + "; an older checkpoint is tried");
        });
    }
    if (ranks.rank() == 0) require_new_folder();
    if (last_) last_step_ = last_->moment.step;
    if (options.checkpoint.empty()) return;
    writer_ = std::make_unique<checkpoint::Writer>(options.checkpoint, identity_, communicator_.get(), options.keep);
}

// Rejects folders that would mix two runs, or lose one.
void Checkpoints::require_new_folder() const {
    std::error_code ignored;
    const bool is_same = options_.checkpoint == options_.resume ||
                         std::filesystem::equivalent(options_.checkpoint, options_.resume, ignored);
    if (!options_.resume.empty() && !last_) {
        if (!is_same) {
            throw Error(ErrorCode::io, "--resume", options_.resume.generic_string(),
                        "must be a folder with checkpoints, and has none");
        }
        complain(fmt::format("there is no checkpoint in {} yet: the run begins at its start",
                             options_.resume.generic_string()));
    }
    if (options_.checkpoint.empty() || (is_same && !options_.resume.empty())) return;
    const std::vector<std::uint64_t> steps = checkpoint::steps_in(options_.checkpoint);
    if (steps.empty()) return;
    const std::string folder = options_.checkpoint.generic_string();
    throw Error(ErrorCode::wrong_state, "--checkpoint", folder,
                fmt::format("has checkpoints, the last of step {}: continue with --resume {}, or choose another folder",
                            steps.front(), folder));
}

void Checkpoints::restore(World& world, std::optional<JointTargets>& targets) {
    if (!last_) return;
    const std::string place = last_->place.generic_string();
    if (last_->sections.size() != sections) {
        throw Error(ErrorCode::invalid_file, place, std::to_string(last_->sections.size()),
                    fmt::format("must have {} sections", std::size_t{sections}));
    }
    Snapshot snapshot{std::exchange(last_->sections[state], {}), definitions_};
    // Changed since the start, for example by broken joints; shapes are unchanged.
    if (!last_->sections[definitions].empty()) {
        snapshot.definitions = std::make_shared<SnapshotDefinitions>(
            SnapshotDefinitions{std::exchange(last_->sections[definitions], {}), definitions_->shapes});
    }
    world.restore(snapshot);
    const std::uint64_t hash = world.state_hash(), steps = world.statistics().steps;
    if (hash != last_->moment.state_hash || steps != last_->moment.step) {
        throw Error(ErrorCode::invalid_file, place, fmt::format("state {:016x} after step {}", hash, steps),
                    fmt::format("must be state {:016x} after step {}", last_->moment.state_hash, last_->moment.step));
    }
    if (targets) targets->restore(last_->sections[targets_of_joints], place);
}

bool Checkpoints::is_due(std::uint64_t step) const {
    if (!writer_ || step == last_step_) return false;
    if (options_.checkpoint_every) return step % static_cast<std::uint64_t>(*options_.checkpoint_every) == 0;
    const std::chrono::duration<double> since = std::chrono::steady_clock::now() - last_time_;
    return since.count() >= options_.checkpoint_seconds.value_or(default_seconds_between);
}

void Checkpoints::write(const World& world, const std::optional<JointTargets>& targets, checkpoint::Moment moment) {
    const auto start = std::chrono::steady_clock::now();
    moment.step = world.statistics().steps;
    if (!writer_ || (moment.step == last_step_ && (count_.written > 0 || last_))) return;
    moment.time = world.time();
    moment.state_hash = world.state_hash();
    const double processor_start = processor_seconds();
    const Snapshot snapshot = world.save();
    count_.saving_seconds += processor_seconds() - processor_start;
    std::array<std::span<const std::byte>, sections> bytes;
    bytes[state] = snapshot.bytes;
    if (snapshot.definitions != definitions_) bytes[definitions] = snapshot.definitions->bytes;
    std::vector<std::byte> of_targets;
    if (targets) of_targets = targets->save();
    bytes[targets_of_joints] = of_targets;
    try {
        writer_->write(moment, bytes);
    } catch (const Error& error) {
        const std::string last = last_step_ == 0
                                     ? "there is no older checkpoint"
                                     : fmt::format("the last complete checkpoint is of step {}", last_step_);
        throw Error(error.code(), error.field(), {},
                    fmt::format("{} (of the checkpoint of step {}; {})",
                                std::string(error.what()).substr(error.field().size() + 2), moment.step, last));
    }
    last_step_ = count_.last_step = moment.step;
    ++count_.written;
    count_.own_part_seconds = writer_->part_seconds();
    for (const std::span<const std::byte> section : bytes) count_.bytes += static_cast<double>(section.size());
    last_time_ = std::chrono::steady_clock::now();
    count_.seconds += std::chrono::duration<double>(last_time_ - start).count();
}

std::string describe(const CheckpointCount& count, const RunOptions& options) {
    if (count.written == 0) return {};
    const double each = 1.0 / static_cast<double>(count.written);
    return fmt::format("{} in {}, the last of step {}: {:.3g} MB each, in {:.3g} ms\n",
                       count.written == 1 ? "1 checkpoint" : fmt::format("{} checkpoints", count.written),
                       options.checkpoint.generic_string(), count.last_step, 1e-6 * count.bytes * each,
                       1e3 * count.seconds * each);
}

} // namespace cairn::cli
