// Internal edges are edges between surfaces that lie side by side: two boxes that make a floor, or two tiles of
// terrain. A body that slides over one surface meets the edge of the next before its face, and would bump into it
// although nothing sticks out. A contact with an immovable body is dropped if a deeper contact of the same body has a
// plane
// - that contains all points of the contact, or that no part of the body is below, and
// - above which the other shape does not rise.
// A body that rolls along such an edge touches both surfaces: if one of them carries the whole line, the contact with
// the other is dropped. Each contact applies friction in the middle of its part of the line, and would turn the body
// aside.
// Thin walls are made of two surfaces back to back: a body in front of one is behind the other.
#include "contacts/internal_edges.h"

#include "bodies/bodies.h"
#include "bodies/motion_budget.h"
#include "contacts/contact_record.h"
#include "contacts/contact_update.h"
#include "contacts/shared_tests.h"
#include "contacts/touch.h"
#include "core/cache.h"
#include "core/key_tree.h"
#include "jobs/ordered_list.h"
#include "shapes/convex.h"
#include "state/state.h"

#include <algorithm>
#include <optional>

namespace cairn {

using math::to_vec;

namespace {

// Tolerance for a point in a plane, as a share of the sizes of both shapes: as far as contact points on the rim of a
// face are off. It is bounded by how far the body may move until its points are found anew.
constexpr float flatness = 2e-4f;

constexpr int contacts_per_chunk = 1024; // items per chunk of a parallel loop

// Whether two unit vectors differ so little that planes of the size of a shape differ by at most the same tolerance.
bool is_same(math::Vec3 a, math::Vec3 b) { return math::dot(a - b, a - b) < flatness * flatness; }

// The extent of a shape (other than an infinite plane) relative to the center of mass of a body that touches it, by
// support points; meshes and height fields count as their bounding boxes.
struct Extent {
    Convex solid;

    Extent(const Bodies& bodies, const Shapes& shapes, std::uint32_t shape, std::int32_t body) {
        const Geometry& g = shapes.geometry[shape];
        const ShapePose& pose = shapes.poses[shape];
        math::DVec3 center = shape_position(pose) - bodies.motion[body].x;
        const math::DQuat q = math::normalized(math::to_double(shape_rotation(pose)));
        if (g.type == ShapeType::mesh) {
            make_bounds(mesh_of(shapes.data[shape]).lo, mesh_of(shapes.data[shape]).hi, center, q);
        } else if (g.type == ShapeType::height_field) {
            const HeightFieldData& field = height_field_of(shapes.data[shape]);
            const float x = float(grid_half(field.columns, field.spacing_x));
            const float z = float(grid_half(field.rows, field.spacing_z));
            make_bounds({-x, field.least, -z}, {x, field.greatest, z}, center, q);
        } else {
            const Geometry part = near_part(g, center, q, {}, double(bodies.links[body].radius));
            solid = make_convex(part, shapes.data[shape], center, q);
        }
    }
    void make_bounds(math::Vec3 lo, math::Vec3 hi, math::DVec3 center, math::DQuat q) {
        solid.kind = Convex::Kind::box;
        solid.is_sharp = true;
        solid.axes = math::to_matrix(q);
        solid.center = center + solid.axes * math::to_double(0.5f * (lo + hi));
        solid.size = math::to_double(0.5f * (hi - lo));
    }
    // The distance by which the shape extends from a point along n, m.
    double reach(math::DVec3 n, math::DVec3 from) const { return math::dot(n, support(solid, n) - from); }
};

// Where point i is on the other surface, relative to the body's center of mass at the start of the step. The surface is
// at rest, but the body moves until they touch.
math::Vec3 other_surface(const Bodies& bodies, const Contacts& contacts, std::uint32_t contact, int i) {
    const ContactRecord& r = contacts.records[contact];
    const math::Vec3 point = to_vec(point_of(r, i));
    const math::Vec3 way = r.touch_time * bodies.motion[contacts.info[contact].body_a].v;
    return point + way + 0.5f * point_of(r, i)[3] * to_vec(r.normal);
}

// Indices of a contact's keys in the tree of planes and, if it has two points, in the tree of lines. Planes: the
// normal, then the plane's height above the center of mass, the depth, and the place in the order of depths. Lines: the
// normal, then the bounds of the line.
enum PlaneKey : std::size_t { plane_offset = 3, plane_depth, plane_rank };
enum LineKey : std::size_t { line_lo = 3, line_hi = 6 };

double square(double x) { return x * x; }

// The least and the greatest distance, squared, between n and unit vectors whose components are within bounds.
template <class Bounds> double least_difference(const Bounds& b, math::Vec3 n) {
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const double x = double(n[int(i)]), off = std::max({b.lo[i] - x, x - b.hi[i], 0.0});
        sum += off * off;
    }
    return sum;
}
template <class Bounds> double greatest_difference(const Bounds& b, math::Vec3 n) {
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const double x = double(n[int(i)]), off = std::max(x - b.lo[i], b.hi[i] - x);
        sum += off * off;
    }
    return sum;
}

