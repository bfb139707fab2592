/// \file headless.h
/// Pictures and videos without a window: OpenGL through EGL's surfaceless platform, so no display is needed.
#pragma once

#include "viewer/render_frame.h"

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <span>
#include <vector>

namespace cairn::viewer {

/// Writes 8-bit RGB pixels, top row first, as PNG: to a temporary file beside `path` first, which then takes its
/// name. Makes missing folders. Throws `Error` (io) if it cannot.
void write_png(const std::filesystem::path& path, int width, int height, std::span<const std::uint8_t> rgb);

/// Draws frames into memory, with an OpenGL context of its own. Use it on the thread that made it; there may be
/// several on one thread.
class HeadlessRenderer {
  public:
    /// Width and height in pixels, 16 to 8192. Throws `Error`: `invalid_value` for a size out of range,
    /// `unsupported` if this machine has no EGL or OpenGL 3.3.
    explicit HeadlessRenderer(int width = 1280, int height = 720);
    ~HeadlessRenderer();
    HeadlessRenderer(const HeadlessRenderer&) = delete;
    HeadlessRenderer& operator=(const HeadlessRenderer&) = delete;

    int width() const noexcept;
    int height() const noexcept;
    void draw(const RenderFrame& frame);
    /// The last picture drawn: 8-bit RGB, top row first, 3 x width x height bytes.
    const std::vector<std::uint8_t>& pixels() const noexcept;
    /// Saves the last picture drawn. See `write_png`.
    void save_png(const std::filesystem::path& path) const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

/// Writes pictures as an H.264 video through the program `ffmpeg`. The video is written to a temporary file
/// beside `path`, which takes its name when `close` succeeds.
class VideoWriter {
  public:
    /// Size in pixels, both even; `frames_per_second` > 0. Throws `Error`: `invalid_value` for a bad size,
    /// `unsupported` if there is no ffmpeg, `io` if the file cannot be written.
    VideoWriter(const std::filesystem::path& path, int width, int height, double frames_per_second = 60.0);
    /// Closes, if that was not done; an error is lost then.
    ~VideoWriter();
    VideoWriter(const VideoWriter&) = delete;
    VideoWriter& operator=(const VideoWriter&) = delete;

    /// Appends one picture: 8-bit RGB, top row first, 3 x width x height bytes. Throws `Error` (io).
    void add(std::span<const std::uint8_t> rgb);
    /// Finishes the file. Throws `Error` (io) if ffmpeg failed. Further calls do nothing.
    void close();

  private:
    std::filesystem::path path_, temporary_;
    std::size_t frame_bytes_ = 0;
    int pipe_ = -1;    // file descriptor that ffmpeg reads
    int process_ = -1; // ffmpeg's process id
};

} // namespace cairn::viewer
