#include "impacts/impact_report.h"

#include "bodies/motion_budget.h"
#include "contacts/contact_record.h"
#include "contacts/patches.h"

namespace cairn {

namespace {

// Writes the struck point to the contact's record. `normal`: from A of the contact. Returns whether touching begins.
bool begins_to_touch(const ImpactContext& s, SolverScratch& solver, std::uint32_t id, const ImpactOutcome& outcome,
                     math::Vec3 normal) {
    forget_separation(s.bodies, s.contacts, id); // so that the next step tests the pair in any case
    bool has_touched = s.contacts.info[id].touching;
    if (is_group(s.contacts.info[id])) {
        for (std::int32_t p = s.contacts.info[id].related; p != none; p = s.contacts.info[p].next)
            has_touched |= s.contacts.info[p].touching != 0;
        id = patch_along(s.shapes, s.contacts, id, normal, outcome.surface_material, s.ranks);
    }
    s.contacts.info[id].touching = 1;
    if (s.contacts.info[id].point_count > 0) { // the solver has solved it and reports its impulse
        solver.reports[id].impulse += float(outcome.impulse);
        return !has_touched;
    }
    if (!s.contacts.records.has(id)) return !has_touched;
    ContactRecord& r = s.contacts.records[id];
    forget_impulses(r, 0);
    math::put(r.normal, normal);
    math::put(r.first_point, math::to_float(outcome.position - s.bodies.motion[s.contacts.info[id].body_a].x));
    r.first_point[3] = 0;
    r.first_total = float(outcome.impulse);
    return !has_touched;
}

} // namespace

void report_impact(const ImpactContext& s, SolverScratch& solver, const SweptPair& pair, const ImpactOutcome& outcome,
                   double moment) {
    const std::int32_t id = pair.contact;
    const bool is_first = id == none || s.contacts.info[id].shape_a == pair.shape; // as A of the contact
    const std::uint32_t first = is_first ? pair.shape : pair.other, second = is_first ? pair.other : pair.shape;
    const math::Vec3 n = math::to_float(is_first ? outcome.normal : -outcome.normal);
    const ShapeId a = s.shapes.slots.id(first), b = s.shapes.slots.id(second);
    const BodyId body_a = s.bodies.id(s.shapes.links[first].body), body_b = s.bodies.id(s.shapes.links[second].body);
    const bool begins = !pair.has_begun && (id == none || begins_to_touch(s, solver, std::uint32_t(id), outcome, n));
    if (begins) s.events.begins.push_back({a, b, body_a, body_b});
    if (begins && id == none) s.events.brief.push_back({a, b, body_a, body_b});
    if (outcome.approach < double(s.settings.hit_speed)) return;
    const math::DVec3 p = outcome.position;
    s.events.hits.push_back({a,
                             b,
                             body_a,
                             body_b,
                             {p.x, p.y, p.z},
                             {n.x, n.y, n.z},
                             float(outcome.approach),
                             float(moment),
                             outcome.surface_material});
}

} // namespace cairn
