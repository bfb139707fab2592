// Invalid arguments of the C API: null, NaN, stale and foreign handles, wrong sizes. Nothing changes, and the error
// gives the reason.
#include "copy_world.h"
#include "wrong_calls.h"

#include <limits>
#include <memory>
#include <string>
#include <thread>

namespace {

struct Destroy {
    void operator()(cairn_world* world) const { cairn_world_destroy(world); }
};

class WrongCalls : public testing::Test {
  protected:
    void SetUp() override { build(); }
    ~WrongCalls() override { cairn_geometry_release(geometry); }

    // Two bodies with a joint, and a stale handle of each kind.
    void build() {
        cairn_world* made = nullptr;
        CAIRN_CALL(cairn_world_create(nullptr, &made));
        world.reset(made);
        c.world = made;
        cairn_body_def def = cairn_default_body_def();
        const cairn_shape box = cairn_default_shape(CAIRN_SHAPE_BOX);
        const cairn_force_field field = cairn_default_force_field();
        cairn_body_id other, ground;
        CAIRN_CALL(cairn_world_create_body(made, &def, &c.body));
        def.position.y = 3;
        CAIRN_CALL(cairn_world_create_body(made, &def, &other));
        CAIRN_CALL(cairn_world_create_body(made, &def, &c.stale_body));
        CAIRN_CALL(cairn_world_add_shape(made, c.body, &box, nullptr, &c.shape));
        def.type = CAIRN_BODY_TYPE_STATIC;
        CAIRN_CALL(cairn_world_create_body(made, &def, &ground)); // a static body, whose surface may have a velocity
        CAIRN_CALL(cairn_world_add_shape(made, ground, &box, nullptr, &c.shape));
        CAIRN_CALL(cairn_world_add_shape(made, other, &box, nullptr, &c.stale_shape));
        c.joint_def = cairn_default_joint_def();
        c.joint_def.body_a = c.body;
        c.joint_def.body_b = other;
        CAIRN_CALL(cairn_world_create_joint(made, &c.joint_def, &c.joint));
        CAIRN_CALL(cairn_world_create_joint(made, &c.joint_def, &c.stale_joint));
        CAIRN_CALL(cairn_world_add_force_field(made, &field, &c.force_field));
        CAIRN_CALL(cairn_world_add_force_field(made, &field, &c.stale_force_field));
        CAIRN_CALL(cairn_world_destroy_joint(made, c.stale_joint));
        CAIRN_CALL(cairn_world_remove_shape(made, c.stale_shape));
        CAIRN_CALL(cairn_world_remove_force_field(made, c.stale_force_field));
        CAIRN_CALL(cairn_world_destroy_body(made, c.stale_body));
        CAIRN_CALL(cairn_world_step(made, 1.0f / 60));
        c.vec3 = {1, 2, 3};
        c.position = {1, 2, 3};
        c.quat = {0, 0, 0, 1};
        c.transform = cairn_default_transform();
        c.bounds = {{-1, -1, -1}, {1, 1, 1}};
    }

    // The bytes of everything in the world, whether steps change it or not.
    std::string state() const {
        cairn_snapshot* snapshot = nullptr;
        cairn_snapshot_sizes sizes{};
        EXPECT_EQ(cairn_world_save(c.world, &snapshot), CAIRN_OK);
        EXPECT_EQ(cairn_snapshot_get_sizes(snapshot, &sizes), CAIRN_OK);
        cairn_snapshot_release(snapshot);
        uint64_t hash = 0;
        EXPECT_EQ(cairn_world_get_state_hash(c.world, &hash), CAIRN_OK);
        size_t counts[3] = {};
        EXPECT_EQ(cairn_world_get_bodies(c.world, nullptr, 0, &counts[0]), CAIRN_OK);
        EXPECT_EQ(cairn_world_get_joints(c.world, nullptr, 0, &counts[1]), CAIRN_OK);
        EXPECT_EQ(cairn_body_get_shapes(c.world, c.body, nullptr, 0, &counts[2]), CAIRN_OK);
        return std::to_string(hash) + " " + std::to_string(counts[0]) + " " + std::to_string(counts[1]) + " " +
               std::to_string(counts[2]) + " " + std::to_string(sizes.definitions) + " " + std::to_string(sizes.bodies);
    }

    void expect_invalid(cairn_result result, const char* about) {
        EXPECT_EQ(result, CAIRN_ERROR_INVALID_VALUE) << about;
        EXPECT_NE(std::string(cairn_last_error()).find(about), std::string::npos) << cairn_last_error();
    }

    std::unique_ptr<cairn_world, Destroy> world;
    wrong_context c{};
    cairn_geometry* geometry = nullptr;
};

TEST_F(WrongCalls, AreRefusedOneByOneAndChangeNothing) {
    ASSERT_GT(wrong_call_count, 400);
    const std::string before = state();
    for (int i = 0; i < wrong_call_count; ++i) {
        const wrong_call& call = wrong_calls[i];
        const std::string about = std::string(call.function) + ", " + call.what;
        EXPECT_EQ(call.call(&c, call.wrong), call.expected) << about << ": " << cairn_last_error();
        EXPECT_STRNE(cairn_last_error(), "") << about;
        ASSERT_EQ(state(), before) << about;
    }
}

// Verifies the test above: without the fault, the calls are accepted.
TEST_F(WrongCalls, WouldBeAcceptedWithNothingWrong) {
    std::string last;
    for (int i = 0; i < wrong_call_count; ++i) {
        const wrong_call& call = wrong_calls[i];
        if (last == call.function) continue;
        last = call.function;
        build();
        const bool walks = last.find("character") != std::string::npos || last.find("walk") != std::string::npos;
        if (last == "body_move_to" || last == "body_jump" || walks)
            CAIRN_CALL(cairn_body_set_type(c.world, c.body, CAIRN_BODY_TYPE_KINEMATIC));
        const cairn_character_def usual = cairn_default_character_def();
        if (last == "body_jump" || walks) CAIRN_CALL(cairn_body_set_character(c.world, c.body, &usual));
        ASSERT_EQ(call.call(&c, -1), CAIRN_OK) << call.function << ": " << cairn_last_error();
    }
}

} // namespace
