#include "viewer/file_output.h"

#include <cairn/error.h>

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <string>
#include <system_error>

namespace cairn::viewer {

namespace fs = std::filesystem;

fs::path temporary_beside(const fs::path& path) {
    // Keeps the extension: ffmpeg chooses the container by it.
    std::string name(".");
    name += path.stem().string() + "." + std::to_string(getpid()) + ".part" + path.extension().string();
    return fs::path(path).replace_filename(name);
}

void make_parent_folder(const fs::path& path) {
    if (!path.has_parent_path()) return;
    std::error_code error;
    fs::create_directories(path.parent_path(), error);
    if (error) throw Error(ErrorCode::io, path.string(), error.message(), "its folder must exist or be creatable");
}

void take_final_name(const fs::path& temporary, const fs::path& path) {
    std::error_code error;
    fs::rename(temporary, path, error);
    if (!error) return;
    std::error_code ignored; // the first error is the one to tell
    fs::remove(temporary, ignored);
    throw Error(ErrorCode::io, path.string(), {}, "cannot be written: " + error.message());
}

void write_file(const fs::path& path, std::string_view content) {
    make_parent_folder(path);
    const fs::path temporary = temporary_beside(path);
    errno = 0;
    std::ofstream file(temporary, std::ios::binary | std::ios::trunc);
    if (file) file.write(content.data(), std::streamsize(content.size()));
    if (file) file.close();
    if (!file) {
        const std::string reason = errno != 0 ? std::strerror(errno) : "write failed";
        std::error_code ignored;
        fs::remove(temporary, ignored);
        throw Error(ErrorCode::io, path.string(), {}, "cannot be written: " + reason);
    }
    take_final_name(temporary, path);
}

} // namespace cairn::viewer
