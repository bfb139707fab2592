/// \file energy_balance.h
/// The energy balance of a world: losses to friction and in impacts, and energy from outside.
///
/// The work of a force over a step is its impulse times the mean of the velocities before and after, which is exact for
/// forces that are constant over the step. The work of friction, joints and force fields is thus computed from their
/// impulses. The remaining energy loss of touching bodies in a step is attributed to impacts, whose work cannot be
/// computed this way: an impact occurs at some time within its step, so that the mean velocity says nothing about it.
#pragma once

#include <cairn/world.h>

#include <cstdint>
#include <vector>

namespace cairn::viewer {

/// Energies in J, of one step or accumulated over many.
struct EnergyFlow {
    double friction = 0.0; ///< Loss by sliding friction.
    double impacts = 0.0;  ///< Loss of bodies that touch something, except by friction.
    /// Work of joints, force fields, damping, moving scenery, and changes between steps; may be < 0.
    double external_work = 0.0;
};

class EnergyBalance {
  public:
    /// To be called directly before each step.
    void before_step(const World& world);
    /// To be called directly after the step: returns its energy flow. `previous`: the total energy after the preceding
    /// step, J.
    EnergyFlow after_step(const World& world, double step_length, double previous) const;

  private:
    struct Before {
        BodyId id;
        Vec3 velocity{0.0f, 0.0f, 0.0f}, angular_velocity{0.0f, 0.0f, 0.0f}; // m/s, rad/s
        double energy = 0.0;                                                 // J
    };
    struct Work;
    const Before* known(BodyId body) const;
    glm::dvec3 mean_turning(const World& world, BodyId body) const;
    glm::dvec3 mean_velocity(const World& world, BodyId body, const Position& point) const;
    void add_contact(const World& world, const Contact& contact, std::vector<Work>& works, EnergyFlow& flow) const;
    void add_joint(const World& world, JointId joint, double step_length, std::vector<Work>& works,
                   EnergyFlow& flow) const;

    std::vector<Before> bodies_; // by slot index
    double energy_ = 0.0;        // J, of all bodies
};

} // namespace cairn::viewer
