#include "c_api_by_hand.h"

#include <cmath>

namespace cairn_fuzz {

namespace {

constexpr int max_steps = 60, max_scenes = 6, max_threads_set = 2;
constexpr std::size_t max_geometries = 12, max_snapshots = 4;

// --- worlds

cairn_result step(CState& s, cairn_world* world) {
    if (++s.steps > max_steps) return CAIRN_OK;
    return cairn_world_step(world, s.bytes.pick(8) ? 1.0f / 60 : float(s.bytes.number()));
}

cairn_result steps(CState& s, cairn_world* world) {
    const auto count = std::size_t(s.bytes.pick(4));
    if ((s.steps += int(count)) > max_steps) return CAIRN_OK;
    return cairn_world_steps(world, s.bytes.pick(8) ? 1.0f / 60 : float(s.bytes.number()), count);
}

cairn_result set_threads(CState& s, cairn_world* world) {
    if (++s.threads > max_threads_set) return CAIRN_OK;
    return cairn_world_set_threads(world, s.bytes.pick(4) ? s.bytes.pick(6) : 257 + s.bytes.whole() % 1000);
}

// Creates a world, which replaces the second one.
cairn_result create(CState& s, cairn_world*) {
    Given<cairn_world_def> def(s.bytes, draw_world_def(s.bytes), 4);
    Room<cairn_world*> world(s.bytes, 1);
    const cairn_result result = cairn_world_create(def.get(), world.get());
    if (result != CAIRN_OK) return done(result, world);
    cairn_world_destroy(s.worlds[1]);
    s.worlds[1] = world[0];
    ++s.second_worlds;
    return result;
}

cairn_result destroy(CState&, cairn_world*) {
    cairn_world_destroy(nullptr); // no effect; worlds are destroyed when another one replaces them
    return CAIRN_OK;
}

// Saves the world, and checks that restoring it at once changes nothing; the snapshot is kept for either world.
cairn_result save(CState& s, cairn_world* world) {
    Room<cairn_snapshot*> snapshot(s.bytes, 1);
    const cairn_result result = cairn_world_save(world, snapshot.get());
    if (result != CAIRN_OK) return done(result, snapshot);
    std::uint64_t before = 0, after = 0;
    require(cairn_world_get_state_hash(world, &before) == CAIRN_OK, "the hash of the state");
    if (++s.steps <= max_steps) require(cairn_world_step(world, 1.0f / 60) == CAIRN_OK, "a step");
    require(cairn_world_restore(world, snapshot[0]) == CAIRN_OK, "what was saved");
    require(cairn_world_get_state_hash(world, &after) == CAIRN_OK, "the hash of the state");
    require(before == after, "what is restored is not what was saved");
    if (s.snapshots.size() < max_snapshots)
        s.snapshots.push_back(snapshot[0]);
    else
        cairn_snapshot_release(snapshot[0]);
    return result;
}

const cairn_snapshot* any_snapshot(CState& s) {
    if (s.snapshots.empty() || s.bytes.pick(16) == 0) return nullptr;
    return s.snapshots[std::size_t(s.bytes.pick(int(s.snapshots.size())))];
}

cairn_result restore(CState& s, cairn_world* world) { return cairn_world_restore(world, any_snapshot(s)); }

cairn_result snapshot_sizes(CState& s, cairn_world*) {
    const cairn_snapshot* const snapshot = any_snapshot(s);
    Room<cairn_snapshot_sizes> sizes(s.bytes, 1);
    return done(cairn_snapshot_get_sizes(snapshot, sizes.get()), sizes);
}

cairn_result snapshot_release(CState& s, cairn_world*) {
    cairn_snapshot_release(nullptr);
    if (s.snapshots.empty()) return CAIRN_OK;
    cairn_snapshot_release(s.snapshots.back());
    s.snapshots.pop_back();
    return CAIRN_OK;
}

// An array with a stride of 0 to 31 bytes, mostly 0; the array is long enough for the requested stride.
template <class T> struct Column {
    Column(CBytes& bytes, std::size_t bodies, std::size_t numbers)
        : stride(bytes.pick(4) ? 0 : std::size_t(bytes.pick(32))),
          room(bytes, (bodies * (stride ? stride : numbers * sizeof(T)) + sizeof(T) - 1) / sizeof(T) + numbers),
          is_wanted(bytes.pick(4) != 0) {}
    T* get() { return is_wanted ? room.get() : nullptr; }

    std::size_t stride;
    Room<T> room;
    bool is_wanted;
};

cairn_result read_bodies(CState& s, cairn_world* world) {
    std::vector<cairn_body_id> ids(std::size_t(s.bytes.pick(9)));
    for (cairn_body_id& id : ids) id = s.bytes.body_id();
    std::size_t count = ids.size();
    const bool all = s.bytes.pick(3) == 0;
    // Count remains unchanged without a world.
    if (all && s.bytes.pick(4)) cairn_world_get_bodies(world, nullptr, 0, &count);
    Column<double> positions(s.bytes, count, 3);
    Column<float> rotations(s.bytes, count, 4), linear(s.bytes, count, 3), angular(s.bytes, count, 3);
    cairn_body_arrays arrays = cairn_default_body_arrays();
    arrays.positions = positions.get(), arrays.position_stride = positions.stride;
    arrays.rotations = rotations.get(), arrays.rotation_stride = rotations.stride;
    arrays.linear_velocities = linear.get(), arrays.linear_velocity_stride = linear.stride;
    arrays.angular_velocities = angular.get(), arrays.angular_velocity_stride = angular.stride;
    if (s.bytes.pick(32) == 0) arrays.struct_size = std::uint32_t(s.bytes.pick(256));
    Given<cairn_body_arrays> given(s.bytes, arrays, 64);
    const cairn_result result = cairn_world_read_bodies(world, all ? nullptr : ids.data(), count, given.get());
    return done(result, positions.room, rotations.room, linear.room, angular.room);
}

// --- joints

cairn_result joint_limits(CState& s, cairn_world* world) {
    const cairn_joint_id joint = s.bytes.joint_id();
    const auto capacity = std::size_t(s.bytes.pick(4));
    Room<cairn_joint_limit> limits(s.bytes, capacity);
    Room<std::size_t> count(s.bytes, 1);
    return done(cairn_joint_get_limits(world, joint, limits.get(), capacity, count.get()), limits, count);
}

cairn_result joint_drives(CState& s, cairn_world* world) {
    const cairn_joint_id joint = s.bytes.joint_id();
    const auto capacity = std::size_t(s.bytes.pick(4));
    Room<cairn_joint_drive> drives(s.bytes, capacity);
    Room<std::size_t> count(s.bytes, 1);
    return done(cairn_joint_get_drives(world, joint, drives.get(), capacity, count.get()), drives, count);
}

cairn_result joint_at(CState& s, cairn_world* world) {
    const cairn_body_id a = s.bytes.pick(4) ? s.bytes.body_id() : cairn_body_id{}, b = s.bytes.body_id();
    Given<cairn_joint> joint(s.bytes, draw_joint(s.bytes), 64);
    Room<cairn_joint_def> def(s.bytes, 1, cairn_default_joint_def());
    const cairn_result result =
        cairn_world_joint_at(world, a, b, s.bytes.position(), s.bytes.vec3(), joint.get(), def.get());
    return done(result, def);
}

cairn_result spring(CState& s, cairn_world*) {
    cairn_spring_from_frequency(float(s.bytes.number()), float(s.bytes.number()));
    return CAIRN_OK;
}

// --- hulls, meshes and height fields

// Keeps a new geometry in place of the previous one of its kind, which shapes may still use.
cairn_result kept(CState& s, cairn_result result, Room<cairn_geometry*>& made, std::size_t kind) {
    if (result != CAIRN_OK) return done(result, made);
    if (s.bytes.geometries.size() < max_geometries) {
        s.bytes.geometries.push_back(made[0]);
    } else {
        cairn_geometry_release(s.bytes.geometries[kind]);
        s.bytes.geometries[kind] = made[0];
    }
    return result;
}

std::vector<float> numbers(CBytes& bytes, std::size_t count) {
    std::vector<float> list(count);
    for (float& x : list) x = bytes.pick(64) ? float(bytes.pick(16)) / 4 : float(bytes.number());
    return list;
}

// Points of x, y, z with the stride between them, in bytes; the array is long enough for it.
struct Points {
    explicit Points(CBytes& bytes)
        : count(std::size_t(bytes.pick(10))), stride(bytes.pick(4) ? 0 : std::size_t(bytes.pick(5)) * 5) {
        list = numbers(bytes, std::max<std::size_t>(3 * count, (count * stride + 12) / 4));
        if (bytes.pick(32) == 0) is_null = true;
    }
    const float* get() const { return is_null ? nullptr : list.data(); }
    std::size_t count, stride;
    std::vector<float> list;
    bool is_null = false;
};

cairn_result create_hull(CState& s, cairn_world*) {
    const Points points(s.bytes);
    Room<cairn_geometry*> made(s.bytes, 1);
    return kept(s, cairn_geometry_create_hull(points.get(), points.count, points.stride, made.get()), made, 0);
}

// Materials, and the material indices of `parts` parts, or of a different number of them.
struct Materials {
    Materials(CBytes& bytes, std::size_t parts) : materials(std::size_t(bytes.pick(4))) {
        for (cairn_material& material : materials) {
            material = cairn_default_material();
            material.restitution = float(bytes.pick(5)) / 4;
            material.dynamic_friction = float(bytes.pick(16) ? bytes.pick(4) : bytes.number());
        }
        numbers.resize(bytes.pick(8) ? parts : std::size_t(bytes.pick(4)));
        for (std::uint16_t& number : numbers) number = std::uint16_t(bytes.pick(bytes.pick(32) ? 4 : 70'000));
    }
    std::vector<cairn_material> materials;
    std::vector<std::uint16_t> numbers;
};

cairn_result create_mesh(CState& s, cairn_world*) {
    const Points points(s.bytes);
    std::vector<std::uint32_t> indices(std::size_t(s.bytes.pick(16) ? 3 * s.bytes.pick(8) : s.bytes.pick(24)));
    for (std::uint32_t& index : indices)
        index = std::uint32_t(s.bytes.pick(64) ? s.bytes.pick(std::max(int(points.count), 1)) : s.bytes.whole());
    const std::uint32_t* const list = s.bytes.pick(32) ? indices.data() : nullptr;
    Room<cairn_geometry*> made(s.bytes, 1);
    if (s.bytes.pick(2)) {
        const Materials own(s.bytes, indices.size() / 3);
        const cairn_result result = cairn_geometry_create_mesh_with_materials(
            points.get(), points.count, points.stride, list, indices.size(), own.materials.data(), own.materials.size(),
            own.numbers.data(), own.numbers.size(), made.get());
        return kept(s, result, made, 1);
    }
    const cairn_result result =
        cairn_geometry_create_mesh(points.get(), points.count, points.stride, list, indices.size(), made.get());
    return kept(s, result, made, 1);
}

cairn_result create_height_field(CState& s, cairn_world*) {
    const int columns = s.bytes.pick(16) ? s.bytes.pick(5) : s.bytes.whole();
    const int rows = s.bytes.pick(16) ? s.bytes.pick(5) : s.bytes.whole();
    const bool fits = columns >= 0 && columns < 8 && rows >= 0 && rows < 8 && s.bytes.pick(8) != 0;
    const std::vector<float> heights = numbers(s.bytes, fits ? std::size_t(columns * rows) : 3);
    const float* const list = s.bytes.pick(32) ? heights.data() : nullptr;
    const cairn_vec2 spacing = {float(s.bytes.positive()), float(s.bytes.positive())};
    Room<cairn_geometry*> made(s.bytes, 1);
    if (s.bytes.pick(2)) {
        const Materials own(s.bytes, fits && columns > 0 && rows > 0 ? std::size_t((columns - 1) * (rows - 1)) : 3);
        const cairn_result result = cairn_geometry_create_height_field_with_materials(
            columns, rows, spacing, list, heights.size(), own.materials.data(), own.materials.size(),
            own.numbers.data(), own.numbers.size(), made.get());
        return kept(s, result, made, 2);
    }
    const cairn_result result =
        cairn_geometry_create_height_field(columns, rows, spacing, list, heights.size(), made.get());
    return kept(s, result, made, 2);
}

cairn_result geometry_release(CState& s, cairn_world*) {
    cairn_geometry_release(nullptr);
    if (s.bytes.geometries.size() <= 3) return CAIRN_OK;
    cairn_geometry_release(s.bytes.geometries.back());
    s.bytes.geometries.pop_back();
    return CAIRN_OK;
}

// Reads a list of a geometry through a call that fills an array of limited capacity.
template <class T, class Call> cairn_result list_of(CState& s, const Call& call) {
    const cairn_geometry* const geometry = s.bytes.geometry();
    const auto capacity = std::size_t(s.bytes.pick(16));
    Room<T> list(s.bytes, capacity);
    Room<std::size_t> count(s.bytes, 1);
    return done(call(geometry, list.get(), capacity, count.get()), list, count);
}

template <class T, class Call> cairn_result one_of(CState& s, const Call& call) {
    const cairn_geometry* const geometry = s.bytes.geometry();
    Room<T> answer(s.bytes, 1);
    return done(call(geometry, answer.get()), answer);
}

cairn_result vertices(CState& s, cairn_world*) { return list_of<cairn_vec3>(s, cairn_geometry_get_vertices); }
cairn_result indices(CState& s, cairn_world*) { return list_of<std::uint32_t>(s, cairn_geometry_get_indices); }
cairn_result materials(CState& s, cairn_world*) { return list_of<cairn_material>(s, cairn_geometry_get_materials); }
cairn_result material_numbers(CState& s, cairn_world*) {
    return list_of<std::uint16_t>(s, cairn_geometry_get_material_numbers);
}
cairn_result heights(CState& s, cairn_world*) { return list_of<float>(s, cairn_geometry_get_heights); }
cairn_result face(CState& s, cairn_world*) {
    const auto number = std::size_t(s.bytes.pick(16) ? s.bytes.pick(8) : s.bytes.bits());
    return list_of<std::uint32_t>(s, [number](auto geometry, auto list, auto capacity, auto count) {
        return cairn_geometry_get_face(geometry, number, list, capacity, count);
    });
}
cairn_result dropped(CState& s, cairn_world*) { return one_of<std::size_t>(s, cairn_geometry_get_dropped_triangles); }
cairn_result face_count(CState& s, cairn_world*) { return one_of<std::size_t>(s, cairn_geometry_get_face_count); }
cairn_result volume(CState& s, cairn_world*) { return one_of<double>(s, cairn_geometry_get_volume); }
cairn_result grid(CState& s, cairn_world*) {
    const cairn_geometry* const geometry = s.bytes.geometry();
    Room<int> columns(s.bytes, 1), rows(s.bytes, 1);
    Room<cairn_vec2> spacing(s.bytes, 1);
    return done(cairn_geometry_get_grid(geometry, columns.get(), rows.get(), spacing.get()), columns, rows, spacing);
}

// --- scenes: from and to memory, and of files those that cannot be there

cairn_result scene_load(CState& s, cairn_world*) {
    static constexpr const char* paths[] = {nullptr, "", "/nonexistent/scene.gltf", "/", "scene.unknown"};
    Room<cairn_world*> world(s.bytes, 1);
    Room<float> time_step(s.bytes, 1);
    return done(cairn_scene_load(paths[s.bytes.pick(5)], world.get(), time_step.get()), world, time_step);
}

cairn_result scene_save(CState& s, cairn_world* world) {
    static constexpr const char* paths[] = {nullptr, "", "/nonexistent/scene.gltf", "/nonexistent/scene.glb", "/"};
    return cairn_scene_save(world, paths[s.bytes.pick(5)]);
}

cairn_result scene_save_to_memory(CState& s, cairn_world* world) {
    if (++s.scenes > max_scenes) return CAIRN_OK;
    const auto capacity = std::size_t(s.bytes.pick(256)) * 16;
    Room<char> text(s.bytes, capacity);
    Room<std::size_t> length(s.bytes, 1);
    return done(cairn_scene_save_to_memory(world, text.get(), capacity, length.get()), text, length);
}

// Loads the text of a saved world, sometimes truncated or with a modified byte, in place of the second world.
cairn_result scene_load_from_memory(CState& s, cairn_world* world) {
    if (++s.scenes > max_scenes) return CAIRN_OK;
    std::size_t length = 0;
    if (const cairn_result result = cairn_scene_save_to_memory(world, nullptr, 0, &length); result != CAIRN_OK)
        return result;
    std::vector<char> text(length + 1);
    require(cairn_scene_save_to_memory(world, text.data(), text.size(), &length) == CAIRN_OK, "a scene that was saved");
    const std::size_t place = std::size_t(s.bytes.bits()) % text.size();
    text.resize(s.bytes.pick(8) ? length : place);
    text.shrink_to_fit();
    if (s.bytes.pick(2) && !text.empty()) text[place % text.size()] = char(s.bytes.pick(256));
    const char* const name = s.bytes.text();
    Room<cairn_world*> loaded(s.bytes, 1);
    Room<float> time_step(s.bytes, 1);
    const cairn_result result =
        cairn_scene_load_from_memory(text.data(), text.size(), name, loaded.get(), time_step.get());
    if (result != CAIRN_OK) return done(result, loaded, time_step);
    cairn_world_destroy(s.worlds[1]);
    s.worlds[1] = loaded[0];
    ++s.second_worlds;
    return result;
}

// Calls that need no arguments and cannot fail.
cairn_result constants(CState&, cairn_world*) {
    require(cairn_abi_version() == CAIRN_ABI_VERSION && cairn_version()[0] && cairn_instruction_set()[0], "a version");
    require(cairn_hardware_threads() >= 1, "threads");
    require(cairn_last_error() && cairn_last_error_field() && cairn_last_error_value(), "a text");
    return CAIRN_OK;
}

constexpr ByHand calls[] = {
    {{"world_step", true, true}, step},
    {{"world_steps", true, true}, steps},
    {{"world_set_threads", false, true}, set_threads},
    {{"world_create", false, true}, create},
    {{"world_destroy", false, false}, destroy},
    {{"world_save", false, true}, save},
    {{"world_restore", true, true}, restore},
    {{"snapshot_get_sizes", false, true}, snapshot_sizes},
    {{"snapshot_release", false, false}, snapshot_release},
    {{"world_read_bodies", false, true}, read_bodies},
    {{"joint_get_limits", false, true}, joint_limits},
    {{"joint_get_drives", false, true}, joint_drives},
    {{"world_joint_at", false, true}, joint_at},
    {{"spring_from_frequency", false, false}, spring},
    {{"geometry_create_hull", false, true}, create_hull},
    {{"geometry_create_mesh, geometry_create_mesh_with_materials", false, true}, create_mesh},
    {{"geometry_create_height_field, geometry_create_height_field_with_materials", false, true}, create_height_field},
    {{"geometry_release", false, false}, geometry_release},
    {{"geometry_get_vertices", false, true}, vertices},
    {{"geometry_get_indices", false, true}, indices},
    {{"geometry_get_heights", false, true}, heights},
    {{"geometry_get_materials", false, true}, materials},
    {{"geometry_get_material_numbers", false, true}, material_numbers},
    {{"geometry_get_face", false, true}, face},
    {{"geometry_get_dropped_triangles", false, true}, dropped},
    {{"geometry_get_face_count", false, true}, face_count},
    {{"geometry_get_volume", false, true}, volume},
    {{"geometry_get_grid", false, true}, grid},
    {{"scene_load", false, true}, scene_load},
    {{"scene_save", false, true}, scene_save},
    {{"scene_save_to_memory", false, true}, scene_save_to_memory},
    {{"scene_load_from_memory", false, true}, scene_load_from_memory},
    {{"abi_version, version, instruction_set, hardware_threads, last_error, last_error_field, last_error_value", false,
      false},
     constants},
};

} // namespace

const std::span<const ByHand> calls_by_hand(calls);

} // namespace cairn_fuzz
