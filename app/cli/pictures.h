// Pictures and a video of a run, rendered without a window.
#pragma once

#include "scene/scene.h"
#include "viewer/headless.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

namespace cairn::cli {

// Records pictures and a video. Files are completed by `finish`; an unfinished video is removed.
class PictureRecorder {
  public:
    // Either path may be empty. Throws Error: `unsupported` without EGL or ffmpeg, `io`, `invalid_value`.
    PictureRecorder(const scene::Scene& scene, std::filesystem::path png, const std::filesystem::path& video, int width,
                    int height);

    // To be called at the first recorded moment, and after each later step: renders frames as needed for a video of 60
    // frames per second, for any step length.
    void add(const World& world);
    // Renders the final picture, and closes the files.
    void finish(const World& world);

  private:
    void draw(const World& world);

    std::filesystem::path png_;
    std::vector<viewer::Visual> visuals_;
    std::vector<viewer::JointAppearance> strings_;
    viewer::CameraPose camera_;
    viewer::FrameOptions options_;
    bool has_camera_; // the scene defines a camera
    std::vector<viewer::Appearance> appearances_;
    viewer::MeshCache meshes_;
    viewer::HeadlessRenderer renderer_;
    std::unique_ptr<viewer::VideoWriter> video_;
    std::optional<double> start_; // time of the first frame
    long long frames_ = 0;
};

} // namespace cairn::cli
