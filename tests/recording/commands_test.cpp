// Changes of a world as commands: each one is reported, and can be executed again.
#include "random_changes.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <deque>
#include <map>
#include <set>
#include <string>

namespace cairn::test {
namespace {

// Stores all commands that it receives.
class Log final : public CommandListener, public CommandSource {
  public:
    void on_command(std::span<const std::byte> command) override {
        if (refuses) throw std::runtime_error("the disk is full");
        commands.emplace_back(command.begin(), command.end());
    }
    void on_step(const World& world) noexcept override { digests[commands.size()] = world.state_digest(); }
    std::uint64_t number_of(const Shape& shape) override {
        shapes.push_back(shape);
        return shapes.size() - 1;
    }
    std::uint64_t number_of(const Snapshot& snapshot) override {
        snapshots.push_back(snapshot);
        return snapshots.size() - 1;
    }
    const Shape& shape(std::uint64_t number) override {
        if (number >= shapes.size()) throw Error(ErrorCode::invalid_file, "shape", "", "is not there");
        return shapes[std::size_t(number)];
    }
    const Snapshot& snapshot(std::uint64_t number) override {
        if (number >= snapshots.size()) throw Error(ErrorCode::invalid_file, "snapshot", "", "is not there");
        return snapshots[std::size_t(number)];
    }

