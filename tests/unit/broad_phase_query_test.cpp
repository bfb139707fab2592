// Queries of the broad phase, compared with brute force.
#include "broad_phase_scene.h"

namespace cairn {
namespace {

TEST(BroadPhase, QueriesFindWhatBruteForceFinds) {
    for (const DVec3 offset : {DVec3{}, DVec3{-4e6, 2e6, 1e7}}) {
        Scene scene(51, 7, offset);
        fill(scene);
        std::map<std::uint32_t, std::vector<std::uint32_t>> asleep;
        std::size_t hits = 0, visits = 0;
        for (int step = 0; step < 40; ++step) {
            stir(scene, step, asleep);
            if (step % 2) scene.update(); // also query while changes are waiting for their update
            Random& random = scene.random;
            const DVec3 a = scene.random_point(), b = scene.random_point();
            const double length = math::length(b - a);
            DVec3 direction = (1 / length) * (b - a);
            if (step % 4 == 0) direction = {0, 0, random.below(2) ? 1.0 : -1.0};
            const DBounds box = {math::min(a, b), math::min(a, b) + DVec3{1, 1, 1}};
            std::set<std::uint32_t> in_box, on_ray;
            scene.broad.query_bounds(box, [&](std::uint32_t i) { EXPECT_TRUE(in_box.insert(i).second); });
            scene.broad.query_ray(a, direction, length, [&](std::uint32_t i, double max) {
                EXPECT_TRUE(on_ray.insert(i).second);
                return max;
            });
            for (std::uint32_t i = 0; i < scene.shapes.size(); ++i) {
                const Scene::Shape& s = scene.shapes[i];
                EXPECT_TRUE(s.kind != Kind::none || (!in_box.count(i) && !on_ray.count(i)));
                if (s.kind == Kind::none || s.kind == Kind::plane) continue;
                const DBounds tight = Scene::tight(s);
                EXPECT_TRUE(!overlap(tight, box, 0) || in_box.count(i));
                double near = 0, far = length;
                for (int axis = 0; axis < 3; ++axis) {
                    const double lo = tight.lo[axis] - a[axis], hi = tight.hi[axis] - a[axis], d = direction[axis];
                    if (d == 0)
                        far = lo <= 0 && hi >= 0 ? far : -1;
                    else
                        near = std::max(near, std::min(lo / d, hi / d)), far = std::min(far, std::max(lo / d, hi / d));
                }
                EXPECT_TRUE(near > far || on_ray.count(i)) << i << ' ' << step;
                hits += near <= far;
                visits += on_ray.count(i);
            }
        }
        EXPECT_GT(hits, 40u);
        EXPECT_LT(visits, 3 * hits); // there are few false candidates
    }
}

// Box sweeps and nearest-box queries; boxes beyond the search distance need not be visited.
TEST(BroadPhase, SweepsAndNearestBoxesAreThoseOfBruteForce) {
    for (const DVec3 offset : {DVec3{}, DVec3{-4e6, 2e6, 1e7}}) {
        Scene scene(53, 7, offset);
        fill(scene);
        std::map<std::uint32_t, std::vector<std::uint32_t>> asleep;
        std::size_t swept = 0, near = 0, visits = 0, planes_met = 0, planes_passed = 0;
        for (int step = 0; step < 40; ++step) {
            stir(scene, step, asleep);
            if (step % 2) scene.update();
            const DVec3 a = scene.random_point(), half{0.4, 0.1, 0.8};
            const DVec3 way = step % 5 == 0 ? DVec3{} : step % 5 == 1 ? DVec3{0, -3, 0} : scene.random_point() - a;
            const double reach = scene.random.between(0, 4);
            std::set<std::uint32_t> on_way, at_hand;
            const double end = step % 3 == 0 ? 0.5 : 1;
            scene.broad.query_sweep({a - half, a + half}, way, [&](std::uint32_t i, double) {
                EXPECT_TRUE(on_way.insert(i).second);
                return end;
            });
            scene.broad.query_near(a, reach, [&](std::uint32_t i, double max) {
                EXPECT_TRUE(at_hand.insert(i).second);
                return max;
            });
            visits += on_way.size() + at_hand.size();
            for (std::uint32_t i = 0; i < scene.shapes.size(); ++i) {
                const Scene::Shape& s = scene.shapes[i];
                if (s.kind == Kind::none) continue;
                if (s.kind == Kind::plane) {
                    const double height = math::dot(s.normal, a - s.point), change = math::dot(s.normal, way);
                    const double reach = math::dot(math::abs(s.normal), half);
                    const double low = std::min(height, height + change) - reach;
                    const double high = std::max(height, height + change) + reach;
                    if (std::fabs(low) < 1e-6 || std::fabs(high) < 1e-6) continue;
                    EXPECT_EQ(on_way.count(i), low < 0 && (!s.is_sheet || high > 0)) << i << ' ' << step;
                    ++(on_way.count(i) ? planes_met : planes_passed);
                    continue;
                }
                const DBounds tight = Scene::tight(s);
                double enter = 0, leave = end, square = 0;
                for (int axis = 0; axis < 3; ++axis) {
                    const double lo = tight.lo[axis] - a[axis], hi = tight.hi[axis] - a[axis];
                    const double off = std::max({lo, -hi, 0.0}), d = way[axis], h = half[axis];
                    square += off * off;
                    if (d == 0)
                        leave = lo - h <= 0 && hi + h >= 0 ? leave : -1;
                    else
                        enter = std::max(enter, std::min((lo - h) / d, (hi + h) / d)),
                        leave = std::min(leave, std::max((lo - h) / d, (hi + h) / d));
                }
                EXPECT_TRUE(enter > leave || on_way.count(i)) << i << ' ' << step;
                EXPECT_TRUE(square > reach * reach || at_hand.count(i)) << i << ' ' << step;
                swept += enter <= leave;
                near += square <= reach * reach;
            }
        }
        EXPECT_GT(swept, 40u);
        EXPECT_GT(near, 40u);
        EXPECT_GT(planes_met, 4u);
        EXPECT_GT(planes_passed, 10u);
        EXPECT_LT(visits, 3 * (swept + near)); // there are few false candidates
    }
}

TEST(BroadPhase, RaysFromFarAwayHit) {
    Scene scene(52, 7);
    for (int i = 0; i < 300; ++i) scene.add(i % 2 ? Kind::awake : Kind::fixed, 0.01, 0.05);
    scene.update();
    std::size_t visits = 0;
    for (std::uint32_t i = 0; i < 300; ++i) {
        const DVec3 target = scene.shapes[i].center;
        DVec3 start;
        for (int axis = 0; axis < 3; ++axis) start[axis] = scene.random.between(-2e6, 2e6);
        bool hit = false;
        const DVec3 direction = math::normalized(target - start);
        scene.broad.query_ray(start, direction, math::length(target - start) + 1, [&](std::uint32_t shape, double max) {
            hit |= shape == i;
            ++visits;
            return max;
        });
        EXPECT_TRUE(hit) << i;
    }
    EXPECT_LT(visits, 20000u);

    const DVec3 lonely = {3e7 + 0.7, 1e7 + 0.3, -2e7}; // floats have a spacing of meters there
    scene.broad.add(400, {lonely - DVec3{0.1, 0.1, 0.1}, lonely + DVec3{0.1, 0.1, 0.1}}, Mobility::awake);
    for (int i = 0; i < 300; ++i) {
        const double x = scene.random.between(-5, 5), y = scene.random.between(-5, 5), z = scene.random.between(-5, 5);
        bool hit = false;
        scene.broad.query_ray(lonely + DVec3{x, y, z}, math::normalized(DVec3{-x, -y, -z}), 20,
                              [&](std::uint32_t shape, double max) {
                                  hit |= shape == 400;
                                  return max;
                              });
        EXPECT_TRUE(hit) << i;
    }
}

TEST(BroadPhase, RaysStopEarly) {
    BroadPhase broad(kernels().broad);
    CountingSink sink;
    for (std::uint32_t i = 0; i < 512; ++i)
        broad.add(i, {{2.0 * i, 0, 0}, {2.0 * i + 1, 1, 1}}, i % 2 ? Mobility::fixed : Mobility::awake);
    broad.update(sink);
    std::size_t visits = 0;
    double nearest = 0;
    broad.query_ray({-5, 0.5, 0.5}, {1, 0, 0}, 1e9, [&](std::uint32_t shape, double max) {
        ++visits;
        return nearest = std::min(max, 5 + 2.0 * shape);
    });
    EXPECT_EQ(nearest, 5.0);
    EXPECT_LT(visits, 8u);
    visits = 0;
    broad.query_ray({-5, 0.5, 0.5}, {1, 0, 0}, 1e9, [&](std::uint32_t, double) { return ++visits, 0.0; });
    EXPECT_EQ(visits, 1u);
}

} // namespace
} // namespace cairn
