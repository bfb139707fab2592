// The commands and their options, as they stand on the command line.
#pragma once

#include "cli/commands.h"

#include <CLI/CLI.hpp>

namespace cairn::cli {

// Parse with `app`, then `execute`.
struct CommandLine {
    CommandLine();
    CommandLine(const CommandLine&) = delete; // `app` refers to the options
    CommandLine& operator=(const CommandLine&) = delete;

    int execute() const; // the exit code

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

// What completes the command line in `shell`, made of the options themselves.
int completion_command(const CompletionOptions& options, const CLI::App& app);

// The manual page, in the macros of man(7).
int manual_command(const CLI::App& app);

// The words that an option or an argument may be; empty if there is no list of them.
std::vector<std::string> choices_of(const CLI::Option& option);

} // namespace cairn::cli
