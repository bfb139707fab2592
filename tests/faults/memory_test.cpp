// The k-th allocation fails: row 47 of the list of faults. Whatever call it hits, the world is either unchanged, or
// refuses everything until it is restored.
#include "../sanitized.h"
#include "../unit/allocation_count.h"

#include <cairn/cairn.h>

#include <gtest/gtest.h>

#include <functional>
#include <new>
#include <ostream>
#include <string>
#include <vector>

namespace {

using namespace cairn;

struct Stage {
    World world;
    BodyId ground, crate, ball;
    ShapeId crate_shape;
    JointId rope;
    ForceFieldId field;

    Stage() {
        BodyDef def;
        def.type = BodyType::static_;
        ground = world.create_body(def);
        world.add_shape(ground, Plane{});
        def.type = BodyType::dynamic;
        def.position = {0, 1, 0};
        crate = world.create_body(def);
        crate_shape = world.add_shape(crate, Box{});
        def.position = {0, 3, 0};
        ball = world.create_body(def);
        world.add_shape(ball, Sphere{});
        rope = world.create_joint(world.joint_at(crate, ball, {0, 2, 0}, {0, 1, 0}, BallJoint{}));
        field = world.add_force_field({});
        for (int i = 0; i < 20; ++i) world.step(1.0f / 60);
    }
};

const std::vector<Vec3> corners = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}};

const std::vector<std::uint32_t> triangle = {0, 2, 1};

struct Call {
    const char* name;
    std::function<void(Stage&)> run;
};

const Call calls[] = {
    {"create_body",
     [](Stage& s) {
         BodyDef def;
         def.name = "a name that is too long to be stored within a string itself";
         for (int i = 0; i < 40; ++i) s.world.create_body(def);
     }},
    {"add_shape", [](Stage& s) { s.world.add_shape(s.crate, Hull(corners)); }},
    {"add_mesh", [](Stage& s) { s.world.add_shape(s.ground, Mesh(corners, triangle)); }},
    {"remove_shape", [](Stage& s) { s.world.remove_shape(s.crate_shape); }},
    {"destroy_body", [](Stage& s) { s.world.destroy_body(s.crate); }},
    {"create_joint",
     [](Stage& s) {
         for (int i = 0; i < 8; ++i)
             s.world.create_joint(s.world.joint_at(s.ball, {}, {0, 3, 0}, {0, 1, 0}, HingeJoint{}));
     }},
    {"set_joint", [](Stage& s) { s.world.set_joint(s.rope, HingeJoint{}); }},
    {"destroy_joint", [](Stage& s) { s.world.destroy_joint(s.rope); }},
    {"add_force_field", [](Stage& s) { s.world.add_force_field({}); }},
    {"set_type", [](Stage& s) { s.world.body(s.crate).set_type(BodyType::kinematic); }},
    {"set_position",
     [](Stage& s) {
         s.world.body(s.crate).set_position({5, 5, 5});
     }},
    {"set_name", [](Stage& s) { s.world.body(s.crate).set_name(std::string(100, 'x')); }},
    {"add_force",
     [](Stage& s) {
         s.world.body(s.crate).add_force({1, 2, 3});
     }},
    {"set_settings",
     [](Stage& s) {
         WorldDef def = s.world.settings();
         def.gravity = {1, 0, 0};
         s.world.set_settings(def);
     }},
    {"set_threads", [](Stage& s) { s.world.set_threads(2); }},
    {"step", [](Stage& s) { s.world.step(1.0f / 60); }},
    {"step_after_changes",
     [](Stage& s) {
         for (int i = 0; i < 10; ++i) {
             BodyDef def;
             def.position = {double(i), 0.5, 0};
             s.world.add_shape(s.world.create_body(def), Box{});
         }
         s.world.step(1.0f / 60);
     }},
    {"queries",
     [](Stage& s) {
         s.world.cast_ray_all({0, 9, 0}, {0, -1, 0}, 20);
         s.world.overlap(Sphere{3}, {});
         s.world.contacts();
         s.world.bodies();
     }},
    {"save", [](Stage& s) { s.world.save(); }},
    {"restore", [](Stage& s) { s.world.restore(s.world.save()); }},
};

void PrintTo(const Call& call, std::ostream* out) { *out << call.name; } // otherwise its bytes, different in each run

class Row47 : public testing::TestWithParam<Call> {};

// A summary of the world, or that it refuses to answer.
std::string state_of(World& world) {
    try {
        return std::to_string(world.state_hash()) + " " + std::to_string(world.bodies().size()) + " " +
               std::to_string(world.joints().size()) + " " + std::to_string(world.statistics().shapes);
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::wrong_state);
        EXPECT_NE(std::string(error.what()).find("ran out of memory"), std::string::npos) << error.what();
        return "refused";
    }
}

TEST_P(Row47, AllocationThatFailsLeavesTheWorldAsItWasOrRefused) {
    if (cairn_test::is_thread_sanitized) GTEST_SKIP() << "the sanitizer has an operator new of its own";
    bool ended = false;
    int refused = 0, unchanged = 0;
    for (std::size_t k = 0; k < 20000 && !ended; k += k < 300 ? 1 : 97) {
        Stage stage;
        const Snapshot saved = stage.world.save();
        const std::string before = state_of(stage.world);
        bool failed = false;
        fail_allocation_after(k);
        try {
            GetParam().run(stage);
        } catch (const std::bad_alloc&) {
            failed = true;
        }
        ended = !stop_failing();
        if (!failed) continue; // at the end, or the allocation was optional (std::stable_sort)
        const std::string after = state_of(stage.world);
        if (after == "refused") {
            ++refused;
            EXPECT_THROW(stage.world.step(1.0f / 60), Error);
            EXPECT_THROW(stage.world.create_body({}), Error);
            EXPECT_THROW(stage.world.body(stage.ball), Error);
            EXPECT_THROW(stage.world.save(), Error);
        } else {
            ++unchanged;
        }
        stage.world.restore(saved);
        EXPECT_EQ(state_of(stage.world), before) << k;
        Stage twin;
        for (int i = 0; i < 10; ++i) stage.world.step(1.0f / 60), twin.world.step(1.0f / 60);
        EXPECT_EQ(stage.world.state_hash(), twin.world.state_hash()) << k;
    }
    EXPECT_TRUE(ended);
    RecordProperty("refused", refused);
    RecordProperty("unchanged", unchanged);
}

INSTANTIATE_TEST_SUITE_P(Calls, Row47, testing::ValuesIn(calls), [](const auto& info) { return info.param.name; });

} // namespace
