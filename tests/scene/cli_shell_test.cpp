// Information about the program itself: the doctor command, the manual page, and shell completion.
#include "cli_program.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

namespace {

using namespace cairn::test;

class CliShell : public Cli {
  protected:
    // The completions that bash offers for a command line whose last word is incomplete.
    std::vector<std::string> completed(const std::string& words) const {
        const Result result = shell("eval \"$(\"$CAIRN\" completion bash)\"; COMP_WORDS=(" + words +
                                    "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _cairn \"$CAIRN\" 2>/dev/null; "
                                    "printf '%s\\n' \"${COMPREPLY[@]}\"");
        EXPECT_EQ(result.code, 0) << result.err;
        std::istringstream lines(result.out);
        std::vector<std::string> replies;
        for (std::string line; std::getline(lines, line);) {
            if (!line.empty()) replies.push_back(line);
        }
        return replies;
    }
    bool has(const std::string& program) const { return shell("command -v " + program).code == 0; }
};

using Words = std::vector<std::string>;

TEST_F(CliShell, BashCompletesCommandsOptionsValuesScenesAndFiles) {
    EXPECT_EQ(completed("cairn com"), Words{"completion"});
    EXPECT_EQ(completed("cairn run --inte"), Words{"--integrator"});
    EXPECT_EQ(completed("cairn run x --integrator ''"), (Words{"semi-implicit", "explicit", "rk4"}));
    EXPECT_EQ(completed("cairn completion z"), Words{"zsh"});
    EXPECT_EQ(completed("cairn run 08"), Words{"08_tower"});
    EXPECT_EQ(completed("cairn validate --case pend"), Words{"pendulum"});
    shell("touch '08 my own.gltf'");
    EXPECT_EQ(completed("cairn view 08"), (Words{"08 my own.gltf", "08_tower"}));
    EXPECT_EQ(completed("cairn run x --csv 08"), Words{}); // files are left to readline's own completion
    EXPECT_EQ(completed("cairn run x --seconds ''"), Words{});
    EXPECT_EQ(completed("cairn fly --"), Words{});
}

TEST_F(CliShell, EveryOptionIsInAllOfThemAndInTheManual) {
    const std::string bash = cairn("completion bash").out, zsh = cairn("completion zsh").out,
                      fish = cairn("completion fish").out, manual = cairn("manual").out;
    int options = 0;
    for (const char* command :
         {"run", "view", "scenes", "convert", "sweep", "fit", "validate", "doctor", "completion"}) {
        std::istringstream help(cairn(std::string(command) + " --help").out);
        EXPECT_NE(manual.find(std::string(".SS cairn ") + command), std::string::npos);
        for (std::string line; std::getline(help, line);) {
            const std::size_t at = line.find("  --");
            if (at == std::string::npos || at > 2) continue;
            const std::string name = line.substr(at + 4, line.find_first_of(" ,", at + 4) - at - 4);
            EXPECT_NE(bash.find("--" + name), std::string::npos) << name;
            EXPECT_NE(zsh.find("'--" + name + "["), std::string::npos) << name;
            EXPECT_NE(fish.find(" -l " + name + " "), std::string::npos) << name;
            ++options;
            std::string escaped;
            for (const char c : "--" + name) {
                if (c == '-') escaped += '\\';
                escaped += c;
            }
            EXPECT_NE(manual.find(escaped), std::string::npos) << escaped;
        }
    }
    EXPECT_GT(options, 35);
    expect_one_line(cairn("completion tcsh"), 2, "must be one of bash, zsh, fish, got tcsh");
}

TEST_F(CliShell, ShellsAndManReadThem) {
    EXPECT_EQ(shell("\"$CAIRN\" completion bash >c; bash -n c").code, 0);
    if (has("zsh")) {
        EXPECT_EQ(shell("\"$CAIRN\" completion zsh >c; zsh -n c").code, 0);
    }
    if (has("fish")) {
        EXPECT_EQ(shell("\"$CAIRN\" completion fish >c; fish -n c").code, 0);
    }
    if (has("man")) {
        const Result page = shell("\"$CAIRN\" manual >cairn.1; LC_ALL=C man --warnings -l ./cairn.1 | col -b");
        EXPECT_EQ(page.err, "");
    }
}

TEST_F(CliShell, TheDoctorNamesWhatIsThereAndWhatIsLacking) {
    const nlohmann::json json = nlohmann::json::parse(cairn("doctor --json").out);
    for (const char* name : {"cairn", "processor", "kernels", "threads", "opengl", "display", "ffmpeg", "scenes"})
        EXPECT_FALSE(json[name].get<std::string>().empty()) << name;
    EXPECT_NE(json["kernels"].get<std::string>().find(" used of scalar"), std::string::npos);
    const Result bare =
        shell("CAIRN_SCENES=missing CAIRN_ISA=scalar; export CAIRN_ISA CAIRN_SCENES; unset DISPLAY WAYLAND_DISPLAY; "
              "PATH=/nonexistent \"$CAIRN\" doctor");
    EXPECT_EQ(bare.code, 0) << bare.err;
    EXPECT_NE(bare.out.find("+ kernels    scalar used of "), std::string::npos) << bare.out;
    EXPECT_NE(bare.out.find("- display    none, so no cairn view"), std::string::npos);
    EXPECT_NE(bare.out.find("- ffmpeg     none, so no videos"), std::string::npos);
    EXPECT_NE(bare.out.find("- scenes     none: missing: cannot be listed"), std::string::npos);
}

TEST_F(CliShell, NamesOfScenesAreListedWithoutReadingThem) {
    const Result result = cairn("scenes --names");
    EXPECT_EQ(result.out.substr(0, result.out.find('\n')), "01_open_plane");
    EXPECT_NE(result.out.find("\nwelcome\n"), std::string::npos);
    expect_one_line(cairn("scenes --names --json"), 2, "excludes");
}

} // namespace
