/// \file window.h
/// The interactive viewer.
#pragma once

#include "viewer/export.h"
#include "viewer/scene_source.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace cairn::viewer {

struct ViewerOptions {
    std::string scene;                             ///< Path of the scene to open, as `loader` takes it.
    std::vector<SceneItem> scenes;                 ///< The list in the panel; the first nine are on the keys 1 to 9.
    SceneLoader loader;                            ///< Required.
    Savers savers;                                 ///< Of recordings and scenes.
    SvgOfChart svg_of_chart;                       ///< For exporting plots.
    std::vector<std::string> file_types;           ///< Extensions of files that `loader` reads: `.gltf` and so on.
    int width = 1280, height = 720;                ///< Of the window, in screen coordinates.
    std::filesystem::path screenshot_folder = "."; ///< Where F12, F9 put pictures and recordings.
    std::filesystem::path docs;                    ///< Pages that links open; empty: there are none.
    std::optional<double> exit_after;              ///< Seconds after which the window closes by itself.
    std::filesystem::path layout; ///< Where the places of windows are kept from run to run; empty: they are not.
    std::filesystem::path report; ///< Write the viewer's state here as JSON on exit; empty: do not.
    std::filesystem::path script; ///< Play these inputs (see script.h); empty: do not.
};

/// Opens the window and runs until it is closed; returns the exit code of the program: 0, or 1 after an error, which
/// has been printed to stderr in one line (no display, no OpenGL 3.3, the first scene cannot be loaded, the report
/// cannot be written, a script that cannot be read).
int run_viewer(const ViewerOptions& options);

} // namespace cairn::viewer
