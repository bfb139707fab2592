#include "viewer/key_map.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

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
