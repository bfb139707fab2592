#include "core_watch.h"

#include "bodies.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace cairn_test {
namespace {

// Depth of a heart, as a fraction of the inner radius. The solver may press shapes into each other by half of it.
constexpr double heart_share = 0.6;
constexpr double way_share = 0.1; // accuracy of paths, as a fraction of the core inset

// The pose on a path at a given time.
Knot knot_at(const std::vector<Knot>& way, double time) {
    std::size_t k = 1;
    while (k + 1 < way.size() && way[k].time <= time) ++k;
    const Knot &from = way[k - 1], &to = way[k];
    const double part = to.time > from.time ? std::clamp((time - from.time) / (to.time - from.time), 0.0, 1.0) : 1;
    return {time, from.center + part * (to.center - from.center), glm::slerp(from.rotation, to.rotation, part)};
}

bool are_joined(const World& world, BodyId a, BodyId b) {
    for (const JointId id : world.joints(a)) {
        const JointDef& def = world.joint_def(id);
        if ((def.body_a == b || def.body_b == b) && !def.enable_collision) return true;
    }
    return false;
}

} // namespace

CoreWatch::Member CoreWatch::make_member(const World& world, BodyId id) {
    const Body body = world.body(id);
    Member member{.id = id, .is_static = body.type() == BodyType::static_};
    const MassProperties mass = body.mass_properties();
    if (body.type() == BodyType::dynamic) {
        member.center = glm::dvec3(mass.center_of_mass);
        member.free.inertia = glm::dvec3(mass.inertia_diagonal);
        member.free.principal = glm::normalize(glm::dquat(mass.inertia_orientation));
    }
    double core = std::numeric_limits<double>::infinity();
    for (const ShapeId shape : body.shapes()) {
        const ShapeDef& def = world.shape_def(shape);
        Part part{world.shape(shape), glm::dvec3(def.position), glm::normalize(glm::dquat(def.rotation))};
        const double radius = inner_radius(part.shape);
        part.core.depth = core_shrink(radius), part.heart.depth = std::max(part.core.depth, heart_share * radius);
        core = std::min(core, part.core.depth);
        const glm::dvec3 center = glm::conjugate(part.rotation) * (member.center - part.position);
        member.free.reach = std::max(member.free.reach, make_core(part.shape, 0).reach_from(center));
        member.parts.push_back(std::move(part));
    }
    member.free.tolerance = way_share * core;
    for (Part& part : member.parts)
        for (Inside* inside : {&part.core, &part.heart}) {
            inside->at_rest = make_core(part.shape, inside->depth);
            inside->on_way = make_core(part.shape, inside->depth + member.free.tolerance);
        }
    return member;
}

BodyState CoreWatch::state_of(const World& world, BodyId id) {
    const Body body = world.body(id);
    return {body.center_of_mass(), glm::normalize(glm::dquat(body.rotation())), glm::dvec3(body.linear_velocity()),
            glm::dvec3(body.angular_velocity())};
}

CoreWatch::CoreWatch(const World& world) {
    for (const BodyId id : world.bodies()) {
        members_.push_back(make_member(world, id));
        move(members_.back(), state_of(world, id), 0, 0);
    }
    touched_ = touching(world);
    overlapped_.resize(members_.size() * members_.size());
    for (std::size_t a = 0; a < members_.size(); ++a)
        for (std::size_t b = a + 1; b < members_.size(); ++b)
            overlapped_[a * members_.size() + b] = do_meet_at_end(members_[a], members_[b], &Part::core);
}

void CoreWatch::bound_static(Member& member) {
    const double infinity = std::numeric_limits<double>::infinity();
    member.low = glm::dvec3(infinity), member.high = glm::dvec3(-infinity);
    for (const Part& part : member.parts) {
        const Core& core = part.core.at_rest;
        if (core.half_space) member.low = glm::dvec3(-infinity), member.high = glm::dvec3(infinity);
        const glm::dquat rotation = member.state.rotation * part.rotation;
        const glm::dvec3 origin = member.state.center + member.state.rotation * part.position;
        for (const CorePiece& piece : core.pieces)
            for (int axis = 0; axis < 3; ++axis) {
                glm::dvec3 way(0);
                way[axis] = 1;
                const glm::dvec3 local = glm::conjugate(rotation) * way;
                member.low[axis] = std::min(member.low[axis], (origin + rotation * piece.support(-local))[axis]);
                member.high[axis] = std::max(member.high[axis], (origin + rotation * piece.support(local))[axis]);
            }
    }
}

// `dt` 0: the body is placed there.
void CoreWatch::move(Member& member, const BodyState& to, double dt, int impacts) {
    const Knot end{1, to.center, to.rotation};
    member.way = {};
    if (member.is_static)
        member.way.knots = {{0, to.center, to.rotation}, end};
    else if (dt > 0)
        member.way = reconstruct_path(member.free, member.state, to, dt);
    // Several impacts may look like a single one at a place beyond the body that was hit.
    if (member.way.is_broken && impacts != 1) member.way = {};
    member.state = to;
    if (member.is_static) return bound_static(member);
    member.low = member.high = to.center;
    for (const Knot& knot : member.way.knots) {
        member.low = glm::min(member.low, knot.center);
        member.high = glm::max(member.high, knot.center);
    }
    member.low -= member.free.reach, member.high += member.free.reach;
}

