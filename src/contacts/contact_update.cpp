#include "contacts/contact_update.h"

#include "bodies/bodies.h"
#include "bodies/motion_budget.h"
#include "contacts/contact_record.h"
#include "contacts/patches.h"
#include "contacts/shared_tests.h"
#include "core/cache.h"
#include "core/hash.h"
#include "core/room.h"
#include "islands/coloring.h"
#include "islands/islands.h"
#include "islands/substep_policy.h"

#include <algorithm>
#include <limits>
#include <tuple>

namespace cairn {

using math::to_vec;

namespace {

constexpr float unused = 1e30f;
constexpr int reports_per_chunk = 512; // items per chunk of a parallel loop

// Share of the relative speed that is added to the approach speed, as bodies that are hit within the step may continue
// in any direction. Without it, boxes in a closed box gain 6 % of energy instead of 4 % (validation, closed_pile).
constexpr float redirected = 0.5f;

// The greatest speed at which points approach along the normal n from a to b. arm_of(i): from the center of mass of a
// to point i; d: from the center of mass of b to that of a.
template <class F>
float greatest_approach(const BodyMotion& a, const BodyMotion& b, math::Vec3 n, math::Vec3 d, int count, F&& arm_of) {
    float speed = std::numeric_limits<float>::lowest();
    for (int i = 0; i < count; ++i) {
        const math::Vec3 arm = arm_of(i);
        const math::Vec3 v = (b.v + math::cross(b.w, arm + d)) - (a.v + math::cross(a.w, arm));
        speed = std::max(speed, -math::dot(n, v));
    }
    return speed;
}

void note_trigger(const Bodies& bodies, const Shapes& shapes, StepEvents& events, ContactInfo& c, bool inside) {
    c.touching = inside;
    const bool a_is_trigger = shapes.traits[c.shape_a].is_trigger;
    const std::uint32_t trigger = a_is_trigger ? c.shape_a : c.shape_b, other = a_is_trigger ? c.shape_b : c.shape_a;
    events.triggers.next.push_back({shapes.slots.id(trigger), shapes.slots.id(other),
                                    bodies.id(shapes.links[trigger].body), bodies.id(shapes.links[other].body), inside,
                                    0});
}

// Whether another patch of the same pair touches.
bool pair_touches_elsewhere(const Contacts& contacts, const ContactInfo& c) {
    if (c.kind != PairKind::patch) return false;
    for (std::int32_t p = contacts.info[c.related].related; p != none; p = contacts.info[p].next)
        if (&contacts.info[p] != &c && contacts.info[p].touching) return true;
    return false;
}

void end_touch(const Bodies& bodies, const Shapes& shapes, const Contacts& contacts, StepEvents& events,
               ContactInfo& c) {
    c.touching = 0;
    if (pair_touches_elsewhere(contacts, c)) return;
    events.ends.next.push_back(
        {shapes.slots.id(c.shape_a), shapes.slots.id(c.shape_b), bodies.id(c.body_a), bodies.id(c.body_b)});
}

void begin_contact(Bodies& bodies, Islands& islands, StepEvents& events, const ForceFields& fields,
                   const WorldDef& settings, ContactInfo& c, math::Vec3 normal) {
    if (c.b_moves)
        link_islands(bodies, islands, events, c.body_a, c.body_b);
    else
        wake_island(bodies, islands, events, bodies.links[c.body_a].island);
    count_contact(bodies, c);
    c.load = c.force = first_load(bodies, fields, settings, c, normal);
    c.substep_time = 0;
}

// Whether the distance that a test of this kind finds is kept. Distances from planes, which are infinite, are not.
bool has_distance(PairKind kind) {
    switch (kind) {
    case PairKind::sphere_sphere:
    case PairKind::sphere_box:
    case PairKind::sphere_capsule:
    case PairKind::box_box:
    case PairKind::capsule_capsule:
    case PairKind::box_capsule:
    case PairKind::convex_convex:
    case PairKind::group:
        return true;
    default:
        return false;
    }
}

} // namespace

float approach_speed(const Bodies& bodies, const ContactInfo& c, const ContactRecord& r) {
    const BodyMotion &a = bodies.motion[c.body_a], &b = bodies.motion[c.body_b];
    const float speed = greatest_approach(a, b, to_vec(r.normal), to_vec(r.center_offset), c.point_count,
                                          [&](int i) { return to_vec(point_of(r, i)); });
    return std::max(speed, 0.0f);
}

float approach_of(const Bodies& bodies, const Shapes& shapes, const ContactInfo& c, const Manifold& m) {
    const std::int32_t first = c.flipped ? c.body_b : c.body_a, second = c.flipped ? c.body_a : c.body_b;
    const BodyMotion &a = bodies.motion[first], &b = bodies.motion[second];
    const math::Vec3 center = shapes.links[c.flipped ? c.shape_b : c.shape_a].arm;
    return greatest_approach(a, b, to_vec(m.normal), math::to_float(a.x - b.x), m.count,
                             [&](int i) { return center + to_vec(m.points[i]); });
}

BegunContact how_it_begins(const Contacts& contacts, std::uint32_t id, float dt) {
    const ContactRecord& r = contacts.records[id];
    return {to_vec(r.normal), min_separation(contacts.info[id], r) > dt * r.approach_speed};
}

namespace {

// How a contact begins; if another rank owns its record, as that rank has reported.
BegunContact start_of(const FollowUpContext& s, std::uint32_t id, float dt) {
    if (s.contacts.records.has(id)) return how_it_begins(s.contacts, id, dt);
    return s.narrow.begun[s.narrow.next_begun++];
}

} // namespace

void follow_up(const FollowUpContext& s, std::uint32_t id, std::uint8_t outcome, float dt) {
    if (outcome == apart) return;
    if (outcome == ended) {
        end_contact(s.bodies, s.shapes, s.contacts, s.islands, s.events, id);
        return;
    }
    if (outcome == skipped) {
        s.narrow.skipped.push_back(id);
        return;
    }
    if (outcome == entered || outcome == left) {
        note_trigger(s.bodies, s.shapes, s.events, s.contacts.info[id], outcome == entered);
        return;
    }
    if (outcome != persists) {
        ContactInfo& c = s.contacts.info[id];
        const BegunContact start = outcome == begun ? start_of(s, id, dt) : BegunContact{};
        const bool asleep = is_asleep(s.bodies, s.islands, c);
        // A body that passes by does not wake a sleeping one: only a body that will touch it within the step does.
        if (outcome == begun && asleep && start.passes_by) {
            c.point_count = 0;
            forget_separation(s.bodies, s.contacts, id);
            return;
        }
        if (outcome == begun) {
            begin_contact(s.bodies, s.islands, s.events, s.fields, s.settings, c, start.normal);
            std::vector<Uncolored>& uncolored = s.narrow.uncolored;
            uncolored.push_back({0, none, std::uint32_t(uncolored.size()), id});
        } else if (asleep) {
            wake_body(s.bodies, s.islands, s.events, c.body_a);
        }
        if (!c.b_moves && moves(s.bodies, c.body_b)) s.islands.all[s.bodies.links[c.body_a].island].kept_awake = 1;
    }
    s.solved.push_back(id);
}

void color_begun(Bodies& bodies, Contacts& contacts, NarrowScratch& narrow) {
    std::vector<Uncolored>& begun = narrow.uncolored;
    for (Uncolored& u : begun) {
        const ContactInfo& c = contacts.info[u.contact];
        u.island = bodies.links[c.body_a].island;
        u.key = std::uint64_t(c.shape_a) << 32 | c.shape_b;
    }
    std::sort(begun.begin(), begun.end(), [](const Uncolored& a, const Uncolored& b) {
        return std::tie(a.island, a.key, a.order) < std::tie(b.island, b.key, b.order);
    });
    std::uint64_t rank = 0;
    for (std::size_t i = 0; i < begun.size(); ++i) {
        rank = i > 0 && begun[i].island == begun[i - 1].island ? rank + 1 : 0;
        Hash64 shuffled;
        shuffled.add(rank);
        begun[i].key = shuffled.value();
    }
    std::sort(begun.begin(), begun.end(), [](const Uncolored& a, const Uncolored& b) { return a.key < b.key; });
    for (const Uncolored& u : begun)
        if (ContactInfo& c = contacts.info[u.contact]; c.in_use && c.point_count > 0 && c.color == no_color)
            assign_color(bodies, c);
    begun.clear();
}

// The solver would have nothing to do for such contacts, which are up to half of all while a heap lands.
bool stays_apart(const Bodies& bodies, const Shapes& shapes, const ContactInfo& c, const Manifold& m, float dt) {
    if (m.count == 0) return true;
    if (c.is_trigger) return false;
    const float least = least_separation(m);
    if (least <= c.base_margin) return false;
    const std::int32_t first = c.flipped ? c.body_b : c.body_a, second = c.flipped ? c.body_a : c.body_b;
    const BodyMotion &a = bodies.motion[first], &b = bodies.motion[second];
    const float speed = std::max(approach_of(bodies, shapes, c, m), 0.0f);
    // How far the path of a point may bend because of rotation, beyond its present speed.
    const auto bend = [&](const BodyMotion& body, float radius) {
        const float turn = predicted_rotation(dt * math::length(body.w));
        return 0.5f * turn * turn * radius;
    };
    const float more = bend(a, bodies.links[first].radius) + bend(b, bodies.links[second].radius);
    return least > c.base_margin + dt * (speed + redirected * math::length(b.v - a.v)) + more;
}

std::uint8_t take_distance(const Bodies& bodies, Contacts& contacts, std::uint32_t id, float distance) {
    ContactInfo& c = contacts.info[id];
    const bool is_known = distance > c.base_margin && distance < unused && has_distance(c.kind);
    keep_separation(bodies, contacts, id, is_known ? double(distance - c.base_margin) : 0.0);
    if (c.is_trigger) return trigger_outcome(c, false);
    return c.point_count == 0 && !c.touching ? apart : ended;
}

std::uint8_t take_apart(const Bodies& bodies, Contacts& contacts, std::uint32_t id, const Manifold& m) {
    // The normal along which the shapes are separated; wide kernels do not give it.
    const ContactInfo& c = contacts.info[id];
    if (c.kind == PairKind::convex_convex && !c.is_trigger) math::put(contacts.records[id].normal, to_vec(m.normal));
    return take_distance(bodies, contacts, id, m.count == 0 ? m.points[0][3] : 0.0f);
}

namespace {

// The moment of a touch for the solver, which extrapolates with the velocities of the start of the step: the time at
// which these give the displacement along the normal that the shapes have at their touch, gravity included.
Moment moment_of(const Bodies& bodies, const ContactInfo& c, const Touch& touch, const Manifold& m) {
    const math::DVec3 n = math::to_double(to_vec(m.normal));
    const double speed = math::dot(n, math::to_double(bodies.motion[c.body_a].v - bodies.motion[c.body_b].v));
    const double time = math::dot(n, touch.passed) / speed, found = double(touch.moment.time);
    Moment moment = touch.moment;
    moment.pose_a = &touch.pose_a, moment.pose_b = &touch.pose_b;
    if (time > 0.5 * found && time < 2 * found) moment.time = float(time);
    return moment;
}

} // namespace

std::uint8_t take_manifold(const Bodies& bodies, const Shapes& shapes, Contacts& contacts, const Islands& islands,
                           std::uint32_t id, const Manifold& m, const Touch* touch) {
    ContactInfo& c = contacts.info[id];
    if (m.count == 0) return take_apart(bodies, contacts, id, m);
    if (c.is_trigger) {
        keep_separation(bodies, contacts, id, 0);
        return trigger_outcome(c, true);
    }
    if (touch)
        forget_separation(bodies, contacts, id);
    else
        keep_separation(bodies, contacts, id, 0);
    return take_points(bodies, shapes, contacts, islands, id, m,
                       touch ? moment_of(bodies, c, *touch, m) : moment_of_start(bodies, shapes, c));
}

std::uint8_t trigger_outcome(const ContactInfo& c, bool inside) {
    if (inside == (c.touching != 0)) return apart;
    return inside ? entered : left;
}

void end_contact(Bodies& bodies, const Shapes& shapes, Contacts& contacts, Islands& islands, StepEvents& events,
                 std::uint32_t id) {
    ContactInfo& c = contacts.info[id];
    if (c.is_trigger) {
        if (c.touching) note_trigger(bodies, shapes, events, c, false);
        return;
    }
    if (is_group(c)) {
        for_each_patch(contacts, id,
                       [&](std::uint32_t patch) { end_patch(bodies, shapes, contacts, islands, events, patch); });
        return;
    }
    if (c.point_count > 0) {
        release_contact(bodies, c);
        c.point_count = 0;
        const std::int32_t island = bodies.links[c.body_a].island;
        if (island != none) islands.all[island].lost_contact |= c.b_moves;
    }
    if (c.touching) end_touch(bodies, shapes, contacts, events, c); // also a touch that an impact began (impacts/)
}

namespace {

// A contact has begun to touch. `separation`: at the start of the step. `told`: what the owner of its record reports;
// null: the record is here.
void begin_touch(const Bodies& bodies, const Shapes& shapes, Contacts& contacts, StepEvents& events,
                 const WorldDef& settings, std::uint32_t id, float separation, const TouchPoint* told, float dt) {
    ContactInfo& c = contacts.info[id];
    c.touching = 1;
    if (pair_touches_elsewhere(contacts, c)) return;
    const ShapeId a = shapes.slots.id(c.shape_a), b = shapes.slots.id(c.shape_b);
    const BodyId body_a = bodies.id(c.body_a), body_b = bodies.id(c.body_b);
    events.begins.push_back({a, b, body_a, body_b});
    const TouchPoint touch = told ? *told : touch_point_of(contacts, id);
    if (touch.approach_speed < settings.hit_speed) return;
    const math::DVec3 p = bodies.motion[c.body_a].x + math::to_double(touch.arm);
    const float until_touch = separation > 0 ? std::min(separation / touch.approach_speed, dt) : 0.0f;
    const math::Vec3 n = touch.normal;
    events.hits.push_back({a,
                           b,
                           body_a,
                           body_b,
                           {p.x, p.y, p.z},
                           {n.x, n.y, n.z},
                           touch.approach_speed,
                           until_touch,
                           c.surface_material});
}

// Whether a contact has begun or ceased to touch in this step.
bool begins_or_ends(const ContactInfo& c, const ContactReport& report) {
    if (!c.touching) return report.separation <= 0 || report.impulse > 0;
    return report.impulse == 0 && report.separation > 0.25f * c.base_margin;
}

} // namespace

TouchPoint touch_point_of(const Contacts& contacts, std::uint32_t id) {
    const ContactRecord& r = contacts.records[id];
    int deepest = 0;
    for (int i = 1; i < contacts.info[id].point_count; ++i)
        if (point_of(r, i)[3] < point_of(r, deepest)[3]) deepest = i;
    return {id, r.approach_speed, to_vec(r.normal), to_vec(point_of(r, deepest))};
}

float report_contacts(const Bodies& bodies, const Shapes& shapes, Contacts& contacts, Islands& islands,
                      StepEvents& events, const WorldDef& settings, const SolverScratch& solver, NarrowScratch& narrow,
                      ThreadPool& thread_pool, Communicator* ranks, float dt) {
    float deepest = 0; // raised by all threads
    const std::vector<SortedContact>& solved = solver.of_batches;
    std::vector<std::uint8_t>& changes = narrow.changes;
    set_size_anew(changes, solved.size());
    const float gain = load_gain(dt);
    thread_pool.for_chunks(int(solved.size()), reports_per_chunk, [&](int begin, int end, int) {
        // Writes of bytes may alias anything, so without local copies the compiler would reload the pointers after
        // each.
        ContactInfo* const info = contacts.info.data();
        Island* const all = islands.all.data();
        const ContactReport* const reports = solver.reports.data();
        const SortedContact* const list = solved.data();
        std::uint8_t* const change = changes.data();
        float own = 0;
        for (int k = begin; k < end; ++k) {
            constexpr int ahead = 2 * int(contacts_ahead);
            if (k + ahead < end) {
                const std::uint32_t next = list[k + ahead].id;
                prefetch(&info[next]);
                prefetch(&reports[next]);
            }
            const ContactReport& report = reports[list[k].id];
            // Non-finite impulses (of bodies that were stopped for exceeding the number range) must not warm start the
            // next step.
            const bool is_finite = std::isfinite(report.impulse);
            ContactInfo& c = info[list[k].id];
            if (!is_finite && contacts.records.has(list[k].id))
                forget_impulses(contacts.records[list[k].id], c.point_count);
            note_load(all[list[k].island], c, is_finite ? report.impulse / dt : 0, report.inverse_mass, gain);
            change[k] = begins_or_ends(c, report);
            own = std::max(own, -report.separation);
        }
        raise(deepest, own);
    });
    const std::uint8_t* const end = changes.data() + changes.size();
    const auto next_change = [&](const std::uint8_t* from) { return std::find(from, end, 1); };
    const TouchPoint* told = ranks ? exchange_touches(contacts, solver, narrow, *ranks) : nullptr;
    for (const std::uint8_t* at = next_change(changes.data()); at != end; at = next_change(at + 1)) {
        const std::uint32_t id = solved[std::size_t(at - changes.data())].id;
        ContactInfo& c = contacts.info[id];
        if (c.touching)
            end_touch(bodies, shapes, contacts, events, c);
        else
            begin_touch(bodies, shapes, contacts, events, settings, id, solver.reports[id].separation,
                        told ? told++ : nullptr, dt);
    }
    return deepest;
}

} // namespace cairn
