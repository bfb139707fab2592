// Sequences of calls of the C API, generated from the table of the API, on two worlds at a time. A rejected call gives
// a reason, and changes neither a world nor the memory for its results; reading calls change nothing; no call changes
// another world; restoring a world gives the saved one; nothing crashes.
#include "c_api_fuzz.h"
#include "c_api_by_hand.h"

#include <cstdio>
#include <cstdlib>

namespace cairn_fuzz {

namespace {

constexpr std::size_t max_handles = 60;

std::map<std::string, CCallCount>& counts() {
    static std::map<std::string, CCallCount> all;
    return all;
}

std::uint64_t hash(const cairn_world* world) {
    std::uint64_t value = 0;
    require(cairn_world_get_state_hash(world, &value) == CAIRN_OK, "the hash of the state");
    return value;
}

const char* current = ""; // name of the current call

void call_one(CState& s) {
    const int made = int(c_calls.size()), number = s.bytes.pick(256);
    const bool by_hand = number >= made || s.bytes.pick(4) == 0;
    // The first of these is a step, which is made more often than rarely used calls.
    const std::size_t which = by_hand && s.bytes.pick(4) ? std::size_t(s.bytes.pick(256)) % calls_by_hand.size() : 0;
    const CCallInfo& info = by_hand ? calls_by_hand[which].info : c_calls[std::size_t(number)];
    current = info.name;
    const int target = s.bytes.pick(8) ? 0 : 1;
    cairn_world* const world = s.bytes.pick(64) ? s.worlds[std::size_t(target)] : nullptr;
    const std::uint64_t before[] = {hash(s.worlds[0]), hash(s.worlds[1])};
    const int second_worlds = s.second_worlds;
    const cairn_result result = by_hand ? calls_by_hand[which].call(s, world) : c_call(world, s.bytes, number);
    CCallCount& count = counts()[info.name];
    ++(result == CAIRN_OK ? count.accepted : count.refused);
    for (int i = 0; i < 2; ++i) {
        if (i == 1 && second_worlds != s.second_worlds) continue; // the second world was replaced
        const bool may_change = result == CAIRN_OK && info.changes && world == s.worlds[std::size_t(i)];
        require(may_change || hash(s.worlds[std::size_t(i)]) == before[i],
                "a call has changed a world that it must not change");
    }
    if (result == CAIRN_OK) return;
    require(info.can_fail, "a call has failed that cannot");
    require(cairn_last_error()[0] != '\0', "an error without a text");
    require(result != CAIRN_ERROR_OTHER, "an error that is none of the known ones");
    require(world || !info.changes || result == CAIRN_ERROR_INVALID_HANDLE || result == CAIRN_ERROR_INVALID_VALUE,
            "no world, and another error");
}

} // namespace

void require(bool holds, const char* what) {
    if (holds) return;
    std::fprintf(stderr, "cairn_%s: %s: %s\n", current, what, cairn_last_error());
    std::abort();
}

const std::map<std::string, CCallCount>& c_call_counts() {
    for (const CCallInfo& call : c_calls) counts()[call.name].can_fail = call.can_fail;
    for (const ByHand& call : calls_by_hand) counts()[call.info.name].can_fail = call.info.can_fail;
    return counts();
}

// Adds four bodies with a box each (one of them a character), a joint and a force field, so that every call has
// something to act on.
static void add_initial_bodies(CBytes& bytes, cairn_world* world) {
    const cairn_shape box = cairn_default_shape(CAIRN_SHAPE_BOX);
    for (int i = 0; i < 4; ++i) {
        cairn_body_def def = cairn_default_body_def();
        def.type = i == 0 ? CAIRN_BODY_TYPE_STATIC : i == 1 ? CAIRN_BODY_TYPE_KINEMATIC : CAIRN_BODY_TYPE_DYNAMIC;
        def.position.y = i;
        cairn_shape_id shape;
        require(cairn_world_create_body(world, &def, &bytes.bodies.emplace_back()) == CAIRN_OK, "a body");
        require(cairn_world_add_shape(world, bytes.bodies.back(), &box, nullptr, &shape) == CAIRN_OK, "a shape");
        bytes.shapes.push_back(shape);
        const cairn_character_def walks = cairn_default_character_def();
        if (i == 1) require(cairn_body_set_character(world, bytes.bodies.back(), &walks) == CAIRN_OK, "a character");
    }
    cairn_joint_def joint = cairn_default_joint_def();
    joint.body_a = bytes.bodies[bytes.bodies.size() - 2];
    joint.body_b = bytes.bodies.back();
    const cairn_force_field field = cairn_default_force_field();
    require(cairn_world_create_joint(world, &joint, &bytes.joints.emplace_back()) == CAIRN_OK, "a joint");
    require(cairn_world_add_force_field(world, &field, &bytes.fields.emplace_back()) == CAIRN_OK, "a force field");
}

CState::CState(std::span<const std::uint8_t> data) : bytes(data) {
    for (cairn_world*& world : worlds) require(cairn_world_create(nullptr, &world) == CAIRN_OK, "a world");
    add_initial_bodies(bytes, worlds[1]);
    add_initial_bodies(bytes, worlds[0]);
    const float corners[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
    const std::uint32_t triangles[] = {0, 2, 1, 0, 3, 2};
    const float heights[] = {0, 1, 0, 0, 0.5f, 0, 1, 0, 0};
    bytes.geometries.resize(3);
    cairn_geometry** const made = bytes.geometries.data();
    require(cairn_geometry_create_hull(corners, 4, 0, made) == CAIRN_OK, "a hull");
    require(cairn_geometry_create_mesh(corners, 4, 12, triangles, 6, made + 1) == CAIRN_OK, "a mesh");
    require(cairn_geometry_create_height_field(3, 3, {1, 1}, heights, 9, made + 2) == CAIRN_OK, "a height field");
}

CState::~CState() {
    for (cairn_world* world : worlds) cairn_world_destroy(world);
    for (cairn_geometry* geometry : bytes.geometries) cairn_geometry_release(geometry);
    for (cairn_snapshot* snapshot : snapshots) cairn_snapshot_release(snapshot);
}

} // namespace cairn_fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace cairn_fuzz;
    CState state(std::span(data, size));
    while (!state.bytes.is_empty() && state.bytes.bodies.size() < max_handles) call_one(state);
    return 0;
}
