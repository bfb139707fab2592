// Converts the scene library's types to the viewer's: the two libraries are independent.
#pragma once

#include "cli/commands.h"
#include "scene/scene.h"
#include "viewer/chart.h"
#include "viewer/scene_source.h"

#include <filesystem>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace cairn::cli {

std::vector<viewer::Appearance> appearances_of(const scene::Scene& scene);

// The visual meshes of the scene; those with the same triangles share one mesh.
std::vector<viewer::Visual> visuals_of(const scene::Scene& scene);

std::vector<viewer::JointAppearance> strings_of(const scene::Scene& scene);

std::vector<viewer::Light> lights_of(const scene::Scene& scene);

// The scene's own camera, or one that shows the whole scene.
viewer::CameraPose camera_of(const scene::Scene& scene, std::span<const viewer::Visual> visuals);

// Extensions of the files that `load_for_viewer` reads.
std::vector<std::string> viewer_file_types();

// See `viewer::Savers`.
void save_recording(const std::filesystem::path& path, const viewer::RecordingLooks& looks, World& world,
                    const std::function<void()>& run);

// Name of the note in recordings that stores the scene's appearance (`Recorder::note`).
inline constexpr const char* looks_note = "cairn.looks";
std::map<std::string, std::string> note_of(const viewer::RecordingLooks& looks, const World& world);

void save_scene(const std::filesystem::path& path, viewer::LoadedScene& saved);

// A chart of the viewer as an SVG picture.
std::string svg_of_chart(const viewer::Chart& chart);

viewer::LoadedScene load_for_viewer(const std::string& path, const ReadOptions& options);

} // namespace cairn::cli
