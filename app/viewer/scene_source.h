/// \file scene_source.h
/// How scenes reach the viewer. The viewer knows nothing of scene files: whoever starts it passes a function.
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

/// A joint that the scene shows, as a string between its two anchors.
struct JointAppearance {
    JointId joint;
    Vec3 color{0.8f, 0.8f, 0.8f}; ///< Linear.
};

/// A mesh that the scene has for its looks. It moves with its body, whose shapes it stands for in the picture.
struct Visual {
    BodyId body;     ///< Null: scenery, which never moves.
    Transform local; ///< In the frame of the body; of scenery, in the world.
    std::shared_ptr<const ShapeMesh> mesh;
    Vec3 color{0.8f, 0.8f, 0.8f}; ///< Linear.
    /// None: it is rigid. Else it bends with the bodies of these, whose shapes it stands for; `body` is null, and
    /// `local` means nothing.
    std::vector<Bone> bones{};
};

/// What was done between two steps of a recorded world, as commands (cairn/commands.h), and the step.
struct RecordedStep {
    std::vector<std::vector<std::byte>> changes;
    std::vector<std::byte> step;       ///< Empty: none follows.
    std::optional<StateDigest> digest; ///< Of the state after the step, as recorded.
};

/// A run that a file has: the world of the scene is at its beginning, and these steps lead through it.
struct RecordedRun {
    std::vector<RecordedStep> steps;
    std::shared_ptr<CommandSource> source; ///< Of these commands; needed if there are any.
    /// The last state that was kept after more than `after` steps and no more than `until`, and its step. May be empty.
    std::function<std::optional<std::pair<std::uint64_t, Snapshot>>(std::uint64_t after, std::uint64_t until)> keyframe;
};

/// A scene, ready to run.
struct LoadedScene {
    World world;
    std::string title;
    std::string hint; ///< One line on what to try.
    CameraPose camera;
    std::vector<Light> lights{};    ///< None: that of every scene.
    float time_step = 1.0f / 60.0f; ///< Seconds of one step, > 0.
    std::vector<Appearance> appearances;
    std::vector<Visual> visuals{};
    std::vector<JointAppearance> strings{};
    std::vector<std::vector<BodyId>> groups{}; ///< Bodies that are selected together.
    RecordedRun run{};
    bool is_paused = false; ///< Waits to be started.
};

/// Loads the scene of that path. Throws `cairn::Error` (or any std::exception) if it cannot. It is called on the
/// physics thread.
using SceneLoader = std::function<LoadedScene(const std::string& path)>;

/// What a recording says of its beginning beside the commands.
struct RecordingLooks {
    std::string source; ///< What is recorded, for people.
    CameraPose camera;
    std::vector<Light> lights; ///< As `LoadedScene` has them.
    std::vector<Appearance> appearances;
    std::vector<Visual> visuals{};
};

/// How the viewer's files are written. Either may be empty, and throws as the loader does.
struct Savers {
    /// Makes a recording: `run` does to `world`, which must be told to nobody yet, what is to be recorded. It is called
    /// on a thread of its own.
    std::function<void(const std::filesystem::path& path, const RecordingLooks& looks, World& world,
                       const std::function<void()>& run)>
        recording;
    /// Writes a scene.
    std::function<void(const std::filesystem::path& path, LoadedScene& scene)> scene;
};

/// One line of the viewer's list of scenes.
struct SceneItem {
    std::string path;
    std::string title;
};

} // namespace cairn::viewer
