#include "bodies/fluids.h"

#include "bodies/integrators.h"
#include "math/angle.h"
#include "state/substeps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace cairn {

using math::dot;
using math::DVec3;

namespace {

DVec3 of_public(const Vec3& v) { return {v.x, v.y, v.z}; }

// A fluid as a body sees it: places are relative to the body's center of mass.
struct Surroundings {
    DVec3 up;                       // away from gravity; zero without it
    double surface = 0;             // how far above the body, along that
    int vertical = -1;              // the axis nearest to that
    DVec3 center, half;             // m
    double pressed = 0, rubbed = 0; // kg/m^3: half of the density times the coefficients of drag and of skin friction
    DVec3 v, w;                     // of the body against it

    DVec3 velocity_at(DVec3 p) const { return v + math::cross(w, p); }
    double depth_of(DVec3 p) const { return surface - dot(up, p); }
};

// A symmetric matrix that makes a force and a torque about the center of mass of a velocity and a rate of turn. The
// lower half is kept.
class Coupling {
  public:
    // Along n at a point, by `weight` for each unit of motion along it.
    void add(DVec3 at, DVec3 n, double weight) {
        const DVec3 turn = math::cross(at, n);
        const std::array<double, 6> j = {n.x, n.y, n.z, turn.x, turn.y, turn.z};
        for (std::size_t i = 0; i < 6; ++i)
            for (std::size_t k = 0; k <= i; ++k) entries_[i][k] += weight * j[i] * j[k];
    }
    // In all directions.
    void add(DVec3 at, double weight) {
        for (int axis = 0; axis < 3; ++axis) {
            DVec3 n;
            n[axis] = 1;
            add(at, n, weight);
        }
    }
    void add_turn(double weight) {
        for (std::size_t i = 3; i < 6; ++i) entries_[i][i] += weight;
    }
    void add(const Coupling& other, double weight) {
        for (std::size_t i = 0; i < 6; ++i)
            for (std::size_t k = 0; k <= i; ++k) entries_[i][k] += weight * other.entries_[i][k];
    }
    double operator()(std::size_t i, std::size_t k) const { return i >= k ? entries_[i][k] : entries_[k][i]; }

  private:
    std::array<std::array<double, 6>, 6> entries_{};
};

// What a body displaces, of density 1: the volume, its first moments about the center of mass, the second ones.
struct Displaced {
    double volume = 0;
    DVec3 first;
    math::DSym3 second;

    // A column that ends at p, with that area across `up` and that height above p.
    void add_column(DVec3 p, DVec3 up, double area, double height) {
        const double one = area * height, two = 0.5 * one * height, three = two * height / 1.5;
        volume += one;
        first += one * p + two * up;
        const auto entry = [&](int i, int k) {
            return one * p[i] * p[k] + two * (p[i] * up[k] + up[i] * p[k]) + three * up[i] * up[k];
        };
        second = second + math::DSym3{entry(0, 0), entry(0, 1), entry(0, 2), entry(1, 1), entry(1, 2), entry(2, 2)};
    }
    void add_point(DVec3 p, double v) {
        volume += v, first += v * p;
        second = second +
                 math::DSym3{v * p.x * p.x, v * p.x * p.y, v * p.x * p.z, v * p.y * p.y, v * p.y * p.z, v * p.z * p.z};
    }
};

// What is wetted of a body by one fluid.
class Wetted {
  public:
    explicit Wetted(const Surroundings& fluid) : fluid_(fluid) {}

    // `lid`: up to where columns are counted, above all of the shape that is wet.
    void add_triangle(DVec3 a, DVec3 b, DVec3 c, double lid) {
        Polygon p = {{a, b, c}, 3};
        if (fluid_.vertical >= 0) p.clip(fluid_.up, fluid_.surface);
        for (int axis = 0; axis < 3 && p.count > 0; ++axis) {
            if (axis == fluid_.vertical || !std::isfinite(fluid_.half[axis])) continue;
            DVec3 n;
            n[axis] = 1;
            p.clip(n, fluid_.center[axis] + fluid_.half[axis]);
            p.clip(-n, fluid_.half[axis] - fluid_.center[axis]);
        }
        for (int i = 2; i < p.count; ++i) add_piece(p.at[0], p.at[std::size_t(i) - 1], p.at[std::size_t(i)], lid);
    }
    void add_ball(DVec3 center, double radius);

