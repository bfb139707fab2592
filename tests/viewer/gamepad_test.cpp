#include "viewer/gamepad.h"

#include "test_scene.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <variant>
#include <vector>

namespace {

using namespace cairn;
using namespace cairn::viewer;

using test::aspect;

struct PadDesk {
    Stage stage{test::load_boxes, "2"};
    std::vector<Command> posted;
    Controller controller{[this](Command command) {
                              posted.push_back(command);
                              stage.apply(command);
                          },
                          {{"2", "two"}, {"5", "five"}}};
    Gamepad pad;

    PadDesk() { controller.update(stage.state()); }
    void hold(const GamepadState& state, int frames) {
        for (int i = 0; i < frames; ++i) pad.update(state, static_cast<float>(test::frame), aspect, controller);
    }
    template <class T> int count() const {
        int n = 0;
        for (const Command& command : posted) n += std::holds_alternative<T>(command);
        return n;
    }
};

GamepadState with(PadButton button) {
    GamepadState state;
    state.down[std::size_t(button)] = true;
    return state;
}

TEST(Gamepad, SticksTurnAndShiftTheViewAndTriggersZoom) {
    PadDesk desk;
    OrbitCamera& camera = desk.controller.camera;
    const Vec3 before = camera.forward(), right = camera.right();
    GamepadState state;
    state.right_stick = {1.0f, 0.0f};
    desk.hold(state, 30); // half a second at 2.5 rad/s: the camera moves to its right, and therefore looks to the left
    EXPECT_NEAR(glm::dot(before, camera.forward()), std::cos(1.25f) + (1 - std::cos(1.25f)) * before.y * before.y,
                0.01f);
    EXPECT_LT(glm::dot(camera.forward(), right), 0.0f);

    const Position target = camera.target();
    const Vec3 across = camera.right();
    state = {};
    state.left_stick = {1.0f, 0.0f};
    desk.hold(state, 30);
    const float height = 2.0f * camera.distance() * camera.half_height(aspect);
    EXPECT_NEAR(glm::dot(Vec3(camera.target() - target), across), 0.4f * height, 0.01f * height);

    const float distance = camera.distance();
    state = {};
    state.right_trigger = 1.0f;
    desk.hold(state, 30);
    EXPECT_LT(camera.distance(), 0.7f * distance);
    state.right_trigger = 0.0f, state.left_trigger = 1.0f;
    desk.hold(state, 30);
    EXPECT_NEAR(camera.distance(), distance, 0.05f * distance);
}

TEST(Gamepad, WornSticksDoNotMoveTheCamera) {
    PadDesk desk;
    const CameraPose before = desk.controller.camera.pose();
    GamepadState state;
    state.left_stick = {0.1f, -0.1f}, state.right_stick = {-0.1f, 0.1f};
    state.left_trigger = 0.1f;
    desk.hold(state, 100);
    EXPECT_EQ(before.position, desk.controller.camera.position());
    EXPECT_EQ(before.target, desk.controller.camera.target());
    EXPECT_TRUE(desk.posted.empty());
}

TEST(Gamepad, ButtonsCountOncePerPressAndStepsRepeat) {
    PadDesk desk;
    desk.hold({}, 1);
    desk.hold(with(PadButton::a), 30);
    desk.hold({}, 1);
    EXPECT_TRUE(desk.stage.state().paused);
    const int first = int(desk.posted.size());
    desk.hold(with(PadButton::right_bumper), 1);
    EXPECT_EQ(int(desk.posted.size()), first + 1);
    desk.hold(with(PadButton::right_bumper), 60); // after 0.4 s the action repeats 20 times per second
    EXPECT_NEAR(double(desk.posted.size()) - first, 1 + 12, 2);
    desk.hold({}, 1);
    desk.hold(with(PadButton::x), 60);
    EXPECT_EQ(desk.count<command::ResetScene>(), 1);
}

// A button that was already held when the window got the focus, or when the gamepad was plugged in, does not count as
// pressed.
TEST(Gamepad, WhatIsDownWhenItComesIsNotPressed) {
    PadDesk desk;
    desk.hold(with(PadButton::x), 5);
    EXPECT_TRUE(desk.posted.empty());
    desk.pad.update(std::nullopt, static_cast<float>(test::frame), aspect, desk.controller);
    desk.hold(with(PadButton::x), 5);
    EXPECT_TRUE(desk.posted.empty());
    desk.hold({}, 1);
    desk.hold(with(PadButton::x), 5);
    EXPECT_EQ(desk.count<command::ResetScene>(), 1);
}

TEST(Gamepad, NoButtonHasTwoMeaningsAndNoneIsHeldInAction) {
    std::set<PadButton> buttons;
    for (const PadBinding& binding : pad_bindings()) {
        EXPECT_TRUE(buttons.insert(binding.button).second) << binding.name;
        EXPECT_FALSE(is_held(binding.action)) << binding.name;
    }
}

} // namespace
