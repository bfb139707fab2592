// Two conical wheels on an axle that roll along rails and oscillate across them (row 34).
#include "validation/cases.h"
#include "validation/measures.h"
#include "validation/random_starts.h"
#include "validation/worlds.h"

#include <string>
#include <vector>

namespace cairn::validation {
namespace {

struct Track {
    double half_gauge, radius, conicity, speed, offset; // m, m, -, m/s, m
    bool round_rails = false;
    glm::dquat heading{1, 0, 0, 0};
    glm::dvec3 place{0, 0, 0};

    // Wavelength, m, of rolling without slip: J. Klingel, Ueber den Lauf der Eisenbahnwagen auf gerader Bahn, 1883.
    double wavelength() const { return 2 * pi * std::sqrt(radius * half_gauge / conicity); }
};

constexpr double rail_radius = 0.03, half_tread = 0.06, half_track = 30; // m

// Adds the edges of boxes, or cylinders, as rails that touch the wheels at the middle of their treads when centered.
void add_rails(World& world, const Track& track) {
    for (const double side : {-1.0, 1.0}) {
        BodyDef def;
        def.type = BodyType::static_;
        const glm::dvec3 at = track.round_rails ? glm::dvec3(0, -rail_radius, side * track.half_gauge)
                                                : glm::dvec3(0, -0.05, side * (track.half_gauge + 0.03));
        def.position = track.place + track.heading * at;
        def.rotation = Quat(track.heading);
        if (track.round_rails) {
            def.rotation = Quat(track.heading * glm::angleAxis(pi / 2, glm::dvec3(0, 0, 1)));
            add_body(world, Cylinder{float(half_track), float(rail_radius)}, def, rough());
        } else {
            add_body(world, Box{{float(half_track), 0.05f, 0.03f}}, def, rough());
        }
    }
}

BodyId add_wheels(World& world, const Track& track) {
    const double slope = std::atan(track.conicity);
    const double rise = track.round_rails ? rail_radius * (1 / std::cos(slope) - 1) : 0;
    BodyDef def;
    def.position = track.place + track.heading * glm::dvec3(-0.9 * half_track, track.radius + rise, track.offset);
    def.rotation = Quat(track.heading);
    def.linear_velocity = Vec3(track.heading * glm::dvec3(track.speed, 0, 0));
    def.angular_velocity = Vec3(track.heading * glm::dvec3(0, 0, -track.speed / track.radius));
    def.mass_properties = MassProperties{100.0f, {}, {20.0f, 20.0f, 10.0f}, {1, 0, 0, 0}};
    const BodyId axle = world.create_body(def);
    for (const double side : {-1.0, 1.0}) {
        ShapeDef wheel;
        wheel.material = rough();
        wheel.position = {0, 0, float(side * track.half_gauge)};
        wheel.rotation = glm::angleAxis(float(side * pi / 2), Vec3(1, 0, 0)); // the smaller end is outside
        const double taper = track.conicity * half_tread;
        world.add_shape(axle, Cylinder{float(half_tread), float(track.radius + taper), float(track.radius - taper)},
                        wheel);
    }
    return axle;
}

struct Rolled {
    double wavelength = 0; // mean, m
    Curve path{"measured", {}, {}, true};
};
Rolled roll_along(const Track& track, double dt) {
    World world(without_sleep());
    add_rails(world, track);
    const BodyId axle = add_wheels(world, track);
    Rolled run;
    std::vector<double> crossings;
    double x = -0.9 * half_track, z = track.offset;
    const int steps = steps_in(1.8 * half_track / track.speed, dt), shown = std::max(1, steps / 120);
    for (int i = 0; i < steps; ++i) {
        world.step(float(dt));
        const glm::dvec3 now = glm::conjugate(track.heading) * (world.body(axle).position() - track.place);
        if (z * now.z < 0) crossings.push_back(x + (now.x - x) * z / (z - now.z));
        x = now.x, z = now.z;
        if (i % shown == 0) run.path.x.push_back(x + 0.9 * half_track), run.path.y.push_back(z);
    }
    if (crossings.size() > 1)
        run.wavelength = 2 * (crossings.back() - crossings.front()) / double(crossings.size() - 1);
    return run;
}

} // namespace

Result measure_wheelset() {
    Result result;
    Plot plot{"A wheelset on rails, initial offset 1 cm", "distance, m", "lateral offset, m", false, false, {}};
    for (const double dt : time_steps) {
        for (const bool round_rails : {false, true}) {
            RandomStart random(34);
            Farthest wavelength{1};
            for (int i = 0; i < 6; ++i) {
                Track track;
                track.half_gauge = random.uniform(0.3, 0.8), track.radius = random.uniform(0.2, 0.5);
                track.conicity = random.uniform(0.05, 0.15), track.speed = random.uniform(1, 2);
                track.offset = 0.01, track.round_rails = round_rails;
                track.heading = glm::angleAxis(random.uniform(0, 2 * pi), glm::dvec3(0, 1, 0));
                track.place = {random.uniform(-50, 50), random.uniform(-5, 5), random.uniform(-50, 50)};
                const Rolled run = roll_along(track, dt);
                wavelength.add(run.wavelength / track.wavelength());
                if (i > 0 || round_rails || dt != time_steps[0]) continue;
                Curve expected{"expected (Klingel)", {}, {}};
                for (int k = 0; k <= 240; ++k) {
                    expected.x.push_back(1.8 * half_track * k / 240);
                    expected.y.push_back(track.offset * std::cos(2 * pi * expected.x.back() / track.wavelength()));
                }
                plot.curves = {expected, run.path};
            }
            result.rows.push_back(
                {std::string("wavelength on ") + (round_rails ? "round rails" : "edges") + " over Klingel's", dt, 1,
                 wavelength.value, 0.02});
        }
    }
    result.plots.push_back(plot);
    return result;
}

} // namespace cairn::validation
