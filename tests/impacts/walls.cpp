// Bodies shot at walls that they must not pass.
#include "cells.h"

#include <array>

namespace cairn_test {
namespace {

constexpr double half_width = 2;      // m, of static walls; plates have half of it
constexpr double aim = 0.3;           // m; shots hit within this distance of the middle, in x and z
constexpr double hill = 0.05;         // m: the height field lies between -hill and 0
constexpr int columns = 17;           // of the height field, 0.25 m apart
constexpr double fastest_wall = 30;   // m/s
constexpr double greatest_turn = 0.5; // rad; a plate that rotates by more within a step is not judged by its poses
constexpr double plate_mass = 0.12;   // kg per N s of the bullet: hit at its edge, it rotates by half of that

float height_at(int column, int row) { return float(-hill * (0.5 + 0.5 * std::sin(1.7 * column + 2.3 * row))); }

// The height of the field's triangles at a place, m.
double height_of_field(double x, double z) {
    const double spacing = 2 * half_width / (columns - 1);
    const double u = (x + half_width) / spacing, v = (z + half_width) / spacing;
    const int column = std::clamp(int(u), 0, columns - 2), row = std::clamp(int(v), 0, columns - 2);
    const double s = u - column, t = v - row;
    const double first = double(height_at(column, row)), last = double(height_at(column + 1, row + 1));
    if (s > t) {
        const double corner = double(height_at(column + 1, row));
        return first + s * (corner - first) + t * (last - corner);
    }
    const double corner = double(height_at(column, row + 1));
    return first + t * (corner - first) + s * (last - corner);
}

Shape make_field() {
    std::vector<float> heights;
    for (int row = 0; row < columns; ++row)
        for (int column = 0; column < columns; ++column) heights.push_back(height_at(column, row));
    const float spacing = float(2 * half_width / (columns - 1));
    return HeightField(columns, columns, {spacing, spacing}, heights);
}

// A flat mesh of triangles of all shapes.
Shape make_mesh() {
    Random random(3);
    constexpr std::uint32_t n = 9;
    std::vector<Vec3> points;
    for (std::uint32_t row = 0; row < n; ++row)
        for (std::uint32_t column = 0; column < n; ++column) {
            const auto place = [&](std::uint32_t i) {
                const bool is_inner = i > 0 && i + 1 < n;
                return float(half_width * (2.0 * (i + (is_inner ? random.between(-0.3, 0.3) : 0)) / (n - 1) - 1));
            };
            const float x = place(column);
            points.push_back({x, 0, place(row)});
        }
    std::vector<std::uint32_t> corners;
    for (std::uint32_t row = 0; row + 1 < n; ++row)
        for (std::uint32_t column = 0; column + 1 < n; ++column) {
            const std::uint32_t a = row * n + column, b = a + 1, c = a + n, d = c + 1;
            for (const std::uint32_t corner : {a, c, d, a, d, b}) corners.push_back(corner);
        }
    return Mesh(points, corners);
}

class Wall {
  public:
    Wall(World& world, const Shooting& cell, const Position& velocity, double bullet_mass) : cell_(cell) {
        static const Shape field = make_field(), mesh = make_mesh();
        const float thick = float(cell.thickness / 2);
        BodyDef def;
        def.type = BodyType::static_;
        half_ = half_width;
        Shape shape = Box{{float(half_), thick, float(half_)}};
        if (cell.target == Target::plane) shape = Plane{};
        if (cell.target == Target::mesh) shape = mesh;
        if (cell.target == Target::height_field) shape = field;
        if (cell.target == Target::kinematic) {
            def.type = BodyType::kinematic;
            def.linear_velocity = Vec3(velocity);
        }
        if (cell.target == Target::plate) {
            half_ = half_width / 2;
            shape = Box{{float(half_), thick, float(half_)}};
            def.type = BodyType::dynamic;
            const double mass = 4000 * half_ * half_ * cell.thickness; // kg
            def.mass = float(std::max(mass, plate_mass * bullet_mass * cell.speed));
        }
        id_ = add_body(world, shape, def, surface(0.6f, float(cell.restitution)));
    }

