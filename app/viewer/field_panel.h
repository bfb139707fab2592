/// \file field_panel.h
/// The part of the panel that lists the force fields of a scene, and changes them.
#pragma once

#include "viewer/controller.h"

namespace cairn::viewer {

class FieldPanel {
  public:
    /// To be called inside the panel's window.
    void draw(const StageState& state, Controller& controller);

  private:
    bool draw_field(Controller& controller, std::size_t index, bool& is_removed);

    std::vector<std::pair<ForceFieldId, ForceField>> fields_; // follow the world while none is being edited
};

} // namespace cairn::viewer