// Tests whether a contact is with an internal edge, by the planes of deeper contacts.
class EdgeTest {
  public:
    EdgeTest(const Bodies& bodies, const Shapes& shapes, const Contacts& contacts, std::uint32_t contact)
        : bodies_(bodies), shapes_(shapes), contacts_(contacts), info_(contacts.info[contact]),
          record_(contacts.records[contact]), radius_(bodies.links[info_.body_a].radius),
          tolerance_(std::min(flatness * (radius_ + shapes.geometry[info_.shape_b].bounding_radius),
                              float(nearness) * radius_)) {
        for (int i = 0; i < info_.point_count; ++i) points_[i] = other_surface(bodies, contacts, contact, i);
    }

    // Whether the contact is with an edge in the plane of the other contact.
    bool lies_in(std::uint32_t deeper, float depth) {
        if (!may_be_seam(deeper)) return false;
        const math::Vec3 up = -to_vec(contacts_.records[deeper].normal),
                         origin = other_surface(bodies_, contacts_, deeper, 0);
        const bool is_in_plane = has_points_in(deeper, depth);
        const math::DVec3 n = math::to_double(up), from = math::to_double(origin);
        if (other().reach(n, from) > double(tolerance_)) return false;
        // Separated sharp edges meet as rounded ones would, at a point somewhere off the plane. But if all of the body
        // is above the plane, it can meet a shape below the plane only in the plane.
        return is_in_plane || own().reach(-n, from) <= double(depth + tolerance_);
    }

    // Whether all points of the contact are in the plane of the other contact, up to the penetration. If the other
    // shape rises above that plane, it is a wall or a ramp that begins there.
    bool stands_on(std::uint32_t deeper, float depth) const {
        return may_be_seam(deeper) && has_points_in(deeper, depth);
    }
    float tolerance() const { return tolerance_; }

    // Returns false if the contact lies in none of the planes with such keys. `may_rise`: the other shape may rise
    // above them.
    bool may_lie_in(const KeyTree<6>::Bounds& planes, bool may_rise = false) {
        if (shapes_.geometry[info_.shape_b].type == ShapeType::plane) return false;
        if (greatest_difference(planes, -to_vec(record_.normal)) < square(double(flatness) - rounding)) return false;
        math::DVec3 up, spread;
        for (std::size_t i = 0; i < 3; ++i) {
            up[int(i)] = 0.5 * (planes.lo[i] + planes.hi[i]);
            spread[int(i)] = 0.5 * (planes.hi[i] - planes.lo[i]);
        }
        // Lower and upper bounds of the height of a point above any of the planes.
        const auto slack = [&](math::DVec3 p) {
            return double(tolerance_) + rounding * (double(radius_) + math::length(p));
        };
        const auto least_height = [&](math::DVec3 p) {
            return math::dot(up, p) - math::dot(spread, math::abs(p)) - planes.hi[plane_offset] - slack(p);
        };
        const auto greatest_height = [&](math::DVec3 p) {
            return math::dot(up, p) + math::dot(spread, math::abs(p)) - planes.lo[plane_offset] + slack(p);
        };
        if (!may_rise && least_height(support(other().solid, up)) > 0) return false;
        const double depth = std::max(planes.hi[plane_depth], 0.0);
        bool may_be_in_plane = true;
        for (int i = 0; i < info_.point_count; ++i) {
            const math::DVec3 p = math::to_double(points_[i]);
            may_be_in_plane = may_be_in_plane && least_height(p) <= 0 && greatest_height(p) >= -depth;
        }
        return may_be_in_plane || (!may_rise && greatest_height(support(own().solid, -up)) >= -depth);
    }

