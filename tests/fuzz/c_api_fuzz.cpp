// Sequences of calls of the C API, made from the table of the API. What is refused says why and changes nothing; a
// world that is restored is the one that was saved; nothing crashes.
#include "c_api_calls.h"

#include <cstdio>
#include <cstdlib>

namespace {

using namespace cairn_fuzz;

constexpr int max_steps = 60;
constexpr std::size_t max_bodies = 60;

void require(bool holds, const char* what) {
    if (holds) return;
    std::fprintf(stderr, "%s: %s\n", what, cairn_last_error());
    std::abort();
}

std::uint64_t hash(const cairn_world* world) {
    std::uint64_t value = 0;
    require(cairn_world_get_state_hash(world, &value) == CAIRN_OK, "the hash of the state");
    return value;
}

struct Geometries {
    cairn_geometry *hull = nullptr, *mesh = nullptr, *field = nullptr;
    Geometries() {
        const float corners[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
        const std::uint32_t triangles[] = {0, 2, 1, 0, 3, 2};
        const float heights[] = {0, 1, 0, 0, 0.5f, 0, 1, 0, 0};
        require(cairn_geometry_create_hull(corners, 4, 0, &hull) == CAIRN_OK, "a hull");
        require(cairn_geometry_create_mesh(corners, 4, 12, triangles, 6, &mesh) == CAIRN_OK, "a mesh");
        require(cairn_geometry_create_height_field(3, 3, {1, 1}, heights, 9, &field) == CAIRN_OK, "a height field");
    }
};

// What takes long, or is not made from the table.
cairn_result by_hand(cairn_world* world, CBytes& bytes, int what, int& steps) {
    if (what < 2) {
        if (++steps > max_steps) return CAIRN_OK;
        return cairn_world_step(world, bytes.pick(8) ? 1.0f / 60 : float(bytes.number()));
    }
    if (what == 2) return cairn_world_set_threads(world, bytes.pick(6));
    if (what == 3) {
        cairn_snapshot* snapshot = nullptr;
        const std::uint64_t before = hash(world);
        require(cairn_world_save(world, &snapshot) == CAIRN_OK, "a snapshot");
        if (++steps <= max_steps) require(cairn_world_step(world, 1.0f / 60) == CAIRN_OK, "a step");
        require(cairn_world_restore(world, snapshot) == CAIRN_OK, "what was saved");
        cairn_snapshot_release(snapshot);
        require(hash(world) == before, "what is restored is not what was saved");
        return CAIRN_OK;
    }
    double positions[3 * 16];
    float velocities[3 * 16];
    cairn_body_arrays arrays = cairn_default_body_arrays();
    arrays.positions = positions;
    arrays.linear_velocities = velocities;
    if (bytes.pick(8) == 0) arrays.position_stride = std::size_t(bytes.pick(32));
    std::array<cairn_body_id, 16> ids;
    const auto count = std::size_t(bytes.pick(9)); // at twice the stride, at most
    for (cairn_body_id& id : ids) id = bytes.body_id();
    return cairn_world_read_bodies(world, ids.data(), count, &arrays);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const Geometries geometries;
    CBytes bytes(std::span(data, size));
    bytes.geometries = {geometries.hull, geometries.mesh, geometries.field};
    cairn_world* world = nullptr;
    require(cairn_world_create(nullptr, &world) == CAIRN_OK, "a world");
    int steps = 0;
    while (!bytes.is_empty() && bytes.bodies.size() < max_bodies) {
        const int call = bytes.pick(c_call_count + 40);
        const std::uint64_t before = hash(world);
        const cairn_result result =
            call < c_call_count ? c_call(world, bytes, call) : by_hand(world, bytes, call % 5, steps);
        if (result == CAIRN_OK) continue;
        require(hash(world) == before, "a refused call has changed the world");
        require(cairn_last_error()[0] != '\0', "an error without a text");
        require(result != CAIRN_ERROR_OTHER, "an error that is none of the known ones");
    }
    cairn_world_destroy(world);
    return 0;
}
