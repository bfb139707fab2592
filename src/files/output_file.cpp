#include "files/output_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstring>
#include <ctime>
#include <optional>
#include <system_error>
#include <utility>

namespace cairn::files {

namespace fs = std::filesystem;

namespace {

constexpr int longest_chain_of_links = 40;          // greatest number of links followed, as in Linux
constexpr std::size_t piece = std::size_t{1} << 16; // bytes written at a time

[[noreturn]] void cannot(const fs::path& path, const std::string& why) {
    throw Error(ErrorCode::io, path.generic_string(), {}, "cannot be written: " + why);
}

// The descriptor that a path in one of the system's descriptor folders refers to.
std::optional<int> descriptor_named(const fs::path& path) {
    const fs::path folder = path.parent_path();
    if (folder != "/dev/fd" && folder != "/proc/self/fd" && folder != "/proc/thread-self/fd") return std::nullopt;
    const std::string name = path.filename().string();
    int number = -1;
    const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), number);
    if (error != std::errc() || end != name.data() + name.size() || number < 0) return std::nullopt;
    return number;
}

void require_folder(const fs::path& path, const fs::path& shown) {
    const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
    std::error_code code;
    const fs::file_status status = fs::status(folder, code);
    if (!fs::exists(status)) cannot(shown, "there is no folder " + folder.generic_string());
    if (!fs::is_directory(status)) cannot(shown, folder.generic_string() + " is no folder");
    if (access(folder.c_str(), W_OK | X_OK) != 0) cannot(shown, std::strerror(errno));
}

// Writes to a descriptor, without termination by SIGPIPE if its reader has gone. Returns the error, or 0.
int write_all(int descriptor, std::string_view bytes) {
    sigset_t broken_pipe, before;
    sigemptyset(&broken_pipe);
    sigaddset(&broken_pipe, SIGPIPE);
    pthread_sigmask(SIG_BLOCK, &broken_pipe, &before);
    int error = 0;
    while (!bytes.empty() && error == 0) {
        const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
        if (written > 0) {
            bytes.remove_prefix(static_cast<std::size_t>(written));
        } else if (written == 0) {
            error = EIO;
        } else if (errno != EINTR) {
            error = errno;
        }
    }
    if (error == EPIPE) {
        const timespec at_once{0, 0};
        sigtimedwait(&broken_pipe, nullptr, &at_once); // removes the pending signal before it is unblocked
    }
    pthread_sigmask(SIG_SETMASK, &before, nullptr);
    return error;
}

} // namespace

ReaderGone::ReaderGone(const std::string& path) : Error(ErrorCode::io, path, {}, "is read by nobody any more") {}

Destination destination_of(const fs::path& path) {
    Destination to;
    if (path.empty()) cannot("\"\"", "it has no name");
    if (path == "-") {
        to.kind = Destination::Kind::descriptor;
        to.descriptor = STDOUT_FILENO;
        return to;
    }
    fs::path at = path;
    std::error_code code;
    for (int links = 0;; ++links) {
        if (const auto number = descriptor_named(fs::absolute(at, code).lexically_normal())) {
            to.kind = Destination::Kind::descriptor;
            to.descriptor = *number;
            return to;
        }
        if (!fs::is_symlink(fs::symlink_status(at, code))) break;
        if (links == longest_chain_of_links) cannot(path, "its links lead in a circle");
        const fs::path target = fs::read_symlink(at, code);
        if (code) cannot(path, code.message());
        at = target.is_absolute() ? target : at.parent_path() / target;
    }
    to.path = at;
    struct stat found {};
    if (stat(path.c_str(), &found) != 0) {
        if (errno != ENOENT && errno != ENOTDIR) cannot(path, std::strerror(errno));
        if (!at.has_filename()) cannot(path, "there is no folder " + at.generic_string());
        require_folder(at, path);
        return to;
    }
    if (S_ISDIR(found.st_mode)) throw Error(ErrorCode::io, path.generic_string(), {}, "is a folder, not a file");
    if (S_ISREG(found.st_mode)) {
        require_folder(at, path);
        return to;
    }
    if (S_ISSOCK(found.st_mode)) cannot(path, "it is a socket");
    if (access(path.c_str(), W_OK) != 0) cannot(path, std::strerror(errno));
    to.kind = Destination::Kind::stream;
    to.path = path; // unresolved, as links in /proc may lead to files without a name
    return to;
}

