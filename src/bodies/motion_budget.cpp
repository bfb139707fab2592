#include "bodies/motion_budget.h"

#include "bodies/bodies.h"

#include "core/cache.h"
#include "state/substeps.h"

#include <algorithm>

namespace cairn {

namespace {

// m/s^2: times the square of the substep (and the radius of bodies smaller than 1 m) it is the displacement up to which
// the motion of a slow body is not counted: a hundredth of what a soft contact sinks under a body's own weight.
constexpr double max_creep = 0.1;
constexpr double max_step = 0.25; // share of that length in one step: the solver cannot detect such a slow creep

constexpr int bodies_per_chunk = 1024; // bodies that a thread takes at a time
constexpr int bodies_ahead = 8;        // bodies ahead of the loop that are prefetched

void prefetch_poses(const Bodies& bodies, std::int32_t b) {
    prefetch(&bodies.motion[b].x);
    prefetch(&bodies.motion[b].q);
    prefetch(&bodies.counted[b]);
    prefetch(&bodies.mass[b]);
}

bool is_within(math::DVec3 v, double most) { return math::dot(v, v) <= most * most; }

bool rests(const CountedPose& counted, const BodyMotion& motion, float radius, double shift, double speed) {
    const double most = shift * std::min(radius, 1.0f);
    // A turn by a small angle a changes the unit quaternion by a / 2.
    const double turn = square_difference(counted.q, motion.q);
    return is_within(math::to_double(motion.v), speed) &&
           is_within(double(radius) * math::to_double(motion.w), speed) && is_within(motion.x - counted.x, most) &&
           4 * turn * double(radius) * double(radius) <= most * most;
}

// Compares exactly, as planes are infinite and magnify any rotation.
bool stands_still(const CountedPose& counted, const BodyMotion& motion) {
    return motion.v == math::Vec3{} && motion.w == math::Vec3{} && motion.x == counted.x && motion.q.x == counted.q.x &&
           motion.q.y == counted.q.y && motion.q.z == counted.q.z && motion.q.w == counted.q.w;
}

void count(CountedPose& counted, Travel& travel, const BodyMotion& motion, float radius) {
    travel += travelled(uncounted(counted, motion, radius));
    counted = {motion.x, motion.q};
}

} // namespace

void spend_budget(Bodies& bodies, std::int32_t b) {
    const BodyMotion& motion = bodies.motion[b];
    bodies.counted[b] = {motion.x, motion.q};
    spend_separations(bodies, b);
}

void spend_separations(Bodies& bodies, std::int32_t b) {
    bodies.travel[b] += travelled(max_leap);
    bodies.ahead[b] = bodies.boxes_until[b] = bodies.travel[b];
}

void count_motion(Bodies& bodies, const Islands& islands, const WorldDef& settings, NarrowScratch& narrow,
                  ThreadPool& thread_pool, float dt) {
    const double h = double(dt) / substeps_of(settings, dt);
    const double shift = max_creep * h * h, speed = max_step * shift / double(dt);
    // The turn reach of bodies that do not move is zero.
    std::vector<std::int32_t>& moving = narrow.moving;
    for (const std::int32_t b : moving) narrow.rotation_bound[b] = 0;
    narrow.rotation_bound.resize(bodies.links.size());
    moving.clear();
    for (const std::int32_t i : islands.awake)
        for (std::int32_t b = islands.all[i].first_body; b != none; b = bodies.links[b].next_in_island)
            moving.push_back(b);
    const int awake = int(moving.size());
    const BodyMotion* const motions = bodies.motion.data();
    const BodyLinks* const links = bodies.links.data();
    CountedPose* const counted = bodies.counted.data();
    Travel *const travel = bodies.travel.data(), *const ahead = bodies.ahead.data();
    float* const turn_reaches = narrow.rotation_bound.data();
    const auto look_ahead = [=](std::int32_t b, float turn_speed) {
        const float reach = turn_reaches[b] = predicted_rotation(dt * turn_speed) * links[b].radius;
        ahead[b] = travel[b] + travelled(double(dt * math::length(motions[b].v) + reach));
    };
    thread_pool.for_chunks(awake, bodies_per_chunk, [&](int begin, int end, int) {
        const std::int32_t* const list = moving.data();
        for (int k = begin; k < end; ++k) {
            if (k + bodies_ahead < awake) prefetch_poses(bodies, list[k + bodies_ahead]);
            const std::int32_t b = list[k];
            const BodyMotion& motion = motions[b];
            if (!rests(counted[b], motion, links[b].radius, shift, speed))
                count(counted[b], travel[b], motion, links[b].radius);
            look_ahead(b, math::length(motion.w));
        }
    });
    for (const std::int32_t b : bodies.kinematics) {
        const BodyMotion& motion = motions[b];
        if (!stands_still(counted[b], motion)) count(counted[b], travel[b], motion, links[b].radius);
        look_ahead(b, math::length(motion.w));
        moving.push_back(b);
    }
}

} // namespace cairn
