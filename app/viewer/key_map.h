/// \file key_map.h
/// The key bindings. One table serves the keyboard, scripts, and the help window.
#pragma once

#include <optional>
#include <span>
#include <string_view>

namespace cairn::viewer {

enum class Action {
    choose_scene, // argument: 0 for the first
    next_scene,
    previous_scene,
    reset_scene,
    add_box,
    add_large_sphere,
    add_small_sphere,
    add_capsule,
    add_cylinder,
    add_cone,
    add_polyhedron,
    shoot,
    remove_last,
    remove_selected,
    select_nothing,
    join_by_ball,
    join_by_hinge,
    join_fixed,
    remove_joint,
    force_x,
    force_y,
    force_z, // while held; argument: sign
    pull_to_center,
    freeze, // while held
    toggle_pause,
    single_step,
    step_back,
    play_backwards,
    undo,
    redo,
    branch_off,
    exchange_runs,
    end_other_run,
    save_recording,
    slower,
    faster,
    frame_selection,
    follow_selection,
    view_front,
    view_side,
    view_top,
    toggle_parallel,
    reset_camera,
    orbit_left,
    orbit_right,
    orbit_up,
    orbit_down,
    zoom_in,
    zoom_out,
    next_colors,
    toggle_grid,
    toggle_shadows,
    toggle_visuals,
    toggle_joints,
    toggle_panel,
    toggle_help,
    toggle_palette,
    toggle_theme,
    record_video,
    toggle_contacts,
    duplicate,
    group,
    ungroup,
    next_gizmo,
    save_scene,
    toggle_plots,
    toggle_integrators,
    toggle_panes,
    toggle_impacts,
    screenshot,
    quit,
};

/// `chord` is the key's name after its modifiers in the order Ctrl, Alt, Shift: `U`, `KP4`, `Shift+Backspace`.
struct Binding {
    std::string_view chord;
    Action action;
    int argument = 0;
};

/// All bindings.
std::span<const Binding> key_bindings();
/// The binding of a chord, if any.
std::optional<Binding> find_binding(std::string_view chord);
/// Whether the action lasts as long as its key is down.
bool is_held(Action action);
/// Whether the action repeats while its key is held.
bool repeats(Action action);

/// A line of the help window: the keys in readable form, and their action. An empty `keys` makes a heading.
struct KeyHelp {
    const char* keys;
    const char* meaning;
    std::string_view chords = {}; ///< The explained bindings, separated by spaces; empty: mouse actions.
};
std::span<const KeyHelp> key_help();

} // namespace cairn::viewer
