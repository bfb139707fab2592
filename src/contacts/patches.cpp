#include "contacts/patches.h"

#include "bodies/motion_budget.h"
#include "contacts/contact_update.h"
#include "contacts/convex_tests.h"
#include "contacts/flight.h"
#include "contacts/midway.h"
#include "contacts/pairs.h"
#include "contacts/prefetch.h"
#include "contacts/record_owners.h"
#include "contacts/round_touch.h"
#include "contacts/touch.h"
#include "core/cache.h"
#include "islands/coloring.h"
#include "islands/islands.h"
#include "state/state.h"

#include <algorithm>

namespace cairn {

using math::to_vec;

namespace {

constexpr float same_patch = 0.9f;      // cosine: one patch may turn by up to this angle per step
constexpr float looked_ahead_steps = 3; // steps, for separated pairs
constexpr std::uint8_t not_found = 255; // in NarrowScratch::patch_outcomes

// The patch of a mesh contact whose last normal was nearest to that of the manifold, among the patches with the same
// material that no other manifold has matched yet.
std::int32_t matching_patch(const Contacts& contacts, const NarrowScratch& narrow, const ContactInfo& group,
                            const Manifold& m) {
    std::int32_t best = none;
    float nearest = same_patch;
    for (std::int32_t p = group.related; p != none; p = contacts.info[p].next) {
        if (narrow.patch_outcomes[p] != not_found || contacts.info[p].surface_material != surface_material_of(m))
            continue;
        const float cosine = math::dot(to_vec(m.normal), to_vec(contacts.records[p].normal));
        if (cosine > nearest) nearest = cosine, best = p;
    }
    return best;
}

// How far to search for triangles, m. A separated pair is not tested as long as its bodies travel no farther than that:
// searching as far as they come in several steps costs less than searching in each step.
float reach_of(const ContactInfo& group, float margin) {
    if (group.point_count > 0) return margin;
    return margin + looked_ahead_steps * std::max(margin - group.base_margin, 0.0f);
}

// Finds the patches of a mesh contact at the start of the step; returns a lower bound of the distance if there are
// none.
float find_at_start(const NarrowInput& in, const Contacts& contacts, const NarrowScratch& narrow,
                    const ContactInfo& group, float dt, NarrowBatch& own) {
    const float margin = contact_margin(narrow, group, dt);
    const PosedShape a = posed_shape(in.shapes, group.shape_a), b = posed_shape(in.shapes, group.shape_b);
    const float distance = find_patches(a, b, margin, reach_of(group, margin), own.surface, own.hits);
    const bool meets = touches(contacts, group);
    for (Manifold& hit : own.hits) drop_separated_points(in, group, meets, a, b, dt, hit);
    return distance;
}

// Lists the triangles of a patch.
void list_triangles(const SurfaceScratch& surface, std::size_t patch, std::vector<std::uint32_t>& triangles) {
    triangles.clear();
    for (const std::uint32_t k : surface.order)
        if (surface.hits[k].patch == patch) triangles.push_back(surface.hits[k].triangle);
}

// The deepest patch at a touch that has one of these triangles.
const Manifold* deepest_of(const SurfaceScratch& surface, const std::vector<Manifold>& hits,
                           const std::vector<std::uint32_t>& triangles) {
    for (const std::uint32_t k : surface.order) {
        const TriangleHit& hit = surface.hits[k];
        if (hit.patch < hits.size() && std::find(triangles.begin(), triangles.end(), hit.triangle) != triangles.end())
            return &hits[hit.patch];
    }
    return nullptr;
}

// For a patch that moves far: replaces its manifold at the start of the step by the one where its triangles touch or
// are nearest. Other triangles, which may touch already, are handled with their own patches.
Approach look_ahead(const NarrowInput& in, const ContactInfo& group, std::size_t patch, float margin, float dt,
                    NarrowBatch& own, Manifold& hit, Touch& touch) {
    list_triangles(own.surface, patch, own.triangles);
    const Approach approach = find_touch(in, group, own.triangles, dt, touch);
    if (approach != Approach::later) return approach;
    if (touch.is_beside) {
        const std::uint32_t material = surface_material_of(hit);
        hit = touch.manifold;
        hit.features[0] |= material << surface_material_bit;
        return approach;
    }
    const PosedShape a = posed_shape(in.shapes, group.shape_a), b = posed_shape(in.shapes, group.shape_b);
    find_patches({a.geometry, a.data, touch.pose_a, touch.arm_a}, {b.geometry, b.data, touch.pose_b, b.arm}, margin,
                 margin, own.surface_at_touch, own.hits_at_touch);
    const Manifold* const found = deepest_of(own.surface_at_touch, own.hits_at_touch, own.triangles);
    if (!found) return Approach::passes; // its triangles are edges of a deeper patch
    hit = *found;
    return approach;
}

std::uint32_t create_patch(const Shapes& shapes, Contacts& contacts, std::uint32_t group_id,
                           std::uint16_t surface_material) {
    const std::uint32_t id = new_contact(contacts, contacts.info[group_id].body_a);
    ContactInfo &patch = contacts.info[id], &group = contacts.info[group_id];
    patch = group;
    patch.kind = PairKind::patch;
    patch.point_count = 0;
    patch.touching = 0;
    patch.surface_material = surface_material;
    patch.related = std::int32_t(group_id);
    patch.next = group.related;
    group.related = std::int32_t(id);
    combine_materials(shapes, contacts, id);
    return id;
}

// Turns the manifolds `own.hits` of the mesh contact at that place among the candidates into patches.
void take_group(const NarrowInput& in, Contacts& contacts, NarrowScratch& narrow, std::uint32_t place, NarrowBatch& own,
                float dt) {
    const std::uint32_t id = narrow.candidates[place];
    ContactInfo& group = contacts.info[id];
    const float margin = contact_margin(narrow, group, dt);
    narrow.outcomes[place] = tested_patches;
    for (std::int32_t p = group.related; p != none; p = contacts.info[p].next) narrow.patch_outcomes[p] = not_found;
    std::uint32_t order = 0;
    for (std::size_t k = 0; k < own.hits.size(); ++k) {
        Manifold& hit = own.hits[k];
        Touch touch;
        Approach approach = Approach::now;
        if (moves_far(in, group, hit, dt)) approach = look_ahead(in, group, k, margin, dt, own, hit, touch);
        if (approach == Approach::passes) continue;
        const bool is_ahead = approach == Approach::later;
        if (is_ahead) forget_separation(in.bodies, contacts, id);
        if (!is_ahead && stays_apart(in.bodies, in.shapes, group, hit, dt)) continue;
        const std::int32_t patch = matching_patch(contacts, narrow, group, hit);
        if (patch == none)
            own.fresh.push_back({place, order++, hit, is_ahead, touch});
        else
            narrow.patch_outcomes[patch] = take_manifold(in.bodies, in.shapes, contacts, in.islands,
                                                         std::uint32_t(patch), hit, is_ahead ? &touch : nullptr);
    }
    for (std::int32_t p = group.related; p != none; p = contacts.info[p].next)
        if (std::uint8_t& outcome = narrow.patch_outcomes[p]; outcome == not_found) outcome = ended;
    if (order == 0 && group.related == none) narrow.outcomes[place] = take_distance(in.bodies, contacts, id, 0);
}

// Whether a pair continues until the middle of the step with the same patches: there it touches what it touches now,
// and nothing else; if so, its patches are updated from there. The relative displacement until then is at most half of
// the smallest half width of A, so that A may be in a shape that it meets until then, but not beyond it.
bool stays_until_midway(const NarrowInput& in, Contacts& contacts, NarrowScratch& narrow, std::uint32_t id,
                        NarrowBatch& own, float dt) {
    const ContactInfo& group = contacts.info[id];
    const float time = midway_time(in.substeps, dt), margin = contact_margin(narrow, group, dt);
    if (group.point_count == 0 ||
        !may_be_midway(narrow, group, time, 0.5f * in.bodies.links[group.body_a].inner_radius))
        return false;
    if (may_leave_predicted_path(narrow, group, time))
        for (std::int32_t p = group.related; p != none; p = contacts.info[p].next)
            if (contacts.info[p].touching &&
                !keeps_normal(in.bodies, in.shapes, contacts.info[p], contacts.records[p], time))
                return false;
    const PosedShape a_then = shape_midway(in.shapes, narrow, group.shape_a, group.body_a),
                     b_then = shape_midway(in.shapes, narrow, group.shape_b, group.body_b);
    find_patches(a_then, b_then, margin, margin, own.surface, own.hits);
    const bool meets = touches(contacts, group);
    for (Manifold& hit : own.hits) drop_separated_points(in, group, meets, a_then, b_then, dt, hit);
    for (std::int32_t p = group.related; p != none; p = contacts.info[p].next) narrow.patch_outcomes[p] = not_found;
    own.matched.clear();
    for (const Manifold& hit : own.hits) {
        const std::int32_t patch = matching_patch(contacts, narrow, group, hit);
        if (patch == none || !contacts.info[patch].touching || stays_apart(in.bodies, in.shapes, group, hit, dt) ||
            approach_of(in.bodies, in.shapes, group, hit) * time > group.base_margin ||
            leaves_face(in.shapes, group, contacts.records[patch], hit, a_then.pose, b_then.pose))
            return false;
        narrow.patch_outcomes[patch] = tested_patches;
        own.matched.push_back(std::uint32_t(patch));
    }
    for (std::int32_t p = group.related; p != none; p = contacts.info[p].next)
        if (narrow.patch_outcomes[p] == not_found) return false;
    const Moment midway = moment_midway(in.bodies, in.shapes, narrow, group, time);
    for (std::size_t k = 0; k < own.hits.size(); ++k)
        narrow.patch_outcomes[own.matched[k]] =
            take_points(in.bodies, in.shapes, contacts, in.islands, own.matched[k], own.hits[k], midway);
    keep_separation(in.bodies, contacts, id, 0);
    return true;
}

void test_group(const NarrowInput& in, Contacts& contacts, NarrowScratch& narrow, std::uint32_t place, NarrowBatch& own,
                float dt) {
    const std::uint32_t id = narrow.candidates[place];
    ContactInfo& group = contacts.info[id];
    if (stays_until_midway(in, contacts, narrow, id, own, dt)) {
        narrow.outcomes[place] = tested_patches;
        return;
    }
    const float distance = find_at_start(in, contacts, narrow, group, dt, own);
    if (own.hits.empty() && group.related == none) {
        narrow.outcomes[place] = take_distance(in.bodies, contacts, id, distance);
        return;
    }
    keep_separation(in.bodies, contacts, id, 0);
    if (group.is_trigger) {
        narrow.outcomes[place] = trigger_outcome(group, !own.hits.empty());
        return;
    }
    const auto flies = [&](const Manifold& hit) { return may_meet_in_flight(in, contacts, group, hit, dt); };
    if (!own.hits.empty() && std::all_of(own.hits.begin(), own.hits.end(), flies)) {
        own.flights.add(place, nullptr, 0);
        narrow.outcomes[place] = may_be_in_free_flight;
        return;
    }
    take_group(in, contacts, narrow, place, own, dt);
}

// Writes a new patch. A rank that does not own it knows only what the owner has reported.
std::uint8_t take_fresh_patch(const FollowUpContext& s, std::uint32_t patch, const FreshPatch& fresh) {
    if (s.contacts.records.has(patch))
        return take_manifold(s.bodies, s.shapes, s.contacts, s.islands, patch, fresh.manifold,
                             fresh.is_ahead ? &fresh.touch : nullptr);
    if (fresh.is_ahead)
        forget_separation(s.bodies, s.contacts, patch);
    else
        keep_separation(s.bodies, s.contacts, patch, 0);
    s.contacts.info[patch].point_count = std::uint8_t(fresh.manifold.count);
    return begun;
}

} // namespace

void test_held_group(const NarrowInput& in, Contacts& contacts, NarrowScratch& narrow, std::uint32_t place,
                     NarrowBatch& own, float dt) {
    find_at_start(in, contacts, narrow, contacts.info[narrow.candidates[place]], dt, own);
    take_group(in, contacts, narrow, place, own, dt);
}

bool touches(const Contacts& contacts, const ContactInfo& c) {
    if (!is_group(c)) return c.touching;
    for (std::int32_t p = c.related; p != none; p = contacts.info[p].next)
        if (contacts.info[p].touching) return true;
    return false;
}

void begin_groups(const Contacts& contacts, NarrowScratch& narrow) {
    narrow.patch_outcomes.resize(contacts.info.size());
    for (NarrowBatch& own : narrow.at_work) own.fresh.clear();
}

void test_groups(const NarrowInput& in, Contacts& contacts, NarrowScratch& narrow, int begin, int end, NarrowBatch& own,
                 float dt) {
    const std::vector<std::uint32_t>& places = narrow.lists[std::size_t(PairKind::group)];
    constexpr std::size_t ahead = 4;
    const auto contact_at = [&](std::size_t i) { return narrow.candidates[places[i]]; };
    for (std::size_t i = std::size_t(begin); i < std::size_t(end); ++i) {
        if (i + 2 * ahead < places.size()) prefetch(&contacts.info[contact_at(i + 2 * ahead)]);
        if (i + ahead < places.size()) prefetch_pair(in.bodies, in.shapes, contacts, contact_at(i + ahead));
        for (int n = 0; n < patches_at_hand; ++n)
            if (i + patch_ahead(n) < places.size()) prefetch_patch(contacts, contact_at(i + patch_ahead(n)), n, true);
        test_group(in, contacts, narrow, places[i], own, dt);
    }
}

void collect_fresh_patches(NarrowScratch& narrow) {
    std::vector<FreshPatch>& all = narrow.fresh;
    all.clear();
    narrow.next_fresh = 0;
    for (const NarrowBatch& own : narrow.at_work) all.insert(all.end(), own.fresh.begin(), own.fresh.end());
    std::sort(all.begin(), all.end(), comes_before);
}

void follow_up_group(const FollowUpContext& s, std::uint32_t place, float dt) {
    NarrowScratch& narrow = s.narrow;
    const std::uint32_t id = narrow.candidates[place];
    const std::uint8_t outcome = narrow.outcomes[place];
    if (outcome == apart || outcome == skipped || outcome == entered || outcome == left) {
        follow_up(s, id, outcome, dt);
        return;
    }
    const bool was_tested = outcome == tested_patches;
    for_each_patch(s.contacts, id, [&](std::uint32_t patch) {
        follow_up(s, patch, was_tested ? narrow.patch_outcomes[patch] : outcome, dt);
        if (s.contacts.info[patch].point_count == 0)
            end_patch(s.bodies, s.shapes, s.contacts, s.islands, s.events, patch);
    });
    for (std::size_t& k = narrow.next_fresh; k < narrow.fresh.size() && narrow.fresh[k].place == place; ++k) {
        const FreshPatch& fresh = narrow.fresh[k];
        const std::uint32_t patch = create_patch(s.shapes, s.contacts, id, surface_material_of(fresh.manifold));
        follow_up(s, patch, take_fresh_patch(s, patch, fresh), dt);
        if (s.contacts.info[patch].point_count > 0) continue;
        end_patch(s.bodies, s.shapes, s.contacts, s.islands, s.events, patch); // not begun, as its body sleeps
        forget_separation(s.bodies, s.contacts, id);
    }
    s.contacts.info[id].point_count = s.contacts.info[id].related == none ? 0 : 1;
}

std::uint32_t patch_along(const Shapes& shapes, Contacts& contacts, std::uint32_t group, math::Vec3 normal,
                          std::uint16_t surface_material, Communicator* ranks) {
    for (std::int32_t p = contacts.info[group].related; p != none; p = contacts.info[p].next)
        if (contacts.info[p].surface_material == surface_material &&
            math::dot(normal_of(contacts, std::uint32_t(p), ranks), normal) > same_patch)
            return std::uint32_t(p);
    return create_patch(shapes, contacts, group, surface_material);
}

void end_patch(Bodies& bodies, const Shapes& shapes, Contacts& contacts, Islands& islands, StepEvents& events,
               std::uint32_t id) {
    end_contact(bodies, shapes, contacts, islands, events, id);
    ContactInfo& group = contacts.info[contacts.info[id].related];
    std::int32_t* link = &group.related;
    while (*link != std::int32_t(id)) link = &contacts.info[*link].next;
    *link = contacts.info[id].next;
    free_contact(contacts, id);
}

} // namespace cairn
