#include "cli/outputs.h"

#include "files/output_file.h"

#include <cairn/error.h>

#include <fmt/format.h>

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <map>

namespace cairn::cli {

namespace {

bool standard_output_is_taken = false;

} // namespace

void check_outputs(std::span<const Output> outputs) {
    std::map<std::filesystem::path, std::string_view> taken;
    for (const Output& output : outputs) {
        if (output.path.empty()) continue;
        const files::Destination to = files::destination_of(output.path);
        const bool is_standard_output = files::is_standard_output(output.path);
        if (is_standard_output) standard_output_is_taken = true;
        // Several outputs may share /dev/null.
        if (to.kind == files::Destination::Kind::stream && !is_standard_output) continue;
        std::filesystem::path key = fmt::format("/dev/fd/{}", is_standard_output ? 1 : to.descriptor);
        std::error_code ignored; // on failure the name is used as it is
        if (to.kind == files::Destination::Kind::file)
            key = std::filesystem::weakly_canonical(std::filesystem::absolute(to.path, ignored), ignored);
        const auto [other, is_new] = taken.emplace(std::move(key), output.option);
        if (!is_new) {
            throw Error(ErrorCode::invalid_value, std::string(output.option), output.path.generic_string(),
                        fmt::format("must be another file than that of {}", other->second));
        }
    }
}

bool has_format(const std::filesystem::path& path, std::span<const std::string_view> extensions) {
    if (std::find(extensions.begin(), extensions.end(), files::extension_of(path)) != extensions.end()) return true;
    try {
        return files::destination_of(path).kind != files::Destination::Kind::file;
    } catch (const Error&) { // the error of a file is reported elsewhere
        return false;
    }
}

void print(const std::string& text) {
    if (standard_output_is_taken) {
        files::write_descriptor(STDERR_FILENO, text, "stderr");
    } else {
        files::write_descriptor(STDOUT_FILENO, text, "stdout");
    }
}

bool output_is_on_terminal() { return standard_output_is_taken && isatty(STDOUT_FILENO) == 1; }

namespace {

// Shortens a long text to its beginning and end, cut between UTF-8 characters: a command line may have names of a
// million letters.
std::string shortened(std::string_view text) {
    constexpr std::size_t max_length = 1200;
    if (text.size() <= max_length) return std::string(text);
    const auto continues = [text](std::size_t at) { return (static_cast<unsigned char>(text[at]) & 0xC0u) == 0x80u; };
    std::size_t head = max_length / 2, tail = text.size() - max_length / 2;
    while (head > 0 && continues(head)) --head;
    while (tail < text.size() && continues(tail)) ++tail;
    return std::string(text.substr(0, head)) + " ... " + std::string(text.substr(tail));
}

} // namespace

void complain(std::string_view text) {
    std::string line = "cairn: ";
    for (const char c : shortened(text)) line += static_cast<unsigned char>(c) < ' ' || c == 127 ? ' ' : c;
    while (line.back() == ' ') line.pop_back();
    line += '\n';
    static_cast<void>(std::fwrite(line.data(), 1, line.size(), stderr)); // a failure cannot be reported
}

void print_warnings(std::span<const std::string> warnings) {
    for (const std::string& warning : warnings) complain("warning: " + warning);
}

} // namespace cairn::cli
