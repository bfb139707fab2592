// Seams between surfaces that lie side by side: two boxes that make a floor, two tiles of terrain. What slides over one
// meets the edge of the next before its face, and would bump into it although nothing stands out. A contact with
// something immovable is left out where a deeper one of the same body has a plane that
// - all the points of the contact lie in, or nothing of the body is below, and
// - the other thing does not rise above.
// And what rolls along the seam itself touches both: where one of them carries the whole line, the other is left out.
// Each counts its friction in the middle of its part, and would turn it aside.
#include "contacts/internal_edges.h"

#include "bodies/bodies.h"
#include "bodies/motion_budget.h"
#include "contacts/contact_record.h"
#include "contacts/contact_update.h"
#include "shapes/convex.h"
#include "state/state.h"

#include <algorithm>
#include <limits>

namespace cairn {

using math::to_vec;

namespace {

// How far out of the plane a point may be: so much of the sizes of both, as far as contact points on the rim of a face
// are off, but no more than the body may move until its points are found anew.
constexpr float flatness = 2e-4f;

// Of unit vectors that differ by no more, planes of the size of a shape differ by as little.
bool is_same(math::Vec3 a, math::Vec3 b) { return math::dot(a - b, a - b) < flatness * flatness; }

// How far the shape reaches along n, from the point `from`; meshes and height fields by their bounds.
double reach(const Shapes& shapes, std::uint32_t shape, math::DVec3 n, math::DVec3 from) {
    const Geometry& g = shapes.geometry[shape];
    const ShapePose& pose = shapes.poses[shape];
    math::DVec3 center = shape_position(pose) - from;
    const math::DQuat q = math::normalized(math::to_double(shape_rotation(pose)));
    const auto of_bounds = [&](math::Vec3 lo, math::Vec3 hi) {
        const math::DVec3 d = math::rotate_back(q, n), middle = math::to_double(0.5f * (lo + hi));
        return math::dot(n, center) + math::dot(d, middle) + math::dot(math::abs(d), math::to_double(0.5f * (hi - lo)));
    };
    switch (g.type) {
    case ShapeType::plane:
        return std::numeric_limits<double>::infinity();
    case ShapeType::mesh:
        return of_bounds(mesh_of(shapes.data[shape]).lo, mesh_of(shapes.data[shape]).hi);
    case ShapeType::height_field: {
        const HeightFieldData& field = height_field_of(shapes.data[shape]);
        const float x = float(grid_half(field.columns, field.spacing_x));
        const float z = float(grid_half(field.rows, field.spacing_z));
        return of_bounds({-x, field.least, -z}, {x, field.greatest, z});
    }
    default: {
        const Geometry part = near_part(g, center, q, {}, 0);
        return math::dot(n, support(make_convex(part, shapes.data[shape], center, q), n));
    }
    }
}

// Where the other surface is, relative to the body's center of mass. It does not move, but the body does up to the
// touch.
math::Vec3 other_surface(const Bodies& bodies, const Contacts& contacts, std::uint32_t contact, int i) {
    const ContactRecord& r = contacts.records[contact];
    const math::Vec3 point = to_vec(point_of(r, i));
    if (r.touch_time > 0) return point + r.touch_time * bodies.motion[contacts.info[contact].body_a].v;
    return point + 0.5f * point_of(r, i)[3] * to_vec(r.normal);
}

// Whether `c` is an edge in the plane of the deeper contact.
bool is_internal_edge(const Bodies& bodies, const Shapes& shapes, const Contacts& contacts, std::uint32_t deeper,
                      std::uint32_t c, float depth) {
    const ContactInfo &info = contacts.info[c], &over = contacts.info[deeper];
    const ContactRecord &r = contacts.records[c], &plane = contacts.records[deeper];
    const math::Vec3 up = -to_vec(plane.normal);
    if (info.shape_b == over.shape_b || is_same(to_vec(plane.normal), to_vec(r.normal))) return false;
    const math::Vec3 origin = other_surface(bodies, contacts, deeper, 0);
    const float radius = bodies.links[info.body_a].radius;
    const float tolerance =
        std::min(flatness * (radius + shapes.geometry[info.shape_b].bounding_radius), float(nearness) * radius);
    bool is_in_plane = true;
    for (int i = 0; i < info.point_count; ++i) {
        const float height = math::dot(up, other_surface(bodies, contacts, c, i) - origin);
        is_in_plane = is_in_plane && height <= tolerance && height >= -depth - tolerance;
    }
    const math::DVec3 point = bodies.motion[info.body_a].x + math::to_double(origin), n = math::to_double(up);
    if (reach(shapes, info.shape_b, n, point) > double(tolerance)) return false;
    // Sharp edges that are still apart meet as rounded ones would, somewhere beside the plane. But if all of the body
    // is above it, what is below can only be met in it.
    return is_in_plane || reach(shapes, info.shape_a, -n, point) <= double(depth + tolerance);
}

// The next step finds it as if for the first time: its face is not preferred once the body is over it.
void drop(Contacts& contacts, NarrowScratch& narrow, std::uint32_t c) {
    narrow.is_internal_edge[c] = 1;
    narrow.any_internal_edges = true;
    forget_impulses(contacts.records[c], contacts.info[c].point_count);
    contacts.records[c].features = no_features;
}

// Whether the points of `c` lie on the line that another contact with the same normal carries.
bool is_covered(const Bodies& bodies, const Contacts& contacts, std::uint32_t line, std::uint32_t c) {
    const ContactInfo &info = contacts.info[c], &over = contacts.info[line];
    const ContactRecord &r = contacts.records[c], &whole = contacts.records[line];
    if (over.point_count != 2 || info.point_count > 2 || info.shape_b == over.shape_b) return false;
    if (!is_same(to_vec(whole.normal), to_vec(r.normal))) return false;
    const math::Vec3 from = to_vec(point_of(whole, 0)), along = to_vec(point_of(whole, 1)) - from;
    const float square = math::dot(along, along), tolerance = flatness * bodies.links[info.body_a].radius;
    for (int i = 0; i < info.point_count; ++i) {
        const math::Vec3 to = to_vec(point_of(r, i)) - from;
        const float part = square > 0 ? std::clamp(math::dot(to, along) / square, 0.0f, 1.0f) : 0.0f;
        const math::Vec3 off = to - part * along;
        if (math::dot(off, off) > tolerance * tolerance) return false;
    }
    return true;
}
void drop_covered(const Bodies& bodies, Contacts& contacts, NarrowScratch& narrow,
                  const std::vector<std::uint32_t>& ids) {
    for (const std::uint32_t c : ids)
        for (const std::uint32_t line : ids) {
            if (line == c || narrow.is_internal_edge[line] || !is_covered(bodies, contacts, line, c)) continue;
            drop(contacts, narrow, c);
            break;
        }
}

// Drops internal edges among the contacts of one body with what does not move by forces.
void drop_internal_edges_of_body(const Bodies& bodies, const Shapes& shapes, Contacts& contacts, NarrowScratch& narrow,
                                 std::vector<std::uint32_t>& ids) {
    drop_covered(bodies, contacts, narrow, ids);
    const auto depth_of = [&](std::uint32_t id) { // at the start of the step
        const ContactRecord& r = contacts.records[id];
        return -min_separation(contacts.info[id], r) - r.touch_time * r.approach_speed;
    };
    const math::Vec3 first = to_vec(contacts.records[ids[0]].normal);
    if (std::all_of(ids.begin(), ids.end(),
                    [&](std::uint32_t id) { return is_same(first, to_vec(contacts.records[id].normal)); }))
        return;
    std::sort(ids.begin(), ids.end(), [&](std::uint32_t a, std::uint32_t b) {
        const float depth_a = depth_of(a), depth_b = depth_of(b);
        return depth_a != depth_b ? depth_a > depth_b : a < b;
    });
    const auto drop_if_internal = [&](std::size_t j, std::size_t k) {
        if (narrow.is_internal_edge[ids[j]] || narrow.is_internal_edge[ids[k]]) return;
        if (is_internal_edge(bodies, shapes, contacts, ids[j], ids[k], std::max(depth_of(ids[j]), 0.0f)))
            drop(contacts, narrow, ids[k]);
    };
    for (std::size_t k = 1; k < ids.size(); ++k)
        for (std::size_t j = 0; j < k; ++j) drop_if_internal(j, k);
    // Just beyond an edge, its side may be the deeper one by a rounding error or a slight tilt.
    const float slack = flatness * bodies.links[std::size_t(contacts.info[ids[0]].body_a)].radius;
    for (std::size_t k = 0; k + 1 < ids.size(); ++k)
        for (std::size_t j = k + 1; j < ids.size() && depth_of(ids[j]) + slack > depth_of(ids[k]); ++j)
            drop_if_internal(j, k);
}

} // namespace

void drop_internal_edges(const Bodies& bodies, const Shapes& shapes, Contacts& contacts, NarrowScratch& narrow,
                         std::vector<std::uint32_t>& solved) {
    std::vector<std::int32_t>& last_of_body = narrow.last_of_body;
    std::vector<FixedContact>& fixed = narrow.fixed;
    last_of_body.resize(bodies.links.size(), none);
    narrow.is_internal_edge.resize(contacts.info.size());
    fixed.clear();
    narrow.any_internal_edges = false;
    for (const std::uint32_t id : solved) {
        const ContactInfo& c = contacts.info[id];
        if (c.b_moves) continue;
        narrow.is_internal_edge[id] = 0;
        std::int32_t& last = last_of_body[c.body_a];
        bool on_several = false;
        if (last != none) {
            const FixedContact& before = fixed[last];
            on_several = before.on_several || contacts.info[before.contact].shape_b != c.shape_b;
        }
        fixed.push_back({id, last, on_several});
        last = std::int32_t(fixed.size()) - 1;
    }
    for (std::size_t k = fixed.size(); k-- > 0;) {
        std::int32_t& last = last_of_body[std::size_t(contacts.info[fixed[k].contact].body_a)];
        if (last == none) continue; // its body is done
        if (fixed[last].on_several) {
            narrow.of_body.clear();
            for (std::int32_t i = last; i != none; i = fixed[i].before) narrow.of_body.push_back(fixed[i].contact);
            drop_internal_edges_of_body(bodies, shapes, contacts, narrow, narrow.of_body);
        }
        last = none;
    }
    if (!narrow.any_internal_edges) return;
    std::erase_if(solved,
                  [&](std::uint32_t id) { return !contacts.info[id].b_moves && narrow.is_internal_edge[id] != 0; });
}

} // namespace cairn
