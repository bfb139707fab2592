#include "cli/pictures.h"

#include "cli/viewer_scene.h"

#include <utility>

namespace cairn::cli {

namespace {

constexpr double frames_per_second = 60.0;
// Times are sums of steps: a frame due within this tolerance is rendered now.
constexpr double tolerance = 1e-6;

} // namespace

PictureRecorder::PictureRecorder(const scene::Scene& scene, std::filesystem::path png,
                                 const std::filesystem::path& video, int width, int height)
    : png_(std::move(png)), visuals_(visuals_of(scene)), strings_(strings_of(scene)),
      camera_(camera_of(scene, visuals_)), has_camera_(scene.info.camera.has_value()),
      appearances_(appearances_of(scene)), renderer_(width, height) {
    options_.lighting = viewer::lighting_of(lights_of(scene), camera_.target);
    if (!video.empty()) video_ = std::make_unique<viewer::VideoWriter>(video, width, height, frames_per_second);
}

void PictureRecorder::draw(const World& world) {
    renderer_.draw(viewer::make_frame(world, appearances_, camera_, options_, meshes_, visuals_, strings_));
}

void PictureRecorder::add(const World& world) {
    if (!video_) return;
    if (!start_) start_ = world.time();
    const double time = world.time() - *start_;
    if (time + tolerance < static_cast<double>(frames_) / frames_per_second) return;
    draw(world);
    for (; time + tolerance >= static_cast<double>(frames_) / frames_per_second; ++frames_) {
        video_->add(renderer_.pixels());
    }
}

void PictureRecorder::finish(const World& world) {
    if (!png_.empty()) {
        // Without a video, the beginning is not seen, so the default camera is fitted to the final state.
        if (!has_camera_ && !video_) camera_ = viewer::fit_camera(world, visuals_);
        draw(world);
        renderer_.save_picture(png_);
    }
    if (video_) video_->close();
}

} // namespace cairn::cli
