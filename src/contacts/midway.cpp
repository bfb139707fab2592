#include "contacts/midway.h"
#include "core/cache.h"
#include "core/room.h"

namespace cairn {

namespace {

constexpr int bodies_per_chunk = 256; // items per chunk of a parallel loop

// The quaternion of a rotation by less than a radian, by series of the sine and the cosine of half of the angle: bodies
// that rotate farther are not tested in the middle of the step.
math::Quat turn_by(math::Vec3 rotation) {
    const math::Vec3 half = 0.5f * rotation;
    const float x2 = math::dot(half, half);
    const float sine = 1 - x2 * (1.0f / 6 - x2 * (1.0f / 120)),
                cosine = 1 - x2 * (0.5f - x2 * (1.0f / 24 - x2 * (1.0f / 720)));
    return {sine * half.x, sine * half.y, sine * half.z, cosine};
}

// Prefetches what is read for the bodies that follow in the list, and for their first shapes.
void prefetch_poses(const Bodies& bodies, const Shapes& shapes, const std::vector<std::int32_t>& list, std::size_t k) {
    if (k + 2 * contacts_ahead < list.size()) {
        const std::int32_t b = list[k + 2 * contacts_ahead];
        prefetch(&bodies.links[b].first_shape), prefetch(&bodies.motion[b].v);
    }
    if (k + contacts_ahead < list.size()) {
        const std::int32_t shape = bodies.links[list[k + contacts_ahead]].first_shape;
        if (shape != none) prefetch(&shapes.poses[shape]), prefetch(&shapes.links[shape]);
    }
}

} // namespace

void pose_midway(const Bodies& bodies, const Shapes& shapes, NarrowScratch& narrow, ThreadPool& thread_pool,
                 float time) {
    if (!(time > 0)) return;
    set_size(narrow.midway_poses, shapes.poses.size());
    set_size(narrow.midway_arms, shapes.poses.size());
    thread_pool.for_chunks(int(narrow.moving.size()), bodies_per_chunk, [&](int begin, int end, int) {
        for (int k = begin; k < end; ++k) {
            prefetch_poses(bodies, shapes, narrow.moving, std::size_t(k));
            const std::int32_t b = narrow.moving[std::size_t(k)];
            const MotionAhead& ahead = narrow.motion_ahead[std::size_t(b)];
            if (!ahead.moves || !ahead.is_tested) continue;
            const BodyMotion& m = bodies.motion[b];
            const math::Quat turn = turn_by(time * m.w);
            const math::Vec3 way = time * m.v;
            for (std::int32_t s = bodies.links[b].first_shape; s != none; s = shapes.links[s].next) {
                ShapePose& pose = narrow.midway_poses[s] = shapes.poses[s];
                math::Vec3& arm = narrow.midway_arms[s] = shapes.links[s].arm;
                math::Vec3 moved = way;
                if (!(arm == math::Vec3{})) {
                    const math::Vec3 turned = math::rotate(turn, arm);
                    moved = way + (turned - arm);
                    arm = turned;
                }
                const math::Quat q = turn * math::Quat{pose.q[0], pose.q[1], pose.q[2], pose.q[3]};
                pose.low[0] += moved.x, pose.low[1] += moved.y, pose.low[2] += moved.z;
                pose.q[0] = q.x, pose.q[1] = q.y, pose.q[2] = q.z, pose.q[3] = q.w;
            }
        }
    });
}

} // namespace cairn
