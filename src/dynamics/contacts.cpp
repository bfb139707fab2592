// The narrow phase.
#include "dynamics/contacts.h"

#include "dynamics/bodies.h"
#include "dynamics/coloring.h"
#include "dynamics/islands.h"
#include "dynamics/rest.h"
#include "dynamics/solver.h"

#include <algorithm>
#include <cstring>

namespace cairn {

namespace {

constexpr float unused = 1e30f;
constexpr float most_turn = 0.25f; // of the radius: how far ahead a rotation is looked at

math::Vec3 to_vec(const float* p) { return {p[0], p[1], p[2]}; }
void put(float* p, math::Vec3 v) { p[0] = v.x, p[1] = v.y, p[2] = v.z; }

bool moves(const State& s, std::int32_t body) {
    const BodyMotion& m = s.motion[std::size_t(body)];
    return !(m.v == math::Vec3{} && m.w == math::Vec3{});
}

// How far apart two shapes may be to count: what the next step can close.
float contact_margin(const State& s, const ContactInfo& c, float dt) {
    const BodyMotion &a = s.motion[std::size_t(c.body_a)], &b = s.motion[std::size_t(c.body_b)];
    const float ra = s.bodies[std::size_t(c.body_a)].radius, rb = s.bodies[std::size_t(c.body_b)].radius;
    const math::Vec3 v = b.v - a.v;
    const float turn =
        std::min(dt * math::length(a.w), most_turn) * ra + std::min(dt * math::length(b.w), most_turn) * rb;
    return c.base_margin + dt * math::length(v) + turn;
}

// The greatest speed at which the points of a record approach.
float approach_speed(const State& s, const ContactInfo& c, const ContactRecord& r) {
    const BodyMotion &a = s.motion[std::size_t(c.body_a)], &b = s.motion[std::size_t(c.body_b)];
    const math::Vec3 n = to_vec(r.normal), d = to_vec(r.center_offset);
    float speed = 0;
    for (int i = 0; i < c.point_count; ++i) {
        const math::Vec3 arm = to_vec(r.points[i]);
        const math::Vec3 v = (b.v + math::cross(b.w, arm + d)) - (a.v + math::cross(a.w, arm));
        speed = std::max(speed, -math::dot(n, v));
    }
    return speed;
}

float least_separation(const ContactInfo& c, const ContactRecord& r) {
    float least = unused;
    for (int i = 0; i < c.point_count; ++i) least = std::min(least, r.points[i][3]);
    return least;
}

// What is kept of a contact's last step to warm start the next.
struct OldPoints {
    int count;
    math::Vec3 normal, arm[4], friction;
    float impulse[4], torsion;
};

// Gives the new points the impulses of the old ones at the same places in A's frame. What the old points without a
// successor carried is shared among the new ones without a predecessor: otherwise a contact that changes from four
// points to one lets its load drop for a substep, and a heap never comes to rest.
void match_points(const OldPoints& old, float tolerance, int count, ContactRecord& r) {
    const float limit = tolerance * tolerance;
    unsigned taken = 0, unmatched = 0;
    auto square_distance = [&](int i, int k) {
        const math::Vec3 e = to_vec(r.points[i]) - old.arm[k];
        return math::dot(e, e);
    };
    for (int i = 0; i < count; ++i) {
        int match = -1;
        // Mostly the order stays as well.
        if (i < old.count && !(taken & (1u << i)) && square_distance(i, i) < 0.0625f * limit) {
            match = i;
        } else {
            float nearest = limit;
            for (int k = 0; k < old.count; ++k) {
                const float square = square_distance(i, k);
                if (square < nearest && !(taken & (1u << k))) nearest = square, match = k;
            }
        }
        if (match < 0) {
            unmatched |= 1u << i;
            continue;
        }
        taken |= 1u << match;
        r.impulses[i] = old.impulse[match];
    }
    if (unmatched != 0 && math::dot(old.normal, to_vec(r.normal)) > 0.7f) {
        float left = 0;
        for (int k = 0; k < old.count; ++k)
            if (!(taken & (1u << k))) left += old.impulse[k];
        left /= float(__builtin_popcount(unmatched));
        for (int i = 0; i < count; ++i)
            if (unmatched & (1u << i)) r.impulses[i] = left;
        taken |= 1;
    }
    if (taken == 0) return;
    put(r.friction_impulse, old.friction);
    r.torsion_impulse = old.torsion;
}

OldPoints old_points(const ContactRecord& r, int count, math::Quat turned) {
    OldPoints old;
    old.count = count;
    old.normal = to_vec(r.normal);
    old.friction = to_vec(r.friction_impulse);
    old.torsion = r.torsion_impulse;
    for (int k = 0; k < count; ++k) {
        old.arm[k] = math::rotate(turned, to_vec(r.points[k]));
        old.impulse[k] = r.impulses[k];
    }
    return old;
}

void forget_impulses(ContactRecord& r) {
    for (int i = 0; i < 4; ++i) r.impulses[i] = r.total_impulses[i] = 0;
    put(r.friction_impulse, {});
    put(r.total_friction, {});
    r.torsion_impulse = 0;
}

void end_touch(State& s, ContactInfo& c) {
    c.touching = 0;
    s.next_ends.push_back({s.shape_id(c.shape_a), s.shape_id(c.shape_b), s.body_id(c.body_a), s.body_id(c.body_b)});
}

// Four floats side by side: a point and its separation.
using Float4 = float __attribute__((vector_size(16)));
Float4 load4(const float* p) {
    Float4 v;
    std::memcpy(&v, p, sizeof(v));
    return v;
}
void store4(float* p, Float4 v) { std::memcpy(p, &v, sizeof(v)); }

// Whether each point is where the old one of the same number is, in A's frame: then all impulses stay as they are.
// That is the common case, and this its short way.
bool points_stay(const ContactRecord& r, const Float4* points, const math::Mat3& turned, float tolerance) {
    const Float4 x = {turned.c0.x, turned.c0.y, turned.c0.z}, y = {turned.c1.x, turned.c1.y, turned.c1.z},
                 z = {turned.c2.x, turned.c2.y, turned.c2.z};
    float greatest = 0;
    for (int i = 0; i < 4; ++i) {
        const float* old = r.points[i];
        const Float4 difference = points[i] - (old[0] * x + old[1] * y + old[2] * z), square = difference * difference;
        greatest = std::max(greatest, square[0] + square[1] + square[2]);
    }
    return greatest < 0.0625f * tolerance * tolerance;
}

// From a sphere's center to the point midway between the surfaces; 0 for other shapes.
float contact_radius(const State& s, std::uint32_t shape, float separation) {
    const Geometry& g = s.geometry[shape];
    return g.type == ShapeType::sphere ? g.size.x + 0.5f * separation : 0.0f;
}

void write_record(State& s, std::uint32_t id, const Manifold& m) {
    ContactInfo& c = s.contacts[id];
    ContactRecord& r = s.records[id];
    math::Vec3 normal = to_vec(m.normal), offset = s.shapes[c.shape_a].arm;
    if (c.flipped) {
        const ShapePose &a = s.shape_poses[c.shape_a], &b = s.shape_poses[c.shape_b];
        offset = offset - ((to_vec(a.high) - to_vec(b.high)) + (to_vec(a.low) - to_vec(b.low)));
        normal = -normal;
    }
    Float4 points[4];
    for (int i = 0; i < 4; ++i)
        points[i] = i < m.count ? load4(m.points[i]) + Float4{offset.x, offset.y, offset.z} : Float4{0, 0, 0, unused};
    const math::Quat turned = s.turned[std::size_t(c.body_a)];
    const bool stay = m.count == c.point_count && points_stay(r, points, math::to_matrix(turned), c.match_tolerance);
    OldPoints old;
    if (!stay) old = old_points(r, c.point_count, turned);
    put(r.normal, normal);
    put(r.center_offset, math::to_float(s.motion[std::size_t(c.body_a)].x - s.motion[std::size_t(c.body_b)].x));
    for (int i = 0; i < 4; ++i) store4(r.points[i], points[i]);
    if (c.kind <= PairKind::sphere_rectangle) {
        r.radius_a = contact_radius(s, c.shape_a, m.points[0][3]);
        r.radius_b = contact_radius(s, c.shape_b, m.points[0][3]);
    }
    c.point_count = std::uint8_t(m.count);
    if (stay) return;
    forget_impulses(r);
    if (old.count > 0) match_points(old, c.match_tolerance, m.count, r);
}

void begin_contact(State& s, ContactInfo& c, math::Vec3 normal) {
    if (c.b_moves)
        link_islands(s, c.body_a, c.body_b);
    else
        wake_island(s, s.bodies[std::size_t(c.body_a)].island);
    assign_color(s, c);
    c.load = c.force = first_load(s, c, normal);
}

// One result of a kernel.
void take_manifold(State& s, std::uint32_t id, const Manifold& m, float dt) {
    ContactInfo& c = s.contacts[id];
    c.tested_at = s.passes + 1;
    if (m.count == 0) {
        end_contact(s, id);
        return;
    }
    const bool is_new = c.point_count == 0;
    write_record(s, id, m);
    ContactRecord& r = s.records[id];
    const float speed = c.touching ? 0 : approach_speed(s, c, r);
    if (!c.touching) r.approach_speed = speed;
    const bool asleep = !s.is_awake(c.body_a) || (c.b_moves && !s.is_awake(c.body_b));
    // Passing by is not enough to wake what sleeps: only what will touch it within the step does.
    if (is_new && asleep && least_separation(c, r) > dt * speed) {
        c.point_count = 0;
        c.tested_at = 0; // no answer that could be kept
        return;
    }
    if (is_new)
        begin_contact(s, c, to_vec(r.normal));
    else if (asleep)
        wake_body(s, c.body_a);
    if (!c.b_moves && moves(s, c.body_b)) s.islands[std::size_t(s.bodies[std::size_t(c.body_a)].island)].kept_awake = 1;
    s.solved.push_back(id);
}

void run_batch(State& s, int kind, float dt) {
    PairBatch& batch = s.narrow.batches[std::size_t(kind)];
    if (batch.count == 0) return;
    const int padded = (batch.count + 7) & ~7;
    for (int i = batch.count; i < padded; ++i)
        batch.first[i] = batch.first[0], batch.second[i] = batch.second[0], batch.margin[i] = batch.margin[0];
    Manifold* out = s.narrow.manifolds.data();
    pair_kernel(kind)(s.shape_poses.data(), batch.first, batch.second, batch.margin, padded, out);
    const int count = batch.count;
    batch.count = 0;
    constexpr int ahead = 6;
    for (int i = 0; i < count; ++i) {
        if (i + ahead < count) {
            const char* record = reinterpret_cast<const char*>(&s.records[batch.contact[i + ahead]]);
            for (std::size_t at = 0; at < sizeof(ContactRecord); at += 64) __builtin_prefetch(record + at);
            __builtin_prefetch(&s.contacts[batch.contact[i + ahead]]);
        }
        take_manifold(s, batch.contact[i], out[i], dt);
    }
}

} // namespace

void end_contact(State& s, std::uint32_t id) {
    ContactInfo& c = s.contacts[id];
    if (c.point_count == 0) return;
    release_color(s, c);
    c.point_count = 0;
    const std::int32_t island = s.bodies[std::size_t(c.body_a)].island;
    if (island != none) s.islands[std::size_t(island)].lost_contact |= c.b_moves;
    if (c.touching) end_touch(s, c);
}

void update_contacts(State& s, float dt) {
    update_resting(s, dt);
    s.solved.clear();
    s.narrow.skipped.clear();
    s.narrow.batches.resize(pair_kinds);
    s.narrow.manifolds.resize(PairBatch::capacity);
    s.broad_phase.for_each_pair([&](std::uint32_t, std::uint32_t, std::uint32_t id) {
        const ContactInfo& c = s.contacts[id];
        if (!c.b_moves && !s.is_awake(c.body_a) && !moves(s, c.body_b)) {
            if (c.point_count > 0) s.narrow.skipped.push_back(id);
            return;
        }
        if (is_tested(s, c)) {
            if (c.point_count > 0) s.solved.push_back(id);
            return;
        }
        PairBatch& batch = s.narrow.batches[std::size_t(c.kind)];
        batch.first[batch.count] = c.flipped ? c.shape_b : c.shape_a;
        batch.second[batch.count] = c.flipped ? c.shape_a : c.shape_b;
        batch.contact[batch.count] = id;
        batch.margin[batch.count] = contact_margin(s, c, dt);
        if (++batch.count == PairBatch::capacity) run_batch(s, int(c.kind), dt);
    });
    for (int kind = 0; kind < pair_kinds; ++kind) run_batch(s, kind, dt);
    // Islands that were woken just now: nothing in them has moved, their records still hold.
    for (const std::int32_t key : s.waking)
        s.broad_phase.for_each_sleeping_pair(std::uint32_t(key), [&](std::uint32_t, std::uint32_t, std::uint32_t id) {
            if (s.contacts[id].point_count > 0) s.solved.push_back(id);
        });
    for (const std::uint32_t id : s.narrow.skipped)
        if (s.is_awake(s.contacts[id].body_a)) s.solved.push_back(id);
}

void report_contacts(State& s, float dt) {
    Statistics& statistics = s.statistics;
    statistics.max_penetration = 0;
    for (const std::uint32_t id : s.solved) {
        ContactInfo& c = s.contacts[id];
        const float separation = s.solver.reports[id].separation, impulse = s.solver.reports[id].impulse;
        // Impulses beyond the range of numbers (of bodies that were stopped for it) must not start the next step.
        if (!std::isfinite(impulse)) forget_impulses(s.records[id]);
        statistics.max_penetration = std::max(statistics.max_penetration, double(-separation));
        note_load(s, c, std::isfinite(impulse) ? impulse / dt : 0);
        if (!c.touching && (separation <= 0 || impulse > 0)) {
            c.touching = 1;
            const ShapeId a = s.shape_id(c.shape_a), b = s.shape_id(c.shape_b);
            const BodyId body_a = s.body_id(c.body_a), body_b = s.body_id(c.body_b);
            s.begins.push_back({a, b, body_a, body_b});
            const ContactRecord& r = s.records[id];
            if (r.approach_speed >= s.settings.hit_speed) {
                int deepest = 0;
                for (int i = 1; i < c.point_count; ++i)
                    if (r.points[i][3] < r.points[deepest][3]) deepest = i;
                const ContactRecord now = advanced_record(s, id);
                const math::DVec3 p = s.motion[std::size_t(c.body_a)].x + math::to_double(to_vec(now.points[deepest]));
                s.hits.push_back(
                    {a, b, body_a, body_b, {p.x, p.y, p.z}, {r.normal[0], r.normal[1], r.normal[2]}, r.approach_speed});
            }
        } else if (c.touching && impulse == 0 && separation > 0.25f * c.base_margin) {
            end_touch(s, c);
        }
    }
}

ContactRecord advanced_record(const State& s, std::uint32_t id) {
    const ContactInfo& c = s.contacts[id];
    ContactRecord r = s.records[id];
    const math::Vec3 n = to_vec(r.normal), d = to_vec(r.center_offset);
    const math::Quat qa = s.turned[std::size_t(c.body_a)], qb = s.turned[std::size_t(c.body_b)];
    const math::Vec3 offset = math::to_float(s.motion[std::size_t(c.body_a)].x - s.motion[std::size_t(c.body_b)].x);
    for (int i = 0; i < c.point_count; ++i) {
        const math::Vec3 arm = to_vec(r.points[i]);
        const math::Vec3 now_a = math::rotate(qa, arm), now_b = math::rotate(qb, arm + d);
        // Anchors that were one point: how far they have come apart, B's relative to A's.
        r.points[i][3] += math::dot(n, now_b - offset - now_a);
        put(r.points[i], 0.5f * (now_a + (now_b - offset))); // midway between the two
    }
    put(r.center_offset, offset);
    return r;
}

} // namespace cairn
