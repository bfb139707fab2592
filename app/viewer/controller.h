/// \file controller.h
/// What the viewer does with keys and the mouse, without knowing where they come from. It moves the camera, keeps the
/// settings of the picture, and turns the rest into commands.
#pragma once

#include "viewer/camera.h"
#include "viewer/commands.h"
#include "viewer/export.h"
#include "viewer/gizmo.h"
#include "viewer/group_edit.h"
#include "viewer/key_map.h"
#include "viewer/render_frame.h"
#include "viewer/scene_source.h"
#include "viewer/selection_frame.h"
#include "viewer/stage.h"

#include <glm/vec2.hpp>

#include <functional>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace cairn::viewer {

enum class MouseButton { left, right, middle };

/// Acceleration that the force keys give every body, m/s^2.
inline constexpr float force_key_acceleration = 40.0f;

class Controller {
  public:
    using Post = std::function<void(Command)>;
    /// `file_types`: the extensions of files that can be opened, in small letters, with their points.
    Controller(Post post, std::vector<SceneItem> scenes, std::vector<std::string> file_types = {})
        : post_(std::move(post)), scenes_(std::move(scenes)), file_types_(std::move(file_types)) {}

    // --- what the picture shows; the panel changes these directly
    OrbitCamera camera;
    ColorMode colors = ColorMode::scene;
    bool grid = true, shadows = true, panel = true, help = false;
    bool visuals = true;                    ///< The meshes that came with the scene instead of what collides.
    JointsShown joints = JointsShown::some; ///< Which are drawn, and can be picked.
    SpawnSettings tool;                     ///< Of the spawn tool.
    bool quit = false;
    SolverShown solver;                      ///< What of the solver is shown; change it by `show_solver`.
    Gizmo gizmo;                             ///< Handles of the selected body.
    bool palette = false;                    ///< The list of commands is open.
    bool light_theme = false;                ///< Of the interface.
    bool follow = false;                     ///< The camera moves with the selected body.
    bool plots = false, integrators = false; ///< Windows that are open.
    bool impacts = false;                    ///< Likewise: that of an impact.
    bool panes = false;                      ///< Panes are wanted.
    bool is_in_first_pane = true;            ///< The cursor is in the picture of the run that commands change.
    std::size_t plotted = 0;                 ///< Samples that the plots show, for reports.
    SvgOfChart svg_of_chart;                 ///< Empty: pictures of charts cannot be made.
    /// Middles of items of the interface, for scripts and tests.
    std::map<std::string, glm::vec2, std::less<>> places;

    // --- what was asked for; whoever does it clears it
    bool screenshot = false, save_scene = false, save_recording = false, video = false;
    std::vector<Export> exports;
    std::string page; ///< Of the documentation, to be opened.

    const std::vector<SceneItem>& scenes() const noexcept { return scenes_; }
    void choose_scene(std::size_t index); ///< Beyond the list: nothing happens.
    void set_colors(ColorMode mode);
    void show_solver(const SolverShown& shown);
    void post(Command command) { post_(std::move(command)); }

    // --- input
    /// A key went down (`repeated`: is still down). Chords that are bound to nothing are ignored.
    void key_down(std::string_view modifiers, std::string_view key, bool repeated = false);
    void key_up(std::string_view key);
    /// Does what a key is bound to, but for what lasts as long as it is held.
    void perform(const Binding& binding);
    /// Lets go of everything: the window lost the focus, so the ends of keys and drags would be missed.
    void release_all();
    /// The cursor, in normalized device coordinates, and the picture's aspect, width over height.
    void move_cursor(const glm::vec2& device, float aspect);
    void button_down(MouseButton button);
    void button_up(MouseButton button);
    /// Files were dropped on the window: opens the first scene among them, or says why there is none.
    void drop_files(std::span<const std::string> paths);
    void wheel(float notches) { camera.zoom(notches); }
    /// Modifiers now held: they constrain a drag. One that begins beside bodies with Shift (`vertical`) spans a frame.
    void set_constraint(DragConstraint constraint) { constraint_ = constraint; }

    /// To be called every frame with the latest state: follows new scenes and the answers to grabs.
    void update(const StageState& state);
    /// Draws the handles of the selected body.
    void add_gizmo(RenderFrame& frame, const StageState& state) const;
    /// How to draw that state.
    FrameOptions frame_options(const StageState& state) const;
    bool dragging() const noexcept { return drag_ == Drag::body; }
    /// The frame that the cursor spans now, to select what lies in it.
    std::optional<SelectionFrame> selection_frame() const;

  private:
    enum class Drag { none, asked, body, orbit, pan, gizmo, frame };
    bool perform_on_camera(Action action);
    void perform_on_body(Action action);
    bool perform_on_joint(Action action);
    JointId joint_under_cursor() const; ///< Among those that are shown.
    std::vector<BodyId> framed_bodies() const;
    bool is_click() const;
    void change_scene(int by);
    bool perform_on_window(Action action);
    bool perform_on_time(Action action);
    void take_scene_view(const StageState& state);
    void follow_selected(const StageState& state);
    bool take_handle();
    void drag_handle();
    void find_grounds(const StageState& state);
    void update_held();

    Post post_;
    std::vector<SceneItem> scenes_;
    std::vector<std::string> file_types_;
    std::uint32_t polyhedra_ = 1;                      // state of a random generator
    std::map<std::string, Binding, std::less<>> held_; // by key, without modifiers
    Vec3 force_{0.0f, 0.0f, 0.0f};
    bool pulling_ = false, freezing_ = false;
    bool wants_parallel_ = false; // whichever the scene
    glm::vec2 cursor_{0.0f, 0.0f}, pressed_at_{0.0f, 0.0f};
    float aspect_ = 16.0f / 9.0f;
    Drag drag_ = Drag::none;
    MouseButton drag_button_ = MouseButton::left;
    bool spans_frame_ = false; // a drag with the left button that meets no body
    JointId pressed_joint_;    // under the cursor when the button went down: a click shows joints that it did not mean
    std::vector<HeldBody> held_bodies_; // by a handle
    Position handle_center_{0.0, 0.0, 0.0};
    float scaled_ = 1.0f; // since it was taken
    std::uint64_t grab_serial_ = 0;
    Position drag_start_{0.0, 0.0, 0.0}, drag_target_{0.0, 0.0, 0.0};
    DragConstraint constraint_ = DragConstraint::view_plane;
    StageState state_; // the latest
    std::uint64_t scene_serial_ = 0;
    std::string scene_path_, framed_path_;
};

} // namespace cairn::viewer
