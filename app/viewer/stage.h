/// \file stage.h
/// The simulation that the viewer shows: a scene, the changes made by user commands, and a clock. Not thread-safe: one
/// thread at a time.
#pragma once

#include "viewer/commands.h"
#include "viewer/pane.h"
#include "viewer/samples.h"
#include "viewer/scene_source.h"
#include "viewer/side_run.h"
#include "viewer/step_clock.h"
#include "viewer/timeline.h"
#include "viewer/world_state.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace cairn::viewer {

/// The answer to `command::GrabBody`, and the state of the drag.
struct Grab {
    std::uint64_t serial = 0;           ///< Serial number of the latest answered command.
    bool holding = false;               ///< A dynamic body is held at present.
    BodyId body;                        ///< The body grabbed last; null if the latest ray met no dynamic body.
    Position start{0.0, 0.0, 0.0};      ///< World position of the grabbed point when it was grabbed, meters.
    Vec3 local_point{0.0f, 0.0f, 0.0f}; ///< The grabbed point in the body's frame, meters.
    Position target{0.0, 0.0, 0.0};     ///< World position that the cursor pulls the grabbed point toward, meters.
};

/// A line of text for the user.
struct Message {
    std::uint64_t serial = 0; ///< Counts up from 1; 0: no message yet.
    std::string text;
};

/// The known part of the run before and after the present step.
struct TimelineState {
    std::uint64_t first = 0, last = 0, now = 0;      ///< Step numbers.
    std::shared_ptr<const std::vector<Mark>> marks;  ///< In order of their steps.
    std::optional<std::string> undoable, redoable;   ///< Names of the changes that undo and redo would affect.
    bool is_backwards = false, is_recording = false; ///< Time runs backwards; the run comes from a recording file.
    Timeline::Verdict verdict;
    std::size_t bytes = 0; ///< Memory that the timeline takes.
};

/// The second of two runs that branched from a common past.
struct OtherRun {
    std::uint64_t branched_at = 0; ///< Step number at which the runs branched.
    RunPicture picture;
    RunDifference difference;
};

/// Everything that the window shows. A copy is cheap: the large parts are shared and immutable.
struct StageState {
    std::uint64_t scene_serial = 0; ///< Counts loaded scenes, resets included.
    std::string path, title, hint;
    CameraPose scene_camera;
    Lighting lighting;
    std::shared_ptr<const WorldLayout> layout;
    std::shared_ptr<const WorldMotion> previous, current;
    Statistics statistics;
    double step_milliseconds = 0.0; ///< Mean over the last half second or so, as the physics thread measured it.
    WorldDef settings;
    int usual_substeps = 6; ///< `World::usual_substeps` of `time_step`.
    /// Force fields, without those that exist while a key is held.
    std::vector<std::pair<ForceFieldId, ForceField>> fields;
    bool paused = false;
    bool frozen = false, pulled = false;
    Vec3 force{0.0f, 0.0f, 0.0f};
    double speed = 1.0, real_time_factor = 0.0, time_step = 1.0 / 60.0;
    double remainder = 0.0;        ///< Simulated seconds by which real time is ahead of `current`.
    BodyId selected;               ///< The body whose data the windows show.
    std::vector<BodyId> selection; ///< All selected bodies, `selected` included.
    bool is_group = false;         ///< The selected bodies form one group.
    JointId selected_joint;
    Grab grab;
    Message message;
    TimelineState timeline;
    std::optional<OtherRun> other;
    std::vector<PaneState> panes;        ///< The panes beside this run.
    std::optional<Impact> impact;        ///< The impact that was requested, if any.
    std::vector<BodyId> impact_partners; ///< Bodies that the impact's body has hit, most recent first.
    double energy = 0.0;                 ///< J, kinetic and potential; computed only while there are panes.
    std::uint64_t panes_began = 0;       ///< Step number at which the panes began.
    SampleLog samples;
    std::optional<BodyFacts> inspected; ///< Data of the selected body.
    /// Data that the gizmo handles edit: the selected body, or a stand-in for several.
    std::optional<BodyFacts> handled;
};

class Stage {
  public:
    /// Loads the first scene; exceptions of the loader propagate.
    Stage(SceneLoader loader, const std::string& path, Savers savers = {});
    ~Stage();

    /// Executes one command. A command that fails changes nothing and leaves a message.
    void apply(const Command& command);
    /// Advances the clock by real seconds: takes the steps that are due, unless they take too long, and returns how
    /// many it took.
    int advance(double real_seconds);
    /// Takes one step regardless of the clock.
    void step();
    /// Real seconds until the next step or other work is due.
    double until_next_step() const;
    /// A copy of the state to display.
    StageState state() const;

    const World& world() const noexcept { return scene_.world; }
    const Timeline& timeline() const noexcept { return timeline_; }