    Displaced displaced;
    Coupling drag, waterline; // N s/m; m^2, and so on
    double waterline_area = 0;
    DVec3 force, torque; // of drag

  private:
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
    void add_piece(DVec3 a, DVec3 b, DVec3 c, double lid) {
        const DVec3 area = 0.5 * math::cross(b - a, c - a);
        const double size = math::length(area), level = -dot(area, fluid_.up);
        if (!(size > 0)) return;
        // Exact up to the third degree (Strang and Fix 1973): columns are of that.
        if (level != 0) {
            add_column((1.0 / 3) * (a + b + c), -27.0 / 48 * level, lid);
            for (const DVec3 p : {a, b, c}) add_column(0.2 * (2.0 * p + (a + b + c)), 25.0 / 48 * level, lid);
        }
        const DVec3 n = (1 / size) * area;
        for (const DVec3 p : {0.5 * (a + b), 0.5 * (b + c), 0.5 * (c + a)}) add_drag(p, n, size / 3);
    }
    void add_column(DVec3 p, double area, double lid) {
        displaced.add_column(p, fluid_.up, area, lid - dot(fluid_.up, p));
        waterline.add(p, fluid_.up, area);
        waterline_area += area;
    }
    void push(DVec3 at, DVec3 f) { force += f, torque += math::cross(at, f); }
    void add_drag(DVec3 at, DVec3 n, double area) {
        const DVec3 v = fluid_.velocity_at(at);
        const double s = dot(n, v);
        if (s > 0) {
            const double k = fluid_.pressed * s * area;
            push(at, (-k * s) * n);
            drag.add(at, n, k);
        }
        const DVec3 along = v - s * n;
        const double speed = math::length(along);
        if (!(fluid_.rubbed > 0) || !(speed > 0)) return;
        const double k = fluid_.rubbed * speed * area;
        push(at, -k * along);
        drag.add(at, k);
        drag.add(at, n, -k);
    }
    const Surroundings& fluid_;
};

// The same integrals in closed form. What resists a ball that is partly in the fluid is the part of its volume that is;
// what it moves along does not turn with it.
void Wetted::add_ball(DVec3 center, double radius) {
    const double square = radius * radius, whole = 4.0 / 3.0 * math::pi * square * radius;
    double part = 1;
    if (fluid_.vertical >= 0) {
        const double height = std::clamp(radius + fluid_.depth_of(center), 0.0, 2 * radius);
        if (!(height > 0)) return;
        const double volume = math::pi * height * height * (3 * radius - height) / 3;
        const double area = math::pi * height * (2 * radius - height);
        part = volume / whole;
        displaced.add_point(center, volume); // the force of a pressure on a ball goes through its middle
        waterline.add(center, fluid_.up, area);
        waterline_area += area;
    }
    const DVec3 v = fluid_.velocity_at(center);
    const double speed = math::length(v), turn = math::length(fluid_.w);
    // The mean of the square of a sine to the second power over a ball, times its surface.
    const double rub = part * fluid_.rubbed * 0.75 * math::pi * math::pi * square;
    if (speed > 0) {
        const double k = part * fluid_.pressed * math::pi * square * speed, rubbed = rub * speed;
        push(center, -(0.5 * k + rubbed) * v);
        drag.add(center, 0.25 * k + rubbed);
        drag.add(center, (1 / speed) * v, 0.25 * k);
    }
    const double k = rub * square * turn;
    torque += -k * fluid_.w;
    drag.add_turn(k);
}

// Of unknowns that are coupled by a matrix close to one that is positive definite; by elimination.
using Vector6 = std::array<double, 6>;
using Matrix6 = std::array<Vector6, 6>;
Vector6 solved(Matrix6 m, Vector6 b) {
    for (std::size_t i = 0; i < 6; ++i) {
        std::size_t pivot = i;
        for (std::size_t k = i + 1; k < 6; ++k)
            if (std::fabs(m[k][i]) > std::fabs(m[pivot][i])) pivot = k;
        std::swap(m[i], m[pivot]), std::swap(b[i], b[pivot]);
        for (std::size_t k = i + 1; k < 6; ++k) {
            const double factor = m[k][i] / m[i][i];
            for (std::size_t l = i; l < 6; ++l) m[k][l] -= factor * m[i][l];
            b[k] -= factor * b[i];
        }
    }
    for (std::size_t i = 6; i-- > 0;) {
        for (std::size_t l = i + 1; l < 6; ++l) b[i] -= m[i][l] * b[l];
        b[i] /= m[i][i];
    }
    return b;
}

// All that fluids do to a body.
struct Effect {
    DVec3 force, torque;
    Coupling resistance; // kg: of the velocity change in the step, times the step
    double mass = 0;     // that is moved along
    math::DSym3 inertia; // likewise, about the center of mass
    bool any = false;
};

// How a body that all forces but contacts and joints move changes its velocity in the step, and from that the impulse
// of the fluids. `mass`: with what is moved along.
void push_laden(const FluidContext& c, std::int32_t body, const BodyMass& own, const BodyMass& mass,
                const Effect& effect, double dt) {
    const BodyMotion& motion = c.bodies.motion[body];
    BodyForces& forces = c.bodies.forces[body];
    const Spin spin = spin_of(mass);
    const auto moved_by = [&](DVec3 force, DVec3 torque) {
        const DVec3 v = double(mass.inverse_mass) * force, w = spin.to_world(motion.q, spin.inverse_moments, torque);
        return Vector6{v.x, v.y, v.z, w.x, w.y, w.z};
    };
    DVec3 others, turned;
    if (own.inverse_mass > 0)
        others = double(own.mass) * acceleration_at(c.bodies, c.fields, c.settings, body, motion.x);
    if (c.bodies.is_pushed(body)) turned = forces.torque;
    const Vector6 free = moved_by(dt * (effect.force + others), dt * (effect.torque + turned));
    Matrix6 m{};
    for (std::size_t k = 0; k < 6; ++k) {
        const auto r = [&](std::size_t i) { return effect.resistance(i, k); };
        const Vector6 column = moved_by({r(0), r(1), r(2)}, {r(3), r(4), r(5)});
        for (std::size_t i = 0; i < 6; ++i) m[i][k] = column[i] + (i == k ? 1 : 0);
    }
    const Vector6 change = solved(m, free);
    Vector6 resisted{};
    for (std::size_t i = 0; i < 6; ++i)
        for (std::size_t k = 0; k < 6; ++k) resisted[i] += effect.resistance(i, k) * change[k];
    // Gravity and fields accelerate what is moved along as well, which does not weigh.
    const DVec3 weight = (double(mass.mass) - double(own.mass)) *
                         field_acceleration(c.fields, c.settings, motion.x, c.bodies.settings[body].gravity_scale, 0);
    const DVec3 force = effect.force - (1 / dt) * DVec3{resisted[0], resisted[1], resisted[2]} -
                        (own.inverse_mass > 0 ? weight : DVec3{}),
                torque = effect.torque - (1 / dt) * DVec3{resisted[3], resisted[4], resisted[5]};
    if (!math::is_finite(force) || !math::is_finite(torque)) return;
    forces.force += force, forces.torque += torque;
    forces.any |= pushed_by_fluid;
    c.bodies.mass[body] = mass;
    // What nothing holds is not at rest where it would be faster than that in the time: a ship that turns around.
    BodyLinks& links = c.bodies.links[body];
    const double speed = math::length(DVec3{change[0], change[1], change[2]}) +
                         math::length(DVec3{change[3], change[4], change[5]}) * double(links.radius);
    if (links.contact_count == 0 && links.joint_count == 0 && links.quiet_time != told_to_sleep &&
        speed * double(c.settings.sleep_time) > dt * double(c.settings.sleep_speed))
        links.quiet_time = 0;
}

// With what is moved along. The principal axes stay: of the inertia that comes, what is beside them is left out.
BodyMass laden(const BodyMass& own, const math::DQuat& q, const Effect& effect) {
    BodyMass mass = own;
    if (!(effect.mass > 0)) return mass;
    if (own.inverse_mass > 0) mass.mass += float(effect.mass), mass.inverse_mass = 1 / mass.mass;
    const math::DMat3 axes = math::to_matrix(q * math::to_double(own.principal));
    for (int i = 0; i < 3; ++i) {
        if (!(own.inverse_inertia[i] > 0)) continue;
        const DVec3 axis = axes.column(i);
        mass.inertia[i] += float(std::max(dot(axis, effect.inertia * axis), 0.0));
        mass.inverse_inertia[i] = 1 / mass.inertia[i];
    }
    const math::Vec3 i = mass.inertia;
    mass.isotropic = own.isotropic && i.x == i.y && i.y == i.z;
    return mass;
}

// Which part of a step passes, on average, before the place is the one that substeps with a constant force give.
double mean_moment(const WorldDef& settings, int substeps) {
    switch (settings.integrator) {
    case Integrator::semi_implicit_euler:
        return 0.5 * (substeps - 1) / substeps;
    case Integrator::explicit_euler:
        return 0.5 * (substeps + 1) / substeps;
    case Integrator::rk4:
        break;
    }
    return 0.5;
}

// One body in the fluids of a world.
class FloatingBody {
  public:
    FloatingBody(const FluidContext& c, std::int32_t body, double dt)
        : c_(c), body_(body), dt_(dt), motion_(c.bodies.motion[body]) {
        const std::int32_t island = c.bodies.links[body].island;
        const int known = c.islands.all[island].substeps;
        const double ahead = dt * mean_moment(c.settings, known > 0 ? known : substeps_of(c.settings, float(dt)));
        x_ = motion_.x + ahead * math::to_double(motion_.v);
        q_ = turned_by(ahead * math::to_double(motion_.w), motion_.q);
        center_ = math::to_double(c.bodies.mass[body].center);
    }
    void wet(const ForceField& field, std::vector<SurfaceTriangle>& surface) {
        const Surroundings fluid = around(field);
        Wetted wetted(fluid);
        is_wet_ = false;
        for (std::int32_t s = c_.bodies.links[body_].first_shape; s != none; s = c_.shapes.links[s].next)
            if (!c_.shapes.traits[s].is_trigger) add_shape(std::uint32_t(s), fluid, surface, wetted);
        if (is_wet_) take(field, fluid, wetted);
    }
    // `own`: where its mass is kept if anything is moved along.
    void push(std::vector<std::pair<std::int32_t, BodyMass>>& own) const {
        if (!effect_.any) return;
        const BodyMass mass = c_.bodies.mass[body_];
        push_laden(c_, body_, mass, laden(mass, motion_.q, effect_), effect_, dt_);
        if (c_.bodies.forces[body_].any & pushed_by_fluid) own.emplace_back(body_, mass);
    }

