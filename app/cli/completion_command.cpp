// Shell completion scripts, generated from the options themselves, so that they cannot become outdated.
#include "cli/command_line.h"
#include "cli/outputs.h"

#include "validation/validation.h"

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <vector>

namespace cairn::cli {

std::vector<std::string> choices_of(const CLI::Option& option) {
    const std::string name = option.get_name();
    if (name == "--integrator") return {"semi-implicit", "explicit", "rk4"};
    if (name == "--as") return {"hull", "mesh"};
    if (name == "shell") return {"bash", "zsh", "fish"};
    std::vector<std::string> words;
    if (name == "--columns") {
        for (const std::string_view quantity : quantity_names()) words.emplace_back(quantity);
    } else if (name == "--case") {
        for (const validation::Case& entry : validation::cases()) words.emplace_back(entry.name);
    }
    return words;
}

namespace {

enum class Takes { nothing, choice, number, file };

Takes taken_by(const CLI::Option& option) {
    if (option.get_items_expected_max() == 0) return Takes::nothing;
    if (!choices_of(option).empty()) return Takes::choice;
    const std::string type = option.get_type_name();
    for (const char* number : {"FLOAT", "INT", "UINT"}) {
        if (type.rfind(number, 0) == 0) return Takes::number;
    }
    return Takes::file;
}

std::vector<const CLI::App*> commands_of(const CLI::App& app) {
    return app.get_subcommands([](const CLI::App*) { return true; });
}

std::vector<const CLI::Option*> options_of(const CLI::App& app) {
    return app.get_options([](const CLI::Option* option) { return !option->get_lnames().empty(); });
}

// The first positional argument; null if there is none.
const CLI::Option* argument_of(const CLI::App& app) {
    for (const CLI::Option* option : app.get_options([](const CLI::Option* o) { return o->get_lnames().empty(); }))
        return option;
    return nullptr;
}

bool takes_scenes(const CLI::App& app) {
    const CLI::Option* argument = argument_of(app);
    return argument != nullptr && (argument->get_name() == "scene" || argument->get_name() == "in");
}

// Puts a backslash before each character of `special`.
std::string with_backslashes(const std::string& text, std::string_view special) {
    std::string result;
    for (const char c : text) {
        if (special.find(c) != std::string_view::npos) result += '\\';
        result += c;
    }
    return result;
}

// Quotes a text in single quotes, for bash and zsh.
std::string in_quotes(const std::string& text) {
    std::string result = "'";
    for (const char c : text) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return result + "'";
}

std::string bash_options(const CLI::App& app) {
    std::string words;
    for (const CLI::Option* option : options_of(app))
        words += (words.empty() ? "--" : " --") + option->get_lnames().front();
    return words;
}

// Completion of option values. For options without an entry, readline completes file names.
std::string bash_values(const CLI::App& app) {
    std::string numbers, choices;
    for (const CLI::App* command : commands_of(app)) {
        for (const CLI::Option* option : options_of(*command)) {
            const std::string name = command->get_name() + ".--" + option->get_lnames().front();
            if (taken_by(*option) == Takes::number) numbers += (numbers.empty() ? "" : " | ") + name;
            if (taken_by(*option) == Takes::choice)
                choices += fmt::format("    {}) words='{}' ;;\n", name, fmt::join(choices_of(*option), " "));
            if (taken_by(*option) == Takes::file) choices += fmt::format("    {}) return ;;\n", name);
        }
    }
    return fmt::format("    {}) compopt +o default 2>/dev/null; return ;;\n{}", numbers, choices);
}

std::string bash_script(const CLI::App& app) {
    std::string names, cases, with_scenes;
    for (const CLI::App* command : commands_of(app)) {
        names += command->get_name() + " ";
        const CLI::Option* argument = argument_of(*command);
        const std::vector<std::string> words = argument != nullptr ? choices_of(*argument) : std::vector<std::string>();
        cases += fmt::format("    {}.-*) words='{}' ;;\n", command->get_name(), bash_options(*command));
        if (takes_scenes(*command)) {
            cases +=
                fmt::format("    {}.*) words=$(\"$1\" scenes --names 2>/dev/null); compopt -o filenames 2>/dev/null;"
                            " mapfile -t COMPREPLY < <(compgen -f -- \"$word\") ;;\n",
                            command->get_name());
        } else if (!words.empty()) {
            cases += fmt::format("    {}.*) words='{}' ;;\n", command->get_name(), fmt::join(words, " "));
        }
    }
    return "# Completes the command line of cairn in bash: cairn completion bash\n"
           "_cairn() {\n"
           "    local word=\"${COMP_WORDS[COMP_CWORD]}\" before=\"${COMP_WORDS[COMP_CWORD - 1]}\" words= reply\n"
           "    COMPREPLY=()\n"
           "    if [ \"$COMP_CWORD\" -eq 1 ]; then\n"
           "        mapfile -t COMPREPLY < <(compgen -W '" +
           names + bash_options(app) +
           "' -- \"$word\")\n"
           "        return\n"
           "    fi\n"
           "    case \"${COMP_WORDS[1]}.$before\" in\n" +
           bash_values(app) +
           "    esac\n"
           "    [ -n \"$words\" ] || case \"${COMP_WORDS[1]}.$word\" in\n" +
           cases +
           "    esac\n"
           "    mapfile -t reply < <(compgen -W \"$words\" -- \"$word\")\n"
           "    COMPREPLY+=(\"${reply[@]}\")\n"
           "}\n"
           "complete -o default -F _cairn cairn\n";
}

std::string zsh_option(const CLI::Option& option) {
    const std::string described =
        "--" + option.get_lnames().front() + "[" + with_backslashes(option.get_description(), "[]:\\") + "]";
    switch (taken_by(option)) {
    case Takes::nothing:
        return described;
    case Takes::choice:
        return described + fmt::format(":value:({})", fmt::join(choices_of(option), " "));
    case Takes::number:
        return described + ":number:";
    case Takes::file:
        break;
    }
    return described + ":file:_files";
}

std::string zsh_script(const CLI::App& app) {
    std::string names, cases;
    for (const CLI::App* command : commands_of(app)) {
        names += "            " +
                 in_quotes(command->get_name() + ":" + with_backslashes(command->get_description(), ":\\")) + "\n";
        cases += "        " + command->get_name() + ")\n            _arguments";
        for (const CLI::Option* option : options_of(*command))
            cases += " \\\n                " + in_quotes(zsh_option(*option));
        const CLI::Option* argument = argument_of(*command);
        if (takes_scenes(*command)) {
            cases += " \\\n                '1:scene:_cairn_scenes' '*:file:_files'";
        } else if (argument != nullptr && !choices_of(*argument).empty()) {
            cases += fmt::format(" \\\n                '1:{}:({})'", argument->get_name(),
                                 fmt::join(choices_of(*argument), " "));
        } else if (argument != nullptr) {
            cases += " \\\n                '*:file:_files'";
        }
        cases += "\n            ;;\n";
    }
    return "#compdef cairn\n"
           "# Completes the command line of cairn in zsh: cairn completion zsh\n"
           "_cairn_scenes() {\n"
           "    local -a names\n"
           "    names=(${(f)\"$(_call_program scenes cairn scenes --names 2>/dev/null)\"})\n"
           "    _alternative 'scenes:scene:compadd -a names' 'files:file:_files'\n"
           "}\n"
           "_cairn() {\n"
           "    local curcontext=\"$curcontext\" state line\n"
           "    local -a commands\n"
           "    _arguments -C '--help[Print the help]' '--version[Print the version]' '1:command:->command' "
           "'*::argument:->arguments'\n"
           "    case $state in\n"
           "    command)\n"
           "        commands=(\n" +
           names +
           "        )\n"
           "        _describe command commands\n"
           "        ;;\n"
           "    arguments)\n"
           "        case $line[1] in\n" +
           cases +
           "        esac\n"
           "        ;;\n"
           "    esac\n"
           "}\n"
           "if [ \"$funcstack[1]\" = _cairn ]; then _cairn \"$@\"; else compdef _cairn cairn; fi\n";
}

std::string fish_text(const std::string& text) { return "'" + with_backslashes(text, "'\\") + "'"; }

std::string fish_script(const CLI::App& app) {
    std::string script = "# Completes the command line of cairn in fish: cairn completion fish\n"
                         "complete -c cairn -n __fish_use_subcommand -f\n"
                         "complete -c cairn -n __fish_use_subcommand -l version -d 'Print the version'\n";
    for (const CLI::App* command : commands_of(app)) {
        const std::string name = command->get_name(),
                          here = "complete -c cairn -n '__fish_seen_subcommand_from " + name + "'";
        script += fmt::format("complete -c cairn -n __fish_use_subcommand -a {} -d {}\n", name,
                              fish_text(command->get_description()));
        for (const CLI::Option* option : options_of(*command)) {
            script += here + " -l " + option->get_lnames().front();
            const Takes takes = taken_by(*option);
            if (takes == Takes::file) script += " -r -F";
            if (takes == Takes::number) script += " -x";
            if (takes == Takes::choice) script += fmt::format(" -x -a '{}'", fmt::join(choices_of(*option), " "));
            script += " -d " + fish_text(option->get_description()) + "\n";
        }
        const CLI::Option* argument = argument_of(*command);
        if (takes_scenes(*command)) {
            script += here + " -a '(cairn scenes --names 2>/dev/null)' -d Scene\n";
        } else if (argument != nullptr && !choices_of(*argument).empty()) {
            script += here + fmt::format(" -f -a '{}'\n", fmt::join(choices_of(*argument), " "));
        }
    }
    return script;
}

} // namespace

int completion_command(const CompletionOptions& options, const CLI::App& app) {
    print(options.shell == "bash" ? bash_script(app) : options.shell == "zsh" ? zsh_script(app) : fish_script(app));
    return 0;
}

} // namespace cairn::cli
