// Videos through a pipe to the program ffmpeg.
#include "viewer/file_output.h"
#include "viewer/headless.h"

#include <cairn/error.h>

#include <csignal>
#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <string>
#include <system_error>
#include <vector>

extern char** environ;

namespace cairn::viewer {

namespace {

// Starts `arguments` with `input` as its standard input; returns its process id, or -1 with errno set.
int start_process(const std::vector<std::string>& arguments, int input) {
    std::vector<char*> pointers;
    for (const std::string& argument : arguments) pointers.push_back(const_cast<char*>(argument.c_str()));
    pointers.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, input, STDIN_FILENO);
    pid_t process = -1;
    // A process group of its own: Ctrl-C ends the simulation, and ffmpeg finishes the file.
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
    const int error = posix_spawnp(&process, pointers[0], &actions, &attributes, pointers.data(), environ);
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&actions);
    errno = error;
    return error == 0 ? int(process) : -1;
}

// Writes to a pipe without being ended by a signal if its reader is gone. Returns false with errno set.
bool write_to_pipe(int pipe, std::span<const std::uint8_t> bytes) {
    sigset_t broken_pipe, before;
    sigemptyset(&broken_pipe);
    sigaddset(&broken_pipe, SIGPIPE);
    pthread_sigmask(SIG_BLOCK, &broken_pipe, &before);
    int error = 0;
    while (!bytes.empty() && error == 0) {
        const ssize_t written = write(pipe, bytes.data(), bytes.size());
        if (written > 0)
            bytes = bytes.subspan(std::size_t(written));
        else if (errno != EINTR)
            error = errno;
    }
    if (error == EPIPE) {
        const timespec at_once{0, 0};
        sigtimedwait(&broken_pipe, nullptr, &at_once); // take the pending signal before unblocking it
    }
    pthread_sigmask(SIG_SETMASK, &before, nullptr);
    errno = error;
    return error == 0;
}

} // namespace

VideoWriter::VideoWriter(const std::filesystem::path& path, int width, int height, double frames_per_second)
    : path_(path), temporary_(temporary_beside(path)), frame_bytes_(3u * std::size_t(width) * std::size_t(height)) {
    const std::string size = std::to_string(width) + "x" + std::to_string(height);
    if (width < 2 || height < 2 || width % 2 != 0 || height % 2 != 0)
        throw Error(ErrorCode::invalid_value, "VideoWriter size", size, "must be even and at least 2x2 pixels");
    if (!(frames_per_second > 0.0) || !std::isfinite(frames_per_second))
        throw Error(ErrorCode::invalid_value, "VideoWriter frames_per_second", std::to_string(frames_per_second),
                    "must be > 0 and finite");
    make_parent_folder(path);
    std::array<int, 2> ends{-1, -1};
    if (pipe2(ends.data(), O_CLOEXEC) != 0)
        throw Error(ErrorCode::io, path.string(), std::strerror(errno), "needs a pipe to ffmpeg");
    // An absolute path cannot be mistaken for an option or a protocol.
    const std::string output = "file:" + std::filesystem::absolute(temporary_).string();
    process_ = start_process({"ffmpeg",
                              "-loglevel",
                              "error",
                              "-nostats",
                              "-y",
                              "-f",
                              "rawvideo",
                              "-pixel_format",
                              "rgb24",
                              "-video_size",
                              size,
                              "-framerate",
                              std::to_string(frames_per_second),
                              "-i",
                              "pipe:0",
                              "-c:v",
                              "libx264",
                              "-preset",
                              "medium",
                              "-crf",
                              "18",
                              "-pix_fmt",
                              "yuv420p",
                              "-movflags",
                              "+faststart",
                              output},
                             ends[0]);
    const int error = errno;
    ::close(ends[0]);
    if (process_ < 0) {
        ::close(ends[1]);
        throw Error(ErrorCode::unsupported, "ffmpeg", std::strerror(error),
                    "videos need the program ffmpeg (on Debian: package ffmpeg)");
    }
    pipe_ = ends[1];
}

VideoWriter::~VideoWriter() {
    try {
        close();
    } catch (const Error&) {
        // Documented: an error is lost when the writer ends without having been closed.
    }
}

void VideoWriter::add(std::span<const std::uint8_t> rgb) {
    if (rgb.size() != frame_bytes_)
        throw Error(ErrorCode::invalid_value, "VideoWriter.add", std::to_string(rgb.size()),
                    "must be a picture of " + std::to_string(frame_bytes_) + " bytes");
    if (pipe_ < 0) throw Error(ErrorCode::wrong_state, "VideoWriter.add", "", "must not be called after close");
    if (!write_to_pipe(pipe_, rgb))
        throw Error(ErrorCode::io, path_.string(), std::strerror(errno), "ffmpeg stopped reading");
}

void VideoWriter::close() {
    if (pipe_ < 0) return;
    ::close(pipe_);
    pipe_ = -1;
    int status = 0;
    pid_t ended = -1;
    do ended = waitpid(process_, &status, 0);
    while (ended < 0 && errno == EINTR);
    if (ended != process_ || !WIFEXITED(status) || WEXITSTATUS(status) != 0) {
        std::error_code ignored; // ffmpeg's failure is the one to tell
        std::filesystem::remove(temporary_, ignored);
        throw Error(ErrorCode::io, path_.string(), "", "ffmpeg could not write the video (see its message above)");
    }
    take_final_name(temporary_, path_);
}

} // namespace cairn::viewer
