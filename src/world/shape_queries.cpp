// Shape casts, closest points and shape overlaps.
#include "queries/query_frame.h"
#include "shapes/convex_query.h"
#include "world/impl.h"
#include "world/sight.h"
#include "world/validate.h"

#include <algorithm>
#include <array>

namespace cairn {

using math::DVec3;

namespace {

// A shape cast: finds the first hit of a convex shape that starts at the query's origin.
class ShapeCast {
  public:
    ShapeCast(const Shapes& shapes, DVec3 origin, const QuerySolid& moving, DVec3 translation)
        : shapes_(shapes), origin_(origin), moving_(moving), center_(middle(moving.convex)), translation_(translation),
          square_(math::dot(translation, translation)), half_way_(center_ + 0.5 * translation),
          reach_(math::length(moving.bounds.hi - moving.bounds.lo) + std::sqrt(square_)) {}

    // The hit on a shape at a fraction of the translation up to `limit`, if any.
    std::optional<ConvexHit> against(std::uint32_t shape, double limit) const {
        const PosedInQuery still(shapes_, shape, origin_);
        switch (still.geometry.type) {
        case ShapeType::plane: {
            const DVec3 up = still.up();
            const bool is_behind = still.geometry.is_double_sided && math::dot(up, center_ - still.center) < 0;
            return against_plane(is_behind ? -up : up, still.center);
        }
        case ShapeType::rectangle:
            if (!still.geometry.is_double_sided && !(math::dot(translation_, still.up()) < 0)) return std::nullopt;
            break;
        case ShapeType::mesh:
        case ShapeType::height_field:
            return against_triangles(still, limit);
        default:
            break;
        }
        if (still.geometry.type == ShapeType::rectangle)
            return cast_convex(moving_.convex, translation_, convex(still), limit);
        const auto start = where_balls_meet(still, limit);
        if (!start) return std::nullopt;
        return cast_convex(moving_.convex, translation_, convex(still), limit, *start);
    }
    // The hit on a convex shape that overlaps the moving shape at the start.
    ConvexHit from_within(std::uint32_t shape) const {
        return overlap_hit(moving_.convex, convex(PosedInQuery(shapes_, shape, origin_)));
    }

  private:
    Convex convex(const PosedInQuery& still) const { return still.convex(half_way_, reach_); }

    // The first time at which the bounding spheres of both shapes touch, if they do.
    std::optional<Approach> where_balls_meet(const PosedInQuery& still, double limit) const {
        constexpr double rounding = 1e-5; // relative error of the radii, which are floats
        const DVec3 to = still.middle() - center_;
        const double radii = moving_.radius + double(still.geometry.bounding_radius),
                     square = radii * radii * (1 + rounding);
        if (math::dot(to, to) <= square) return Approach{to}; // spheres that overlap at the start
        const double along = math::dot(to, translation_);
        if (!(along > 0)) return std::nullopt;
        const DVec3 off = to - (along / square_) * translation_; // at closest approach
        const double inside = square - math::dot(off, off);
        if (!(inside >= 0)) return std::nullopt;
        const double at = along / square_ - std::sqrt(inside / square_);
        if (at > limit) return std::nullopt;
        return Approach{to - at * translation_, std::max(at, 0.0)};
    }
    // The interval of the translation, in fractions up to `limit`, in which the bounding boxes overlap.
    std::optional<std::array<double, 2>> where_bounds_meet(const DBounds& still, double limit) const {
        double first = 0, last = limit;
        for (int i = 0; i < 3; ++i) {
            const double enter = still.lo[i] - moving_.bounds.hi[i], leave = still.hi[i] - moving_.bounds.lo[i];
            const double way = translation_[i];
            if (way == 0) {
                if (enter > 0 || leave < 0) return std::nullopt;
                continue;
            }
            first = std::max(first, std::min(enter / way, leave / way));
            last = std::min(last, std::max(enter / way, leave / way));
        }
        constexpr double rounding = 1e-12;
        if (!(first <= last + rounding)) return std::nullopt;
        return std::array{std::max(first - rounding, 0.0), std::min(last + rounding, limit)};
    }
    // The translation is split into pieces of about the size of the moving shape, so that each is tested against few
    // triangles.
    std::optional<ConvexHit> against_triangles(const PosedInQuery& still, double limit) const {
        constexpr double most_pieces = 256;
        const auto part = where_bounds_meet(
            geometry_bounds(still.geometry, still.data, still.center, math::to_matrix(math::to_float(still.rotation))),
            limit);
        if (!part) return std::nullopt;
        const auto [first, last] = *part;
        const double length = (last - first) * std::sqrt(square_);
        const double size = math::length(moving_.bounds.hi - moving_.bounds.lo);
        const double pieces = length > size * most_pieces ? most_pieces : std::floor(length / size) + 1;
        std::optional<ConvexHit> best;
        Convex met;
        for (int piece = 0; piece < int(pieces); ++piece) {
            const double from = first + (last - first) * (piece / pieces);
            const double to = first + (last - first) * ((piece + 1) / pieces);
            if (best && best->fraction < from) break;
            const DVec3 start = from * translation_, end = to * translation_;
            const DVec3 lo = moving_.bounds.lo + math::min(start, end), hi = moving_.bounds.hi + math::max(start, end);
            for_each_triangle_near(still, lo, hi, [&](const Convex& triangle, std::uint32_t index) {
                if (!(math::dot(translation_, triangle.axes.c1) < 0)) return;
                const auto hit = cast_convex(moving_.convex, translation_, triangle, best ? best->fraction : limit);
                if (!hit || (best && !(hit->fraction < best->fraction))) return;
                best = hit, met = triangle;
                best->triangle = index;
            });
        }
        if (best && best->normal == DVec3{}) {
            const std::uint32_t index = best->triangle;
            best = overlap_hit(moving_.convex, met);
            best->triangle = index;
        }
        return best;
    }
    std::optional<ConvexHit> against_plane(DVec3 up, DVec3 origin) const {
        const DVec3 lowest = support(moving_.convex, -up);
        const double height = math::dot(lowest - origin, up), fall = -math::dot(translation_, up);
        if (height > 0 && !(fall >= height)) return std::nullopt;
        if (height == 0 && !(fall > 0)) return std::nullopt;
        const double fraction = height > 0 ? height / fall : 0;
        return ConvexHit{fraction, lowest + fraction * translation_, up};
    }

