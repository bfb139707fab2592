/// \file screen_video.h
/// A video of the window, made while it is used.
#pragma once

#include "viewer/headless.h"

#include <filesystem>
#include <memory>
#include <string>

namespace cairn::viewer {

class ScreenVideo {
  public:
    bool is_running() const { return writer_ != nullptr; }
    /// Begins one, of the lower left `width` x `height` pixels of the window. Throws as `VideoWriter` does.
    void start(const std::filesystem::path& path, int width, int height);
    /// A frame of the window has been drawn, `seconds` after the one before. Ends the video if the window has become
    /// smaller, or the writer fails; the answer is then what to tell, else empty.
    std::string add_frame(double seconds, int width, int height);
    /// Ends it; what to tell.
    std::string stop();

  private:
    std::unique_ptr<VideoWriter> writer_;
    std::filesystem::path path_;
    int width_ = 0, height_ = 0;
    double due_ = 0.0; // frames of the video that have not been written yet
};

} // namespace cairn::viewer
