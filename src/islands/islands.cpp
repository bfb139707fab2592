#include "islands/islands.h"

#include "bodies/bodies.h"
#include "core/room.h"
#include "state/joint_links.h"
#include "state/state.h"

#include <algorithm>
#include <cmath>

namespace cairn {

namespace {

std::int32_t new_island(Islands& islands) {
    std::int32_t i;
    if (islands.free.empty()) {
        i = std::int32_t(islands.all.size());
        push(islands.all, {});
    } else {
        i = islands.free.back();
        islands.free.pop_back();
        islands.all[i] = {};
    }
    Island& island = islands.all[i];
    island.in_use = 1;
    island.position = std::int32_t(islands.awake.size());
    push(islands.awake, i);
    return i;
}

// Removes an island from the list of awake ones.
void leave_awake_list(Islands& islands, std::int32_t i) {
    Island& island = islands.all[i];
    const std::int32_t last = islands.awake.back();
    islands.awake[island.position] = last;
    islands.all[last].position = island.position;
    islands.awake.pop_back();
    island.position = none;
}

void free_island(Islands& islands, std::int32_t i) {
    if (islands.all[i].position != none) leave_awake_list(islands, i);
    islands.all[i] = {};
    push(islands.free, i);
}

void append_body(Bodies& bodies, Islands& islands, std::int32_t i, std::int32_t body) {
    Island& island = islands.all[i];
    BodyLinks& links = bodies.links[body];
    links.island = i;
    links.previous_in_island = island.last_body;
    links.next_in_island = none;
    if (island.last_body == none)
        island.first_body = body;
    else
        bodies.links[island.last_body].next_in_island = body;
    island.last_body = body;
    ++island.body_count;
}

void append_all(Bodies& bodies, Islands& islands, std::int32_t into, std::int32_t from) {
    for (std::int32_t b = islands.all[from].first_body; b != none;) {
        const std::int32_t next = bodies.links[b].next_in_island;
        append_body(bodies, islands, into, b);
        b = next;
    }
}

void put_to_sleep(Bodies& bodies, Islands& islands, StepEvents& events, std::int32_t i) {
    leave_awake_list(islands, i);
    Island& island = islands.all[i];
    for (std::int32_t b = island.first_body; b != none; b = bodies.links[b].next_in_island) {
        BodyMotion& motion = bodies.motion[b];
        motion.v = motion.w = motion.v_rest = motion.w_rest = {};
        events.sleeps.next.push_back({bodies.id(b), true});
    }
    islands.falling_asleep.push_back(i);
}

// --- splitting

std::int32_t find_root(std::vector<std::int32_t>& parent, std::int32_t i) {
    while (parent[i] != i) {
        parent[i] = parent[parent[i]];
        i = parent[i];
    }
    return i;
}

void split_island(Bodies& bodies, const Contacts& contacts, Islands& islands, const Joints& joints,
                  const std::vector<std::uint32_t>& solved, SolverScratch& solver, std::int32_t i) {
    // Number the bodies in list order; a part's root in the union-find forest is its first body.
    std::vector<std::int32_t> members, parent;
    std::vector<std::int32_t>& number = solver.member_numbers;
    number.resize(bodies.links.size());
    for (std::int32_t b = islands.all[i].first_body; b != none; b = bodies.links[b].next_in_island) {
        number[b] = std::int32_t(members.size());
        parent.push_back(std::int32_t(members.size()));
        members.push_back(b);
    }
    for (const std::uint32_t id : solved) {
        const ContactInfo& contact = contacts.info[id];
        if (!contact.in_use || contact.point_count == 0 || !contact.b_moves) continue;
        if (bodies.links[contact.body_a].island != i) continue;
        const std::int32_t a = find_root(parent, number[contact.body_a]);
        const std::int32_t b = find_root(parent, number[contact.body_b]);
        parent[std::max(a, b)] = std::min(a, b);
    }
    for (const std::int32_t b : members)
        for_each_joint(bodies, joints, b, [&](std::uint32_t joint, int side) {
            const std::int32_t other = other_body(joints.info[joint], side);
            if (other == none || !bodies.is_dynamic(other) || !joints.info[joint].enabled) return;
            const std::int32_t a = find_root(parent, number[b]);
            const std::int32_t c = find_root(parent, number[other]);
            parent[std::max(a, c)] = std::min(a, c);
        });
    Island& island = islands.all[i];
    island.first_body = island.last_body = none;
    island.body_count = island.joint_count = 0;
    island.lost_contact = 0;
    std::vector<std::int32_t> part(members.size(), none);
    for (std::size_t k = 0; k < members.size(); ++k) {
        const std::size_t root = std::size_t(find_root(parent, std::int32_t(k)));
        if (part[root] == none) part[root] = root == 0 ? i : new_island(islands);
        append_body(bodies, islands, part[root], members[k]);
        for_each_joint(bodies, joints, members[k], [&](std::uint32_t joint, int) {
            if (joint_owner(bodies, joints.info[joint]) == members[k]) ++islands.all[part[root]].joint_count;
        });
    }
}

void measure_rest(const Bodies& bodies, Islands& islands, std::int32_t i) {
    Island& island = islands.all[i];
    float least = sleep_requested, greatest = 0;
    bool allowed = true;
    for (std::int32_t b = island.first_body; b != none; b = bodies.links[b].next_in_island) {
        const float quiet = bodies.links[b].quiet_time;
        least = std::min(least, quiet);
        greatest = std::max(greatest, quiet);
        allowed = allowed && bodies.settings[b].allow_sleep;
    }
    island.min_quiet_time = allowed && !island.kept_awake ? least : 0;
    island.greatest_quiet_time = greatest;
}

// Whether an island gains speed steadily: then it will not stay in place, however slow it still is. With the kinetic
// energy per mass e = v^2 / 2, de/dt = v dv/dt. The sums are over the whole island, as its parts may sway long before
// they come to rest. Momentum is no measure: that of a wheel, or of two bodies on one rope, is zero.
bool gains_speed(const Bodies& bodies, const WorldDef& settings, const Island& island) {
    constexpr float steady_gain = 0.25f; // gain of speed per sleep time, as a share of the sleep speed
    float gain = 0, momentum = 0;
    for (std::int32_t b = island.first_body; b != none; b = bodies.links[b].next_in_island) {
        const BodyLinks& links = bodies.links[b];
        const float mass = bodies.mass[b].mass;
        gain += mass * (links.late - links.later);
        momentum += mass * std::sqrt(2 * links.late);
    }
    return gain > lag_of_rest * steady_gain * settings.sleep_speed * momentum;
}

} // namespace

void create_island(Bodies& bodies, Islands& islands, std::int32_t body) {
    append_body(bodies, islands, new_island(islands), body);
}

void remove_from_island(Bodies& bodies, Islands& islands, std::int32_t body) {
    BodyLinks& links = bodies.links[body];
    const std::int32_t i = links.island;
    Island& island = islands.all[i];
    if (links.previous_in_island == none)
        island.first_body = links.next_in_island;
    else
        bodies.links[links.previous_in_island].next_in_island = links.next_in_island;
    if (links.next_in_island == none)
        island.last_body = links.previous_in_island;
    else
        bodies.links[links.next_in_island].previous_in_island = links.previous_in_island;
    links.island = links.next_in_island = links.previous_in_island = none;
    island.lost_contact = 1;
    if (--island.body_count == 0) free_island(islands, i);
}

void link_islands(Bodies& bodies, Islands& islands, StepEvents& events, std::int32_t body_a, std::int32_t body_b) {
    std::int32_t a = bodies.links[body_a].island, b = bodies.links[body_b].island;
    wake_island(bodies, islands, events, a);
    wake_island(bodies, islands, events, b);
    if (a == b) return;
    if (islands.all[a].body_count < islands.all[b].body_count) std::swap(a, b);
    append_all(bodies, islands, a, b);
    islands.all[a].joint_count += islands.all[b].joint_count;
    islands.all[a].lost_contact |= islands.all[b].lost_contact;
    free_island(islands, b);
}

void wake_island(Bodies& bodies, Islands& islands, StepEvents& events, std::int32_t i) {
    Island& island = islands.all[i];
    if (island.position != none) return;
    island.position = std::int32_t(islands.awake.size());
    islands.awake.push_back(i);
    for (std::int32_t b = island.first_body; b != none; b = bodies.links[b].next_in_island) {
        bodies.links[b].quiet_time = 0;
        bodies.motion[b].turned = {};
        events.sleeps.next.push_back({bodies.id(b), false});
    }
    island.kept_awake = 1; // for this step
    if (island.key == none) {
        std::erase(islands.falling_asleep, i);
        return;
    }
    islands.waking.push_back(island.key);
    island.key = none;
}

void wake_body(Bodies& bodies, Islands& islands, StepEvents& events, std::int32_t body) {
    const std::int32_t island = bodies.links[body].island;
    if (island == none) return;
    bodies.links[body].quiet_time = 0;
    wake_island(bodies, islands, events, island);
}

void apply_sleep_requests(Bodies& bodies, const Contacts& contacts, Islands& islands, StepEvents& events,
                          std::vector<std::uint32_t>& solved) {
    if (islands.sleep_requests.empty()) return;
    bool any = false;
    for (const std::int32_t body : islands.sleep_requests) {
        const std::int32_t i = bodies.is_dynamic(body) ? bodies.links[body].island : none;
        if (i == none || islands.all[i].position == none) continue;
        measure_rest(bodies, islands, i);
        if (islands.all[i].min_quiet_time < sleep_requested) continue;
        put_to_sleep(bodies, islands, events, i);
        any = true;
    }
    islands.sleep_requests.clear();
    if (any)
        std::erase_if(solved, [&](std::uint32_t id) { return !is_awake(bodies, islands, contacts.info[id].body_a); });
}

void wake_around_shape(Bodies& bodies, const Shapes& shapes, Islands& islands, const BroadPhase& broad_phase,
                       StepEvents& events, std::uint32_t shape) {
    if (islands.awake.size() + islands.free.size() == islands.all.size()) return; // nothing sleeps
    if (!bodies.is_enabled(shapes.links[shape].body)) return;
    DBounds bounds = shape_bounds(shapes, shape);
    bounds.lo = bounds.lo - math::DVec3{max_margin, max_margin, max_margin};
    bounds.hi = bounds.hi + math::DVec3{max_margin, max_margin, max_margin};
    const std::int32_t body = shapes.links[shape].body;
    std::vector<std::int32_t> found;
    broad_phase.query_bounds(bounds, [&](std::uint32_t other) {
        const std::int32_t near = shapes.links[other].body;
        if (near != body && bodies.is_dynamic(near) && !is_awake(bodies, islands, near)) found.push_back(near);
    });
    std::sort(found.begin(), found.end());
    for (const std::int32_t near : found) wake_body(bodies, islands, events, near);
}

void wake_around(Bodies& bodies, const Shapes& shapes, Islands& islands, const BroadPhase& broad_phase,
                 StepEvents& events, std::int32_t body) {
    for (std::int32_t s = bodies.links[body].first_shape; s != none; s = shapes.links[s].next)
        wake_around_shape(bodies, shapes, islands, broad_phase, events, std::uint32_t(s));
}

void wake_around_moving_planes(Bodies& bodies, const Shapes& shapes, Islands& islands, const BroadPhase& broad_phase,
                               StepEvents& events) {
    for (const std::int32_t b : bodies.kinematics) {
        const BodyMotion& motion = bodies.motion[b];
        if (motion.v == math::Vec3{} && motion.w == math::Vec3{}) continue;
        for (std::int32_t s = bodies.links[b].first_shape; s != none; s = shapes.links[s].next)
            if (shapes.geometry[s].type == ShapeType::plane)
                wake_around_shape(bodies, shapes, islands, broad_phase, events, std::uint32_t(s));
    }
}

void update_sleep(Bodies& bodies, const Contacts& contacts, Islands& islands, const Joints& joints,
                  const WorldDef& settings, StepEvents& events, const std::vector<std::uint32_t>& solved,
                  SolverScratch& solver) {
    if (!settings.enable_sleep) return;
    const float needed = settings.sleep_time;
    std::int32_t to_split = none;
    float quietest = needed;
    for (const std::int32_t i : islands.awake) {
        measure_rest(bodies, islands, i);
        const Island& island = islands.all[i];
        if (island.lost_contact && island.greatest_quiet_time >= quietest && island.body_count > 1 &&
            (to_split == none || island.greatest_quiet_time > quietest)) {
            to_split = i;
            quietest = island.greatest_quiet_time;
        }
        if (island.body_count == 1) islands.all[i].lost_contact = 0;
    }
    for (std::size_t k = islands.awake.size(); k-- > 0;) {
        const std::int32_t i = islands.awake[k];
        const Island& island = islands.all[i];
        if (island.lost_contact || island.min_quiet_time < needed || gains_speed(bodies, settings, island)) continue;
        put_to_sleep(bodies, islands, events, i);
    }
    if (to_split != none) split_island(bodies, contacts, islands, joints, solved, solver, to_split);
}

void flush_sleep(const Bodies& bodies, const Shapes& shapes, Islands& islands, BroadPhase& broad_phase) {
    for (const std::int32_t key : islands.waking) broad_phase.wake(std::uint32_t(key));
    islands.waking.clear();
    if (islands.falling_asleep.empty()) return;
    std::vector<std::uint32_t> members;
    for (const std::int32_t i : islands.falling_asleep) {
        Island& island = islands.all[i];
        members.clear();
        for (std::int32_t b = island.first_body; b != none; b = bodies.links[b].next_in_island)
            for (std::int32_t s = bodies.links[b].first_shape; s != none; s = shapes.links[s].next)
                members.push_back(std::uint32_t(s));
        island.key = i;
        broad_phase.put_to_sleep(std::uint32_t(i), members);
    }
    islands.falling_asleep.clear();
}

} // namespace cairn
