#include "bodies.h"

namespace cairn_test {

Position Random::direction() {
    const double z = between(-1, 1), turn = between(0, 2 * pi), r = std::sqrt(1 - z * z);
    return {r * std::cos(turn), r * std::sin(turn), z};
}

Position Random::direction_near(const Position& axis, double degrees) {
    Position first, second;
    across(axis, first, second);
    const double cosine = between(std::cos(radians(degrees)), 1), turn = between(0, 2 * pi);
    const double sine = std::sqrt(1 - cosine * cosine);
    return cosine * axis + sine * (std::cos(turn) * first + std::sin(turn) * second);
}

Quat Random::rotation() {
    // Shoemake's method for uniformly distributed rotations.
    const double u = uniform(), a = between(0, 2 * pi), b = between(0, 2 * pi);
    const double s = std::sqrt(1 - u), c = std::sqrt(u);
    return glm::normalize(
        Quat(float(c * std::cos(b)), float(s * std::sin(a)), float(s * std::cos(a)), float(c * std::sin(b))));
}

void across(const Position& axis, Position& first, Position& second) {
    const Position other = std::fabs(axis.x) < 0.6 ? Position(1, 0, 0) : Position(0, 1, 0);
    first = glm::normalize(glm::cross(axis, other));
    second = glm::cross(axis, first);
}

const char* name_of(Kind kind) {
    const char* const names[] = {"sphere", "box", "capsule", "cylinder", "cone", "hull", "compound", "plank"};
    return names[std::size_t(kind)];
}

namespace {

// Ten vertices on a sphere: no two faces are parallel.
Hull make_hull(double radius) {
    Random random(7);
    std::vector<Vec3> points;
    while (points.size() < 10) {
        const Position point = random.direction();
        bool is_apart = true;
        for (const Vec3& other : points) is_apart = is_apart && glm::length(Position(other) / radius - point) > 0.7;
        if (is_apart) points.push_back(Vec3(radius * point));
    }
    return Hull(points);
}

double inner_radius_of(const Hull& hull, const Position& center) {
    double radius = 1e9;
    for (std::size_t i = 0; i < hull.face_count(); ++i) {
        const auto face = hull.face(i);
        const Position a(hull.vertices()[face[0]]), b(hull.vertices()[face[1]]), c(hull.vertices()[face[2]]);
        radius = std::min(radius, glm::dot(glm::normalize(glm::cross(b - a, c - a)), a - center));
    }
    return radius;
}

double support_of(const Shape& shape, const Position& d) {
    if (const auto* sphere = std::get_if<Sphere>(&shape)) return double(sphere->radius);
    if (const auto* box = std::get_if<Box>(&shape)) return glm::dot(glm::abs(d), Position(box->half_extents));
    if (const auto* capsule = std::get_if<Capsule>(&shape))
        return double(capsule->half_height) * std::fabs(d.y) + double(capsule->radius);
    if (const auto* cylinder = std::get_if<Cylinder>(&shape)) {
        const double h = double(cylinder->half_height), side = std::sqrt(d.x * d.x + d.z * d.z);
        const double top = double(cylinder->radius_top.value_or(cylinder->radius));
        return std::max(d.y * h + side * top, -d.y * h + side * double(cylinder->radius));
    }
    double most = -1e9;
    for (const Vec3& vertex : std::get<Hull>(shape).vertices()) most = std::max(most, glm::dot(d, Position(vertex)));
    return most;
}

} // namespace

Bullet make_bullet(Kind kind, double size) {
    const float r = float(size);
    Bullet bullet;
    bullet.inner_radius = size;
    switch (kind) {
    case Kind::sphere:
        bullet.shapes = {Sphere{r}};
        break;
    case Kind::box:
        bullet.shapes = {Box{{r, r, r}}};
        break;
    case Kind::capsule:
        bullet.shapes = {Capsule{r, r, {}}};
        break;
    case Kind::cylinder:
        bullet.shapes = {Cylinder{r, r}};
        break;
    case Kind::cone: // the center of mass is a quarter of the height above the base
        bullet.shapes = {cone(r, r)};
        bullet.center = {0, -size / 2, 0};
        bullet.inner_radius = std::min(size / 2, 1.5 * size / std::sqrt(5.0));
        break;
    case Kind::hull:
        bullet.shapes = {make_hull(size)};
        break;
    case Kind::compound: // a cross
        bullet.shapes = {Box{{r, r / 3, r / 3}}, Box{{r / 3, r, r / 3}}};
        bullet.inner_radius = size / 3;
        break;
    case Kind::plank:
        bullet.shapes = {Box{{r, 2 * r / 3, r / 3}}};
        bullet.inner_radius = size / 3;
        break;
    }
    if (kind == Kind::hull) {
        World world;
        const BodyId body = add_bullet(world, bullet, {}, {});
        bullet.center = Position(world.body(body).mass_properties().center_of_mass);
        bullet.inner_radius = inner_radius_of(std::get<Hull>(bullet.shapes[0]), bullet.center);
    }
    const double longest = kind == Kind::sphere                           ? r
                           : kind == Kind::box                            ? r * std::sqrt(3.0)
                           : kind == Kind::cylinder || kind == Kind::cone ? r * std::sqrt(2.0)
                           : kind == Kind::plank                          ? r * std::sqrt(14.0) / 3
                           : kind == Kind::compound                       ? r * std::sqrt(11.0) / 3
                           : kind == Kind::capsule                        ? 2 * r
                                                                          : r;
    bullet.reach = longest + glm::length(bullet.center);
    return bullet;
}

BodyId add_bullet(World& world, const Bullet& bullet, const BodyDef& def, const Material& material) {
    const BodyId body = world.create_body(def);
    ShapeDef shape_def;
    shape_def.material = material;
    for (const Shape& shape : bullet.shapes) world.add_shape(body, shape, shape_def);
    // Adding shapes has moved the center of mass, to which these velocities refer.
    if (def.type == BodyType::dynamic) {
        world.body(body).set_linear_velocity(def.linear_velocity);
        world.body(body).set_angular_velocity(def.angular_velocity);
    }
    return body;
}

double support(const Bullet& bullet, const Position& direction) {
    double most = -1e9;
    for (const Shape& shape : bullet.shapes) most = std::max(most, support_of(shape, direction));
    return most;
}

} // namespace cairn_test
