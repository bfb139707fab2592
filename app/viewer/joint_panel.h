/// \file joint_panel.h
/// The part of the panel that lists joints and edits the selected one.
#pragma once

#include "viewer/controller.h"

namespace cairn::viewer {

class JointPanel {
  public:
    /// Inside the panel's window. Nothing for worlds without joints.
    void draw(const StageState& state, Controller& controller);

  private:
    void draw_list(const StageState& state, Controller& controller);
    void draw_facts(const StageState& state, const JointLayout& joint, const JointState& now);
    void draw_strength(Controller& controller);

    JointId edited_id_; // of the joint that `edited_` is a copy of
    JointDef edited_;   // follows the world while nothing is being edited
};

} // namespace cairn::viewer
