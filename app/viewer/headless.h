/// \file headless.h
/// Pictures and videos without a window: OpenGL through EGL's surfaceless platform, so no display is needed.
#pragma once

#include "viewer/gl_renderer.h"
#include "viewer/render_frame.h"

#include "files/output_file.h"

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace cairn::viewer {

/// Extensions of the pictures that `write_picture` knows, with their dots.
std::vector<std::string_view> picture_extensions();

/// Writes 8-bit RGB pixels, top row first, as the extension says: `.jpg` and `.jpeg` as JPEG, else as PNG. Throws
/// `Error` (io) if it cannot; `files/output_file.h` says how a file is written.
void write_picture(const std::filesystem::path& path, int width, int height, std::span<const std::uint8_t> rgb);

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
    /// `scale`: as of `GlRenderer::draw`.
    void draw(const RenderFrame& frame, Smoothing smoothing = Smoothing::samples, float scale = 1.0f);
    /// The last picture drawn: 8-bit RGB, top row first, 3 x width x height bytes.
    const std::vector<std::uint8_t>& pixels() const noexcept;
    /// Saves the last picture drawn. See `write_picture`.
    void save_picture(const std::filesystem::path& path) const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

/// What draws pictures without a window on this machine: the renderer and its version, as OpenGL names them. Throws
/// `Error` (unsupported) with what is missing.
std::string opengl_renderer();

/// Extensions of the videos that `VideoWriter` knows, with their dots.
std::vector<std::string_view> video_extensions();

/// Whether width and height of a video of that name may be odd.
bool takes_odd_sizes(const std::filesystem::path& video);

/// Writes pictures as a video through the program `ffmpeg`, as the extension says: H.264 in `.mp4`, `.mkv` and `.mov`
/// (and where there is no extension), VP9 in `.webm`, and `.gif` with 25 frames a second. The video is written to a
/// temporary file, and gets to `path` when `close` succeeds: `files/output_file.h` says how.
class VideoWriter {
  public:
    /// Size in pixels, both even but for `.gif`; `frames_per_second` > 0. Throws `Error`: `invalid_value` for a bad
    /// size or an unknown extension, `unsupported` if there is no ffmpeg, `io` if the file cannot be written.
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
    void copy_to_stream() const;

    std::filesystem::path path_, temporary_;
    files::Destination to_;
    std::size_t frame_bytes_ = 0;
    int pipe_ = -1;    // file descriptor that ffmpeg reads
    int process_ = -1; // ffmpeg's process id
};

} // namespace cairn::viewer
