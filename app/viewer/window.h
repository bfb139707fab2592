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
    std::string scene;                             ///< Path of the scene to open, as `loader` expects it.
    std::vector<SceneItem> scenes;                 ///< Scene list of the panel; the keys 1 to 9 open the first nine.
    SceneLoader loader;                            ///< Required.
    Savers savers;                                 ///< Writers of recordings and scenes.
    SvgOfChart svg_of_chart;                       ///< For exporting plots.
    std::vector<std::string> file_types;           ///< Extensions of the files that `loader` reads: `.gltf` and so on.
    int width = 1280, height = 720;                ///< Window size, in screen coordinates.
    std::filesystem::path screenshot_folder = "."; ///< Folder for pictures (F12) and recordings (F9).
    std::filesystem::path docs;                    ///< Folder of the pages that links open; empty: none.
    std::optional<double> exit_after;              ///< Seconds after which the window closes by itself.
    std::filesystem::path layout;                  ///< File that stores window positions across sessions; empty: none.
    std::filesystem::path report;                  ///< Write the viewer's state here as JSON on exit; empty: do not.
    std::filesystem::path script;                  ///< Play these inputs (see script.h); empty: do not.
};

/// Opens the window and runs until it is closed; returns the exit code of the program: 0, or 1 after an error, which
/// has been printed to stderr in one line (no display, no OpenGL 3.3, the first scene cannot be loaded, the report
/// cannot be written, the script cannot be read).
int run_viewer(const ViewerOptions& options);

} // namespace cairn::viewer