  private:
    Surroundings around(const ForceField& field) const {
        Surroundings s;
        const DVec3 gravity = of_public(c_.settings.gravity);
        const double g = math::length(gravity);
        s.center = DVec3{field.center.x, field.center.y, field.center.z} - x_;
        s.half = of_public(field.half_extents);
        if (g > 0) {
            s.up = (-1 / g) * gravity;
            const DVec3 size = math::abs(s.up);
            s.vertical = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
            s.surface = dot(s.up, s.center);
        }
        s.pressed = 0.5 * double(field.density) * double(field.drag);
        s.rubbed = 0.5 * double(field.density) * double(field.skin_friction);
        s.v = math::to_double(motion_.v) - of_public(field.direction), s.w = math::to_double(motion_.w);
        return s;
    }
    void take(const ForceField& field, const Surroundings& fluid, const Wetted& wetted) {
        const Displaced& d = wetted.displaced;
        const double density = field.density, g = math::length(of_public(c_.settings.gravity)), stiff = density * g;
        effect_.any = true;
        effect_.force += wetted.force + (stiff * d.volume) * fluid.up;
        effect_.torque += wetted.torque + stiff * math::cross(d.first, fluid.up);
        effect_.resistance.add(wetted.drag, dt_);
        if (stiff > 0 && wetted.waterline_area > 0 && d.volume > 0) {
            const double damped =
                2 * double(field.wave_damping) * std::sqrt(d.volume / (g * wetted.waterline_area)) * stiff;
            const DVec3 v = fluid.v, w = fluid.w;
            const Vector6 motion = {v.x, v.y, v.z, w.x, w.y, w.z};
            Vector6 lost{};
            for (std::size_t i = 0; i < 6; ++i)
                for (std::size_t k = 0; k < 6; ++k) lost[i] -= damped * wetted.waterline(i, k) * motion[k];
            effect_.force += DVec3{lost[0], lost[1], lost[2]}, effect_.torque += DVec3{lost[3], lost[4], lost[5]};
            effect_.resistance.add(wetted.waterline, dt_ * damped + 0.25 * dt_ * dt_ * stiff);
        }
        const double moved = density * double(field.added_mass);
        const math::DSym3& m = d.second;
        effect_.mass += moved * d.volume;
        effect_.inertia = effect_.inertia + math::DSym3{moved * (m.yy + m.zz), -moved * m.xy, -moved * m.xz,
                                                        moved * (m.xx + m.zz), -moved * m.yz, moved * (m.xx + m.yy)};
    }
    // Whether anything of a ball is in the fluid, whose bottom has all or nothing.
    static bool reaches(const Surroundings& fluid, DVec3 middle, double radius) {
        if (fluid.vertical >= 0) {
            const double depth = fluid.depth_of(middle);
            if (!(depth > -radius) || depth > fluid.half[fluid.vertical]) return false;
        }
        for (int axis = 0; axis < 3; ++axis)
            if (axis != fluid.vertical && !(std::fabs(middle[axis] - fluid.center[axis]) < fluid.half[axis] + radius))
                return false;
        return true;
    }
    void add_shape(std::uint32_t shape, const Surroundings& fluid, std::vector<SurfaceTriangle>& surface,
                   Wetted& wetted) {
        const Geometry& g = c_.shapes.geometry[shape];
        const DVec3 middle =
            placed(math::to_double(g.position) +
                   math::rotate(math::normalized(math::to_double(g.rotation)), math::to_double(g.middle)));
        if (g.type == ShapeType::sphere) { // at a side of the fluid: where its middle is
            if (!reaches(fluid, middle, double(g.size.x)) || !is_beside(fluid, middle)) return;
            is_wet_ = true;
            wetted.add_ball(middle, double(g.size.x));
            return;
        }
        if (!reaches(fluid, middle, double(g.bounding_radius))) return;
        is_wet_ = true;
        const double lid = std::min(fluid.surface, dot(fluid.up, middle) + double(g.bounding_radius));
        make_solid_surface(g, c_.shapes.data[shape], surface);
        for (const SurfaceTriangle& t : surface) wetted.add_triangle(placed(t.a), placed(t.b), placed(t.c), lid);
    }
    static bool is_beside(const Surroundings& fluid, DVec3 p) {
        for (int axis = 0; axis < 3; ++axis)
            if (axis != fluid.vertical && std::fabs(p[axis] - fluid.center[axis]) > fluid.half[axis]) return false;
        return true;
    }
    DVec3 placed(DVec3 in_body) const { return math::rotate(q_, in_body - center_); }