bool is_standard_output(const fs::path& path) {
    if (path.empty()) return false;
    const Destination to = destination_of(path);
    if (to.kind == Destination::Kind::descriptor) return to.descriptor == STDOUT_FILENO;
    struct stat named {
    }, open{};
    return to.kind == Destination::Kind::stream && stat(to.path.c_str(), &named) == 0 &&
           fstat(STDOUT_FILENO, &open) == 0 && !S_ISCHR(named.st_mode) && named.st_dev == open.st_dev &&
           named.st_ino == open.st_ino;
}

std::string extension_of(const fs::path& path) {
    std::string extension = path.extension().string();
    const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
    std::transform(extension.begin(), extension.end(), extension.begin(), lower);
    return extension;
}

namespace {

fs::path hidden_beside(const fs::path& path, const std::string& mark) {
    constexpr std::size_t longest_stem = 200; // bytes; a whole name may have 255
    std::string name(".");
    name += path.stem().string().substr(0, longest_stem) + "." + mark + path.extension().string();
    return fs::path(path).replace_filename(name);
}

} // namespace

fs::path temporary_beside(const fs::path& path) { return hidden_beside(path, std::to_string(getpid()) + ".part"); }

fs::path unfinished_beside(const fs::path& path) { return hidden_beside(path, "unfinished"); }

void take_name(const fs::path& temporary, const fs::path& path) {
    struct stat before {};
    int error = 0;
    if (stat(path.c_str(), &before) == 0) {
        // Root restores the previous owner; others cannot, and own the file already or from now on.
        const bool is_owned = chown(temporary.c_str(), before.st_uid, before.st_gid) == 0;
        // set-user-ID bits are kept only with the owner
        const mode_t rights = before.st_mode & (is_owned ? 07777u : 0777u);
        if (chmod(temporary.c_str(), rights) != 0) error = errno;
    }
    if (error == 0 && std::rename(temporary.c_str(), path.c_str()) != 0) error = errno;
    if (error == 0) return;
    unlink(temporary.c_str());
    cannot(path, std::strerror(error));
}

void sync_folder(const fs::path& folder) {
    const int file = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (file < 0) cannot(folder, std::strerror(errno));
    const int error = fsync(file) == 0 || errno == EINVAL ? 0 : errno; // not supported by every file system
    ::close(file);
    if (error != 0) cannot(folder, std::strerror(error));
}

void make_parent_folder(const fs::path& path) {
    if (!path.has_parent_path()) return;
    std::error_code error;
    fs::create_directories(path.parent_path(), error);
    if (error) throw Error(ErrorCode::io, path.string(), error.message(), "its folder must exist or be creatable");
}