    const Shapes& shapes_;
    DVec3 origin_;
    const QuerySolid& moving_;
    DVec3 center_; // of the bounding sphere of the moving shape
    DVec3 translation_;
    double square_;
    DVec3 half_way_; // middle of the swept region; everything that the cast may hit lies within reach_ of it
    double reach_;
};

// The point of a shape nearest to the query's origin, within a distance of `most`.
std::optional<NearPoint> nearest_of(const PosedInQuery& shape, double most) {
    if (shape.geometry.type == ShapeType::plane) {
        const DVec3 up = shape.up();
        const double height = -math::dot(shape.center, up);
        const bool is_outside = height > 0 || shape.geometry.is_double_sided;
        const NearPoint nearest = is_outside ? NearPoint{-height * up, std::fabs(height)} : NearPoint{{}, 0};
        return nearest.distance <= most ? std::optional(nearest) : std::nullopt;
    }
    if (shape.geometry.type < ShapeType::mesh) return nearest_point(shape.convex({}, 0), {}, most);
    // Searches within a radius that doubles each time, so that few triangles are tested. It starts at the distance to
    // the bounds of the whole surface plus about the size of one triangle.
    const bool is_mesh = shape.geometry.type == ShapeType::mesh;
    const double count = is_mesh ? triangle_count(mesh_of(shape.data)) : triangle_count(height_field_of(shape.data));
    const DBounds bounds =
        geometry_bounds(shape.geometry, shape.data, shape.center, math::to_matrix(math::to_float(shape.rotation)));
    const double outside = math::length(math::max(math::max(bounds.lo, -bounds.hi), {}));
    if (outside > most) return std::nullopt;
    std::optional<NearPoint> best;
    for (double reach = outside + double(shape.geometry.bounding_radius) / std::sqrt(count);; reach *= 2) {
        reach = std::min(reach, most);
        const DVec3 around{reach, reach, reach};
        for_each_triangle_near(shape, -around, around, [&](const Convex& triangle, std::uint32_t index) {
            const auto nearest = nearest_point(triangle, {}, best ? best->distance : most);
            if (!nearest || (best && !(nearest->distance < best->distance))) return;
            best = nearest;
            best->triangle = index;
        });
        if (reach == most || (best && best->distance <= reach)) return best;
    }
}

// Whether a convex shape overlaps another shape.
bool meets(const QuerySolid& asking, const PosedInQuery& other) {
    switch (other.geometry.type) {
    case ShapeType::plane: {
        const DVec3 up = other.up();
        if (math::dot(support(asking.convex, -up) - other.center, up) > 0) return false;
        return !other.geometry.is_double_sided || math::dot(support(asking.convex, up) - other.center, up) >= 0;
    }
    case ShapeType::mesh:
    case ShapeType::height_field: {
        bool found = false;
        for_each_triangle_near(other, asking.bounds.lo, asking.bounds.hi, [&](const Convex& triangle, std::uint32_t) {
            found = found || cairn::overlap(asking.convex, triangle);
        });
        return found;
    }
    default: {
        const double radii = asking.radius + double(other.geometry.bounding_radius);
        const DVec3 to = other.middle() - middle(asking.convex);
        constexpr double rounding = 1e-5; // relative error of the radii, which are floats
        const bool is_far = math::dot(to, to) > radii * radii * (1 + rounding);
        if (is_far && other.geometry.type != ShapeType::rectangle) return false;
        return cairn::overlap(asking.convex,
                              other.convex(middle(asking.convex), math::length(asking.bounds.hi - asking.bounds.lo)));
    }
    }
}

} // namespace

std::optional<ShapeCastHit> World::cast_shape(const Shape& shape, const Transform& start, const Vec3& translation,
                                              const QueryFilter& filter) const {
    validate(shape);
    require_position("World::cast_shape start.position", start.position);
    const Quat rotation = checked_rotation("World::cast_shape start.rotation", start.rotation);
    require_finite("World::cast_shape translation", translation);
    const Geometry g = make_geometry(shape, {Position(0.0), rotation});
    if (is_surface(g.type)) refuse("World::cast_shape shape", shape_name(shape), "must be a convex shape");
    const ShapeData data = make_shape_data(shape);
    const DVec3 origin = to_math(start.position), way = math::to_double(to_math(translation));
    const QuerySolid moving(PosedInQuery(g, data, {}, g.rotation));
    const State& s = impl_->for_queries(filter, "World::cast_shape");
    const ShapeCast cast(s.shapes, origin, moving, way);
    const QueryVisibility sight(s, filter);
    std::optional<ConvexHit> best;
    std::uint32_t met = 0;
    s.broad_phase.query_sweep(
        {origin + moving.bounds.lo, origin + moving.bounds.hi}, way, [&](std::uint32_t other, double limit) {
            // Of two hits at the same fraction, the shape with the lower index wins, whatever the order of the tests.
            if (!sight.sees(other) || (limit == 0 && best && other > met)) return limit;
            const auto hit = cast.against(other, limit);
            if (!hit || (best && (hit->fraction > best->fraction || (hit->fraction == best->fraction && other > met))))
                return limit;
            best = hit;
            met = other;
            return sight.any() ? -1 : hit->fraction;
        });
    if (!best) return std::nullopt;
    if (best->normal == DVec3{}) best = cast.from_within(met);
    return ShapeCastHit{s.shapes.slots.id(met),          s.bodies.id(s.shapes.links[met].body),   best->fraction,
                        to_public(origin + best->point), to_public(math::to_float(best->normal)), int(best->triangle)};
}

std::optional<ClosestPoint> World::closest_point(const Position& point, double max_distance,
                                                 const QueryFilter& filter) const {
    require_position("World::closest_point point", point);
    if (!(max_distance >= 0)) refuse("World::closest_point max_distance", to_text(max_distance), "must be >= 0");
    const double most = std::min(max_distance, 1e15); // the range of positions, m
    const DVec3 origin = to_math(point);
    const State& s = impl_->for_queries(filter, "World::closest_point");
    const QueryVisibility sight(s, filter);
    std::optional<NearPoint> best;
    std::uint32_t nearest = 0;
    s.broad_phase.query_near(origin, most, [&](std::uint32_t other, double limit) {
        if (!sight.sees(other)) return limit;
        const auto found = nearest_of(PosedInQuery(s.shapes, other, origin), limit);
        if (!found || (best && found->distance == best->distance && other > nearest)) return limit;
        best = found;
        nearest = other;
        return sight.any() ? -1 : found->distance;
    });
    if (!best) return std::nullopt;
    return ClosestPoint{s.shapes.slots.id(nearest), s.bodies.id(s.shapes.links[nearest].body),
                        to_public(origin + best->point), best->distance, int(best->triangle)};
}

std::vector<ShapeId> World::overlap(const Shape& shape, const Transform& pose, const QueryFilter& filter) const {
    validate(shape);
    require_position("World::overlap pose.position", pose.position);
    const Quat rotation = checked_rotation("World::overlap pose.rotation", pose.rotation);
    const Geometry g = make_geometry(shape, {Position(0.0), rotation});
    const ShapeData data = make_shape_data(shape);
    const DVec3 origin = to_math(pose.position);
    const DBounds bounds = geometry_bounds(g, data, origin, math::to_matrix(g.rotation));
    const PosedInQuery asking(g, data, {}, g.rotation);
    std::optional<QuerySolid> solid;
    if (!is_surface(g.type)) solid.emplace(asking);
    const State& s = impl_->for_queries(filter, "World::overlap");
    const QueryVisibility sight(s, filter);
    std::vector<ShapeId> found;
    s.broad_phase.query_bounds(bounds, [&](std::uint32_t other) {
        if (!sight.sees(other) || (sight.any() && !found.empty())) return;
        const PosedInQuery posed(s.shapes, other, origin);
        const bool is_met = solid                             ? meets(*solid, posed)
                            : is_surface(posed.geometry.type) ? false
                                                              : meets(QuerySolid(posed), asking);
        if (is_met) found.push_back(s.shapes.slots.id(other));
    });
    std::sort(found.begin(), found.end(), [](ShapeId a, ShapeId b) { return a.index() < b.index(); });
    return found;
}

} // namespace cairn
