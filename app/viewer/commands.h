/// \file commands.h
/// Every action of the user on the simulation, as data. The window queues commands; the physics thread executes them
/// between two steps, in order.
#pragma once

#include "viewer/drag.h"
#include "viewer/inspect.h"
#include "viewer/pane.h"
#include "viewer/solver_view.h"
#include "viewer/spawn.h"

#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace cairn::viewer::command {

/// Loads a scene; on failure the present scene stays, and a message gives the reason.
struct LoadScene {
    std::string path;
};
/// Reloads the present scene.
struct ResetScene {};
/// Adds a body above the middle of the view, at the lowest free place there.
struct Spawn {
    SpawnSettings settings;
    Position position{0.0, 3.0, 0.0};
};
/// Adds a body in front of the camera with a velocity that takes it to the ray's first hit, or along the ray if there
/// is none.
struct Shoot {
    SpawnSettings settings;
    Ray ray;
};
/// Removes the dynamic body that was added last; bodies of the scene itself only after all bodies added by hand.
struct RemoveLast {};
struct RemoveSelected {};
/// A uniform acceleration of every dynamic body, m/s^2; zero ends it.
struct SetForce {
    Vec3 acceleration{0.0f, 0.0f, 0.0f};
};
/// While on, pulls every dynamic body toward the world origin.
struct SetPull {
    bool on = false;
};
/// While on, keeps every body still: all velocities are zeroed before every step.
struct SetFreeze {
    bool on = false;
};
struct SetPaused {
    bool paused = false;
};
struct TogglePause {};
struct SingleStep {};
/// Doubles (positive) or halves (negative) the speed that many times.
struct ChangeSpeed {
    int doublings = 0;
};
struct SetSpeed {
    double speed = 1.0;
};
/// Goes to the state after `step` steps, within the known part of the run; pauses.
struct SeekTo {
    std::uint64_t step = 0;
};
struct StepBack {};
/// Plays time backwards; a second command stops it.
struct PlayBackwards {};
struct Undo {};
struct Redo {};
/// Branches off: the known future becomes a second run beside this one, which continues from the present step
/// independently. An existing second run ends.
struct BranchOff {};
/// Swaps the runs: commands then change the second run, and the present run is shown beside it.
struct ExchangeRuns {};
struct EndOtherRun {};
/// Shows up to three panes beside the run: the same scene with other settings. Existing panes whose settings stay the
/// same continue; new panes start from the moment at which the first pane began.
struct SetPanes {
    std::vector<PaneSettings> panes;
};
/// Explains the last impact of `body` before the present step with `partner`; null `partner`: with any body. Null
/// `body`: none.
struct ExplainImpact {
    BodyId body, partner;
};
/// Replays the explained impact in slow motion, and pauses after it.
struct WatchImpact {};
/// Saves the last `seconds` of the run as a recording, with `camera` as its view.
struct SaveRecording {
    std::string path;
    double seconds = 30.0;
    CameraPose camera{};
};
struct SetSettings {
    WorldDef settings;
};
/// Force fields of the scene, not those that exist while a key is held.
struct AddField {
    ForceField field;
};
struct SetField {
    ForceFieldId id;
    ForceField field;
};
struct RemoveField {
    ForceFieldId id;
};
/// Selects the first dynamic body that the ray meets and grabs it at the hit point. The answer appears in `Grab` with
/// the same `serial`.
struct GrabBody {
    Ray ray;
    std::uint64_t serial = 0;
};
/// Sets the world position that the grabbed point is pulled toward.
struct MoveGrab {
    Position target{0.0, 0.0, 0.0};
};
/// Ends a grab. `click`: the cursor did not move since the grab; a click beside all dynamic bodies selects a finite
/// body that does not move, or else clears the selection. `adds`: the click toggles the body that the ray met, with its
/// group, in the previous selection. `framed`: bodies in the rectangle that the cursor spanned, if it spanned one; they
/// and their groups are added to the selection, unless the ray met a body that was dragged.
struct ReleaseGrab {
    bool click = false, adds = false;
    std::optional<std::vector<BodyId>> framed{};
};
struct SelectNothing {};
/// The kind of joint that `MakeJoint` creates.
enum class JoinKind { ball, hinge, fixed };
/// Joins the first body that the ray meets to the selected body, at the hit point; the axis of a hinge is the surface
/// normal there. Without another selected body, the joint attaches to the world.
struct MakeJoint {
    Ray ray;
    JoinKind kind = JoinKind::ball;
};
/// Selects a joint; null: none.
struct SelectJoint {
    JointId joint;
};
/// Changes limits, motors, springs and other parameters of a joint.
struct SetJoint {
    JointId joint;
    Joint values;
};
struct SetJointStrength {
    JointId joint;
    float break_force, break_torque; ///< N and N m, > 0; may be infinite.
};
struct SetJointEnabled {
    JointId joint;
    bool enabled;
};
struct SetJointSolver {
    JointId joint;
    JointSolver solver = JointSolver::automatic;
};
struct RemoveJoint {
    JointId joint;
};
/// Shows a line of text to the user.
struct Say {
    std::string text;
};
/// Finding islands costs time, so it is done only while islands are shown.
struct ShowIslands {
    bool on = false;
};
/// Copying the solver's data costs time, so it is done only while some of it is shown.
struct ShowSolver {
    SolverShown shown;
};
/// Selects a body; null: none.
struct SelectBody {
    BodyId body;
};
struct EditBody {
    BodyId body;
    BodyEdit edit;
};
/// Edits several bodies in order, as one undoable change. If one edit fails, none is made, and a message gives the
/// reason.
struct EditBodies {
    std::vector<std::pair<BodyId, BodyEdit>> edits;
};
/// Groups the selected bodies: a click on one of them selects all.
struct GroupSelected {};
/// Dissolves the groups of the selected bodies.
struct UngroupSelected {};
/// Ends the current undoable change, so that a following edit of the same kind is not merged with it.
struct EndChange {};
/// Copies the selected bodies and the joints between them, beside the originals; the copies become the selection.
struct DuplicateSelected {};
/// Saves the present state of the world as a scene, with `camera` as its view.
struct SaveScene {
    std::string path;
    CameraPose camera;
};
/// Taking samples for plots costs time, so it is done only while on.
struct TakeSamples {
    bool on = false;
};

} // namespace cairn::viewer::command

