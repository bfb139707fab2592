#include "viewer/key_map.h"
#include "viewer/spawn.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace {

using namespace cairn::viewer;

TEST(KeyMap, KeepsTheKeysOfTheFirstProgram) {
    const auto action = [](const char* chord) {
        const auto binding = find_binding(chord);
        return binding ? binding->action : Action::quit;
    };
    EXPECT_EQ(action("1"), Action::choose_scene);
    EXPECT_EQ(action("4"), Action::choose_scene);
    EXPECT_EQ(action("U"), Action::add_box);
    EXPECT_EQ(action("I"), Action::add_large_sphere);
    EXPECT_EQ(action("O"), Action::add_small_sphere);
    EXPECT_EQ(action("Backspace"), Action::remove_last);
    EXPECT_EQ(action("Delete"), Action::reset_scene);
    EXPECT_EQ(action("KP4"), Action::force_x);
    EXPECT_EQ(action("KP9"), Action::force_y);
    EXPECT_EQ(action("KP8"), Action::force_z);
    EXPECT_EQ(action("C"), Action::pull_to_center);
    EXPECT_EQ(action("X"), Action::freeze);
}

TEST(KeyMap, EveryActionHasAKeyAndEveryKeyIsExplained) {
    std::string explained;
    for (const KeyHelp& line : key_help()) explained += std::string(line.keys) + " ";
    for (const char* key : {"U", "I", "O", "J", "K", "L", "M", "P", "V", "B", "Y", "W", "D", "T"}) {
        EXPECT_TRUE(find_binding(key)) << key;
        EXPECT_NE((" " + explained).find(std::string(" ") + key + " "), std::string::npos) << key;
    }
    std::set<Action> bound;
    for (const Binding& binding : key_bindings()) bound.insert(binding.action);
    for (int i = 0; i <= int(Action::quit); ++i) EXPECT_TRUE(bound.count(Action(i))) << i;
}

std::vector<std::string> words_of(std::string_view text) {
    std::vector<std::string> words;
    std::string word;
    for (const char letter : std::string(text) + " ") {
        const bool is_comma_key = letter == ',' && word.empty();
        if (is_comma_key || (letter != ' ' && letter != ',' && letter != ';')) {
            word += letter;
        } else if (!word.empty()) {
            words.push_back(std::exchange(word, ""));
        }
    }
    return words;
}

// The phrase that the help line of an action must contain. The phrases follow the effects of keys in controller.cpp and
// spawn.cpp.
std::string promise_of(Action action) {
    switch (action) {
    case Action::shoot:
        return std::string("shoot a ") + name_of(SpawnSettings{}.kind);
    case Action::add_box:
        return name_of(box_preset().kind);
    case Action::add_large_sphere:
        return std::string("large ") + name_of(large_sphere_preset().kind);
    case Action::add_small_sphere:
        return std::string("small ") + name_of(small_sphere_preset().kind);
    case Action::add_capsule:
        return name_of(SpawnSettings::Kind::capsule);
    case Action::add_cylinder:
        return name_of(SpawnSettings::Kind::cylinder);
    case Action::add_cone:
        return name_of(SpawnSettings::Kind::cone);
    case Action::add_polyhedron:
        return "polyhedron";
    case Action::remove_last:
        return "remove the last";
    case Action::remove_selected:
        return "remove the selection";
    case Action::remove_joint:
        return "remove the selected joint";
    case Action::join_by_ball:
        return "ball";
    case Action::join_by_hinge:
        return "hinge";
    case Action::join_fixed:
        return "fixed";
    case Action::toggle_joints:
        return "joints";
    case Action::toggle_grid:
        return "grid";
    case Action::toggle_shadows:
        return "shadows";
    case Action::toggle_pause:
        return "pause";
    case Action::single_step:
        return "one step";
    case Action::step_back:
        return "one step back";
    case Action::undo:
        return "undo";
    case Action::redo:
        return "redo";
    case Action::freeze:
        return "freeze";
    case Action::pull_to_center:
        return "to the center";
    case Action::quit:
        return "quit";
    default:
        return "";
    }
}

// The spelling of the chord's key in the key map, without its modifiers.
std::string written(const std::string& chord) {
    static const std::map<std::string, std::string> names{{"PageUp", "up"},
                                                          {"PageDown", "down"},
                                                          {"Left", "arrows"},
                                                          {"Right", "arrows"},
                                                          {"Up", "arrows"},
                                                          {"Down", "arrows"},
                                                          {"=", "+"},
                                                          {"Shift+=", "+"},
                                                          {"KPAdd", "+"},
                                                          {"KPSubtract", "-"},
                                                          {"Shift+Left", "arrows"},
                                                          {"Shift+Right", "arrows"},
                                                          {"Shift+Up", "arrows"},
                                                          {"Shift+Down", "arrows"},
                                                          {"Shift+PageUp", "up"},
                                                          {"Shift+PageDown", "down"}};
    const auto found = names.find(chord);
    if (found != names.end()) return found->second;
    return chord.substr(0, 2) == "KP" ? chord.substr(2) : chord;
}

