// Pictures and a video of a run, drawn without a window.
#pragma once

#include "scene/scene.h"
#include "viewer/headless.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

namespace cairn::cli {

// Files are finished by `finish`; a video that was not is removed.
class PictureRecorder {
  public:
    // Either path may be empty. Throws Error: `unsupported` without EGL or ffmpeg, `io`, `invalid_value`.
    PictureRecorder(const scene::Scene& scene, std::filesystem::path png, const std::filesystem::path& video, int width,
                    int height);

    // To be called at the first moment to be shown, and after each step from there: draws as often as a video of 60
    // frames a second needs, however long the steps are.
    void add(const World& world);
    // Draws the picture of the end, and closes the files.
    void finish(const World& world);

  private:
    void draw(const World& world);

    std::filesystem::path png_;
    std::vector<viewer::Visual> visuals_;
    std::vector<viewer::JointAppearance> strings_;
    viewer::CameraPose camera_;
    viewer::FrameOptions options_;
    bool has_camera_; // of the scene's own
    std::vector<viewer::Appearance> appearances_;
    viewer::MeshCache meshes_;
    viewer::HeadlessRenderer renderer_;
    std::unique_ptr<viewer::VideoWriter> video_;
    std::optional<double> start_; // of the first picture
    long long frames_ = 0;
};

} // namespace cairn::cli
