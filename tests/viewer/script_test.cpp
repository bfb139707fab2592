#include "viewer/script.h"

#include <cairn/error.h>

#include <gtest/gtest.h>

namespace {

using namespace cairn;
using namespace cairn::viewer;

TEST(Script, ReadsCommandsAndIgnoresComments) {
    const auto script =
        parse_script("# start\n\nkey Shift+Backspace  # remove\ncursor 640.5 360\npress left\nwait 0.3\n", "s");
    ASSERT_EQ(script.size(), 4u);
    EXPECT_EQ(script[0].kind, ScriptLine::Kind::key);
    EXPECT_EQ(script[0].word, "Shift+Backspace");
    EXPECT_EQ(script[1].x, 640.5);
    EXPECT_EQ(script[1].y, 360.0);
    EXPECT_EQ(script[2].word, "left");
    EXPECT_EQ(script[3].x, 0.3);
}

TEST(Script, ButtonsArePressedWithKeys) {
    const auto script = parse_script("press Shift+left\nrelease Shift+left\n", "s");
    ASSERT_EQ(script.size(), 2u);
    EXPECT_EQ(script[0].word, "Shift+left");
}

TEST(Script, FilesCanBeDropped) {
    const auto script = parse_script("drop /tmp/bridge.glb\n", "s");
    ASSERT_EQ(script.size(), 1u);
    EXPECT_EQ(script[0].kind, ScriptLine::Kind::drop);
    EXPECT_EQ(script[0].word, "/tmp/bridge.glb");
}

TEST(Script, BadLinesAreNamed) {
    for (const char* line : {"jump", "wait", "wait soon", "cursor 1", "press nose", "press Shift+nose",
                             "press left+Shift", "quit now", "key", "drop"}) {
        try {
            parse_script(std::string("key U\n") + line + "\n", "demo");
            ADD_FAILURE() << line;
        } catch (const Error& error) {
            EXPECT_EQ(error.field(), "demo:2") << line;
            EXPECT_EQ(error.code(), ErrorCode::invalid_file);
        }
    }
}

TEST(Script, AMissingFileIsAnError) { EXPECT_THROW(load_script("/nonexistent/script"), Error); }

TEST(ScriptPlayer, HandsOutEachLineWhenItsTimeHasCome) {
    ScriptPlayer player(parse_script("key A\nwait 1\nkey B\nkey C\nwait 0.5\nkey D\n", "s"));
    const auto due = [&player](double seconds) {
        std::string keys;
        while (const ScriptLine* line = player.next(seconds)) {
            keys += line->word;
            seconds = 0.0;
        }
        return keys;
    };
    EXPECT_EQ(due(0.0), "A");
    EXPECT_EQ(due(0.6), "");
    EXPECT_EQ(due(0.6), "BC");
    EXPECT_EQ(due(0.2), "");
    EXPECT_EQ(due(0.4), "D");
    EXPECT_EQ(due(9.0), "");
}

} // namespace
