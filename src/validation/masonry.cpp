// Structures that stand by their shape alone: arches, and overhanging planks (row 32).
#include "validation/cases.h"
#include "validation/measures.h"
#include "validation/random_starts.h"
#include "validation/worlds.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace cairn::validation {
namespace {

constexpr double to_fall = 5; // s; a structure that has moved little by then is stable

// A world with a ground plane, rotated by a random start.
World turned_world(const RandomStart& start, const Material& material, int substeps) {
    WorldDef def = with_turned_gravity(start);
    def.substeps = substeps;
    World world(def);
    BodyDef ground;
    ground.type = BodyType::static_;
    ground.position = start.place({0, 0, 0});
    ground.rotation = start.quat();
    add_body(world, Plane{}, ground, material);
    return world;
}

// Bodies and their initial positions.
class Masonry {
  public:
    Masonry(World& world, const RandomStart& start, const Material& material)
        : world_(world), start_(start), material_(material) {}
    void add(const Shape& shape, const glm::dvec3& at) {
        BodyDef def;
        def.position = start_.place(at);
        def.rotation = start_.quat();
        bodies_.push_back(add_body(world_, shape, def, material_));
        places_.push_back(def.position);
    }
    // Returns whether no body moves farther than `farthest`, m.
    bool stands(double dt, double farthest) {
        run(world_, float(dt), steps_in(to_fall, dt));
        for (std::size_t i = 0; i < bodies_.size(); ++i)
            if (!(glm::length(world_.body(bodies_[i]).position() - places_[i]) <= farthest)) return false;
        return true;
    }

  private:
    World& world_;
    const RandomStart& start_;
    Material material_;
    std::vector<BodyId> bodies_;
    std::vector<Position> places_;
};

// --- arches

// A semicircular arch of equal stones, which are wedges with straight sides. Lengths are relative to the radius of its
// center line.
struct Arch {
    int stones;
    double angle() const { return pi / stones; }
    double weight(double thickness) const { return thickness * std::sin(angle()); } // weight of a stone at unit density
    double center(double thickness) const { // radius of a stone's center of mass
        return (1 + thickness * thickness / 12) * std::cos(0.5 * angle());
    }
};

// Limit analysis (J. Heyman, "The stone skeleton", 1966): an arch of rigid stones that do not slide is stable if some
// line of thrust lies inside it. Returns the margin of the best line, as a moment: the forces at the foot, H inward and
// half of the weight upward, with a variable point of action, determine the moments at all joints. The margin is
// concave in H.
double room_for_thrust(const Arch& arch, double thickness) {
    const double weight = arch.weight(thickness), half = 0.5 * arch.stones * weight;
    const auto room = [&](double push) {
        double least = -std::numeric_limits<double>::infinity(), greatest = -least, moment = 0;
        for (int k = 0; 2 * k < arch.stones + 2; ++k) {
            const double angle = k * arch.angle();
            const double pressed = (half - k * weight) * std::cos(angle) + push * std::sin(angle);
            least = std::max(least, (1 - 0.5 * thickness) * pressed + moment);
            greatest = std::min(greatest, (1 + 0.5 * thickness) * pressed + moment);
            moment += weight * arch.center(thickness) * std::cos(angle + 0.5 * arch.angle());
        }
        return greatest - least;
    };
    double low = 0, high = 10 * half;
    for (int i = 0; i < 100; ++i) {
        const double third = (high - low) / 3;
        if (room(low + third) < room(high - third))
            low += third;
        else
            high -= third;
    }
    return room(low);
}
double least_thickness(const Arch& arch) {
    return last_where(0.02, 0.3, 1e-6, [&](double thickness) { return room_for_thrust(arch, thickness) < 0; });
}

bool stands(const Arch& arch, double thickness, double radius, double depth, const RandomStart& start, int substeps,
            double dt) {
    const Material stone = surface(0.8f);
    World world = turned_world(start, stone, substeps);
    Masonry masonry(world, start, stone);
    for (int i = 0; i < arch.stones; ++i) {
        const double middle = (i + 0.5) * arch.angle(), center = arch.center(thickness);
        const glm::dvec3 at = center * glm::dvec3(std::cos(middle), std::sin(middle), 0);
        std::vector<Vec3> corners;
        for (const double angle : {i * arch.angle(), (i + 1) * arch.angle()})
            for (const double r : {1 - 0.5 * thickness, 1 + 0.5 * thickness})
                for (const double z : {-0.5 * depth, 0.5 * depth})
                    corners.push_back(Vec3(radius * (glm::dvec3(r * std::cos(angle), r * std::sin(angle), z) - at)));
        masonry.add(Hull(corners), radius * at);
    }
    return masonry.stands(dt, 0.05 * radius);
}

// --- planks

// Each plank overhangs the one below as far as the planks above it allow, by 1/2, 1/4, 1/6 of its length and so on, or
// by a part of that. The table ends at 0.
bool stands_over_edge(int planks, double half_length, double part, const RandomStart& start, double dt) {
    const Material wood = surface(0.6f);
    World world = turned_world(start, wood, 0);
    const glm::dvec3 half = half_length * glm::dvec3(1, 0.08, 0.5);
    const double table = 1.2 * planks * half_length;
    BodyDef def;
    def.type = BodyType::static_;
    def.position = start.place({-half_length, 0.5 * table, 0});
    def.rotation = start.quat();
    add_body(world, Box{Vec3(half_length, 0.5 * table, half_length)}, def, wood);
    Masonry masonry(world, start, wood);
    double edge = 0;
    for (int k = 0; k < planks; ++k) {
        edge += part * half_length / (planks - k);
        masonry.add(Box{Vec3(half)}, {edge - half_length, table + (2 * k + 1) * half.y, 0});
    }
    return masonry.stands(dt, 0.05 * half_length);
}

} // namespace

