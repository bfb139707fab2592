// Functions for worlds and snapshots that are not generated from the table.
#include "c_api/generated/convert.h"
#include "c_api/support.h"

#include <cairn/c/cairn.h>

#include <algorithm>
#include <array>
#include <memory>
#include <vector>

using namespace cairn;
using namespace cairn::c_api;

namespace {

constexpr std::size_t chunk = 256; // bodies read at a time

// A caller's array with `numbers` values per body.
template <class T> struct Column {
    T* first;
    std::size_t numbers, stride;

    Column(T* array, std::size_t count, std::size_t given, const char* field)
        : first(array), numbers(count), stride(given ? given : count * sizeof(T)) {
        if (stride < count * sizeof(T))
            refuse(std::string("BodyArrays.") + field, std::to_string(given),
                   "must be 0 or at least " + std::to_string(count * sizeof(T)));
    }
    void write(std::size_t body, const T* values) const {
        std::memcpy(reinterpret_cast<std::byte*>(first) + body * stride, values, numbers * sizeof(T));
    }
};

// The given bodies, all of which must be valid, or without a list all bodies of the world.
std::vector<BodyId> bodies_of(const World& world, const cairn_body_id* bodies, std::size_t count) {
    std::vector<BodyId> ids;
    if (bodies) {
        ids.reserve(count);
        for (std::size_t i = 0; i < count; ++i) {
            ids.push_back(to_cpp(bodies[i]));
            if (!world.is_valid(ids.back())) world.body(ids.back()).type(); // throws
        }
        return ids;
    }
    ids = world.bodies();
    if (ids.size() != count)
        refuse("count", std::to_string(count), "must be the number of bodies, " + std::to_string(ids.size()));
    return ids;
}

} // namespace

cairn_result cairn_world_create(const cairn_world_def* def, cairn_world** world) {
    return guarded([&] {
        required(world, "world");
        const WorldDef settings = def ? to_cpp(versioned(*def, "def", cairn_default_world_def())) : WorldDef{};
        auto made = std::make_unique<cairn_world>();
        made->world() = World(settings);
        *world = made.release();
    });
}

void cairn_world_destroy(cairn_world* world) { delete world; }

cairn_result cairn_world_steps(cairn_world* world, float dt, size_t count) {
    return guarded([&] {
        for (std::size_t i = 0; i < count; ++i) world_of(world).step(dt);
        world_of(world);
    });
}

cairn_result cairn_world_read_bodies(const cairn_world* world, const cairn_body_id* bodies, size_t count,
                                     const cairn_body_arrays* arrays) {
    return guarded([&] {
        const World& from = world_of(world);
        const cairn_body_arrays to = versioned(required(arrays, "arrays"), "arrays", cairn_default_body_arrays());
        const Column positions(to.positions, 3, to.position_stride, "position_stride");
        const Column rotations(to.rotations, 4, to.rotation_stride, "rotation_stride");
        const Column linear(to.linear_velocities, 3, to.linear_velocity_stride, "linear_velocity_stride");
        const Column angular(to.angular_velocities, 3, to.angular_velocity_stride, "angular_velocity_stride");
        const std::vector<BodyId> ids = bodies_of(from, bodies, count);
        std::array<Transform, chunk> poses;
        for (std::size_t begin = 0; begin < ids.size() && (to.positions || to.rotations); begin += chunk) {
            const std::size_t n = std::min(chunk, ids.size() - begin);
            from.read_transforms(std::span(ids).subspan(begin, n), std::span(poses).first(n));
            for (std::size_t i = 0; i < n; ++i) {
                const cairn_quat q = to_c(poses[i].rotation);
                if (to.positions) positions.write(begin + i, &poses[i].position.x);
                if (to.rotations) rotations.write(begin + i, &q.x);
            }
        }
        for (std::size_t i = 0; i < ids.size(); ++i) {
            const Vec3 v = to.linear_velocities ? from.body(ids[i]).linear_velocity() : Vec3(0);
            const Vec3 w = to.angular_velocities ? from.body(ids[i]).angular_velocity() : Vec3(0);
            if (to.linear_velocities) linear.write(i, &v.x);
            if (to.angular_velocities) angular.write(i, &w.x);
        }
    });
}

cairn_result cairn_world_save(const cairn_world* world, cairn_snapshot** snapshot) {
    return guarded([&] {
        required(snapshot, "snapshot");
        *snapshot = std::make_unique<cairn_snapshot>(cairn_snapshot{world_of(world).save()}).release();
    });
}

cairn_result cairn_world_restore(cairn_world* world, const cairn_snapshot* snapshot) {
    return guarded([&] { world_of(world).restore(required(snapshot, "snapshot").snapshot); });
}

cairn_result cairn_snapshot_get_sizes(const cairn_snapshot* snapshot, cairn_snapshot_sizes* sizes) {
    return guarded([&] {
        required(sizes, "sizes");
        *sizes = to_c(required(snapshot, "snapshot").snapshot.sizes());
    });
}

void cairn_snapshot_release(cairn_snapshot* snapshot) { delete snapshot; }
