// Output files given on the command line, and printed messages.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace cairn::cli {

struct Output {
    std::string_view option;    // "--csv"
    std::filesystem::path path; // empty: not requested
};

// Checks before the run that each output can be written, that no two are the same file, and that at most one is
// standard output; if one is, `print` writes to standard error from then on. Throws Error (io, invalid_value).
void check_outputs(std::span<const Output> outputs);

// Whether the format of a file is known: by its extension, or because it is not a regular file (a pipe, a device,
// standard output), which gets the first format.
bool has_format(const std::filesystem::path& path, std::span<const std::string_view> extensions);

// Prints to stdout, or to stderr (see `check_outputs`). Throws Error (io) on failure, for example if the disk is full.
void print(const std::string& text);

// Whether an output file is standard output, connected to a terminal.
bool output_is_on_terminal();

// Prints one line to stderr, after "cairn: ", with spaces in place of control characters. Never fails.
void complain(std::string_view text);

// Prints the warnings of a scene by `complain`.
void print_warnings(std::span<const std::string> warnings);

} // namespace cairn::cli
