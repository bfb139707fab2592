#include "bodies/wetted.h"

#include "math/angle.h"

#include <algorithm>
#include <cmath>

namespace cairn {

using math::dot;
using math::DVec3;

namespace {

struct Polygon {
    std::array<DVec3, 9> at;
    int count;
    void clip(DVec3 n, double most) {
        Polygon kept = {{}, 0};
        for (int i = 0; i < count; ++i) {
            const DVec3 p = at[std::size_t(i)], q = at[std::size_t((i + 1) % count)];
            const double over_p = dot(n, p) - most, over_q = dot(n, q) - most;
            if (over_p <= 0) kept.at[std::size_t(kept.count++)] = p;
            if ((over_p <= 0) != (over_q <= 0))
                kept.at[std::size_t(kept.count++)] = p + (over_p / (over_p - over_q)) * (q - p);
        }
        *this = kept;
    }
};

} // namespace

WettedSurface::WettedSurface(const Surroundings& fluid) : fluid_(fluid) {
    const auto add = [&](DVec3 n, double most) { sides_[std::size_t(side_count_++)] = {n, most}; };
    if (fluid.vertical >= 0) add(fluid.up, fluid.surface);
    for (int axis = 0; axis < 3; ++axis) {
        if (axis == fluid.vertical || !std::isfinite(fluid.half[axis])) continue;
        DVec3 n;
        n[axis] = 1;
        add(n, fluid.center[axis] + fluid.half[axis]);
        add(-n, fluid.half[axis] - fluid.center[axis]);
    }
}

void WettedSurface::add_triangle(DVec3 a, DVec3 b, DVec3 c, std::optional<double> lid, bool is_small) {
    bool is_cut = false;
    for (int i = 0; i < side_count_; ++i) {
        const Side& side = sides_[std::size_t(i)];
        const double over_a = dot(side.n, a) - side.most, over_b = dot(side.n, b) - side.most,
                     over_c = dot(side.n, c) - side.most;
        if (over_a > 0 && over_b > 0 && over_c > 0) return;
        is_cut = is_cut || over_a > 0 || over_b > 0 || over_c > 0;
    }
    if (!is_cut) return add_piece(a, b, c, lid, is_small);
    Polygon p = {{a, b, c}, 3};
    for (int i = 0; i < side_count_; ++i) p.clip(sides_[std::size_t(i)].n, sides_[std::size_t(i)].most);
    for (int i = 2; i < p.count; ++i) add_piece(p.at[0], p.at[std::size_t(i) - 1], p.at[std::size_t(i)], lid, is_small);
}

void WettedSurface::add_piece(DVec3 a, DVec3 b, DVec3 c, std::optional<double> lid, bool is_small) {
    const DVec3 area = 0.5 * math::cross(b - a, c - a);
    const double size = math::length(area), level = -dot(area, fluid_.up);
    if (!(size > 0)) return;
    const DVec3 n = (1 / size) * area;
    if (is_small) {
        const DVec3 middle = (1.0 / 3) * (a + b + c);
        if (lid) add_column(middle, level, *lid);
        return add_drag(middle, n, size);
    }
    // Quadrature exact up to the third degree (Strang and Fix 1973), as the moments of columns require.
    if (lid && level != 0) {
        add_column((1.0 / 3) * (a + b + c), -27.0 / 48 * level, *lid);
        for (const DVec3 p : {a, b, c}) add_column(0.2 * (2.0 * p + (a + b + c)), 25.0 / 48 * level, *lid);
    }
    for (const DVec3 p : {0.5 * (a + b), 0.5 * (b + c), 0.5 * (c + a)}) add_drag(p, n, size / 3);
}
void WettedSurface::add_column(DVec3 p, double area, double lid) {
    displaced.add_column(p, fluid_.up, area, lid - dot(fluid_.up, p));
    waterline.add(p, area);
}
void WettedSurface::add_drag(DVec3 at, DVec3 n, double area) {
    const DVec3 v = fluid_.velocity_at(at);
    const double s = dot(n, v), k = s > 0 ? fluid_.pressed * s * area : 0;
    const DVec3 along = v - s * n;
    const double rub = fluid_.rubbed > 0 ? fluid_.rubbed * math::length(along) * area : 0;
    if (k == 0 && rub == 0) return;
    push(at, (-k * s) * n - rub * along);
    pressed.add(at, n, k - rub); // skin friction acts only tangentially
    rubbed.add(at, rub);
}

// The same integrals in closed form. The drag on a partly immersed ball is the share of its immersed volume. The added
// mass does not rotate with the ball.
void WettedSurface::add_ball(DVec3 center, double radius) {
    const double square = radius * radius, whole = 4.0 / 3.0 * math::pi * square * radius;
    double part = 1;
    if (fluid_.vertical >= 0) {
        const double height = std::clamp(radius + fluid_.depth_of(center), 0.0, 2 * radius);
        if (!(height > 0)) return;
        const double volume = math::pi * height * height * (3 * radius - height) / 3;
        const double area = math::pi * height * (2 * radius - height);
        part = volume / whole;
        displaced.add(center, volume); // pressure forces on a ball pass through its center
        waterline.add(center, area);
    }
    const DVec3 v = fluid_.velocity_at(center);
    const double speed = math::length(v), turn = math::length(fluid_.w);
    // The integral of |t| t over a ball that moves at the speed 1, with t the tangential part of its velocity.
    const double rub = part * fluid_.rubbed * 0.75 * math::pi * math::pi * square;
    if (speed > 0) {
        const double k = part * fluid_.pressed * math::pi * square * speed;
        push(center, -(0.5 * k + rub * speed) * v);
        rubbed.add(center, 0.25 * k + rub * speed);
        pressed.add(center, (1 / speed) * v, 0.25 * k);
    }
    const double k = rub * square * turn;
    torque += -k * fluid_.w;
    pressed.add_turn(k);
}

} // namespace cairn
