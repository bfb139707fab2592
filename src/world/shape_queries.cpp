// Shape casts, closest points and overlaps.
#include "shapes/convex_query.h"
#include "world/impl.h"
#include "world/query_frame.h"
#include "world/validate.h"

#include <algorithm>

namespace cairn {

using math::DVec3;

namespace {

// The first hit of a shape that starts at the query's origin.
class ShapeCast {
  public:
    ShapeCast(const QuerySolid& moving, double bounding_radius, DVec3 translation)
        : moving_(moving), center_(middle(moving.convex)), radius_(bounding_radius), translation_(translation),
          square_(math::dot(translation, translation)) {}

    // Up to a fraction of the translation.
    std::optional<ConvexHit> against(const PosedInQuery& still, double limit) const {
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
            if (passes_by(still, limit)) return std::nullopt;
            break;
        }
        return cast_convex(moving_.convex, translation_, still.convex(center_ + 0.5 * translation_, length()), limit);
    }

  private:
    double length() const { return math::length(moving_.hi - moving_.lo) + std::sqrt(square_); }

    // Whether the balls around both do not meet.
    bool passes_by(const PosedInQuery& still, double limit) const {
        constexpr double rounding = 1e-5; // of their radii, which are floats
        const DVec3 to = still.middle() - center_;
        const double radii = radius_ + double(still.geometry.bounding_radius);
        const double along = math::dot(to, translation_);
        const double at = !(along > 0) ? 0 : along < limit * square_ ? along / square_ : limit;
        const DVec3 off = to - at * translation_;
        return math::dot(off, off) > radii * radii * (1 + rounding);
    }
    std::optional<ConvexHit> against_triangles(const PosedInQuery& still, double limit) const {
        std::optional<ConvexHit> best;
        const DVec3 lo = math::min(moving_.lo, moving_.lo + limit * translation_);
        const DVec3 hi = math::max(moving_.hi, moving_.hi + limit * translation_);
        for_each_triangle_near(still, lo, hi, [&](const Convex& triangle) {
            if (!(math::dot(translation_, triangle.axes.c1) < 0)) return;
            const auto hit = cast_convex(moving_.convex, translation_, triangle, best ? best->fraction : limit);
            if (hit && (!best || hit->fraction < best->fraction)) best = hit;
        });
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

    const QuerySolid& moving_;
    DVec3 center_; // of a ball around it
    double radius_;
    DVec3 translation_;
    double square_;
};

// The point of a shape nearest to the query's origin, up to a distance.
std::optional<NearPoint> nearest_of(const PosedInQuery& shape, double most) {
    if (shape.geometry.type == ShapeType::plane) {
        const DVec3 up = shape.up();
        const double height = -math::dot(shape.center, up);
        const bool is_outside = height > 0 || shape.geometry.is_double_sided;
        const NearPoint nearest = is_outside ? NearPoint{-height * up, std::fabs(height)} : NearPoint{{}, 0};
        return nearest.distance <= most ? std::optional(nearest) : std::nullopt;
    }
    if (shape.geometry.type < ShapeType::mesh) return nearest_point(shape.convex({}, 0), {}, most);
    std::optional<NearPoint> best;
    const DVec3 reach{most, most, most};
    for_each_triangle_near(shape, -reach, reach, [&](const Convex& triangle) {
        const auto nearest = nearest_point(triangle, {}, best ? best->distance : most);
        if (nearest && (!best || nearest->distance < best->distance)) best = nearest;
    });
    return best;
}

// Whether a convex shape has a point in common with another shape.
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
        for_each_triangle_near(other, asking.lo, asking.hi, [&](const Convex& triangle) {
            found = found || cairn::overlap(asking.convex, triangle);
        });
        return found;
    }
    default:
        return cairn::overlap(asking.convex, other.convex(middle(asking.convex), math::length(asking.hi - asking.lo)));
    }
}

} // namespace

