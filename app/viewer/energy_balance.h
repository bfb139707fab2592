/// \file energy_balance.h
/// Where the energy of a world goes: to friction, into impacts, and what comes from outside.
///
/// The work of a force over a step is its impulse times the mean of the velocities before and after, which is exact for
/// whatever acts evenly. So friction, joints and fields are taken from their own impulses. What else the bodies that
/// touch something lose in a step is counted as lost in impacts: an impact lies somewhere within its step, so the mean
/// velocity tells nothing of it.
#pragma once

#include <cairn/world.h>

#include <cstdint>
#include <vector>

namespace cairn::viewer {

/// J, of one step or summed up over many.
struct EnergyFlow {
    double friction = 0.0; ///< Lost where surfaces slide on each other.
    double impacts = 0.0;  ///< Lost by bodies that touch something, but for friction.
    double brought_in =
        0.0; ///< By joints, force fields, damping, moving scenery, and changes between steps; may be < 0.
};

class EnergyBalance {
  public:
    /// To be called right before each step.
    void before_step(const World& world);
    /// Right after it: its flow. `previous`: the total energy after the step before, J.
    EnergyFlow after_step(const World& world, double step_length, double previous) const;

  private:
    struct Before {
        BodyId id;
        Vec3 velocity{0.0f, 0.0f, 0.0f}, turning{0.0f, 0.0f, 0.0f}; // m/s, rad/s
        double energy = 0.0;                                        // J
    };
    struct Work;
    const Before* known(BodyId body) const;
    glm::dvec3 mean_turning(const World& world, BodyId body) const;
    glm::dvec3 mean_velocity(const World& world, BodyId body, const Position& point) const;
    void add_contact(const World& world, const Contact& contact, std::vector<Work>& works, EnergyFlow& flow) const;
    void add_joint(const World& world, JointId joint, double step_length, std::vector<Work>& works,
                   EnergyFlow& flow) const;

    std::vector<Before> bodies_; // by the index of their slots
    double energy_ = 0.0;        // J, of all
};

} // namespace cairn::viewer
