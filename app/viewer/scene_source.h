/// \file scene_source.h
/// How scenes reach the viewer. The viewer knows nothing of scene files: whoever starts it passes a function.
#pragma once

#include "viewer/camera.h"
#include "viewer/shape_meshes.h"

#include <cairn/cairn.h>

#include <functional>
#include <memory>
#include <string>
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
};

/// A scene, ready to run.
struct LoadedScene {
    World world;
    std::string title;
    std::string hint; ///< One line on what to try.
    CameraPose camera;
    std::optional<Vec3> light;      ///< Unit or not, towards the light; absent: that of every scene.
    float time_step = 1.0f / 60.0f; ///< Seconds of one step, > 0.
    std::vector<Appearance> appearances;
    std::vector<Visual> visuals{};
    std::vector<JointAppearance> strings{};
};

/// Loads the scene of that path. Throws `cairn::Error` (or any std::exception) if it cannot. It is called on the
/// physics thread.
using SceneLoader = std::function<LoadedScene(const std::string& path)>;

/// One line of the viewer's list of scenes.
struct SceneItem {
    std::string path;
    std::string title;
};

} // namespace cairn::viewer
