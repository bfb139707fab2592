// Movers: bodies on their paths through a step, with pose and velocity at any time, which continue on new paths when an
// impact changes their velocities.
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

// State that movers read, and that they modify when they are redirected and written back: bodies, poses of their
// shapes, and the count of clamped speeds.
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
    void add(std::span<const std::int32_t> bodies, ThreadPool& thread_pool); // skips bodies that are movers already
    std::int32_t of_body(std::int32_t body) const { return place_[std::size_t(body)]; }
    Mover& operator[](std::int32_t i) { return movers_[std::size_t(i)]; }
    const Mover& operator[](std::int32_t i) const { return movers_[std::size_t(i)]; }
    std::int32_t count() const { return std::int32_t(movers_.size()); }

    MovingState state_at(std::int32_t i, double time) const;
    // Acceleration (m/s^2) of a free body by forces, and gyroscopic change of its spin (rad/s^2).
    void go_on_freely(std::int32_t i, const MovingState& now, math::DVec3& pull, math::DVec3& spin_change) const;
    // Vector from the center of mass of the shape's body to the shape's origin, m, at the rotation q of the body.
    math::DVec3 arm_of(std::uint32_t shape, math::DQuat q) const;
    // Splits the path of a free body that may meet something into chords that deviate from its parabola by less than
    // the depth of a core, from the start of the step on.
    void follow_parabola(std::int32_t i);
    // Continues with the pose and velocities of `now` at `time`, on a new path to the end of the step. The path of a
    // free body that rotates far covers only a part of its turn, and must be renewed at its end.
    void redirect(std::int32_t i, double time, const MovingState& now);
    // Adds `dv` and `dw` to the velocities along the rest of the path. `and_velocity`: also to the final velocities, as
    // for free bodies in any case; otherwise the body ends with the velocities that the solver gave it.
    void push_path(std::int32_t i, double time, math::DVec3 dv, math::DVec3 dw, bool and_velocity);
    // Lets a body go on at a constant velocity, m/s, to the end of the step, without turning. Its final velocities
    // stay, except for the speed that the forces do not give it on the new path. Returns whether it did so before.
    bool go_straight(std::int32_t i, double time, math::DVec3 velocity);
    // The mean velocity of the center of mass on the rest of the path, m/s.
    math::DVec3 mean_velocity(std::int32_t i, double time) const {
        const Mover& m = (*this)[i];
        if (!m.is_guided || !(time < 1)) return (1 / double(dt_)) * m.path.translation;
        return (1 / ((1 - time) * double(dt_))) * (s.bodies.motion[m.body].x - m.path.at(time).x);
    }
    // Lets a kinematic body carry this one along from `time` to the end of the step. After that, it slides on at its
    // relative speed from before, without the component along `axis` (of any length), the direction of approach.
    void carry(std::int32_t i, double time, std::int32_t carrier, math::DVec3 axis);
    // Starts the next part of the path of a guided body (Mover::is_guided).
    void advance_along_arc(std::int32_t i, double time);
    // Marks that the body rests on another one in the direction of the unit vector `down`: forces in this direction do
    // not accelerate it.
    void rest_on(std::int32_t i, math::DVec3 down);
    void stop(std::int32_t i, double time) { (*this)[i].until = time; }
    // Writes the poses of all redirected or stopped bodies at the end of the step. Returns how many were stopped.
    std::size_t write_final_poses();
    bool is_put_back(std::int32_t body) const { return of_body(body) != none && is_put_back((*this)[of_body(body)]); }

    // Path of a slow body, or one that forces do not move: from its pose at the start of the step to that at its end.
    RigidPath path_of(std::int32_t body) const;
    DBounds swept_bounds(const Mover& m, double from) const;

    // Whether the body is a ball about its center of mass, without joints: rotation does not move its surface.
    bool is_round(std::int32_t body) const;

  private:
    static bool is_put_back(const Mover& m) { return m.is_changed || m.has_stopped(); }
    std::int32_t append(std::int32_t body);
    void set_out(std::int32_t i);
    math::DVec3 acceleration_on(const RigidPath& path, std::int32_t body) const;
    // Called by several threads at once.
    void note_clamped(std::uint64_t times) const { __atomic_fetch_add(&s.clamped_speeds, times, __ATOMIC_RELAXED); }
    math::DVec3 spin_later(const Mover& m, math::DVec3 w, math::DQuat from, math::DQuat to, double duration) const;
    // The rotation at the end of a path between two rotations, for the spin w (rad/s) and a duration in seconds; none
    // if that is more than half a turn, as the two rotations do not determine it then. For a body with an axis of
    // symmetry, a fast rotation about this axis is left out instead.
    std::optional<math::DQuat> end_of_turn(std::int32_t body, math::DQuat from, math::DQuat to, math::DVec3 w,
                                           double duration) const;
    double longest_part(std::int32_t body, math::DVec3 w, math::DQuat q) const;
    double longest_chord(const Mover& m) const;
    double offset_of_velocity() const;
    int substeps_in(double duration) const;
    void follow_joint_screw(Mover& m, const CountedPose& from, const BodyMotion& to) const;
    void fly(const Mover& m, const MovingState& from, double duration) const;
    void keep_in_range(std::int32_t body, const MovingState& from, double duration) const;
    void push_end(std::int32_t body, const MovingState& now, double left, math::DVec3 dv, math::DVec3 dw) const;
    void lead_to_end(Mover& m, const MovingState& now, double time, double until) const;
    void write_final_poses(std::int32_t i);

    const MoverContext s;
    const float dt_;
    std::vector<std::int32_t>& place_;
    std::vector<Mover>& movers_;
};

} // namespace cairn
