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

// m, in the whole step: a body that moves by less counts as being at rest until the middle of the step.
constexpr double still = 2e-6;

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

// Lists the bodies of awake islands, each of which is a linked list. The list of the last step, mostly the same, tells
// which links to prefetch. Returns their number.
int list_awake(const Bodies& bodies, const Islands& islands, std::vector<std::int32_t>& list) {
    std::size_t count = 0;
    for (const std::int32_t i : islands.awake)
        for (std::int32_t b = islands.all[i].first_body; b != none; b = bodies.links[b].next_in_island, ++count) {
            if (const std::size_t later = count + bodies_ahead; later < list.size())
                prefetch(&(bodies.links.data() + list[later])->next_in_island);
            if (count < list.size())
                list[count] = b;
            else
                list.push_back(b);
        }
    list.resize(count);
    return int(count);
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
    std::vector<std::int32_t>& moving = narrow.moving;
    for (const std::int32_t b : moving) narrow.motion_ahead[std::size_t(b)] = {};
    narrow.motion_ahead.resize(bodies.links.size());
    const int awake = list_awake(bodies, islands, moving);
    const BodyMotion* const motions = bodies.motion.data();
    const BodyLinks* const links = bodies.links.data();
    CountedPose* const counted = bodies.counted.data();
    Travel *const travel = bodies.travel.data(), *const ahead = bodies.ahead.data();
    MotionAhead* const motions_ahead = narrow.motion_ahead.data();
    const auto look_ahead = [=](std::int32_t b) {
        const BodyMotion& motion = motions[b];
        const float bound = predicted_rotation(dt * math::length(motion.w)) * links[b].radius;
        ahead[b] = travel[b] + travelled(double(dt * math::length(motion.v) + bound));
        const bool moves =
            !(motion.v == math::Vec3{} && motion.w == math::Vec3{}) && ahead[b] - travel[b] > budget_of(still);
        motions_ahead[b] = {motion.v, bound, motion.w, moves, links[b].joint_count > 0, false};
    };
    thread_pool.for_chunks(awake, bodies_per_chunk, [&](int begin, int end, int) {
        const std::int32_t* const list = moving.data();
        for (int k = begin; k < end; ++k) {
            if (k + bodies_ahead < awake) prefetch_poses(bodies, list[k + bodies_ahead]);
            const std::int32_t b = list[k];
            const BodyMotion& motion = motions[b];
            if (!rests(counted[b], motion, links[b].radius, shift, speed))
                count(counted[b], travel[b], motion, links[b].radius);
            look_ahead(b);
        }
    });
    for (const std::int32_t b : bodies.kinematics) {
        const BodyMotion& motion = motions[b];
        if (!stands_still(counted[b], motion)) count(counted[b], travel[b], motion, links[b].radius);
        look_ahead(b);
        moving.push_back(b);
    }
}

} // namespace cairn
