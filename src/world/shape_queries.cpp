// Shape casts and closest points.
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
    ShapeCast(const Convex& moving, DVec3 translation) : moving_(moving), translation_(translation) {
        for (int i = 0; i < 3; ++i) {
            DVec3 axis;
            axis[i] = 1;
            const double low = support(moving, -axis)[i], high = support(moving, axis)[i];
            lo_[i] = low + std::min(translation[i], 0.0), hi_[i] = high + std::max(translation[i], 0.0);
        }
    }
    DVec3 lo() const { return lo_; }
    DVec3 hi() const { return hi_; }

    std::optional<ConvexHit> against(const PosedInQuery& still) const {
        switch (still.geometry.type) {
        case ShapeType::plane: {
            const DVec3 up = still.up();
            const bool is_behind = still.geometry.is_double_sided && math::dot(up, middle(moving_) - still.center) < 0;
            return against_plane(is_behind ? -up : up, still.center);
        }
        case ShapeType::rectangle:
            if (!still.geometry.is_double_sided && !(math::dot(translation_, still.up()) < 0)) return std::nullopt;
            break;
        case ShapeType::mesh:
        case ShapeType::height_field: {
            std::optional<ConvexHit> best;
            for_each_triangle_near(still, lo_, hi_, [&](const Convex& triangle) {
                if (!(math::dot(translation_, triangle.axes.c1) < 0)) return;
                const auto hit = cast_convex(moving_, translation_, triangle);
                if (hit && (!best || hit->fraction < best->fraction)) best = hit;
            });
            return best;
        }
        default:
            break;
        }
        DVec3 center = still.center;
        const Geometry part =
            near_part(still.geometry, center, still.rotation, 0.5 * (lo_ + hi_), math::length(hi_ - lo_));
        return cast_convex(moving_, translation_, make_convex(part, still.data, center, still.rotation));
    }

  private:
    std::optional<ConvexHit> against_plane(DVec3 up, DVec3 origin) const {
        const DVec3 lowest = support(moving_, -up);
        const double height = math::dot(lowest - origin, up), fall = -math::dot(translation_, up);
        if (height > 0 && !(fall >= height)) return std::nullopt;
        if (height == 0 && !(fall > 0)) return std::nullopt;
        const double fraction = height > 0 ? height / fall : 0;
        return ConvexHit{fraction, lowest + fraction * translation_, up};
    }

    const Convex& moving_;
    DVec3 translation_, lo_, hi_;
};

// The point of a shape nearest to the query's origin, if nearer than `least`.
struct Nearest {
    DVec3 point;
    double distance;
};
std::optional<Nearest> nearest_of(const PosedInQuery& shape, double least) {
    const auto of_convex = [](const Convex& c) -> Nearest {
        Convex point; // a ball without radius
        const ClosestPoints closest = closest_points(point, c);
        return closest.distance > 0 ? Nearest{closest.on_b, closest.distance} : Nearest{{}, 0};
    };
    std::optional<Nearest> best;
    const auto consider = [&](const Nearest& n) {
        if (n.distance <= (best ? best->distance : least)) best = n;
    };
    if (shape.geometry.type == ShapeType::plane) {
        const DVec3 up = shape.up();
        const double height = -math::dot(shape.center, up);
        consider(height > 0 || shape.geometry.is_double_sided ? Nearest{-height * up, std::fabs(height)}
                                                              : Nearest{{}, 0});
    } else if (shape.geometry.type >= ShapeType::mesh) {
        const DVec3 reach{least, least, least};
        for_each_triangle_near(shape, -reach, reach, [&](const Convex& triangle) {
            const Nearest n = of_convex(triangle);
            if (!best || n.distance < best->distance) consider(n);
        });
    } else {
        DVec3 center = shape.center;
        const Geometry part = near_part(shape.geometry, center, shape.rotation, {}, 0);
        consider(of_convex(make_convex(part, shape.data, center, shape.rotation)));
    }
    return best;
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
    const DVec3 origin = to_math(start.position);
    const Convex moving = make_convex(g, data, {}, math::normalized(math::to_double(g.rotation)));
    const ShapeCast cast(moving, math::to_double(to_math(translation)));
    const State& s = impl_->whole("World::cast_shape");
    std::optional<ConvexHit> best;
    std::uint32_t met = 0;
    s.broad_phase.query_bounds({origin + cast.lo(), origin + cast.hi()}, [&](std::uint32_t other) {
        if (!is_seen(s.shapes, other, layers)) return;
        const auto hit = cast.against(PosedInQuery(s, other, origin));
        if (!hit || (best && (hit->fraction > best->fraction || (hit->fraction == best->fraction && other > met))))
            return;
        best = hit;
        met = other;
    });
    if (!best) return std::nullopt;
    return ShapeCastHit{s.shapes.slots.id(met), s.bodies.id(s.shapes.links[met].body), best->fraction,
                        to_public(origin + best->point), to_public(math::to_float(best->normal))};
}

std::optional<ClosestPoint> World::closest_point(const Position& point, double max_distance,
                                                 std::uint64_t layers) const {
    require_position("World::closest_point point", point);
    if (!(max_distance >= 0)) refuse("World::closest_point max_distance", to_text(max_distance), "must be >= 0");
    const double most = std::min(max_distance, 1e15); // as far as positions reach
    const DVec3 origin = to_math(point), reach{most, most, most};
    const State& s = impl_->whole("World::closest_point");
    std::optional<Nearest> best;
    std::uint32_t nearest = 0;
    s.broad_phase.query_bounds({origin - reach, origin + reach}, [&](std::uint32_t other) {
        if (!is_seen(s.shapes, other, layers)) return;
        const auto found = nearest_of(PosedInQuery(s, other, origin), best ? best->distance : most);
        if (!found || (best && found->distance == best->distance && other > nearest)) return;
        best = found;
        nearest = other;
    });
    if (!best) return std::nullopt;
    return ClosestPoint{s.shapes.slots.id(nearest), s.bodies.id(s.shapes.links[nearest].body),
                        to_public(origin + best->point), best->distance};
}

} // namespace cairn
