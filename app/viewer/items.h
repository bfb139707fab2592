/// \file items.h
/// Interface elements that several windows share, made with Dear ImGui.
#pragma once

#include "viewer/controller.h"

#include <string>
#include <utility>
#include <vector>

namespace cairn::viewer {

/// Records the position of the last drawn item under that name (`Controller::places`).
void note_place(Controller& controller, const char* name);

/// Buttons that export charts: each chart as a picture and as a table. `prefix` names their places.
void draw_export_buttons(Controller& controller, const std::string& prefix,
                         const std::vector<std::pair<std::string, const Chart*>>& charts);

/// To be called in a movable window: keeps it right of the panel's column and `bottom` above the lower edge, as far as
/// it fits. Its stored position may come from a main window of another size, now or in an earlier session.
void keep_in_picture(float column, float bottom);

/// A paragraph of explanation in a muted color.
void explain(const char* text);

/// Converts a linear color to the interface's format.
unsigned display_color(const Vec3& linear);
/// A color swatch with its meaning.
void draw_swatch(const Vec3& color, const char* meaning);

/// A clickable word with a tooltip `meaning`; returns whether it was clicked.
bool draw_link(const char* text, const char* meaning);

} // namespace cairn::viewer
