// Video encoding through a pipe to the program ffmpeg.
#include "viewer/headless.h"

#include "files/output_file.h"

#include <cairn/error.h>

#include <csignal>
#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <string>
#include <string_view>
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
    // A process group of its own, so that Ctrl-C ends only the simulation, and ffmpeg finishes the file.
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    // This program ignores SIGPIPE; ffmpeg gets the default behavior.
    sigset_t broken_pipe;
    sigemptyset(&broken_pipe);
    sigaddset(&broken_pipe, SIGPIPE);
    posix_spawnattr_setsigdefault(&attributes, &broken_pipe);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGDEF);
    const int error = posix_spawnp(&process, pointers[0], &actions, &attributes, pointers.data(), environ);
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&actions);
    errno = error;
    return error == 0 ? int(process) : -1;
}

struct Codec {
    std::string_view extension;
    std::vector<const char*> options;
    bool any_size = false; // allows odd sizes
};

// GIF has a time resolution of 1/100 s, and 256 colors, chosen for each picture.
const std::vector<Codec>& codecs() {
    static const std::vector<const char*> h264{"-c:v", "libx264", "-preset",  "medium",
                                               "-crf", "18",      "-pix_fmt", "yuv420p"};
    static const std::vector<Codec> list{
        {".mp4", h264},
        {".mkv", h264},
        {".mov", h264},
        {".webm",
         {"-c:v", "libvpx-vp9", "-crf", "24", "-b:v", "0", "-cpu-used", "4", "-row-mt", "1", "-pix_fmt", "yuv420p"}},
        {".gif",
         {"-filter_complex", "fps=25,split[a][b];[a]palettegen=stats_mode=single[p];[b][p]paletteuse=new=1"},
         true}};
    return list;
}

const Codec* codec_of(std::string_view extension) {
    const auto found = std::find_if(codecs().begin(), codecs().end(),
                                    [&](const Codec& codec) { return codec.extension == extension; });
    return found == codecs().end() ? nullptr : &*found;
}

// Format for a name without an extension, for example a pipe.
constexpr std::string_view default_extension = ".mp4";

std::string video_extension(const std::filesystem::path& path) {
    const std::string extension = files::extension_of(path);
    return extension.empty() || path == "-" ? std::string(default_extension) : extension;
}

// The file that ffmpeg writes: beside the destination file, or in the temporary folder if the destination cannot be
// written out of order.
std::filesystem::path working_file(const files::Destination& to, const std::string& extension) {
    if (to.kind == files::Destination::Kind::file) {
        return files::temporary_beside(std::filesystem::path(to.path).replace_extension(extension));
    }
    return files::temporary_beside(std::filesystem::temp_directory_path() / ("cairn_video" + extension));
}

} // namespace

std::vector<std::string_view> video_extensions() {
    std::vector<std::string_view> list;
    for (const Codec& codec : codecs()) list.push_back(codec.extension);
    return list;
}

bool takes_odd_sizes(const std::filesystem::path& video) {
    const Codec* codec = codec_of(video_extension(video));
    return codec != nullptr && codec->any_size;
}

VideoWriter::VideoWriter(const std::filesystem::path& path, int width, int height, double frames_per_second)
    : path_(path), to_(files::destination_of(path)), frame_bytes_(3u * std::size_t(width) * std::size_t(height)) {
    const std::string size = std::to_string(width) + "x" + std::to_string(height);
    const std::string extension = video_extension(path);
    const Codec* codec = codec_of(extension);
    if (codec == nullptr)
        throw Error(ErrorCode::invalid_value, "VideoWriter path", path.string(), "must have a known extension");
    if (width < 2 || height < 2 || (!codec->any_size && (width % 2 != 0 || height % 2 != 0)))
        throw Error(ErrorCode::invalid_value, "VideoWriter size", size, "must be even and at least 2x2 pixels");
    if (!(frames_per_second > 0.0) || !std::isfinite(frames_per_second))
        throw Error(ErrorCode::invalid_value, "VideoWriter frames_per_second", std::to_string(frames_per_second),
                    "must be > 0 and finite");
    temporary_ = working_file(to_, extension);
    std::array<int, 2> ends{-1, -1};
    if (pipe2(ends.data(), O_CLOEXEC) != 0)
        throw Error(ErrorCode::io, path.string(), std::strerror(errno), "needs a pipe to ffmpeg");
    std::vector<std::string> arguments{"ffmpeg",
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
                                       "pipe:0"};
    arguments.insert(arguments.end(), codec->options.begin(), codec->options.end());
    if (extension == ".mp4" || extension == ".mov") arguments.insert(arguments.end(), {"-movflags", "+faststart"});
    // An absolute path cannot be mistaken for an option or a protocol.
    arguments.push_back("file:" + std::filesystem::absolute(temporary_).string());
    process_ = start_process(arguments, ends[0]);
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
        // Errors of an unclosed writer are ignored, as documented.
    }
}

void VideoWriter::add(std::span<const std::uint8_t> rgb) {
    if (rgb.size() != frame_bytes_)
        throw Error(ErrorCode::invalid_value, "VideoWriter.add", std::to_string(rgb.size()),
                    "must be a picture of " + std::to_string(frame_bytes_) + " bytes");
    if (pipe_ < 0) throw Error(ErrorCode::wrong_state, "VideoWriter.add", "", "must not be called after close");
    try {
        files::write_descriptor(pipe_, {reinterpret_cast<const char*>(rgb.data()), rgb.size()}, path_.string());
    } catch (const files::ReaderGone&) { // ffmpeg has printed the reason
        throw Error(ErrorCode::io, path_.string(), {}, "cannot be written: ffmpeg stopped reading");
    }
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
        std::error_code ignored; // ffmpeg's failure is the error to report
        std::filesystem::remove(temporary_, ignored);
        throw Error(ErrorCode::io, path_.string(), "", "ffmpeg could not write the video (see its message above)");
    }
    if (to_.kind == files::Destination::Kind::file) return files::take_name(temporary_, to_.path);
    try {
        copy_to_stream();
    } catch (...) {
        unlink(temporary_.c_str());
        throw;
    }
    unlink(temporary_.c_str());
}

void VideoWriter::copy_to_stream() const {
    std::ifstream whole(temporary_, std::ios::binary);
    files::OutputFile stream(path_);
    std::string piece(std::size_t{1} << 16, '\0');
    while (whole.read(piece.data(), std::streamsize(piece.size())) || whole.gcount() > 0)
        stream.write(std::string_view(piece).substr(0, std::size_t(whole.gcount())));
    if (whole.bad()) throw Error(ErrorCode::io, temporary_.string(), {}, "cannot be read");
    stream.close();
}

} // namespace cairn::viewer
