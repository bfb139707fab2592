#include "bodies/fluids.h"

#include "bodies/integrators.h"
#include "bodies/wetted.h"
#include "state/substeps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace cairn {

using math::dot;
using math::DVec3;

namespace {

DVec3 of_public(const Vec3& v) { return {v.x, v.y, v.z}; }

// Solves six linear equations by Gaussian elimination with partial pivoting.
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

// The total effect of all fluids on a body.
struct Effect {
    DVec3 force, torque;
    Coupling resistance; // kg: force per change of velocity in the step, times the step
    Moments moved;       // kg: the added mass
    bool any = false;
};

// Predicts the velocity change in the step due to all forces except contacts and joints, and derives the impulse of the
// fluids from it. `mass`: `own` plus the added mass.
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
    // Gravity and fields would accelerate the added mass, too, but it has no weight: this is compensated.
    const DVec3 weight = (double(mass.mass) - double(own.mass)) *
                         field_acceleration(c.fields, c.settings, motion.x, c.bodies.settings[body].gravity_scale, 0);
    const DVec3 force = effect.force - (1 / dt) * DVec3{resisted[0], resisted[1], resisted[2]} -
                        (own.inverse_mass > 0 ? weight : DVec3{}),
                torque = effect.torque - (1 / dt) * DVec3{resisted[3], resisted[4], resisted[5]};
    if (!math::is_finite(force) || !math::is_finite(torque)) return;
    forces.force += force, forces.torque += torque;
    forces.any |= pushed_by_fluid;
    c.bodies.mass[body] = mass;
    // A body without contacts and joints is not at rest if this acceleration would bring it above the sleep speed
    // within the sleep time, as with a ship at the moment when its roll reverses.
    BodyLinks& links = c.bodies.links[body];
    const double speed = math::length(DVec3{change[0], change[1], change[2]}) +
                         math::length(DVec3{change[3], change[4], change[5]}) * double(links.radius);
    if (links.contact_count == 0 && links.joint_count == 0 && links.quiet_time != sleep_requested &&
        speed * double(c.settings.sleep_time) > dt * double(c.settings.sleep_speed))
        links.quiet_time = 0;
}

// The body's mass plus the added mass. The principal axes stay: products of inertia of the added mass in them are
// neglected.
BodyMass laden(const BodyMass& own, const math::DQuat& q, const Effect& effect) {
    BodyMass mass = own;
    if (!(effect.moved.sum > 0)) return mass;
    if (own.inverse_mass > 0) mass.mass += float(effect.moved.sum), mass.inverse_mass = 1 / mass.mass;
    const math::DMat3 axes = math::to_matrix(q * math::to_double(own.principal));
    const math::DSym3 inertia = effect.moved.inertia();
    for (int i = 0; i < 3; ++i) {
        if (!(own.inverse_inertia[i] > 0)) continue;
        const DVec3 axis = axes.column(i);
        mass.inertia[i] += float(std::max(dot(axis, inertia * axis), 0.0));
        mass.inverse_inertia[i] = 1 / mass.inertia[i];
    }
    const math::Vec3 i = mass.inertia;
    mass.isotropic = own.isotropic && i.x == i.y && i.y == i.z;
    return mass;
}

// The time in the step, as a share of it, at which a single impulse would give the same displacement as a constant
// force in substeps.
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

