// A rope of links around half of a fixed drum is held by friction (row 35).
#include "validation/cases.h"
#include "validation/measures.h"
#include "validation/random_starts.h"
#include "validation/text.h"
#include "validation/worlds.h"

#include <string>
#include <vector>

namespace cairn::validation {
namespace {

constexpr double drum_radius = 0.5, rope_radius = 0.02, link_mass = 0.01, small_load = 2; // m, m, kg, kg
constexpr int links_on_drum = 40, links_beside = 6;

// The joints between links: up along one side of the drum, around it, and down along the other side.
std::vector<glm::dvec3> rope_points() {
    const double radius = drum_radius + rope_radius, length = pi * radius / links_on_drum;
    std::vector<glm::dvec3> points;
    for (int i = -links_beside; i <= links_on_drum + links_beside; ++i) {
        const double angle = pi - pi * std::clamp(i, 0, links_on_drum) / links_on_drum;
        const double below = std::max({-i, i - links_on_drum, 0}) * length;
        points.push_back({radius * std::cos(angle), radius * std::sin(angle) - below, 0});
    }
    return points;
}

class Capstan {
  public:
    Capstan(double friction, double load, const glm::dquat& heading) : world_(without_sleep()), heading_(heading) {
        const Material material = surface(float(friction));
        BodyDef drum;
        drum.type = BodyType::static_;
        drum.rotation = Quat(heading * glm::angleAxis(pi / 2, glm::dvec3(1, 0, 0)));
        add_body(world_, Cylinder{0.2f, float(drum_radius)}, drum, material);
        const std::vector<glm::dvec3> points = rope_points();
        std::vector<BodyId> links;
        for (std::size_t i = 0; i + 1 < points.size(); ++i) {
            const glm::dvec3 way = points[i + 1] - points[i], middle = 0.5 * (points[i] + points[i + 1]);
            BodyDef def;
            def.position = heading * middle;
            def.rotation = Quat(heading * glm::angleAxis(std::atan2(-way.x, way.y), glm::dvec3(0, 0, 1)));
            def.mass = float(link_mass);
            links.push_back(
                add_body(world_, Capsule{float(0.5 * glm::length(way)), float(rope_radius)}, def, material));
            if (i > 0) join(links[i - 1], links[i], points[i]);
        }
        hang(links.front(), points.front(), small_load);
        load_ = hang(links.back(), points.back(), load);
    }
    // Slip of the rope, m, in 0.7 s, after half a second in which the rope tightens.
    double slip(double dt) {
        run(world_, float(dt), steps_in(0.5, dt));
        const double before = world_.body(load_).position().y;
        run(world_, float(dt), steps_in(0.7, dt));
        return before - world_.body(load_).position().y;
    }

  private:
    void join(BodyId a, BodyId b, const glm::dvec3& at) {
        world_.create_joint(world_.joint_at(a, b, heading_ * at, {0, 1, 0}, BallJoint{}));
    }
    BodyId hang(BodyId link, const glm::dvec3& at, double mass) {
        BodyDef def;
        def.position = heading_ * (at - glm::dvec3(0, 0.1, 0));
        def.mass = float(mass);
        const BodyId weight = add_body(world_, Sphere{0.1f}, def);
        join(link, weight, at);
        return weight;
    }

    World world_;
    glm::dquat heading_;
    BodyId load_;
};

} // namespace

Result measure_capstan() {
    Result result;
    for (const double dt : {time_steps[0], time_steps[1]})
        for (const double friction : {0.1, 0.3, 0.5}) {
            RandomStart random(35);
            const double theory = std::exp(friction * pi);
            const double most = last_where(0.8 * theory, 1.25 * theory, 0.005 * theory, [&](double ratio) {
                const glm::dquat heading = glm::angleAxis(random.uniform(0, 2 * pi), glm::dvec3(0, 1, 0));
                return Capstan(friction, ratio * small_load, heading).slip(dt) < 0.01;
            });
            result.rows.push_back(
                {"friction " + text(friction) + ": greatest ratio of loads without slip", dt, theory, most, 0.05});
        }
    return result;
}

} // namespace cairn::validation
