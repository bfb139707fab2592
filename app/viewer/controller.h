/// \file controller.h
/// How the viewer responds to keys and the mouse, independent of the input source. It moves the camera, holds the
/// display settings, and turns all other input into commands.
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

/// Acceleration that the force keys give every dynamic body, m/s^2.
inline constexpr float force_key_acceleration = 40.0f;

class Controller {
  public:
    using Post = std::function<void(Command)>;
    /// `file_types`: the extensions of files that can be opened, in lower case, with their dots.
    Controller(Post post, std::vector<SceneItem> scenes, std::vector<std::string> file_types = {})
        : post_(std::move(post)), scenes_(std::move(scenes)), file_types_(std::move(file_types)) {}

    // --- display settings; the panel changes these directly
    OrbitCamera camera;
    ColorMode colors = ColorMode::scene;
    bool grid = true, shadows = true, panel = true, help = false;
    bool visuals = true;                    ///< Show the scene's visual meshes instead of collision shapes.
    JointsShown joints = JointsShown::some; ///< Which joints are drawn, and so can be picked.
    SpawnSettings tool;                     ///< Settings of the spawn tool.
    bool quit = false;
    SolverShown solver;                      ///< Which solver data is shown; change it by `show_solver`.
    Gizmo gizmo;                             ///< Handles of the selection.
    bool palette = false;                    ///< The command palette is open.
    bool light_theme = false;                ///< Light color theme of the interface.
    bool follow = false;                     ///< The camera moves with the selected body.
    bool plots = false, integrators = false; ///< Whether these windows are open.
    bool impacts = false;                    ///< The impact window is open.
    bool panes = false;                      ///< Panes are shown.
    bool is_in_first_pane = true;            ///< The cursor is in the view of the run that commands change.
    std::size_t plotted = 0;                 ///< Number of samples in the plots, for reports.
    SvgOfChart svg_of_chart;                 ///< Empty: charts cannot be exported as SVG.
    /// Centers of interface items by name, for scripts and tests.
    std::map<std::string, glm::vec2, std::less<>> places;

    // --- requests; whoever fulfills one clears it
    bool screenshot = false, save_scene = false, save_recording = false, video = false;
    std::vector<Export> exports;
    std::string page; ///< Documentation page to open.

    const std::vector<SceneItem>& scenes() const noexcept { return scenes_; }
    void choose_scene(std::size_t index); ///< An index beyond the list is ignored.
    void set_colors(ColorMode mode);
    void show_solver(const SolverShown& shown);
    void post(Command command) { post_(std::move(command)); }

    // --- input
    /// A key is pressed (`repeated`: auto-repeat of a held key). Chords without a binding are ignored.
    void key_down(std::string_view modifiers, std::string_view key, bool repeated = false);
    void key_up(std::string_view key);
    /// Performs the action of a binding, except actions that last as long as a key is held.
    void perform(const Binding& binding);
    /// Releases all keys and drags; called when the window loses the focus, because it then misses their release
    /// events.
    void release_all();
    /// Sets the cursor position in normalized device coordinates; `aspect`: width over height of the view.
    void move_cursor(const glm::vec2& device, float aspect);
    void button_down(MouseButton button);
    void button_up(MouseButton button);
    /// Files were dropped on the window: opens the first scene among them, or reports that there is none.
    void drop_files(std::span<const std::string> paths);
    void wheel(float notches) { camera.zoom(notches); }
    /// Sets the drag constraint of the modifiers that are held. A drag that begins beside all bodies with Shift
    /// (`vertical`) spans a selection rectangle.
    void set_constraint(DragConstraint constraint) { constraint_ = constraint; }

    /// To be called every frame with the latest state: adopts the views of new scenes and the answers to grabs.
    void update(const StageState& state);
    /// Draws the handles of the selection.
    void add_gizmo(RenderFrame& frame, const StageState& state) const;
    /// The options for drawing that state.
    FrameOptions frame_options(const StageState& state) const;
    bool dragging() const noexcept { return drag_ == Drag::body; }
    /// The rectangle that the cursor spans at present, for selecting the bodies in it.
    std::optional<SelectionFrame> selection_frame() const;

  private:
    enum class Drag { none, asked, body, orbit, pan, gizmo, frame };
    bool perform_on_camera(Action action);
    void perform_on_body(Action action);
    bool perform_on_joint(Action action);
    JointId joint_under_cursor() const; ///< among the joints that are shown
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
    std::uint32_t polyhedra_ = 1;                      // state of a pseudorandom generator
    std::map<std::string, Binding, std::less<>> held_; // keyed by key name, without modifiers
    Vec3 force_{0.0f, 0.0f, 0.0f};
    bool pulling_ = false, freezing_ = false;
    bool wants_parallel_ = false; // the user's choice, kept across scenes
    glm::vec2 cursor_{0.0f, 0.0f}, pressed_at_{0.0f, 0.0f};
    float aspect_ = 16.0f / 9.0f;
    Drag drag_ = Drag::none;
    MouseButton drag_button_ = MouseButton::left;
    bool spans_frame_ = false; // a left-button drag that meets no body spans a selection rectangle
    // Joint under the cursor at button-down; it is stored because the click itself may make other joints visible.
    JointId pressed_joint_;
    std::vector<HeldBody> held_bodies_; // bodies moved by a handle
    Position handle_center_{0.0, 0.0, 0.0};
    float scaled_ = 1.0f; // total scale factor since the handle was grabbed
    std::uint64_t grab_serial_ = 0;
    Position drag_start_{0.0, 0.0, 0.0}, drag_target_{0.0, 0.0, 0.0};
    DragConstraint constraint_ = DragConstraint::view_plane;
    StageState state_; // latest state
    std::uint64_t scene_serial_ = 0;
    std::string scene_path_, framed_path_;
};

} // namespace cairn::viewer
