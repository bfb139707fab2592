#include "viewer/pages.h"

#include <spawn.h>
#include <sys/wait.h>

#include <array>
#include <system_error>

extern char** environ;

namespace cairn::viewer {

namespace {

#ifdef __APPLE__
constexpr const char* opener = "open";
#else
constexpr const char* opener = "xdg-open";
#endif

// Uses a shell that exits at once, so that the viewer does not wait for the program.
bool open_with_desktop(const std::filesystem::path& file) {
    std::string script = R"(command -v "$1" >/dev/null || exit 1; "$1" "$2" >/dev/null 2>&1 </dev/null &)";
    std::string shell = "sh", option = "-c", program = opener, path = file.string();
    const std::array<char*, 7> arguments{shell.data(),   option.data(), script.data(), shell.data(),
                                         program.data(), path.data(),   nullptr};
    pid_t process = -1;
    if (posix_spawnp(&process, "sh", nullptr, nullptr, arguments.data(), environ) != 0) return false;
    int status = 0;
    return waitpid(process, &status, 0) == process && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

} // namespace

std::string open_page(const std::filesystem::path& folder, const std::string& page) {
    const std::filesystem::path file = folder / page;
    std::error_code code;
    if (folder.empty() || !std::filesystem::is_regular_file(file, code))
        return "docs/" + page + " is not installed here: it is in the source of Cairn.";
    if (open_with_desktop(file)) return "Opening " + file.string();
    return "No program " + std::string(opener) + " to open it: the page is " + file.string();
}

} // namespace cairn::viewer
