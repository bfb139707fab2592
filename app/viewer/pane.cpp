#include "viewer/pane.h"

#include "viewer/elapsed.h"
#include "viewer/integrators.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <exception>
#include <iterator>
#include <utility>

namespace cairn::viewer {

namespace {

constexpr std::uint64_t keyframe_interval = 60; // the pane's own steps
constexpr std::size_t most_keyframes = 64;      // when exceeded, every second one is dropped

} // namespace

std::string describe(const PaneSettings& settings, bool may_be_more) {
    char text[128];
    std::snprintf(text, sizeof text, "step 1/%g s, %d %s%s, %s", double(std::round(1.0f / settings.step_length)),
                  settings.substeps, settings.substeps == 1 ? "substep" : "substeps", may_be_more ? " or more" : "",
                  name_of(settings.integrator));
    std::string line = text;
    if (settings.friction) {
        std::snprintf(text, sizeof text, ", friction %.2g", double(*settings.friction));
        line += text;
    }
    return line;
}

Pane::Pane(const PaneStart& start, int threads, float first_step_length, const PaneSettings& settings,
           const Looks& looks)
    : settings_(settings), first_step_length_(first_step_length), start_(start.moment), done_(start.moment) {
    world_.set_threads(threads);
    world_.restore(start.snapshot);
    take_settings();
    keyframes_.emplace(0, Keyframe{world_.save(), done_});
    read_picture(true, looks);
    picture_.previous = picture_.current;
}

void Pane::read_picture(bool with_layout, const Looks& looks) {
    if (with_layout) {
        picture_.layout =
            std::make_shared<const WorldLayout>(read_layout(world_, looks.appearances, meshes_, looks.visuals));
        joints_ =
            std::make_shared<const std::vector<JointLayout>>(read_joints(world_, *picture_.layout, {}, looks.strings));
    }
    picture_.current = std::make_shared<const WorldMotion>(read_motion(world_, *picture_.layout, false, joints_));
}

void Pane::take_settings() {
    WorldDef def = world_.settings();
    def.substeps = settings_.substeps;
    def.adaptive_substeps = false;
    def.integrator = settings_.integrator;
    world_.set_settings(def);
    if (!settings_.friction) return;
    for (const BodyId body : std::as_const(world_).bodies())
        for (const ShapeId shape : std::as_const(world_).body(body).shapes()) {
            Material material = world_.shape_def(shape).material;
            material.static_friction = material.dynamic_friction = *settings_.friction;
            world_.set_material(shape, material);
        }
}

// Number of the pane's own steps that precede the changes made before step `first_step` of the main run.
std::uint64_t Pane::step_at(std::uint64_t first_step) const {
    const double time = double(first_step - std::min(start_.step, first_step)) * double(first_step_length_);
    return std::uint64_t(time / double(settings_.step_length) + 1e-4);
}

// Repeats the changes that precede the next own step. Returns true if bodies may have been added, removed or changed.
bool Pane::repeat_changes(Timeline& first) {
    const Moment now = first.now();
    done_ = std::max(done_, Moment{first.first_step(), 0}); // older changes are not known
    bool alters = false;
    while (done_ < now && step_at(done_.step) <= step_) {
        const std::size_t count = done_.step == now.step ? now.changes : first.change_count(done_.step);
        for (; done_.changes < count; ++done_.changes) {
            try {
                alters = first.repeat_change(world_, done_) || alters;
            } catch (const std::bad_alloc&) {
                throw;
            } catch (const std::exception& error) {
                trouble_ = error.what();
            }
        }
        if (done_.step == now.step) break;
        done_ = {done_.step + 1, 0};
    }
    if (alters) take_settings();
    return alters;
}

// Restores the last keyframe at or before `step` that belongs to the run up to `moment`.
void Pane::restore(std::uint64_t step, const Moment& moment) {
    auto kept = std::prev(keyframes_.upper_bound(step));
    while (kept != keyframes_.begin() && kept->second.done > moment) --kept;
    world_.restore(kept->second.snapshot);
    step_ = kept->first;
    done_ = kept->second.done;
    trouble_.clear();
}

void Pane::forget_after(const Moment& moment) {
    std::erase_if(keyframes_, [&](const auto& item) { return item.first > 0 && item.second.done > moment; });
    is_stale_ = is_stale_ || done_ > moment;
}

bool Pane::go_to(Timeline& first, double seconds, const Looks& looks) {
    const auto start = std::chrono::steady_clock::now();
    const Moment now = std::max(first.now(), start_);
    const std::uint64_t target = step_at(now.step), before = step_;
    bool alters = false;
    if (is_stale_ || done_ > now || step_ > target) {
        restore(target, now);
        alters = true;
        is_stale_ = false;
    }
    const bool jumps = target > step_ + 2 * (step_at(start_.step + 1) + 1);
    for (;;) {
        alters = repeat_changes(first) || alters;
        if (step_ >= target || (jumps && seconds_since(start) >= seconds)) break;
        world_.step(settings_.step_length);
        ++step_;
        alters = alters || !world_.joint_events().empty(); // joints may have broken
        if (step_ % keyframe_interval == 0) keyframes_.insert_or_assign(step_, Keyframe{world_.save(), done_});
    }
    if (keyframes_.size() > most_keyframes) { // the first keyframe stays
        bool is_second = true;
        std::erase_if(keyframes_, [&](const auto&) { return is_second = !is_second; });
    }
    picture_.previous = picture_.current;
    if (alters || step_ != before) read_picture(alters, looks);
    if (alters) picture_.previous = picture_.current; // the bodies of the preceding step may not match
    return step_ >= target;
}

PaneState Pane::state(const WorldLayout& layout, const WorldMotion& motion) const {
    return {settings_, picture_, world_.kinetic_energy() + world_.potential_energy(),
            difference(layout, motion, picture_), trouble_};
}

} // namespace cairn::viewer
