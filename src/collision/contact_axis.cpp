#include "collision/contact_axis.h"

#include "shapes/columns.h"

namespace cairn {

using math::dot;
using math::DVec3;

namespace {

// Finds the face of a hull along whose normal another shape is farthest away. Any point of the other shape gives an
// upper bound of its separation for each face. The face with the largest bound is measured, which gives another point
// and tightens the bounds, and so on, until no bound exceeds the best separation.
class HullFaceSearch {
  public:
    HullFaceSearch(const Convex& hull, const Convex& other, const DVec3& p, const FaceAxis& floor)
        : hull_(hull), other_(other), p_(p), best_(floor) {
        slack_ = 1e-5 * (hull.hull->bounding_radius + math::length(middle(other) - hull.center));
    }

    FaceAxis search() {
        for (std::size_t i = 0; i < hull_.hull->plane_columns.size(); i += at_once) search_from(i);
        return best_;
    }

  private:
    static constexpr std::size_t width = PlaneColumns::width, at_once = 16 * width; // faces
    static constexpr float done = -std::numeric_limits<float>::infinity();
    using F4 = columns::F4;

    math::Vec3 local(DVec3 point) const { return math::to_float(to_local(hull_, point - hull_.center)); }
    // A face is measured only if its bound exceeds this value.
    float bar() const { return static_cast<float>(best_.separation - outer_radius(hull_) - slack_); }

    // Searches the faces `first` to `first + at_once - 1`.
    void search_from(std::size_t first) {
        const PlaneColumns& planes = hull_.hull->plane_columns; // of the core
        const std::size_t blocks = (std::min(planes.size() - first, at_once) + width - 1) / width;
        const math::Vec3 p = local(p_), q = local(middle(other_));
        F4 limits[at_once / width];
        for (std::size_t i = 0; i < blocks; ++i)
            limits[i] = columns::lesser(planes.above(first + i * width, p), planes.above(first + i * width, q));
        if (const std::size_t known = std::size_t(best_.face) - first; best_.face >= int(first) && known < at_once)
            limits[known / width][known % width] = done;
        F4 most = limits[0];
        for (std::size_t i = 1; i < blocks; ++i) most = columns::greater(limits[i], most);
        for (float greatest = columns::greatest_of(most); greatest > bar(); greatest = columns::greatest_of(most)) {
            const math::Vec3 nearest = local(measure(static_cast<int>(first + take(limits, greatest))));
            most = columns::splat(done);
            for (std::size_t i = 0; i < blocks; ++i) {
                limits[i] = columns::lesser(planes.above(first + i * width, nearest), limits[i]);
                most = columns::greater(limits[i], most);
            }
        }
    }

    // The index of the given bound, which is then marked as done.
    static std::size_t take(F4* limits, float limit) {
        const F4 wanted = columns::splat(limit);
        std::size_t i = 0;
        unsigned places = columns::bits(limits[i] == wanted);
        while (places == 0) places = columns::bits(limits[++i] == wanted);
        const auto k = static_cast<std::size_t>(__builtin_ctz(places));
        limits[i][k] = done;
        return i * width + k;
    }

    // Measures a face; returns the point of the other shape that is nearest to it.
    DVec3 measure(int face) {
        const DVec3 normal = face_normal(hull_, face);
        const NearSupport nearest = near_support(other_, -normal);
        const DVec3 on_face = face_point(hull_, face);
        const double separation = dot(normal, nearest.point - on_face);
        if (separation > best_.separation) best_ = {normal, separation, face, false, nearest.vertex, on_face};
        return nearest.point;
    }

    const Convex &hull_, &other_;
    DVec3 p_;
    FaceAxis best_;
    double slack_ = 0;
};

} // namespace

FaceAxis best_face(const Convex& c, const Convex& other, const DVec3& p, const FaceAxis& floor) {
    if (c.kind == Convex::Kind::hull) return HullFaceSearch(c, other, p, floor).search();
    FaceAxis best = floor;
    for (int i = 0; i < face_count(c); ++i) {
        if (!has_face(c, i)) continue;
        const DVec3 normal = face_normal(c, i), on_face = face_point(c, i);
        if (!(dot(normal, p - on_face) > best.separation)) continue; // the separation is at most that of p
        const NearSupport nearest = near_support(other, -normal);
        const double separation = dot(normal, nearest.point - on_face);
        if (separation > best.separation) best = {normal, separation, i, false, nearest.vertex, on_face};
    }
    return best;
}

} // namespace cairn