    const FluidContext& c_;
    const std::int32_t body_;
    const double dt_;
    const BodyMotion& motion_;
    DVec3 x_, center_;
    math::DQuat q_;
    Effect effect_;
    bool is_wet_ = false;
};

bool is_fluid(const ForceFields& fields, std::size_t i) {
    return fields.slots.is_live(std::uint32_t(i)) && fields.all[i].kind == ForceField::Kind::fluid;
}

} // namespace

void push_by_fluids(const FluidContext& c, FluidScratch& scratch, ThreadPool& threads, float dt) {
    constexpr int bodies_per_chunk = 8;
    bool any = false;
    for (std::size_t i = 0; i < c.fields.all.size(); ++i) any = any || is_fluid(c.fields, i);
    if (!any) return;
    scratch.reached.clear();
    for (const std::int32_t island : c.islands.awake)
        for (std::int32_t b = c.islands.all[island].first_body; b != none; b = c.bodies.links[b].next_in_island)
            if (!(c.bodies.forces[b].any & pushed_by_fluid)) scratch.reached.push_back(b);
    scratch.at_work.resize(std::size_t(threads.threads()));
    threads.for_chunks(int(scratch.reached.size()), bodies_per_chunk, [&](int begin, int end, int thread) {
        FluidScratch::AtWork& own = scratch.at_work[std::size_t(thread)];
        for (int k = begin; k < end; ++k) {
            FloatingBody body(c, scratch.reached[std::size_t(k)], double(dt));
            for (std::size_t i = 0; i < c.fields.all.size(); ++i)
                if (is_fluid(c.fields, i)) body.wet(c.fields.all[i], own.surface);
            body.push(own.laden);
        }
    });
    for (const std::int32_t b : scratch.reached)
        if (c.bodies.forces[b].any == pushed_by_fluid) c.bodies.pushed.push_back(b); // of no other force yet
}

void unload(Bodies& bodies, FluidScratch& scratch) {
    for (FluidScratch::AtWork& own : scratch.at_work) {
        for (const auto& [body, mass] : own.laden) bodies.mass[body] = mass;
        own.laden.clear();
    }
}

} // namespace cairn
