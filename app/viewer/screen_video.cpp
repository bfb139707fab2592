#include "viewer/screen_video.h"

#include "viewer/screen_pixels.h"

#include <cairn/error.h>

#include <algorithm>

namespace cairn::viewer {

namespace {
constexpr double frame_rate = 30.0;
constexpr double longest_pause = 1.0; // s; longer pauses of the window are shortened to this
} // namespace

void ScreenVideo::start(const std::filesystem::path& path, int width, int height) {
    width_ = width & ~1; // the codec requires even sizes
    height_ = height & ~1;
    writer_ = std::make_unique<VideoWriter>(path, width_, height_, frame_rate);
    path_ = path;
    due_ = 0.0;
}

std::string ScreenVideo::add_frame(double seconds, int width, int height) {
    if (!writer_) return {};
    if (width < width_ || height < height_) return "The window is smaller than the video. " + stop();
    due_ += std::min(seconds, longest_pause) * frame_rate;
    if (due_ < 1.0) return {};
    try {
        const std::vector<std::uint8_t> pixels = read_screen(width_, height_);
        for (; due_ >= 1.0; due_ -= 1.0) writer_->add(pixels);
    } catch (const Error& error) {
        writer_.reset();
        return error.what();
    }
    return {};
}

std::string ScreenVideo::stop() {
    const std::unique_ptr<VideoWriter> writer = std::move(writer_);
    try {
        writer->close();
    } catch (const Error& error) {
        return error.what();
    }
    return "Saved " + path_.string();
}

} // namespace cairn::viewer
