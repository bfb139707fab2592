// Shared by the tests of the narrow-phase kernels: poses, random numbers, and running a kernel.
#pragma once

#include "kernels/kernels.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

namespace collide_test {

using cairn::Manifold;
using cairn::ShapePose;
using Vec = std::array<double, 3>;
using Quat = std::array<double, 4>; // x y z w

inline Vec operator+(const Vec& a, const Vec& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline Vec operator-(const Vec& a, const Vec& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline Vec operator*(double s, const Vec& a) { return {s * a[0], s * a[1], s * a[2]}; }
inline double dot(const Vec& a, const Vec& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline double length(const Vec& a) { return std::sqrt(dot(a, a)); }
inline Vec cross(const Vec& a, const Vec& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// Generates the same numbers with every standard library.
class Random {
  public:
    explicit Random(std::uint32_t seed) : engine_(seed) {}
    double uniform(double low, double high) { return low + (high - low) * (engine_() / 4294967296.0); }
    int below(int n) { return static_cast<int>(engine_() % static_cast<std::uint32_t>(n)); }
    Vec direction() {
        for (;;) {
            const Vec v = {uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)};
            const double l = length(v);
            if (l > 0.05 && l < 1.0) return (1.0 / l) * v;
        }
    }
    Quat rotation() {
        for (;;) {
            const Quat q = {uniform(-1, 1), uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)};
            const double l = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
            if (l > 0.05 && l < 1.0) return {q[0] / l, q[1] / l, q[2] / l, q[3] / l};
        }
    }

  private:
    std::mt19937 engine_;
};

inline Quat about(const Vec& axis, double angle) {
    const double s = std::sin(angle / 2);
    return {s * axis[0], s * axis[1], s * axis[2], std::cos(angle / 2)};
}
constexpr Quat no_rotation = {0, 0, 0, 1};

inline ShapePose make_pose(const Vec& position, const Quat& q, const std::array<float, 4>& size) {
    ShapePose p{};
    for (std::size_t i = 0; i < 3; ++i) {
        // volatile: when gcc 12 vectorizes two of these at -O2 and above, it omits the rounding to float, which makes
        // every remainder 0.
        const volatile float high = static_cast<float>(position[i]);
        p.high[i] = high;
        p.low[i] = static_cast<float>(position[i] - static_cast<double>(high));
    }
    for (std::size_t i = 0; i < 4; ++i) p.q[i] = static_cast<float>(q[i]);
    for (std::size_t i = 0; i < 4; ++i) p.size[i] = size[i];
    return p;
}
inline ShapePose sphere(const Vec& position, double radius, const Quat& q = no_rotation) {
    const float r = static_cast<float>(radius);
    return make_pose(position, q, {r, 0, 0, r});
}
inline ShapePose box(const Vec& position, const Quat& q, const Vec& half) {
    return make_pose(position, q,
                     {static_cast<float>(half[0]), static_cast<float>(half[1]), static_cast<float>(half[2]),
                      static_cast<float>(length(half))});
}
inline ShapePose capsule(const Vec& position, const Quat& q, double radius, double half) {
    const float r = static_cast<float>(radius), h = static_cast<float>(half);
    return make_pose(position, q, {r, h, r, r + h});
}
inline ShapePose plane(const Vec& position, const Quat& q) { return make_pose(position, q, {0, 0, 0, 0}); }
inline ShapePose rectangle(const Vec& position, const Quat& q, double hx, double hz) {
    return box(position, q, {hx, 0, hz});
}

// A shape in double precision as the kernel sees it: position, rotation axes (columns) and size.
struct Frame {
    Vec center;
    std::array<Vec, 3> axis;
    Vec half;
    Vec to_local(const Vec& p) const {
        const Vec d = p - center;
        return {dot(axis[0], d), dot(axis[1], d), dot(axis[2], d)};
    }
    Vec to_world(const Vec& v) const { return center + (v[0] * axis[0] + v[1] * axis[1] + v[2] * axis[2]); }
};
inline Frame frame_of(const ShapePose& p) {
    Frame f;
    Quat q;
    double norm = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        q[i] = p.q[i];
        norm += q[i] * q[i];
    }
    for (double& c : q) c /= std::sqrt(norm);
    for (std::size_t i = 0; i < 3; ++i) {
        f.center[i] = static_cast<double>(p.high[i]) + static_cast<double>(p.low[i]);
        f.half[i] = p.size[i];
    }
    const double x = q[0], y = q[1], z = q[2], w = q[3];
    f.axis[0] = {1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)};
    f.axis[1] = {2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)};
    f.axis[2] = {2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)};
    return f;
}

