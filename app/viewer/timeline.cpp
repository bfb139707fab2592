#include "viewer/timeline.h"

#include "viewer/elapsed.h"

#include <cairn/error.h>
#include <cairn/world.h>

#include <algorithm>
#include <bit>
#include <chrono>
#include <iterator>
#include <limits>
#include <string_view>
#include <utility>

namespace cairn::viewer {

namespace {

using Clock = std::chrono::steady_clock;

constexpr double longest_way = 0.1; // s of compute time of steps; longer distances are bridged by restoring a state
// Share of the steps' compute time that keeping states may take on their thread.
constexpr double greatest_share = 0.035;
constexpr std::uint64_t least_interval = 15,
                        most_interval = 240; // steps between kept states, before any thinning out
constexpr std::size_t fewest_states = 8;     // kept even if the budget is exceeded
constexpr std::size_t most_in_ring = 240;
constexpr double newest_weight = 0.1; // of moving averages
constexpr std::size_t ring_bytes = std::size_t{96} << 20;
constexpr std::size_t most_hits = 8192;
constexpr std::uint64_t same_event = 15;  // steps within which impacts share one mark
constexpr std::uint64_t same_change = 60; // steps within which changes by the same slider are merged

double mean(double old, double value) { return old == 0.0 ? value : old + newest_weight * (value - old); }

// Combines the four sums into one number.
std::uint64_t hash_of(const StateDigest& digest) {
    std::uint64_t hash = 0;
    for (const std::uint64_t sum : digest.sums) hash = std::rotl(hash, 17) ^ sum;
    return hash;
}

// Whether a command may create or remove objects, or change a type, name or shape.
bool alters_layout(const std::vector<std::byte>& command) {
    if (command.empty()) return false; // a group note
    const std::string_view name = command_name(command);
    for (const std::string_view harmless :
         {"World::set_joint", "Body::set_linear_velocity", "Body::set_angular_velocity", "Body::wake",
          "Body::apply_impulse", "Body::add_force", "World::set_force_field"})
        if (name == harmless) return false;
    return true;
}

} // namespace

void Timeline::begin(World& world, const RecordedRun& run, Groups groups) {
    log_ = std::make_shared<TimelineLog>(run);
    {
        const LoggingPause going(*log_); // the listener gets the initial state, which is not a new command
        world.set_command_listener(log_);
    }
    recorded_keyframe_ = run.keyframe;
    recorded_until_ = run.keyframe ? std::numeric_limits<std::uint64_t>::max() : 0;
    changes_.clear();
    groups_.clear();
    groups_.emplace(Moment{}, std::move(groups));
    events_.clear();
    hits_.clear();
    watched_until_ = 0;
    is_undone_ = false;
    step_seconds_ = keep_seconds_ = since_kept_ = keeping_seconds_ = 0.0;
    ring_.states.reset();
    verdict_ = {};
    name_recorded_changes();
    states_ = KeptStates();
    states_.keep(world, 0);
    forget_what_came_before();
    gather_marks();
}

// Names recorded changes after their calls, since nothing else is known of them.
void Timeline::name_recorded_changes() {
    for (std::uint64_t step = 0; step < log_->last_step(); ++step) {
        const auto& changes = log_->frame(step).changes;
        const auto first =
            std::find_if(changes.begin(), changes.end(), [](const auto& command) { return alters_layout(*command); });
        if (first == changes.end()) continue;
        std::string name(command_name(**first));
        name.erase(0, name.find(':') == std::string::npos ? 0 : name.rfind(':') + 1);
        std::replace(name.begin(), name.end(), '_', ' ');
        changes_.push_back({{step, 0}, {step, std::uint32_t(changes.size())}, std::move(name)});
    }
}

// Whether the next state is to be kept: after enough compute time of steps that keeping one costs only a small share of
// it, and not longer than an acceptable wait when seeking; or after many steps.
bool Timeline::is_state_due(std::uint64_t steps) const {
    const double thinned = states_.thinned();
    const double least = std::max(states_.least_seconds(), thinned * keep_seconds_ / greatest_share);
    return double(steps) >= thinned * least_interval && since_kept_ >= least &&
           (since_kept_ >= states_.usual_seconds() || double(steps) >= thinned * most_interval);
}

// Keeps the present state if it is due. States are kept in the order of their steps; repeated steps before the last
// kept one are skipped.
void Timeline::keep(const World& world, double step_seconds) {
    step_seconds_ = mean(step_seconds_, step_seconds);
    since_kept_ += step_seconds;
    const std::uint64_t step = log_->now.step;
    if (states_.digest(step) != nullptr) since_kept_ = 0.0;
    const auto is_due = [&] { return step > states_.last() && is_state_due(step - states_.last()); };
    if (!is_due()) return;
    const Clock::time_point start = Clock::now();
    states_.settle();
    make_room(2 * states_.last_size()); // the state and its difference
    if (is_due()) {
        states_.keep(world, step);
        since_kept_ = 0.0;
    }
    const double seconds = seconds_since(start);
    keep_seconds_ = mean(keep_seconds_, seconds);
    keeping_seconds_ += seconds;
}

// Frees memory: thins out the states first, which keeps the whole past reachable; only if that does not suffice, drops
// the oldest part of the run.
void Timeline::make_room(std::size_t more) {
    while (bytes() + more > budget_ && states_.count() > fewest_states) states_.thin_out();
    while (bytes() + more > budget_ && states_.count() > 2) {
        states_.drop_oldest();
        log_->forget_before(states_.first());
    }
    forget_what_came_before();
}

void Timeline::forget_what_came_before() {
    const std::uint64_t first = log_->first_step();
    while (!changes_.empty() && changes_.front().begin.step < first) changes_.pop_front();
    groups_.erase(groups_.begin(), std::prev(groups_.upper_bound(Moment{first, 0})));
    while (!events_.empty() && events_.front().step < first) events_.pop_front();
}

void Timeline::drop_other_future() {
    const std::optional<Moment> branch = log_->take_branch();
    if (!branch) return;
    branched_at_ = branched_at_ ? std::min(*branched_at_, *branch) : *branch;
    is_undone_ = false;
    recorded_until_ = std::min(recorded_until_, branch->step);
    states_.drop_after(branch->step);
    since_kept_ = step_seconds_ * double(branch->step - states_.last());
    groups_.erase(groups_.upper_bound(*branch), groups_.end());
    while (!changes_.empty() && changes_.back().begin >= *branch) changes_.pop_back();
    if (!changes_.empty()) changes_.back().end = std::min(changes_.back().end, *branch);
    while (!events_.empty() && events_.back().step > branch->step) events_.pop_back();
    while (!hits_.empty() && hits_.back().step > branch->step) hits_.pop_back();
    watched_until_ = std::min(watched_until_, branch->step);
    ring_.states.reset();
    gather_marks();
}

Timeline Timeline::fork(World& copy) const {
    Timeline other = *this;
    other.log_ = std::make_shared<TimelineLog>(*log_);
    other.log_->take_branch();
    other.is_undone_ = false;
    const LoggingPause going(*other.log_); // the listener gets the state, which is part of the copied log
    copy.set_command_listener(other.log_);
    return other;
}

bool Timeline::repeat_change(World& other, const Moment& change) {
    const std::vector<std::byte>& command = *log_->frame(change.step).changes[change.changes];
    repeat(other, command, *log_);
    return alters_layout(command);
}

void Timeline::forget_future() {
    log_->truncate();
    drop_other_future();
}

std::optional<Moment> Timeline::take_branch() {
    drop_other_future();
    return std::exchange(branched_at_, std::nullopt);
}

void Timeline::after_step(const World& world, double seconds) {
    drop_other_future();
    ring_.states.reset();
    watch(world);
    keep(world, seconds);
}

void Timeline::compare(const World& world) {
    const std::uint64_t step = log_->now.step;
    std::optional<StateDigest> known = log_->frame(step - 1).digest;
    if (const StateDigest* kept = states_.digest(step); !known && kept != nullptr) known = *kept;
    if (!known) return;
    ++verdict_.compared;
    if (verdict_.first_different) return;
    const StateDigest now = world.state_digest();
    verdict_.here = hash_of(now), verdict_.there = hash_of(*known);
    if (now != *known) verdict_.first_different = step;
}

bool Timeline::execute_changes(World& world, std::uint32_t count) {
    const TimelineLog::Frame& frame = log_->frame(log_->now.step);
    bool alters = false;
    while (log_->now.changes < count) {
        const std::vector<std::byte>& command = *frame.changes[log_->now.changes];
        repeat(world, command, *log_);
        ++log_->now.changes;
        alters = alters || alters_layout(command);
    }
    return alters;
}

bool Timeline::follow_one(World& world, const std::function<void(const World&)>& before_step) {
    const LoggingPause going(*log_);
    const TimelineLog::Frame& frame = log_->frame(log_->now.step);
    const bool alters = execute_changes(world, std::uint32_t(frame.changes.size()));
    if (!frame.step) return alters;
    if (before_step) before_step(world);
    const Clock::time_point start = Clock::now();
    world.execute(*frame.step, *log_);
    const double seconds = seconds_since(start);
    log_->now = {log_->now.step + 1, 0};
    compare(world);
    watch(world);
    keep(world, seconds);
    return alters;
}

bool Timeline::follow(World& world, const std::function<void(const World&)>& before_step) {
    ring_.states.reset();
    return follow_one(world, before_step);
}

// Restores the last kept state at or before `step`, if it is later than `after`.
bool Timeline::restore_before(World& world, std::uint64_t step, std::optional<std::uint64_t> after) {
    const LoggingPause going(*log_);
    const std::uint64_t kept = states_.before(step), beyond = std::max(kept, after.value_or(0));
    if (recorded_keyframe_) {
        const auto recorded = recorded_keyframe_(beyond, std::min(step, recorded_until_));
        try {
            if (recorded) {
                world.restore(recorded->second);
                log_->now = {recorded->first, 0};
                since_kept_ = 0.0;
                return true;
            }
        } catch (const Error& error) {
            if (error.code() != ErrorCode::unsupported) throw;
            recorded_keyframe_ = nullptr; // from another build; states are then reached by more steps
        }
    }
    if (after && kept <= *after) return false;
    world.restore(states_.state(kept));
    log_->now = {kept, 0};
    since_kept_ = 0.0;
    return true;
}

bool Timeline::seek(World& world, Moment to, double seconds) {
    const Clock::time_point start = Clock::now();
    drop_other_future();
    ring_.states.reset();
    is_undone_ = false;
    to.step = std::clamp(to.step, first_step(), last_step());
    to.changes = std::min(to.changes, std::uint32_t(log_->frame(to.step).changes.size()));
    if (log_->now > to)
        restore_before(world, to.step, std::nullopt);
    else if (const std::uint64_t steps = to.step - log_->now.step;
             double(steps) * step_seconds_ > longest_way || steps > most_interval)
        restore_before(world, to.step, log_->now.step);
    while (log_->now.step < to.step) {
        follow_one(world);
        if (log_->now.step < to.step && seconds_since(start) > seconds) return false;
    }
    const LoggingPause going(*log_);
    execute_changes(world, to.changes);
    return true;
}

bool Timeline::step_back(World& world) {
    drop_other_future();
    is_undone_ = false;
    if (log_->now.step == first_step()) {
        if (log_->now.changes == 0) return false;
        ring_.states.reset();
        return seek(world, {first_step(), 0});
    }
    const std::uint64_t to = log_->now.step - 1;
    const LoggingPause going(*log_);
    if (ring_.states && ring_.last >= to && ring_.last - to < ring_.states->size()) {
        ring_.states->restore(world, std::size_t(ring_.last - to));
    } else {
        restore_before(world, to, std::nullopt);
        ring_.states.emplace(std::clamp<std::size_t>(2 * ring_bytes / (states_.last_size() + 1), 8, most_in_ring));
        for (;;) {
            if (to - log_->now.step < ring_.states->capacity()) ring_.states->push(world);
            if (log_->now.step >= to) break;
            follow_one(world);
        }
    }
    ring_.last = to;
    log_->now = {to, 0};
    return true;
}

void Timeline::name_change(const Moment& from, std::string name, Merge merge) {
    drop_other_future();
    if (log_->now == from) return;
    if (std::exchange(has_ended_, false)) merge = Merge::never;
    if (merge != Merge::never && !changes_.empty() && changes_.back().name == name) {
        Change& last = changes_.back();
        if (merge == Merge::always || last.end.step + same_change >= from.step) {
            last.end = log_->now;
            return;
        }
    }
    changes_.push_back({from, log_->now, std::move(name)});
    gather_marks();
}

void Timeline::unname_change(const std::string& name) {
    if (changes_.empty() || changes_.back().name != name) return;
    changes_.pop_back();
    gather_marks();
}

void Timeline::attempt(World& world, const std::function<void()>& change) {
    drop_other_future();
    const TimelineLog::Future known = log_->future();
    const bool was_undone = is_undone_;
    try {
        change();
    } catch (...) {
        if (log_->now != known.from) {
            log_->restore_future(known);
            seek(world, known.from);
            is_undone_ = was_undone;
        }
        throw;
    }
}

void Timeline::set_groups(Groups groups) {
    log_->note();
    drop_other_future();
    groups_.insert_or_assign(log_->now, std::move(groups));
}

void Timeline::watch(const World& world) {
    const std::uint64_t step = log_->now.step;
    if (step <= watched_until_) return; // a repeated step, whose events are known
    watched_until_ = step;
    float fastest = 0.0f;
    const auto before = std::ptrdiff_t(hits_.size());
    for (const ContactHit& hit : world.contact_hits()) {
        fastest = std::max(fastest, hit.approach_speed);
        hits_.push_back({step, hit});
    }
    std::stable_sort(hits_.begin() + before, hits_.end(),
                     [](const KnownHit& a, const KnownHit& b) { return a.hit.time < b.hit.time; });
    while (hits_.size() > most_hits) hits_.pop_front();
    if (fastest > 0.0f) note({Mark::Kind::impact, step, fastest, {}});
    for (const JointEvent& event : world.joint_events())
        if (event.broke) note({Mark::Kind::break_, step, event.force, "joint " + std::to_string(event.joint.index())});
}

void Timeline::note(Mark mark) {
    const auto same = [&](const Mark& other) {
        return mark.kind == Mark::Kind::impact && other.kind == mark.kind && other.step + same_event > mark.step;
    };
    if (!events_.empty() && same(events_.back())) {
        if (events_.back().strength >= mark.strength) return;
        events_.pop_back();
    }
    events_.push_back(std::move(mark));
    gather_marks();
}

void Timeline::gather_marks() {
    std::vector<Mark> marks(events_.begin(), events_.end());
    for (const Change& change : changes_) marks.push_back({Mark::Kind::change, change.begin.step, 0.0f, change.name});
    std::stable_sort(marks.begin(), marks.end(), [](const Mark& a, const Mark& b) { return a.step < b.step; });
    marks_ = std::make_shared<const std::vector<Mark>>(std::move(marks));
}

std::optional<std::string> Timeline::undoable() const {
    for (auto change = changes_.rbegin(); change != changes_.rend(); ++change)
        if (change->begin < log_->now) return change->name;
    return std::nullopt;
}

std::optional<std::string> Timeline::redoable() const {
    for (const Change& change : changes_)
        if (change.begin >= log_->now) return change.name;
    return std::nullopt;
}

bool Timeline::undo(World& world) {
    drop_other_future();
    for (auto change = changes_.rbegin(); change != changes_.rend(); ++change) {
        if (!(change->begin < log_->now)) continue;
        seek(world, change->begin);
        is_undone_ = true;
        return true;
    }
    return false;
}

bool Timeline::redo(World& world) {
    drop_other_future();
    for (const Change& change : changes_) {
        if (change.begin < log_->now) continue;
        seek(world, change.end);
        is_undone_ = true;
        return true;
    }
    return false;
}

Timeline::Excerpt Timeline::excerpt(std::uint64_t steps) const {
    const std::uint64_t from = log_->now.step - std::min(steps, log_->now.step - first_step());
    const std::uint64_t kept = states_.before(from);
    return {states_.state(kept), log_->excerpt(kept)};
}

} // namespace cairn::viewer
