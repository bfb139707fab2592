// A body that passes another without contact keeps its velocity, whatever the phase of the step.
#include "cells.h"

namespace cairn_test {
namespace {

class Tally {
  public:
    void add(const Position& before, const Position& after) {
        ++ghosts_.shots;
        if (ghosts_.shots == 1) {
            const Position along = glm::normalize(before), change = after - before;
            const double across = glm::length(change - glm::dot(change, along) * along);
            ghosts_.first = {float(glm::dot(after, along)), float(across), 0};
        }
        if (!(glm::length(after - before) > radians(0.01) * glm::length(before))) return;
        ++ghosts_.deflected;
        const double lengths = glm::length(before) * glm::length(after);
        const double cosine = lengths > 0 ? glm::dot(before, after) / lengths : 1;
        sum_ += std::acos(std::clamp(cosine, -1.0, 1.0)) / radians(1);
    }
    Ghosts result() const {
        Ghosts ghosts = ghosts_;
        if (ghosts.deflected > 0) ghosts.mean_angle = sum_ / ghosts.deflected;
        return ghosts;
    }

  private:
    Ghosts ghosts_;
    double sum_ = 0;
};

// The distance, m, from the start of a body to the closest point of its path: random within a step, so that it passes
// in the second or third step.
double run_up(Random& random, const PassBy& cell) {
    return cell.speed * double(frame) * random.between(1, 2) + 8 * cell.size;
}

int steps_past(double start, const PassBy& cell) {
    return 2 + int(std::ceil((start + 8 * cell.size) / (cell.speed * double(frame))));
}

Quat to_quat(const Quat& rotation) { return glm::normalize(rotation); }

} // namespace

Ghosts pass_by(const PassBy& cell) {
    Random random(cell.seed);
    Tally tally;
    const Bullet bullet = make_bullet(cell.kind, cell.size);
    for (int shot = 0; shot < cell.shots; ++shot) {
        World world(without_gravity());
        const Position along = random.direction(), side = random.direction();
        const Position up = glm::normalize(side - glm::dot(side, along) * along);
        BodyDef def;
        def.type = BodyType::static_;
        def.rotation = to_quat(random.rotation());
        double reach = cell.spin > 0 ? bullet.reach + glm::length(bullet.center)
                                     : support(bullet, Position(glm::conjugate(def.rotation) * Vec3(up)));
        add_bullet(world, bullet, def, {});
        def.type = BodyType::dynamic;
        def.rotation = to_quat(random.rotation());
        reach += cell.spin > 0 ? bullet.reach + glm::length(bullet.center)
                               : support(bullet, Position(glm::conjugate(def.rotation) * Vec3(-up)));
        const double start = run_up(random, cell);
        // The relative error of float, 1e-6, adds a gap that does not matter.
        def.position = (reach + cell.gap) * up - start * along;
        def.linear_velocity = Vec3(cell.speed * along);
        def.angular_velocity = Vec3(cell.spin * random.direction());
        const Body body = world.body(add_bullet(world, bullet, def, {}));
        const Position before(body.linear_velocity());
        run(world, frame, steps_past(start, cell));
        tally.add(before, Position(body.linear_velocity()));
    }
    return tally.result();
}

Ghosts pass_edge(const PassBy& cell) {
    Random random(cell.seed);
    Tally tally;
    const double radius = cell.size;
    for (int shot = 0; shot < cell.shots; ++shot) {
        World world(without_gravity());
        BodyDef def;
        def.type = BodyType::static_;
        add_body(world, Box{{0.5f, 0.5f, 0.5f}}, def);
        def.type = BodyType::dynamic;
        // Past the edge at x = 0.5, y = 0.5, along a line perpendicular to the edge and to the shortest connection with
        // it.
        const double angle = random.between(0.1, pi / 2 - 0.1);
        const Position away(std::cos(angle), std::sin(angle), 0), along(-std::sin(angle), std::cos(angle), 0);
        const double start = run_up(random, cell);
        const Position nearest(0.5, 0.5, random.between(-0.3, 0.3));
        def.position = nearest + (radius + cell.gap) * away - start * along;
        def.linear_velocity = Vec3(cell.speed * along);
        const Body body = world.body(add_body(world, Sphere{float(radius)}, def));
        const Position before(body.linear_velocity());
        run(world, frame, steps_past(start, cell));
        tally.add(before, Position(body.linear_velocity()));
    }
    return tally.result();
}

} // namespace cairn_test
