// The manual page. Descriptions of commands and options come from the options themselves; the rest is written here.
#include "cli/command_line.h"
#include "cli/outputs.h"

#include <cairn/version.h>

#include <fmt/format.h>

#include <string>
#include <string_view>

namespace cairn::cli {

namespace {

// Escapes plain text for roff.
std::string roff(std::string_view text) {
    std::string result;
    for (const char c : text) {
        if (c == '\\') {
            result += "\\e";
        } else if (c == '-') {
            result += "\\-";
        } else if ((c == '.' || c == '\'') && (result.empty() || result.back() == '\n')) {
            result += std::string("\\&") + c;
        } else {
            result += c;
        }
    }
    return result;
}

// The title of an option: "--seconds" and a placeholder of its value.
std::string title_of(const CLI::Option& option) {
    std::string title = "\\fB" + roff(option.get_name()) + "\\fR";
    if (option.get_lnames().empty()) title = "\\fI" + roff(option.get_name()) + "\\fR";
    if (option.get_lnames().empty() || option.get_items_expected_max() == 0) return title;
    const std::string type = option.get_type_name();
    const bool is_number = type.rfind("FLOAT", 0) == 0 || type.rfind("INT", 0) == 0;
    return title + (is_number ? " \\fINUMBER\\fR" : choices_of(option).empty() ? " \\fIFILE\\fR" : " \\fIWORD\\fR");
}

std::string commands_text(const CLI::App& app) {
    std::string text;
    for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
        text += ".SS cairn " + command->get_name();
        for (const CLI::Option* option :
             command->get_options([](const CLI::Option* o) { return o->get_lnames().empty(); }))
            text += " " + option->get_name();
        text += "\n" + roff(command->get_description()) + "\n";
        for (const CLI::Option* option : command->get_options([](const CLI::Option*) { return true; }))
            text += ".TP\n" + title_of(*option) + "\n" + roff(option->get_description()) + "\n";
    }
    return text;
}

constexpr std::string_view files_text = R"(.SH FILES
The extension of an output file decides its format. A regular file is replaced once its successor is whole; symbolic
links are followed; a file that is not a regular file is written to directly.
.B \-
is standard output, and messages go to standard error then.
.PP
Scenes are glTF files with the drafts KHR_physics_rigid_bodies and KHR_implicit_shapes; models in URDF, MJCF,
SDF and text layers of USD are read too. A scene
is named by a path, or by its name, its number or both:
.BR tower ,
.BR 08 ,
.BR 08_tower .
.SH ENVIRONMENT
.TP
.B CAIRN_SCENES
The folder in which scenes are searched by name.
.TP
.B CAIRN_ISA
The instruction set to use: avx512, avx2, sse2, neon or scalar. Results do not depend on it.
.SH EXIT STATUS
0 on success; 1 for errors, for failed rows of
.B cairn validate
and for incomplete sweeps; 2 for an invalid command line; errors print one line on standard error. A program
whose reader closes the pipe ends by
SIGPIPE. The first interrupt ends a run early, with all of its files; the third ends it at once.
.SH EXAMPLES
.nf
cairn run 13_pile \-\-seconds 10 \-\-json
cairn run welcome \-\-video welcome.mp4 \-\-csv welcome.csv
cairn run tower \-\-csv \- \-\-columns energy | head
cairn run arm.urdf \-\-fixed\-base \-\-floor \-\-targets poses.csv
cairn convert rock.obj rock.gltf \-\-density 2600
cairn sweep plan.json \-\-resume
mpirun \-n 8 cairn sweep plan.json
mpirun \-n 4 cairn run pile
cairn run pile \-\-frames 36000 \-\-csv out.csv \-\-checkpoint ck \-\-resume ck
.fi
)";

} // namespace

int manual_command(const CLI::App& app) {
    std::string names;
    for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
        names += (names.empty() ? "" : " | ") + command->get_name();
    print(fmt::format(".TH CAIRN 1 \"\" \"cairn {}\" \"User Commands\"\n"
                      ".SH NAME\ncairn \\- rigid\\-body physics: simulate, view and measure\n"
                      ".SH SYNOPSIS\n.B cairn\n[\\fB\\-\\-help\\fR] [\\fB\\-\\-version\\fR] {{ {} }} ...\n"
                      ".SH DESCRIPTION\nSimulates scenes of rigid bodies and robots, shows them in a window, writes "
                      "tables, pictures and videos of them, and measures its physics against closed forms.\n"
                      ".SH COMMANDS\n",
                      roff(version_string), names) +
          commands_text(app) + std::string(files_text));
    return 0;
}

} // namespace cairn::cli
