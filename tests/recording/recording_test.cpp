// Recordings in files, and seeking to any time in them.
#include "recorded.h"
#include "recording/geometry_codec.h"
#include "scene/scene.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdio>
#include <utility>

namespace cairn::test {
namespace {

using recording::Recorder;
using recording::RecorderOptions;
using recording::Recording;
using recording::Replay;

class Recordings : public testing::TestWithParam<std::uint32_t> {};

TEST_P(Recordings, ReplayToTheSameStateAfterEveryStepOnAnyNumberOfThreads) {
    RecorderOptions options;
    options.compress = GetParam() % 2 == 0;
    const RecordedRun run = record_changes(GetParam(), 500, options);
    const Recording recording = Recording::from_memory(run.bytes, "run.mcap");
    EXPECT_EQ(recording.info().steps, run.hashes.size() - 1);
    EXPECT_TRUE(recording.info().is_from_start);
    EXPECT_FALSE(recording.info().is_cut_off);
    EXPECT_EQ(recording.info().source, "random changes");
    EXPECT_EQ(recording.info().commands.at("World::step"), recording.info().steps);
    for (const int threads : {1, 8}) {
        Replay replay(recording, threads);
        EXPECT_EQ(replay.world().threads(), threads);
        while (replay.step()) ASSERT_EQ(replay.world().state_hash(), run.hashes[std::size_t(replay.steps())]);
        EXPECT_EQ(replay.steps(), recording.info().steps);
        EXPECT_FALSE(replay.divergence());
    }
}

TEST_P(Recordings, LeadToTheSameStateWhereverTheyAreEntered) {
    RecorderOptions options;
    options.keyframe_work = 5e-5;
    const RecordedRun run = record_changes(GetParam(), 900, options);
    const Recording recording = Recording::from_memory(run.bytes, "run.mcap");
    EXPECT_GT(recording.info().keyframes.size(), 8u);
    Replay replay(recording);
    std::mt19937 random(GetParam());
    for (int i = 0; i < 60; ++i) {
        const std::uint64_t step = random() % (recording.info().steps + 1);
        replay.seek(step);
        ASSERT_EQ(replay.steps(), step);
        if (step > 0) { // at the start, no command has been executed yet
            ASSERT_EQ(replay.world().state_hash(), run.hashes[std::size_t(step)]) << "after " << step << " steps";
        }
        for (int more = 0; more < 3 && replay.step(); ++more)
            ASSERT_EQ(replay.world().state_hash(), run.hashes[std::size_t(replay.steps())]);
        EXPECT_FALSE(replay.divergence()) << replay.divergence()->text();
    }
    EXPECT_THROW(replay.seek(recording.info().steps + 1), Error);
}
TEST_P(Recordings, AreReadCallByCallForAWorldOfOnesOwn) {
    RecorderOptions options;
    options.keyframe_work = 1e-4;
    const RecordedRun run = record_changes(GetParam(), 500, options);
    const Recording recording = Recording::from_memory(run.bytes, "run.mcap");
    recording::CallReader reader(recording);
    World world;
    recording::RecordedCall call;
    std::uint64_t steps = 0;
    while (reader.next(call)) {
        if (call.command.empty()) continue;
        world.execute(call.command, *reader.source());
        if (!call.is_step) continue;
        ++steps;
        ASSERT_TRUE(call.digest) << steps;
        ASSERT_EQ(world.state_digest(), *call.digest) << steps;
        ASSERT_EQ(world.state_hash(), run.hashes[std::size_t(steps)]) << steps;
    }
    EXPECT_EQ(steps, recording.info().steps);
    EXPECT_FALSE(reader.keyframe(0, 0));
    const std::uint64_t second = recording.info().keyframes.at(1);
    const auto found = reader.keyframe(recording.info().keyframes.at(0), second);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->first, second);
    world.restore(found->second);
    EXPECT_EQ(world.state_hash(), run.hashes[std::size_t(second)]);
}
INSTANTIATE_TEST_SUITE_P(Seeds, Recordings, testing::Range(1u, 7u));

TEST(Recorded, ScenesOfTheLibraryReplayFromTheirFirstBodyOn) {
    for (const char* name : {"16_bowl_of_hulls", "25_ragdolls", "30_clock", "32_robot_arm", "15_marble_run"}) {
        const TemporaryFile file(".mcap");
        Recorder recorder(file.path());
        scene::LoadOptions options;
        options.listener = recorder.listener();
        scene::Scene scene =
            scene::load(std::filesystem::path(CAIRN_TEST_SCENES) / (std::string(name) + ".gltf"), options);
        for (int i = 0; i < 40; ++i) scene.world.step(scene.info.time_step);
        recorder.close();
        const Recording recording(file.path());
        EXPECT_TRUE(recording.info().is_from_start) << name;
        Replay replay(recording, 4);
        while (replay.step()) {}
        EXPECT_FALSE(replay.divergence()) << name << ": " << replay.divergence()->text();
        EXPECT_EQ(replay.world().state_hash(), scene.world.state_hash()) << name;
    }
}

TEST(Recorded, WorldsThatAreMidWayBeginWithASnapshot) {
    World world;
    RandomChanges changes(9);
    changes.populate(world);
    for (int i = 0; i < 100; ++i) changes.change(world);
    const TemporaryFile file(".mcap");
    Recorder recorder(file.path());
    world.set_command_listener(recorder.listener());
    for (int i = 0; i < 100; ++i) changes.change(world);
    const Snapshot back = world.save();
    for (int i = 0; i < 20; ++i) changes.change(world);
    world.restore(back);
    world.step(dt);
    recorder.close();
    const Recording recording(file.path());
    EXPECT_FALSE(recording.info().is_from_start);
    Replay replay(recording);
    while (replay.step()) {}
    EXPECT_FALSE(replay.divergence());
    EXPECT_EQ(replay.world().state_hash(), world.state_hash());
}

TEST(Recorded, ChangesAfterTheEndAreNotInTheFile) {
    const TemporaryFile file(".mcap");
    World world;
    {
        Recorder recorder(file.path());
        world.set_command_listener(recorder.listener());
        world.create_body();
        world.step(dt);
        recorder.close();
        recorder.close();
        world.step(dt);
        EXPECT_EQ(recorder.steps(), 1u);
    }
    world.step(dt); // without the recorder
    EXPECT_EQ(Recording(file.path()).info().steps, 1u);
}

TEST(Recorded, StepsOfAnyLengthAreFoundByTheirTime) {
    const TemporaryFile file(".mcap");
    Recorder recorder(file.path());
    World world;
    world.set_command_listener(recorder.listener());
    for (int i = 0; i < 60; ++i) world.step(1.0f / 60.0f);
    for (int i = 0; i < 30; ++i) world.step(1.0f / 30.0f);
    recorder.close();
    const Recording recording(file.path());
    EXPECT_NEAR(recording.info().seconds, 2.0, 1e-5);
    EXPECT_EQ(recording.steps_until(0.0), 0u);
    EXPECT_EQ(recording.steps_until(0.5), 30u);
    EXPECT_EQ(recording.steps_until(1.0), 60u);
    EXPECT_EQ(recording.steps_until(1.5), 75u);
    EXPECT_EQ(recording.steps_until(2.0), 90u);
    EXPECT_EQ(recording.steps_until(100.0), 90u);
    EXPECT_EQ(recording.steps_until(-1.0), 0u);
}

TEST(Recorded, BranchesGoOnWithWhatIsChangedThere) {
    const TemporaryFile file(".mcap");
    Recorder recorder(file.path());
    World world;
    world.set_command_listener(recorder.listener());
    BodyDef def;
    def.position = {0, 100, 0};
    const BodyId body = world.create_body(def);
    world.add_shape(body, Sphere{});
    for (int i = 0; i < 60; ++i) world.step(dt);
    world.body(body).apply_impulse({1, 0, 0});
    for (int i = 0; i < 60; ++i) world.step(dt);
    recorder.close();
    const Recording recording(file.path());
    Replay replay(recording);
    replay.seek(30);
    replay.branch();
    const double height = replay.world().body(replay.world().bodies()[0]).position().y;
    const Vec3 speed = replay.world().body(replay.world().bodies()[0]).linear_velocity();
    replay.world().destroy_body(replay.world().bodies()[0]);
    while (replay.step()) {}
    EXPECT_EQ(replay.refused_calls(), 1u);
    EXPECT_NE(replay.first_refusal().find("step 61: Body::apply_impulse"), std::string::npos) << replay.first_refusal();
    EXPECT_FALSE(replay.divergence());
    replay.seek(30);
    EXPECT_EQ(replay.world().body(replay.world().bodies()[0]).position().y, height); // the height before the branch
    replay.branch();
    WorldDef weightless = replay.world().settings();
    weightless.gravity = {0, 0, 0};
    replay.world().set_settings(weightless);
    while (replay.step()) {}
    EXPECT_NEAR(replay.world().body(replay.world().bodies()[0]).position().y, height + 1.5 * double(speed.y), 1e-3);
}

// The size of a file with that number of steps of 5,000 bodies, all of which move, bytes.
std::uint64_t bytes_of_steps(int steps) {
    const TemporaryFile file(".mcap");
    RecorderOptions options;
    options.keyframe_budget = 0;
    Recorder recorder(file.path(), options);
    World world(WorldDef{.gravity = {0, 0, 0}});
    world.set_command_listener(recorder.listener());
    std::mt19937 random(1);
    const auto somewhere = [&] { return double(random()) / 4294967296.0; };
    for (int i = 0; i < 5000; ++i) {
        BodyDef def;
        def.position = {100 * somewhere(), 100 * somewhere(), 100 * somewhere()};
        def.rotation = {float(somewhere()), float(somewhere()), float(somewhere()), 1.0f};
        def.linear_velocity = {float(somewhere()), float(somewhere()), float(somewhere())};
        const BodyId body = world.create_body(def);
        world.add_shape(body, Box{{0.3f, 0.3f, 0.3f}});
    }
    for (int i = 0; i < steps; ++i) world.step(dt);
    recorder.close();
    return std::filesystem::file_size(file.path());
}

TEST(Recorded, TenMinutesOfFiveThousandBodiesTakeLessThanTwoMegabytes) {
    constexpr int steps = 900; // of 36,000
    const std::uint64_t start = bytes_of_steps(1), some = bytes_of_steps(1 + steps);
    const double all = double(start) + double(some - start) * 36000 / steps;
    std::printf("%.0f bytes, %llu of them for the bodies\n", all, static_cast<unsigned long long>(start));
    EXPECT_LT(all, 2e6);
}

TEST(Recorder, NotesAreReadAgain) {
    const TemporaryFile file(".mcap");
    Recorder recorder(file.path(), {});
    World world;
    world.set_command_listener(recorder.listener());
    world.step(dt);
    recorder.note("looks", {{"color", "1 0 0"}, {"empty", ""}});
    EXPECT_THROW(recorder.note("cairn", {}), Error);
    recorder.close();
    recorder.note("late", {{"a", "b"}});
    const Recording recording(file.path());
    EXPECT_EQ(recording.note("looks"), (std::map<std::string, std::string>{{"color", "1 0 0"}, {"empty", ""}}));
    EXPECT_TRUE(recording.note("late").empty());
    EXPECT_EQ(recording.info().steps, 1u);
}

TEST(Recorder, RefusesWhatItCannotWriteAndTheWorldStaysAsItWas) {
    EXPECT_THROW(Recorder("/nowhere/run.mcap"), Error);
    RecorderOptions options;
    options.keyframe_work = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(Recorder(TemporaryFile(".mcap").path(), options), Error);
    World world;
    EXPECT_THROW(
        {
            Recorder recorder("/dev/full");
            world.set_command_listener(recorder.listener());
        },
        Error);
    EXPECT_EQ(world.step_count(), 0u);
    world.step(dt);
    EXPECT_EQ(world.step_count(), 1u);
}

TEST(Geometry, OfHullsMeshesAndHeightFieldsIsTheSameAgain) {
    std::mt19937 random(1);
    const auto number = [&] { return float(random() % 20001) / 10000.0f - 1.0f; };
    for (int round = 0; round < 300; ++round) {
        std::vector<Vec3> points(std::size_t(4 + round % 60));
        const float flat = round % 5 == 0 ? 0.01f : 1.0f;
        for (Vec3& p : points) {
            p.x = number(), p.y = flat * number(), p.z = number();
            if (round % 3 == 0) p = {std::round(p.x * 3) / 3, p.y, std::round(p.z * 3) / 3}; // many points in one plane
        }
        const Hull hull(points);
        const Shape again = recording::decode_geometry(recording::encode_geometry(hull), "hull");
        const Hull& copy = std::get<Hull>(again);
        ASSERT_EQ(recording::encode_geometry(copy), recording::encode_geometry(hull));
        ASSERT_EQ(copy.face_count(), hull.face_count());
        for (std::size_t f = 0; f < hull.face_count(); ++f)
            ASSERT_TRUE(std::equal(hull.face(f).begin(), hull.face(f).end(), copy.face(f).begin(), copy.face(f).end()));
        ASSERT_EQ(copy.volume(), hull.volume());
        std::vector<std::uint32_t> indices;
        for (int i = 0; i < 90; ++i) indices.push_back(std::uint32_t(random() % points.size()));
        SurfaceMaterials materials;
        if (round % 2 == 0) {
            materials.materials.resize(std::size_t(round % 400));
            for (Material& material : materials.materials) material.restitution = std::fabs(number());
            for (int i = 0; i < 30; ++i)
                materials.numbers.push_back(std::uint16_t(random() % (materials.materials.size() + 1)));
        }
        const Mesh mesh(points, indices, materials);
        const Shape mesh_again = recording::decode_geometry(recording::encode_geometry(mesh), "mesh");
        ASSERT_EQ(recording::encode_geometry(mesh_again), recording::encode_geometry(mesh));
        const SurfaceMaterials& read = std::get<Mesh>(mesh_again).materials();
        ASSERT_EQ(read.numbers, mesh.materials().numbers);
        ASSERT_EQ(read.materials.size(), materials.materials.size());
        for (std::size_t i = 0; i < read.materials.size(); ++i)
            ASSERT_EQ(read.materials[i].restitution, materials.materials[i].restitution);
    }
    const std::vector<float> heights{0, 1, 2, 3, 4, 5};
    const HeightField field(3, 2, {0.5f, 0.25f}, heights, {{Material{}}, {0, 1}});
    const Shape field_again = recording::decode_geometry(recording::encode_geometry(field), "height field");
    EXPECT_EQ(recording::encode_geometry(field_again), recording::encode_geometry(field));
}

} // namespace
} // namespace cairn::test
