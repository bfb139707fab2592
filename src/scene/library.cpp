// The library of scenes: finding its folder, listing it, and finding one scene in it.
#include "scene/document.h"
#include "scene/gltf_file.h"
#include "scene/node_graph.h"
#include "scene/scene.h"
#include "scene/world_settings.h"

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <system_error>

namespace cairn::scene {

namespace {

namespace fs = std::filesystem;

// Counts the bodies at a node and below it, by the same rules as when the world is built.
std::size_t count_bodies(const Value& nodes, const NodeGraph& graph, std::size_t index, bool in_body,
                         std::size_t depth) {
    const Value node = nodes[index];
    if (depth > max_node_depth)
        node.fail("must be at most " + std::to_string(max_node_depth) + " nodes below its root");
    const auto physics = extension(node, "KHR_physics_rigid_bodies");
    const bool has_motion = physics && physics->find("motion");
    const auto trigger = physics ? physics->find("trigger") : std::nullopt;
    const bool is_marked = extension(node, "CAIRN_body") || (trigger && trigger->find("nodes"));
    const bool begins_body = has_motion || (!in_body && is_marked);
    const bool lone_collider = !begins_body && !in_body && physics && (physics->find("collider") || trigger);
    std::size_t bodies = begins_body || lone_collider ? 1 : 0;
    for (const std::size_t child : graph.children[index]) {
        bodies += count_bodies(nodes, graph, child, in_body || begins_body, depth + 1);
    }
    return bodies;
}

SceneEntry read_entry(const fs::path& path) {
    SceneEntry entry;
    entry.path = path;
    entry.name = path.stem().generic_string();
    try {
        const std::string file = path.filename().generic_string();
        const std::vector<std::byte> bytes = read_file(path);
        const GltfFile gltf = parse_gltf(bytes, file);
        const Value document(gltf.json, file);
        check_document(document);
        const auto scene = default_scene(document);
        SceneInfo info;
        if (const auto own = scene ? extension(*scene, "CAIRN_world") : std::nullopt) read_title(*own, info);
        entry.title = info.title;
        entry.hint = info.hint;
        const NodeGraph graph = read_node_graph(document, scene);
        for (const std::size_t root : graph.roots) {
            entry.bodies += count_bodies(document.require("nodes"), graph, root, false, 0);
        }
    } catch (const Error& error) {
        entry.error = error.what();
    }
    return entry;
}

bool is_scene_file(const fs::path& path) { return path.extension() == ".gltf" || path.extension() == ".glb"; }

// "01_open_plane" -> "open_plane"
std::string without_number(const std::string& name) {
    const std::size_t digits = name.find_first_not_of("0123456789");
    if (digits == 0 || digits == std::string::npos || name[digits] != '_') return name;
    return name.substr(digits + 1);
}

// "01_open_plane" -> 1; nothing without a number. Numbers may have up to nine digits.
std::optional<int> number_of(const std::string& name) {
    const std::size_t digits = std::min(name.find_first_not_of("0123456789"), name.size());
    if (digits == 0 || digits > 9 || (digits < name.size() && name[digits] != '_')) return std::nullopt;
    return std::stoi(name.substr(0, digits));
}

// Returns the files that a name matches: by the whole name if any does, else by the name without its number, else by
// the number.
std::vector<fs::path> scenes_named(const std::string& name, const std::vector<fs::path>& files) {
    const bool is_number = name.find_first_not_of("0123456789") == std::string::npos;
    const auto matches = [&](int way, const std::string& file_name, const std::string& stem) {
        if (way == 0) return name == file_name || name == stem;
        if (way == 1) return name == without_number(file_name) || name == without_number(stem);
        return is_number && number_of(stem) && number_of(stem) == number_of(name);
    };
    std::vector<fs::path> found;
    for (int way = 0; way < 3 && found.empty(); ++way) {
        for (const fs::path& file : files) {
            if (matches(way, file.filename().generic_string(), file.stem().generic_string())) found.push_back(file);
        }
    }
    return found;
}

// Returns the folder of the running program; empty where the system does not tell it.
fs::path program_directory() {
    std::error_code code;
    const fs::path program = fs::read_symlink("/proc/self/exe", code);
    return code ? fs::path() : program.parent_path();
}

} // namespace

std::vector<fs::path> scene_files(const fs::path& directory) {
    std::vector<fs::path> files;
    std::error_code code;
    for (fs::directory_iterator entry(directory, code), end; !code && entry != end; entry.increment(code)) {
        if (is_scene_file(entry->path()) && !entry->is_directory(code)) files.push_back(entry->path());
        code.clear(); // error of a single entry: reading that file will report it
    }
    if (code) throw Error(ErrorCode::io, directory.generic_string(), {}, "cannot be listed: " + code.message());
    std::sort(files.begin(), files.end(), [](const fs::path& a, const fs::path& b) {
        return a.filename().generic_string() < b.filename().generic_string();
    });
    return files;
}

std::vector<SceneEntry> list_scenes(const fs::path& directory) {
    std::vector<SceneEntry> entries;
    for (const fs::path& file : scene_files(directory)) entries.push_back(read_entry(file));
    return entries;
}

fs::path scenes_directory() {
    if (const char* chosen = std::getenv("CAIRN_SCENES"); chosen != nullptr && *chosen != '\0') return chosen;
    std::error_code code;
    if (const fs::path program = program_directory(); !program.empty()) {
        const fs::path installed = program / ".." / "share" / "cairn" / "scenes";
        if (fs::is_directory(installed, code)) return installed.lexically_normal();
    }
    return CAIRN_SOURCE_SCENES;
}

namespace {

// Returns the scene of that name in the library; nothing if there is none.
std::optional<fs::path> named_scene(const std::string& name) {
    const fs::path directory = scenes_directory();
    std::error_code code;
    if (name.empty() || fs::path(name).has_parent_path() || !fs::is_directory(directory, code)) return std::nullopt;
    const std::vector<fs::path> found = scenes_named(name, scene_files(directory));
    if (found.empty()) return std::nullopt;
    if (found.size() == 1) return found[0];
    std::string candidates;
    for (const fs::path& file : found)
        candidates += (candidates.empty() ? "" : ", ") + file.filename().generic_string();
    throw Error(ErrorCode::invalid_value, name, {}, "may be any of " + candidates);
}

[[noreturn]] void fail_to_find(const std::string& name) {
    std::string problem = "there is no such file";
    if (!name.empty() && !fs::path(name).has_parent_path()) {
        problem += ", nor a scene of that name in " + scenes_directory().generic_string();
    }
    throw Error(ErrorCode::io, name.empty() ? "\"\"" : name, {}, problem);
}

} // namespace

fs::path find_named_scene(std::string_view name) {
    if (const std::optional<fs::path> found = named_scene(std::string(name))) return *found;
    fail_to_find(std::string(name));
}

fs::path find_scene(std::string_view path_or_name) {
    const fs::path path(path_or_name);
    std::error_code code;
    const fs::file_status status = fs::status(path, code);
    if (fs::exists(status) && !fs::is_directory(status)) return path;
    if (const std::optional<fs::path> found = named_scene(std::string(path_or_name))) return *found;
    if (fs::exists(status)) return path; // a folder: the error is reported when it is read
    fail_to_find(std::string(path_or_name));
}

} // namespace cairn::scene
