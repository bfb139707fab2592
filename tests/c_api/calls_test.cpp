// The hand-written part of the C API: worlds, bulk reads, geometries, snapshots, texts, errors.
#include "copy_world.h"

#include "c_api/support.h"

#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <random>
#include <string>
#include <thread>

namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

std::string error() { return cairn_last_error(); }

class CCalls : public testing::Test {
  protected:
    void SetUp() override { CAIRN_CALL(cairn_world_create(nullptr, &world)); }
    ~CCalls() override { cairn_world_destroy(world); }

    // Creates bodies at random positions with random velocities and rotations.
    void scatter(std::size_t count) {
        std::mt19937 random(7);
        std::uniform_real_distribution<float> number(-5, 5);
        for (std::size_t i = 0; i < count; ++i) {
            cairn_body_def def = cairn_default_body_def();
            def.position = {number(random), number(random), number(random)};
            def.rotation = {number(random), number(random), number(random), number(random)};
            def.linear_velocity = {number(random), number(random), number(random)};
            def.angular_velocity = {number(random), number(random), number(random)};
            CAIRN_CALL(cairn_world_create_body(world, &def, &bodies.emplace_back()));
            cairn_shape box = cairn_default_shape(CAIRN_SHAPE_BOX);
            cairn_shape_def shape_def = cairn_default_shape_def();
            shape_def.position = {0.3f, 0.1f, 0}; // so that the center of mass differs from the origin
            cairn_shape_id shape;
            CAIRN_CALL(cairn_world_add_shape(world, bodies.back(), &box, &shape_def, &shape));
        }
    }

    cairn_world* world = nullptr;
    std::vector<cairn_body_id> bodies;
};

TEST_F(CCalls, BulkReadsSayWhatTheSingleOnesSayAtAnyStride) {
    scatter(600);
    for (const std::size_t extra : {0u, 1u, 8u}) { // bytes between bodies, also an odd number of them
        std::vector<std::byte> p(600 * (24 + extra)), q(600 * (16 + extra)), v(600 * (12 + extra)), w(v);
        cairn_body_arrays arrays = cairn_default_body_arrays();
        arrays.positions = reinterpret_cast<double*>(p.data()), arrays.position_stride = 24 + extra;
        arrays.rotations = reinterpret_cast<float*>(q.data()), arrays.rotation_stride = 16 + extra;
        arrays.linear_velocities = reinterpret_cast<float*>(v.data()), arrays.linear_velocity_stride = 12 + extra;
        arrays.angular_velocities = reinterpret_cast<float*>(w.data()), arrays.angular_velocity_stride = 12 + extra;
        const bool all = extra == 8;
        CAIRN_CALL(cairn_world_read_bodies(world, all ? nullptr : bodies.data(), bodies.size(), &arrays));
        for (std::size_t i = 0; i < bodies.size(); ++i) {
            cairn_position position;
            cairn_quat rotation;
            cairn_vec3 linear, angular;
            CAIRN_CALL(cairn_body_get_position(world, bodies[i], &position));
            CAIRN_CALL(cairn_body_get_rotation(world, bodies[i], &rotation));
            CAIRN_CALL(cairn_body_get_linear_velocity(world, bodies[i], &linear));
            CAIRN_CALL(cairn_body_get_angular_velocity(world, bodies[i], &angular));
            ASSERT_EQ(std::memcmp(&p[i * (24 + extra)], &position, 24), 0);
            ASSERT_EQ(std::memcmp(&q[i * (16 + extra)], &rotation, 16), 0);
            ASSERT_EQ(std::memcmp(&v[i * (12 + extra)], &linear, 12), 0);
            ASSERT_EQ(std::memcmp(&w[i * (12 + extra)], &angular, 12), 0);
        }
    }
}

