/// \file integrator_window.h
/// Integrators compared with the exact solution: their motion, energy, and error.
#pragma once

#include "viewer/controller.h"
#include "viewer/integrators.h"

#include <array>
#include <optional>
#include <vector>

namespace cairn::viewer {

class IntegratorWindow {
  public:
    /// To be called between ImGui's NewFrame and Render. `column`: left edge of the view, which is `room` wide;
    /// `bottom`: height of the bar below it.
    void draw(Controller& controller, float scale, float column, float room, float bottom);

  private:
    void compute();
    void draw_controls(Controller& controller);
    void draw_motion(float width, float height) const;
    void draw_verdict() const;

    LabSystem system_ = LabSystem::spring;
    float rate_ = 60.0f; // steps per second
    bool is_running_ = true;
    double time_ = 0.0; // s
    std::optional<LabSystem> computed_system_;
    float computed_rate_ = 0.0f;
    std::array<std::vector<LabState>, lab_integrators.size()> paths_;
    Chart energies_, errors_;
};

} // namespace cairn::viewer
