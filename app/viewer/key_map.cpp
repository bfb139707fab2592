#include "viewer/key_map.h"

#include <algorithm>
#include <array>

namespace cairn::viewer {

namespace {

constexpr Binding bindings[] = {
    {"1", Action::choose_scene, 0},
    {"2", Action::choose_scene, 1},
    {"3", Action::choose_scene, 2},
    {"4", Action::choose_scene, 3},
    {"5", Action::choose_scene, 4},
    {"6", Action::choose_scene, 5},
    {"7", Action::choose_scene, 6},
    {"8", Action::choose_scene, 7},
    {"9", Action::choose_scene, 8},
    {"PageDown", Action::next_scene},
    {"PageUp", Action::previous_scene},
    {"Delete", Action::reset_scene},
    {"U", Action::add_box},
    {"I", Action::add_large_sphere},
    {"O", Action::add_small_sphere},
    {"J", Action::add_capsule},
    {"K", Action::add_cylinder},
    {"L", Action::add_cone},
    {"M", Action::add_polyhedron},
    {"P", Action::shoot},
    {"Backspace", Action::remove_last},
    {"Shift+Backspace", Action::remove_selected},
    {"R", Action::remove_selected},
    {"Escape", Action::select_nothing},
    {"B", Action::join_by_ball},
    {"Y", Action::join_by_hinge},
    {"W", Action::join_fixed},
    {"D", Action::remove_joint},
    {"KP4", Action::force_x, -1},
    {"KP6", Action::force_x, 1},
    {"KP7", Action::force_y, -1},
    {"KP9", Action::force_y, 1},
    {"KP8", Action::force_z, -1},
    {"KP2", Action::force_z, 1},
    {"Shift+Left", Action::force_x, -1},
    {"Shift+Right", Action::force_x, 1},
    {"Shift+PageDown", Action::force_y, -1},
    {"Shift+PageUp", Action::force_y, 1},
    {"Shift+Up", Action::force_z, -1},
    {"Shift+Down", Action::force_z, 1},
    {"C", Action::pull_to_center},
    {"X", Action::freeze},
    {"Space", Action::toggle_pause},
    {".", Action::single_step},
    {",", Action::step_back},
    {"Shift+Space", Action::play_backwards},
    {"Ctrl+Z", Action::undo},
    {"Ctrl+Shift+Z", Action::redo},
    {"Ctrl+B", Action::branch_off},
    {"Ctrl+Shift+B", Action::exchange_runs},
    {"Shift+B", Action::end_other_run},
    {"F9", Action::save_recording},
    {"[", Action::slower},
    {"]", Action::faster},
    {"F", Action::frame_selection},
    {"Home", Action::reset_camera},
    {"E", Action::follow_selection},
    {"Ctrl+1", Action::view_front},
    {"Ctrl+2", Action::view_side},
    {"Ctrl+3", Action::view_top},
    {"Ctrl+5", Action::toggle_parallel},
    {"Ctrl+P", Action::toggle_palette},
    {"Ctrl+T", Action::toggle_theme},
    {"F10", Action::record_video},
    {"Left", Action::orbit_left},
    {"Right", Action::orbit_right},
    {"Up", Action::orbit_up},
    {"Down", Action::orbit_down},
    {"=", Action::zoom_in},
    {"Shift+=", Action::zoom_in},
    {"KPAdd", Action::zoom_in},
    {"-", Action::zoom_out},
    {"KPSubtract", Action::zoom_out},
    {"Tab", Action::next_colors},
    {"N", Action::next_colors},
    {"G", Action::toggle_grid},
    {"H", Action::toggle_shadows},
    {"V", Action::toggle_visuals},
    {"T", Action::toggle_joints},
    {"F2", Action::toggle_panel},
    {"F1", Action::toggle_help},
    {"F3", Action::toggle_plots},
    {"F5", Action::toggle_contacts},
    {"Ctrl+D", Action::duplicate},
    {"Ctrl+G", Action::group},
    {"Ctrl+Shift+G", Action::ungroup},
    {"Q", Action::next_gizmo},
    {"Ctrl+S", Action::save_scene},
    {"F4", Action::toggle_integrators},
    {"F6", Action::toggle_panes},
    {"F7", Action::toggle_impacts},
    {"F12", Action::screenshot},
    {"Ctrl+Q", Action::quit},
};

constexpr KeyHelp help[] = {
    {"", "Scene"},
    {"1 ... 9", "choose a scene", "1 2 3 4 5 6 7 8 9"},
    {"Page up / down", "previous / next scene", "PageUp PageDown"},
    {"Delete", "reset the scene", "Delete"},
    {"Drop a file on the window", "open it"},
    {"", "Bodies"},
    {"U  I  O", "add a box / large sphere / small sphere", "U I O"},
    {"J  K  L  M", "add a capsule / cylinder / cone / polyhedron", "J K L M"},
    {"P", "shoot a box at the cursor, or what the spawn tool is set to", "P"},
    {"Backspace", "remove the last body", "Backspace"},
    {"Shift+click", "select one more body, or one less"},
    {"Shift+drag beside bodies", "select what lies in a frame as well"},
    {"Ctrl+G, Ctrl+Shift+G", "group what is selected / end the group", "Ctrl+G Ctrl+Shift+G"},
    {"R  or  Shift+Backspace", "remove what is selected", "R Shift+Backspace"},
    {"Ctrl+D", "duplicate what is selected", "Ctrl+D"},
    {"Q", "handles to move / turn / scale what is selected", "Q"},
    {"Left drag on a body", "pull it   (Shift: up and down, Ctrl: level)"},
    {"", "Joints"},
    {"B  Y  W", "ball / hinge / fixed joint at the cursor", "B Y W"},
    {" ", "to the selected body, or to the world"},
    {"Click on an anchor", "select the joint"},
    {"D", "remove the selected joint", "D"},
    {"", "Forces, while held"},
    {"Keypad 4 6, 7 9, 8 2", "left right, down up, away near", "KP4 KP6 KP7 KP9 KP8 KP2"},
    {"Shift + arrows, Page up / down", "the same without a keypad",
     "Shift+Left Shift+Right Shift+PageDown Shift+PageUp Shift+Up Shift+Down"},
    {"C", "pull everything to the center", "C"},
    {"X", "freeze everything", "X"},
    {"", "Time"},
    {"Space", "pause", "Space"},
    {".  ,", "one step / one step back", ". ,"},
    {"Shift+Space", "let time run backwards", "Shift+Space"},
    {"Drag on the bar below", "go to any moment"},
    {"Ctrl+Z, Ctrl+Shift+Z", "undo / redo a change", "Ctrl+Z Ctrl+Shift+Z"},
    {"Ctrl+B", "branch off: this run anew, as it was beside it", "Ctrl+B"},
    {"Ctrl+Shift+B / Shift+B", "exchange the two runs / end the other", "Ctrl+Shift+B Shift+B"},
    {"F9", "save the last 30 seconds as a recording", "F9"},
    {"[  ]", "slower / faster, 1/32 to 8 times", "[ ]"},
    {"", "View"},
    {"Drag beside bodies, right drag, arrows", "orbit", "Left Right Up Down"},
    {"Wheel, + -", "zoom", "= Shift+= KPAdd - KPSubtract"},
    {"Middle drag", "move sideways"},
    {"F / Home", "look at the selected body / the scene's own view", "F Home"},
    {"E", "follow the selected body", "E"},
    {"Ctrl+1, Ctrl+2, Ctrl+3", "from the front / the side / the top", "Ctrl+1 Ctrl+2 Ctrl+3"},
    {"Ctrl+5", "parallel rays (orthographic), to compare lengths", "Ctrl+5"},
    {"Tab or N", "colors: scene, mass, speed, islands, shape", "Tab N"},
    {"G  H", "grid / shadows", "G H"},
    {"T", "joints: selected or loaded, all, none", "T"},
    {"V", "the file's own meshes / what collides", "V"},
    {"", "Window"},
    {"Ctrl+P", "find any command by its name", "Ctrl+P"},
    {"Ctrl+T", "dark / light", "Ctrl+T"},
    {"F1  F2", "this key map / the panel", "F1 F2"},
    {"F3  F4", "plots of this run / integrators side by side", "F3 F4"},
    {"F5", "contacts and their forces", "F5"},
    {"F6", "the same scene with other settings, side by side", "F6"},
    {"F7", "the last impact of the selected body, with its formula", "F7"},
    {"Ctrl+S", "save the scene as it stands, as glTF", "Ctrl+S"},
    {"F12  F10", "save a picture / start or end a video", "F12 F10"},
    {"Escape / Ctrl+Q", "select nothing / quit", "Escape Ctrl+Q"},
};

} // namespace

std::span<const Binding> key_bindings() { return bindings; }

std::optional<Binding> find_binding(std::string_view chord) {
    const auto found = std::find_if(std::begin(bindings), std::end(bindings),
                                    [chord](const Binding& binding) { return binding.chord == chord; });
    if (found == std::end(bindings)) return std::nullopt;
    return *found;
}

bool is_held(Action action) {
    return action == Action::force_x || action == Action::force_y || action == Action::force_z ||
           action == Action::pull_to_center || action == Action::freeze;
}

bool repeats(Action action) {
    constexpr std::array repeated{Action::orbit_left, Action::orbit_right, Action::orbit_up,    Action::orbit_down,
                                  Action::zoom_in,    Action::zoom_out,    Action::single_step, Action::step_back};
    return std::find(repeated.begin(), repeated.end(), action) != repeated.end();
}

std::span<const KeyHelp> key_help() { return help; }

} // namespace cairn::viewer
