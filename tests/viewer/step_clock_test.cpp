#include "viewer/step_clock.h"

#include "test_scene.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using cairn::viewer::StepClock;

using test::frame;

TEST(StepClock, TakesOneStepForEachStepOfRealTime) {
    StepClock clock(frame);
    int steps = 0;
    for (int i = 0; i < 600; ++i) steps += clock.advance(frame);
    EXPECT_EQ(steps, 600);
}

TEST(StepClock, FrameRateDoesNotChangeTheNumberOfSteps) {
    for (const double rate : {30.0, 47.0, 144.0, 1000.0}) {
        StepClock clock(frame);
        int steps = 0;
        for (int i = 0; i < int(10.0 * rate); ++i) steps += clock.advance(1.0 / rate);
        EXPECT_NEAR(steps, 600, 1) << rate;
    }
}

TEST(StepClock, SleepOfTheMachineIsNotCaughtUpWith) {
    StepClock clock(frame);
    EXPECT_EQ(clock.advance(3600.0), int(StepClock::max_catch_up / frame));
    EXPECT_LE(clock.advance(frame), 2);
}

TEST(StepClock, TimeRunningBackwardsIsIgnored) {
    StepClock clock(frame);
    EXPECT_EQ(clock.advance(-5.0), 0);
    EXPECT_EQ(clock.advance(frame), 1);
}

TEST(StepClock, SlowAndFastMotion) {
    StepClock clock(frame);
    clock.set_speed(0.25);
    int slow = 0, fast = 0;
    for (int i = 0; i < 240; ++i) slow += clock.advance(frame);
    EXPECT_EQ(slow, 60);
    clock.set_speed(8.0);
    for (int i = 0; i < 60; ++i) fast += clock.advance(frame);
    EXPECT_EQ(fast, 480);
}

TEST(StepClock, SpeedIsDoubledAndHalvedWithinItsRange) {
    StepClock clock(frame);
    clock.change_speed(-3);
    EXPECT_EQ(clock.speed(), 0.125);
    clock.change_speed(-100);
    EXPECT_EQ(clock.speed(), StepClock::min_speed);
    clock.change_speed(100);
    EXPECT_EQ(clock.speed(), StepClock::max_speed);
}

TEST(StepClock, PausedClockTakesOnlyRequestedSteps) {
    StepClock clock(frame);
    clock.set_paused(true);
    EXPECT_EQ(clock.advance(10.0), 0);
    EXPECT_TRUE(std::isinf(clock.until_next_step()));
    clock.request_step();
    clock.request_step();
    EXPECT_EQ(clock.until_next_step(), 0.0);
    EXPECT_EQ(clock.advance(0.0), 2);
    EXPECT_EQ(clock.advance(10.0), 0);
    clock.set_paused(false);
    EXPECT_EQ(clock.advance(0.0), 0); // no time accumulated during the pause
    EXPECT_EQ(clock.advance(frame), 1);
}

TEST(StepClock, SingleStepPausesARunningClock) {
    StepClock clock(frame);
    clock.request_step();
    EXPECT_TRUE(clock.paused());
    EXPECT_EQ(clock.advance(1.0), 1);
}

TEST(StepClock, TellsWhenTheNextStepIsDue) {
    StepClock clock(0.5);
    clock.set_speed(2.0);
    EXPECT_EQ(clock.advance(0.05), 0);
    EXPECT_NEAR(clock.until_next_step(), 0.2, 1e-12);
    EXPECT_NEAR(clock.remainder(), 0.1, 1e-12);
}

TEST(StepClock, MeasuresTheRealTimeFactor) {
    StepClock clock(frame);
    for (int i = 0; i < 120; ++i) {
        const int due = clock.advance(2.0 * frame); // this machine manages only half of the steps
        for (int step = 0; step < due / 2; ++step) clock.count_step();
    }
    EXPECT_NEAR(clock.real_time_factor(), 0.5, 0.05);
}

} // namespace
