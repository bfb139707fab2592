#include "cli/activity.h"
#include "cli/commands.h"
#include "cli/outputs.h"
#include "cli/viewer_scene.h"

#include "viewer/new_files.h"
#include "viewer/window.h"

#include <filesystem>
#include <system_error>
#include <vector>

namespace cairn::cli {

int view_command(const ViewOptions& options) {
    check_outputs(std::vector<Output>{{"--report", options.report}});
    viewer::ViewerOptions window;
    // Resolved here, so that a wrong name gives an error message on the terminal rather than an empty window.
    window.scene = scene::find_scene(options.scene.empty() ? "welcome" : options.scene).string();
    for (const scene::SceneEntry& entry : scene::list_scenes(scene::scenes_directory())) {
        if (!entry.error.empty()) continue;
        window.scenes.push_back({entry.path.string(), entry.title});
        // Normalizes the path, because the list recognizes the open scene by its path.
        std::error_code ignored;
        if (std::filesystem::equivalent(entry.path, window.scene, ignored)) window.scene = entry.path.string();
    }
    // The options apply only to the first scene, not to others from the list or dropped on the window.
    window.loader = [&](const std::string& path) {
        return load_for_viewer(path, path == window.scene ? options.read : ReadOptions{});
    };
    window.savers = {save_recording, save_scene};
    window.svg_of_chart = svg_of_chart;
    window.file_types = viewer_file_types();
    window.docs = scene::scenes_directory().parent_path() / "docs"; // both in the installation and in the source tree
    window.width = options.width;
    window.height = options.height;
    window.exit_after = options.exit_after;
    window.report = options.report;
    window.script = options.script;
    window.layout = viewer::layout_file();
    set_activity("showing", window.scene);
    return viewer::run_viewer(window);
}

} // namespace cairn::cli
