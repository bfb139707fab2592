/// \file field_panel.h
/// The part of the panel that lists and edits the force fields of a scene.
#pragma once

#include "viewer/controller.h"

namespace cairn::viewer {

class FieldPanel {
  public:
    /// To be called inside the panel's window.
    void draw(const StageState& state, Controller& controller);

  private:
    bool draw_field(Controller& controller, std::size_t index, bool& is_removed);

    std::vector<std::pair<ForceFieldId, ForceField>> fields_; // synchronized with the world while no widget is active
};

} // namespace cairn::viewer
