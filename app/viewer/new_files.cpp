#include "viewer/new_files.h"

#include <ctime>

namespace cairn::viewer {

std::string name_of_now() {
    char name[64];
    const std::time_t now = std::time(nullptr);
    std::strftime(name, sizeof name, "cairn_%Y-%m-%d_%H-%M-%S", std::localtime(&now));
    return name;
}

std::filesystem::path unused_path(const std::filesystem::path& folder, const std::string& name,
                                  const std::string& extension) {
    std::filesystem::path path = folder / (name + extension);
    for (int i = 2; std::filesystem::exists(path); ++i) path = folder / (name + "_" + std::to_string(i) + extension);
    return path;
}

} // namespace cairn::viewer
