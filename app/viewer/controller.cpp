#include "viewer/controller.h"

#include "viewer/joint_drawing.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <utility>

namespace cairn::viewer {

namespace {

constexpr float orbit_per_picture = 3.5f; // radians for a drag over the height of the view
constexpr float click_slack = 0.01f;      // share of the view's height; a shorter movement is a click
constexpr float joint_slack = 0.02f;      // share of the view's height; a click this near an anchor hits the joint
constexpr float spawn_height = 0.3f;      // above the target, in camera distances

} // namespace

void Controller::choose_scene(std::size_t index) {
    if (index < scenes_.size()) post_(command::LoadScene{scenes_[index].path});
}

void Controller::set_colors(ColorMode mode) {
    colors = mode;
    post_(command::ShowIslands{mode == ColorMode::island});
}

void Controller::show_solver(const SolverShown& shown) {
    solver = shown;
    post_(command::ShowSolver{shown});
}

void Controller::change_scene(int by) {
    if (scenes_.empty()) return;
    const auto present = std::find_if(scenes_.begin(), scenes_.end(),
                                      [this](const SceneItem& item) { return item.path == scene_path_; });
    const int count = int(scenes_.size());
    const int index = present == scenes_.end() ? (by > 0 ? -1 : 0) : int(present - scenes_.begin());
    choose_scene(std::size_t((index + by + count) % count));
}

void Controller::key_down(std::string_view modifiers, std::string_view key, bool repeated) {
    const auto binding = find_binding(std::string(modifiers) + std::string(key));
    if (!binding) return;
    if (repeated && !repeats(binding->action)) return;
    if (is_held(binding->action)) {
        held_.insert_or_assign(std::string(key), *binding);
        update_held();
    } else {
        perform(*binding);
    }
}

void Controller::key_up(std::string_view key) {
    const auto found = held_.find(key);
    if (found == held_.end()) return;
    held_.erase(found);
    update_held();
}

void Controller::release_all() {
    held_.clear();
    update_held();
    if (drag_ != Drag::none) button_up(drag_button_);
}

void Controller::update_held() {
    Vec3 force(0.0f);
    bool pulling = false, freezing = false;
    for (const auto& [key, binding] : held_) {
        const float acceleration = force_key_acceleration * float(binding.argument);
        if (binding.action == Action::force_x) force.x += acceleration;
        if (binding.action == Action::force_y) force.y += acceleration;
        if (binding.action == Action::force_z) force.z += acceleration;
        pulling = pulling || binding.action == Action::pull_to_center;
        freezing = freezing || binding.action == Action::freeze;
    }
    if (force != force_) post_(command::SetForce{force});
    if (pulling != pulling_) post_(command::SetPull{pulling});
    if (freezing != freezing_) post_(command::SetFreeze{freezing});
    force_ = force;
    pulling_ = pulling;
    freezing_ = freezing;
}

void Controller::perform_on_body(Action action) {
    const Position above = camera.target() + Position(0.0, double(spawn_height * camera.distance()), 0.0);
    switch (action) {
    case Action::add_box:
        post_(command::Spawn{box_preset(), above});
        break;
    case Action::add_large_sphere:
        post_(command::Spawn{large_sphere_preset(), above});
        break;
    case Action::add_small_sphere:
        post_(command::Spawn{small_sphere_preset(), above});
        break;
    case Action::add_capsule:
        post_(command::Spawn{preset_of(SpawnSettings::Kind::capsule), above});
        break;
    case Action::add_cylinder:
        post_(command::Spawn{preset_of(SpawnSettings::Kind::cylinder), above});
        break;
    case Action::add_cone:
        post_(command::Spawn{preset_of(SpawnSettings::Kind::cone), above});
        break;
    case Action::add_polyhedron:
        // Linear congruential generator of Numerical Recipes; only its upper bits are good.
        polyhedra_ = polyhedra_ * 1664525u + 1013904223u;
        post_(command::Spawn{preset_of(polyhedron_kinds[(polyhedra_ >> 16) % std::size(polyhedron_kinds)]), above});
        break;
    case Action::shoot:
        post_(command::Shoot{tool, camera.cursor_ray(cursor_, aspect_)});
        break;
    case Action::remove_last:
        post_(command::RemoveLast{});
        break;
    case Action::remove_selected:
        post_(command::RemoveSelected{});
        break;
    case Action::select_nothing:
        if (palette)
            palette = false;
        else if (help)
            help = false;
        else if (drag_ == Drag::frame)
            drag_ = Drag::none;
        else
            post_(command::SelectNothing{});
        break;
    default:
        break;
    }
}

bool Controller::perform_on_joint(Action action) {
    const auto join = [&](command::JoinKind kind) {
        post_(command::MakeJoint{camera.pick_ray(cursor_, aspect_), kind});
    };
    switch (action) {
    case Action::join_by_ball:
        join(command::JoinKind::ball);
        return true;
    case Action::join_by_hinge:
        join(command::JoinKind::hinge);
        return true;
    case Action::join_fixed:
        join(command::JoinKind::fixed);
        return true;
    case Action::remove_joint:
        post_(command::RemoveJoint{state_.selected_joint});
        return true;
    case Action::toggle_joints:
        joints = JointsShown((int(joints) + 1) % joints_shown_count);
        return true;
    default:
        return false;
    }
}

// The shown joint with the anchor nearest to the cursor, within `joint_slack`; null if there is none, or if the picture
// shows no joints.
JointId Controller::joint_under_cursor() const {
    JointId nearest;
    if (!state_.current || !state_.current->joints) return nearest;
    float least = joint_slack;
    const FrameOptions options = frame_options(state_);
    for (std::size_t i = 0; i < state_.current->joints->size(); ++i) {
        const JointLayout& joint = (*state_.current->joints)[i];
        if (!is_shown(joint, state_.current->joint_states[i], *state_.layout, options)) continue;
        const JointFrames frames = frames_of(joint, state_.current->transforms);
        for (const Position& anchor : {frames.a.position, frames.b.position}) {
            const auto device = camera.project(anchor, aspect_);
            if (!device) continue;
            const float distance = glm::length((*device - cursor_) * glm::vec2(aspect_, 1.0f) * 0.5f);
            if (distance >= least) continue;
            least = distance;
            nearest = joint.id;
        }
    }
    return nearest;
}

bool Controller::perform_on_time(Action action) {
    switch (action) {
    case Action::toggle_pause:
        post_(command::TogglePause{});
        return true;
    case Action::single_step:
        post_(command::SingleStep{});
        return true;
    case Action::step_back:
        post_(command::StepBack{});
        return true;
    case Action::play_backwards:
        post_(command::PlayBackwards{});
        return true;
    case Action::undo:
        post_(command::Undo{});
        return true;
    case Action::redo:
        post_(command::Redo{});
        return true;
    case Action::branch_off:
        post_(command::BranchOff{});
        return true;
    case Action::exchange_runs:
        post_(command::ExchangeRuns{});
        return true;
    case Action::end_other_run:
        post_(command::EndOtherRun{});
        return true;
    case Action::slower:
        post_(command::ChangeSpeed{-1});
        return true;
    case Action::faster:
        post_(command::ChangeSpeed{1});
        return true;
    default:
        return false;
    }
}

bool Controller::perform_on_window(Action action) {
    const auto toggle = [](bool& what) { return what = !what, true; };
    SolverShown shown = solver;
    switch (action) {
    case Action::toggle_grid:
        return toggle(grid);
    case Action::toggle_shadows:
        return toggle(shadows);
    case Action::toggle_visuals:
        return toggle(visuals);
    case Action::toggle_panel:
        return toggle(panel);
    case Action::toggle_help:
        return toggle(help);
    case Action::toggle_plots:
        return toggle(plots);
    case Action::toggle_integrators:
        return toggle(integrators);
    case Action::toggle_impacts:
        return toggle(impacts);
    case Action::toggle_panes:
        return toggle(panes);
    case Action::toggle_palette:
        return toggle(palette);
    case Action::toggle_theme:
        return toggle(light_theme);
    case Action::toggle_contacts:
        shown.contacts = !shown.contacts;
        show_solver(shown);
        return true;
    case Action::save_scene:
        return save_scene = true;
    case Action::save_recording:
        return save_recording = true;
    case Action::record_video:
        return video = true;
    case Action::screenshot:
        return screenshot = true;
    case Action::quit:
        return quit = true;
    default:
        return false;
    }
}

void Controller::perform(const Binding& binding) {
    const Action action = binding.action;
    if (perform_on_camera(action) || perform_on_joint(action) || perform_on_time(action) || perform_on_window(action))
        return;
    switch (action) {
    case Action::choose_scene:
        choose_scene(std::size_t(binding.argument));
        break;
    case Action::next_scene:
        change_scene(1);
        break;
    case Action::previous_scene:
        change_scene(-1);
        break;
    case Action::reset_scene:
        post_(command::ResetScene{});
        break;
    case Action::next_colors:
        set_colors(ColorMode((int(colors) + 1) % color_mode_count));
        break;
    case Action::next_gizmo:
        gizmo.mode = GizmoMode((int(gizmo.mode) + 1) % gizmo_mode_count);
        break;
    case Action::duplicate:
        post_(command::DuplicateSelected{});
        break;
    case Action::group:
        post_(command::GroupSelected{});
        break;
    case Action::ungroup:
        post_(command::UngroupSelected{});
        break;
    default:
        perform_on_body(action);
        break;
    }
}

void Controller::move_cursor(const glm::vec2& device, float aspect) {
    const glm::vec2 moved = (device - cursor_) * 0.5f; // in view sizes
    cursor_ = device;
    aspect_ = aspect;
    if (drag_ == Drag::orbit) camera.orbit(-moved.x * aspect * orbit_per_picture, -moved.y * orbit_per_picture);
    if (drag_ == Drag::pan) camera.pan(-moved.x * aspect, -moved.y, aspect);
}

void Controller::button_down(MouseButton button) {
    if (drag_ != Drag::none) return;
    drag_button_ = button;
    pressed_at_ = cursor_;
    if (button == MouseButton::right || (button == MouseButton::left && !is_in_first_pane)) {
        drag_ = Drag::orbit;
    } else if (button == MouseButton::middle) {
        drag_ = Drag::pan;
    } else if (take_handle()) {
        drag_ = Drag::gizmo;
    } else {
        drag_ = Drag::asked;
        spans_frame_ = constraint_ == DragConstraint::vertical; // Shift
        pressed_joint_ = joint_under_cursor();
        post_(command::GrabBody{camera.pick_ray(cursor_, aspect_), ++grab_serial_});
    }
}

void Controller::button_up(MouseButton button) {
    if (drag_ == Drag::none || button != drag_button_) return;
    const Drag was = std::exchange(drag_, Drag::none);
    if (was == Drag::gizmo) {
        gizmo.end();
        post_(command::EndChange{});
        return;
    }
    if (button != MouseButton::left) return;
    command::ReleaseGrab release{is_click(), constraint_ == DragConstraint::vertical}; // Shift
    // While the answer to the grab is still pending, only the stage knows whether a body is dragged.
    if (!release.click && (was == Drag::frame || (was == Drag::asked && spans_frame_)))
        release.framed = framed_bodies();
    post_(release);
    if (release.click && pressed_joint_) post_(command::SelectJoint{pressed_joint_});
}

bool Controller::is_click() const {
    return glm::length((cursor_ - pressed_at_) * glm::vec2(aspect_, 1.0f) * 0.5f) < click_slack;
}

std::optional<SelectionFrame> Controller::selection_frame() const {
    if (drag_ != Drag::frame || is_click()) return std::nullopt;
    return SelectionFrame::between(pressed_at_, cursor_);
}

std::vector<BodyId> Controller::framed_bodies() const {
    if (!state_.layout || !state_.current) return {};
    return bodies_within(SelectionFrame::between(pressed_at_, cursor_), *state_.layout, *state_.current, camera,
                         aspect_);
}

void Controller::drop_files(std::span<const std::string> paths) {
    if (paths.empty()) return;
    const auto is_scene = [this](const std::string& path) {
        std::string type = std::filesystem::path(path).extension().string();
        for (char& letter : type)
            if (letter >= 'A' && letter <= 'Z') letter = char(letter - 'A' + 'a');
        return std::find(file_types_.begin(), file_types_.end(), type) != file_types_.end();
    };
    // A dropped set may include textures and buffers.
    const auto found = std::find_if(paths.begin(), paths.end(), is_scene);
    if (found != paths.end()) return post_(command::LoadScene{*found});
    std::string types;
    for (const std::string& type : file_types_) types += (types.empty() ? "" : ", ") + type;
    const std::string name = std::filesystem::path(paths.front()).filename().string();
    post_(command::Say{name + " is not a scene: files of these types can be opened: " + types});
}

void Controller::update(const StageState& state) {
    state_ = state;
    scene_path_ = state.path;
    if (state.scene_serial != scene_serial_) {
        const bool same_scene_again = scene_serial_ != 0 && state.path == framed_path_;
        if (!same_scene_again) take_scene_view(state);
        find_grounds(state);
        framed_path_ = state.path;
        scene_serial_ = state.scene_serial;
        force_ = Vec3(0.0f); // the new world has none of the held forces yet
        pulling_ = freezing_ = false;
        update_held();
    }
    follow_selected(state);
    if (drag_ == Drag::gizmo) drag_handle();
    if (drag_ == Drag::asked && state.grab.serial == grab_serial_) {
        drag_ = state.grab.holding ? Drag::body : spans_frame_ ? Drag::frame : Drag::orbit;
        drag_start_ = state.grab.start;
    }
    if (drag_ != Drag::body) return;
    if (!state.grab.holding) { // the body was removed
        drag_ = Drag::none;
        return;
    }
    const Position target = drag_target(camera.pick_ray(cursor_, aspect_), drag_start_, camera.forward(), constraint_,
                                        farthest_drag + camera.reach_behind());
    drag_target_ = target;
    if (target != state.grab.target) post_(command::MoveGrab{target});
}

FrameOptions Controller::frame_options(const StageState& state) const {
    FrameOptions options;
    options.colors = colors;
    options.grid = grid;
    options.shadows = shadows;
    options.lighting = state.lighting;
    options.visuals = visuals;
    options.selected = state.selected;
    options.selection = state.selection;
    if (selection_frame())
        for (const BodyId body : framed_bodies()) options.selection.push_back(body);
    std::sort(options.selection.begin(), options.selection.end());
    options.joints = joints;
    options.selected_joint = state.selected_joint;
    // The drag line ends at the present cursor target, because the stage's target may be several steps old.
    if (drag_ == Drag::body && state.grab.holding)
        options.drag = DragLine{state.grab.body, state.grab.local_point, drag_target_};
    return options;
}

} // namespace cairn::viewer
