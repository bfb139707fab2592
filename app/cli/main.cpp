// The `cairn` command: parses the command line and runs the command. A usage error ends with one line on stderr and
// exit code 2, an error at run time with one line and exit code 1.
#include "cli/activity.h"
#include "cli/command_line.h"
#include "cli/outputs.h"
#include "files/output_file.h"

#include <fmt/format.h>

#include <csignal>
#include <exception>
#include <new>
#include <sstream>
#include <string>

namespace {

constexpr int failed = 1, called_wrongly = 2;

int fail(const std::string& text, int code) {
    cairn::cli::complain(text);
    return code;
}

// Ends quietly by SIGPIPE, as usual for programs that write to a pipe without a reader. All files are closed.
int end_without_reader() {
    std::signal(SIGPIPE, SIG_DFL);
    std::raise(SIGPIPE);
    return 128 + SIGPIPE; // if the signal is blocked
}

// Prints the help, or the version for --version.
int print_help(const CLI::App& app, const CLI::ParseError& error) {
    std::ostringstream text;
    app.exit(error, text, text);
    cairn::cli::print(text.str());
    return 0;
}

int run(int argc, char** argv) {
    cairn::cli::CommandLine line;
    CLI::App& app = line.app;
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) return print_help(app, error);
        if (argc > 1 && argv[1][0] != '-' && app.get_subcommands().empty()) {
            return fail(fmt::format("there is no command \"{}\" (see cairn --help)", argv[1]), called_wrongly);
        }
        return fail(std::string(error.what()) + " (see cairn --help)", called_wrongly);
    }
    return line.execute();
}

} // namespace

int main(int argc, char** argv) {
    std::signal(SIGPIPE, SIG_IGN); // write errors report it instead
    std::signal(SIGXFSZ, SIG_IGN); // likewise, where the file size is limited
    cairn::cli::prepare_for_out_of_memory();
    try {
        return run(argc, argv);
    } catch (const std::bad_alloc&) {
        cairn::cli::report_out_of_memory();
        return failed;
    } catch (const cairn::files::ReaderGone&) {
        return end_without_reader();
    } catch (const std::exception& error) {
        return fail(error.what(), failed);
    }
}
