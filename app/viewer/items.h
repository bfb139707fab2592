/// \file items.h
/// Parts of the interface that several of its windows have, made with Dear ImGui.
#pragma once

#include "viewer/controller.h"

#include <string>
#include <utility>
#include <vector>

namespace cairn::viewer {

/// Notes where the item that was drawn last is, under that name (`Controller::places`).
void note_place(Controller& controller, const char* name);

/// Buttons that export charts: a picture of each, and a table of each. `prefix` names their places.
void draw_export_buttons(Controller& controller, const std::string& prefix,
                         const std::vector<std::pair<std::string, const Chart*>>& charts);

/// To be called in a window that people move: it stays right of the panel's column and above so much at the bottom, as
/// far as it fits. Its place may be of a window of another size, a moment ago or in an earlier run.
void keep_in_picture(float column, float bottom);

/// A paragraph in a calmer color.
void explain(const char* text);

/// As the interface has it, of a linear color.
unsigned display_color(const Vec3& linear);
/// A patch of a color, and what it means.
void draw_swatch(const Vec3& color, const char* meaning);

/// A word that can be clicked, and what that does; whether it was.
bool draw_link(const char* text, const char* meaning);

} // namespace cairn::viewer