TEST_F(CCalls, BulkReadsOfAStaleBodyWriteNothing) {
    scatter(20);
    CAIRN_CALL(cairn_world_destroy_body(world, bodies[15]));
    std::vector<double> positions(60, -7.0);
    cairn_body_arrays arrays = cairn_default_body_arrays();
    arrays.positions = positions.data();
    EXPECT_EQ(cairn_world_read_bodies(world, bodies.data(), 20, &arrays), CAIRN_ERROR_INVALID_HANDLE);
    EXPECT_EQ(positions, std::vector<double>(60, -7.0));
    EXPECT_EQ(cairn_world_read_bodies(world, nullptr, 20, &arrays), CAIRN_ERROR_INVALID_VALUE);
    EXPECT_EQ(error(), "count: must be the number of bodies, 19, got 20");
    arrays.position_stride = 23;
    EXPECT_EQ(cairn_world_read_bodies(world, nullptr, 19, &arrays), CAIRN_ERROR_INVALID_VALUE);
    EXPECT_EQ(error(), "BodyArrays.position_stride: must be 0 or at least 24, got 23");
    EXPECT_EQ(cairn_world_read_bodies(world, nullptr, 19, nullptr), CAIRN_ERROR_INVALID_VALUE);
    EXPECT_EQ(positions, std::vector<double>(60, -7.0));
}

TEST_F(CCalls, ListsSayHowLongTheyAreAndWriteWhatHasRoom) {
    scatter(10);
    std::array<cairn_body_id, 10> room{};
    size_t count = 0;
    CAIRN_CALL(cairn_world_get_bodies(world, nullptr, 0, &count));
    EXPECT_EQ(count, 10u);
    CAIRN_CALL(cairn_world_get_bodies(world, room.data(), 4, &count));
    EXPECT_EQ(count, 10u);
    EXPECT_EQ(room[3].bits, bodies[3].bits);
    EXPECT_EQ(room[4].bits, 0u);
}

TEST_F(CCalls, TextsAreCutOffWhereTheyHaveNoRoom) {
    cairn_body_def def = cairn_default_body_def();
    def.name = "barrel";
    cairn_body_id body;
    CAIRN_CALL(cairn_world_create_body(world, &def, &body));
    char text[8] = "xxxxxxx";
    size_t length = 0;
    CAIRN_CALL(cairn_body_get_name(world, body, text, 4, &length));
    EXPECT_STREQ(text, "bar");
    EXPECT_EQ(text[4], 'x');
    EXPECT_EQ(length, 6u);
    CAIRN_CALL(cairn_body_get_name(world, body, text, sizeof text, &length));
    EXPECT_STREQ(text, "barrel");
    CAIRN_CALL(cairn_body_get_name(world, body, nullptr, 0, &length));
    EXPECT_EQ(length, 6u);
}

