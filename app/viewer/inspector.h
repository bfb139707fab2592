/// \file inspector.h
/// The inspector: data of the selected body, which can be edited while the simulation runs.
#pragma once

#include "viewer/controller.h"

#include <array>
#include <string>

namespace cairn::viewer {

class Inspector {
  public:
    /// To be called between ImGui's NewFrame and Render. `top`: lower edge of the view's title; `room`: the view's
    /// width.
    void draw(const StageState& state, Controller& controller, float scale, float top, float bottom, float room);
    /// The same in the lowest `height` of the panel's column, which has that `width`: used with several views, of which
    /// it would cover one.
    void draw_in_column(const StageState& state, Controller& controller, float width, float height);

  private:
    std::string follow(const StageState& state, Controller& controller);
    void draw_content(const StageState& state, Controller& controller, float width);
    void draw_identity(const BodyFacts& facts, Controller& controller);
    void draw_motion(const BodyFacts& facts, Controller& controller);
    void draw_surface(const BodyFacts& facts, Controller& controller);
    void draw_buttons(Controller& controller);
    void draw_selection_buttons(Controller& controller);
    void draw_several(const StageState& state, Controller& controller);
    void draw_touches(const BodyFacts& facts, Controller& controller);

    BodyFacts edited_; // synchronized with the body while no widget is active
    std::array<char, 64> name_{};
};

} // namespace cairn::viewer