TEST(KeyMap, TheKeyMapOnTheScreenSaysWhatTheKeysDo) {
    std::set<std::string> explained;
    for (const KeyHelp& line : key_help()) {
        const std::vector<std::string> keys = words_of(line.keys);
        std::size_t place = 0; // position in the meaning, where keys and their effects are in the same order
        for (const std::string& chord : words_of(line.chords)) {
            const auto binding = find_binding(chord);
            ASSERT_TRUE(binding) << chord;
            EXPECT_TRUE(explained.insert(chord).second) << chord;
            const bool is_digit = binding->action == Action::choose_scene; // "1 ... 9"
            EXPECT_TRUE(is_digit || std::find(keys.begin(), keys.end(), written(chord)) != keys.end()) << chord;
            const std::string promise = promise_of(binding->action);
            const std::size_t found = std::string(line.meaning).find(promise, place);
            EXPECT_NE(found, std::string::npos) << chord << " is to " << promise << ", not " << line.meaning;
            if (found != std::string::npos) place = found;
        }
        // A letter key in a line's text must be one of the keys that the line describes.
        for (const std::string& key : keys) {
            const bool is_letter = key.size() == 1 && key[0] >= 'A' && key[0] <= 'Z';
            EXPECT_TRUE(!is_letter || line.chords.find(key) != std::string_view::npos) << key;
        }
    }
    for (const Binding& binding : key_bindings())
        EXPECT_TRUE(explained.count(std::string(binding.chord))) << binding.chord;
}

TEST(KeyMap, ThePageOfTheViewerHasTheWholeKeyMap) {
    std::ifstream file(CAIRN_TEST_SCENES "/../docs/viewer.md");
    const std::string page{std::istreambuf_iterator<char>(file), {}};
    ASSERT_FALSE(page.empty());
    for (const KeyHelp& line : key_help()) {
        const std::string keys = line.keys[0] == ' ' ? "" : line.keys;
        const std::string row = keys.empty() && line.keys[0] == '\0' ? "| **" + std::string(line.meaning) + "** | |"
                                : keys.empty()                       ? "|  | " + std::string(line.meaning) + " |"
                                                                     : "| " + keys + " | " + line.meaning + " |";
        EXPECT_NE(page.find(row), std::string::npos) << row;
    }
}

TEST(KeyMap, HintsOfScenesNameKeysThatDoWhatTheySay) {
    int hints = 0;
    for (const auto& entry : std::filesystem::directory_iterator(CAIRN_TEST_SCENES)) {
        std::ifstream file(entry.path());
        const std::string text{std::istreambuf_iterator<char>(file), {}};
        const std::size_t at = text.find("\"hint\":\"");
        if (entry.path().extension() != ".gltf" || at == std::string::npos) continue;
        const std::string hint = text.substr(at + 8, text.find('"', at + 8) - at - 8);
        ++hints;
        const std::vector<std::string> words = words_of(hint);
        for (std::size_t i = 0; i + 1 < words.size(); ++i) {
            if (words[i] != "Press" && words[i] != "Hold" && words[i] != "press" && words[i] != "hold") continue;
            if (std::islower(static_cast<unsigned char>(words[i + 1][0]))) continue; // as in "hold a tray"
            const auto binding = find_binding(words[i + 1]);
            ASSERT_TRUE(binding) << hint;
            EXPECT_EQ(is_held(binding->action), words[i] == "Hold" || words[i] == "hold") << hint;
            EXPECT_TRUE(hint.find("shoot") == std::string::npos || binding->action == Action::shoot) << hint;
        }
        const bool names_shot = hint.find("hoot a ") != std::string::npos;
        EXPECT_TRUE(!names_shot || hint.find("Press P to " + promise_of(Action::shoot)) != std::string::npos) << hint;
    }
    EXPECT_GT(hints, 30);
}

TEST(KeyMap, NoChordMeansTwoThings) {
    std::set<std::string> chords;
    for (const Binding& binding : key_bindings())
        EXPECT_TRUE(chords.insert(std::string(binding.chord)).second) << binding.chord;
}

TEST(KeyMap, OppositeForceKeysPushOppositely) {
    for (const auto& [one, other] : {std::pair("KP4", "KP6"),
                                     {"KP7", "KP9"},
                                     {"KP8", "KP2"},
                                     {"Shift+Left", "Shift+Right"},
                                     {"Shift+Up", "Shift+Down"}}) {
        const auto a = find_binding(one), b = find_binding(other);
        ASSERT_TRUE(a && b);
        EXPECT_EQ(a->action, b->action);
        EXPECT_EQ(a->argument, -b->argument);
        EXPECT_TRUE(is_held(a->action));
    }
}

TEST(KeyMap, UnboundChordsMeanNothing) {
    EXPECT_FALSE(find_binding("Ctrl+U"));
    EXPECT_FALSE(find_binding(""));
}

} // namespace