  private:
    bool may_be_seam(std::uint32_t deeper) const {
        return info_.shape_b != contacts_.info[deeper].shape_b &&
               !is_same(to_vec(contacts_.records[deeper].normal), to_vec(record_.normal)) &&
               shapes_.geometry[info_.shape_b].type != ShapeType::plane;
    }
    bool has_points_in(std::uint32_t deeper, float depth) const {
        const math::Vec3 up = -to_vec(contacts_.records[deeper].normal),
                         origin = other_surface(bodies_, contacts_, deeper, 0);
        return std::all_of(points_, points_ + info_.point_count, [&](const math::Vec3& p) {
            const float height = math::dot(up, p - origin);
            return height <= tolerance_ && height >= -depth - tolerance_;
        });
    }

    // Created on demand, as extents are seldom needed.
    const Extent& extent(std::optional<Extent>& extent, std::uint32_t shape) {
        if (!extent) extent.emplace(bodies_, shapes_, shape, info_.body_a);
        return *extent;
    }
    const Extent& other() { return extent(other_, info_.shape_b); }
    const Extent& own() { return extent(own_, info_.shape_a); }

    const Bodies& bodies_;
    const Shapes& shapes_;
    const Contacts& contacts_;
    const ContactInfo& info_;
    const ContactRecord& record_;
    float radius_, tolerance_; // m
    math::Vec3 points_[4];
    std::optional<Extent> other_, own_;
};

void drop_own_edge(const Bodies& bodies, Contacts& contacts, NarrowScratch& narrow, std::uint32_t c) {
    drop_internal_edge(bodies, contacts, narrow, c);
    narrow.dropped.push_back(c);
}

// A surface that pushes a shape out to its front, as the middle of the shape is behind the surface.
struct Lift {
    math::DVec3 normal, foot; // from the shape to the surface; the middle projected onto the surface
};
std::optional<Lift> lift_of(const Bodies& bodies, const Shapes& shapes, const Contacts& contacts, std::uint32_t c) {
    const ContactInfo& info = contacts.info[c];
    const ContactRecord& r = contacts.records[c];
    if (!(min_separation(info, r) < -bodies.links[info.body_a].inner_radius)) return {};
    if (!is_surface(shapes.geometry[info.shape_b].type)) return {};
    const math::DVec3 middle = inside_of(Extent(bodies, shapes, info.shape_a, info.body_a).solid),
                      n = math::to_double(to_vec(r.normal));
    const double depth = math::dot(n, middle - math::to_double(other_surface(bodies, contacts, c, 0)));
    if (!(depth > 0)) return {};
    return Lift{n, middle - depth * n};
}
// A shape on a floor whose back side is a ceiling is behind the ceiling as well, and may reach through it by its
// penetration of the floor. The ceiling does not push the shape if the floor lies between them: as drop_far_sides in
// collision/surface_contact.cpp does within a mesh.
void drop_far_sides(const Bodies& bodies, const Shapes& shapes, Contacts& contacts, NarrowScratch& narrow,
                    const std::vector<std::uint32_t>& ids) {
    for (const std::uint32_t c : ids) {
        const std::optional<Lift> lift = lift_of(bodies, shapes, contacts, c);
        if (!lift) continue;
        const double tolerance = double(flatness * bodies.links[contacts.info[c].body_a].radius);
        if (std::any_of(ids.begin(), ids.end(), [&](std::uint32_t near) {
                const math::DVec3 n = math::to_double(to_vec(contacts.records[near].normal)),
                                  way = math::to_double(other_surface(bodies, contacts, near, 0)) - lift->foot;
                return contacts.info[near].shape_a == contacts.info[c].shape_a && math::dot(n, lift->normal) < 0 &&
                       math::dot(lift->normal, way) >= -tolerance && math::dot(n, way) <= tolerance &&
                       !lift_of(bodies, shapes, contacts, near);
            }))
            drop_own_edge(bodies, contacts, narrow, c);
    }
}

