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

/// Extensions of the picture formats that `write_picture` supports, with their dots.
std::vector<std::string_view> picture_extensions();

/// Writes 8-bit RGB pixels, top row first, in the format of the extension: JPEG for `.jpg` and `.jpeg`, else PNG.
/// Throws `Error` (io) on failure; `files/output_file.h` says how a file is written.
void write_picture(const std::filesystem::path& path, int width, int height, std::span<const std::uint8_t> rgb);

/// Renders frames into memory with an OpenGL context of its own. Use it on the thread that created it; one thread may
/// have several.
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
    /// `scale`: as in `GlRenderer::draw`.
    void draw(const RenderFrame& frame, Smoothing smoothing = Smoothing::samples, float scale = 1.0f);
    /// The last picture drawn: 8-bit RGB, top row first, 3 x width x height bytes.
    const std::vector<std::uint8_t>& pixels() const noexcept;
    /// Saves the last picture drawn. See `write_picture`.
    void save_picture(const std::filesystem::path& path) const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

/// The renderer that this machine uses without a window, and its version, as OpenGL names them. Throws `Error`
/// (unsupported) with the missing part.
std::string opengl_renderer();

/// Extensions of the video formats that `VideoWriter` supports, with their dots.
std::vector<std::string_view> video_extensions();

/// Whether width and height of a video of that name may be odd.
bool takes_odd_sizes(const std::filesystem::path& video);

/// Encodes pictures as a video by the program `ffmpeg`, in the format of the extension: H.264 in `.mp4`, `.mkv` and
/// `.mov` (and without an extension), VP9 in `.webm`, and `.gif` with 25 frames per second. The video is written to a
/// temporary file, which `close` moves to `path`; `files/output_file.h` says how.
class VideoWriter {
  public:
    /// Size in pixels, both even except for `.gif`; `frames_per_second` > 0. Throws `Error`: `invalid_value` for a bad
    /// size or an unknown extension, `unsupported` if there is no ffmpeg, `io` if the file cannot be written.
    VideoWriter(const std::filesystem::path& path, int width, int height, double frames_per_second = 60.0);
    /// Calls `close` if that was not done; errors are then ignored.
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
