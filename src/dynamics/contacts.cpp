// The narrow phase.
#include "dynamics/contacts.h"

#include "collision/far_apart.h"
#include "core/cache.h"
#include "dynamics/bodies.h"
#include "dynamics/coloring.h"
#include "dynamics/islands.h"
#include "dynamics/rest.h"
#include "dynamics/solver.h"

#include <algorithm>
#include <atomic>

namespace cairn {

using math::to_vec;

namespace {

constexpr float unused = 1e30f;
constexpr int pairs_per_chunk = 512, reports_per_chunk = 512; // for threads
constexpr int convex_pairs_per_chunk = 32, groups_per_chunk = 8, moved_pairs_per_chunk = 128;

bool moves(const State& s, std::int32_t body) {
    const BodyMotion& m = s.motion[std::size_t(body)];
    return !(m.v == math::Vec3{} && m.w == math::Vec3{});
}

constexpr float little_turn = 0.1f; // rad in a pass: contacts may be moved along
// Of the relative speed: what hits others in the step may come to move in any direction. Without it, boxes in a closed
// box gain 6 % of energy instead of 4 % (validation, closed_pile).
constexpr float redirected = 0.5f;

// The greatest speed at which points approach along the normal n from a to b. arm_of(i): from the center of a to a
// point; d: from that of b to that of a.
template <class F>
float greatest_approach(const BodyMotion& a, const BodyMotion& b, math::Vec3 n, math::Vec3 d, int count, F&& arm_of) {
    float speed = 0;
    for (int i = 0; i < count; ++i) {
        const math::Vec3 arm = arm_of(i);
        const math::Vec3 v = (b.v + math::cross(b.w, arm + d)) - (a.v + math::cross(a.w, arm));
        speed = std::max(speed, -math::dot(n, v));
    }
    return speed;
}

// Of the points of a record.
float approach_speed(const State& s, const ContactInfo& c, const ContactRecord& r) {
    const BodyMotion &a = s.motion[std::size_t(c.body_a)], &b = s.motion[std::size_t(c.body_b)];
    return greatest_approach(a, b, to_vec(r.normal), to_vec(r.center_offset), c.point_count,
                             [&](int i) { return to_vec(point_of(r, i)); });
}

void note_trigger(State& s, ContactInfo& c, bool inside) {
    c.touching = inside;
    const bool a_is_trigger = s.shape_traits[c.shape_a].is_trigger;
    const std::uint32_t trigger = a_is_trigger ? c.shape_a : c.shape_b, other = a_is_trigger ? c.shape_b : c.shape_a;
    s.next_triggers.push_back({s.shape_id(trigger), s.shape_id(other), s.body_id(s.shapes[trigger].body),
                               s.body_id(s.shapes[other].body), inside});
}

// Whether another patch of the same pair touches.
bool pair_touches_elsewhere(const State& s, const ContactInfo& c) {
    if (c.kind != PairKind::patch) return false;
    for (std::int32_t p = s.contacts[std::size_t(c.related)].related; p != none; p = s.contacts[std::size_t(p)].next)
        if (&s.contacts[std::size_t(p)] != &c && s.contacts[std::size_t(p)].touching) return true;
    return false;
}

void end_touch(State& s, ContactInfo& c) {
    c.touching = 0;
    if (pair_touches_elsewhere(s, c)) return;
    s.next_ends.push_back({s.shape_id(c.shape_a), s.shape_id(c.shape_b), s.body_id(c.body_a), s.body_id(c.body_b)});
}

void begin_contact(State& s, ContactInfo& c, math::Vec3 normal) {
    if (c.b_moves)
        link_islands(s, c.body_a, c.body_b);
    else
        wake_island(s, s.bodies[std::size_t(c.body_a)].island);
    assign_color(s, c);
    c.load = c.force = first_load(s, c, normal);
}

// Planes have no end.
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

bool is_asleep(const State& s, const ContactInfo& c) {
    return !s.is_awake(c.body_a) || (c.b_moves && !s.is_awake(c.body_b));
}

// The outcome of a contact that stays.
std::uint8_t going_on(const State& s, const ContactInfo& c) {
    return is_asleep(s, c) || (!c.b_moves && moves(s, c.body_b)) ? may_wake : goes_on;
}

// Up to PairBatch::capacity pairs of one kind, by their places among all.
void test_wide_pairs(State& s, PairKind kind, int begin, int end, NarrowBatch& own, float dt) {
    PairBatch& batch = own.pairs;
    const int count = end - begin, padded = (count + 7) & ~7;
    const std::size_t record_size = has_one_point(kind) ? offsetof(ContactRecord, more_points) : sizeof(ContactRecord);
    const bool keeps_features = kind == PairKind::box_box;
    const std::uint32_t* places = s.narrow.lists[std::size_t(kind)].data() + begin;
    std::uint32_t ids[PairBatch::capacity];
    for (int i = 0; i < count; ++i) ids[i] = s.narrow.candidates[places[i]];
    for (int i = 0; i < count; ++i) {
        if (const int next = i + int(contacts_ahead); next < count) {
            ask_cache(&s.contacts[ids[next]]);
            if (keeps_features) ask_cache(&s.records[ids[next]].features);
        }
        const ContactInfo& c = s.contacts[ids[i]];
        batch.first[i] = c.flipped ? c.shape_b : c.shape_a;
        batch.second[i] = c.flipped ? c.shape_a : c.shape_b;
        batch.margin[i] = contact_margin(s, c, dt);
        batch.kept[i] = keeps_features && c.force > 0 ? s.records[ids[i]].features : no_features;
        ask_cache(&s.shapes[c.shape_a]); // for write_record
    }
    for (int i = count; i < padded; ++i) {
        batch.first[i] = batch.first[0], batch.second[i] = batch.second[0];
        batch.margin[i] = batch.margin[0], batch.kept[i] = batch.kept[0];
    }
    wide_kernel(kind)(s.shape_poses.data(), batch.first, batch.second, batch.margin, batch.kept, padded, own.manifolds);
    for (int i = 0; i < count; ++i) {
        if (const int next = i + int(contacts_ahead); next < count && own.manifolds[next].count > 0) {
            prefetch_record(s, ids[next], record_size);
            if (may_be_round(kind))
                for (const std::uint32_t shape : {batch.first[next], batch.second[next]}) ask_cache(&s.geometry[shape]);
        }
        s.narrow.outcomes[places[i]] = take_manifold(s, ids[i], own.manifolds[i], dt);
    }
}

// Pairs that no wide kernel tests, by their places among all.
void test_convex_pairs(State& s, PairKind kind, int begin, int end, float dt) {
    const std::vector<std::uint32_t>& places = s.narrow.lists[std::size_t(kind)];
    constexpr int ahead = int(contacts_ahead);
    const int count = int(places.size()); // the next chunk begins at once
    const auto contact_at = [&](int i) { return s.narrow.candidates[places[std::size_t(i)]]; };
    for (int i = begin; i < end; ++i) {
        if (i + 2 * ahead < count) ask_cache(&s.contacts[contact_at(i + 2 * ahead)]);
        if (i + ahead < count) prefetch_pair(s, contact_at(i + ahead));
        const std::uint32_t place = places[std::size_t(i)], id = s.narrow.candidates[place];
        const ContactInfo& c = s.contacts[id];
        const PosedShape a = posed_shape(s, c.shape_a), b = posed_shape(s, c.shape_b);
        const float margin = contact_margin(s, c, dt);
        if (kind == PairKind::convex_convex && c.point_count == 0) {
            const float distance = least_distance(a.geometry, a.pose, b.geometry, b.pose);
            if (distance > margin) {
                s.narrow.outcomes[place] = take_distance(s, id, distance);
                continue;
            }
        }
        ContactMemory memory = s.records[id].features;
        const Manifold m = test_convex_pair(kind, a, b, to_vec(s.records[id].normal), margin, memory);
        s.narrow.outcomes[place] = take_manifold(s, id, m, dt);
        if (kind == PairKind::convex_convex) s.records[id].features = memory; // also of those that are apart
    }
}

// Asks the cache for what moving the points of a pair along needs.
void prefetch_move(const State& s, std::uint32_t id) {
    const ContactInfo& c = s.contacts[id];
    for (const std::int32_t body : {c.body_a, c.body_b}) ask_cache(&s.motion[std::size_t(body)]);
    if (!is_group(c))
        prefetch_record(s, id, c.point_count > 1 ? sizeof(ContactRecord) : offsetof(ContactRecord, more_points));
}

// Pairs that were tested a short while ago, by their places among all.
void move_contacts(State& s, int begin, int end) {
    const std::vector<std::uint32_t>& places = s.narrow.to_move;
    const std::size_t count = places.size();
    const auto contact_at = [&](std::size_t i) { return s.narrow.candidates[places[i]]; };
    for (std::size_t i = std::size_t(begin); i < std::size_t(end); ++i) {
        if (i + 2 * contacts_ahead < count) ask_cache(&s.contacts[contact_at(i + 2 * contacts_ahead)]);
        if (i + contacts_ahead < count) prefetch_move(s, contact_at(i + contacts_ahead));
        for (int n = 0; n < patches_at_hand && s.narrow.any_groups; ++n)
            if (i + patch_ahead(n) < count) prefetch_patch(s, contact_at(i + patch_ahead(n)), n, true);
        const std::uint32_t id = contact_at(i);
        for_each_patch(s, id, [&](std::uint32_t contact) {
            ContactInfo& c = s.contacts[contact];
            ContactRecord& r = s.records[contact];
            advance_record(s, c, r);
            note_gap(c, r);
            if (!c.touching) r.approach_speed = approach_speed(s, c, r);
        });
        s.narrow.outcomes[places[std::size_t(i)]] = going_on(s, s.contacts[id]);
    }
}

} // namespace

void prefetch_record(const State& s, std::uint32_t id, std::size_t size) {
    const char* record = reinterpret_cast<const char*>(&s.records[id]);
    for (std::size_t at = 0; at < size; at += 64) ask_cache(record + at);
}

void prefetch_pair(const State& s, std::uint32_t id) {
    const ContactInfo& c = s.contacts[id];
    for (const std::uint32_t shape : {c.shape_a, c.shape_b}) {
        ask_cache(&s.shape_poses[shape]);
        ask_cache(&s.geometry[shape]);
        ask_cache(&s.geometry[shape].is_double_sided);
        ask_cache(&s.shape_data[shape]);
        ask_cache(&s.shapes[shape]);
    }
    for (const std::int32_t body : {c.body_a, c.body_b}) {
        ask_cache(&s.motion[std::size_t(body)].v);
        ask_cache(&s.bodies[std::size_t(body)].radius);
    }
    prefetch_record(s, id); // all of it: another thread may be about to say how many points there are
}

void prefetch_patch(const State& s, std::uint32_t id, int n, bool with_record) {
    if (!is_group(s.contacts[id])) return;
    std::int32_t patch = s.contacts[id].related;
    for (; n > 0 && patch != none; --n) patch = s.contacts[std::size_t(patch)].next;
    if (patch == none) return;
    ask_cache(&s.contacts[std::size_t(patch)]);
    if (with_record) prefetch_record(s, std::uint32_t(patch));
}

void follow_up(State& s, std::uint32_t id, std::uint8_t outcome, float dt) {
    if (outcome == apart) return;
    if (outcome == ended) {
        end_contact(s, id);
        return;
    }
    if (outcome == skipped) {
        s.narrow.skipped.push_back(id);
        return;
    }
    if (outcome == entered || outcome == left) {
        note_trigger(s, s.contacts[id], outcome == entered);
        return;
    }
    if (outcome != goes_on) {
        ContactInfo& c = s.contacts[id];
        const ContactRecord& r = s.records[id];
        const bool asleep = is_asleep(s, c);
        // Passing by is not enough to wake what sleeps: only what will touch it within the step does.
        if (outcome == begun && asleep && least_separation(c, r) > dt * r.approach_speed) {
            c.point_count = 0;
            c.tested_at = 0; // no answer that could be kept
            return;
        }
        if (outcome == begun)
            begin_contact(s, c, to_vec(r.normal));
        else if (asleep)
            wake_body(s, c.body_a);
        if (!c.b_moves && moves(s, c.body_b))
            s.islands[std::size_t(s.bodies[std::size_t(c.body_a)].island)].kept_awake = 1;
    }
    s.solved.push_back(id);
}

namespace {

// Whether the first pass of the step has tested the pair, as far as the whole step reaches, and its points may be moved
// along. What whirls is tested in each pass.
bool is_found(const State& s, const ContactInfo& c) {
    if (s.passes == s.first_pass || c.tested_at != s.first_pass + 1 || c.is_trigger) return false;
    const auto turns_little = [&](std::int32_t body) {
        const math::Quat q = s.motion[std::size_t(body)].turned; // in the last pass
        return !s.narrow.whirls[std::size_t(body)] &&
               4 * (q.x * q.x + q.y * q.y + q.z * q.z) < little_turn * little_turn;
    };
    return turns_little(c.body_a) && turns_little(c.body_b);
}

std::uint8_t before_test(const State& s, const ContactInfo& c) {
    if (!c.b_moves && !s.is_awake(c.body_a) && !moves(s, c.body_b)) return c.point_count > 0 ? skipped : apart;
    if (!is_tested(s, c)) {
        if (is_found(s, c)) return c.point_count > 0 ? to_move : apart;
        // What has no points is tested: they may come near each other on the way, the more so the larger they are.
        if (c.kind >= PairKind::box_capsule && c.point_count > 0 && is_near(s, c)) return to_move;
        return std::uint8_t(to_test + int(c.kind));
    }
    if (c.is_trigger) return apart;
    return c.point_count > 0 ? goes_on : apart;
}

// What stays apart, as most do, shows without the contact. Without a branch: none could guess. (Outcomes are bytes,
// which may be anything for the compiler: it would look up the arrays anew after each.)
void list_open_pairs(State& s) {
    NarrowScratch& scratch = s.narrow;
    const std::uint32_t* const candidates = scratch.candidates.data();
    const ApartPair* const pairs = s.apart_pairs.data();
    const double* const ahead = s.ahead.data();
    std::uint8_t* const outcomes = scratch.outcomes.data();
    s.crew->for_chunks(int(scratch.candidates.size()), pairs_per_chunk, [=](int begin, int end, int) {
        static_assert(apart == 0);
        const auto look_at = [=](int k) {
            outcomes[k] = std::uint8_t(to_test * int(!stays_apart(ahead, pairs[candidates[k]])));
        };
        constexpr int early = 2 * int(contacts_ahead);
        int k = begin;
        for (; k < end - early; ++k) {
            ask_cache(&pairs[candidates[k + early]]);
            look_at(k);
        }
        for (; k < end; ++k) look_at(k);
    });
    scratch.open.resize(scratch.candidates.size());
    std::uint32_t* const open = scratch.open.data();
    std::size_t count = 0;
    for (std::size_t k = 0; k < scratch.candidates.size(); ++k) {
        open[count] = std::uint32_t(k);
        count += outcomes[k] != apart;
    }
    scratch.open.resize(count);
}

// Sorts the pairs that may have moved into the lists of their kinds.
void list_pairs(State& s) {
    NarrowScratch& scratch = s.narrow;
    scratch.candidates.clear();
    s.broad_phase.for_each_pair(
        [&](std::uint32_t, std::uint32_t, std::uint32_t id) { scratch.candidates.push_back(id); });
    scratch.outcomes.resize(scratch.candidates.size());
    list_open_pairs(s);
    const std::size_t open = scratch.open.size();
    std::atomic<bool> any_groups = false;
    s.crew->for_chunks(int(open), pairs_per_chunk, [&](int begin, int end, int) {
        bool any = false;
        for (std::size_t i = std::size_t(begin); i < std::size_t(end); ++i) {
            if (i + contacts_ahead < std::size_t(end))
                ask_cache(&s.contacts[scratch.candidates[scratch.open[i + contacts_ahead]]]);
            const std::uint32_t k = scratch.open[i];
            const ContactInfo& c = s.contacts[scratch.candidates[k]];
            any |= is_group(c);
            scratch.outcomes[k] = before_test(s, c);
        }
        if (any) any_groups = true;
    });
    scratch.any_groups = any_groups;
    for (auto& list : scratch.lists) list.clear();
    scratch.to_move.clear();
    for (const std::uint32_t k : scratch.open) {
        const std::uint8_t outcome = scratch.outcomes[k];
        if (outcome >= to_test)
            scratch.lists[std::size_t(outcome - to_test)].push_back(k);
        else if (outcome == to_move)
            scratch.to_move.push_back(k);
    }
    s.statistics.tested_pairs = scratch.to_move.size();
    for (const auto& list : scratch.lists) s.statistics.tested_pairs += list.size();
}

} // namespace

// How far apart two shapes may be to count: what the next step can close. Triggers do not look ahead.
float contact_margin(const State& s, const ContactInfo& c, float dt) {
    if (c.is_trigger) return 0;
    const BodyMotion &a = s.motion[std::size_t(c.body_a)], &b = s.motion[std::size_t(c.body_b)];
    return c.base_margin + dt * math::length(b.v - a.v) +
           (s.narrow.turn_reach[std::size_t(c.body_a)] + s.narrow.turn_reach[std::size_t(c.body_b)]);
}

// Such contacts would have nothing to do in the solver: they are up to half of all while a heap lands.
bool stays_apart(const State& s, const ContactInfo& c, const Manifold& m, float dt) {
    if (c.is_trigger) return false;
    float least = m.points[0][3];
    for (int i = 1; i < m.count; ++i) least = std::min(least, m.points[i][3]);
    if (least <= c.base_margin) return false;
    const std::int32_t first = c.flipped ? c.body_b : c.body_a, second = c.flipped ? c.body_a : c.body_b;
    const BodyMotion &a = s.motion[std::size_t(first)], &b = s.motion[std::size_t(second)];
    const math::Vec3 center = s.shapes[c.flipped ? c.shape_b : c.shape_a].arm;
    const float speed = greatest_approach(a, b, to_vec(m.normal), math::to_float(a.x - b.x), m.count,
                                          [&](int i) { return center + to_vec(m.points[i]); });
    // What a rotation adds to the way of a point beyond its speed.
    const auto bend = [&](const BodyMotion& body, float radius) {
        const float turn = looked_ahead(dt * math::length(body.w));
        return 0.5f * turn * turn * radius;
    };
    const float more = bend(a, s.bodies[std::size_t(first)].radius) + bend(b, s.bodies[std::size_t(second)].radius);
    return least > c.base_margin + dt * (speed + redirected * math::length(b.v - a.v)) + more;
}

std::uint8_t take_distance(State& s, std::uint32_t id, float distance) {
    ContactInfo& c = s.contacts[id];
    c.tested_at = s.passes + 1;
    if (distance > c.base_margin && distance < unused && has_distance(c.kind))
        s.apart_pairs[id].until =
            (s.way[std::size_t(c.body_a)] + s.way[std::size_t(c.body_b)]) + double(distance - c.base_margin);
    if (c.is_trigger) return trigger_outcome(c, false);
    return c.point_count == 0 ? apart : ended;
}

std::uint8_t take_manifold(State& s, std::uint32_t id, const Manifold& m, float dt) {
    ContactInfo& c = s.contacts[id];
    if (m.count == 0 || stays_apart(s, c, m, dt)) {
        // Along which they are apart; wide kernels do not say.
        if (c.kind == PairKind::convex_convex && !c.is_trigger) math::put(s.records[id].normal, to_vec(m.normal));
        return take_distance(s, id, m.count == 0 ? m.points[0][3] : 0.0f);
    }
    c.tested_at = s.passes + 1;
    s.apart_pairs[id].until = 0;
    if (c.is_trigger) return trigger_outcome(c, true);
    const bool is_new = c.point_count == 0;
    write_record(s, id, m);
    ContactRecord& r = s.records[id];
    if (!c.touching) r.approach_speed = approach_speed(s, c, r);
    return is_new ? std::uint8_t(begun) : going_on(s, c);
}

std::uint8_t trigger_outcome(const ContactInfo& c, bool inside) {
    if (inside == (c.touching != 0)) return apart;
    return inside ? entered : left;
}

void end_contact(State& s, std::uint32_t id) {
    ContactInfo& c = s.contacts[id];
    if (c.is_trigger) {
        if (c.touching) note_trigger(s, c, false);
        return;
    }
    if (is_group(c)) {
        for_each_patch(s, id, [&](std::uint32_t patch) { end_patch(s, patch); });
        return;
    }
    if (c.point_count == 0) return;
    release_color(s, c);
    c.point_count = 0;
    const std::int32_t island = s.bodies[std::size_t(c.body_a)].island;
    if (island != none) s.islands[std::size_t(island)].lost_contact |= c.b_moves;
    if (c.touching) end_touch(s, c);
}

namespace {

void test_all(State& s, float dt) {
    const auto for_kind = [&](PairKind kind, int per_chunk, auto&& test) {
        s.crew->for_chunks(
            int(s.narrow.lists[std::size_t(kind)].size()), per_chunk,
            [&](int begin, int end, int thread) { test(begin, end, s.narrow.at_work[std::size_t(thread)]); });
    };
    for (int kind = 0; kind < wide_kinds; ++kind)
        for_kind(PairKind(kind), PairBatch::capacity, [&](int begin, int end, NarrowBatch& own) {
            test_wide_pairs(s, PairKind(kind), begin, end, own, dt);
        });
    for (const PairKind kind : {PairKind::convex_plane, PairKind::convex_rectangle, PairKind::convex_convex})
        for_kind(kind, convex_pairs_per_chunk,
                 [&](int begin, int end, NarrowBatch&) { test_convex_pairs(s, kind, begin, end, dt); });
    s.crew->for_chunks(int(s.narrow.to_move.size()), moved_pairs_per_chunk,
                       [&](int begin, int end, int) { move_contacts(s, begin, end); });
    begin_groups(s);
    for_kind(PairKind::group, groups_per_chunk,
             [&](int begin, int end, NarrowBatch& own) { test_groups(s, begin, end, own, dt); });
    collect_fresh_patches(s);
}

} // namespace

void update_contacts(State& s, float dt) {
    update_resting(s, dt);
    s.solved.clear();
    s.narrow.skipped.clear();
    s.narrow.lists.resize(tested_kinds);
    s.narrow.at_work.resize(std::size_t(s.crew->threads()));
    list_pairs(s);
    test_all(s, dt);
    const std::vector<std::uint32_t>& open = s.narrow.open;
    for (std::size_t i = 0; i < open.size(); ++i) {
        if (i + contacts_ahead < open.size() && s.narrow.outcomes[open[i + contacts_ahead]] != apart)
            ask_cache(&s.contacts[s.narrow.candidates[open[i + contacts_ahead]]]);
        for (int n = 0; n < patches_at_hand && s.narrow.any_groups; ++n)
            if (const std::size_t at = i + patch_ahead(n); at < open.size() && s.narrow.outcomes[open[at]] != apart)
                prefetch_patch(s, s.narrow.candidates[open[at]], n, false);
        const std::uint32_t k = open[i], id = s.narrow.candidates[k];
        if (s.narrow.outcomes[k] == apart) continue; // the contact need not be looked at
        if (is_group(s.contacts[id]))
            follow_up_group(s, k, dt);
        else if (s.narrow.outcomes[k] == goes_on) // as most do
            s.solved.push_back(id);
        else
            follow_up(s, id, s.narrow.outcomes[k], dt);
    }
    // What was moved along is as good as tested: while both bodies rest, it need not be moved again.
    for (const std::uint32_t k : s.narrow.to_move) s.contacts[s.narrow.candidates[k]].tested_at = s.passes + 1;
    drop_seams(s);
    const auto push_solved = [&](std::uint32_t id) {
        for_each_patch(s, id, [&](std::uint32_t contact) { s.solved.push_back(contact); });
    };
    // Islands that were woken just now: nothing in them has moved, their records still hold.
    for (const std::int32_t key : s.waking)
        s.broad_phase.for_each_sleeping_pair(std::uint32_t(key), [&](std::uint32_t, std::uint32_t, std::uint32_t id) {
            if (s.contacts[id].point_count > 0) push_solved(id);
        });
    for (const std::uint32_t id : s.narrow.skipped)
        if (s.is_awake(s.contacts[id].body_a)) push_solved(id);
}

namespace {

// The contact began to touch.
void begin_touch(State& s, std::uint32_t id) {
    ContactInfo& c = s.contacts[id];
    c.touching = 1;
    if (pair_touches_elsewhere(s, c)) return;
    const ShapeId a = s.shape_id(c.shape_a), b = s.shape_id(c.shape_b);
    const BodyId body_a = s.body_id(c.body_a), body_b = s.body_id(c.body_b);
    s.begins.push_back({a, b, body_a, body_b});
    const ContactRecord& r = s.records[id];
    if (r.approach_speed < s.settings.hit_speed) return;
    int deepest = 0;
    for (int i = 1; i < c.point_count; ++i)
        if (point_of(r, i)[3] < point_of(r, deepest)[3]) deepest = i;
    const ContactRecord now = advanced_record(s, id);
    const math::DVec3 p = s.motion[std::size_t(c.body_a)].x + math::to_double(to_vec(point_of(now, deepest)));
    s.hits.push_back(
        {a, b, body_a, body_b, {p.x, p.y, p.z}, {r.normal[0], r.normal[1], r.normal[2]}, r.approach_speed});
}

// Takes note of what a contact carried, and says whether it began or ceased to touch. Others may be at work on other
// contacts.
bool take_report(State& s, const SortedContact& sorted, float dt) {
    ContactInfo& c = s.contacts[sorted.id];
    const ContactReport& report = s.solver.reports[sorted.id];
    // Impulses beyond the range of numbers (of bodies that were stopped for it) must not start the next step.
    if (!std::isfinite(report.impulse)) forget_impulses(s.records[sorted.id], c.point_count);
    const float force = std::isfinite(report.impulse) ? report.impulse / dt : 0;
    note_load(s.islands[std::size_t(sorted.island)], c, force, report.inverse_mass);
    if (!c.touching) return report.separation <= 0 || report.impulse > 0;
    return report.impulse == 0 && report.separation > 0.25f * c.base_margin;
}

} // namespace

void report_contacts(State& s, float dt) {
    float deepest = 0; // raised by all threads
    std::vector<std::uint8_t>& changes = s.narrow.changes;
    changes.resize(s.contacts.size());
    const std::vector<SortedContact>& sorted = s.solver.sorted;
    s.crew->for_chunks(int(sorted.size()), reports_per_chunk, [&](int begin, int end, int) {
        float own = 0;
        for (std::size_t k = std::size_t(begin); k < std::size_t(end); ++k) {
            if (k + contacts_ahead < std::size_t(end)) {
                const std::uint32_t next = sorted[k + contacts_ahead].id;
                ask_cache(&s.contacts[next]);
                ask_cache(&s.solver.reports[next]);
            }
            const std::uint32_t id = sorted[k].id;
            changes[id] = take_report(s, sorted[k], dt);
            own = std::max(own, -s.solver.reports[id].separation);
        }
        raise(deepest, own);
    });
    s.statistics.max_penetration = double(deepest);
    for (const SortedContact& solved : s.solver.unsorted) {
        if (solved.is_left_out || !changes[solved.id]) continue;
        const std::uint32_t id = solved.id;
        ContactInfo& c = s.contacts[id];
        if (c.touching)
            end_touch(s, c);
        else
            begin_touch(s, id);
    }
}

} // namespace cairn
