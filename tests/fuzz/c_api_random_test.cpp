// The fuzzer of the C API with random bytes, the same in every run: a few seconds of fuzzing as a test.
#include "c_api_fuzz.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace {

TEST(CApiRandomCalls, LeaveWorldsSaneAndReachEveryCallBothWays) {
    std::mt19937 random(1);
    std::vector<std::uint8_t> bytes(3000);
    for (int sequence = 0; sequence < 1000; ++sequence) {
        for (std::uint8_t& byte : bytes) byte = std::uint8_t(random());
        LLVMFuzzerTestOneInput(bytes.data(), bytes.size()); // aborts if a condition does not hold
    }
    for (const auto& [name, count] : cairn_fuzz::c_call_counts()) {
        const bool has_no_file = name == "scene_load" || name == "scene_save"; // these calls need a file
        EXPECT_GT(count.accepted + has_no_file, 0u) << name;
        EXPECT_GT(count.refused + !count.can_fail, 0u) << name;
    }
}

} // namespace
