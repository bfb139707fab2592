// The shipped scenes through C give the same bits as through C++.
#include "copy_world.h"

#include "scene/scene.h"

#include <filesystem>
#include <map>
#include <memory>

namespace {

using cairn_test::copy_world;

struct Destroy {
    void operator()(cairn_world* world) const { cairn_world_destroy(world); }
};
using WorldPointer = std::unique_ptr<cairn_world, Destroy>;

constexpr int steps = 90;

std::vector<std::filesystem::path> scenes() { return cairn::scene::scene_files(CAIRN_TEST_SCENES); }

class OfEveryScene : public testing::TestWithParam<std::filesystem::path> {
  protected:
    void load() {
        cairn_world* loaded = nullptr;
        CAIRN_CALL(cairn_scene_load(GetParam().c_str(), &loaded, &time_step));
        world.reset(loaded);
    }
    static uint64_t hash(const cairn_world* of) {
        uint64_t value = 0;
        EXPECT_EQ(cairn_world_get_state_hash(of, &value), CAIRN_OK);
        return value;
    }
    WorldPointer world;
    float time_step = 0;
};

TEST_P(OfEveryScene, StepsInCHaveTheBitsOfStepsInCpp) {
    load();
    cairn::scene::Scene scene = cairn::scene::load(GetParam());
    ASSERT_EQ(time_step, scene.info.time_step);
    for (int i = 0; i < steps; ++i) {
        CAIRN_CALL(cairn_world_step(world.get(), time_step));
        scene.world.step(time_step);
        ASSERT_EQ(hash(world.get()), scene.world.state_hash()) << "after step " << i + 1;
    }
}

// Like copy_world, through C++.
cairn::World copy_by_cpp(const cairn::World& from) {
    cairn::World to(from.settings());
    std::map<cairn::BodyId, cairn::BodyId> made{{cairn::BodyId{}, cairn::BodyId{}}};
    for (const cairn::BodyId id : from.bodies()) {
        const cairn::Body body = from.body(id);
        cairn::BodyDef def{body.type(),
                           body.position(),
                           body.rotation(),
                           body.linear_velocity(),
                           body.angular_velocity(),
                           body.linear_damping(),
                           body.angular_damping(),
                           body.gravity_scale(),
                           body.allow_sleep()};
        if (def.type == cairn::BodyType::dynamic) def.mass_properties = body.mass_properties();
        def.name = body.name();
        def.user_data = body.user_data();
        made[id] = to.create_body(def);
        for (const cairn::ShapeId shape : body.shapes())
            to.add_shape(made[id], from.shape(shape), from.shape_def(shape));
    }
    for (const cairn::JointId id : from.joints()) {
        cairn::JointDef def = from.joint_def(id);
        def.body_a = made.at(def.body_a);
        def.body_b = made.at(def.body_b);
        to.create_joint(def);
    }
    return to;
}

// Every property is read and set through C: nothing of a body, shape or joint is lost.
TEST_P(OfEveryScene, AWorldMadeAnewThroughCIsTheOneMadeAnewThroughCpp) {
    load();
    cairn_world* copy = nullptr;
    copy_world(world.get(), &copy);
    const WorldPointer owned(copy);
    ASSERT_FALSE(HasFatalFailure());
    cairn::World expected = copy_by_cpp(cairn::scene::load(GetParam()).world);
    for (int i = 0; i < steps; ++i) {
        ASSERT_EQ(hash(copy), expected.state_hash()) << "after step " << i;
        CAIRN_CALL(cairn_world_step(copy, time_step));
        expected.step(time_step);
    }
    cairn_snapshot* snapshot = nullptr;
    cairn_snapshot_sizes sizes;
    CAIRN_CALL(cairn_world_save(copy, &snapshot));
    CAIRN_CALL(cairn_snapshot_get_sizes(snapshot, &sizes));
    cairn_snapshot_release(snapshot);
    EXPECT_EQ(sizes.definitions, expected.save().sizes().definitions);
}

INSTANTIATE_TEST_SUITE_P(CApi, OfEveryScene, testing::ValuesIn(scenes()),
                         [](const auto& scene) { return scene.param.stem().string(); });

} // namespace
