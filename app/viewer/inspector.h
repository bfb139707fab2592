/// \file inspector.h
/// All about the selected body, to be read and changed while it runs.
#pragma once

#include "viewer/controller.h"

#include <array>

namespace cairn::viewer {

class Inspector {
  public:
    /// To be called between ImGui's NewFrame and Render. `top`: where the picture's title ends; `room`: the picture's
    /// width.
    void draw(const StageState& state, Controller& controller, float scale, float top, float bottom, float room);

  private:
    void draw_identity(const BodyFacts& facts, Controller& controller);
    void draw_motion(const BodyFacts& facts, Controller& controller);
    void draw_surface(const BodyFacts& facts, Controller& controller);
    void draw_buttons(Controller& controller);
    void draw_selection_buttons(Controller& controller);
    void draw_several(const StageState& state, Controller& controller);
    void draw_touches(const BodyFacts& facts, Controller& controller);

    BodyFacts edited_; // follows the body while nothing is being edited
    std::array<char, 64> name_{};
};

} // namespace cairn::viewer