TEST_F(CCalls, GeometriesAreReadBackAndRefuseOtherKinds) {
    const float corners[] = {0, 0, 0, 9, 2, 0, 0, 9, 0, 2, 0, 9, 0, 0, 2, 9}; // stride of 16 bytes
    const uint32_t triangles[] = {0, 1, 2, 0, 2, 3, 1, 1, 2};
    const float heights[] = {0, 1, 2, 3, 4, 5};
    cairn_geometry *hull, *mesh, *field;
    CAIRN_CALL(cairn_geometry_create_hull(corners, 4, 16, &hull));
    CAIRN_CALL(cairn_geometry_create_mesh(corners, 4, 16, triangles, 9, &mesh));
    CAIRN_CALL(cairn_geometry_create_height_field(3, 2, {0.5f, 2}, heights, 6, &field));
    double volume = 0;
    CAIRN_CALL(cairn_geometry_get_volume(hull, &volume));
    EXPECT_NEAR(volume, 8.0 / 6, 1e-6);
    size_t count = 0;
    uint32_t indices[9] = {};
    CAIRN_CALL(cairn_geometry_get_face_count(hull, &count));
    EXPECT_EQ(count, 4u);
    CAIRN_CALL(cairn_geometry_get_face(hull, 3, indices, 9, &count));
    EXPECT_EQ(count, 3u);
    EXPECT_EQ(cairn_geometry_get_face(hull, 4, indices, 9, &count), CAIRN_ERROR_INVALID_VALUE);
    CAIRN_CALL(cairn_geometry_get_indices(mesh, indices, 9, &count));
    EXPECT_EQ(count, 6u);
    CAIRN_CALL(cairn_geometry_get_dropped_triangles(mesh, &count));
    EXPECT_EQ(count, 1u);
    int columns = 0, rows = 0;
    cairn_vec2 spacing;
    CAIRN_CALL(cairn_geometry_get_grid(field, &columns, &rows, &spacing));
    EXPECT_EQ(columns * 10 + rows, 32);
    float read[6];
    CAIRN_CALL(cairn_geometry_get_heights(field, read, 6, &count));
    EXPECT_EQ(std::memcmp(read, heights, sizeof heights), 0);
    const float with_a_hole[] = {0, 1, INFINITY, 3, 4, 5};
    cairn_geometry* holed;
    CAIRN_CALL(cairn_geometry_create_height_field(3, 2, {0.5f, 2}, with_a_hole, 6, &holed));
    CAIRN_CALL(cairn_geometry_get_indices(holed, indices, 9, &count));
    EXPECT_EQ(count, 9u);
    EXPECT_EQ((std::vector<uint32_t>(indices, indices + 9)), (std::vector<uint32_t>{0, 3, 4, 0, 4, 1, 1, 4, 5}));
    cairn_vec3 places[6];
    CAIRN_CALL(cairn_geometry_get_vertices(holed, places, 6, &count));
    EXPECT_EQ(count, 6u);
    EXPECT_EQ(places[5].x, 0.5f);
    EXPECT_EQ(places[5].z, 1.0f);
    EXPECT_EQ(cairn_geometry_get_indices(hull, indices, 9, &count), CAIRN_ERROR_INVALID_VALUE);
    cairn_geometry_release(holed);
    cairn_material own[2] = {cairn_default_material(), cairn_default_material()};
    own[1].restitution = 0.5f;
    uint16_t numbers[] = {2, 0};
    cairn_geometry* patched;
    CAIRN_CALL(
        cairn_geometry_create_height_field_with_materials(3, 2, {0.5f, 2}, heights, 6, own, 2, numbers, 2, &patched));
    cairn_material read_own[3];
    CAIRN_CALL(cairn_geometry_get_materials(patched, read_own, 3, &count));
    EXPECT_EQ(count, 2u);
    EXPECT_EQ(read_own[1].restitution, 0.5f);
    uint16_t read_numbers[3];
    CAIRN_CALL(cairn_geometry_get_material_numbers(patched, read_numbers, 3, &count));
    EXPECT_EQ(count, 2u);
    EXPECT_EQ(read_numbers[0], 2);
    cairn_geometry_release(patched);
    numbers[0] = 3;
    EXPECT_EQ(cairn_geometry_create_mesh_with_materials(corners, 5, 0, triangles, 9, own, 2, numbers, 2, &patched),
              CAIRN_ERROR_INVALID_VALUE);
    EXPECT_EQ(cairn_geometry_get_materials(hull, read_own, 3, &count), CAIRN_ERROR_INVALID_VALUE);
    EXPECT_EQ(cairn_geometry_get_volume(mesh, &volume), CAIRN_ERROR_INVALID_VALUE);
    EXPECT_EQ(error(), "geometry: must be a hull, got another kind");
    EXPECT_EQ(cairn_geometry_get_heights(hull, read, 6, &count), CAIRN_ERROR_INVALID_VALUE);

    cairn_shape shape = cairn_default_shape(CAIRN_SHAPE_HULL);
    shape.as.hull.geometry = mesh;
    cairn_body_id body;
    cairn_shape_id id;
    CAIRN_CALL(cairn_world_create_body(world, nullptr, &body));
    EXPECT_EQ(cairn_world_add_shape(world, body, &shape, nullptr, &id), CAIRN_ERROR_INVALID_VALUE);
    shape.as.hull.geometry = hull;
    CAIRN_CALL(cairn_world_add_shape(world, body, &shape, nullptr, &id));
    // The shape keeps its geometry.
    for (cairn_geometry* geometry : {hull, mesh, field}) cairn_geometry_release(geometry);
    float mass = 0;
    CAIRN_CALL(cairn_body_get_mass(world, body, &mass));
    EXPECT_NEAR(mass, 8000.0f / 6, 0.01f);
}

TEST_F(CCalls, GeometriesRefuseWhatIsNoShape) {
    const float corners[] = {0, 0, 0, 2, 0, 0, 0, 2, 0, 0, 0, nan};
    const uint32_t triangles[] = {0, 1, 7};
    cairn_geometry* geometry = nullptr;
    EXPECT_EQ(cairn_geometry_create_hull(corners, 4, 0, &geometry), CAIRN_ERROR_INVALID_VALUE);
    EXPECT_EQ(cairn_geometry_create_hull(corners, 3, 0, &geometry), CAIRN_ERROR_INVALID_VALUE);
    EXPECT_EQ(cairn_geometry_create_hull(nullptr, 4, 0, &geometry), CAIRN_ERROR_INVALID_VALUE);
    EXPECT_EQ(cairn_geometry_create_hull(corners, 4, 11, &geometry), CAIRN_ERROR_INVALID_VALUE);
    EXPECT_EQ(cairn_geometry_create_mesh(corners, 3, 0, triangles, 3, &geometry), CAIRN_ERROR_INVALID_VALUE);
    EXPECT_EQ(cairn_geometry_create_mesh(corners, 3, 0, nullptr, 3, &geometry), CAIRN_ERROR_INVALID_VALUE);
    EXPECT_EQ(cairn_geometry_create_height_field(-1, 2, {1, 1}, corners, 4, &geometry), CAIRN_ERROR_INVALID_VALUE);
    EXPECT_EQ(cairn_geometry_create_height_field(2, 2, {1, 1}, nullptr, 4, &geometry), CAIRN_ERROR_INVALID_VALUE);
    EXPECT_EQ(geometry, nullptr);
}

