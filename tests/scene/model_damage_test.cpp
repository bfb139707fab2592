// MJCF, SDF and USD files with flipped bits, truncations, duplicated parts and huge numbers: each is rejected with a
// one-line message, or loads as a scene that runs and can be saved.
#include "scene_text.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <fstream>
#include <iterator>
#include <random>
#include <string>

namespace {

using namespace cairn;
using namespace cairn::scene_test;
using scene::Scene;

std::string corpus(const std::string& beginning, const std::string& name) {
    std::ifstream file(std::string(CAIRN_TEST_CORPUS "/").append(name));
    return std::string(beginning).append(std::istreambuf_iterator<char>(file), {});
}

// Applies one to three random changes of any kind.
std::string damaged(std::string text, std::mt19937& random) {
    const auto below = [&](std::size_t most) { return most == 0 ? 0 : random() % most; };
    const int changes = 1 + static_cast<int>(below(3));
    for (int i = 0; i < changes && !text.empty(); ++i) {
        const std::size_t at = below(text.size()), length = below(80);
        switch (random() % 7) {
        case 0:
            text[at] = static_cast<char>(text[at] ^ (1 << random() % 8));
            break;
        case 1:
            text.resize(at);
            break;
        case 2:
            text.erase(at, length);
            break;
        case 3:
            text.insert(at, text.substr(at, length));
            break;
        case 4: { // duplicates an element, or text that looks like one
            const std::size_t begin = text.find('<', at), end = text.find('>', std::min(begin, text.size()));
            if (end != std::string::npos) text.insert(begin, text.substr(begin, end + 1 - begin));
            break;
        }
        default: { // replaces a number
            const std::size_t begin = text.find_first_of("0123456789", at);
            if (begin == std::string::npos) break;
            static const char* const numbers[] = {"1e300", "-1e38",  "nan",         "inf", "0",
                                                  "-1",    "1e-300", "99999999999", "1e9"};
            const std::size_t end = std::min(text.find_first_not_of("0123456789.", begin), text.size());
            text.replace(begin, end - begin, numbers[random() % std::size(numbers)]);
            break;
        }
        }
    }
    return text;
}

void try_damaged(const std::string& whole, unsigned seed) {
    Scene scene = load_text(whole, "model");
    EXPECT_GT(scene.world.bodies().size(), 2u);
    EXPECT_GT(scene.world.joints().size(), 1u);
    std::mt19937 random(seed);
    int loaded = 0, refused = 0;
    double longest = 0.0;
    for (int i = 0; i < 10000; ++i) {
        const std::string text = damaged(whole, random);
        const auto begin = std::chrono::steady_clock::now();
        try {
            Scene one = load_text(text, "model");
            one.world.step(one.info.time_step);
            if (i % 10 == 0) load_text(scene::save_to_string(one));
            ++loaded;
        } catch (const Error& error) {
            const std::string said = error.what();
            EXPECT_EQ(said.find('\n'), std::string::npos) << said;
            EXPECT_EQ(said.find("model"), 0u) << said << "\n" << text;
            EXPECT_LT(said.size(), 600u) << said;
            EXPECT_TRUE(error.code() == ErrorCode::invalid_file || error.code() == ErrorCode::unsupported) << said;
            ++refused;
        }
        const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin;
        longest = std::max(longest, elapsed.count());
        if (testing::Test::HasFailure()) break;
    }
    EXPECT_GT(loaded, 300);
    EXPECT_GT(refused, 500);
    EXPECT_LT(longest, 10.0);
}

TEST(ModelDamage, Mjcf) { try_damaged(corpus("<mujoco", "mjcf/everything.xml"), 1); }
TEST(ModelDamage, Sdf) { try_damaged(corpus("<sdf", "sdf/everything.sdf"), 2); }
TEST(ModelDamage, Usd) { try_damaged(corpus("#usda 1.0\n", "usd/everything.usda"), 3); }

} // namespace