// Pairs to test; `poses` holds the first and second shape of each pair in turn.
struct Pairs {
    std::vector<ShapePose> poses;
    std::vector<float> margins;
    void add(const ShapePose& first, const ShapePose& second, float margin) {
        poses.push_back(first);
        poses.push_back(second);
        margins.push_back(margin);
    }
    int count() const { return static_cast<int>(margins.size()); }
    const ShapePose& first(int i) const { return poses[2 * static_cast<std::size_t>(i)]; }
    const ShapePose& second(int i) const { return poses[2 * static_cast<std::size_t>(i) + 1]; }
    double margin(int i) const { return margins[static_cast<std::size_t>(i)]; }
};

// `kept`: the cached features of the last step, one entry per pair, or empty.
inline std::vector<Manifold> run(cairn::CollideKernel kernel, const Pairs& pairs,
                                 std::vector<std::uint32_t> kept = {}) {
    std::vector<std::uint32_t> first, second;
    std::vector<float> margins;
    const int padded = (pairs.count() + 7) / 8 * 8;
    for (int i = 0; i < padded; ++i) {
        const int pair = i < pairs.count() ? i : 0;
        first.push_back(static_cast<std::uint32_t>(2 * pair));
        second.push_back(static_cast<std::uint32_t>(2 * pair + 1));
        margins.push_back(pairs.margins[static_cast<std::size_t>(pair)]);
    }
    if (!kept.empty()) kept.resize(static_cast<std::size_t>(padded), kept[0]);
    std::vector<Manifold> out(static_cast<std::size_t>(padded));
    kernel(pairs.poses.data(), first.data(), second.data(), margins.data(), kept.empty() ? nullptr : kept.data(),
           padded, out.data());
    out.resize(static_cast<std::size_t>(pairs.count()));
    return out;
}
// The features of a manifold as a contact record keeps them for the next step.
inline std::uint32_t kept_features(const Manifold& m) {
    std::uint32_t kept = 0;
    for (int k = 0; k < 4; ++k) kept |= (k < m.count ? m.features[k] & 255u : 255u) << (8 * k);
    return kept;
}
inline Manifold run_one(cairn::CollideKernel kernel, const ShapePose& a, const ShapePose& b, float margin) {
    Pairs pairs;
    pairs.add(a, b, margin);
    return run(kernel, pairs)[0];
}

// All kernel tables of this build that the machine supports.
inline std::vector<const cairn::KernelTable*> backends() {
    std::vector<const cairn::KernelTable*> r;
    for (const char* name : {"scalar", "sse2", "avx2", "avx512", "neon"})
        if (const cairn::KernelTable* table = cairn::kernels_named(name)) r.push_back(table);
    return r;
}

inline Vec normal_of(const Manifold& m) { return {m.normal[0], m.normal[1], m.normal[2]}; }
inline Vec point_of(const Manifold& m, int k) { return {m.points[k][0], m.points[k][1], m.points[k][2]}; }
inline double separation_of(const Manifold& m, int k) { return m.points[k][3]; }
inline double deepest_of(const Manifold& m) {
    double d = 1e30;
    for (int k = 0; k < m.count; ++k) d = std::min(d, separation_of(m, k));
    return d;
}

// The lower bound of the distance that a manifold without points reports; -1e30 where it reports none.
inline double reported_distance(const Manifold& m) {
    return m.count == 0 && m.points[0][3] < 1e30f ? m.points[0][3] : -1e30;
}

// Conditions that hold for every manifold. Returns a description of the first violation, or an empty string.
inline std::string flaw(const Manifold& m, double margin) {
    if (m.count < 0 || m.count > 4) return "count " + std::to_string(m.count);
    const double l = length(normal_of(m));
    if (m.count == 0 ? l != 0.0 : !(std::fabs(l - 1.0) < 2e-6)) return "normal of length " + std::to_string(l);
    for (int k = 0; k < 4; ++k) {
        const bool used = k < m.count;
        for (int c = 0; c < 3; ++c)
            if (used ? !std::isfinite(m.points[k][c]) : m.points[k][c] != 0.0f) return "point " + std::to_string(k);
        const bool says_apart = m.count == 0 && k == 0 && m.points[k][3] > static_cast<float>(margin);
        if (used ? !(m.points[k][3] <= static_cast<float>(margin)) : !says_apart && m.points[k][3] != 1e30f)
            return "separation " + std::to_string(m.points[k][3]);
        if (!used && m.features[k] != 0) return "feature " + std::to_string(k);
        for (int i = 0; i < k && used; ++i)
            if (m.count > 1 && m.features[i] == m.features[k]) return "two points with one feature";
    }
    return {};
}

} // namespace collide_test
