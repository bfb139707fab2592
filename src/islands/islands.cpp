#include "islands/islands.h"

#include "bodies/bodies.h"
#include "state/joint_links.h"
#include "state/state.h"

#include <algorithm>
#include <cmath>

namespace cairn {

namespace {


std::int32_t new_island(State& state) {
    std::int32_t i;
    if (state.islands.free.empty()) {
        i = std::int32_t(state.islands.all.size());
        state.islands.all.emplace_back();
    } else {
        i = state.islands.free.back();
        state.islands.free.pop_back();
        state.islands.all[i] = {};
    }
    Island& island = state.islands.all[i];
    island.in_use = 1;
    island.position = std::int32_t(state.islands.awake.size());
    state.islands.awake.push_back(i);
    return i;
}

// Takes an island out of the list of awake ones.
void leave_awake_list(State& state, std::int32_t i) {
    Island& island = state.islands.all[i];
    const std::int32_t last = state.islands.awake.back();
    state.islands.awake[island.position] = last;
    state.islands.all[last].position = island.position;
    state.islands.awake.pop_back();
    island.position = none;
}

void free_island(State& state, std::int32_t i) {
    if (state.islands.all[i].position != none) leave_awake_list(state, i);
    state.islands.all[i] = {};
    state.islands.free.push_back(i);
}

void append_body(State& state, std::int32_t i, std::int32_t body) {
    Island& island = state.islands.all[i];
    BodyLinks& links = state.bodies.links[body];
    links.island = i;
    links.previous_in_island = island.last_body;
    links.next_in_island = none;
    if (island.last_body == none)
        island.first_body = body;
    else
        state.bodies.links[island.last_body].next_in_island = body;
    island.last_body = body;
    ++island.body_count;
}

void append_all(State& state, std::int32_t into, std::int32_t from) {
    for (std::int32_t b = state.islands.all[from].first_body; b != none;) {
        const std::int32_t next = state.bodies.links[b].next_in_island;
        append_body(state, into, b);
        b = next;
    }
}

void put_to_sleep(State& state, std::int32_t i) {
    leave_awake_list(state, i);
    Island& island = state.islands.all[i];
    for (std::int32_t b = island.first_body; b != none; b = state.bodies.links[b].next_in_island) {
        BodyMotion& motion = state.bodies.motion[b];
        motion.v = motion.w = motion.v_rest = motion.w_rest = {};
        state.events.sleeps.next.push_back({state.bodies.id(b), true});
    }
    state.islands.falling_asleep.push_back(i);
}

// --- splitting

std::int32_t find_root(std::vector<std::int32_t>& parent, std::int32_t i) {
    while (parent[i] != i) {
        parent[i] = parent[parent[i]];
        i = parent[i];
    }
    return i;
}

void split_island(State& state, StepScratch& step, std::int32_t i) {
    // Number the bodies in list order; the root of a part is its first body.
    std::vector<std::int32_t> members, parent;
    std::vector<std::int32_t>& number = step.solver.member_numbers;
    number.resize(state.bodies.links.size());
    for (std::int32_t b = state.islands.all[i].first_body; b != none; b = state.bodies.links[b].next_in_island) {
        number[b] = std::int32_t(members.size());
        parent.push_back(std::int32_t(members.size()));
        members.push_back(b);
    }
    for (const std::uint32_t id : step.solved) {
        const ContactInfo& contact = state.contacts.info[id];
        if (!contact.in_use || contact.point_count == 0 || !contact.b_moves) continue;
        if (state.bodies.links[contact.body_a].island != i) continue;
        const std::int32_t a = find_root(parent, number[contact.body_a]);
        const std::int32_t b = find_root(parent, number[contact.body_b]);
        parent[std::max(a, b)] = std::min(a, b);
    }
    for (const std::int32_t b : members)
        for_each_joint(state, b, [&](std::uint32_t joint, int side) {
            const std::int32_t other = other_body(state.joints.info[joint], side);
            if (other == none || !state.bodies.is_dynamic(other)) return;
            const std::int32_t a = find_root(parent, number[b]);
            const std::int32_t c = find_root(parent, number[other]);
            parent[std::max(a, c)] = std::min(a, c);
        });
    Island& island = state.islands.all[i];
    island.first_body = island.last_body = none;
    island.body_count = island.joint_count = 0;
    island.lost_contact = 0;
    std::vector<std::int32_t> part(members.size(), none);
    for (std::size_t k = 0; k < members.size(); ++k) {
        const std::size_t root = std::size_t(find_root(parent, std::int32_t(k)));
        if (part[root] == none) part[root] = root == 0 ? i : new_island(state);
        append_body(state, part[root], members[k]);
        for_each_joint(state, members[k], [&](std::uint32_t joint, int) {
            if (joint_owner(state, state.joints.info[joint]) == members[k]) ++state.islands.all[part[root]].joint_count;
        });
    }
}

void measure_rest(State& state, std::int32_t i) {
    Island& island = state.islands.all[i];
    float least = 1e30f, greatest = 0;
    bool allowed = true;
    for (std::int32_t b = island.first_body; b != none; b = state.bodies.links[b].next_in_island) {
        const float quiet = state.bodies.links[b].quiet_time;
        least = std::min(least, quiet);
        greatest = std::max(greatest, quiet);
        allowed = allowed && state.bodies.settings[b].allow_sleep;
    }
    island.min_quiet_time = allowed && !island.kept_awake ? least : 0;
    island.greatest_quiet_time = greatest;
}

// What gains speed steadily will not stay where it is, however slow it is yet. The whole of an island is asked: its
// parts may sway for long before they come to rest.
bool gains_speed(const State& state, const Island& island) {
    constexpr float steady_gain = 0.25f; // of the sleep speed, in a sleep time
    float mass = 0;
    math::Vec3 momentum, difference;
    for (std::int32_t b = island.first_body; b != none; b = state.bodies.links[b].next_in_island) {
        const BodyLinks& links = state.bodies.links[b];
        const float m = state.bodies.mass[b].mass;
        mass += m;
        momentum += m * links.late;
        difference += m * (links.late - links.later);
    }
    return math::dot(difference, momentum) > 0 &&
           math::length(difference) > lag_of_rest * steady_gain * state.settings.sleep_speed * mass;
}

} // namespace

void create_island(State& state, std::int32_t body) { append_body(state, new_island(state), body); }

void remove_from_island(State& state, std::int32_t body) {
    BodyLinks& links = state.bodies.links[body];
    const std::int32_t i = links.island;
    Island& island = state.islands.all[i];
    if (links.previous_in_island == none)
        island.first_body = links.next_in_island;
    else
        state.bodies.links[links.previous_in_island].next_in_island = links.next_in_island;
    if (links.next_in_island == none)
        island.last_body = links.previous_in_island;
    else
        state.bodies.links[links.next_in_island].previous_in_island = links.previous_in_island;
    links.island = links.next_in_island = links.previous_in_island = none;
    island.lost_contact = 1;
    if (--island.body_count == 0) free_island(state, i);
}

void link_islands(State& state, std::int32_t body_a, std::int32_t body_b) {
    std::int32_t a = state.bodies.links[body_a].island, b = state.bodies.links[body_b].island;
    wake_island(state, a);
    wake_island(state, b);
    if (a == b) return;
    if (state.islands.all[a].body_count < state.islands.all[b].body_count) std::swap(a, b);
    append_all(state, a, b);
    state.islands.all[a].joint_count += state.islands.all[b].joint_count;
    state.islands.all[a].lost_contact |= state.islands.all[b].lost_contact;
    free_island(state, b);
}

void wake_island(State& state, std::int32_t i) {
    Island& island = state.islands.all[i];
    if (island.position != none) return;
    island.position = std::int32_t(state.islands.awake.size());
    state.islands.awake.push_back(i);
    for (std::int32_t b = island.first_body; b != none; b = state.bodies.links[b].next_in_island) {
        state.bodies.links[b].quiet_time = 0;
        state.bodies.motion[b].turned = {};
        state.events.sleeps.next.push_back({state.bodies.id(b), false});
    }
    island.kept_awake = 1; // for this step
    if (island.key == none) {
        std::erase(state.islands.falling_asleep, i);
        return;
    }
    state.islands.waking.push_back(island.key);
    island.key = none;
}

void wake_body(State& state, std::int32_t body) {
    const std::int32_t island = state.bodies.links[body].island;
    if (island == none) return;
    state.bodies.links[body].quiet_time = 0;
    wake_island(state, island);
}

void wake_around_shape(State& state, std::uint32_t shape) {
    if (state.islands.awake.size() + state.islands.free.size() == state.islands.all.size()) return; // nothing sleeps
    constexpr double reach = 0.05; // m: further than any contact at rest
    DBounds bounds = shape_bounds(state, shape);
    bounds.lo = bounds.lo - math::DVec3{reach, reach, reach};
    bounds.hi = bounds.hi + math::DVec3{reach, reach, reach};
    const std::int32_t body = state.shapes.links[shape].body;
    std::vector<std::int32_t> found;
    state.broad_phase.query_bounds(bounds, [&](std::uint32_t other) {
        const std::int32_t near = state.shapes.links[other].body;
        if (near != body && state.bodies.is_dynamic(near) && !is_awake(state.bodies, state.islands, near))
            found.push_back(near);
    });
    std::sort(found.begin(), found.end());
    for (const std::int32_t near : found) wake_body(state, near);
}

void wake_around(State& state, std::int32_t body) {
    for (std::int32_t s = state.bodies.links[body].first_shape; s != none; s = state.shapes.links[s].next)
        wake_around_shape(state, std::uint32_t(s));
}

void wake_around_moving_planes(State& state) {
    for (const std::int32_t b : state.bodies.kinematics) {
        const BodyMotion& motion = state.bodies.motion[b];
        if (motion.v == math::Vec3{} && motion.w == math::Vec3{}) continue;
        for (std::int32_t s = state.bodies.links[b].first_shape; s != none; s = state.shapes.links[s].next)
            if (state.shapes.geometry[s].type == ShapeType::plane) wake_around_shape(state, std::uint32_t(s));
    }
}

bool update_sleep(State& state, StepScratch& step) {
    if (!state.settings.enable_sleep) return false;
    const float needed = state.settings.sleep_time;
    std::int32_t to_split = none;
    float quietest = needed;
    bool any_sleeps = false;
    for (const std::int32_t i : state.islands.awake) {
        measure_rest(state, i);
        const Island& island = state.islands.all[i];
        if (island.lost_contact && island.greatest_quiet_time >= quietest && island.body_count > 1 &&
            (to_split == none || island.greatest_quiet_time > quietest)) {
            to_split = i;
            quietest = island.greatest_quiet_time;
        }
        if (island.body_count == 1) state.islands.all[i].lost_contact = 0;
    }
    for (std::size_t k = state.islands.awake.size(); k-- > 0;) {
        const std::int32_t i = state.islands.awake[k];
        const Island& island = state.islands.all[i];
        if (island.lost_contact || island.min_quiet_time < needed || gains_speed(state, island)) continue;
        put_to_sleep(state, i);
        any_sleeps = true;
    }
    if (to_split != none) split_island(state, step, to_split);
    return any_sleeps;
}

void flush_sleep(State& state) {
    for (const std::int32_t key : state.islands.waking) state.broad_phase.wake(std::uint32_t(key));
    state.islands.waking.clear();
    if (state.islands.falling_asleep.empty()) return;
    std::vector<std::uint32_t> members;
    for (const std::int32_t i : state.islands.falling_asleep) {
        Island& island = state.islands.all[i];
        members.clear();
        for (std::int32_t b = island.first_body; b != none; b = state.bodies.links[b].next_in_island)
            for (std::int32_t s = state.bodies.links[b].first_shape; s != none; s = state.shapes.links[s].next)
                members.push_back(std::uint32_t(s));
        island.key = i;
        state.broad_phase.put_to_sleep(std::uint32_t(i), members);
    }
    state.islands.falling_asleep.clear();
}

} // namespace cairn
