/// \file screen_video.h
/// Screen recording of the window as a video.
#pragma once

#include "viewer/headless.h"

#include <filesystem>
#include <memory>
#include <string>

namespace cairn::viewer {

class ScreenVideo {
  public:
    bool is_running() const { return writer_ != nullptr; }
    /// Starts a video of the lower left `width` x `height` pixels of the window. Throws as `VideoWriter` does.
    void start(const std::filesystem::path& path, int width, int height);
    /// Adds the drawn frame, `seconds` after the previous one. Ends the video if the window has become smaller or the
    /// writer fails; then returns a message, else an empty string.
    std::string add_frame(double seconds, int width, int height);
    /// Ends the video; returns a message.
    std::string stop();

  private:
    std::unique_ptr<VideoWriter> writer_;
    std::filesystem::path path_;
    int width_ = 0, height_ = 0;
    double due_ = 0.0; // video frames due but not written yet
};

} // namespace cairn::viewer
