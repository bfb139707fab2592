#include "viewer/side_run.h"

#include "viewer/elapsed.h"

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <unordered_map>
#include <utility>

namespace cairn::viewer {

namespace {

constexpr double seen_distance = 1e-3; // m
constexpr float seen_turn = 0.003f;    // sine of half the angle: a thousandth of a turn

} // namespace

void end_held(World& world, std::span<const Held> held) {
    for (const Held& one : held) {
        if (const auto* joint = std::get_if<JointId>(&one.id)) {
            if (world.is_valid(*joint)) world.destroy_joint(*joint);
        } else if (world.is_valid(std::get<ForceFieldId>(one.id))) {
            world.remove_force_field(std::get<ForceFieldId>(one.id));
        }
    }
}

SideRun::SideRun(const World& other, const Timeline& known, std::vector<Held> of_hands, float step_length,
                 const Looks& looks)
    : held(std::move(of_hands)), step_length_(step_length) {
    world.set_threads(other.threads());
    world.restore(other.save());
    timeline = known.fork(world);
    refresh(looks);
}

void SideRun::refresh(const Looks& looks) {
    picture_.layout =
        std::make_shared<const WorldLayout>(read_layout(world, looks.appearances, meshes_, looks.visuals));
    picture_.current = std::make_shared<const WorldMotion>(read_motion(world, *picture_.layout));
    picture_.previous = picture_.current;
}

void SideRun::live_step() {
    end_held(world, std::exchange(held, {}));
    const auto start = std::chrono::steady_clock::now();
    world.step(step_length_);
    timeline.after_step(world, seconds_since(start));
}

bool SideRun::go_to(std::uint64_t step, double seconds, const Looks& looks) {
    const auto start = std::chrono::steady_clock::now();
    step = std::max(step, timeline.first_step());
    const std::uint64_t from = timeline.now().step;
    if (step == from) return true;
    bool alters = true;
    if (step + 1 == from) {
        timeline.step_back(world);
    } else if (step < from || (step > from + 1 && timeline.last_step() > from)) {
        timeline.seek(world, {std::min(step, timeline.last_step()), 0}, seconds);
    } else {
        alters = false;
    }
    while (timeline.now().step < step && seconds_since(start) < seconds) {
        if (timeline.follows()) {
            alters = timeline.follow(world) || alters;
        } else {
            alters = alters || !held.empty();
            live_step();
        }
    }
    const std::shared_ptr<const WorldMotion> before = picture_.current;
    const std::size_t bodies = picture_.layout->bodies.size();
    if (alters)
        refresh(looks);
    else
        picture_.current = std::make_shared<const WorldMotion>(read_motion(world, *picture_.layout));
    const bool is_next = timeline.now().step == from + 1 || timeline.now().step + 1 == from;
    picture_.previous = is_next && picture_.layout->bodies.size() == bodies ? before : picture_.current;
    return timeline.now().step == step;
}

bool is_elsewhere(const Transform& a, const Transform& b) {
    const Quat turn = glm::conjugate(a.rotation) * b.rotation;
    return glm::length(a.position - b.position) > seen_distance ||
           glm::length(Vec3(turn.x, turn.y, turn.z)) > seen_turn;
}

RunDifference difference(const WorldLayout& layout, const WorldMotion& motion, const RunPicture& other) {
    std::unordered_map<BodyId, std::size_t> places; // indices of the other run's bodies
    for (std::size_t i = 0; i < other.layout->bodies.size(); ++i) places.emplace(other.layout->bodies[i].id, i);
    RunDifference difference;
    std::size_t shared = 0;
    for (std::size_t i = 0; i < layout.bodies.size(); ++i) {
        const auto place = places.find(layout.bodies[i].id);
        if (place == places.end()) continue;
        ++shared;
        const Transform &here = motion.transforms[i], &there = other.current->transforms[place->second];
        if (!is_elsewhere(here, there)) continue;
        ++difference.elsewhere;
        const double distance = glm::length(here.position - there.position);
        if (distance < difference.farthest && difference.farthest_body) continue;
        difference.farthest = distance;
        difference.farthest_body = layout.bodies[i].id;
    }
    difference.elsewhere += (layout.bodies.size() - shared) + (other.layout->bodies.size() - shared);
    return difference;
}

} // namespace cairn::viewer
