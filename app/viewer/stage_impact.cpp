// Explanation of an impact of the run, and its replay in slow motion.
#include "viewer/stage.h"

#include <algorithm>
#include <limits>

namespace cairn::viewer {

namespace {

constexpr double slow_speed = 1.0 / 32.0; // simulated seconds per real second
constexpr std::uint64_t shown_steps = 6;  // before and after the impact

} // namespace

void Stage::operator()(const command::ExplainImpact& explain) {
    impact_.reset();
    impact_partners_.clear();
    if (!explain.body || !scene_.world.is_valid(explain.body)) return;
    const KnownHit* last = nullptr;
    const auto& hits = timeline_.hits();
    for (auto known = hits.rbegin(); known != hits.rend(); ++known) {
        const ContactHit& hit = known->hit;
        if (known->step > timeline_.now().step || (hit.body_a != explain.body && hit.body_b != explain.body)) continue;
        const BodyId partner = hit.body_a == explain.body ? hit.body_b : hit.body_a;
        if (std::find(impact_partners_.begin(), impact_partners_.end(), partner) == impact_partners_.end())
            impact_partners_.push_back(partner);
        if (last == nullptr && (!explain.partner || partner == explain.partner)) last = &*known;
    }
    if (last == nullptr || last->step <= timeline_.first_step()) return;
    // Uses a copy of the world, which can be taken back to the state before the impact.
    World copy;
    copy.set_threads(scene_.world.threads());
    copy.restore(scene_.world.save());
    Timeline timeline = timeline_.fork(copy);
    timeline.seek(copy, {last->step - 1, std::numeric_limits<std::uint32_t>::max()});
    impact_ = explain_impact(copy, *last, float(clock_.time_step()));
}

void Stage::operator()(const command::WatchImpact&) {
    if (!impact_) return say("No impact is selected.");
    const double speed = slow_motion_ ? slow_motion_->speed_before : clock_.speed();
    (*this)(command::SeekTo{impact_->step - std::min(impact_->step, shown_steps)});
    slow_motion_ = {impact_->step + shown_steps, speed};
    clock_.set_speed(slow_speed);
}

void Stage::end_slow_motion() {
    if (!slow_motion_ || timeline_.now().step < slow_motion_->end) return;
    clock_.set_paused(true);
    clock_.set_speed(slow_motion_->speed_before);
    slow_motion_.reset();
}

} // namespace cairn::viewer
