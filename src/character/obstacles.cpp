#include "character/obstacles.h"

#include "bodies/bodies.h"
#include "collision/one_way.h"
#include "math/rotation.h"
#include "queries/query_frame.h"
#include "shapes/convex_query.h"

#include <algorithm>
#include <limits>

namespace cairn {

using math::dot;
using math::DVec3;

namespace {

// The shape enlarged by a ball of radius `by`.
Convex padded(Convex c, double by) {
    if (c.is_sharp) {
        c.is_sharp = false;
        c.shallow = by + c.radius;
        c.radius = by;
    } else {
        c.radius += by;
        c.shallow += by;
        if (c.kind == Convex::Kind::ball || c.kind == Convex::Kind::capsule) c.size.x += by, c.size.z += by;
    }
    c.extent += by;
    return c;
}

DBounds moved(const DBounds& b, DVec3 by) { return {b.lo + by, b.hi + by}; }

// Angle, rad: a motion that leads into a surface by less than this slides past it.
constexpr double grazing = 1e-5;

double height_over(const Obstacle& plane, const Convex& shape) {
    return dot(support(shape, -plane.convex.axes.c1) - plane.convex.center, plane.convex.axes.c1);
}

// The displacement in a step of a point that moves with a body.
DVec3 carried(const BodyMotion& motion, DVec3 point, double dt) {
    const DVec3 arm = point - motion.x, turn = dt * math::to_double(motion.w);
    const DVec3 shift = dt * math::to_double(motion.v);
    if (turn == DVec3{}) return shift;
    return shift + (math::rotate(math::from_rotation_vector(turn), arm) - arm);
}

// A bound of the displacement of a body's points in a step, m.
double own_reach(const Bodies& bodies, std::int32_t b, double dt) {
    const BodyMotion& m = bodies.motion[b];
    return dt * (double(math::length(m.v)) + double(math::length(m.w)) * double(bodies.links[b].radius));
}

} // namespace

Surroundings::Surroundings(const CharacterInput& input, std::size_t index, double reach, CharacterScratch& scratch)
    : input_(input), self_(input.characters.all[index]), index_(index), scratch_(scratch),
      origin_(input.bodies.motion[self_.body].x) {
    gather_parts(self_.body, double(self_.skin));
    if (has_shape()) gather(self_.body, reach);
}

double Surroundings::lowest(DVec3 up) const {
    double least = 0;
    for (const CharacterPart& part : scratch_.parts) least = std::min(least, dot(support(part.sharp, -up), up));
    return least;
}

void Surroundings::gather_parts(std::int32_t body, double skin) {
    scratch_.parts.clear();
    const Shapes& shapes = input_.shapes;
    for (std::int32_t s = input_.bodies.links[body].first_shape; s != none; s = shapes.links[s].next) {
        const auto shape = std::uint32_t(s);
        if (is_surface(shapes.geometry[shape].type) || shapes.traits[shape].is_trigger) continue;
        const QuerySolid solid(PosedInQuery(shapes, shape, origin_));
        scratch_.parts.push_back({solid.convex, padded(solid.convex, skin), solid.bounds, shape});
        size_ = std::max(size_, math::length(solid.bounds.hi - solid.bounds.lo));
    }
}

void Surroundings::gather(std::int32_t body, double reach) {
    double fastest = 0;
    for (const std::int32_t b : input_.bodies.kinematics)
        if (b != body) fastest = std::max(fastest, own_reach(input_.bodies, b, input_.dt));
    DBounds near = scratch_.parts[0].bounds;
    for (const CharacterPart& part : scratch_.parts)
        near = {math::min(near.lo, part.bounds.lo), math::max(near.hi, part.bounds.hi)};
    near = grown(near, reach + fastest);
    scratch_.found.clear();
    scratch_.obstacles.clear();
    input_.broad_phase.query_bounds(moved(near, origin_),
                                    [&](std::uint32_t shape) { scratch_.found.push_back(shape); });
    std::sort(scratch_.found.begin(), scratch_.found.end());
    for (const std::uint32_t shape : scratch_.found) {
        const ShapeTraits& traits = input_.shapes.traits[shape];
        if (traits.is_trigger || input_.shapes.links[shape].body == body) continue;
        const bool is_met = std::any_of(scratch_.parts.begin(), scratch_.parts.end(), [&](const CharacterPart& part) {
            return may_meet(input_.shapes.traits[part.shape].filter, traits.filter);
        });
        if (is_met) add_shape(shape, near);
    }
}

void Surroundings::add_shape(std::uint32_t shape, const DBounds& near) {
    const Bodies& bodies = input_.bodies;
    PosedInQuery posed(input_.shapes, shape, origin_);
    Obstacle o;
    o.body = input_.shapes.links[shape].body, o.shape = shape, o.type = bodies.settings[o.body].type;
    // Characters move one after another: those that have moved already stand where they will be after the step, the
    // others where they are now.
    const auto& all = input_.characters.all;
    const auto other = std::find_if(all.begin(), all.end(), [&](const Character& c) { return c.body == o.body; });
    if (other != all.end()) {
        o.ride = within_numbers(input_.dt * math::to_double(bodies.motion[o.body].v));
        if (std::size_t(other - all.begin()) < index_) posed.center += o.ride;
    }
    const bool moves = other == all.end() && o.type != BodyType::static_;
    if (const ShapeTraits& traits = input_.shapes.traits[shape]; traits.has_surface_velocity)
        o.belt = within_numbers(input_.dt * math::rotate(posed.rotation, math::to_double(traits.surface_velocity)));
    if (const ShapeTraits& traits = input_.shapes.traits[shape]; traits.is_one_way) {
        const DVec3 direction = math::rotate(posed.rotation, math::to_double(traits.one_way));
        const Convex other = posed.convex(middle(scratch_.parts[0].sharp), math::length(near.hi - near.lo));
        for (const CharacterPart& part : scratch_.parts)
            if (!is_beyond(part.sharp, other, direction)) return; // the character passes through it
    }
    const auto push = [&] {
        scratch_.obstacles.push_back(o);
        if (moves) set_motion(scratch_.obstacles.size() - 1);
    };
    switch (posed.geometry.type) {
    case ShapeType::plane: {
        o.is_plane = true;
        o.convex.center = posed.center;
        o.convex.axes.c1 = posed.up();
        if (posed.geometry.is_double_sided && dot(o.convex.axes.c1, middle(scratch_.parts[0].sharp) - posed.center) < 0)
            o.convex.axes.c1 = -o.convex.axes.c1;
        push();
        return;
    }
    case ShapeType::mesh:
    case ShapeType::height_field:
        o.is_one_sided = true;
        for_each_triangle_near(posed, near.lo, near.hi, [&](const Convex& triangle, std::uint32_t) {
            o.convex = triangle;
            o.bounds = {triangle.corners[0], triangle.corners[0]};
            for (int i = 1; i < 3; ++i)
                o.bounds = {math::min(o.bounds.lo, triangle.corners[i]), math::max(o.bounds.hi, triangle.corners[i])};
            push();
        });
        return;
    default:
        o.is_one_sided = posed.geometry.type == ShapeType::rectangle && !posed.geometry.is_double_sided;
        o.convex = posed.convex(middle(scratch_.parts[0].sharp), math::length(near.hi - near.lo));
        o.bounds =
            geometry_bounds(posed.geometry, posed.data, posed.center, math::to_matrix(math::to_float(posed.rotation)));
        push();
    }
}

// Sets an obstacle's motion to that of its point nearest to the character, as the points of a rotating body move
// differently.
void Surroundings::set_motion(std::size_t obstacle) {
    Obstacle& o = scratch_.obstacles[obstacle];
    const BodyMotion& motion = input_.bodies.motion[o.body];
    DVec3 nearest;
    if (!(motion.w == math::Vec3{}))
        if (const auto found = gap(obstacle, {}, 0, std::numeric_limits<double>::infinity())) nearest = found->point;
    o.carry = o.ride = within_numbers(carried(motion, origin_ + nearest, input_.dt));
}

std::optional<CharacterGap> Surroundings::gap(std::size_t obstacle, DVec3 at, double time, double most) const {
    const Obstacle& o = scratch_.obstacles[obstacle];
    const DVec3 shift = at - time * o.carry;
    std::optional<CharacterGap> best;
    for (const CharacterPart& part : scratch_.parts) {
        if (o.is_plane) {
            const Convex shape = moved(part.sharp, shift);
            const double height = height_over(o, shape);
            if (height <= most && (!best || height < best->distance))
                best = CharacterGap{height, o.convex.axes.c1, support(shape, -o.convex.axes.c1) + time * o.carry};
            continue;
        }
        if (!meet(grown(moved(part.bounds, shift), most), o.bounds)) continue;
        const Convex shape = moved(part.sharp, shift);
        const DVec3 front = o.convex.axes.c1;
        if (o.is_one_sided && dot(middle(shape) - o.convex.corners[0], front) < 0) continue;
        const ClosestPoints c = closest_points(shape, o.convex);
        if (!(c.distance <= most) || (best && !(c.distance < best->distance))) continue;
        best = CharacterGap{c.distance, -c.normal, c.on_b + time * o.carry};
        if (!o.is_one_sided || dot(best->normal, front) > 0) continue;
        if (c.distance > 0) {
            best.reset();
        } else { // the character has sunk in: push it out along the front
            best->normal = front;
            best->distance = dot(support(shape, -front) - o.convex.corners[0], front);
        }
    }
    return best;
}

std::optional<CharacterHit> Surroundings::cast_at(const CharacterPart& part, std::size_t obstacle, DVec3 at,
                                                  double time, DVec3 way, double duration, double limit) const {
    const Obstacle& o = scratch_.obstacles[obstacle];
    const DVec3 shift = at - time * o.carry, relative = way - duration * o.carry;
    const double length = math::length(relative);
    if (!(length > 0)) return std::nullopt;
    const auto hit_at = [&](double fraction, DVec3 normal, DVec3 point) {
        return CharacterHit{fraction, normal, point + (time + fraction * duration) * o.carry, obstacle};
    };
    if (o.is_plane) {
        const DVec3 up = o.convex.axes.c1;
        const Convex shape = moved(part.padded, shift);
        const double height = height_over(o, shape), fall = -dot(relative, up);
        if (!(fall > grazing * length) || height > limit * fall) return std::nullopt;
        const double fraction = height > 0 ? height / fall : 0;
        return hit_at(fraction, up, support(shape, -up) + fraction * relative - double(self_.skin) * up);
    }
    if (o.is_one_sided && !(dot(relative, o.convex.axes.c1) < 0)) return std::nullopt;
    const DBounds start = grown(moved(part.bounds, shift), double(self_.skin));
    const DBounds way_bounds{math::min(start.lo, start.lo + relative), math::max(start.hi, start.hi + relative)};
    if (!meet(way_bounds, o.bounds)) return std::nullopt;
    const auto hit = cast_convex(moved(part.padded, shift), relative, o.convex, limit);
    if (!hit) return std::nullopt;
    if (hit->fraction > 0) return hit_at(hit->fraction, hit->normal, hit->point);
    // The shapes are within the skin already. Convex shapes that separate do not meet again on a straight path.
    const auto near = gap(obstacle, at, time, 2 * double(self_.skin));
    if (!near || !(dot(relative, near->normal) < -grazing * length)) return std::nullopt;
    return CharacterHit{0, near->normal, near->point, obstacle};
}

std::optional<CharacterHit> Surroundings::cast(DVec3 at, double time, DVec3 way, double duration) const {
    std::optional<CharacterHit> best;
    for (std::size_t i = 0; i < scratch_.obstacles.size(); ++i)
        for (const CharacterPart& part : scratch_.parts) {
            const auto hit = cast_at(part, i, at, time, way, duration, best ? best->fraction : 1);
            if (hit && (!best || hit->fraction < best->fraction)) best = hit;
        }
    return best;
}

std::optional<DVec3> Surroundings::face_at(const CharacterHit& hit, double time, DVec3 up) const {
    const double tolerance = 1e-3 * size_;
    const Obstacle& met = scratch_.obstacles[hit.obstacle];
    std::optional<DVec3> best;
    const auto consider = [&](DVec3 normal) {
        if (!best || dot(normal, up) > dot(*best, up)) best = normal;
    };
    if (met.is_plane) return met.convex.axes.c1;
    const DVec3 point = hit.point - time * met.carry;
    for (const Obstacle& o : scratch_.obstacles) {
        if (o.shape != met.shape || o.is_plane) continue;
        if (o.convex.kind == Convex::Kind::polygon) {
            if (!nearest_point(o.convex, point, tolerance)) continue;
            consider(o.is_one_sided || dot(o.convex.axes.c1, up) > 0 ? o.convex.axes.c1 : -o.convex.axes.c1);
            continue;
        }
        const double around = outer_radius(o.convex);
        for (int f = 0; f < face_count(o.convex); ++f) {
            if (!has_face(o.convex, f)) continue;
            const DVec3 normal = face_normal(o.convex, f);
            const double height = dot(point - face_point(o.convex, f), normal) - around;
            if (std::fabs(height) < tolerance) consider(normal);
        }
    }
    return best;
}

void Surroundings::stop_approach(std::int32_t body, DVec3 normal) {
    for (Obstacle& o : scratch_.obstacles)
        if (o.body == body) o.carry -= std::max(0.0, dot(o.carry, normal)) * normal;
}

} // namespace cairn
