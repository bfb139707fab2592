// Helpers of the tests of physics. Numbers in tests named "row n" are rows of the table in docs/validation.md.
#pragma once

#include "validation/worlds.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace cairn_test {

using namespace cairn;
using namespace cairn::validation;

inline std::vector<Vec3> box_corners(const Vec3& half) {
    std::vector<Vec3> result;
    for (int i = 0; i < 8; ++i)
        result.push_back({i & 1 ? half.x : -half.x, i & 2 ? half.y : -half.y, i & 4 ? half.z : -half.z});
    return result;
}

// A flat floor about the origin, of `cells` x `cells` square cells with edges of `width` m, each divided into two
// triangles.
inline Mesh flat_mesh(int cells, float width) {
    std::vector<Vec3> corners;
    std::vector<std::uint32_t> triangles;
    const float first = -0.5f * float(cells) * width;
    for (int x = 0; x <= cells; ++x)
        for (int z = 0; z <= cells; ++z) corners.push_back({first + float(x) * width, 0, first + float(z) * width});
    const auto row = std::uint32_t(cells) + 1;
    for (std::uint32_t x = 0; x + 1 < row; ++x)
        for (std::uint32_t z = 0; z + 1 < row; ++z) {
            const std::uint32_t at = x * row + z, beside = at + row;
            triangles.insert(triangles.end(), {at, at + 1, beside + 1, at, beside + 1, beside});
        }
    return Mesh(corners, triangles);
}

// A test that runs with several step lengths; the parameter is the number of steps per second.
class EveryStep : public testing::TestWithParam<int> {
  protected:
    float dt() const { return 1.0f / float(GetParam()); }
    int steps_in(double seconds) const { return int(std::lround(seconds * GetParam())); }
};

inline std::string step_name(const testing::TestParamInfo<int>& info) {
    return "At" + std::to_string(info.param) + "Hz";
}

#define CAIRN_AT_EVERY_STEP(suite)                                                                                     \
    INSTANTIATE_TEST_SUITE_P(Physics, suite, testing::Values(60, 240, 1000), cairn_test::step_name)

} // namespace cairn_test