    std::vector<std::vector<std::byte>> commands;
    std::map<std::size_t, StateDigest> digests; // by the number of preceding commands
    std::deque<Shape> shapes;
    std::deque<Snapshot> snapshots;
    bool refuses = false;
};

class Commands : public testing::TestWithParam<std::uint32_t> {};

TEST_P(Commands, MadeAgainInAnotherWorldLeadToTheSameStateAfterEveryStep) {
    const auto log = std::make_shared<Log>();
    World world;
    world.set_command_listener(log);
    RandomChanges changes(GetParam());
    changes.populate(world);
    for (int i = 0; i < 400; ++i) changes.change(world);
    const Snapshot middle = world.save();
    for (int i = 0; i < 50; ++i) changes.change(world);
    world.restore(middle);
    for (int i = 0; i < 50; ++i) changes.change(world);
    EXPECT_GT(log->digests.size(), 200u);

    World again;
    again.set_threads(3);
    for (std::size_t i = 0; i < log->commands.size(); ++i) {
        again.execute(log->commands[i], *log);
        const auto digest = log->digests.find(i + 1);
        if (digest != log->digests.end()) {
            ASSERT_EQ(again.state_digest(), digest->second)
                << "after command " << i << ", " << command_name(log->commands[i]);
        }
    }
    EXPECT_EQ(again.state_hash(), world.state_hash());
    EXPECT_EQ(again.bodies().size(), world.bodies().size());
    EXPECT_EQ(again.joints().size(), world.joints().size());
}
INSTANTIATE_TEST_SUITE_P(Seeds, Commands, testing::Range(1u, 13u));

TEST(Command, OfEveryCallInTheTableIsTold) {
    const nlohmann::json encoding = nlohmann::json::parse(command_encoding());
    std::set<std::string> expected, told;
    for (const auto& [number, call] : encoding["calls"].items()) expected.insert(call[0].get<std::string>());
    EXPECT_GT(expected.size(), 30u);
    const auto log = std::make_shared<Log>();
    World world;
    world.set_command_listener(log);
    RandomChanges changes(7);
    changes.populate(world);
    for (int i = 0; i < 3000; ++i) changes.change(world, i % 50 == 0);
    world.restore(world.save());
    for (const std::vector<std::byte>& command : log->commands) told.emplace(command_name(command));
    EXPECT_EQ(told, expected);
}

TEST(Command, OfAWorldThatHasALifeBehindItIsASnapshotFirst) {
    RandomChanges changes(3);
    World world;
    changes.populate(world);
    for (int i = 0; i < 60; ++i) changes.change(world);
    const auto log = std::make_shared<Log>();
    world.set_command_listener(log);
    ASSERT_EQ(log->commands.size(), 1u);
    EXPECT_EQ(command_name(log->commands[0]), "World::restore");
    for (int i = 0; i < 60; ++i) changes.change(world);
    World again;
    for (const std::vector<std::byte>& command : log->commands) again.execute(command, *log);
    EXPECT_EQ(again.state_hash(), world.state_hash());
}

TEST(Command, ThatTheListenerRefusesIsNotDone) {
    RandomChanges changes(5);
    World world;
    changes.populate(world);
    const auto log = std::make_shared<Log>();
    world.set_command_listener(log);
    const std::uint64_t before = world.state_hash();
    log->refuses = true;
    EXPECT_THROW(world.step(1.0f / 60.0f), std::runtime_error);
    EXPECT_THROW(world.create_body(), std::runtime_error);
    EXPECT_THROW(world.body(world.bodies().back()).set_position({0, 9, 0}), std::runtime_error);
    EXPECT_THROW(world.restore(world.save()), std::runtime_error);
    EXPECT_EQ(world.state_hash(), before);
    EXPECT_EQ(world.step_count(), 0u);
    log->refuses = false;
    world.step(1.0f / 60.0f);
    EXPECT_EQ(world.step_count(), 1u);
}

TEST(Command, MayNotBeGivenWhileTheListenerIsTold) {
    struct Meddler final : CommandListener {
        World* world = nullptr;
        void on_command(std::span<const std::byte>) override {
            if (world) world->create_body();
        }
        std::uint64_t number_of(const Shape&) override { return 0; }
        std::uint64_t number_of(const Snapshot&) override { return 0; }
    };
    World world;
    const auto meddler = std::make_shared<Meddler>();
    world.set_command_listener(meddler);
    meddler->world = &world;
    try {
        world.step(0.01f);
        FAIL() << "nothing was thrown";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::wrong_state);
    }
    EXPECT_EQ(world.bodies().size(), 0u);
    EXPECT_EQ(world.step_count(), 0u);
    world.set_command_listener(nullptr);
    world.step(0.01f);
}

TEST(Command, ThatIsCutOffOrDamagedChangesNothing) {
    const auto log = std::make_shared<Log>();
    World world;
    world.set_command_listener(log);
    RandomChanges changes(11);
    changes.populate(world);
    for (int i = 0; i < 500; ++i) changes.change(world, i % 50 == 0);
    world.set_command_listener(nullptr);
    std::mt19937 random(1);
    World copy;
    for (const std::vector<std::byte>& command : log->commands) {
        for (std::size_t size = 0; size < command.size(); ++size) {
            const std::uint64_t before = copy.state_hash();
            try {
                copy.execute(std::span(command).first(size), *log);
                FAIL() << command_name(command) << " is whole without its last bytes";
            } catch (const Error& error) {
                EXPECT_TRUE(error.code() == ErrorCode::invalid_file || error.code() == ErrorCode::unsupported ||
                            error.code() == ErrorCode::invalid_value)
                    << error.what();
            }
            ASSERT_EQ(copy.state_hash(), before);
        }
        std::vector<std::byte> longer = command;
        longer.push_back(std::byte{0});
        EXPECT_THROW(copy.execute(longer, *log), Error);
        copy.execute(command, *log);
    }
    EXPECT_EQ(copy.state_hash(), world.state_hash());
}

TEST(Command, OfAnOlderVersionWithFewerMembersHasTheirDefaults) {
    struct None final : CommandSource {
        const Shape& shape(std::uint64_t) override { throw Error(ErrorCode::invalid_file, "shape", "", "none"); }
        const Snapshot& snapshot(std::uint64_t) override { throw Error(ErrorCode::invalid_file, "s", "", "none"); }
    } none;
    World world;
    const std::vector<std::byte> old{std::byte{7}, std::byte{1}, std::byte{1}}; // create_body with 1 member: kinematic
    world.execute(old, none);
    ASSERT_EQ(world.bodies().size(), 1u);
    EXPECT_EQ(world.body(world.bodies()[0]).type(), BodyType::kinematic);
    EXPECT_EQ(world.body(world.bodies()[0]).gravity_scale(), 1.0f);
    const std::vector<std::byte> later{std::byte{7}, std::byte{99}, std::byte{1}};
    try {
        world.execute(later, none);
        FAIL() << "nothing was thrown";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::unsupported);
        EXPECT_NE(std::string(error.what()).find("99 members"), std::string::npos) << error.what();
    }
}

} // namespace
} // namespace cairn::test
