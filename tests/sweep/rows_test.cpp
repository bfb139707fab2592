// Rows agree with closed forms, and do not depend on how they are distributed.
#include "plan_folder.h"

#include "sweep/run.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>

namespace cairn::test {
namespace {

class SweepRows : public PlanFolder {
  protected:
    static constexpr const char* drops = R"json("sample": {"random": 700},
        "parameters": [{"name": "h", "from": 0.5, "to": 3}, {"name": "v", "mean": 1, "deviation": 2}],
        "set": {"ball.position.y": "h", "ball.velocity.x": "v", "ball.mass": "v > 4.5 ? -1 : 2"}, "seconds": 0.3,
        "stop": "ball.position.x > 0.8",
        "measure": [{"name": "y", "of": "ball.position.y"}, {"name": "top", "of": "ball.speed", "take": "max"}])json";

    // All rows in the folder, exact to the bit.
    static std::vector<double> stored(const sweep::Store& store) {
        std::vector<double> all;
        store.read([&](std::uint64_t row, std::span<const double> numbers) {
            all.push_back(static_cast<double>(row));
            all.insert(all.end(), numbers.begin(), numbers.end());
        });
        return all;
    }
    static bool are_same(const std::vector<double>& a, const std::vector<double>& b) {
        return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
    }
    static void run_all(const sweep::Plan& plan, const sweep::Start& start, sweep::Store& store, int threads) {
        sweep::LocalSource source;
        sweep::run_chunks(plan, start, store, store.missing(), threads, source,
                          [](const sweep::Count&) { return true; });
        store.look();
    }
};

TEST_F(SweepRows, ABallLandsWhenTheFormulaSaysSo) {
    write_scene();
    const std::vector<Row> rows = rows_of(plan(R"json("sample": {"sobol": 30}, "seconds": 2,
        "parameters": [{"name": "h", "from": 0.5, "to": 4}, {"name": "g", "from": 3, "to": 20}],
        "set": {"ball.position.y": "h + 0.1", "world.gravity.y": "-g"},
        "measure": [{"name": "landed", "of": "ball.touches.floor", "take": "first"},
                    {"name": "fastest", "of": "ball.speed", "take": "max"},
                    {"name": "rest", "of": "ball.speed < 0.001", "take": "since"},
                    {"name": "lowest", "of": "ball.position.y", "take": "min"},
                    {"name": "early", "of": "ball.position.y", "at": 0.1}])json"));
    for (const Row& row : rows) {
        const double h = row.at("h"), g = row.at("g"), fall = std::sqrt(2.0 * h / g);
        EXPECT_NEAR(row.at("landed"), fall, 0.01);
        EXPECT_NEAR(row.at("fastest"), std::sqrt(2.0 * g * h), 0.02 * std::sqrt(2.0 * g * h));
        EXPECT_NEAR(row.at("rest"), fall, 0.05);
        EXPECT_NEAR(row.at("lowest"), 0.1, 0.01);
        EXPECT_NEAR(row.at("early"), h + 0.1 - 0.5 * g * 0.01, 0.02 * g * 0.1);
        EXPECT_EQ(row.at("outcome"), 0.0);
    }
}

TEST_F(SweepRows, ACrateSlidesAsFarAsItsFrictionLetsIt) {
    write_scene();
    const std::vector<Row> rows = rows_of(plan(R"json("seconds": 4,
        "parameters": [{"name": "mu", "from": 0.2, "to": 0.8, "count": 4}, {"name": "v", "values": [1, 3]}],
        "set": {"'wide crate'.friction": "mu", "floor.friction": "1", "'wide crate'.velocity.z": "v"},
        "measure": [{"name": "way", "of": "'wide crate'.position.z"},
                    {"name": "ratio", "of": "way / (v * v / (2 * mu * 9.81))"}])json"));
    ASSERT_EQ(rows.size(), 8u);
    for (const Row& row : rows) EXPECT_NEAR(row.at("ratio"), 1.0, 0.03) << row.at("mu") << " " << row.at("v");
}

TEST_F(SweepRows, ARuleStopsARowAndWhatComesLaterIsNoNumber) {
    write_scene();
    const std::vector<Row> rows = rows_of(plan(R"json("seconds": 2, "stop": ["time > 5", "ball.position.y < 1"],
        "measure": [{"name": "y", "of": "ball.position.y"}, {"name": "late", "of": "ball.position.y", "at": [0.1, 1]},
                    {"name": "never", "of": "ball.position.y > 3", "take": "first"}])json"));
    EXPECT_EQ(rows[0].at("outcome"), 1.0);
    EXPECT_LT(rows[0].at("y"), 1.0);
    EXPECT_GT(rows[0].at("y"), 0.95);
    EXPECT_NEAR(rows[0].at("time"), std::sqrt(2.0 / 9.81), 0.01);
    EXPECT_FALSE(std::isnan(rows[0].at("late_0")));
    EXPECT_TRUE(std::isnan(rows[0].at("late_1")));
    EXPECT_TRUE(std::isnan(rows[0].at("never")));
}

TEST_F(SweepRows, AnyNumberOfThreadsAndAnyOrderGiveTheSameBytes) {
    write_scene();
    const sweep::Plan read = plan(drops);
    const sweep::Start start = sweep::load_start(read);
    std::vector<double> expected;
    for (const int threads : {1, 2, 5}) {
        sweep::Store store(folder_ / std::to_string(threads), read, start);
        run_all(read, start, store, threads);
        const std::vector<double> rows = stored(store);
        ASSERT_EQ(rows.size(), 700 * (read.numbers() + 1));
        if (expected.empty()) expected = rows;
        EXPECT_TRUE(are_same(rows, expected)) << threads;
    }
    // One row at a time, backwards.
    sweep::Runner runner(read, start);
    const std::size_t width = read.numbers() + 1;
    const std::atomic<bool> never{false};
    std::size_t failed = 0, stopped = 0;
    for (std::size_t row = 700; row-- > 0;) {
        std::vector<double> numbers(read.numbers());
        runner.run(row, numbers, never);
        EXPECT_EQ(std::memcmp(numbers.data(), &expected[row * width + 1], numbers.size() * sizeof(double)), 0) << row;
        failed += numbers.back() == 2.0 ? 1 : 0, stopped += numbers.back() == 1.0 ? 1 : 0;
        EXPECT_EQ(numbers.back() == 2.0, numbers[1] > 4.5);
        EXPECT_EQ(numbers.back() == 2.0, runner.failure().find("mass") != std::string::npos) << runner.failure();
    }
    EXPECT_GT(failed, 5u);
    EXPECT_GT(stopped, 50u);
}

TEST_F(SweepRows, WhateverIsCutOffOrDamagedIsRunAgain) {
    write_scene();
    const sweep::Plan read = plan(drops);
    const sweep::Start start = sweep::load_start(read);
    sweep::Store store(folder_ / "out", read, start);
    run_all(read, start, store, 1);
    const std::vector<double> expected = stored(store);
    const fs::path shard = folder_ / "out" / "shards" / "0.rows";
    std::ifstream stream(shard, std::ios::binary);
    const std::string whole{std::istreambuf_iterator<char>(stream), {}};
    std::mt19937 random(3);
    for (int i = 0; i < 12; ++i) {
        const std::size_t place = std::uniform_int_distribution<std::size_t>(0, whole.size() - 1)(random);
        std::string damaged = whole.substr(0, place);
        if (i % 2 == 0 && place > 100) damaged.back() = static_cast<char>(damaged.back() ^ 1);
        fs::remove_all(folder_ / "out" / "shards");
        fs::create_directories(folder_ / "out" / "shards");
        std::ofstream(shard, std::ios::binary) << damaged;
        sweep::Store again(folder_ / "out", read, start);
        EXPECT_FALSE(again.missing().empty());
        // Rows before the damage are kept.
        EXPECT_GE((again.chunks().count - again.missing().size() + 2) * (16 + 8 * read.numbers()) + 40, place);
        run_all(read, start, again, 2);
        EXPECT_TRUE(again.missing().empty());
        EXPECT_TRUE(are_same(stored(again), expected)) << place;
    }
}

TEST_F(SweepRows, AFolderOfAnotherPlanOrSceneIsRefused) {
    write_scene();
    const std::string members = "\"seconds\": 0.1, \"measure\": [{\"name\": \"y\", \"of\": \"ball.position.y\"}]";
    const sweep::Plan first = plan(members);
    const sweep::Start start = sweep::load_start(first);
    {
        sweep::Store store(folder_ / "out", first, start);
        run_all(first, start, store, 1);
    }
    EXPECT_TRUE(sweep::Store(folder_ / "out", first, start).missing().empty());
    const sweep::Plan longer = plan("\"seconds\": 0.2, \"measure\": [{\"name\": \"y\", \"of\": \"ball.position.y\"}]");
    EXPECT_THROW(sweep::Store(folder_ / "out", longer, sweep::load_start(longer)), Error);
    write_scene(0.5f);
    const sweep::Plan same = plan(members);
    EXPECT_THROW(sweep::Store(folder_ / "out", same, sweep::load_start(same)), Error);
    write("file", "");
    EXPECT_THROW(sweep::Store(folder_ / "file" / "out", first, start), Error);
}

TEST_F(SweepRows, AJointThatBreaksHasNoLoad) {
    write_scene();
    const std::vector<Row> rows = rows_of(plan(R"json("seconds": 0.5,
        "parameters": [{"name": "strength", "values": [1, 1e9]}], "set": {"hinge.break_force": "strength"},
        "measure": [{"name": "broken", "of": "hinge.broken"}, {"name": "load", "of": "hinge.load"},
                    {"name": "angle", "of": "hinge.position"}])json"));
    EXPECT_EQ(rows[0].at("broken"), 1.0);
    EXPECT_TRUE(std::isnan(rows[0].at("load")));
    EXPECT_EQ(rows[1].at("broken"), 0.0);
    EXPECT_NEAR(rows[1].at("load"), 1000.0 * 0.2 * 2.0 * 0.5 * 9.81, 30.0); // density x volume x gravity
    EXPECT_NEAR(rows[1].at("angle"), 0.0, 1e-3);
}

} // namespace
} // namespace cairn::test
