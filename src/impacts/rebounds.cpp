#include "impacts/rebounds.h"

#include <algorithm>
#include <cmath>

namespace cairn {

using math::cross;
using math::dot;
using math::DVec3;

namespace {

DVec3 turn_of(const TouchingBody& body) { return body.is_round ? DVec3{} : body.now.w; }
DVec3 velocity_at(const TouchingBody& body, DVec3 point) {
    return body.now.v + cross(turn_of(body), point - body.now.x);
}

// A ball's center is where it is held, wherever its surface touches.
DVec3 held_point(const TouchingBody& a, const TouchingBody& b, DVec3 point) {
    return a.is_round ? a.now.x : b.is_round ? b.now.x : point;
}

} // namespace

double closing_acceleration(const TouchingBody& a, const TouchingBody& b, DVec3 point, DVec3 normal) {
    if (a.is_round && b.is_round) return 0; // they part on straight ways
    const DVec3 held = held_point(a, b, point), slip = velocity_at(b, held) - velocity_at(a, held);
    const auto drawn = [&](const TouchingBody& body) {
        const DVec3 w = turn_of(body);
        return cross(w, cross(w, held - body.now.x));
    };
    const auto followed = [&](const TouchingBody& body) { return 2 * dot(normal, cross(body.now.w, slip)); };
    const double faces = a.is_round ? followed(b) : b.is_round ? followed(a) : std::max(followed(a), followed(b));
    return dot(drawn(a) - drawn(b), normal) + faces;
}

void set_rebounds(const Movers& movers, const Shapes& shapes, const SweptPair& pair, const MovingState& now_a,
                  const MovingState& now_b, std::span<ImpactPoint> points) {
    const auto is_round = [&](std::uint32_t shape) {
        return shapes.geometry[shape].type == ShapeType::sphere && movers.is_round(shapes.links[shape].body);
    };
    const TouchingBody a{now_a, is_round(pair.shape)}, b{now_b, is_round(pair.other)};
    const bool has_second = pair.second != none;
    const bool gyrates = movers[pair.first].gyrates || (has_second && movers[pair.second].gyrates);
    for (ImpactPoint& point : points) {
        DVec3 force = movers.acceleration_of(pair.first, now_a, point.position);
        if (has_second) force -= movers.acceleration_of(pair.second, now_b, point.position);
        const DVec3 n = point.normal;
        const double depth = std::max(point.depth, 0.0), press = dot(force, n);
        const auto speed_from = [&](double acceleration) { return std::sqrt(2 * std::max(acceleration, 0.0) * depth); };
        const DVec3 held = held_point(a, b, point.position);
        const double approach = std::max(dot(velocity_at(a, held) - velocity_at(b, held), n), 0.0);
        point.rebound = std::min(speed_from(press + closing_acceleration(a, b, point.position, n)), approach);
        if (gyrates) point.rebound = std::max(point.rebound, speed_from(press));
    }
}

} // namespace cairn
