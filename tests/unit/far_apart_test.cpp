#include "collision/far_apart.h"

#include "convex_test_support.h"
#include "shapes/gjk.h"

#include <gtest/gtest.h>

namespace {

using namespace convex_test;

cairn::ShapePose pose_at(DVec3 center, DQuat q) {
    cairn::ShapePose pose{};
    for (int i = 0; i < 3; ++i) {
        pose.high[i] = float(center[i]);
        pose.low[i] = float(center[i] - double(pose.high[i]));
    }
    pose.q[0] = float(q.x), pose.q[1] = float(q.y), pose.q[2] = float(q.z), pose.q[3] = float(q.w);
    return pose;
}

double separation(const Convex& a, const Convex& b) {
    const auto r = cairn::gjk_distance({exact_core(a), exact_core(b)}, {}, 1e300);
    if (r.state == cairn::GjkResult::State::overlapping) return 0;
    return r.distance - exact_core(a).radius - exact_core(b).radius;
}

bool is_segment(const Solid& s) {
    return s.geometry.type == cairn::ShapeType::sphere ||
           (s.geometry.type == cairn::ShapeType::capsule && s.geometry.size.x == s.geometry.size.z);
}

// The bound never exceeds the distance; for balls and capsules it is nearly equal to the distance.
TEST(FarApart, LeastDistanceIsNoMoreThanTheDistance) {
    Random random(7);
    int far = 0, segments = 0;
    for (int k = 0; k < 100000; ++k) {
        const double size = random.below(4) ? 1 : 0.1;
        const Solid a = any_solid(random, 1), b = any_solid(random, size);
        const DVec3 place = (random.below(2) ? 0.0 : 1e5) * random.direction();
        const DVec3 offset = random.uniform(0, 4) * random.direction();
        const DQuat qa = random.rotation(), qb = random.below(3) ? random.rotation() : qa; // some of them parallel
        const double s = separation(a.at({}, qa), b.at(offset, qb));
        const double said =
            double(cairn::gap_lower_bound(a.geometry, pose_at(place, qa), b.geometry, pose_at(place + offset, qb)));
        EXPECT_LE(said, s) << k;
        far += said > 0.1;
        if (!is_segment(a) || !is_segment(b) || s == 0) continue;
        ++segments;
        EXPECT_GT(said, s - 0.05) << k;
    }
    EXPECT_GT(far, 20000);
    EXPECT_GT(segments, 1000);
}

} // namespace