Moving CoreWatch::moving(const Member& member, const Part& part, const Knot& from, const Knot& to, const Core& core) {
    const auto pose = [&](const Knot& knot) {
        const glm::dquat rotation = knot.rotation * part.rotation;
        return Transform{knot.center + knot.rotation * (part.position - member.center), Quat(rotation)};
    };
    const glm::dvec3 center = glm::conjugate(part.rotation) * (member.center - part.position);
    return {&part.shape, pose(from), pose(to), center, 0, &core};
}

bool CoreWatch::do_meet_at_end(const Member& a, const Member& b, Inside Part::*inside) {
    const Knot end_a{1, a.state.center, a.state.rotation}, end_b{1, b.state.center, b.state.rotation};
    for (const Part& part_a : a.parts)
        for (const Part& part_b : b.parts)
            if (cores_overlap_at_start(moving(a, part_a, end_a, end_a, (part_a.*inside).at_rest),
                                       moving(b, part_b, end_b, end_b, (part_b.*inside).at_rest)))
                return true;
    return false;
}

bool CoreWatch::do_meet_between(const Member& a, const Member& b, double from, double to, Inside Part::*inside) {
    const Knot from_a = knot_at(a.way.knots, from), to_a = knot_at(a.way.knots, to);
    const Knot from_b = knot_at(b.way.knots, from), to_b = knot_at(b.way.knots, to);
    for (const Part& part_a : a.parts)
        for (const Part& part_b : b.parts)
            if (cores_meet(moving(a, part_a, from_a, to_a, (part_a.*inside).on_way),
                           moving(b, part_b, from_b, to_b, (part_b.*inside).on_way)))
                return true;
    return false;
}

bool CoreWatch::do_meet_on_way(const Member& a, const Member& b, Inside Part::*inside) {
    std::vector<double> times;
    for (const Member* member : {&a, &b})
        for (const Knot& knot : member->way.knots) times.push_back(knot.time);
    std::sort(times.begin(), times.end());
    times.erase(std::unique(times.begin(), times.end()), times.end());
    for (std::size_t i = 1; i < times.size(); ++i)
        if (do_meet_between(a, b, times[i - 1], times[i], inside)) return true;
    return false;
}

void CoreWatch::judge(const World& world, std::size_t i, std::size_t k, CoreEncounters& met) {
    const Member &a = members_[i], &b = members_[k];
    if (a.is_static && b.is_static) return;
    const std::size_t pair = i * members_.size() + k;
    const bool overlapped = overlapped_[pair];
    overlapped_[pair] = false;
    const bool are_near = glm::all(glm::lessThanEqual(a.low, b.high)) && glm::all(glm::lessThanEqual(b.low, a.high));
    if (!are_near || are_joined(world, a.id, b.id)) return;
    const bool overlaps = do_meet_at_end(a, b, &Part::core), is_known = !a.way.knots.empty() && !b.way.knots.empty();
    overlapped_[pair] = overlaps;
    met.overlapping += overlaps;
    const auto tell = [&](const char* what) {
        met.worst = "bodies " + std::to_string(a.id.index()) + " and " + std::to_string(b.id.index()) + what;
    };
    // The states before and after the step do not show whether the solver, too, moved a body that had an impact or a
    // contact.
    const bool is_free = is_known && !a.way.is_broken && !b.way.is_broken && !overlapped && !touched_[pair];
    if (is_free && do_meet_on_way(a, b, &Part::core)) {
        ++met.passed;
        return tell(" have met on their ways, and nothing happened");
    }
    if (!(overlaps && do_meet_at_end(a, b, &Part::heart)) && !(is_known && do_meet_on_way(a, b, &Part::heart))) return;
    ++met.deep;
    tell(" are deep in each other");
}

std::vector<bool> CoreWatch::touching(const World& world) const {
    std::vector<bool> pairs(members_.size() * members_.size());
    const auto place = [&](BodyId id) {
        const auto is_it = [&](const Member& member) { return member.id == id; };
        return std::size_t(std::find_if(members_.begin(), members_.end(), is_it) - members_.begin());
    };
    for (const Contact& contact : world.contacts()) {
        const std::size_t a = place(contact.body_a), b = place(contact.body_b);
        pairs[std::min(a, b) * members_.size() + std::max(a, b)] = true;
    }
    return pairs;
}

CoreEncounters CoreWatch::look(const World& world, double dt) {
    for (Member& member : members_) {
        int impacts = 0;
        for (const ContactHit& hit : world.contact_hits())
            impacts += hit.body_a == member.id || hit.body_b == member.id;
        move(member, state_of(world, member.id), dt, impacts);
    }
    // A pair in contact at the end counts as in contact during the step.
    const std::vector<bool> touch_now = touching(world);
    for (std::size_t i = 0; i < touched_.size(); ++i) touched_[i] = touched_[i] || touch_now[i];
    CoreEncounters met;
    for (std::size_t a = 0; a < members_.size(); ++a)
        for (std::size_t b = a + 1; b < members_.size(); ++b) judge(world, a, b, met);
    touched_ = touch_now;
    return met;
}

} // namespace cairn_test
