// Rigid limits of directly solved joints. A limit that is a separate row acts on the two bodies of its joint alone:
// where one is light and carries a heavy one, the limit stops the light body and the joints push it on, substep after
// substep, until the correction of the error throws the heavy body. The impulses of limits therefore act on all
// connected bodies, and those of all active limits are found together, as a linear complementarity problem: W x >= b, x
// >= 0, one of the two with equality, where W is the response of the limits' speeds to their impulses.
#include "joints/direct_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace cairn {

using math::DVec3;

namespace {

// Greatest number of bounds that are solved together, in 13 kB of stack; further ones follow in separate blocks.
constexpr std::size_t block_size = 24;
// m/s or rad/s: a limit whose speed is wrong by less is settled.
constexpr double settled = 1e-6;
// Fraction of the response of the two bodies alone below which the joints already hold what the limit would.
constexpr double held_response = 1e-9;

struct LimitRow {
    DVec3 linear[2], angular[2];
    double position;
};

LimitRow row_of(const SetView& v, const DirectLimit& limit) {
    const AxisBlock& b = v.axes[limit.lane / 8];
    const std::size_t lane = limit.lane % 8;
    const auto get = [&](const float(*p)[8]) {
        return DVec3{double(p[0][lane]), double(p[1][lane]), double(p[2][lane])};
    };
    return {{get(b.linear_a), get(b.linear_b)}, {get(b.angular_a), get(b.angular_b)}, double(b.position[lane])};
}

double speed_of(const SetView& v, const DirectLimit& limit, const LimitRow& row) {
    double speed = 0;
    for (int side = 0; side < 2; ++side) {
        const DirectBody& body = v.bodies[limit.body[side]];
        speed += math::dot(row.linear[side], body.v + body.dv) + math::dot(row.angular[side], body.w + body.dw);
    }
    return speed;
}

// Response of a limit's speed to its own impulse, with its two bodies alone.
double own_response(const SetView& v, const DirectLimit& limit, const LimitRow& row) {
    double response = 0;
    for (int side = 0; side < 2; ++side) {
        const DirectBody& body = v.bodies[limit.body[side]];
        response += body.inverse_mass * math::dot(row.linear[side], row.linear[side]);
        response += math::dot(row.angular[side], body.inverse_inertia * row.angular[side]);
    }
    return response;
}

void apply(const SetView& v, const DirectLimit& limit, const LimitRow& row, double impulse) {
    for (int side = 0; side < 2; ++side) {
        DirectBody& body = v.bodies[limit.body[side]];
        body.dv += (impulse * body.inverse_mass) * row.linear[side];
        body.dw += impulse * (body.inverse_inertia * row.angular[side]);
    }
}

// One bound of a limit that is active, or is to become active.
struct Bound {
    DirectLimit* limit;
    LimitRow row;
    int side;
    double sign, wanted; // wanted: the least speed away from it
};

double speed_of(const SetView& v, const Bound& b) { return b.sign * speed_of(v, *b.limit, b.row); }

class BoundBlock {
  public:
    // Collects bounds, starting with the limit `next`. Returns the number of the first limit that is left.
    std::size_t gather(const SetView& v, std::size_t next, double rate, double h) {
        count_ = 0;
        for (; next < v.limit_count && count_ + 2 <= block_size; ++next) {
            DirectLimit& limit = v.limits[next];
            const LimitRow row = row_of(v, limit);
            for (int side = 0; side < 2; ++side) {
                const double sign = side == 0 ? 1.0 : -1.0, gap = sign * (row.position - limit.bounds[side]);
                const double wanted = gap > 0 ? -gap / h : std::min(-rate * gap, fastest_return);
                const Bound bound{&limit, row, side, sign, wanted};
                if (limit.impulse[side] > 0 || speed_of(v, bound) < wanted) bounds_[count_++] = bound;
            }
        }
        return next;
    }

    bool is_settled(const SetView& v) const {
        return std::all_of(bounds_.begin(), bounds_.begin() + std::ptrdiff_t(count_), [&](const Bound& b) {
            const double spare = speed_of(v, b) - b.wanted;
            return spare > -settled && (spare < settled || !(b.limit->impulse[b.side] > 0));
        });
    }

