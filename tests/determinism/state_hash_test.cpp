// The same inputs give the same bits: with every instruction set, in every run, and as recorded.
#include "scenes.h"

#include <gtest/gtest.h>

#include <array>
#include <cinttypes>
#include <cstdio>
#include <string>
#include <sys/wait.h>

namespace cairn_test {
namespace {

class Determinism : public testing::TestWithParam<NamedScene> {};
INSTANTIATE_TEST_SUITE_P(Scenes, Determinism, testing::ValuesIn(scenes().begin(), scenes().end()),
                         [](const testing::TestParamInfo<NamedScene>& info) { return std::string(info.param.name); });

struct ChildResult {
    int status = -1;
    std::string instruction_set, hash;
};

// Runs cairn_hashes, which ./dev determinism also builds for other machines.
ChildResult run_child(const std::string& instruction_set, const std::string& scene) {
    const std::string command = "CAIRN_ISA=" + instruction_set + " '" CAIRN_HASHES "' --steps " +
                                std::to_string(golden_steps) + " " + scene + " 2>&1";
    ChildResult result;
    std::FILE* pipe = popen(command.c_str(), "r");
    if (!pipe) return result;
    std::array<char, 64> isa{}, hash{};
    const int read = std::fscanf(pipe, "%63s %*s %*s %63s", isa.data(), hash.data());
    const int status = pclose(pipe);
    if (read == 2 && WIFEXITED(status)) result = {WEXITSTATUS(status), isa.data(), hash.data()};
    return result;
}

std::string hexadecimal(std::uint64_t value) {
    std::array<char, 17> text{};
    std::snprintf(text.data(), text.size(), "%016" PRIx64, value);
    return text.data();
}

TEST_P(Determinism, EveryInstructionSetGivesTheSameState) {
    const std::string here = hexadecimal(hash_after(GetParam().make(), golden_steps));
#if defined(__x86_64__)
    std::vector<std::string> sets{"scalar", "sse2"};
    if (__builtin_cpu_supports("avx2")) sets.push_back("avx2");
    if (__builtin_cpu_supports("avx512vl")) sets.push_back("avx512");
#elif defined(__aarch64__)
    const std::vector<std::string> sets{"scalar", "neon"};
#else
    const std::vector<std::string> sets{"scalar"};
#endif
    for (const std::string& set : sets) {
        const ChildResult child = run_child(set, GetParam().name);
        EXPECT_EQ(child.status, 0) << set;
        EXPECT_EQ(child.instruction_set, set);
        EXPECT_EQ(child.hash, here) << set;
    }
}

TEST_P(Determinism, TwoRunsInOneProcessGiveTheSameStateAtEveryStep) {
    Scene& scene = GetParam().make();
    cairn::World first{scene.settings()}, second{scene.settings()};
    scene.build(first);
    scene.build(second);
    EXPECT_EQ(first.state_hash(), second.state_hash());
    const std::uint64_t start = first.state_hash();
    for (int i = 0; i < golden_steps; ++i) {
        scene.step(first);
        scene.step(second);
        ASSERT_EQ(first.state_hash(), second.state_hash()) << "step " << i;
    }
    EXPECT_NE(first.state_hash(), start);
}

TEST_P(Determinism, StateIsTheRecordedOne) {
    EXPECT_EQ(hexadecimal(hash_after(GetParam().make(), golden_steps)), hexadecimal(GetParam().golden_hash))
        << "if the engine's arithmetic was meant to change: cairn_determinism_test --print-golden-hashes";
}

TEST(StateHash, ChangesWithOneBitOfOneVelocity) {
    cairn::World world;
    const cairn::BodyId body = world.create_body();
    world.add_shape(body, cairn::Sphere{});
    world.body(body).set_linear_velocity({1, 0, 0});
    const std::uint64_t before = world.state_hash();
    world.body(body).set_linear_velocity({1.00000012f, 0, 0});
    EXPECT_NE(world.state_hash(), before);
    world.body(body).set_linear_velocity({1, 0, 0});
    EXPECT_EQ(world.state_hash(), before);
}

} // namespace
} // namespace cairn_test
