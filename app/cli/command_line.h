// The commands of the program and their options.
#pragma once

#include "cli/commands.h"

#include <CLI/CLI.hpp>

namespace cairn::cli {

// Parse with `app`, then `execute`.
struct CommandLine {
    CommandLine();
    CommandLine(const CommandLine&) = delete; // `app` refers to the options
    CommandLine& operator=(const CommandLine&) = delete;

    int execute() const; // returns the exit code

    CLI::App app;
    RunOptions run;
    RecordOptions record;
    ReplayOptions replay;
    InfoOptions info;
    DiffOptions diff;
    ScenesOptions scenes;
    ConvertOptions convert;
    SweepOptions sweep;
    FitOptions fit;
    ValidateOptions validate;
    ViewOptions view;
    DoctorOptions doctor;
    CompletionOptions completion;
};

// Prints a completion script for `shell`, generated from the options.
int completion_command(const CompletionOptions& options, const CLI::App& app);

// Prints the manual page, in the macros of man(7).
int manual_command(const CLI::App& app);

// The allowed values of an option or argument; empty if there is no fixed list.
std::vector<std::string> choices_of(const CLI::Option& option);

} // namespace cairn::cli
