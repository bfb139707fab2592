// The part of a body that a fluid wets: the displaced volume and the resistance to its motion (fluids.h).
#pragma once

#include "math/vec.h"

#include <array>
#include <cstddef>
#include <optional>

namespace cairn {

// A fluid relative to a body: positions are relative to the body's center of mass.
struct Surroundings {
    math::DVec3 up;                 // against gravity; zero without gravity
    double surface = 0;             // height of the fluid's surface above the center of mass, along `up`, m
    int vertical = -1;              // the coordinate axis nearest to `up`
    math::DVec3 center, half;       // of the fluid's box, m
    double pressed = 0, rubbed = 0; // kg/m^3: half of the density times the coefficients of drag and of skin friction
    math::DVec3 v, w;               // velocities of the body relative to the fluid

    math::DVec3 velocity_at(math::DVec3 p) const { return v + math::cross(w, p); }
    double depth_of(math::DVec3 p) const { return surface - math::dot(up, p); }
};

// A quantity distributed over points: its sum, and its first and second moments about the center of mass.
struct Moments {
    double sum = 0;
    math::DVec3 first;
    math::DSym3 second;

    void add(math::DVec3 p, double weight) {
        const math::DVec3 q = weight * p;
        sum += weight, first += q;
        second = second + math::DSym3{q.x * p.x, q.x * p.y, q.x * p.z, q.y * p.y, q.y * p.z, q.z * p.z};
    }
    // Adds a column that starts at p and extends by `height` along `up`, with the cross section `area`.
    void add_column(math::DVec3 p, math::DVec3 up, double area, double height) {
        const double one = area * height, two = 0.5 * one * height, three = two * height / 1.5;
        const auto entry = [&](int i, int k) {
            return one * p[i] * p[k] + two * (p[i] * up[k] + up[i] * p[k]) + three * up[i] * up[k];
        };
        sum += one, first += one * p + two * up;
        second = second + math::DSym3{entry(0, 0), entry(0, 1), entry(0, 2), entry(1, 1), entry(1, 2), entry(2, 2)};
    }
    void add(const Moments& other, double weight) {
        const math::DSym3& s = other.second;
        sum += weight * other.sum, first += weight * other.first;
        second = second +
                 math::DSym3{weight * s.xx, weight * s.xy, weight * s.xz, weight * s.yy, weight * s.yz, weight * s.zz};
    }
    // The inertia tensor, if the quantity is mass.
    math::DSym3 inertia() const {
        const math::DSym3& s = second;
        return {s.yy + s.zz, -s.xy, -s.xz, s.xx + s.zz, -s.yz, s.xx + s.yy};
    }
};

// A symmetric 6 x 6 matrix that maps a linear and angular velocity to a force and a torque about the center of mass.
// Only the lower triangle is stored.
class Coupling {
  public:
    // Adds a resistance at a point along n: `weight` is force per velocity.
    void add(math::DVec3 at, math::DVec3 n, double weight) {
        const math::DVec3 turn = math::cross(at, n);
        const std::array<double, 6> j = {n.x, n.y, n.z, turn.x, turn.y, turn.z};
        for (std::size_t i = 0; i < 6; ++i)
            for (std::size_t k = 0; k <= i; ++k) entries_[i][k] += weight * j[i] * j[k];
    }
    // Adds an isotropic resistance at distributed points, in proportion to their quantity.
    void add(const Moments& m, double weight) {
        const math::DSym3 turn = m.inertia();
        const math::DVec3 f = weight * m.first;
        for (std::size_t i = 0; i < 3; ++i) entries_[i][i] += weight * m.sum;
        entries_[3][1] -= f.z, entries_[3][2] += f.y, entries_[4][0] += f.z;
        entries_[4][2] -= f.x, entries_[5][0] -= f.y, entries_[5][1] += f.x;
        entries_[3][3] += weight * turn.xx, entries_[4][3] += weight * turn.xy, entries_[4][4] += weight * turn.yy;
        entries_[5][3] += weight * turn.xz, entries_[5][4] += weight * turn.yz, entries_[5][5] += weight * turn.zz;
    }
    // Adds a resistance along n at distributed points.
    void add(const Moments& m, math::DVec3 n, double weight) {
        const math::DVec3 lever = math::cross(m.first, n);
        const math::DSym3& s = m.second;
        // The second moments of p x n: those of p, with n as a cross product on both sides.
        const std::array<math::DVec3, 3> once = {math::cross(math::DVec3{s.xx, s.xy, s.xz}, n),
                                                 math::cross(math::DVec3{s.xy, s.yy, s.yz}, n),
                                                 math::cross(math::DVec3{s.xz, s.yz, s.zz}, n)};
        for (int i = 0; i < 3; ++i) {
            const math::DVec3 twice = math::cross(math::DVec3{once[0][i], once[1][i], once[2][i]}, n);
            for (int k = 0; k < 3; ++k) {
                if (k <= i) entries_[std::size_t(i)][std::size_t(k)] += weight * m.sum * n[i] * n[k];
                entries_[std::size_t(i) + 3][std::size_t(k)] += weight * lever[i] * n[k];
                if (k <= i) entries_[std::size_t(i) + 3][std::size_t(k) + 3] += weight * twice[k];
            }
        }
    }
    void add_turn(double weight) {
        for (std::size_t i = 3; i < 6; ++i) entries_[i][i] += weight;
    }
    void add(const Coupling& other, double weight) {
        for (std::size_t i = 0; i < 6; ++i)
            for (std::size_t k = 0; k <= i; ++k) entries_[i][k] += weight * other.entries_[i][k];
    }
    double operator()(std::size_t i, std::size_t k) const { return i >= k ? entries_[i][k] : entries_[k][i]; }

  private:
    std::array<std::array<double, 6>, 6> entries_{};
};

// The wetted part of a body in one fluid.
class WettedSurface {
  public:
    explicit WettedSurface(const Surroundings& fluid);

    // `lid`: the height up to which columns are counted, above all wet parts of the shape; nothing if the displaced
    // volume is known already. `is_small`: the triangle is one of many on a round surface, and is integrated by its
    // centroid alone.
    void add_triangle(math::DVec3 a, math::DVec3 b, math::DVec3 c, std::optional<double> lid, bool is_small);
    void add_ball(math::DVec3 center, double radius);

    Moments displaced, waterline, rubbed; // m^3, m^2, N s/m
    Coupling pressed;                     // N s/m
    math::DVec3 force, torque;            // by drag

  private:
    void add_piece(math::DVec3 a, math::DVec3 b, math::DVec3 c, std::optional<double> lid, bool is_small);
    void add_column(math::DVec3 p, double area, double lid);
    void push(math::DVec3 at, math::DVec3 f) { force += f, torque += math::cross(at, f); }
    void add_drag(math::DVec3 at, math::DVec3 n, double area);
    // A half-space that contains the fluid: n . p <= most.
    struct Side {
        math::DVec3 n;
        double most;
    };
    const Surroundings& fluid_;
    std::array<Side, 6> sides_;
    int side_count_ = 0;
};

} // namespace cairn
