#include "viewer/command_list.h"

#include <algorithm>
#include <cctype>
#include <optional>
#include <utility>

namespace cairn::viewer {

namespace {

struct ActionName {
    Action action;
    const char* name;
};

// Without actions that last as long as a key is held, and camera movements that repeat with a key.
constexpr ActionName names[] = {
    {Action::toggle_pause, "pause or resume"},
    {Action::single_step, "one step"},
    {Action::step_back, "one step back"},
    {Action::play_backwards, "run time backwards"},
    {Action::slower, "slower"},
    {Action::faster, "faster"},
    {Action::undo, "undo"},
    {Action::redo, "redo"},
    {Action::branch_off, "branch off: keep this run beside a new one"},
    {Action::exchange_runs, "exchange the two runs"},
    {Action::end_other_run, "end the other run"},
    {Action::reset_scene, "restart the scene"},
    {Action::next_scene, "next scene"},
    {Action::previous_scene, "previous scene"},
    {Action::add_box, "add a box"},
    {Action::add_large_sphere, "add a large sphere"},
    {Action::add_small_sphere, "add a small sphere"},
    {Action::add_capsule, "add a capsule"},
    {Action::add_cylinder, "add a cylinder"},
    {Action::add_cone, "add a cone"},
    {Action::add_polyhedron, "add a polyhedron"},
    {Action::remove_last, "remove the last body"},
    {Action::remove_selected, "remove the selection"},
    {Action::duplicate, "duplicate the selection"},
    {Action::group, "group the selected bodies"},
    {Action::ungroup, "ungroup the selected bodies"},
    {Action::next_gizmo, "handles: move, rotate, scale the selection"},
    {Action::select_nothing, "select nothing"},
    {Action::remove_joint, "remove the selected joint"},
    {Action::frame_selection, "look at the selected body"},
    {Action::follow_selection, "follow the selected body"},
    {Action::reset_camera, "the scene's initial view"},
    {Action::view_front, "view from the front"},
    {Action::view_side, "view from the side"},
    {Action::view_top, "view from the top"},
    {Action::toggle_parallel, "orthographic projection"},
    {Action::next_colors, "next colors"},
    {Action::toggle_grid, "show or hide the grid"},
    {Action::toggle_shadows, "show or hide shadows"},
    {Action::toggle_visuals, "visual meshes or collision shapes"},
    {Action::toggle_joints, "joints: loaded, all, none"},
    {Action::toggle_panel, "show or hide the panel"},
    {Action::toggle_help, "keys and mouse"},
    {Action::toggle_plots, "plots of energy, momentum and bodies"},
    {Action::toggle_integrators, "integrators side by side"},
    {Action::toggle_impacts, "impact of the selected body: formula and slow motion"},
    {Action::toggle_panes, "panes: the same scene with other settings side by side"},
    {Action::toggle_theme, "dark or light theme"},
    {Action::save_scene, "save the scene as glTF"},
    {Action::save_recording, "save the last 30 seconds as a recording"},
    {Action::screenshot, "save a picture (screenshot)"},
    {Action::record_video, "start or end a video"},
    {Action::quit, "quit"},
};

char lower(char letter) { return char(std::tolower(static_cast<unsigned char>(letter))); }

std::string lower(std::string_view text) {
    std::string result(text);
    std::transform(result.begin(), result.end(), result.begin(), [](char letter) { return lower(letter); });
    return result;
}

// Match quality, lower is better; empty if there is no match.
std::optional<std::size_t> rank(const std::string& name, const std::string& query) {
    const std::size_t found = name.find(query);
    if (found != std::string::npos) return found == 0 || name[found - 1] == ' ' ? found : 100 + found;
    std::size_t place = 0, gaps = 0;
    for (const char letter : query) {
        const std::size_t next = name.find(letter, place);
        if (next == std::string::npos) return std::nullopt;
        gaps += next - place;
        place = next + 1;
    }
    return 1000 + gaps;
}

} // namespace

std::vector<NamedCommand> all_commands(const Controller& controller) {
    std::vector<NamedCommand> commands;
    for (const auto& [action, name] : names) {
        std::string keys;
        for (const Binding& binding : key_bindings())
            if (binding.action == action) keys += (keys.empty() ? "" : ", ") + std::string(binding.chord);
        commands.push_back({name, keys, [binding = Binding{"", action, 0}](Controller& c) { c.perform(binding); }});
    }
    for (int i = 0; i < color_mode_count; ++i)
        commands.push_back({std::string("colors: ") + name_of(ColorMode(i)), "",
                            [mode = ColorMode(i)](Controller& c) { c.set_colors(mode); }});
    for (const SolverPart& part : solver_parts())
        commands.push_back({std::string("show or hide ") + part.name, part.shown == &SolverShown::contacts ? "F5" : "",
                            [shown = part.shown](Controller& c) {
                                SolverShown changed = c.solver;
                                changed.*shown = !(changed.*shown);
                                c.show_solver(changed);
                            }});
    for (std::size_t i = 0; i < controller.scenes().size(); ++i)
        commands.push_back({"scene: " + controller.scenes()[i].title, i < 9 ? std::to_string(i + 1) : std::string(),
                            [i](Controller& c) { c.choose_scene(i); }});
    return commands;
}

std::vector<std::size_t> matching(std::span<const NamedCommand> commands, std::string_view query) {
    std::vector<std::pair<std::size_t, std::size_t>> ranked; // rank and index
    for (std::size_t i = 0; i < commands.size(); ++i)
        if (const auto place = rank(lower(commands[i].name), lower(query))) ranked.emplace_back(*place, i);
    std::stable_sort(ranked.begin(), ranked.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<std::size_t> indices;
    for (const auto& [place, index] : ranked) indices.push_back(index);
    return indices;
}

} // namespace cairn::viewer
