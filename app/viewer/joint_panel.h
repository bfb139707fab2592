/// \file joint_panel.h
/// The part of the panel that lists joints and edits the selected one.
#pragma once

#include "viewer/controller.h"

namespace cairn::viewer {

class JointPanel {
  public:
    /// The list, inside the panel's window. Nothing for worlds without joints.
    void draw(const StageState& state, Controller& controller);
    /// The window of the selected joint, at the right under `top` and over `bottom`; nothing if none is selected. Where
    /// it would reach the middle of the picture, which is `room` wide, or where there are several pictures, it lies
    /// over the lower part of the panel instead.
    void draw_selected(const StageState& state, Controller& controller, float scale, float top, float bottom,
                       float room);

  private:
    void draw_facts(const StageState& state, const JointLayout& joint, const JointState& now);
    void draw_strength(Controller& controller);

    JointId edited_id_; // of the joint that `edited_` is a copy of
    JointDef edited_;   // follows the world while nothing is being edited
};

} // namespace cairn::viewer
