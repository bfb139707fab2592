// From the scene library's types to the viewer's: neither knows of the other.
#pragma once

#include "scene/scene.h"
#include "viewer/scene_source.h"

namespace cairn::cli {

std::vector<viewer::Appearance> appearances_of(const scene::Scene& scene);

// The scene's own view, or one that shows all of it.
viewer::CameraPose camera_of(const scene::Scene& scene);

viewer::LoadedScene load_for_viewer(const std::string& path);

} // namespace cairn::cli
