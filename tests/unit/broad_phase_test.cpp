// The broad phase compared with brute force: no pair is missed, none is reported twice, and every code path that leads
// to the same boxes gives the same pairs in the same order.
#include "allocation_count.h"
#include "broad_phase_scene.h"

#include <chrono>
#include <cstdio>
#include <cstring>
#include <limits>
#include <type_traits>

namespace cairn {
namespace {

TEST(BroadPhase, FindsEveryPairOfMovingBoxes) {
    Scene scene(1, 6);
    for (int i = 0; i < 400; ++i) scene.add(Kind::awake, 0.1, 0.6);
    for (int step = 0; step < 60; ++step) {
        scene.move(step % 20 < 10 ? 1 : 0.02, 0.08);
        scene.update();
        scene.check();
    }
    EXPECT_GT(scene.sink.live.size(), 100u);
}

TEST(BroadPhase, FindsEveryPairUnderChurnSleepAndTeleports) {
    for (const std::uint64_t seed : {11u, 12u, 13u}) {
        Scene scene(seed, 7);
        scene.sink.refuse_some = seed == 12;
        fill(scene);
        std::map<std::uint32_t, std::vector<std::uint32_t>> asleep;
        std::uint32_t kept = 0;
        for (int step = 0; step < 120; ++step) {
            stir(scene, step, asleep);
            scene.update();
            scene.check();
            kept = std::max(kept, scene.broad.counts().sleeping_pairs);
            ASSERT_FALSE(HasFailure()) << "seed " << seed << " step " << step;
        }
        EXPECT_GT(kept, 20u);
        EXPECT_GT(scene.broad.counts().large, 0u);
    }
}

// Shapes that move by many times their size per step scatter over the whole scene before the tree is sorted again. The
// sleeping islands have one shape or several, some of which have been removed.
TEST(BroadPhase, WhatHasFlownApartFindsAllThatSleeps) {
    Scene scene(14, 20);
    for (int i = 0; i < 40; ++i) scene.add(Kind::fixed, 0.3, 1);
    std::vector<std::uint32_t> sleepers;
    for (int i = 0; i < 600; ++i) sleepers.push_back(scene.add(Kind::awake, 0.2, 0.8));
    scene.update();
    std::uint32_t key = 0;
    for (std::size_t i = 0; i < sleepers.size();) {
        const std::size_t size = std::min<std::size_t>(i < 300 ? 1 : 1 + i % 12, sleepers.size() - i);
        scene.sleep(key++, {sleepers.begin() + std::ptrdiff_t(i), sleepers.begin() + std::ptrdiff_t(i + size)});
        i += size;
    }
    for (int i = 0; i < 150; ++i) scene.add(Kind::awake, 0.05, 0.3);
    for (int step = 0; step < 30; ++step) {
        scene.move(1, 4);
        if (step % 3 == 0) scene.remove(sleepers[std::size_t(step * 19 + 5)]);
        scene.update();
        scene.check();
        ASSERT_FALSE(HasFailure()) << "step " << step;
    }
    EXPECT_GT(scene.sink.live.size(), 200u);
}

TEST(BroadPhase, WorksTenMillionMetersOut) {
    Scene scene(21, 7, {1e7, -1e7, 3e6});
    fill(scene);
    std::map<std::uint32_t, std::vector<std::uint32_t>> asleep;
    for (int step = 0; step < 60; ++step) {
        stir(scene, step, asleep);
        scene.update();
        scene.check(); // with a slack of 1 mm: the boxes are not coarse
        ASSERT_FALSE(HasFailure()) << step;
    }
}

// The log of the sink in a run, followed by the pairs at its end in the order in which they are walked.
std::vector<std::uint32_t> run_log(std::uint64_t seed, const char* isa, bool search_all, int threads = 1,
                                   bool moves_together = false) {
    Scene scene(seed, 7, {}, isa);
    ThreadPool thread_pool(threads);
    scene.thread_pool = &thread_pool;
    scene.moves_together = moves_together;
    scene.broad.set_search_all(search_all);
    fill(scene);
    std::map<std::uint32_t, std::vector<std::uint32_t>> asleep;
    std::vector<std::uint32_t> log;
    for (int step = 0; step < 120; ++step) {
        stir(scene, step, asleep);
        scene.update();
        scene.broad.for_each_pair([&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
            log.insert(log.end(), {a, b, c});
        });
    }
    log.insert(log.end(), scene.sink.log.begin(), scene.sink.log.end());
    return log;
}

TEST(BroadPhase, PartialSearchEqualsFullSearch) {
    const std::vector<std::uint32_t> partial = run_log(31, nullptr, false);
    EXPECT_GT(partial.size(), 10000u);
    EXPECT_TRUE(partial == run_log(31, nullptr, true));
}

TEST(BroadPhase, TwoRunsAreEqual) { EXPECT_TRUE(run_log(32, nullptr, false) == run_log(32, nullptr, false)); }

TEST(BroadPhase, AnyNumberOfThreadsFindsTheSame) {
    const std::vector<std::uint32_t> reference = run_log(34, nullptr, false);
    for (const int threads : {2, 3, 7}) EXPECT_TRUE(reference == run_log(34, nullptr, false, threads)) << threads;
}

TEST(BroadPhase, ShapesMovedTogetherAreAsThoseMovedOneByOne) {
    const std::vector<std::uint32_t> reference = run_log(35, nullptr, false);
    for (const int threads : {1, 3}) EXPECT_TRUE(reference == run_log(35, nullptr, false, threads, true)) << threads;
}

TEST(BroadPhase, InstructionSetsAreEqual) {
    const std::vector<std::uint32_t> reference = run_log(33, "scalar", false);
    for (const char* isa : {"sse2", "avx2", "avx512", "neon"})
        EXPECT_TRUE(!kernels_named(isa) || reference == run_log(33, isa, false)) << isa;
}

// An archive that writes to a list of bytes, or reads from it.
struct Archive {
    std::vector<unsigned char> bytes;
    std::size_t at = 0;
    bool loads = false;
    void raw(void* data, std::size_t size) {
        if (size == 0) return;
        if (!loads)
            bytes.insert(bytes.end(), static_cast<unsigned char*>(data), static_cast<unsigned char*>(data) + size);
        else
            std::memcpy(data, bytes.data() + at, size), at += size;
    }
    template <class T> void operator()(T& value) {
        static_assert(std::is_trivially_copyable_v<T>);
        raw(&value, sizeof value);
    }
    template <class T> void operator()(std::vector<T>& list) {
        static_assert(std::is_trivially_copyable_v<T>);
        std::uint64_t size = list.size();
        raw(&size, sizeof size);
        list.resize(size);
        raw(list.data(), size * sizeof(T));
    }
};

TEST(BroadPhase, RestoredCopyContinuesEqually) {
    for (const int saved_at : {3, 37, 71}) {
        Scene scene(41, 7), copy(41, 7, {}, "scalar");
        fill(scene);
        fill(copy); // different contents, to be overwritten
        std::map<std::uint32_t, std::vector<std::uint32_t>> asleep, copy_asleep;
        for (int step = 0; step < 110; ++step) {
            stir(scene, step, asleep);
            if (step > saved_at) stir(copy, step, copy_asleep);
            if (step == saved_at) { // between the calls and the update that processes them
                Archive archive;
                scene.broad.serialize(archive);
                archive.loads = true;
                copy.broad.serialize(archive);
                EXPECT_EQ(archive.at, archive.bytes.size());
                copy.random = scene.random, copy.shapes = scene.shapes, copy.sink = scene.sink;
                copy.pending_free = scene.pending_free, copy.free_indices = scene.free_indices;
                copy_asleep = asleep;
            }
            scene.update();
            if (step >= saved_at) copy.update();
        }
        EXPECT_TRUE(scene.sink.log == copy.sink.log);
        Archive first, second;
        scene.broad.serialize(first);
        copy.broad.serialize(second);
        EXPECT_TRUE(first.bytes == second.bytes);
    }
}

TEST(BroadPhase, SleepKeepsContactsUntilAShapeWakes) {
    BroadPhase broad(kernels().broad);
    Recorder sink;
    const auto cube = [](double x) { return DBounds{{x - 0.5, 0, -0.5}, {x + 0.5, 1, 0.5}}; };
    broad.add(0, {{-50, -1, -50}, {50, 0, 50}}, Mobility::fixed);
    for (std::uint32_t i = 1; i <= 4; ++i) broad.add(i, cube(i), Mobility::awake);
    broad.update(sink);
    const std::map<Pair, std::uint32_t> before = sink.live; // 4 pairs with the ground, 3 of the others with each other
    EXPECT_EQ(before.size(), 7u);
    broad.put_to_sleep(5, std::vector<std::uint32_t>{1, 2});
    broad.update(sink);
    broad.put_to_sleep(6, std::vector<std::uint32_t>{3, 4});
    broad.update(sink);
    std::size_t walked = 0, kept = 0;
    broad.for_each_pair([&](std::uint32_t, std::uint32_t, std::uint32_t) { ++walked; });
    for (const std::uint32_t key : {5u, 6u})
        broad.for_each_sleeping_pair(key, [&](std::uint32_t, std::uint32_t, std::uint32_t) { ++kept; });
    EXPECT_EQ(walked, 0u);
    EXPECT_EQ(kept, 6u); // all pairs except the one between the islands
    broad.wake(6);
    broad.set_bounds(4, cube(9));
    broad.update(sink);
    broad.for_each_pair([&](std::uint32_t, std::uint32_t, std::uint32_t) { ++walked; });
    EXPECT_EQ(walked, 3u); // 3 and 4 with the ground, 3 with the sleeping 2
    broad.remove(0);
    broad.wake(5);
    broad.update(sink);
    EXPECT_EQ(sink.live, (std::map<Pair, std::uint32_t>{{{1, 2}, before.at({1, 2})}, {{2, 3}, before.at({2, 3})}}));
    EXPECT_EQ(sink.next_contact, 7u);
}

TEST(BroadPhase, RemovedGroundEndsPairsOfSleepers) {
    BroadPhase broad(kernels().broad);
    Recorder sink;
    broad.add(0, {{-5, -1, -5}, {5, 0, 5}}, Mobility::fixed);
    broad.add_plane(1, {0, 0, 0}, {0, 1, 0});
    broad.add(2, {{0, 0, 0}, {1, 1, 1}}, Mobility::awake);
    broad.update(sink);
    EXPECT_EQ(sink.live.size(), 2u);
    broad.put_to_sleep(0, std::vector<std::uint32_t>{2});
    broad.update(sink);
    EXPECT_EQ(sink.live.size(), 2u);
    broad.remove(0);
    broad.update(sink);
    EXPECT_EQ(sink.live.size(), 1u);
    broad.remove(1);
    broad.update(sink);
    EXPECT_EQ(sink.live.size(), 0u);
}

TEST(BroadPhase, ShapeThatMovesSleepsWakesAndMovesBetweenUpdatesIsFound) {
    BroadPhase broad(kernels().broad);
    Recorder sink;
    const auto cube = [](double x) { return DBounds{{x, 0, 0}, {x + 1, 1, 1}}; };
    for (std::uint32_t i = 0; i < 30; ++i) broad.add(i, cube(3.0 * i), Mobility::awake);
    broad.update(sink);
    EXPECT_TRUE(sink.live.empty());
    broad.set_bounds(4, cube(200));
    broad.put_to_sleep(0, std::vector<std::uint32_t>{4});
    broad.wake(0);
    broad.set_bounds(4, cube(3.0 * 15 + 0.5));
    broad.update(sink);
    EXPECT_EQ(sink.live.size(), 1u);
    EXPECT_TRUE(sink.live.count({4, 15}));
}

// With so few shapes the tree is never sorted, and the sort is when the origin of the floats may move.
TEST(BroadPhase, FewShapesFarOutHaveBoxesThatAreNotCoarse) {
    BroadPhase broad(kernels().broad);
    Recorder sink;
    for (std::uint32_t i = 0; i < 4; ++i) {
        const DVec3 corner = {1e7 + 1.3 * i, 5e6, -1e7};
        broad.add(i, {corner, corner + DVec3{1, 1, 1}}, Mobility::awake);
    }
    broad.update(sink);
    EXPECT_TRUE(sink.live.empty());
}

// A body may be far from all others: its box is coarse, but none of its pairs is missed.
TEST(BroadPhase, LonelyPairFarFromTheOriginIsFound) {
    Scene scene(25, 6);
    fill(scene);
    const DVec3 corner = {3e7, 1e7, -2e7};
    scene.broad.add(500, {corner, corner + DVec3{1, 1, 1}}, Mobility::awake);
    scene.broad.add(501, {corner + DVec3{1, 0, 0}, corner + DVec3{2, 1, 1}}, Mobility::fixed);
    scene.update();
    EXPECT_TRUE(scene.sink.live.count({500, 501}));
}

TEST(BroadPhase, RefilterAsksAgain) {
    BroadPhase broad(kernels().broad);
    Recorder sink;
    sink.refuse_some = sink.refilters = true;
    broad.add(3, {{0, 0, 0}, {1, 1, 1}}, Mobility::awake);
    broad.add(4, {{0, 1, 0}, {1, 2, 1}}, Mobility::awake);
    for (int i = 0; i < 3; ++i) broad.update(sink);
    EXPECT_EQ(sink.log.size(), 4u); // one log entry: the pair was filtered once in three updates
    sink.refuse_some = false;
    broad.refilter(4);
    broad.update(sink);
    EXPECT_EQ(sink.live.size(), 1u);
    sink.refuse_some = true;
    broad.refilter(3);
    broad.update(sink);
    EXPECT_EQ(sink.live.size(), 0u);
}

TEST(BroadPhase, BoundsThatAreNoNumbersAreBoundless) {
    const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
    Scene scene(61, 5);
    for (int i = 0; i < 100; ++i) scene.add(Kind::awake, 0.1, 0.5);
    scene.broad.add(200, {{nan, nan, nan}, {nan, nan, nan}}, Mobility::awake);
    scene.broad.add(201, {{-inf, 0, -1e300}, {inf, 1, 1e300}}, Mobility::fixed);
    CountingSink sink;
    scene.broad.update(sink);
    std::size_t with_boundless = 0;
    scene.broad.for_each_pair(
        [&](std::uint32_t a, std::uint32_t b, std::uint32_t) { with_boundless += a == 200 || b == 200; });
    EXPECT_EQ(with_boundless, 101u);
    scene.broad.set_bounds(200, {{0, 0, 0}, {1, 1, 1}}, {float(nan), float(inf), 0});
    scene.broad.set_bounds(0, {{0, 0, 0}, {1, 1, 1}}, {1e38f, 0, -1e38f});
    scene.broad.update(sink);
    EXPECT_GT(sink.lost, 50u);
}

// Awake shapes that fall far from their start move the origin of the trees along.
TEST(BroadPhase, OriginFollows) {
    Scene scene(71, 6);
    fill(scene);
    scene.update();
    for (Scene::Shape& s : scene.shapes)
        if (s.kind == Kind::awake) s.center += DVec3{3e6, -2e6, 5e6};
    scene.offset = {3e6, -2e6, 5e6};
    for (int step = 0; step < 40; ++step) {
        scene.slack = step < 20 ? 2.0 : 1e-3; // float bounds are coarse until the next sort
        scene.move(1, 0.05);
        scene.update();
        scene.check();
    }
}

TEST(BroadPhase, SteadyStateAllocatesNothing) {
    Scene scene(81, 9);
    fill(scene);
    for (int i = 0; i < 1500; ++i) scene.add(Kind::awake, 0.1, 0.5);
    CountingSink sink;
    std::vector<std::uint32_t> island;
    for (std::uint32_t i = 0; i < 40; ++i) island.push_back(i);
    const std::vector<Scene::Shape> home = scene.shapes;
    // The motion goes back and forth, so that all buffers have reached their final size.
    const auto cycle = [&](int steps) {
        for (int step = 0; step < steps; ++step) {
            const int phase = step % 32 < 16 ? step % 32 : 32 - step % 32;
            for (std::uint32_t i = 0; i < home.size(); ++i) {
                Scene::Shape& s = scene.shapes[i];
                if (s.kind != Kind::awake || (step % 8 < 4 && i < island.size())) continue;
                const double reach = 0.01 * (i % 8) * phase;
                const DVec3 target = home[i].center + DVec3{reach, i % 3 == 0 ? reach : 0.0, -reach};
                scene.broad.set_bounds(i, {target - s.half, target + s.half}, math::to_float(target - s.center));
                s.center = target;
            }
            if (step % 8 == 0) scene.broad.put_to_sleep(1, island);
            if (step % 8 == 4) scene.broad.wake(1);
            scene.broad.update(sink);
        }
    };
    cycle(640);
    const std::size_t before = allocation_count(), bytes = scene.broad.bytes();
    cycle(640);
    EXPECT_EQ(allocation_count(), before);
    EXPECT_EQ(scene.broad.bytes(), bytes);
    EXPECT_GT(sink.lost, 1000u);
}

// Timings for information, on any machine; only the counts are checked.
TEST(BroadPhase, TwentyThousandItems) {
    using Clock = std::chrono::steady_clock;
    const auto ms = [](Clock::time_point since) {
        return std::chrono::duration<double, std::milli>(Clock::now() - since).count();
    };
    Scene scene(91, 15);
    CountingSink sink;
    auto start = Clock::now();
    for (int i = 0; i < 20000; ++i) scene.add(Kind::awake, 0.3, 0.5);
    scene.broad.update(sink);
    std::printf("add and first update %.2f ms, %u pairs\n", ms(start), scene.broad.counts().pairs);
    for (const double share : {1.0, 0.02, 0.001, 0.0}) {
        double set = 0, update = 0, worst = 0;
        std::uint32_t moved = 0, searched = 0;
        std::vector<NewBounds> bounds;
        ThreadPool thread_pool(1);
        constexpr int steps = 60;
        for (int step = 0; step < steps; ++step) {
            bounds.clear();
            for (std::uint32_t i = 0; i < 20000; ++i) {
                Scene::Shape& s = scene.shapes[i];
                s.velocity = scene.random.between(0, 1) < share ? Vec3{0.02f, -0.03f, 0.01f} : Vec3{};
                s.center += math::to_double(s.velocity);
                bounds.push_back({i, Scene::tight(s), s.velocity});
            }
            start = Clock::now();
            scene.broad.set_bounds(bounds, thread_pool);
            set += ms(start);
            start = Clock::now();
            scene.broad.update(sink);
            worst = std::max(worst, ms(start));
            update += ms(start);
            moved += scene.broad.counts().moved, searched += scene.broad.counts().leaves_searched;
        }
        std::printf(
            "share moved %5.3f: boxes left %5u, leaves searched %4u of 2500, set %.3f ms, update %.3f ms, worst %.2f\n",
            share, moved / steps, searched / steps, set / steps, update / steps, worst);
    }
    EXPECT_EQ(scene.broad.counts().awake, 20000u);
    std::printf("%.1f MB\n", double(scene.broad.bytes()) / 1e6);

    // A hundred thousand sleeping shapes below cost a step nothing.
    std::uint32_t next = 20000;
    start = Clock::now();
    for (std::uint32_t island = 0; island < 10000; ++island) {
        std::vector<std::uint32_t> members;
        for (int k = 0; k < 10; ++k) {
            const DVec3 corner = {double(island % 100) * 3 + k * 0.2, -100.0, double(island / 100) * 3};
            scene.broad.add(next, {corner, corner + DVec3{0.3, 0.3, 0.3}}, Mobility::awake);
            members.push_back(next++);
        }
        scene.broad.put_to_sleep(island, members);
    }
    scene.broad.update(sink);
    std::printf("100,000 fall asleep %.2f ms\n", ms(start));
    start = Clock::now();
    for (int step = 0; step < 100; ++step) scene.broad.update(sink);
    std::printf("update beside them %.4f ms\n", ms(start) / 100);
    start = Clock::now();
    scene.broad.wake(77);
    scene.broad.update(sink);
    std::printf("one island wakes %.4f ms\n", ms(start));
    EXPECT_EQ(scene.broad.counts().sleeping, 99990u);
}

} // namespace
} // namespace cairn
