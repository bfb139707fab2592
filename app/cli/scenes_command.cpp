#include "cli/activity.h"
#include "cli/commands.h"
#include "cli/outputs.h"

#include "scene/scene.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace cairn::cli {

int scenes_command(const ScenesOptions& options) {
    const std::filesystem::path folder = options.folder.empty() ? scene::scenes_directory() : options.folder;
    set_activity("listing", folder.generic_string());
    if (options.names) {
        std::string names;
        for (const std::filesystem::path& file : scene::scene_files(folder)) names += file.stem().string() + "\n";
        print(names);
        return 0;
    }
    const std::vector<scene::SceneEntry> entries = scene::list_scenes(folder);
    if (options.json) {
        nlohmann::ordered_json list = nlohmann::ordered_json::array();
        for (const scene::SceneEntry& entry : entries) {
            nlohmann::ordered_json item{{"name", entry.name},
                                        {"path", entry.path.generic_string()},
                                        {"title", entry.title},
                                        {"hint", entry.hint},
                                        {"bodies", entry.bodies}};
            if (!entry.error.empty()) item["error"] = entry.error;
            list.push_back(std::move(item));
        }
        // File names may contain invalid UTF-8, which is replaced.
        print(list.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n");
        return 0;
    }
    if (entries.empty()) print(fmt::format("no scenes in {}\n", folder.generic_string()));
    std::size_t widest = 0;
    for (const scene::SceneEntry& entry : entries) widest = std::max(widest, entry.name.size());
    for (const scene::SceneEntry& entry : entries) {
        if (!entry.error.empty()) {
            print(fmt::format("{:<{}}  unusable: {}\n", entry.name, widest, entry.error));
            continue;
        }
        print(fmt::format("{:<{}}  {:>5} bodies  {}. {}\n", entry.name, widest, entry.bodies, entry.title, entry.hint));
    }
    return 0;
}

} // namespace cairn::cli