    struct Pose {
        Position position;
        glm::dquat rotation;
        // A point in the frame of the wall.
        Position seen(const Position& point) const { return glm::conjugate(rotation) * (point - position); }
    };
    Pose pose(World& world) const {
        const Body body = world.body(id_);
        return {body.position(), glm::dquat(body.rotation())};
    }

    // Whether a center that moves between two places, in the frame of the wall, passes it within a step.
    bool is_passed(const Position& from, const Position& to) const {
        const bool is_field = cell_.target == Target::height_field;
        const double middle = is_field ? -hill : 0.0;
        if (is_field && covers(to) && from.y > height_of_field(from.x, from.z) && to.y < height_of_field(to.x, to.z))
            return true;
        if (!(from.y > middle && to.y <= middle)) return false;
        return covers(from + (to - from) * ((from.y - middle) / (from.y - to.y)));
    }
    // Whether a ball of the given radius, with its center in front, is in the wall.
    bool has_in(const Position& center, double radius) const {
        if (!covers(center)) return false;
        const bool is_thick =
            cell_.target == Target::box || cell_.target == Target::plate || cell_.target == Target::kinematic;
        double surface = is_thick ? cell_.thickness / 2 : 0;
        if (cell_.target == Target::height_field) surface = height_of_field(center.x, center.z);
        return center.y - surface < radius - 1e-5;
    }

  private:
    bool covers(const Position& place) const {
        if (cell_.target == Target::plane) return true;
        const double inside = half_ - 2 * cell_.size;
        return std::fabs(place.x) < inside && std::fabs(place.z) < inside;
    }

