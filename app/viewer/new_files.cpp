#include "viewer/new_files.h"

#include <cstdlib>
#include <ctime>
#include <system_error>

namespace cairn::viewer {

std::string name_of_now() {
    char name[64];
    const std::time_t now = std::time(nullptr);
    std::strftime(name, sizeof name, "cairn_%Y-%m-%d_%H-%M-%S", std::localtime(&now));
    return name;
}

std::filesystem::path layout_file() {
    const char *folder = std::getenv("XDG_CONFIG_HOME"), *home = std::getenv("HOME");
    std::filesystem::path path;
    if (folder && folder[0] == '/')
        path = folder; // relative paths shall be ignored (XDG Base Directory Specification)
    else if (home && home[0] == '/')
        path = std::filesystem::path(home) / ".config";
    else
        return {};
    path /= "cairn";
    std::error_code error;
    std::filesystem::create_directories(path, error);
    return error ? std::filesystem::path() : path / "viewer_windows.ini";
}

std::filesystem::path unused_path(const std::filesystem::path& folder, const std::string& name,
                                  const std::string& extension) {
    std::filesystem::path path = folder / (name + extension);
    for (int i = 2; std::filesystem::exists(path); ++i) path = folder / (name + "_" + std::to_string(i) + extension);
    return path;
}

} // namespace cairn::viewer