// Whether all points of `c` lie on the line between the two points of another contact with the same normal.
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
    KeyTree<9>& tree = narrow.line_tree;
    std::vector<KeyTree<9>::Keys>& keys = narrow.line_keys;
    std::vector<std::uint32_t>& lines = narrow.lines;
    keys.clear();
    lines.clear();
    for (const std::uint32_t c : ids) {
        if (contacts.info[c].point_count != 2) continue;
        const ContactRecord& r = contacts.records[c];
        const math::Vec3 p = to_vec(point_of(r, 0)), q = to_vec(point_of(r, 1)), lo = math::min(p, q);
        const math::Vec3 hi = math::max(p, q), n = to_vec(r.normal);
        keys.push_back({n.x, n.y, n.z, lo.x, lo.y, lo.z, hi.x, hi.y, hi.z});
        lines.push_back(c);
    }
    const double radius = double(bodies.links[std::size_t(contacts.info[ids[0]].body_a)].radius);
    tree.build(keys, {radius, radius, radius, 1, 1, 1, 1, 1, 1});
    std::uint32_t next = 0; // index into `lines`
    for (const std::uint32_t c : ids) {
        const ContactRecord& r = contacts.records[c];
        const int count = contacts.info[c].point_count;
        const auto may_be_covered = [&](const KeyTree<9>::Bounds& b) {
            const double tolerance = (double(flatness) + rounding) * radius;
            if (least_difference(b, to_vec(r.normal)) > square(double(flatness) + rounding)) return false;
            for (int i = 0; i < count; ++i)
                for (std::size_t k = 0; k < 3; ++k) {
                    const double x = double(point_of(r, i)[k]);
                    if (x < b.lo[line_lo + k] - tolerance || x > b.hi[line_hi + k] + tolerance) return false;
                }
            return true;
        };
        const bool is_line = next < lines.size() && lines[next] == c;
        if (count <= 2 && tree.any(may_be_covered, [&](std::uint32_t i) {
                return lines[i] != c && !narrow.is_internal_edge[lines[i]] && is_covered(bodies, contacts, lines[i], c);
            })) {
            drop_own_edge(bodies, contacts, narrow, c);
            if (is_line) tree.remove(next);
        }
        next += is_line ? 1 : 0;
    }
}

// The penetration of a contact at the start of the step, m.
float depth_of(const Contacts& contacts, std::uint32_t contact) {
    const ContactInfo& c = contacts.info[contact];
    const ContactRecord& r = contacts.records[contact];
    return -min_separation(c, r) - (c.touching ? 0 : r.touch_time * r.approach_speed);
}

// Builds the tree of the planes of contacts, which are given deepest first.
void build_plane_tree(const Bodies& bodies, const Contacts& contacts, NarrowScratch& narrow,
                      const std::vector<DepthOfContact>& planes) {
    std::vector<KeyTree<6>::Keys>& keys = narrow.plane_keys;
    keys.clear();
    for (std::size_t i = 0; i < planes.size(); ++i) {
        const math::Vec3 up = -to_vec(contacts.records[planes[i].contact].normal);
        const double offset =
            math::dot(math::to_double(up), math::to_double(other_surface(bodies, contacts, planes[i].contact, 0)));
        keys.push_back({up.x, up.y, up.z, offset, planes[i].depth, double(i)});
    }
    // Planes that are nearly the same are split by their order, as the search is bounded by the order of depths, too.
    const double radius = double(bodies.links[std::size_t(contacts.info[planes[0].contact].body_a)].radius);
    const double by_rank = double(flatness) * radius / double(planes.size());
    narrow.plane_tree.build(keys, {radius, radius, radius, 1, 1, by_rank});
}

