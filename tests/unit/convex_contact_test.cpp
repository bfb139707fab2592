#include "collision/convex_contact.h"

#include "shapes/gjk.h"
#include "convex_test_support.h"

#include <gtest/gtest.h>

namespace {

using namespace convex_test;
using cairn::collide_convex;
using cairn::Manifold;

DVec3 normal_of(const Manifold& m) { return {m.normal[0], m.normal[1], m.normal[2]}; }
DVec3 point_of(const Manifold& m, int i) { return {m.points[i][0], m.points[i][1], m.points[i][2]}; }
double deepest(const Manifold& m) {
    double d = 1e30;
    for (int i = 0; i < m.count; ++i) d = std::min(d, double(m.points[i][3]));
    return d;
}
double separation_along(const Convex& a, const Convex& b, DVec3 n) {
    return dot(n, support(b, -n) - support(a, n));
}
// The greatest separation over all directions, by sampling and hill climbing.
double greatest_separation(const Convex& a, const Convex& b, DVec3 hint, Random& random, DVec3& best) {
    struct Try {
        double s;
        DVec3 n;
    };
    std::vector<Try> tries{{separation_along(a, b, hint), hint}};
    for (int i = 0; i < 300; ++i) {
        const DVec3 n = random.direction();
        tries.push_back({separation_along(a, b, n), n});
    }
    std::sort(tries.begin(), tries.end(), [](const Try& p, const Try& q) { return p.s > q.s; });
    Try top = tries[0];
    for (int t = 0; t < 4; ++t) {
        Try at = tries[std::size_t(t)];
        for (double step = 0.3; step > 1e-6; step *= 0.7)
            for (int i = 0; i < 12; ++i) {
                const DVec3 n = normalized(at.n + step * random.direction());
                const double s = separation_along(a, b, n);
                if (s > at.s) at = {s, n};
            }
        if (at.s > top.s) top = at;
    }
    best = top.n;
    return top.s;
}
// What holds of every manifold; empty when all is well.
std::string flaw(const Manifold& m, double margin) {
    if (m.count < 0 || m.count > 4) return "count " + std::to_string(m.count);
    const double l = length(normal_of(m));
    if (m.count == 0 ? l != 0.0 : !(std::fabs(l - 1.0) < 2e-6)) return "normal of length " + std::to_string(l);
    for (int k = 0; k < 4; ++k) {
        const bool used = k < m.count;
        for (int c = 0; c < 3; ++c)
            if (used ? !std::isfinite(m.points[k][c]) : m.points[k][c] != 0.0f) return "point " + std::to_string(k);
        if (used ? !(m.points[k][3] <= float(margin)) : m.points[k][3] != 1e30f)
            return "separation " + std::to_string(m.points[k][3]);
        if (!used && m.features[k] != 0) return "feature " + std::to_string(k);
        for (int i = 0; i < k && used; ++i)
            if (m.features[i] == m.features[k]) return "two points with one feature";
    }
    return {};
}

TEST(ConvexContact, RandomPairsTouchAlongAUnitNormalByTheirTrueSeparation) {
    Random random(1);
    int touching = 0;
    double worst = 0, worst_late = 0, worst_away = 0;
    for (int k = 0; k < 100000; ++k) {
        const Solid sa = any_solid(random, 1), sb = any_solid(random, 1);
        const Convex a = sa.at({}, random.rotation());
        const Convex b = sb.at(random.uniform(0, 2.5) * random.direction(), random.rotation());
        const double margin = random.below(2) ? 0.02 : 0.3;
        Manifold m;
        collide_convex(a, b, margin, {}, m);
        ASSERT_EQ(flaw(m, margin), "") << k;
        if (m.count == 0) continue;
        ++touching;
        const double s = separation_along(a, b, normal_of(m)), d = deepest(m) - s;
        if (std::fabs(d) > worst) {
            worst = std::fabs(d);
            std::printf("%d: kinds %d %d off %g sep %g count %d\n", k, int(a.kind), int(b.kind), d, s, m.count);
        }
        if (k < 20000) {
            DVec3 best;
            const double t = greatest_separation(a, b, normal_of(m), random, best);
            if (t - s > worst_late) {
                worst_late = t - s;
                std::printf("  %d: kinds %d %d true %g sep %g count %d angle %g core %g %g\n", k, int(a.kind), int(b.kind), t, s,
                            m.count, dot(best, normal_of(m)), a.radius, b.radius);
            }
        }
        for (int i = 0; i < m.count; ++i) {
            const DVec3 p = point_of(m, i);
            const double z = m.points[i][3];
            for (int side = 0; side < 2; ++side) {
                const Convex point = ball(1e-9).at(side ? p + (0.5 * z) * normal_of(m) : p - (0.5 * z) * normal_of(m));
                const auto r = cairn::gjk_distance({exact_core(point), exact_core(side ? b : a)}, {}, 1e9);
                const double away = r.state == cairn::GjkResult::State::overlapping ? 0 : r.distance - (side?b:a).is_sharp*0 - ((side ? b : a).is_sharp ? 0 : (side ? b : a).radius);
                if (away > worst_away) {
                    worst_away = away;
                    for (const Convex* c : {&a, &b}) std::printf("   size %g %g %g axis.n %g\n", c->size.x, c->size.y, c->size.z, dot(c->axes.c1, normal_of(m)));
                    std::printf("    %d: kinds %d %d point %d of %d away %g side %d z %g s %g\n", k, int(a.kind), int(b.kind), i, m.count, away, side, z, s);
                }
            }
        }
    }
    std::printf("%d touching, worst %g\n", touching, worst);
}

} // namespace
