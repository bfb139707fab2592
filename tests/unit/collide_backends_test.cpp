// All instruction sets give the same bits in every narrow-phase kernel.
#include "collide_test_support.h"

#include "collision/wide_pairs.h"

#include <cstring>
#include <string>

using namespace collide_test;

namespace {

enum class Kind { sphere, box, plane, rectangle, capsule };

// Random or exactly aligned shapes. Aligned ones have positions on a grid of eighths, quarter turns, and sizes that are
// multiples of a quarter, so that they touch exactly, share edges and corners, or contain each other.
ShapePose any_shape(Random& random, Kind kind, const Vec& around, bool aligned) {
    const auto size = [&] { return aligned ? 0.25 * (1 + random.below(3)) : random.uniform(0.05, 1.0); };
    Vec position = around;
    for (double& c : position) c += aligned ? 0.125 * (random.below(17) - 8) : random.uniform(-0.8, 0.8);
    Quat q = random.rotation();
    if (aligned) {
        const double s = std::sqrt(0.5);
        const Quat turns[] = {no_rotation, {s, 0, 0, s}, {0, s, 0, s}, {0, 0, s, s}, {0, 1, 0, 0}, {-s, 0, 0, s}};
        q = turns[random.below(6)];
    }
    switch (kind) {
    case Kind::sphere:
        return sphere(position, size(), q);
    case Kind::box:
        return box(position, q, {size(), size(), size()});
    case Kind::plane:
        return plane(position, q);
    case Kind::rectangle:
        return rectangle(position, q, 2 * size(), 2 * size());
    case Kind::capsule:
        return capsule(position, q, size(), size());
    }
    return {};
}

Pairs any_pairs(Kind first, Kind second, std::uint32_t seed) {
    Random random(seed);
    Pairs pairs;
    for (int i = 0; i < 12000; ++i) {
        const bool aligned = i % 2 == 0;
        const Vec around = {random.uniform(-1e3, 1e3), 0.5 * random.below(10), 7.25};
        const ShapePose a = any_shape(random, first, around, aligned);
        ShapePose b = any_shape(random, second, around, aligned);
        if (i % 16 == 0) // the same pose
            for (int k = 0; k < 4; ++k) {
                b.high[k] = a.high[k];
                b.low[k] = a.low[k];
                b.q[k] = a.q[k];
            }
        pairs.add(a, b, i % 3 == 0 ? 0.0f : 0.05f);
    }
    return pairs;
}

void expect_equal_bits(cairn::CollideKernel cairn::KernelTable::*kernel, const Pairs& pairs,
                       const std::vector<std::uint32_t>& kept = {}) {
    const std::vector<const cairn::KernelTable*> tables = backends();
    ASSERT_FALSE(tables.empty());
    const std::vector<Manifold> reference = run(tables[0]->*kernel, pairs, kept);
    int touching = 0;
    for (int i = 0; i < pairs.count(); ++i) {
        ASSERT_EQ(flaw(reference[static_cast<std::size_t>(i)], pairs.margin(i)), "") << "pair " << i;
        touching += reference[static_cast<std::size_t>(i)].count > 0;
    }
    EXPECT_GT(touching, pairs.count() / 10);
    for (const cairn::KernelTable* table : tables) {
        const std::vector<Manifold> other = run(table->*kernel, pairs, kept);
        for (int i = 0; i < pairs.count(); ++i) {
            const std::size_t k = static_cast<std::size_t>(i);
            ASSERT_EQ(std::memcmp(&reference[k], &other[k], sizeof(Manifold)), 0)
                << tables[0]->name << " and " << table->name << " differ at pair " << i;
        }
    }
}

void expect_equal_bits(cairn::CollideKernel cairn::KernelTable::*kernel, Kind first, Kind second) {
    expect_equal_bits(kernel, any_pairs(first, second, 77));
}

// Compares the contact points of a pair; entries beyond `count` are unspecified.
void expect_same(const Manifold& one, const Manifold& other, const std::string& who) {
    ASSERT_EQ(one.count, other.count) << who;
    if (one.count == 0) {
        ASSERT_EQ(one.points[0][3], other.points[0][3]) << who;
        return;
    }
    ASSERT_EQ(std::memcmp(one.normal, other.normal, sizeof one.normal), 0) << who;
    const auto count = static_cast<std::size_t>(one.count);
    ASSERT_EQ(std::memcmp(one.points, other.points, count * sizeof one.points[0]), 0) << who;
    ASSERT_EQ(std::memcmp(one.features, other.features, count * sizeof one.features[0]), 0) << who;
}

// Tests each pair together with pairs of all kinds, and in a block of its own.
void expect_blind_lanes(cairn::CollideKernel cairn::KernelTable::*kernel, Kind first, Kind second) {
    const Pairs pairs = any_pairs(first, second, 79);
    for (const cairn::KernelTable* table : backends()) {
        const std::vector<Manifold> together = run(table->*kernel, pairs);
        for (int i = 0; i < pairs.count(); i += 5) {
            Pairs alone;
            alone.add(pairs.first(i), pairs.second(i), pairs.margins[static_cast<std::size_t>(i)]);
            expect_same(together[static_cast<std::size_t>(i)], run(table->*kernel, alone)[0],
                        std::string(table->name) + ", pair " + std::to_string(i));
            if (testing::Test::HasFatalFailure()) return;
        }
    }
}

} // namespace