    void operator()(const command::LoadScene& load);
    void operator()(const command::ResetScene&);
    void operator()(const command::Spawn& spawn);
    void operator()(const command::Shoot& shoot);
    void operator()(const command::RemoveLast&);
    void operator()(const command::RemoveSelected&);
    void operator()(const command::SetForce& force);
    void operator()(const command::SetPull& pull);
    void operator()(const command::SetFreeze& freeze);
    void operator()(const command::SetPaused& pause);
    void operator()(const command::TogglePause&);
    void operator()(const command::SingleStep&);
    void operator()(const command::ChangeSpeed& change);
    void operator()(const command::SetSpeed& speed);
    void operator()(const command::SeekTo& seek);
    void operator()(const command::StepBack&);
    void operator()(const command::PlayBackwards&);
    void operator()(const command::Undo&);
    void operator()(const command::Redo&);
    void operator()(const command::BranchOff&);
    void operator()(const command::ExchangeRuns&);
    void operator()(const command::EndOtherRun&);
    void operator()(const command::SetPanes& set);
    void operator()(const command::ExplainImpact& explain);
    void operator()(const command::WatchImpact&);
    void operator()(const command::SaveRecording& save);
    void operator()(const command::SetSettings& settings);
    void operator()(const command::AddField& add);
    void operator()(const command::SetField& set);
    void operator()(const command::RemoveField& remove);
    void operator()(const command::GrabBody& grab);
    void operator()(const command::MoveGrab& move);
    void operator()(const command::ReleaseGrab& release);
    void operator()(const command::SelectNothing&);
    void operator()(const command::Say& words);
    void operator()(const command::ShowIslands& show);
    void operator()(const command::TakeSamples& take);
    void operator()(const command::ShowSolver& show);
    void operator()(const command::SelectBody& select);
    void operator()(const command::EditBody& change);
    void operator()(const command::EditBodies& change);
    void operator()(const command::GroupSelected&);
    void operator()(const command::UngroupSelected&);
    void operator()(const command::EndChange&);
    void operator()(const command::DuplicateSelected&);
    void operator()(const command::SaveScene& save);
    void operator()(const command::MakeJoint& make);
    void operator()(const command::SelectJoint& select);
    void operator()(const command::SetJoint& joint);
    void operator()(const command::SetJointStrength& strength);
    void operator()(const command::SetJointEnabled& change);
    void operator()(const command::SetJointSolver& solver);
    void operator()(const command::RemoveJoint& joint);

  private:
    struct Writer;
    void take_scene(LoadedScene scene, const std::string& path);
    void live_step();
    void follow();
    void go_back();
    void go_on_seeking();
    void arrive();
    void settle_branch();
    void take_others_along(double seconds);
    void restart_panes();
    void end_slow_motion();
    Looks looks() const { return {scene_.appearances, scene_.visuals, scene_.strings}; }
    void hear_from_writer();
    void take_sample();
    void watch_energy();
    template <class Go> bool travel(const Go& go);
    void remove(const std::vector<BodyId>& bodies);
    void all_or_nothing(const std::function<void()>& change);
    std::vector<BodyId> copy_bodies(const std::vector<BodyId>& bodies, double shift);
    const std::vector<BodyId>* group_of(BodyId body) const;
    std::vector<BodyId> with_group(BodyId body) const;
    bool is_group_selected() const;
    void select(BodyId body);
    void select(std::vector<BodyId> bodies, BodyId first);
    void toggle_selected(std::vector<BodyId> before, BodyId body);
    void drop_gone_from_selection();
    void finish_click(bool adds);
    void add_to_selection(const std::vector<BodyId>& bodies);
    void say(std::string text);
    void add_body(const SpawnSettings& settings, const Position& position, const Vec3& velocity);
    bool walk(const Vec3& push);
    void update_field(std::optional<ForceFieldId>& id, const ForceField& field, bool on);
    std::vector<std::pair<ForceFieldId, ForceField>> fields() const;
    void pull_grabbed();
    void let_go();
    void report_broken();
    void hold_still();
    void refresh_layout();
    void refresh_joints();
    void refresh_motion();

    SceneLoader loader_;
    LoadedScene scene_;
    std::string path_;
    StepClock clock_;
    Spawner spawner_;
    MeshCache meshes_;
    std::vector<BodyId> order_; // dynamic bodies in order of creation; may hold stale ids
    std::optional<ForceFieldId> force_field_, pull_field_;
    Vec3 force_{0.0f, 0.0f, 0.0f};
    bool frozen_ = false, with_islands_ = false;
    BodyId selected_; // one body of the selection, or null
    std::vector<BodyId> selection_, selected_before_grab_;
    BodyId met_; // the body, of any type, that the ray of the latest grab met
    JointId selected_joint_;
    Grab grab_;
    JointId drag_joint_; // belongs to the viewer, not to the scene: lists of joints leave it out
    Message message_;
    std::uint64_t scene_serial_ = 0;
    Timeline timeline_;
    std::vector<Held> held_;
    std::unique_ptr<SideRun> other_; // null: no second run
    std::uint64_t parted_at_ = 0;
    std::optional<PaneStart> panes_start_; // empty: no panes
    std::vector<Pane> panes_;
    bool others_are_here_ = true; // the other run and the panes are at the same step as this run
    std::optional<std::uint64_t> seeking_;
    bool is_backwards_ = false;
    bool with_samples_ = false;
    SolverShown solver_shown_;
    // An interval of the run that is shown in slow motion.
    struct SlowMotion {
        std::uint64_t end = 0;     // step number
        double speed_before = 1.0; // clock speed to return to
    };
    std::optional<SlowMotion> slow_motion_;
    std::optional<Impact> impact_;
    std::vector<BodyId> impact_partners_;
    SampleLog samples_;
    EnergyBalance energy_balance_;
    Savers savers_;
    std::shared_ptr<Writer> writer_;
    std::shared_ptr<const WorldLayout> layout_;
    std::shared_ptr<const std::vector<JointLayout>> joints_;
    std::shared_ptr<const WorldMotion> previous_, current_;
    double step_milliseconds_ = 0.0;
};

} // namespace cairn::viewer
