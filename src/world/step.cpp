// One step, top to bottom. Each line is a stage; each stage is a file. A step is one pass through them; while
// something whirls and touches (see bodies/motion_budget.h), it is several.
#include "bodies/finalize.h"
#include "bodies/motion_budget.h"
#include "contacts/contact_update.h"
#include "contacts/narrow_phase.h"
#include "contacts/pairs.h"
#include "impacts/resolve_impacts.h"
#include "islands/islands.h"
#include "joints/joints.h"
#include "solver/island_batches.h"
#include "solver/solve.h"
#include "state/state.h"
#include "world/impl.h"
#include "world/validate.h"

#include <algorithm>
#include <atomic>
#include <chrono>

namespace cairn {

namespace {

// Measures the stages one after another.
class StageClock {
  public:
    double lap() {
        const auto now = Clock::now();
        const double ms = std::chrono::duration<double, std::milli>(now - last_).count();
        last_ = now;
        return ms;
    }
    double total() const { return std::chrono::duration<double, std::milli>(last_ - start_).count(); }

  private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point start_ = Clock::now(), last_ = start_;
};

// Other calls that change the world are refused while it lives.
class Busy {
  public:
    explicit Busy(std::atomic<bool>& flag) : flag_(flag) { flag_ = true; }
    ~Busy() { flag_ = false; }

  private:
    std::atomic<bool>& flag_;
};

// Splits the step into passes while something turns at that speed and touches. Where no number is enough, a few do less
// harm than many: each finds contacts at another random angle.
int split_step(StepPasses& passes, float whirl, float dt) {
    constexpr float max_turn = 0.5f, beyond_help = 32.0f; // radians in a pass; in a step
    constexpr int max_passes = 32, few_passes = 8;
    const float turn = whirl * dt;
    if (!(turn > 0)) return 1;
    if (turn > beyond_help) return few_passes; // and all the substeps in each
    return passes.split = std::min(int(std::ceil(turn / max_turn)), max_passes);
}

} // namespace

void World::step(float dt) {
    Impl::Change change(*impl_, commands::world_step, dt);
    if (!(dt > 0) || !std::isfinite(dt)) refuse("World::step dt", to_text(dt), "must be finite and > 0");
    change.begin();
    impl_->make_step(dt);
    if (impl_->listener) impl_->listener->on_step(*this);
}

void World::Impl::make_step(float dt) {
    StageTimes& times = state.statistics.times;
    StageClock clock;
    const Busy busy(stepping);
    if (!state.bodies.dead.empty() || !state.shapes.dead.empty()) are_definitions_known = false; // slots come free
    state.events.begin_step();
    times = {};
    state.statistics.swept_pairs = state.statistics.impacts = state.statistics.stopped_bodies = 0;
    int passes = 1;
    for (int pass = 0; pass < passes; ++pass) {
        step.passes.number = pass;
        for (const std::int32_t island : state.islands.awake) state.islands.all[island].kept_awake = 0;
        wake_driven_joints(state.bodies, state.islands, state.joints, state.events);
        update_pairs(state.bodies, state.shapes, state.contacts, state.islands, state.joints, state.broad_phase,
                     state.events, step.narrow, step.thread_pool.get());
        times.broad_phase += clock.lap();
        state.statistics.tested_pairs =
            update_contacts(state.bodies, state.shapes, state.contacts, state.islands, state.fields, state.broad_phase,
                            state.events, state.settings, step, dt / float(passes));
        times.narrow_phase += clock.lap();
        if (pass == 0) passes = split_step(step.passes, fastest_spinner_in_contact(state.bodies, step.narrow), dt);
        const float pass_dt = dt / float(passes);
        pack_batches(state.bodies, state.contacts, state.islands, state.settings, step, pass_dt);
        times.islands += clock.lap();
        state.clamped_speeds +=
            solve_batches(state.bodies, state.shapes, state.contacts, state.islands, state.joints, state.fields,
                          state.broad_phase, state.settings, step, communicator.get(), pass_dt);
        const double solve = clock.lap(), prepare = step.solver.prepare_share * solve;
        times.prepare += prepare;
        times.solve += solve - prepare;
        finalize_kinematics(state.bodies, state.shapes, state.broad_phase, pass_dt);
        resolve_impacts({state.settings, state.joints, state.fields, state.bodies, state.shapes, state.contacts,
                         state.islands, state.broad_phase, state.events, state.statistics, state.clamped_speeds},
                        step, pass_dt);
        wake_around_moving_planes(state.bodies, state.shapes, state.islands, state.broad_phase, state.events);
        state.statistics.max_penetration =
            report_contacts(state.bodies, state.shapes, state.contacts, state.islands, state.events, state.settings,
                            step.solver, step.narrow, *step.thread_pool, {float(pass) * pass_dt, pass_dt});
        break_joints();
        update_sleep(state.bodies, state.contacts, state.islands, state.joints, state.settings, state.events,
                     step.solved, step.solver);
        times.finalize += clock.lap();
    }
    step.passes = {};
    for (const std::int32_t b : state.bodies.pushed) state.bodies.forces[b] = {}; // they act for one step
    state.bodies.pushed.clear();
    state.events.publish();
    times.total = clock.total();

    ++state.steps;
    state.time += double(dt);
}

} // namespace cairn
