/// \file scene_source.h
/// The interface through which the viewer gets scenes. The viewer does not depend on scene files: its caller passes a
/// loader function.
#pragma once

#include "viewer/camera.h"
#include "viewer/lights.h"
#include "viewer/shape_meshes.h"

#include <cairn/cairn.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace cairn::viewer {

/// The color that a scene gives to one shape: linear red, green and blue, each 0 to 1.
struct Appearance {
    ShapeId shape;
    Vec3 color{0.8f, 0.8f, 0.8f};
};

/// A joint that is drawn as a string between its two anchors.
struct JointAppearance {
    JointId joint;
    Vec3 color{0.8f, 0.8f, 0.8f}; ///< Linear.
};

/// A visual mesh of the scene. It moves with its body, and is drawn instead of the body's shapes.
struct Visual {
    BodyId body;     ///< Null: scenery, which never moves.
    Transform local; ///< Pose in the frame of the body, or of scenery in the world.
    std::shared_ptr<const ShapeMesh> mesh;
    Vec3 color{0.8f, 0.8f, 0.8f}; ///< Linear.
    /// Empty: the mesh is rigid. Else it is skinned to these bones and drawn instead of the shapes of their bodies;
    /// `body` is null, and `local` is unused.
    std::vector<Bone> bones{};
};

/// The changes between two steps of a recorded world, as commands (cairn/commands.h), and the step command.
struct RecordedStep {
    std::vector<std::vector<std::byte>> changes;
    std::vector<std::byte> step;       ///< Empty: no step follows.
    std::optional<StateDigest> digest; ///< Recorded digest of the state after the step.
};

/// The run of a recording file: the world of the scene is at its beginning, and these steps reproduce it.
struct RecordedRun {
    std::vector<RecordedStep> steps;
    /// Resolves the references of the commands; needed if there are any commands.
    std::shared_ptr<CommandSource> source;
    /// The last keyframe after more than `after` and at most `until` steps, and its step. May be empty.
    std::function<std::optional<std::pair<std::uint64_t, Snapshot>>(std::uint64_t after, std::uint64_t until)> keyframe;
};

/// A scene, ready to run.
struct LoadedScene {
    World world;
    std::string title;
    std::string hint; ///< One line that suggests what to try.
    CameraPose camera;
    std::vector<Light> lights{};    ///< Empty: the default lighting.
    float time_step = 1.0f / 60.0f; ///< Seconds of one step, > 0.
    std::vector<Appearance> appearances;
    std::vector<Visual> visuals{};
    std::vector<JointAppearance> strings{};
    std::vector<std::vector<BodyId>> groups{}; ///< Bodies that are selected together.
    RecordedRun run{};
    bool is_paused = false; ///< The scene starts paused.
};

/// Loads the scene at that path. Throws `cairn::Error` (or any std::exception) if it cannot. Called on the physics
/// thread.
using SceneLoader = std::function<LoadedScene(const std::string& path)>;

/// The data at the beginning of a recording besides the commands.
struct RecordingLooks {
    std::string source; ///< A readable name of the recorded scene.
    CameraPose camera;
    std::vector<Light> lights; ///< As in `LoadedScene`.
    std::vector<Appearance> appearances;
    std::vector<Visual> visuals{};
};

/// Functions that write the viewer's files. Either may be empty, and throws as the loader does.
struct Savers {
    /// Writes a recording: `run` executes the commands to be recorded in `world`, which must not have a listener yet.
    /// Called on a thread of its own.
    std::function<void(const std::filesystem::path& path, const RecordingLooks& looks, World& world,
                       const std::function<void()>& run)>
        recording;
    /// Writes a scene.
    std::function<void(const std::filesystem::path& path, LoadedScene& scene)> scene;
};

/// An entry of the viewer's list of scenes.
struct SceneItem {
    std::string path;
    std::string title;
};

} // namespace cairn::viewer