void OutputFile::open_unfinished(int flags, std::size_t kept) {
    temporary_ = unfinished_beside(to_.path);
    flags |= O_NOFOLLOW;
    const auto take = [&] { // locks are not supported by every file system
        if (file_ < 0 || flock(file_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;
        ::close(std::exchange(file_, -1));
        cannot(path_, "another program is writing " + temporary_.generic_string());
    };
    file_ = open(temporary_.c_str(), flags);
    take();
    if (kept == 0) {
        if (file_ >= 0) ::close(file_);
        unlink(temporary_.c_str()); // left by a program that has ended, or a link placed by somebody
        file_ = open(temporary_.c_str(), flags | O_CREAT | O_EXCL, 0666);
        return take();
    }
    if (file_ < 0) return;
    const off_t end = static_cast<off_t>(kept);
    int error = lseek(file_, 0, SEEK_END) < end ? ENODATA : 0;
    if (error == 0 && (ftruncate(file_, end) != 0 || lseek(file_, end, SEEK_SET) != end)) error = errno;
    if (error == 0) return;
    ::close(std::exchange(file_, -1));
    errno = error;
}

OutputFile::OutputFile(const fs::path& path, Appearance appearance, std::size_t kept)
    : path_(path), to_(destination_of(path)), appearance_(appearance) {
    int flags = O_WRONLY | O_CLOEXEC | O_NOCTTY;
    switch (to_.kind) {
    case Destination::Kind::file:
        if (appearance == Appearance::as_it_grows) {
            file_ = open(to_.path.c_str(), flags | O_CREAT | O_TRUNC, 0666);
            break;
        }
        if (appearance == Appearance::resumable) {
            open_unfinished(flags, kept);
            break;
        }
        temporary_ = temporary_beside(to_.path);
        unlink(temporary_.c_str()); // left by a killed process with the same number, or a link placed by somebody
        flags |= O_CREAT | O_EXCL;
        file_ = open(temporary_.c_str(), flags, 0666);
        break;
    case Destination::Kind::stream:
        file_ = open(to_.path.c_str(), flags); // a signal ends the wait for a reader
        break;
    case Destination::Kind::descriptor:
        file_ = fcntl(to_.descriptor, F_DUPFD_CLOEXEC, 3);
        break;
    }
    if (file_ < 0) cannot(path_, std::strerror(errno));
}

OutputFile::~OutputFile() {
    if (file_ < 0) return;
    ::close(file_);
    remove_temporary();
}

void OutputFile::remove_temporary() const {
    if (!temporary_.empty() && appearance_ != Appearance::resumable) unlink(temporary_.c_str());
}

void OutputFile::fail(int error) {
    if (file_ >= 0) ::close(file_);
    file_ = -1;
    remove_temporary();
    if (error == EPIPE) throw ReaderGone(path_.generic_string());
    cannot(path_, std::strerror(error));
}

void OutputFile::send(std::string_view bytes) {
    if (const int error = write_all(file_, bytes); error != 0) fail(error);
}

void OutputFile::write(std::string_view bytes) {
    if (file_ < 0) throw Error(ErrorCode::wrong_state, path_.generic_string(), {}, "is closed");
    if (is_stream() || appearance_ == Appearance::as_it_grows) return send(bytes);
    waiting_ += bytes;
    if (waiting_.size() < piece) return;
    send(waiting_);
    waiting_.clear();
}

void OutputFile::overwrite(std::size_t offset, std::string_view bytes) {
    if (file_ < 0 || is_stream()) throw Error(ErrorCode::wrong_state, path_.generic_string(), {}, "is no open file");
    send(std::exchange(waiting_, {}));
    while (!bytes.empty()) {
        const ssize_t written = pwrite(file_, bytes.data(), bytes.size(), static_cast<off_t>(offset));
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) fail(written < 0 ? errno : EIO);
        offset += static_cast<std::size_t>(written);
        bytes.remove_prefix(static_cast<std::size_t>(written));
    }
}

void OutputFile::sync() {
    if (file_ < 0) throw Error(ErrorCode::wrong_state, path_.generic_string(), {}, "is closed");
    send(std::exchange(waiting_, {}));
    if (is_stream()) return;
    if (fsync(file_) != 0 && errno != EINVAL) fail(errno); // not supported by every file system
}

void OutputFile::close() {
    if (file_ < 0) return;
    send(std::exchange(waiting_, {}));
    if (::close(std::exchange(file_, -1)) != 0) fail(errno);
    if (!temporary_.empty()) take_name(temporary_, to_.path);
}

void write_file(const fs::path& path, std::string_view bytes) {
    OutputFile file(path);
    file.write(bytes);
    file.close();
}

void write_descriptor(int descriptor, std::string_view bytes, const std::string& name) {
    const int error = write_all(descriptor, bytes);
    if (error == EPIPE) throw ReaderGone(name);
    if (error != 0) throw Error(ErrorCode::io, name, {}, std::string("cannot be written: ") + std::strerror(error));
}

} // namespace cairn::files