std::optional<ShapeCastHit> World::cast_shape(const Shape& shape, const Transform& start, const Vec3& translation,
                                              std::uint64_t layers) const {
    validate(shape);
    require_position("World::cast_shape start.position", start.position);
    const Quat rotation = checked_rotation("World::cast_shape start.rotation", start.rotation);
    require_finite("World::cast_shape translation", translation);
    const Geometry g = make_geometry(shape, {Position(0.0), rotation});
    if (is_surface(g.type)) refuse("World::cast_shape shape", shape_name(shape), "must be a convex shape");
    const ShapeData data = make_shape_data(shape);
    const DVec3 origin = to_math(start.position), way = math::to_double(to_math(translation));
    const QuerySolid moving(PosedInQuery(g, data, {}, g.rotation).convex({}, 0));
    const ShapeCast cast(moving, double(g.bounding_radius), way);
    const State& s = impl_->whole("World::cast_shape");
    std::optional<ConvexHit> best;
    std::uint32_t met = 0;
    s.broad_phase.query_sweep({origin + moving.lo, origin + moving.hi}, way, [&](std::uint32_t other, double limit) {
        // Of two at the same fraction the one with the lower index counts, in whatever order they come.
        if (!is_seen(s, other, layers) || (limit == 0 && best && other > met)) return limit;
        const auto hit = cast.against(PosedInQuery(s, other, origin), limit);
        if (!hit || (best && (hit->fraction > best->fraction || (hit->fraction == best->fraction && other > met))))
            return limit;
        best = hit;
        met = other;
        return hit->fraction;
    });
    if (!best) return std::nullopt;
    return ShapeCastHit{s.shape_id(met), s.body_id(s.shapes[met].body), best->fraction, to_public(origin + best->point),
                        to_public(math::to_float(best->normal))};
}

std::optional<ClosestPoint> World::closest_point(const Position& point, double max_distance,
                                                 std::uint64_t layers) const {
    require_position("World::closest_point point", point);
    if (!(max_distance >= 0)) refuse("World::closest_point max_distance", to_text(max_distance), "must be >= 0");
    const double most = std::min(max_distance, 1e15); // as far as positions reach
    const DVec3 origin = to_math(point);
    const State& s = impl_->whole("World::closest_point");
    std::optional<NearPoint> best;
    std::uint32_t nearest = 0;
    s.broad_phase.query_near(origin, most, [&](std::uint32_t other, double limit) {
        if (!is_seen(s, other, layers)) return limit;
        const auto found = nearest_of(PosedInQuery(s, other, origin), limit);
        if (!found || (best && found->distance == best->distance && other > nearest)) return limit;
        best = found;
        nearest = other;
        return found->distance;
    });
    if (!best) return std::nullopt;
    return ClosestPoint{s.shape_id(nearest), s.body_id(s.shapes[nearest].body), to_public(origin + best->point),
                        best->distance};
}

std::vector<ShapeId> World::overlap(const Shape& shape, const Transform& pose, std::uint64_t layers) const {
    validate(shape);
    require_position("World::overlap pose.position", pose.position);
    const Quat rotation = checked_rotation("World::overlap pose.rotation", pose.rotation);
    const Geometry g = make_geometry(shape, {Position(0.0), rotation});
    const ShapeData data = make_shape_data(shape);
    const DVec3 origin = to_math(pose.position);
    const DBounds bounds = geometry_bounds(g, data, origin, math::to_matrix(g.rotation));
    const PosedInQuery asking(g, data, {}, g.rotation);
    std::optional<QuerySolid> solid;
    if (!is_surface(g.type)) solid.emplace(asking.convex({}, 0));
    const State& s = impl_->whole("World::overlap");
    std::vector<ShapeId> found;
    s.broad_phase.query_bounds(bounds, [&](std::uint32_t other) {
        if (!is_seen(s, other, layers)) return;
        const PosedInQuery posed(s, other, origin);
        const bool is_met = solid                             ? meets(*solid, posed)
                            : is_surface(posed.geometry.type) ? false
                                                              : meets(QuerySolid(posed.convex({}, 0)), asking);
        if (is_met) found.push_back(s.shape_id(other));
    });
    std::sort(found.begin(), found.end(), [](ShapeId a, ShapeId b) { return a.index() < b.index(); });
    return found;
}

} // namespace cairn
