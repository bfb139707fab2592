#include "impacts/meeting_points.h"

#include "bodies/bodies.h"
#include "contacts/convex_tests.h"
#include "contacts/pairs.h"

#include <algorithm>

namespace cairn {

using math::DVec3;
using math::to_double;

namespace {

struct Placed {
    std::uint32_t shape;
    math::Vec3 arm; // from the body's center of mass to the shape's origin
    ShapePose pose;
};

// Seen from `origin`, for precision far from that of the world.
Placed placed_at(const State& s, std::uint32_t shape, const MovingState& body, DVec3 origin) {
    const Geometry& g = s.shapes.geometry[shape];
    const math::Quat q = math::to_float(body.q);
    Placed p{shape, math::rotate(q, g.position - s.bodies.mass[s.shapes.links[shape].body].center),
             s.shapes.poses[shape]};
    pose_shape(p.pose, g, (body.x - origin) + to_double(p.arm), q);
    return p;
}

Manifold manifold_of(const State& s, PairKind kind, const Placed& a, const Placed& b, float margin) {
    if (int(kind) < wide_kinds) {
        const ShapePose poses[2] = {a.pose, b.pose};
        std::uint32_t first[8], second[8], features[8];
        float margins[8];
        for (int i = 0; i < 8; ++i) first[i] = 0, second[i] = 1, margins[i] = margin, features[i] = no_features;
        Manifold manifolds[8];
        wide_kernel(kind)(poses, first, second, margins, features, 8, manifolds);
        return manifolds[0];
    }
    ContactMemory memory = nothing_met;
    return test_convex_pair(kind, {s.shapes.geometry[a.shape], s.shapes.data[a.shape], a.pose, a.arm},
                            {s.shapes.geometry[b.shape], s.shapes.data[b.shape], b.pose, b.arm}, {}, margin, memory);
}

} // namespace

void find_meeting_points(const State& s, std::uint32_t shape_a, const MovingState& a, std::uint32_t shape_b,
                         const MovingState& b, MeetingScratch& scratch, std::vector<ImpactPoint>& points) {
    constexpr double most = 1e-4, part = 0.01;
    points.clear();
    bool swapped = false;
    const std::optional<PairKind> kind = pair_kind(s.shapes.geometry[shape_a], s.shapes.geometry[shape_b], swapped);
    if (!kind) return;
    const double width = 0.5 * double(std::min(smallest_extent(s.shapes.geometry[shape_a], s.shapes.data[shape_a]),
                                               smallest_extent(s.shapes.geometry[shape_b], s.shapes.data[shape_b])));
    const auto margin = float(std::min(most, part * width));
    const DVec3 origin = a.x;
    Placed first = placed_at(s, shape_a, a, origin), second = placed_at(s, shape_b, b, origin);
    if (swapped) std::swap(first, second);
    scratch.hits.clear();
    if (*kind == PairKind::group)
        find_patches({s.shapes.geometry[first.shape], s.shapes.data[first.shape], first.pose, first.arm},
                     {s.shapes.geometry[second.shape], s.shapes.data[second.shape], second.pose, second.arm}, margin,
                     margin, scratch.surface, scratch.hits);
    else
        scratch.hits.push_back(manifold_of(s, *kind, first, second, margin));
    const DVec3 center = origin + shape_position(first.pose);
    for (const Manifold& hit : scratch.hits)
        for (int i = 0; i < hit.count; ++i) {
            if (!(hit.points[i][3] <= margin)) continue;
            const DVec3 n = to_double(math::to_vec(hit.normal)), normal = math::normalized(swapped ? -n : n);
            points.push_back({center + to_double(math::to_vec(hit.points[i])), normal});
        }
}

} // namespace cairn
