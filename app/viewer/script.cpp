#include "viewer/script.h"

#include <cairn/error.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iterator>
#include <sstream>
#include <utility>

namespace cairn::viewer {

namespace {

enum class Operand { nothing, word, button, number, point };

struct Grammar {
    const char* name;
    ScriptLine::Kind kind;
    Operand operand;
};

constexpr std::array<Grammar, 13> grammar{{
    {"wait", ScriptLine::Kind::wait, Operand::number},
    {"key", ScriptLine::Kind::key, Operand::word},
    {"down", ScriptLine::Kind::down, Operand::word},
    {"up", ScriptLine::Kind::up, Operand::word},
    {"cursor", ScriptLine::Kind::cursor, Operand::point},
    {"press", ScriptLine::Kind::press, Operand::button},
    {"release", ScriptLine::Kind::release, Operand::button},
    {"wheel", ScriptLine::Kind::wheel, Operand::number},
    {"drop", ScriptLine::Kind::drop, Operand::word},
    {"report", ScriptLine::Kind::report, Operand::word},
    {"picture", ScriptLine::Kind::picture, Operand::word},
    {"window", ScriptLine::Kind::window, Operand::word},
    {"quit", ScriptLine::Kind::quit, Operand::nothing},
}};

bool is_button(const std::string& name) { return name == "left" || name == "right" || name == "middle"; }

bool read_operand(std::istringstream& words, Operand operand, ScriptLine& line) {
    switch (operand) {
    case Operand::nothing:
        return true;
    case Operand::number:
        return bool(words >> line.x) && std::isfinite(line.x);
    case Operand::point:
        return bool(words >> line.x >> line.y) && std::isfinite(line.x) && std::isfinite(line.y);
    case Operand::word:
        return bool(words >> line.word);
    case Operand::button:
        return bool(words >> line.word) && is_button(line.word.substr(line.word.rfind('+') + 1));
    }
    return false;
}

} // namespace

std::vector<ScriptLine> parse_script(std::string_view text, const std::string& name) {
    std::istringstream lines{std::string(text)};
    std::vector<ScriptLine> script;
    std::string line;
    for (int number = 1; std::getline(lines, line); ++number) {
        std::istringstream words(line.substr(0, line.find('#')));
        std::string verb, rest;
        if (!(words >> verb)) continue;
        const auto rule = std::find_if(grammar.begin(), grammar.end(),
                                       [&verb](const Grammar& candidate) { return verb == candidate.name; });
        ScriptLine parsed;
        if (rule == grammar.end() || !read_operand(words, rule->operand, parsed) || words >> rest)
            throw Error(ErrorCode::invalid_file, name + ":" + std::to_string(number), "\"" + line + "\"",
                        "must be a command of the viewer's scripts, such as `wait 0.5` or `key U`");
        parsed.kind = rule->kind;
        script.push_back(std::move(parsed));
    }
    return script;
}

std::vector<ScriptLine> load_script(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    if (!file) throw Error(ErrorCode::io, path.string(), "", "must be a readable file");
    return parse_script(text, path.string());
}

const ScriptLine* ScriptPlayer::next(double seconds) {
    waiting_ -= seconds;
    while (place_ < lines_.size() && waiting_ <= 0.0) {
        const ScriptLine& line = lines_[place_++];
        if (line.kind != ScriptLine::Kind::wait) return &line;
        waiting_ = std::max(waiting_, 0.0) + line.x;
    }
    return nullptr;
}

} // namespace cairn::viewer