// Ranks divide the pairs among themselves: which pairs share a block depends on the number of ranks.
TEST(CollideBackends, APairDoesNotSeeTheOthersOfItsBlock){
#define CAIRN_EXPECT_BLIND(first, second)                                                                              \
    {                                                                                                                  \
        SCOPED_TRACE(#first " and " #second);                                                                          \
        expect_blind_lanes(&cairn::KernelTable::first##_##second, Kind::first, Kind::second);                          \
    }
    CAIRN_WIDE_PAIRS(CAIRN_EXPECT_BLIND)
#undef CAIRN_EXPECT_BLIND
}

TEST(CollideBackends, SphereSphere) {
    expect_equal_bits(&cairn::KernelTable::sphere_sphere, Kind::sphere, Kind::sphere);
}
TEST(CollideBackends, SphereBox) { expect_equal_bits(&cairn::KernelTable::sphere_box, Kind::sphere, Kind::box); }
TEST(CollideBackends, SpherePlane) { expect_equal_bits(&cairn::KernelTable::sphere_plane, Kind::sphere, Kind::plane); }
TEST(CollideBackends, SphereRectangle) {
    expect_equal_bits(&cairn::KernelTable::sphere_rectangle, Kind::sphere, Kind::rectangle);
}
TEST(CollideBackends, SphereCapsule) {
    expect_equal_bits(&cairn::KernelTable::sphere_capsule, Kind::sphere, Kind::capsule);
}
TEST(CollideBackends, BoxBox) { expect_equal_bits(&cairn::KernelTable::box_box, Kind::box, Kind::box); }
TEST(CollideBackends, BoxBoxWithTheChoiceOfTheLastStep) {
    // The pairs move a little: some of the cached features remain valid, others do not.
    const Pairs pairs = any_pairs(Kind::box, Kind::box, 77);
    std::vector<std::uint32_t> kept;
    for (const Manifold& m : run(backends()[0]->box_box, pairs)) kept.push_back(kept_features(m));
    Pairs moved = pairs;
    Random random(78);
    for (std::size_t i = 0; i < moved.poses.size(); i += 2)
        for (float& x : moved.poses[i].low) x += static_cast<float>(random.uniform(-0.02, 0.02));
    expect_equal_bits(&cairn::KernelTable::box_box, moved, kept);
}
TEST(CollideBackends, BoxPlane) { expect_equal_bits(&cairn::KernelTable::box_plane, Kind::box, Kind::plane); }
TEST(CollideBackends, BoxRectangle) {
    expect_equal_bits(&cairn::KernelTable::box_rectangle, Kind::box, Kind::rectangle);
}
TEST(CollideBackends, CapsuleCapsule) {
    expect_equal_bits(&cairn::KernelTable::capsule_capsule, Kind::capsule, Kind::capsule);
}
TEST(CollideBackends, BoxCapsule) { expect_equal_bits(&cairn::KernelTable::box_capsule, Kind::box, Kind::capsule); }
