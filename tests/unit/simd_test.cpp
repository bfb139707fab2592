// The wide arithmetic of one instruction set, compared with plain scalar arithmetic bit by bit. This file is compiled
// once per backend (see CMakeLists.txt).
#include "simd/wide_math.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <random>

#define CAIRN_TEST_NAME2(isa) Simd_##isa
#define CAIRN_TEST_NAME(isa) CAIRN_TEST_NAME2(isa)

namespace {

using namespace cairn::CAIRN_ISA;

struct Lanes {
    alignas(32) float v[8];
    explicit Lanes(f32x8 a) { store(v, a); }
};

std::uint32_t bits_of(float f) {
    std::uint32_t u;
    std::memcpy(&u, &f, 4);
    return u;
}

// Floats of all signs and magnitudes, including both zeros and denormals.
struct Source {
    std::mt19937 random{12345};
    float next() {
        switch (random() % 8) {
        case 0:
            return 0.0f;
        case 1:
            return -0.0f;
        case 2:
            return 1e-40f * float(random() % 100);
        default:
            return std::ldexp(float(random()) / 2147483648.0f - 1.0f, int(random() % 40) - 20);
        }
    }
    void fill(float (&a)[8]) {
        for (float& f : a) f = next();
    }
};

template <class Wide, class Scalar> void expect_same(Wide wide, Scalar scalar) {
    Source source;
    for (int round = 0; round < 2000; ++round) {
        alignas(32) float a[8], b[8];
        source.fill(a);
        source.fill(b);
        const Lanes got(wide(load(a), load(b)));
        for (int i = 0; i < 8; ++i) {
            const float want = scalar(a[i], b[i]);
            ASSERT_EQ(bits_of(got.v[i]), bits_of(want)) << a[i] << " " << b[i] << " lane " << i;
        }
    }
}

TEST(CAIRN_TEST_NAME(CAIRN_ISA), arithmetic_is_that_of_single_floats) {
    expect_same([](f32x8 a, f32x8 b) { return a + b; }, [](float a, float b) { return a + b; });
    expect_same([](f32x8 a, f32x8 b) { return a - b; }, [](float a, float b) { return a - b; });
    expect_same([](f32x8 a, f32x8 b) { return a * b; }, [](float a, float b) { return a * b; });
    expect_same([](f32x8 a, f32x8 b) { return a / (abs(b) + one()); },
                [](float a, float b) { return a / (std::fabs(b) + 1.0f); });
    expect_same([](f32x8 a, f32x8) { return -a; }, [](float a, float) { return -a; });
    expect_same([](f32x8 a, f32x8) { return sqrt(abs(a)); }, [](float a, float) { return std::sqrt(std::fabs(a)); });
}

TEST(CAIRN_TEST_NAME(CAIRN_ISA), min_and_max_take_the_second_operand_on_a_tie) {
    expect_same([](f32x8 a, f32x8 b) { return max(a, b); }, [](float a, float b) { return a > b ? a : b; });
    expect_same([](f32x8 a, f32x8 b) { return min(a, b); }, [](float a, float b) { return a < b ? a : b; });
    EXPECT_EQ(bits_of(Lanes(max(splat(0.0f), splat(-0.0f))).v[3]), bits_of(-0.0f));
    EXPECT_EQ(bits_of(Lanes(min(splat(-0.0f), splat(0.0f))).v[5]), bits_of(0.0f));
}

TEST(CAIRN_TEST_NAME(CAIRN_ISA), masks_select_and_become_bits) {
    expect_same([](f32x8 a, f32x8 b) { return select(a < b, a, b + one()); },
                [](float a, float b) { return a < b ? a : b + 1.0f; });
    expect_same([](f32x8 a, f32x8 b) { return select((a > b) | (a == b), one(), zero()); },
                [](float a, float b) { return a >= b ? 1.0f : 0.0f; });
    expect_same([](f32x8 a, f32x8 b) { return select(and_not(a > zero(), b > zero()), one(), zero()); },
                [](float a, float b) { return a > 0 && !(b > 0) ? 1.0f : 0.0f; });
    expect_same([](f32x8 a, f32x8 b) { return select((a > zero()) ^ (b > zero()), one(), zero()); },
                [](float a, float b) { return (a > 0) != (b > 0) ? 1.0f : 0.0f; });
    for (int b = 0; b < 256; ++b) ASSERT_EQ(bits(mask_from_bits(b)), b);
}

TEST(CAIRN_TEST_NAME(CAIRN_ISA), gather_and_scatter_are_inverse_transposes) {
    alignas(32) float rows[8][4], back[8][4] = {};
    const float* from[8];
    float* to[8];
    for (int i = 0; i < 8; ++i) {
        from[i] = rows[i];
        to[i] = back[i];
        for (int k = 0; k < 4; ++k) rows[i][k] = float(10 * i + k);
    }
    f32x8 column[4];
    gather4(from, column[0], column[1], column[2], column[3]);
    for (int k = 0; k < 4; ++k)
        for (int i = 0; i < 8; ++i) EXPECT_EQ(Lanes(column[k]).v[i], float(10 * i + k));
    scatter4(to, column[0], column[1], column[2], column[3]);
    EXPECT_EQ(std::memcmp(rows, back, sizeof rows), 0);
}

TEST(CAIRN_TEST_NAME(CAIRN_ISA), rotation_by_a_quaternion_equals_its_matrix) {
    const float s = std::sqrt(0.5f);
    const Quatx8 quarter_turn_about_y{{zero(), splat(s), zero()}, splat(s)};
    const Vec3x8 x = rotate(quarter_turn_about_y, {one(), zero(), zero()});
    EXPECT_NEAR(Lanes(x.z).v[0], -1.0f, 1e-6f);
    const Vec3x8 back = rotate_back(quarter_turn_about_y, x);
    EXPECT_NEAR(Lanes(back.x).v[7], 1.0f, 1e-6f);
    EXPECT_NEAR(Lanes(to_matrix(quarter_turn_about_y).c0.z).v[0], -1.0f, 1e-6f);
}

} // namespace
