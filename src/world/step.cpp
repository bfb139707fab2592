// One step, from top to bottom: each line is a stage, and each stage has a file of its own.
#include "bodies/finalize.h"
#include "bodies/fluids.h"
#include "bodies/motion_budget.h"
#include "character/move_characters.h"
#include "contacts/contact_update.h"
#include "contacts/narrow_phase.h"
#include "contacts/pairs.h"
#include "impacts/resolve_impacts.h"
#include "islands/islands.h"
#include "joints/direct_sets.h"
#include "joints/joints.h"
#include "solver/island_batches.h"
#include "solver/rank_cut.h"
#include "solver/solve.h"
#include "state/state.h"
#include "state/substeps.h"
#include "world/impl.h"
#include "world/validate.h"

#include <algorithm>
#include <atomic>
#include <chrono>

namespace cairn {

namespace {

// Measures the time of consecutive stages.
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

// While an object of this class exists, other calls that change the world are refused.
class Busy {
  public:
    explicit Busy(std::atomic<bool>& flag) : flag_(flag) { flag_ = true; }
    ~Busy() { flag_ = false; }

  private:
    std::atomic<bool>& flag_;
};

// On destruction, restores the masses of bodies that carried the added mass of fluids.
class Unloading {
  public:
    Unloading(Bodies& bodies, FluidScratch& scratch) : bodies_(bodies), scratch_(scratch) {}
    ~Unloading() { unload(bodies_, scratch_); }
    Unloading(const Unloading&) = delete;
    Unloading& operator=(const Unloading&) = delete;

  private:
    Bodies& bodies_;
    FluidScratch& scratch_;
};

} // namespace

int World::usual_substeps(float dt) const {
    if (!(dt > 0) || !std::isfinite(dt)) refuse("World::usual_substeps dt", to_text(dt), "must be finite and > 0");
    return substeps_of(impl_->state.settings, dt);
}

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
    if (!state.bodies.dead.empty() || !state.shapes.dead.empty()) are_definitions_known = false; // slots are recycled
    state.events.begin_step();
    times = {};
    if (communicator) share_out_records(state.bodies, state.contacts, step.solver, *communicator);
    state.statistics.swept_pairs = state.statistics.impacts = state.statistics.stopped_bodies = 0;
    for (const std::int32_t island : state.islands.awake) state.islands.all[island].kept_awake = 0;
    move_characters({state.settings, state.fields, state.bodies, state.shapes, state.islands, state.broad_phase,
                     state.events, state.characters},
                    step.characters, dt);
    wake_driven_joints(state.bodies, state.islands, state.joints, state.events);
    update_direct_sets(state.bodies, state.joints, step.direct);
    const Unloading unloading(state.bodies, step.fluids);
    const FluidContext fluids{state.settings, state.fields, state.bodies, state.shapes, state.islands};
    push_by_fluids(fluids, step.fluids, *step.thread_pool, dt);
    update_pairs(state.bodies, state.shapes, state.contacts, state.islands, state.joints, state.broad_phase,
                 state.events, step.thread_pool.get());
    times.broad_phase = clock.lap();
    state.statistics.tested_pairs =
        update_contacts(state.bodies, state.shapes, state.contacts, state.islands, state.joints, state.fields,
                        state.broad_phase, state.events, state.settings, step, communicator.get(), dt);
    apply_sleep_requests(state.bodies, state.contacts, state.islands, state.events, step.solved);
    push_by_fluids(fluids, step.fluids, *step.thread_pool, dt); // for bodies that have woken since
    times.narrow_phase = clock.lap();
    pack_batches(state.bodies, state.contacts, state.islands, state.fields, state.settings, step, communicator.get(),
                 dt);
    times.islands = clock.lap();
    state.clamped_speeds +=
        solve_batches(state.bodies, state.shapes, state.contacts, state.islands, state.joints, state.fields,
                      state.broad_phase, state.settings, step, communicator.get(), dt);
    const double solve = clock.lap();
    times.prepare = step.solver.prepare_share * solve;
    times.solve = solve - times.prepare;
    finalize_kinematics(state.bodies, state.shapes, state.broad_phase, dt);
    resolve_impacts({state.settings, state.joints, state.fields, state.bodies, state.shapes, state.contacts,
                     state.islands, state.broad_phase, state.events, state.statistics, state.clamped_speeds,
                     communicator.get()},
                    step, dt);
    wake_around_moving_planes(state.bodies, state.shapes, state.islands, state.broad_phase, state.events);
    state.statistics.max_penetration =
        report_contacts(state.bodies, state.shapes, state.contacts, state.islands, state.events, state.settings,
                        step.solver, step.narrow, *step.thread_pool, communicator.get(), dt);
    break_joints();
    update_sleep(state.bodies, state.contacts, state.islands, state.joints, state.settings, state.events, step.solved,
                 step.solver);
    times.finalize = clock.lap();
    for (const std::int32_t b : state.bodies.pushed) state.bodies.forces[b] = {}; // forces act for one step
    state.bodies.pushed.clear();
    state.events.publish();
    step.shrink_capacity();
    times.total = clock.total();

    ++state.steps;
    state.time += double(dt);
}

} // namespace cairn