// A body on the ground penetrates it by some micrometers, and would meet the edge of a ramp that begins there from the
// side, and stop. So this finds how the body and the other shape meet with the body lifted out of the ground: the
// contact is updated accordingly, or, if they do not meet in this step, the result is false.
bool meets_from(const NarrowInput& in, Contacts& contacts, NarrowScratch& narrow, std::uint32_t id,
                const DepthOfContact& ground, float tolerance, float dt) {
    const ContactInfo& c = contacts.info[id];
    const math::DVec3 up = -math::to_double(to_vec(contacts.records[ground.contact].normal)),
                      lift = double(std::max(ground.depth, 0.0f) + tolerance) * up,
                      axis = math::to_double(to_vec(contacts.records[id].normal));
    const float margin = contact_margin(narrow, c, dt);
    Touch touch;
    const Approach approach = c.kind == PairKind::patch ? find_lifted_touch(in, contacts.info[c.related], lift, dt,
                                                                            margin, narrow.at_work[0], touch)
                                                        : find_lifted_touch(in, c, lift, axis, dt, margin, touch);
    if (approach == Approach::passes) return false;
    if (touch.manifold.count == 0) return true;
    take_manifold(in.bodies, in.shapes, contacts, in.islands, id, touch.manifold, &touch);
    test_again(in.bodies, contacts, id);
    narrow.lifted.push_back(id);
    return true;
}

// Drops the internal edges among the contacts of one body with bodies that do not move by forces.
void drop_internal_edges_of_body(const NarrowInput& in, Contacts& contacts, NarrowScratch& narrow,
                                 const std::vector<std::uint32_t>& ids, float dt) {
    const Bodies& bodies = in.bodies;
    const Shapes& shapes = in.shapes;
    drop_far_sides(bodies, shapes, contacts, narrow, ids);
    drop_covered(bodies, contacts, narrow, ids);
    const math::Vec3 first = to_vec(contacts.records[ids[0]].normal);
    if (std::all_of(ids.begin(), ids.end(),
                    [&](std::uint32_t id) { return is_same(first, to_vec(contacts.records[id].normal)); }))
        return;
    std::vector<DepthOfContact>& planes = narrow.by_depth;
    planes.clear();
    for (const std::uint32_t c : ids)
        if (!narrow.is_internal_edge[c]) planes.push_back({c, depth_of(contacts, c)});
    std::sort(planes.begin(), planes.end(), [](const DepthOfContact& a, const DepthOfContact& b) {
        return a.depth != b.depth ? a.depth > b.depth : a.contact < b.contact;
    });
    build_plane_tree(bodies, contacts, narrow, planes);
    KeyTree<6>& tree = narrow.plane_tree;
    const auto is_dropped = [&](std::uint32_t k) { return narrow.is_internal_edge[planes[k].contact] != 0; };
    const auto drop = [&](std::uint32_t k) {
        drop_own_edge(bodies, contacts, narrow, planes[k].contact);
        tree.remove(k);
    };
    const auto is_internal = [&](EdgeTest& edge, auto&& may_count, auto&& counts) {
        return tree.any([&](const KeyTree<6>::Bounds& b) { return may_count(b) && edge.may_lie_in(b); },
                        [&](std::uint32_t j) {
                            return counts(j) && !is_dropped(j) &&
                                   edge.lies_in(planes[j].contact, std::max(planes[j].depth, 0.0f));
                        });
    };
    const std::uint32_t count = std::uint32_t(planes.size());
    for (std::uint32_t k = 1; k < count; ++k) {
        if (is_dropped(k)) continue;
        EdgeTest edge(bodies, shapes, contacts, planes[k].contact);
        const auto may_be_deeper = [&](const KeyTree<6>::Bounds& b) { return b.lo[plane_rank] < double(k); };
        if (is_internal(edge, may_be_deeper, [&](std::uint32_t j) { return j < k; })) {
            drop(k);
            continue;
        }
        std::uint32_t ground = k;
        tree.any([&](const KeyTree<6>::Bounds& b) { return may_be_deeper(b) && edge.may_lie_in(b, true); },
                 [&](std::uint32_t j) {
                     const bool stands =
                         j < k && !is_dropped(j) && edge.stands_on(planes[j].contact, std::max(planes[j].depth, 0.0f));
                     if (stands) ground = j;
                     return stands;
                 });
        if (ground != k && !meets_from(in, contacts, narrow, planes[k].contact, planes[ground], edge.tolerance(), dt))
            drop(k);
    }
    // Just beyond an edge, the contact with the side may be the deeper one because of rounding errors or a slight tilt.
    const float slack = flatness * bodies.links[std::size_t(contacts.info[ids[0]].body_a)].radius;
    for (std::uint32_t k = 0; k + 1 < count; ++k) {
        const auto is_as_deep = [&](float depth) { return depth + slack > planes[k].depth; };
        if (!is_as_deep(planes[k + 1].depth)) continue;
        if (is_dropped(k)) continue;
        EdgeTest edge(bodies, shapes, contacts, planes[k].contact);
        const auto may_be_as_deep = [&](const KeyTree<6>::Bounds& b) {
            return b.hi[plane_rank] > double(k) && is_as_deep(float(b.hi[plane_depth]));
        };
        if (is_internal(edge, may_be_as_deep, [&](std::uint32_t j) { return j > k && is_as_deep(planes[j].depth); }))
            drop(k);
    }
}

} // namespace

