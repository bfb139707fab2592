// Fuzzes fast motion: any bytes describe a closed room with bodies of random shapes, sizes, speeds and spins. After
// each step a slow oracle (tests/impacts/core_watch.h) checks whether the core of any body has passed through that of
// another, or through a surface. Cores that overlap by less, because the solver pressed them together, are a known
// limit (docs/known_limits.md).
#include "bytes.h"
#include "impacts/core_watch.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <vector>

namespace cairn_fuzz {
namespace {

// The limits of docs/known_limits.md are excluded: joints, meshes and height fields, bodies that turn over within a
// step while the solver holds them, and bodies a thousand times lighter than those that crush them.
constexpr double smallest = 0.01, largest = 0.06; // half widths of bodies, m
constexpr double thinnest = 0.004;                // radius of the inscribed ball, m
constexpr float max_turn = 2.5f;                  // rad per step
constexpr double density_low = 500, density_high = 2000;

class Room {
  public:
    explicit Room(std::span<const std::uint8_t> bytes) : bytes_(bytes) {
        WorldDef def;
        def.hit_speed = 0;
        dt_ = std::array{1.0f / 60, 1.0f / 240, 1.0f / 30}[std::size_t(bytes_.pick(3))];
        def.max_angular_speed = max_turn / dt_;
        if (bytes_.pick(4)) def.gravity = {0, 0, 0};
        world_ = World(def);
        half_ = between(0.25, 0.6);
        add_walls();
        add_obstacle();
        const int bodies = 2 + bytes_.pick(7);
        for (int i = 0; i < bodies; ++i) add_body();
    }

    void run() {
        cairn_test::CoreWatch watch(world_);
        const int steps = 10 + bytes_.pick(31);
        for (int i = 0; i < steps; ++i) {
            world_.step(dt_);
            const cairn_test::CoreEncounters met = watch.look(world_, double(dt_));
            std::string what = met.passed + met.deep > 0 ? met.worst : std::string();
            for (const BodyId id : bodies_)
                if (!is_inside(id)) what = "body " + std::to_string(id.index()) + " has left the room";
            if (!what.empty()) throw std::logic_error("step " + std::to_string(i) + ": " + what);
        }
    }

  private:
    double between(double low, double high) { return low + (high - low) * bytes_.fraction(); }
    double on_scale(double low, double high) { return low * std::pow(high / low, bytes_.fraction()); } // logarithmic
    float size() { return float(on_scale(smallest, largest)); }
    Vec3 vector(double length) {
        const double x = between(-1, 1), y = between(-1, 1), z = between(-1, 1), l = std::hypot(x, y, z);
        return l > 0 ? Vec3(length / l * Position(x, y, z)) : Vec3(float(length), 0, 0);
    }
    Quat rotation() {
        const float x = float(between(-1, 1)), y = float(between(-1, 1)), z = float(between(-1, 1));
        return glm::normalize(Quat(float(between(0.1, 1)), x, y, z));
    }
    ShapeDef surface() {
        ShapeDef def;
        def.material.restitution = 0.5f * float(bytes_.pick(3));
        def.material.static_friction = def.material.dynamic_friction = 0.3f * float(bytes_.pick(4));
        def.density = float(on_scale(density_low, density_high));
        return def;
    }
    bool is_inside(BodyId id) const {
        const Position p = world_.body(id).center_of_mass();
        return std::fabs(p.x) < half_ && std::fabs(p.y) < half_ && std::fabs(p.z) < half_; // false for NaN
    }

    void add_walls() {
        const bool are_planes = bytes_.pick(3) == 0;
        const float thick = float(between(0.002, 0.03)), half = float(half_);
        const ShapeDef def = surface();
        for (int axis = 0; axis < 3; ++axis)
            for (const float side : {-1.0f, 1.0f}) {
                BodyDef body;
                body.type = BodyType::static_;
                body.position[axis] = double(side) * (are_planes ? half_ : half_ + double(thick));
                const BodyId wall = world_.create_body(body);
                Vec3 normal(0), extents(half + 2 * thick);
                normal[axis] = -side, extents[axis] = thick;
                const Vec3 tangent = axis == 0 ? Vec3(0, 1, 0) : Vec3(1, 0, 0);
                world_.add_shape(wall, are_planes ? Shape(Plane{normal, tangent, {}}) : Shape(Box{extents}), def);
            }
    }
    void add_obstacle() {
        const int kind = bytes_.pick(3);
        if (kind == 0) return;
        const ShapeDef def = surface();
        BodyDef body;
        body.type = kind == 1 ? BodyType::static_ : BodyType::kinematic;
        body.rotation = rotation();
        if (kind == 2) body.angular_velocity = vector(on_scale(1, double(max_turn / dt_)));
        const float half = float(half_);
        world_.add_shape(world_.create_body(body), Box{{0.3f * half, 0.2f * half, size()}}, def);
    }

    Shape shape() {
        const float a = size(), b = size(), c = size();
        switch (bytes_.pick(8)) {
        case 0:
            return Sphere{a};
        case 1:
            return Box{{a, b, c}};
        case 2:
            return Box{{a, b, c}, 0.5f * std::min(a, b)};
        case 3:
            return Capsule{a, b, {}};
        case 4:
            return Capsule{a, b, c};
        case 5:
            return Cylinder{a, b, c};
        case 6:
            return cone(a, b);
        default:
            std::vector<Vec3> corners(4 + std::size_t(bytes_.pick(7)));
            for (Vec3& corner : corners) corner = vector(double(a));
            return Hull(corners);
        }
    }
    // Adds a body, unless it would overlap another one.
    void add_body() {
        BodyDef body;
        const double reach = half_ - 0.5 * largest;
        for (int axis = 0; axis < 3; ++axis) body.position[axis] = between(-reach, reach);
        body.rotation = rotation();
        const Vec3 velocity = vector(on_scale(1, 1000)), spin = vector(on_scale(0.1, 1000));
        const BodyId id = world_.create_body(body);
        const int shapes = 1 + (bytes_.pick(4) == 0);
        const ShapeDef def = surface();
        bool is_free = true;
        for (int i = 0; i < shapes; ++i) try {
                const Shape one = shape();
                is_free = is_free && cairn_test::inner_radius(one) >= thinnest;
                world_.add_shape(id, one, def);
            } catch (const Error&) { // a hull without volume
                is_free = false;
            }
        is_free = is_free && is_inside(id) && !overlaps(id);
        if (!is_free) return world_.destroy_body(id);
        world_.body(id).set_linear_velocity(velocity);
        world_.body(id).set_angular_velocity(spin);
        bodies_.push_back(id);
    }
    bool overlaps(BodyId id) const {
        for (const ShapeId shape : world_.body(id).shapes())
            for (const ShapeId other : world_.overlap(world_.shape(shape), world_.shape_transform(shape)))
                if (world_.body_of(other) != id) return true;
        return false;
    }

    Bytes bytes_;
    World world_;
    float dt_ = 0;    // s
    double half_ = 0; // half the room's width, m
    std::vector<BodyId> bodies_;
};

} // namespace
} // namespace cairn_fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        cairn_fuzz::Room({data, size}).run();
    } catch (const std::exception& broken) {
        std::fprintf(stderr, "%s\n", broken.what());
        std::abort();
    }
    return 0;
}
