#include "viewer/timeline_log.h"

#include <cairn/error.h>
#include <cairn/world.h>

#include <algorithm>
#include <string>
#include <utility>

namespace cairn::viewer {

namespace {

// Numbers of shapes and snapshots of the timeline itself start here; lower ones belong to the recording.
constexpr std::uint64_t own_numbers = std::uint64_t{1} << 40;

const void* geometry_of(const Shape& shape) {
    if (const auto* hull = std::get_if<Hull>(&shape)) return hull->data().get();
    if (const auto* mesh = std::get_if<Mesh>(&shape)) return mesh->data().get();
    if (const auto* field = std::get_if<HeightField>(&shape)) return field->data().get();
    return nullptr;
}

template <class Parts> const auto& part_of(const Parts& parts, std::uint64_t number, const char* what) {
    if (number - own_numbers >= parts.size())
        throw Error(ErrorCode::invalid_file, what, std::to_string(number), "is not in the timeline");
    return parts[std::size_t(number - own_numbers)];
}

} // namespace

// A copy of the referenced objects, for another thread.
struct TimelineLog::Parts final : CommandSource {
    std::deque<Shape> shapes;
    std::deque<Snapshot> snapshots;
    std::shared_ptr<CommandSource> recorded;

    const Shape& shape(std::uint64_t number) override {
        return number < own_numbers && recorded ? recorded->shape(number) : part_of(shapes, number, "shape");
    }
    const Snapshot& snapshot(std::uint64_t number) override {
        return number < own_numbers && recorded ? recorded->snapshot(number) : part_of(snapshots, number, "snapshot");
    }
};

TimelineLog::TimelineLog(const RecordedRun& run) : recorded_(run.source) {
    for (const RecordedStep& step : run.steps) {
        Frame frame;
        for (const std::vector<std::byte>& change : step.changes) frame.changes.push_back(shared(change));
        if (!step.step.empty()) frame.step = shared(step.step);
        frame.digest = step.digest;
        frames_.push_back(std::move(frame));
    }
    if (frames_.empty() || frames_.back().step) frames_.emplace_back();
}

TimelineLog::Bytes TimelineLog::shared(std::span<const std::byte> command) {
    const bool is_step = command_name(command) == "World::step";
    if (is_step && last_step_command_ && std::ranges::equal(*last_step_command_, command)) return last_step_command_;
    auto bytes = std::make_shared<const std::vector<std::byte>>(command.begin(), command.end());
    bytes_ += command.size() + sizeof(*bytes);
    if (is_step) last_step_command_ = bytes;
    return bytes;
}

bool TimelineLog::is_at_end() const { return now.step == last_step() && now.changes == frames_.back().changes.size(); }

void TimelineLog::truncate() {
    if (is_at_end()) return;
    branched_at_ = branched_at_ ? std::min(*branched_at_, now) : now;
    frames_.resize(std::size_t(now.step - first_step_) + 1);
    Frame& open = frames_.back();
    open.changes.resize(now.changes);
    open.step.reset();
    open.digest.reset();
}

void TimelineLog::forget_before(std::uint64_t step) {
    while (first_step_ < step && frames_.size() > 1) {
        for (const Bytes& change : frames_.front().changes) bytes_ -= change->size() + sizeof(*change);
        frames_.pop_front();
        ++first_step_;
    }
}

void TimelineLog::note() {
    truncate();
    frames_.back().changes.push_back(std::make_shared<const std::vector<std::byte>>());
    bytes_ += sizeof(std::vector<std::byte>);
    ++now.changes;
}

TimelineLog::Future TimelineLog::future() const {
    Future known{now, {}};
    if (!is_at_end()) known.frames.assign(frames_.begin() + std::ptrdiff_t(now.step - first_step_), frames_.end());
    return known;
}

void TimelineLog::restore_future(const Future& known) {
    frames_.resize(std::size_t(known.from.step - first_step_) + 1);
    if (known.frames.empty()) {
        frames_.back().changes.resize(known.from.changes);
    } else {
        frames_.pop_back();
        frames_.insert(frames_.end(), known.frames.begin(), known.frames.end());
    }
    branched_at_.reset();
}

TimelineLog::Excerpt TimelineLog::excerpt(std::uint64_t from) const {
    Excerpt excerpt;
    const auto begin = frames_.begin() + std::ptrdiff_t(from - first_step_);
    excerpt.frames.assign(begin, begin + std::ptrdiff_t(now.step - from) + 1);
    excerpt.frames.back().changes.resize(now.changes);
    excerpt.frames.back().step.reset();
    auto parts = std::make_shared<Parts>();
    parts->shapes = shapes_;
    parts->snapshots = snapshots_;
    parts->recorded = recorded_;
    excerpt.source = std::move(parts);
    return excerpt;
}

void TimelineLog::on_command(std::span<const std::byte> command) {
    if (is_logging_paused) return;
    truncate();
    Frame& open = frames_.back();
    if (command_name(command) == "World::step") {
        open.step = shared(command);
    } else {
        open.step.reset(); // left by a step that was begun but not completed
        open.changes.push_back(shared(command));
        ++now.changes;
    }
}

void repeat(World& world, const std::vector<std::byte>& change, CommandSource& source) {
    if (!change.empty()) world.execute(change, source);
}

// If memory runs out, the step is discarded and not counted.
void TimelineLog::on_step(const World&) noexcept {
    if (is_logging_paused) return;
    try {
        frames_.emplace_back();
        now = {now.step + 1, 0};
    } catch (const std::bad_alloc&) {
        frames_.back().step.reset();
    }
}

std::uint64_t TimelineLog::number_of(const Shape& shape) {
    const auto [found, is_new] = numbers_.try_emplace(geometry_of(shape), own_numbers + shapes_.size());
    if (is_new) shapes_.push_back(shape); // keeps the data alive, so that its address stays unique
    return found->second;
}

std::uint64_t TimelineLog::number_of(const Snapshot& snapshot) {
    if (is_logging_paused) return 0;
    snapshots_.push_back(snapshot);
    bytes_ += snapshot.bytes.size();
    return own_numbers + snapshots_.size() - 1;
}

const Shape& TimelineLog::shape(std::uint64_t number) {
    return number < own_numbers && recorded_ ? recorded_->shape(number) : part_of(shapes_, number, "shape");
}

const Snapshot& TimelineLog::snapshot(std::uint64_t number) {
    return number < own_numbers && recorded_ ? recorded_->snapshot(number) : part_of(snapshots_, number, "snapshot");
}

} // namespace cairn::viewer