    void hold(const SetView& v, double rate, bool keeps) {
        measure(v, rate);
        for (std::size_t i = 0; i < count_; ++i) {
            double b = bounds_[i].wanted - speed_of(v, bounds_[i]);
            for (std::size_t k = 0; k < count_; ++k) b += at(i, k) * impulse_of(k);
            sought_[i] = b;
            is_at_work_[i] = impulse_of(i) > 0 || b > 0;
        }
        find_impulses();
        for (std::size_t i = 0; i < count_; ++i) {
            apply(v, *bounds_[i].limit, bounds_[i].row, bounds_[i].sign * (impulses_[i] - impulse_of(i)));
            bounds_[i].limit->impulse[bounds_[i].side] = impulses_[i];
        }
        solve_impulse_increments(v, rate);
        if (keeps) commit_increments(v);
    }

  private:
    double& at(std::size_t row, std::size_t column) { return responses_[row * block_size + column]; }
    double& factor(std::size_t row, std::size_t column) { return factors_[row * block_size + column]; }
    double impulse_of(std::size_t i) const { return bounds_[i].limit->impulse[bounds_[i].side]; }

    // Measures the response of all bounds to an impulse at each one. Bounds that the joints hold already are removed.
    void measure(const SetView& v, double rate) {
        const std::size_t bodies = v.set.bodies.size();
        for (std::size_t i = 0; i < bodies; ++i)
            v.bodies[i].held_dv = v.bodies[i].dv, v.bodies[i].held_dw = v.bodies[i].dw;
        for (std::size_t i = 0; i < v.set.nodes.size(); ++i) {
            DirectRow& r = v.rows[i];
            r.held_given = r.given, r.drive.held_given = r.drive.given;
        }
        std::array<double, block_size> before, own;
        for (std::size_t i = 0; i < count_; ++i) {
            before[i] = speed_of(v, bounds_[i]);
            own[i] = own_response(v, *bounds_[i].limit, bounds_[i].row);
        }
        std::size_t kept = 0;
        std::array<std::size_t, block_size> from{};
        for (std::size_t i = 0; i < count_; ++i) {
            if (!(own[i] > 0)) continue;
            apply(v, *bounds_[i].limit, bounds_[i].row, bounds_[i].sign / own[i]);
            solve_impulse_increments(v, rate);
            const bool is_held = !(speed_of(v, bounds_[i]) - before[i] > held_response);
            if (!is_held) {
                for (std::size_t k = 0; k < count_; ++k) at(k, kept) = own[i] * (speed_of(v, bounds_[k]) - before[k]);
                from[kept++] = i;
            }
            for (std::size_t k = 0; k < bodies; ++k)
                v.bodies[k].dv = v.bodies[k].held_dv, v.bodies[k].dw = v.bodies[k].held_dw;
            for (std::size_t k = 0; k < v.set.nodes.size(); ++k) {
                DirectRow& r = v.rows[k];
                r.given = r.held_given, r.drive.given = r.drive.held_given;
            }
        }
        for (std::size_t i = 0; i < kept; ++i) {
            bounds_[i] = bounds_[from[i]];
            for (std::size_t k = 0; k < kept; ++k) at(i, k) = at(from[i], k);
        }
        count_ = kept;
    }

    // Block principal pivoting: exchanges all wrong bounds at once as long as their number falls, otherwise the last of
    // them alone, which terminates for every such W (Judice and Pires 1994).
    void find_impulses() {
        std::size_t fewest = count_ + 1;
        int tries = 3;
        for (std::size_t round = 0; round < 8 * block_size; ++round) {
            solve_those_at_work();
            std::size_t wrong = 0, last = 0;
            std::array<bool, block_size> is_wrong{};
            for (std::size_t i = 0; i < count_; ++i) {
                double spare = -sought_[i];
                for (std::size_t k = 0; k < count_; ++k) spare += at(i, k) * impulses_[k];
                is_wrong[i] = is_at_work_[i] ? impulses_[i] < 0 : spare < -0.1 * settled;
                if (is_wrong[i]) ++wrong, last = i;
            }
            if (wrong == 0) return;
            if (wrong < fewest)
                fewest = wrong, tries = 3;
            else
                --tries;
            for (std::size_t i = 0; i < count_; ++i)
                if (tries >= 0 ? is_wrong[i] : i == last) is_at_work_[i] = !is_at_work_[i];
        }
        for (std::size_t i = 0; i < count_; ++i) impulses_[i] = std::max(impulses_[i], 0.0);
    }