    Shooting cell_;
    BodyId id_;
    double half_ = 0;
};

enum class Fate : std::uint8_t { held, core_in, through };

// Whether a center passed the wall in a step in which both move uniformly: a body that leaves a plate past its edge may
// be behind it at the end of the step.
bool passes(const Wall& wall, const Wall::Pose& first, const Position& from, const Wall::Pose& last,
            const Position& to) {
    constexpr int looks = 256;
    Position before = first.seen(from);
    for (int i = 1; i <= looks; ++i) {
        const double part = double(i) / looks;
        const Wall::Pose pose{glm::mix(first.position, last.position, part),
                              glm::slerp(first.rotation, last.rotation, part)};
        const Position now = pose.seen(glm::mix(from, to, part));
        if (wall.is_passed(before, now)) return true;
        before = now;
    }
    return false;
}

Fate follow(World& world, const Wall& wall, const Body& body, double core, int steps) {
    Fate fate = Fate::held;
    Position from = body.center_of_mass();
    Wall::Pose first = wall.pose(world);
    for (int i = 0; i < steps; ++i) {
        world.step(frame);
        const Position to = body.center_of_mass();
        const Wall::Pose last = wall.pose(world);
        const double cosine = std::fabs(glm::dot(first.rotation, last.rotation));
        if (2 * std::acos(std::min(1.0, cosine)) > greatest_turn) return fate;
        if (passes(wall, first, from, last, to)) return Fate::through;
        const Position now = last.seen(to);
        if (now.y < 0) return fate; // beyond the edge of the wall
        if (wall.has_in(now, core)) fate = Fate::core_in;
        from = to;
        first = last;
    }
    return fate;
}

struct Shot {
    Quat rotation{1, 0, 0, 0};
    Position direction{0, -1, 0}; // of the velocity of the bullet relative to the target
    double way = 0;               // m, distance to the target
    Vec3 spin{0, 0, 0};
};

Shot draw(Random& random, const Shooting& cell, const Bullet& bullet) {
    Shot shot;
    shot.direction = random.direction_near({0, -1, 0}, cell.steepest);
    // Without contact with the wall at the start, whatever the rotation.
    const double clear = (bullet.reach + cell.thickness / 2 + 0.01) / -shot.direction.y;
    shot.way = clear + cell.speed * double(frame) * random.between(0, 2);
    const Quat rotation = random.rotation();
    if (cell.is_turned) shot.rotation = rotation;
    shot.spin = Vec3(cell.spin * random.direction());
    return shot;
}

int steps_of(const Shot& shot, const Shooting& cell) { return 5 + int(shot.way / (cell.speed * double(frame))); }

Fate shoot_wall(Random& random, const Shooting& cell, const Bullet& bullet) {
    const Shot shot = draw(random, cell, bullet);
    const Position wall_velocity = cell.target == Target::kinematic
                                       ? std::min(fastest_wall, 0.3 * cell.speed) * random.direction()
                                       : Position(0, 0, 0);
    World world(without_gravity());
    const Position goal(random.between(-aim, aim), 0, random.between(-aim, aim));
    BodyDef def;
    def.rotation = shot.rotation;
    def.position = goal - shot.way * shot.direction - glm::dquat(shot.rotation) * bullet.center;
    def.linear_velocity = Vec3(cell.speed * shot.direction + wall_velocity);
    def.angular_velocity = shot.spin;
    const Body body = world.body(add_bullet(world, bullet, def, surface(0.6f, float(cell.restitution))));
    const Wall wall(world, cell, wall_velocity, double(body.mass()));
    const double core = bullet.inner_radius - core_shrink(bullet.inner_radius);
    return follow(world, wall, body, core, steps_of(shot, cell));
}

// Two bullets that move toward each other, each at half of the speed.
Fate shoot_bullet(Random& random, const Shooting& cell, const Bullet& bullet) {
    const Shot first = draw(random, cell, bullet), second = draw(random, cell, bullet);
    World world(without_gravity());
    Position side, other;
    across(first.direction, side, other);
    const double most = bullet.inner_radius;
    const Position offset = random.between(-most, most) * side + random.between(-most, most) * other;
    const auto add = [&](const Shot& shot, double sign, const Position& from) {
        BodyDef def;
        def.rotation = shot.rotation;
        def.position = from - sign * 0.5 * (first.way + 2 * bullet.reach) * first.direction -
                       glm::dquat(shot.rotation) * bullet.center;
        def.linear_velocity = Vec3(sign * 0.5 * cell.speed * first.direction);
        def.angular_velocity = shot.spin;
        return world.body(add_bullet(world, bullet, def, surface(0.6f, float(cell.restitution))));
    };
    const Body a = add(first, 1, offset), b = add(second, -1, {0, 0, 0});
    const double cores = 2 * (bullet.inner_radius - core_shrink(bullet.inner_radius)) - 1e-5;
    Position before = b.center_of_mass() - a.center_of_mass();
    for (int i = 0; i < steps_of(first, cell) + 1; ++i) {
        world.step(frame);
        const Position now = b.center_of_mass() - a.center_of_mass(), change = now - before;
        const double length2 = glm::dot(change, change);
        const double when = length2 > 0 ? std::clamp(-glm::dot(before, change) / length2, 0.0, 1.0) : 0;
        if (glm::length(before + when * change) < cores) return Fate::through;
        before = now;
    }
    return Fate::held;
}

} // namespace

const char* name_of(Target target) {
    const char* const names[] = {"box", "plane", "mesh", "height field", "plate", "kinematic", "bullet"};
    return names[std::size_t(target)];
}

Lost shoot(const Shooting& cell) {
    Random random(cell.seed);
    const Bullet bullet = make_bullet(cell.kind, cell.size);
    Lost lost;
    for (; lost.shots < cell.shots; ++lost.shots) {
        const Fate fate =
            cell.target == Target::bullet ? shoot_bullet(random, cell, bullet) : shoot_wall(random, cell, bullet);
        lost.through += fate == Fate::through;
        lost.core_in += fate == Fate::core_in;
    }
    return lost;
}

} // namespace cairn_test
