#include "bodies/rest.h"

#include "bodies/bodies.h"

#include "core/cache.h"

#include <algorithm>
#include <mutex>

namespace cairn {

namespace {

// How far any point of a body may be from where it rested, less for bodies smaller than a meter: a share of what a soft
// contact sinks under a body's own weight, which is about 10 m/s^2 times the square of the substep. And how fast it may
// be, as a share of that way in one step: the solver cannot see a creep as slow as that.
constexpr double sinking = 10.0, max_shift = 0.01, max_step = 0.25;

// How far any point of a body may be from where its contacts were found, as a share of its radius, and in meters at
// most. Points that are moved along instead keep their normal: what they miss is of second order, a shift of a
// millimeter times a turn of three thousandths; and corners that come near are found at latest when they are that much
// nearer.
constexpr double nearness = 3e-3, max_nearness = 5e-3;

constexpr float max_turn = 1.0f; // radians in a step

constexpr int bodies_per_chunk = 1024;  // for threads
constexpr std::size_t bodies_ahead = 8; // that are asked for in time

void prefetch_poses(const State& s, std::int32_t b) {
    ask_cache(&s.motion[b].x);
    ask_cache(&s.motion[b].q);
    ask_cache(&s.resting[b]);
    ask_cache(&s.near[b]);
    ask_cache(&s.mass[b]);
}

bool is_within(math::DVec3 v, double most) { return math::dot(v, v) <= most * most; }

// Whether every point of a body is within `most` of where it is in that pose.
bool is_at(const RestingPose& pose, const BodyMotion& motion, float radius, double most) {
    // A turn by a small angle a changes the unit quaternion by a / 2.
    const double turn = square_difference(pose.q, motion.q);
    return is_within(motion.x - pose.x, most) && 4 * turn * double(radius) * double(radius) <= most * most;
}

bool rests(const RestingPose& pose, const BodyMotion& motion, float radius, double shift, double speed) {
    return is_at(pose, motion, radius, shift * std::min(radius, 1.0f)) && is_within(math::to_double(motion.v), speed) &&
           is_within(double(radius) * math::to_double(motion.w), speed);
}

} // namespace

void count_way(State& s, std::int32_t b) {
    const BodyMotion& motion = s.motion[b];
    RestingPose& pose = s.resting[b];
    s.way[b] += way_from(pose, motion, s.bodies[b].radius);
    pose = {motion.x, motion.q};
    s.ahead[b] = s.way[b];
}

void update_resting(State& s, float dt) {
    const double h = double(dt) / s.in_pass(s.settings.substeps);
    const double shift = max_shift * sinking * h * h, speed = max_step * shift / double(dt);
    const std::uint64_t pass = s.passes + 1;
    auto leave = [&](std::int32_t b) {
        const BodyMotion& motion = s.motion[b];
        count_way(s, b);
        s.left_at[b] = pass;
        const float radius = s.bodies[b].radius;
        if (is_at(s.near[b], motion, radius, std::min(nearness * double(radius), max_nearness))) return;
        s.near[b] = {motion.x, motion.q};
        s.strayed_at[b] = pass;
    };
    const auto look_ahead = [&](std::int32_t b) {
        const float reach = s.narrow.turn_reach[b] = turn_reach(s, b, dt);
        const float way = dt * math::length(s.motion[b].v);
        s.ahead[b] = s.way[b] + double(way + reach);
    };
    s.narrow.turn_reach.assign(s.bodies.size(), 0); // of what does not move
    const bool is_first = s.passes == s.first_pass; // what whirls is asked once a step
    if (is_first) {
        for (const std::int32_t b : s.narrow.whirling) s.narrow.whirls[b] = 0;
        s.narrow.whirls.resize(s.bodies.size());
        s.narrow.whirling.clear();
    }
    std::vector<std::int32_t>& awake = s.narrow.awake;
    awake.clear();
    for (const std::int32_t i : s.awake_islands)
        for (std::int32_t b = s.islands[i].first_body; b != none; b = s.bodies[b].next_in_island) awake.push_back(b);
    const float max_square = (max_turn / dt) * (max_turn / dt);
    std::mutex whirling;
    s.thread_pool->for_chunks(int(awake.size()), bodies_per_chunk, [&](int begin, int end, int) {
        for (std::size_t k = std::size_t(begin); k < std::size_t(end); ++k) {
            if (k + bodies_ahead < awake.size()) prefetch_poses(s, awake[k + bodies_ahead]);
            const std::int32_t b = awake[k];
            const BodyMotion& motion = s.motion[b];
            if (!rests(s.resting[b], motion, s.bodies[b].radius, shift, speed)) leave(b);
            look_ahead(b);
            if (is_first && math::dot(motion.w, motion.w) > max_square && !s.mass[b].isotropic) {
                const std::lock_guard lock(whirling);
                s.narrow.whirling.push_back(b); // in any order
                s.narrow.whirls[b] = 1;
            }
        }
    });
    for (const std::int32_t b : s.kinematics) {
        const BodyMotion& motion = s.motion[b];
        const RestingPose& pose = s.resting[b];
        // Exactly: planes reach far.
        const bool still = motion.v == math::Vec3{} && motion.w == math::Vec3{} && motion.x == pose.x &&
                           motion.q.x == pose.q.x && motion.q.y == pose.q.y && motion.q.z == pose.q.z &&
                           motion.q.w == pose.q.w;
        if (!still) leave(b);
        look_ahead(b);
    }
}

float whirl_in_contact(const State& s) {
    float fastest = 0;
    for (const std::int32_t b : s.narrow.whirling)
        if (const BodyLinks& links = s.bodies[b]; links.contact_count > 0 && links.joint_count == 0)
            fastest = std::max(fastest, math::length(s.motion[b].w));
    return fastest;
}

} // namespace cairn