// One body and all the fluids of a world that it is in.
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
        WettedSurface wetted(fluid);
        bool is_wet = false;
        for (std::int32_t s = c_.bodies.links[body_].first_shape; s != none; s = c_.shapes.links[s].next)
            if (!c_.shapes.traits[s].is_trigger) is_wet |= add_shape(std::uint32_t(s), fluid, surface, wetted);
        if (is_wet) take(field, fluid, wetted);
    }
    // `own` receives the body's own mass properties, as the body is given those with the added mass.
    void push(std::vector<std::pair<std::int32_t, BodyMass>>& own) const {
        if (!effect_.any) return;
        const BodyMass mass = c_.bodies.mass[body_];
        own.emplace_back(body_, mass);
        push_laden(c_, body_, mass, laden(mass, motion_.q, effect_), effect_, dt_);
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
    void take(const ForceField& field, const Surroundings& fluid, const WettedSurface& wetted) {
        const Moments& d = wetted.displaced;
        const double density = field.density, g = math::length(of_public(c_.settings.gravity)), stiff = density * g;
        effect_.any = true;
        effect_.force += wetted.force + (stiff * d.sum) * fluid.up;
        effect_.torque += wetted.torque + stiff * math::cross(d.first, fluid.up);
        effect_.resistance.add(wetted.pressed, dt_);
        effect_.resistance.add(wetted.rubbed, dt_);
        const double area = wetted.waterline.sum;
        if (stiff > 0 && area > 0 && d.sum > 0) {
            Coupling waterline;
            waterline.add(wetted.waterline, fluid.up, stiff);
            const double damped = 2 * double(field.wave_damping) * std::sqrt(d.sum / (g * area));
            const Vector6 motion = {fluid.v.x, fluid.v.y, fluid.v.z, fluid.w.x, fluid.w.y, fluid.w.z};
            Vector6 lost{};
            for (std::size_t i = 0; i < 6; ++i)
                for (std::size_t k = 0; k < 6; ++k) lost[i] -= damped * waterline(i, k) * motion[k];
            effect_.force += DVec3{lost[0], lost[1], lost[2]}, effect_.torque += DVec3{lost[3], lost[4], lost[5]};
            effect_.resistance.add(waterline, dt_ * damped + 0.25 * dt_ * dt_);
        }
        effect_.moved.add(d, density * double(field.added_mass));
    }
    // Whether a ball overlaps the fluid. At the bottom of the fluid the center of the ball decides.
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
    // Adds the wetted part of a shape; false if the shape cannot overlap the fluid.
    bool add_shape(std::uint32_t shape, const Surroundings& fluid, std::vector<SurfaceTriangle>& surface,
                   WettedSurface& wetted) {
        const Geometry& g = c_.shapes.geometry[shape];
        const DVec3 middle =
            placed(math::to_double(g.position) +
                   math::rotate(math::normalized(math::to_double(g.rotation)), math::to_double(g.middle)));
        if (g.type == ShapeType::sphere) { // at a side of the fluid the center decides
            if (!reaches(fluid, middle, double(g.size.x)) || !is_beside(fluid, middle)) return false;
            wetted.add_ball(middle, double(g.size.x));
            return true;
        }
        if (!reaches(fluid, middle, double(g.bounding_radius))) return false;
        make_solid_surface(g, c_.shapes.data[shape], surface);
        const double top = dot(fluid.up, middle) + double(g.bounding_radius);
        std::optional<double> lid;
        if (is_within(fluid, middle, double(g.bounding_radius)))
            add_whole(geometry_mass(g, c_.shapes.data[shape], 1), wetted);
        else
            lid = std::min(fluid.surface, top);
        const math::DMat3 turn = math::to_matrix(q_);
        const auto at = [&](DVec3 in_body) { return turn * (in_body - center_); };
        for (const SurfaceTriangle& t : surface) wetted.add_triangle(at(t.a), at(t.b), at(t.c), lid, is_round(g));
        return true;
    }
    // Whether a ball is completely below the surface and between the sides.
    static bool is_within(const Surroundings& fluid, DVec3 middle, double radius) {
        if (fluid.vertical >= 0 && fluid.depth_of(middle) < radius) return false;
        for (int axis = 0; axis < 3; ++axis)
            if (axis != fluid.vertical && std::fabs(middle[axis] - fluid.center[axis]) + radius > fluid.half[axis])
                return false;
        return true;
    }
    // Adds a whole shape to the displaced volume, given its mass properties for density 1 in the body's frame.
    void add_whole(const MassSum& solid, WettedSurface& wetted) const {
        const math::DSym3& i = solid.inertia;
        const double half = 0.5 * (i.xx + i.yy + i.zz);
        const math::DMat3 r = math::to_matrix(q_);
        const math::DSym3 own = {half - i.xx, -i.xy, -i.xz, half - i.yy, -i.yz, half - i.zz};
        const DVec3 x = own * DVec3{r.c0.x, r.c1.x, r.c2.x}, y = own * DVec3{r.c0.y, r.c1.y, r.c2.y},
                    z = own * DVec3{r.c0.z, r.c1.z, r.c2.z};
        const auto row = [&](int axis, DVec3 v) { return r.c0[axis] * v.x + r.c1[axis] * v.y + r.c2[axis] * v.z; };
        wetted.displaced.add(placed(solid.center), solid.mass);
        wetted.displaced.second =
            wetted.displaced.second + math::DSym3{row(0, x), row(0, y), row(0, z), row(1, y), row(1, z), row(2, z)};
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
        if (c.bodies.forces[b].any == pushed_by_fluid) c.bodies.pushed.push_back(b); // not listed yet for another force
}

void unload(Bodies& bodies, FluidScratch& scratch) {
    for (FluidScratch::AtWork& own : scratch.at_work) {
        for (const auto& [body, mass] : own.laden) bodies.mass[body] = mass;
        own.laden.clear();
    }
}

} // namespace cairn