TEST_F(CCalls, AWorldGoesBackToItsSnapshotBitForBit) {
    scatter(50);
    cairn_snapshot* snapshot = nullptr;
    uint64_t first = 0, again = 0;
    CAIRN_CALL(cairn_world_save(world, &snapshot));
    CAIRN_CALL(cairn_world_steps(world, 1.0f / 60, 40));
    CAIRN_CALL(cairn_world_get_state_hash(world, &first));
    CAIRN_CALL(cairn_world_restore(world, snapshot));
    for (int i = 0; i < 40; ++i) CAIRN_CALL(cairn_world_step(world, 1.0f / 60));
    CAIRN_CALL(cairn_world_get_state_hash(world, &again));
    cairn_snapshot_release(snapshot);
    EXPECT_EQ(first, again);
    EXPECT_EQ(cairn_world_restore(world, nullptr), CAIRN_ERROR_INVALID_VALUE);
    EXPECT_EQ(cairn_world_steps(world, nan, 3), CAIRN_ERROR_INVALID_VALUE);
}

TEST_F(CCalls, ErrorsBelongToTheThreadThatMadeThem) {
    EXPECT_EQ(cairn_world_step(world, -1), CAIRN_ERROR_INVALID_VALUE);
    const std::string here = error();
    EXPECT_NE(here.find("-1"), std::string::npos) << here;
    EXPECT_STREQ(cairn_last_error_value(), "-1");
    std::thread([] {
        EXPECT_STREQ(cairn_last_error(), "");
        EXPECT_EQ(cairn_world_step(nullptr, 1), CAIRN_ERROR_INVALID_HANDLE);
        EXPECT_STREQ(cairn_last_error_field(), "world");
    }).join();
    EXPECT_EQ(error(), here);
    CAIRN_CALL(cairn_world_step(world, 1.0f / 60));
    EXPECT_EQ(error(), here); // of the last call that failed
}

TEST_F(CCalls, HandlesOfAnotherWorldAreRefused) {
    scatter(1);
    cairn_world* other = nullptr;
    CAIRN_CALL(cairn_world_create(nullptr, &other));
    EXPECT_EQ(cairn_body_wake(other, bodies[0]), CAIRN_ERROR_INVALID_HANDLE);
    EXPECT_FALSE(cairn_body_is_valid(other, bodies[0]));
    EXPECT_FALSE(cairn_body_is_valid(nullptr, bodies[0]));
    EXPECT_TRUE(cairn_body_is_valid(world, bodies[0]));
    cairn_world_destroy(other);
    cairn_world_destroy(nullptr);
}

TEST_F(CCalls, ScenesThatAreNotThereAreRefused) {
    cairn_world* loaded = nullptr;
    EXPECT_EQ(cairn_scene_load("/nowhere/scene.gltf", &loaded, nullptr), CAIRN_ERROR_IO);
    EXPECT_NE(error().find("/nowhere/scene.gltf"), std::string::npos);
    EXPECT_EQ(cairn_scene_load(nullptr, &loaded, nullptr), CAIRN_ERROR_INVALID_VALUE);
    EXPECT_EQ(cairn_scene_save(world, nullptr), CAIRN_ERROR_INVALID_VALUE);
    EXPECT_EQ(cairn_scene_save(world, "/nowhere/scene.gltf"), CAIRN_ERROR_IO);
    EXPECT_EQ(loaded, nullptr);
}

