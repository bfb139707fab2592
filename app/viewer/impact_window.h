/// \file impact_window.h
/// The window that shows an impact in slow motion, and the formula for its impulse with all numbers.
#pragma once

#include "viewer/controller.h"

namespace cairn::viewer {

class ImpactWindow {
  public:
    void draw(const StageState& state, Controller& controller, float scale, float column, float bottom);

  private:
    void ask(const StageState& state, Controller& controller);
    void draw_partner(const StageState& state, Controller& controller);

    bool was_open_ = false;
    BodyId body_, partner_; // the bodies of the requested impact; a null partner: any body
    std::uint64_t now_ = 0; // step number at the request
};

} // namespace cairn::viewer
