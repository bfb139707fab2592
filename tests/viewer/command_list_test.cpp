#include "viewer/command_list.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace {

using namespace cairn::viewer;

std::string best(const Controller& controller, const char* query) {
    const auto commands = all_commands(controller);
    const auto found = matching(commands, query);
    return found.empty() ? "" : commands[found.front()].name;
}

TEST(CommandList, FindsWhatPeopleType) {
    const Controller controller([](Command) {}, {{"a.gltf", "Tower"}, {"b.gltf", "Pyramid"}});
    EXPECT_EQ(best(controller, "undo"), "undo");
    EXPECT_EQ(best(controller, "screenshot"), "save a picture (screenshot)");
    EXPECT_EQ(best(controller, "Energy"), "plots of energy, momentum and bodies");
    EXPECT_EQ(best(controller, "integr"), "integrators side by side");
    EXPECT_EQ(best(controller, "ortho"), "orthographic projection");
    EXPECT_EQ(best(controller, "tower"), "scene: Tower");
    EXPECT_EQ(best(controller, "frcn"), "show or hide friction cones");
    EXPECT_EQ(best(controller, "no such thing"), "");
    EXPECT_EQ(matching(all_commands(controller), "").size(), all_commands(controller).size());
}

TEST(CommandList, DoesWhatTheKeysDo) {
    std::vector<Command> posted;
    Controller controller([&](Command command) { posted.push_back(std::move(command)); }, {{"a.gltf", "Tower"}});
    for (const NamedCommand& command : all_commands(controller))
        if (command.name == "undo" || command.name == "scene: Tower" || command.name == "show or hide velocities" ||
            command.name == "integrators side by side")
            command.run(controller);
    ASSERT_EQ(posted.size(), 3u);
    EXPECT_TRUE(std::holds_alternative<command::Undo>(posted[0]));
    EXPECT_TRUE(std::get<command::ShowSolver>(posted[1]).shown.velocities);
    EXPECT_EQ(std::get<command::LoadScene>(posted[2]).path, "a.gltf");
    EXPECT_TRUE(controller.integrators);
}

TEST(CommandList, NamesAreDistinctAndKeysAreBound) {
    const Controller controller([](Command) {}, {});
    std::set<std::string> names;
    for (const NamedCommand& command : all_commands(controller))
        EXPECT_TRUE(names.insert(command.name).second) << command.name;
    std::set<Action> nameless;
    for (const Binding& binding : key_bindings()) {
        bool is_named = false;
        for (const NamedCommand& command : all_commands(controller))
            is_named = is_named ||
                       (", " + command.keys + ",").find(", " + std::string(binding.chord) + ",") != std::string::npos;
        if (!is_named && !is_held(binding.action)) nameless.insert(binding.action);
    }
    // These actions need the cursor, repeat while held, or open the list itself; scenes are listed by their titles.
    EXPECT_EQ(nameless, (std::set<Action>{Action::choose_scene, Action::orbit_left, Action::orbit_right,
                                          Action::orbit_up, Action::orbit_down, Action::zoom_in, Action::zoom_out,
                                          Action::shoot, Action::join_by_ball, Action::join_by_hinge,
                                          Action::join_fixed, Action::toggle_palette}));
}

} // namespace