TEST_F(CCalls, ASavedSceneIsLoadedAgainWithTheSameHash) {
    scatter(9);
    const std::string path = testing::TempDir() + "saved_by_c.glb";
    CAIRN_CALL(cairn_scene_save(world, path.c_str()));
    cairn_world* loaded = nullptr;
    CAIRN_CALL(cairn_scene_load(path.c_str(), &loaded, nullptr));
    size_t count = 0;
    CAIRN_CALL(cairn_world_get_bodies(loaded, nullptr, 0, &count));
    EXPECT_EQ(count, 9u);
    cairn_world_destroy(loaded);
}

TEST_F(CCalls, ASceneInMemoryIsTheOneThatWouldBeInAFile) {
    scatter(9);
    size_t length = 0, again = 0;
    CAIRN_CALL(cairn_scene_save_to_memory(world, nullptr, 0, &length));
    std::string text(length, '?');
    CAIRN_CALL(cairn_scene_save_to_memory(world, text.data(), length + 1, &again));
    EXPECT_EQ(again, length);
    cairn_world* loaded = nullptr;
    float time_step = 0;
    CAIRN_CALL(cairn_scene_load_from_memory(text.data(), text.size(), "nine.gltf", &loaded, &time_step));
    EXPECT_EQ(time_step, 1.0f / 60);
    std::string second(length, '?');
    CAIRN_CALL(cairn_scene_save_to_memory(loaded, second.data(), length + 1, &again));
    EXPECT_EQ(second, text);
    cairn_world_destroy(loaded);
    std::string part(10, '?'); // the text is truncated to the capacity
    CAIRN_CALL(cairn_scene_save_to_memory(world, part.data(), part.size(), &again));
    EXPECT_EQ(again, length);
    EXPECT_EQ(part, text.substr(0, 9) + '\0');
}

TEST_F(CCalls, ASceneThatIsDamagedInMemoryIsRefusedByItsName) {
    const std::string text = "{\"asset\":";
    cairn_world* loaded = nullptr;
    EXPECT_EQ(cairn_scene_load_from_memory(text.data(), text.size(), "cut.gltf", &loaded, nullptr),
              CAIRN_ERROR_INVALID_FILE);
    EXPECT_NE(error().find("cut.gltf"), std::string::npos);
    EXPECT_EQ(cairn_scene_load_from_memory(nullptr, 0, "empty", &loaded, nullptr), CAIRN_ERROR_INVALID_FILE);
    EXPECT_EQ(cairn_scene_load_from_memory(nullptr, 5, "none", &loaded, nullptr), CAIRN_ERROR_INVALID_VALUE);
    EXPECT_EQ(cairn_scene_load_from_memory(text.data(), 5, nullptr, &loaded, nullptr), CAIRN_ERROR_INVALID_VALUE);
    EXPECT_EQ(cairn_scene_load_from_memory(text.data(), 5, "a", nullptr, nullptr), CAIRN_ERROR_INVALID_VALUE);
    EXPECT_EQ(cairn_scene_save_to_memory(nullptr, nullptr, 0, nullptr), CAIRN_ERROR_INVALID_VALUE);
    EXPECT_EQ(loaded, nullptr);
}

TEST(CApiVersion, IsThatOfTheHeaders) { EXPECT_EQ(cairn_abi_version(), CAIRN_ABI_VERSION); }

// A structure that has grown since its first version: a program compiled with that version does not know `added`.
struct Grown {
    std::uint32_t struct_size;
    float old;
    double added;
};

TEST(CApiStructSize, ProgramsThatWereCompiledEarlierGetDefaultsForWhatTheyDoNotKnow) {
    using namespace cairn::c_api;
    const Grown defaults{sizeof(Grown), 1, 2};
    EXPECT_EQ(versioned(Grown{8, 5, 99}, "def", defaults, 8).added, 2);
    EXPECT_EQ(versioned(Grown{8, 5, 99}, "def", defaults, 8).old, 5);
    EXPECT_EQ(versioned(Grown{sizeof(Grown), 5, 99}, "def", defaults, 8).added, 99);
    for (const std::uint32_t size : {0u, 7u, unsigned(sizeof(Grown)) + 8}) {
        const Grown wrong{size, 5, 99};
        EXPECT_THROW(require_size(wrong, "def", 8), cairn::Error);
    }
    Grown out{8, 0, -3};
    require_versioned(&out, "out", 8);
    write_versioned(defaults, &out);
    EXPECT_EQ(out.old, 1);
    EXPECT_EQ(out.added, -3); // beyond the program's structure
    EXPECT_EQ(out.struct_size, 8u);
}

} // namespace
