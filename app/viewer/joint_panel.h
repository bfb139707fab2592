/// \file joint_panel.h
/// The part of the panel that lists joints and edits the selected one.
#pragma once

#include "viewer/controller.h"

namespace cairn::viewer {

class JointPanel {
  public:
    /// Draws the list inside the panel's window; nothing for worlds without joints.
    void draw(const StageState& state, Controller& controller);
    /// Draws the window of the selected joint, at the right between `top` and `bottom`; nothing if none is selected.
    /// Where it would reach the middle of the view, which is `room` wide, or with several views, it covers the lower
    /// part of the panel instead.
    void draw_selected(const StageState& state, Controller& controller, float scale, float top, float bottom,
                       float room);

  private:
    void draw_facts(const StageState& state, const JointLayout& joint, const JointState& now);
    void draw_strength(Controller& controller);

    JointId edited_id_; // id of the joint that `edited_` copies
    JointDef edited_;   // synchronized with the world while no widget is active
};

} // namespace cairn::viewer