namespace cairn::viewer {

using Command =
    std::variant<command::LoadScene, command::ResetScene, command::Spawn, command::Shoot, command::RemoveLast,
                 command::RemoveSelected, command::SetForce, command::SetPull, command::SetFreeze, command::SetPaused,
                 command::TogglePause, command::SingleStep, command::ChangeSpeed, command::SetSpeed, command::SeekTo,
                 command::StepBack, command::PlayBackwards, command::Undo, command::Redo, command::BranchOff,
                 command::ExchangeRuns, command::EndOtherRun, command::SetPanes, command::ExplainImpact,
                 command::WatchImpact, command::SaveRecording, command::SetSettings, command::AddField,
                 command::SetField, command::RemoveField, command::GrabBody, command::MoveGrab, command::ReleaseGrab,
                 command::SelectNothing, command::Say, command::ShowIslands, command::TakeSamples, command::ShowSolver,
                 command::SelectBody, command::EditBody, command::EditBodies, command::GroupSelected,
                 command::UngroupSelected, command::EndChange, command::DuplicateSelected, command::SaveScene,
                 command::MakeJoint, command::SelectJoint, command::SetJoint, command::SetJointStrength,
                 command::SetJointEnabled, command::SetJointSolver, command::RemoveJoint>;

/// A queue with many producers and one consumer.
class CommandQueue {
  public:
    void push(Command command);
    /// Takes all queued commands in order, without waiting.
    std::vector<Command> take();
    /// Waits until a command is queued, `close` is called, or that many seconds have passed.
    void wait(double seconds);
    /// Wakes the waiting thread permanently: later waits return at once.
    void close();
    bool closed() const;

  private:
    mutable std::mutex mutex_;
    std::condition_variable changed_;
    std::vector<Command> commands_;
    bool closed_ = false;
};

} // namespace cairn::viewer
