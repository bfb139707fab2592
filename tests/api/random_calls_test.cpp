// Random API calls, valid and invalid, on three worlds that must stay identical (tests/fuzz/calls.h).
#include "../fuzz/calls.h"

#include <gtest/gtest.h>

#include <random>
#include <stdexcept>
#include <vector>

namespace {

class RandomCalls : public testing::TestWithParam<unsigned> {};

TEST_P(RandomCalls, LeaveThreeWorldsSaneAndTheSame) {
    std::mt19937 random(GetParam());
    std::vector<std::uint8_t> bytes(30000);
    for (std::uint8_t& byte : bytes) byte = std::uint8_t(random());
    cairn_fuzz::Calls calls(bytes, 100000);
    try {
        calls.run();
    } catch (const std::logic_error& broken) {
        FAIL() << "step " << calls.steps() << ": " << broken.what();
    }
    EXPECT_GT(calls.steps(), 300u);
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomCalls, testing::Range(1u, 9u));

} // namespace