    // Solves for the active bounds by Cholesky factorization; redundant bounds get zero impulse.
    void solve_those_at_work() {
        std::array<std::size_t, block_size> used;
        std::size_t n = 0;
        for (std::size_t i = 0; i < count_; ++i) {
            impulses_[i] = 0;
            if (!is_at_work_[i]) continue;
            for (std::size_t k = 0; k <= n; ++k) {
                double sum = at(i, k < n ? used[k] : i);
                for (std::size_t m = 0; m < k; ++m) sum -= factor(n, m) * factor(k, m);
                factor(n, k) = k < n ? sum / factor(k, k) : sum;
            }
            if (!(factor(n, n) > held_response * at(i, i))) continue;
            factor(n, n) = std::sqrt(factor(n, n));
            used[n++] = i;
        }
        std::array<double, block_size> y;
        for (std::size_t k = 0; k < n; ++k) {
            y[k] = sought_[used[k]];
            for (std::size_t m = 0; m < k; ++m) y[k] -= factor(k, m) * y[m];
            y[k] /= factor(k, k);
        }
        for (std::size_t k = n; k-- > 0;) {
            for (std::size_t m = k + 1; m < n; ++m) y[k] -= factor(m, k) * y[m];
            y[k] /= factor(k, k);
            impulses_[used[k]] = y[k];
        }
    }

    std::array<Bound, block_size> bounds_;
    std::size_t count_ = 0;
    std::array<double, block_size * block_size> responses_, factors_;
    std::array<double, block_size> sought_, impulses_; // b and x
    std::array<bool, block_size> is_at_work_;
};

void hold_all(const SetView& v, double rate, double h, bool keeps) {
    // The impulses of one pass may activate other limits, but at most as many times as there are limits.
    for (std::size_t pass = 0; pass <= v.limit_count; ++pass) {
        bool are_settled = true;
        for (std::size_t next = 0; next < v.limit_count;) {
            BoundBlock block;
            next = block.gather(v, next, rate, h);
            if (block.is_settled(v)) continue;
            block.hold(v, rate, keeps);
            are_settled = false;
        }
        if (are_settled) return;
    }
}

} // namespace

void forget_limits(const SetView& v) {
    for (std::size_t i = 0; i < v.limit_count; ++i) v.limits[i].impulse[0] = v.limits[i].impulse[1] = 0;
}

void begin_limits(const SetView& v) {
    for (std::size_t i = 0; i < v.limit_count; ++i) {
        const DirectLimit& limit = v.limits[i];
        if (const double impulse = limit.impulse[0] - limit.impulse[1]; impulse != 0)
            apply(v, limit, row_of(v, limit), impulse);
    }
}

void hold_limits(const SetView& v, double rate, double h) { hold_all(v, rate, h, true); }

void hold_limits_for_now(const SetView& v, double rate, double h) {
    for (std::size_t i = 0; i < v.limit_count; ++i) std::copy_n(v.limits[i].impulse, 2, v.limits[i].kept);
    hold_all(v, rate, h, false);
    for (std::size_t i = 0; i < v.limit_count; ++i) std::copy_n(v.limits[i].kept, 2, v.limits[i].impulse);
}

void count_limits(const SetView& v) {
    for (std::size_t i = 0; i < v.limit_count; ++i) {
        const DirectLimit& limit = v.limits[i];
        v.axes[limit.lane / 8].total[limit.lane % 8] += float(limit.impulse[0] - limit.impulse[1]);
    }
}

} // namespace cairn
