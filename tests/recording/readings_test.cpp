// Messages in recordings for programs other than Cairn.
#include "recorded.h"
#include "recording/mcap_reader.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdlib>

namespace cairn::test {
namespace {

recording::Readings all_readings() { return {true, true, true, true, true}; }

TEST(Readings, ChangeNothingOfWhatIsRecorded) {
    recording::RecorderOptions with;
    with.readings = all_readings();
    const RecordedRun plain = record_changes(3, 300), run = record_changes(3, 300, with);
    EXPECT_EQ(run.hashes, plain.hashes);
    EXPECT_GT(run.bytes.size(), plain.bytes.size());
    const TemporaryFile file(".mcap");
    std::ofstream(file.path(), std::ios::binary) << run.bytes;
    const recording::Recording recording(file.path());
    recording::Replay replay(recording, 1);
    while (replay.step()) {}
    EXPECT_FALSE(replay.divergence());
    EXPECT_EQ(replay.world().state_hash(), run.hashes.back());
}

TEST(Readings, RefuseAnIntervalThatIsNone) {
    const TemporaryFile file(".mcap");
    recording::RecorderOptions options;
    options.readings = all_readings();
    for (const double interval : {-1.0, double(NAN), double(INFINITY)}) {
        options.readings_interval = interval;
        EXPECT_THROW(recording::Recorder(file.path(), options), Error);
    }
}

// A ball falls on a plate that hangs from a hinge, beside a shape of each kind.
void fill(World& world) {
    const auto add = [&](const char* name, BodyType type, const Position& position, const Shape& shape) {
        BodyDef def;
        def.name = name, def.type = type, def.position = position;
        const BodyId body = world.create_body(def);
        world.add_shape(body, shape);
        return body;
    };
    add("ground", BodyType::static_, {0.0, 0.0, 0.0}, Plane{});
    const Vec3 corners[] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const std::uint32_t triangles[] = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
    const float heights[] = {0.0f, 0.1f, 0.2f, 0.3f};
    add("twin", BodyType::dynamic, {0.0, 3.0, 0.0}, Sphere{0.5f});
    add("twin", BodyType::dynamic, {0.0, 0.5, 0.0}, Box{});
    add("", BodyType::dynamic, {3.0, 1.0, 0.0}, Capsule{});
    add("", BodyType::dynamic, {5.0, 1.0, 0.0}, cone(0.5f, 0.5f));
    add("", BodyType::dynamic, {7.0, 1.0, 0.0}, Hull(corners));
    add("", BodyType::dynamic, {9.0, 1.0, 0.0}, Box{{0.4f, 0.4f, 0.4f}, 0.1f});
    add("mesh", BodyType::static_, {20.0, 0.0, 0.0}, Mesh(corners, triangles));
    add("field", BodyType::static_, {30.0, 0.0, 0.0}, HeightField(2, 2, {1.0f, 1.0f}, heights));
    const BodyId door = add("door", BodyType::dynamic, {0.0, 3.0, 9.0}, Box{});
    JointDef def = world.joint_at({}, door, {0.5, 3.0, 9.0}, {0.0f, 0.0f, 1.0f}, HingeJoint{});
    def.name = "hinge";
    world.create_joint(def);
}

// Sizes of the messages that list the shapes, in bytes.
std::vector<std::size_t> sizes_of_scenes(const std::filesystem::path& path) {
    const recording::McapReader reader{recording::InputBytes(path)};
    const std::optional<std::uint16_t> channel = reader.channel("/scene");
    std::vector<std::size_t> sizes;
    for (std::size_t i = 0; i < reader.chunks().size(); ++i) {
        const std::string records = reader.load(i);
        reader.for_each_message(records, [&](const recording::McapMessage& message) {
            if (message.channel == channel) sizes.push_back(message.data.size());
        });
    }
    return sizes;
}

TEST(Readings, HaveNoShapesOfWhatIsDisabled) {
    const TemporaryFile file(".mcap");
    recording::RecorderOptions options;
    options.readings = all_readings();
    recording::Recorder recorder(file.path(), options);
    World world;
    world.set_command_listener(recorder.listener());
    fill(world);
    const BodyId ball = *world.find_body("twin");
    for (const bool enabled : {true, false, false, true}) {
        world.body(ball).set_enabled(enabled);
        for (int i = 0; i < 20; ++i) world.step(1.0f / 60.0f);
    }
    recorder.close();
    const std::vector<std::size_t> sizes = sizes_of_scenes(file.path());
    ASSERT_EQ(sizes.size(), 3u) << "at first, without it, and with it again";
    EXPECT_GT(sizes[2], sizes[1] + 50) << "a ball takes more; times take a few bytes more as they grow";
    EXPECT_NEAR(double(sizes[2]), double(sizes[0]), 40.0);
}

TEST(Readings, AreReadByOtherProgramsAsFoxgloveHasThem) {
    const std::filesystem::path folder = CAIRN_TEST_MCAP;
    if (std::system("node --version >/dev/null 2>&1") != 0 ||
        !std::filesystem::exists(folder / "node_modules" / "protobufjs"))
        GTEST_SKIP() << "no node, or no protobufjs: ./dev test fetches it with npm";
    const TemporaryFile file(".mcap"), found(".json");
    recording::RecorderOptions options;
    options.readings = all_readings();
    options.readings_interval = 1.0 / 20.0;
    recording::Recorder recorder(file.path(), options);
    World world;
    world.set_command_listener(recorder.listener());
    fill(world);
    for (int i = 0; i < 120; ++i) world.step(1.0f / 60.0f);
    recorder.close();
    const std::string line = "node '" + (folder / "readings.mjs").string() + "' '" + file.path().string() + "' >'" +
                             found.path().string() + "'";
    ASSERT_EQ(std::system(line.c_str()), 0) << line;
    const nlohmann::json json = nlohmann::json::parse(found.bytes());
    for (const char* topic : {"/tf", "/contacts", "/joints", "/joint_loads", "/statistics"})
        EXPECT_EQ(json.at(topic).at("count"), 41) << topic << ": after the first step, and 20 times a second";
    EXPECT_EQ(json.at("/scene").at("count"), 1) << "as nothing came or went";
    const auto& entities = json.at("/scene").at("last").at("entities");
    ASSERT_EQ(entities.size(), world.bodies().size());
    EXPECT_EQ(entities[1].at("frame_id"), "twin");
    EXPECT_EQ(entities[2].at("frame_id"), "twin 2") << "no two have one name";
    EXPECT_EQ(entities[3].at("spheres").size(), 2u) << "a capsule is a cylinder with two balls";
    EXPECT_EQ(entities[5].at("triangles").at(0).at("indices").size(), 12u);
    const auto& first = json.at("/tf").at("first").at("transforms");
    ASSERT_EQ(first.size(), 1 + world.bodies().size());
    EXPECT_EQ(first[0].at("child_frame_id"), "scene") << "in which y is up";
    EXPECT_NEAR(first[2].at("translation").at("y").get<double>(), 3.0, 0.01);
    EXPECT_NEAR(json.at("/statistics").at("last").at("kinetic_energy").get<double>(), world.kinetic_energy(), 1e-6);
    const auto& joints = json.at("/joints").at("last").at("joints");
    ASSERT_EQ(joints.size(), 1u);
    EXPECT_EQ(joints[0].at("name"), "hinge");
    EXPECT_NEAR(joints[0].at("position").get<double>(), double(world.joint_state(world.joints()[0]).positions[0]),
                1e-6);
    EXPECT_GT(json.at("/contacts").at("last").at("entities").at(0).at("arrows").size(), 4u);
    EXPECT_GT(json.at("/events").at("count"), 0);
    EXPECT_NE(json.at("/events").dump().find("hits"), std::string::npos);
}

} // namespace
} // namespace cairn::test
