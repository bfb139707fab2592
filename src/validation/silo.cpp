// Grains poured into a silo: how much of their weight its floor carries (row 36).
#include "validation/cases.h"
#include "validation/measures.h"
#include "validation/random_starts.h"
#include "validation/text.h"
#include "validation/worlds.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace cairn::validation {
namespace {

constexpr double width = 0.12, grain = 0.01;             // m: inner width, and mean radius of a grain
constexpr int across = 5, layers = 48, layers_shown = 4; // a layer has across x across grains

struct Fill {
    double poured = 0, borne = 0; // kg
};

class Silo {
  public:
    Silo(double friction, std::uint32_t seed, double dt)
        : start_(seed), world_(with_turned_gravity(start_)), material_(surface(float(friction))), dt_(dt) {
        constexpr double high = 2, thick = 0.05;
        constexpr float half = float(width / 2), wide = float(width / 2 + 2 * thick);
        floor_ = add_wall({0, -thick, 0}, {wide, float(thick), wide});
        for (const double side : {-1.0, 1.0}) {
            add_wall({side * (width / 2 + thick), high / 2, 0}, {float(thick), float(high / 2), wide});
            add_wall({0, high / 2, side * (width / 2 + thick)}, {half, float(high / 2), float(thick)});
        }
    }

    // Fills the silo and measures the load on its floor: a layer is poured at a time, onto grains at rest.
    std::vector<Fill> fill() {
        std::vector<Fill> fills;
        for (int layer = 1; layer <= layers; ++layer) {
            pour();
            run(world_, float(dt_), steps_in(0.1, dt_));
            if (layer % layers_shown != 0) continue;
            run(world_, float(dt_), steps_in(0.15, dt_));
            fills.push_back({poured_, borne(steps_in(0.15, dt_))});
        }
        return fills;
    }

  private:
    BodyId add_wall(const glm::dvec3& at, const Vec3& half) {
        BodyDef def;
        def.type = BodyType::static_;
        def.position = start_.place(at);
        def.rotation = start_.quat();
        return add_body(world_, Box{half}, def, material_);
    }
    void pour() {
        double top = 0;
        for (const BodyId body : grains_)
            top = std::max(top,
                           (glm::conjugate(start_.rotation()) * (world_.body(body).position() - start_.place({}))).y);
        for (int i = 0; i < across * across; ++i) {
            const double apart = 2.3 * grain;
            const glm::dvec3 at{(i % across - 0.5 * (across - 1)) * apart + start_.uniform(-0.1, 0.1) * grain,
                                top + 3 * grain,
                                (i / across - 0.5 * (across - 1)) * apart + start_.uniform(-0.1, 0.1) * grain};
            BodyDef def;
            def.position = start_.place(at);
            def.linear_velocity = Vec3(start_.turned({0, -0.3, 0}));
            grains_.push_back(add_body(world_, Sphere{float(start_.uniform(0.9, 1.1) * grain)}, def, material_));
            poured_ += double(world_.body(grains_.back()).mass());
        }
    }
    // Load on the floor, kg: the mean over some steps.
    double borne(int steps) {
        double impulse = 0;
        for (int i = 0; i < steps; ++i) {
            world_.step(float(dt_));
            for (const Contact& contact : world_.contacts())
                if (contact.body_a == floor_ || contact.body_b == floor_)
                    for (const ContactPoint& point : contact.points) impulse += double(point.normal_impulse);
        }
        return impulse / (steps * dt_ * gravity);
    }

    RandomStart start_;
    World world_;
    Material material_;
    double dt_, poured_ = 0;
    BodyId floor_;
    std::vector<BodyId> grains_;
};

// The saturation load on the floor, kg, for which Janssen's law fits best.
double saturation_of(const std::vector<Fill>& fills) {
    const auto error = [&](double most) {
        double sum = 0;
        for (const Fill& f : fills) sum += std::pow(f.borne - most * (1 - std::exp(-f.poured / most)), 2);
        return sum;
    };
    double best = 0.01;
    for (double most = best; most < 20; most *= 1.002)
        if (error(most) < error(best)) best = most;
    return best;
}

} // namespace

Result measure_silo() {
    Result result;
    Plot plot{"Load on the floor of a silo", "poured mass, kg", "carried by the floor, kg", false, false, {}};
    for (const double dt : {time_steps[0], time_steps[1]}) {
        for (const double friction : {0.0, 0.3, 0.6}) {
            Farthest off;
            for (std::uint32_t seed = 0; seed < (friction > 0 ? 3u : 1u); ++seed) {
                Silo silo(friction, 360 + seed, dt);
                const std::vector<Fill> fills = silo.fill();
                const double most = saturation_of(fills);
                Curve expected{"expected (Janssen), friction " + text(friction), {}, {}};
                Curve measured{"friction " + text(friction), {}, {}};
                for (const Fill& f : fills) {
                    const double law = friction > 0 ? most * (1 - std::exp(-f.poured / most)) : f.poured;
                    off.add((f.borne - law) / (friction > 0 ? most : f.poured));
                    expected.x.push_back(f.poured), expected.y.push_back(law);
                    measured.x.push_back(f.poured), measured.y.push_back(f.borne);
                }
                if (seed == 0 && dt == time_steps[0]) plot.curves.push_back(expected), plot.curves.push_back(measured);
            }
            result.rows.push_back(
                {"friction " + text(friction) + ": error of the load on the floor, relative to the greatest load", dt,
                 0, off.value, friction > 0 ? 0.2 : 0.03, Bar::absolute});
        }
    }
    result.plots.push_back(plot);
    return result;
}

} // namespace cairn::validation
