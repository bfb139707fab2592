/// \file commands.h
/// Everything that a person can do to the simulation, as data. Commands are queued by the window and carried out by
/// the physics thread between two steps, in the order in which they were given.
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

/// Loads a scene; on failure the present one stays, and a message says why.
struct LoadScene {
    std::string path;
};
/// Loads the present scene again.
struct ResetScene {};
/// Adds a body above the middle of the view, or wherever there is room above that.
struct Spawn {
    SpawnSettings settings;
    Position position{0.0, 3.0, 0.0};
};
/// Adds a body in front of the camera that flies to where the ray meets something; else along the ray.
struct Shoot {
    SpawnSettings settings;
    Ray ray;
};
/// Removes the dynamic body that was added last, the scene's own after those added by hand.
struct RemoveLast {};
struct RemoveSelected {};
/// A uniform acceleration on every dynamic body, m/s^2; zero ends it.
struct SetForce {
    Vec3 acceleration{0.0f, 0.0f, 0.0f};
};
/// Pulls every dynamic body to the origin of the world while on.
struct SetPull {
    bool on = false;
};
/// Holds every body still while on: all velocities are zero before every step.
struct SetFreeze {
    bool on = false;
};
struct SetPaused {
    bool paused = false;
};
struct TogglePause {};
struct SingleStep {};
/// Doubles or halves the speed that many times.
struct ChangeSpeed {
    int doublings = 0;
};
struct SetSpeed {
    double speed = 1.0;
};
/// Goes to the moment after so many steps, within what is known; pauses.
struct SeekTo {
    std::uint64_t step = 0;
};
struct StepBack {};
/// Lets time run backwards; a second one stops it.
struct PlayBackwards {};
struct Undo {};
struct Redo {};
/// Branches off: what is known stays as another run beside this one, which goes on from now by itself. A run that there
/// is already beside it ends.
struct BranchOff {};
/// The run beside it becomes the one that commands change, and this one that beside it.
struct ExchangeRuns {};
struct EndOtherRun {};
/// The same scene with these settings beside the run, at most three; those that there are and stay go on. The others go
/// on from the moment at which the first of all began.
struct SetPanes {
    std::vector<PaneSettings> panes;
};
/// Of a body, the last impact before now with another; a null `partner`: with whatever it was. Null: none.
struct ExplainImpact {
    BodyId body, partner;
};
/// Shows that impact in slow motion, and pauses after it.
struct WatchImpact {};
/// Saves the last seconds as a recording, looked at from there.
struct SaveRecording {
    std::string path;
    double seconds = 30.0;
    CameraPose camera{};
};
struct SetSettings {
    WorldDef settings;
};
/// Force fields of the scene, not those that are held keys.
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
/// Selects the dynamic body that the ray meets first and grabs it there. The answer appears in `Grab` with the same
/// `serial`.
struct GrabBody {
    Ray ray;
    std::uint64_t serial = 0;
};
/// Where the grabbed point should go.
struct MoveGrab {
    Position target{0.0, 0.0, 0.0};
};
/// `click`: the cursor did not move since the grab; a click beside all bodies selects nothing, unless it was on what
/// belongs to a group. `adds`: a click adds the body that the ray met to those selected before, with its group, or
/// takes it away from them. `framed`: bodies in the frame that the cursor spanned, if it did; they are added to those
/// selected, with their groups, unless the ray met a body that was pulled.
struct ReleaseGrab {
    bool click = false, adds = false;
    std::optional<std::vector<BodyId>> framed{};
};
struct SelectNothing {};
/// What `MakeJoint` makes.
enum class JoinKind { ball, hinge, fixed };
/// Joins the body that the ray meets first to the selected one, at the point that it meets; a hinge turns about the
/// surface's normal there. Without another selected body the joint is with the world.
struct MakeJoint {
    Ray ray;
    JoinKind kind = JoinKind::ball;
};
/// Null: none.
struct SelectJoint {
    JointId joint;
};
/// Changes limits, motors, springs ... of a joint.
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
/// Shows a line to the person at the screen.
struct Say {
    std::string text;
};
/// Islands cost time to find, so they are found only while they are shown.
struct ShowIslands {
    bool on = false;
};
/// What the solver sees costs time, too.
struct ShowSolver {
    SolverShown shown;
};
/// Null: none.
struct SelectBody {
    BodyId body;
};
struct EditBody {
    BodyId body;
    BodyEdit edit;
};
/// Of several bodies, in that order; it is undone as one. Where one cannot be changed, none is, and a message says why.
struct EditBodies {
    std::vector<std::pair<BodyId, BodyEdit>> edits;
};
/// From now on a click on one of the selected bodies selects them all.
struct GroupSelected {};
/// Ends the groups of the selected bodies.
struct UngroupSelected {};
/// The next change is not one with the last, though it be of the same kind.
struct EndChange {};
/// Copies beside the selected bodies, which become the selected ones, joined as they are among each other.
struct DuplicateSelected {};
/// Saves the world as it stands as a scene, looked at from there.
struct SaveScene {
    std::string path;
    CameraPose camera;
};
/// Samples for plots cost time, too.
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

/// A queue that many threads may fill and one empties.
class CommandQueue {
  public:
    void push(Command command);
    /// Takes all that is queued, first come first; does not wait.
    std::vector<Command> take();
    /// Waits until something is queued, `close` was called, or that many seconds have passed.
    void wait(double seconds);
    /// Wakes the waiting thread for good: later waits return at once.
    void close();
    bool closed() const;

  private:
    mutable std::mutex mutex_;
    std::condition_variable changed_;
    std::vector<Command> commands_;
    bool closed_ = false;
};

} // namespace cairn::viewer