Result measure_masonry() {
    Result result;
    constexpr double usual = 1.0 / 60;
    RandomStart random(32);
    Farthest fine{1}, usually{1};
    Plot plot{"Semicircular arches", "stones", "least stable thickness over the radius", false, false, {}};
    Curve theory{"limit analysis", {}, {}}, measured{"measured, 128 substeps", {}, {}, true},
        coarse{"measured, default substeps", {}, {}, true};
    for (int stones = 7; stones <= 28; ++stones) {
        const Arch arch{stones};
        const double least = least_thickness(arch);
        theory.x.push_back(stones), theory.y.push_back(least);
        if (stones % 3 != 1) continue;
        const RandomStart start(std::uint32_t(320 + stones));
        const double radius = random.uniform(1, 10), depth = random.uniform(0.2, 1.5);
        const auto measure = [&](int substeps, Farthest& farthest, Curve& curve) {
            const double from = last_where(0.8 * least, 1.6 * least, 0.004 * least, [&](double thickness) {
                return !stands(arch, thickness, radius, depth, start, substeps, usual);
            });
            farthest.add(from / least);
            curve.x.push_back(stones), curve.y.push_back(from);
        };
        measure(128, fine, measured);
        measure(0, usually, coarse);
    }
    plot.curves = {theory, measured, coarse};
    result.plots.push_back(plot);
    const char* const thickness =
        "an arch of 7 to 28 stones, 1 to 10 m: least stable thickness over that of limit analysis";
    result.rows.push_back({thickness + std::string(", 128 substeps"), usual, 1, fine.value, 0.02});
    Row row{thickness + std::string(", default substeps"), usual, 1, usually.value, 0.02};
    row.note = "the arch is created at once, so its thrust is unknown before the first step";
    row.known_bar = 0.15;
    result.rows.push_back(row);
    for (const double dt : time_steps) {
        Farthest over{1};
        for (int i = 0; i < 6; ++i) {
            const RandomStart start(std::uint32_t(350 + i));
            const double half_length = random.uniform(1, 4);
            over.add(last_where(0.9, 1.1, 0.002,
                                [&](double part) { return stands_over_edge(3 + i, half_length, part, start, dt); }));
        }
        result.rows.push_back(
            {"3 to 8 planks of 2 to 8 m: greatest stable overhang over 1/2, 1/4, 1/6, ... of their length", dt, 1,
             over.value, 0.02});
    }
    return result;
}

} // namespace cairn::validation
