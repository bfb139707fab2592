#include "cli/commands.h"
#include "cli/outputs.h"

#include "viewer/headless.h"

#include <cairn/version.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>

namespace cairn::cli {

namespace {

// The output of a shell command; empty if it fails.
std::string output_of(const char* line) {
    std::FILE* pipe = popen(line, "r");
    if (pipe == nullptr) return {};
    std::string text;
    std::array<char, 4096> piece{};
    while (const std::size_t count = std::fread(piece.data(), 1, piece.size(), pipe)) text.append(piece.data(), count);
    return pclose(pipe) == 0 ? text : std::string();
}

std::string processor() {
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);) {
        const std::size_t colon = line.find(": ");
        if (line.substr(0, 10) == "model name" && colon != std::string::npos) return line.substr(colon + 2);
    }
    return "unknown";
}

std::string variable(const char* name) {
    const char* value = std::getenv(name);
    return value == nullptr ? std::string() : std::string(value);
}

struct Finding {
    const char* name; // key in JSON
    std::string text;
    bool is_lacking = false; // some function is unavailable without it
};

Finding kernels() {
    std::string text = fmt::format("{} used of {} compiled", instruction_set(), CAIRN_KERNELS);
    if (const std::string forced = variable("CAIRN_ISA"); !forced.empty()) text += ", CAIRN_ISA=" + forced;
    return {"kernels", std::move(text)};
}

Finding opengl() {
    try {
        return {"opengl", viewer::opengl_renderer()};
    } catch (const Error& error) {
        return {"opengl", std::string("none, so no pictures and videos: ") + error.what(), true};
    }
}

Finding display() {
    for (const char* name : {"WAYLAND_DISPLAY", "DISPLAY"}) {
        if (const std::string value = variable(name); !value.empty())
            return {"display", fmt::format("{}={}", name, value)};
    }
    return {"display", "none, so no cairn view: neither DISPLAY nor WAYLAND_DISPLAY is set", true};
}

Finding ffmpeg() {
    const std::string version = output_of("ffmpeg -version 2>/dev/null");
    if (version.empty()) return {"ffmpeg", "none, so no videos (on Debian: package ffmpeg)", true};
    std::string text = version.substr(0, version.find(" Copyright"));
    text = text.substr(0, text.find('\n'));
    const std::string encoders = output_of("ffmpeg -hide_banner -encoders 2>/dev/null");
    bool lacks = false;
    for (const auto& [encoder, files] : {std::pair("libx264", ".mp4, .mkv, .mov"), std::pair("libvpx-vp9", ".webm")}) {
        if (encoders.find(encoder) != std::string::npos) continue;
        text += fmt::format(", without {}: no {}", encoder, files);
        lacks = true;
    }
    return {"ffmpeg", std::move(text), lacks};
}

Finding scenes() {
    try {
        const std::filesystem::path folder = scene::scenes_directory();
        return {"scenes", fmt::format("{} in {}", scene::scene_files(folder).size(), folder.generic_string())};
    } catch (const Error& error) {
        return {"scenes", std::string("none: ") + error.what(), true};
    }
}

} // namespace

int doctor_command(const DoctorOptions& options) {
    const std::vector<Finding> findings{
        {"cairn", fmt::format("{}, built by {}, {}", version_string, CAIRN_COMPILER, CAIRN_BUILD_TYPE)},
        {"processor", processor()},
        kernels(),
        {"threads", fmt::format("{}", hardware_threads())},
        opengl(),
        display(),
        ffmpeg(),
        scenes()};
    if (options.json) {
        nlohmann::ordered_json json;
        for (const Finding& finding : findings) json[finding.name] = finding.text;
        json["lacking"] = nlohmann::ordered_json::array();
        for (const Finding& finding : findings) {
            if (finding.is_lacking) json["lacking"].push_back(finding.name);
        }
        print(json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n");
        return 0;
    }
    std::string text;
    for (const Finding& finding : findings)
        text += fmt::format("{} {:<10} {}\n", finding.is_lacking ? "-" : "+", finding.name, finding.text);
    print(text);
    return 0;
}

} // namespace cairn::cli