// The next step tests the contact as if for the first time: the face is not preferred once the body is over it, and, as
// the solver skips the contact, its points are not moved along.
void drop_internal_edge(const Bodies& bodies, Contacts& contacts, NarrowScratch& narrow, std::uint32_t c) {
    narrow.is_internal_edge[c] = 1;
    narrow.any_internal_edges = true;
    const ContactInfo& info = contacts.info[c];
    if (contacts.records.has(c)) {
        forget_impulses(contacts.records[c], info.point_count);
        contacts.records[c].features = no_features;
    }
    stay_unsolved(bodies, contacts, info.kind == PairKind::patch ? std::uint32_t(info.related) : c);
}

void test_again(const Bodies& bodies, Contacts& contacts, std::uint32_t c) {
    forget_separation(bodies, contacts, c);
    if (contacts.info[c].kind == PairKind::patch)
        forget_separation(bodies, contacts, std::uint32_t(contacts.info[c].related));
}

void drop_internal_edges(const NarrowInput& in, Contacts& contacts, NarrowScratch& narrow,
                         std::vector<std::uint32_t>& solved, ThreadPool& thread_pool, Communicator* ranks, float dt) {
    const Bodies& bodies = in.bodies;
    list_in_order(&thread_pool, int(solved.size()), contacts_per_chunk, narrow.fixed_ids, narrow.parts,
                  [&](int begin, int end, std::uint32_t* next) {
                      for (int k = begin; k < end; ++k) {
                          if (const int later = k + 2 * int(contacts_ahead); later < end)
                              prefetch(&contacts.info[solved[std::size_t(later)]]);
                          const std::uint32_t id = solved[std::size_t(k)];
                          if (!contacts.info[id].b_moves) *next++ = id;
                      }
                      return next;
                  });
    std::vector<std::int32_t>& last_of_body = narrow.last_of_body;
    std::vector<FixedContact>& fixed = narrow.fixed;
    last_of_body.resize(bodies.links.size(), none);
    narrow.is_internal_edge.resize(contacts.info.size());
    fixed.clear();
    narrow.dropped.clear();
    narrow.lifted.clear();
    narrow.any_internal_edges = false;
    for (const std::uint32_t id : narrow.fixed_ids) {
        const ContactInfo& c = contacts.info[id];
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
        if (last == none) continue;                                                // the contacts of this body are done
        if (fixed[last].on_several && contacts.records.has(fixed[last].contact)) { // records of a body are on one rank
            narrow.of_body.clear();
            for (std::int32_t i = last; i != none; i = fixed[i].before) narrow.of_body.push_back(fixed[i].contact);
            drop_internal_edges_of_body(in, contacts, narrow, narrow.of_body, dt);
        }
        last = none;
    }
    if (ranks) exchange_internal_edges(bodies, contacts, narrow, *ranks);
    if (!narrow.any_internal_edges) return;
    std::erase_if(solved,
                  [&](std::uint32_t id) { return !contacts.info[id].b_moves && narrow.is_internal_edge[id] != 0; });
}

} // namespace cairn
