// Time travel: going back, following the known run, and saving it to a file.
#include "viewer/stage.h"

#include <algorithm>
#include <exception>
#include <filesystem>
#include <limits>
#include <mutex>
#include <thread>
#include <utility>

namespace cairn::viewer {

namespace {

// Real time per frame spent on a seek before the intermediate state is shown, s.
constexpr double longest_look = 1.0 / 30.0;
constexpr double writer_interval = 0.1; // s between checks whether a file is finished

} // namespace

// Writes a recording from a copy of the world on a thread of its own.
struct Stage::Writer {
    std::mutex mutex;
    std::optional<std::string> words; // the result message, once it is done
    std::thread thread;

    Writer() = default;
    Writer(const Writer&) = delete;
    Writer& operator=(const Writer&) = delete;
    ~Writer() {
        if (thread.joinable()) thread.join();
    }
};

Stage::~Stage() = default;

double Stage::until_next_step() const {
    if (seeking_ || !others_are_here_) return 0.0;
    const double next = clock_.until_next_step();
    return writer_ ? std::min(next, writer_interval) : next;
}

// Calls `go`, which changes the world's moment, and updates all that depends on it.
template <class Go> bool Stage::travel(const Go& go) {
    seeking_.reset();
    const bool moved = go();
    arrive();
    return moved;
}

// Updates the stage after the world has moved to another moment: objects of the previous one may not exist.
void Stage::arrive() {
    const World& world = scene_.world;
    grab_.holding = false;
    drag_joint_ = {};
    force_field_.reset();
    pull_field_.reset();
    for (const Held& held : held_)
        if (const auto* joint = std::get_if<JointId>(&held.id); joint && world.is_valid(*joint)) drag_joint_ = *joint;
    drop_gone_from_selection();
    for (const BodyId id : world.bodies())
        if (world.body(id).type() == BodyType::dynamic && std::find(order_.begin(), order_.end(), id) == order_.end())
            order_.push_back(id);
    refresh_layout();
}

// Forgets held joints and force fields that were created in an abandoned future; those that existed at the branching
// moment are removed from the world, because nobody holds them now.
void Stage::settle_branch() {
    const std::optional<Moment> branch = timeline_.take_branch();
    if (!branch) return;
    for (Pane& pane : panes_) pane.forget_after(*branch);
    World& world = scene_.world;
    const auto is_present = [&](const Held& held) {
        if (const auto* joint = std::get_if<JointId>(&held.id)) return grab_.holding && *joint == drag_joint_;
        const ForceFieldId field = std::get<ForceFieldId>(held.id);
        return field == force_field_ || field == pull_field_;
    };
    std::vector<Held> present;
    for (const Held& held : held_) {
        if (is_present(held)) {
            present.push_back(held);
        } else if (held.since < *branch) {
            if (const auto* joint = std::get_if<JointId>(&held.id)) {
                if (world.is_valid(*joint)) world.destroy_joint(*joint);
            } else if (world.is_valid(std::get<ForceFieldId>(held.id))) {
                world.remove_force_field(std::get<ForceFieldId>(held.id));
            }
        }
    }
    held_ = std::move(present);
    walk(force_);
    if (!grab_.holding) drag_joint_ = {};
    timeline_.take_branch(); // discards the branch that these removals caused, which needs no handling
    refresh_joints();
}

void Stage::follow() {
    const bool alters = timeline_.follow(scene_.world, [this](const World&) { watch_energy(); });
    take_sample();
    if (alters)
        arrive();
    else {
        previous_ = current_;
        report_broken();
        refresh_motion();
    }
    if (!timeline_.is_at_end() || !timeline_.is_recording()) return;
    clock_.set_paused(true);
    say("The recording ends here: press Space to continue the simulation.");
}

void Stage::go_back() {
    const std::size_t bodies = layout_->bodies.size();
    if (!timeline_.step_back(scene_.world)) {
        clock_.set_paused(true);
        is_backwards_ = false;
        return say("The timeline starts here.");
    }
    const std::shared_ptr<const WorldMotion> before = current_;
    arrive();
    if (layout_->bodies.size() == bodies) previous_ = before;
}

void Stage::go_on_seeking() {
    try {
        const bool is_there = timeline_.seek(scene_.world, {*seeking_, 0}, longest_look);
        if (is_there) seeking_.reset();
        if (is_there && slow_motion_) clock_.set_paused(false);
    } catch (const std::exception& error) {
        seeking_.reset();
        say(error.what());
    }
    arrive();
}

void Stage::operator()(const command::SeekTo& seek) {
    clock_.set_paused(true);
    is_backwards_ = false;
    slow_motion_.reset();
    seeking_ = std::clamp(seek.step, timeline_.first_step(), timeline_.last_step());
}

void Stage::operator()(const command::StepBack&) {
    clock_.set_paused(true);
    is_backwards_ = false;
    if (!travel([&] { return timeline_.step_back(scene_.world); })) say("The timeline starts here.");
}

void Stage::operator()(const command::PlayBackwards&) {
    is_backwards_ = !is_backwards_ || clock_.paused();
    clock_.set_paused(!is_backwards_);
}

void Stage::operator()(const command::Undo&) {
    const std::optional<std::string> name = timeline_.undoable();
    if (!travel([&] { return timeline_.undo(scene_.world); })) return say("There is nothing to undo.");
    clock_.set_paused(true);
    is_backwards_ = false;
    say("Undone: " + *name + ". Ctrl+Shift+Z: redo, Space: continue without it.");
}

void Stage::operator()(const command::Redo&) {
    const std::optional<std::string> name = timeline_.redoable();
    if (!travel([&] { return timeline_.redo(scene_.world); })) return say("There is nothing to redo.");
    clock_.set_paused(true);
    is_backwards_ = false;
    say("Redone: " + *name + ".");
}

// Takes the second run and the panes to this run's moment, each for about `seconds` of real time.
void Stage::take_others_along(double seconds) {
    others_are_here_ = true;
    try {
        if (other_) others_are_here_ = other_->go_to(timeline_.now().step, seconds, looks());
    } catch (const std::exception& error) {
        other_.reset();
        say(std::string("The other run has ended: ") + error.what());
    }
    try {
        for (Pane& pane : panes_) others_are_here_ = pane.go_to(timeline_, seconds, looks()) && others_are_here_;
    } catch (const std::exception& error) {
        panes_.clear();
        panes_start_.reset();
        say(std::string("The panes have ended: ") + error.what());
    }
}

void Stage::operator()(const command::SetPanes& set) {
    if (set.panes.empty()) {
        panes_.clear();
        panes_start_.reset();
        return;
    }
    if (!panes_start_) panes_start_ = {scene_.world.save(), timeline_.now()};
    std::vector<Pane> panes;
    for (std::size_t i = 0; i < std::min(set.panes.size(), most_panes - 1); ++i) {
        if (i < panes_.size() && panes_[i].settings() == set.panes[i])
            panes.push_back(std::move(panes_[i]));
        else
            panes.emplace_back(*panes_start_, scene_.world.threads(), float(clock_.time_step()), set.panes[i], looks());
    }
    panes_ = std::move(panes);
}

// Restarts the panes with the same settings in a new scene.
void Stage::restart_panes() {
    if (!panes_start_) return;
    command::SetPanes again;
    for (const Pane& pane : panes_) again.panes.push_back(pane.settings());
    panes_.clear();
    panes_start_.reset();
    (*this)(again);
}

void Stage::operator()(const command::BranchOff&) {
    seeking_.reset();
    is_backwards_ = false;
    other_ = std::make_unique<SideRun>(scene_.world, timeline_, held_, float(clock_.time_step()), looks());
    parted_at_ = timeline_.now().step;
    timeline_.forget_future();
    say("Branched off: the original run continues beside this one, transparent.");
}

void Stage::operator()(const command::ExchangeRuns&) {
    if (!other_) return say("There is no other run: branch off first.");
    seeking_.reset();
    is_backwards_ = false;
    std::swap(scene_.world, other_->world);
    std::swap(timeline_, other_->timeline);
    std::swap(held_, other_->held);
    for (Pane& pane : panes_) pane.forget_after({parted_at_, 0});
    samples_.clear();
    arrive();
    other_->refresh(looks());
}

void Stage::operator()(const command::EndOtherRun&) {
    if (!other_) return say("There is no other run.");
    other_.reset();
}

void Stage::operator()(const command::SaveRecording& save) {
    if (!savers_.recording) return say("This program cannot write recordings.");
    if (writer_) return say("A recording is being written.");
    auto excerpt =
        std::make_shared<Timeline::Excerpt>(timeline_.excerpt(std::uint64_t(save.seconds / clock_.time_step())));
    writer_ = std::make_shared<Writer>();
    const int threads = std::max(scene_.world.threads() / 2, 1);
    RecordingLooks looks{std::filesystem::path(path_).filename().generic_string(), save.camera, scene_.lights,
                         scene_.appearances, scene_.visuals};
    writer_->thread =
        std::thread([excerpt, threads, looks, write = savers_.recording, writer = writer_.get(), path = save.path] {
            std::string words;
            try {
                World world;
                world.set_threads(threads);
                world.restore(excerpt->start);
                write(path, looks, world, [&] {
                    for (const TimelineLog::Frame& frame : excerpt->log.frames) {
                        for (const auto& change : frame.changes) repeat(world, *change, *excerpt->log.source);
                        if (frame.step) world.execute(*frame.step, *excerpt->log.source);
                    }
                });
                words = "Saved " + path;
            } catch (const std::exception& error) {
                words = error.what();
            }
            const std::lock_guard lock(writer->mutex);
            writer->words = std::move(words);
        });
    say("Saving the last seconds ...");
}

void Stage::operator()(const command::TakeSamples& take) {
    with_samples_ = take.on;
    take_sample();
}

void Stage::watch_energy() {
    if (with_samples_) energy_balance_.before_step(scene_.world);
}

void Stage::take_sample() {
    if (!with_samples_) return;
    const std::uint64_t step = timeline_.now().step;
    EnergyFlow flow;
    if (const Sample* last = samples_.at(step - 1); last != nullptr && step > 0) {
        flow = flow_of(*last);
        const EnergyFlow more = energy_balance_.after_step(scene_.world, clock_.time_step(),
                                                           last->values[std::size_t(Quantity::total_energy)]);
        flow.friction += more.friction;
        flow.impacts += more.impacts;
        flow.external_work += more.external_work;
    }
    samples_.add(measure(scene_.world, selected_, step, clock_.time_step(), flow));
}

void Stage::hear_from_writer() {
    if (!writer_) return;
    {
        const std::lock_guard lock(writer_->mutex);
        if (!writer_->words) return;
        say(*writer_->words);
    }
    writer_.reset();
}

} // namespace cairn::viewer
