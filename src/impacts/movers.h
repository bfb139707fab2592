// Bodies on their way through a step: where they are at any time in it, and how fast; and how they go on when an impact
// changes their velocities.
#pragma once

#include "state/state.h"
#include "state/step_scratch.h"

#include <optional>
#include <span>

namespace cairn {

struct MovingState {
    math::DVec3 x; // center of mass
    math::DQuat q;
    math::DVec3 v, w;
};

// What movers read, and what they change as they are redirected and put back: bodies, the places of their shapes, and
// how often a speed was cut.
struct MoverContext {
    const WorldDef& settings;
    const Islands& islands;
    const ForceFields& fields;
    Bodies& bodies;
    Shapes& shapes;
    BroadPhase& broad_phase;
    std::uint64_t& clamped_speeds;
};

class Movers {
  public:
    Movers(const MoverContext& context, SweepScratch& scratch, float dt);
    ~Movers();
    Movers(const Movers&) = delete;
    Movers& operator=(const Movers&) = delete;

    std::int32_t add(std::int32_t body);
    void add(std::span<const std::int32_t> bodies, ThreadPool& thread_pool); // those of them that are none yet
    std::int32_t of_body(std::int32_t body) const { return place_[std::size_t(body)]; }
    Mover& operator[](std::int32_t i) { return movers_[std::size_t(i)]; }
    const Mover& operator[](std::int32_t i) const { return movers_[std::size_t(i)]; }
    std::int32_t count() const { return std::int32_t(movers_.size()); }

    MovingState state_at(std::int32_t i, double time) const;
    // How forces, and the change of its own turn, change the velocity of what is free, m/s^2, rad/s^2.
    void go_on_freely(std::int32_t i, const MovingState& now, math::DVec3& pull, math::DVec3& spin_change) const;
    // From its body's center of mass to the origin of a shape, m, as the body is turned.
    math::DVec3 arm_of(std::uint32_t shape, math::DQuat q) const;
    // The path of what is free, from the start on, is made of chords that are nowhere as far from its parabola as a
    // core is deep: for what may meet something.
    void follow_parabola(std::int32_t i);
    // The pose of `now` and its velocities are those of the time; the rest of the way is made anew: of what turns far
    // and is free, up to a part of a turn, where it has to be renewed.
    void redirect(std::int32_t i, double time, const MovingState& now);
    // It goes by `dv` and `dw` faster on the rest of its way. `and_velocity`: so it does in the end, as what is free
    // does in any case; else it arrives with the velocities that the solver gave it.
    void push_way(std::int32_t i, double time, math::DVec3 dv, math::DVec3 dw, bool and_velocity);
    // Something kinematic takes it along from a time on, and lets go of it in the end: then it slides on as fast as it
    // did, but for what approached along `axis`, a direction of any length.
    void carry(std::int32_t i, double time, std::int32_t carrier, math::DVec3 axis);
    // The next part of the path of what is led.
    void lead_on(std::int32_t i, double time);
    // It lies on something in the direction of the unit vector `down`: the forces that press it there do not move it.
    void rest_on(std::int32_t i, math::DVec3 down);
    void stop(std::int32_t i, double time) { (*this)[i].until = time; }
    // All that were redirected or stopped: where they are at the end of the step. Returns how many were stopped.
    std::size_t put_back();
    bool is_put_back(std::int32_t body) const { return of_body(body) != none && is_put_back((*this)[of_body(body)]); }

    // Of what does not move by forces, or is slow: where it was at the start of the step and is at its end.
    RigidPath path_of(std::int32_t body) const;
    DBounds bounds_of_way(const Mover& m, double from) const;

    // A ball about its center of mass, on no joints: its turns bring its surface nowhere.
    bool is_round(std::int32_t body) const;

  private:
    static bool is_put_back(const Mover& m) { return m.is_changed || m.has_stopped(); }
    std::int32_t append(std::int32_t body);
    void set_out(std::int32_t i);
    math::DVec3 acceleration_on(const RigidPath& path, std::int32_t body) const;
    // From several threads at once.
    void note_clamped(std::uint64_t times) const { __atomic_fetch_add(&s.clamped_speeds, times, __ATOMIC_RELAXED); }
    math::DVec3 spin_later(const Mover& m, math::DVec3 w, math::DQuat from, math::DQuat to, double duration) const;
    // The rotation at the end of a path that leads from one to another, at that spin, in so many seconds; none, if that
    // is more than half a turn: the two do not tell how. Of what is round about an axis without its turn about that.
    std::optional<math::DQuat> end_of_turn(std::int32_t body, math::DQuat from, math::DQuat to, math::DVec3 w,
                                           double duration) const;
    double longest_part(std::int32_t body, math::DVec3 w, math::DQuat q) const;
    double longest_chord(const Mover& m) const;
    double offset_of_velocity() const;
    int substeps_in(double duration) const;
    void lead_by_joints(Mover& m, const CountedPose& from, const BodyMotion& to) const;
    void fly(const Mover& m, const MovingState& from, double duration) const;
    void keep_in_range(std::int32_t body, const MovingState& from, double duration) const;
    void push_end(std::int32_t body, const MovingState& now, double left, math::DVec3 dv, math::DVec3 dw) const;
    void lead_to_end(Mover& m, const MovingState& now, double time, double until) const;
    void put_back(std::int32_t i);

    const MoverContext s;
    const float dt_;
    std::vector<std::int32_t>& place_;
    std::vector<Mover>& movers_;
};

} // namespace cairn
