// From the scene library's types to the viewer's: neither knows of the other.
#pragma once

#include "scene/scene.h"
#include "viewer/scene_source.h"

namespace cairn::cli {

std::vector<viewer::Appearance> appearances_of(const scene::Scene& scene);

// The scene's own view, or one that shows all of it.
viewer::CameraPose camera_of(const scene::Scene& scene);

// Extensions of the files that `load_for_viewer` reads.
std::vector<std::string> viewer_file_types();

viewer::LoadedScene load_for_viewer(const std::string& path);

} // namespace cairn::cli
