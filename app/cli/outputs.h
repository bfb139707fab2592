// Names of output files on the command line, and what is printed beside them.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace cairn::cli {

struct Output {
    std::string_view option;    // "--csv"
    std::filesystem::path path; // empty: not asked for
};

// Before anything runs: whether each can be written, no two are one file, and at most one is standard output. Where one
// is, `print` writes to standard error from now on. Throws Error (io, invalid_value).
void check_outputs(std::span<const Output> outputs);

// Whether the format of a file of that name is known: by its extension, or because it is no regular file (a pipe, a
// device, standard output), which gets the first of them.
bool has_format(const std::filesystem::path& path, std::span<const std::string_view> extensions);

// Prints to stdout, or see `check_outputs`. Throws Error (io) if that fails, for example because the disk is full.
void print(const std::string& text);

// Whether an output file is standard output, and that is a terminal.
bool output_is_on_terminal();

// Prints a line of its own to stderr, after "cairn: "; what is not printable in it becomes a blank. Never fails.
void complain(std::string_view text);

// Prints those of a scene, as `complain` does.
void print_warnings(std::span<const std::string> warnings);

} // namespace cairn::cli
