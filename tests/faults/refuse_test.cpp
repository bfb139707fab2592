// Bad arguments are refused: rows 1 to 19 of the list of faults. Each call must name the field, the value and the
// expectation, and must leave the world unchanged, to the last bit of its snapshot.
#include "refusals.h"

namespace cairn::test {
namespace {

class Refused : public testing::TestWithParam<Refusal> {};

TEST_P(Refused, NamesFieldValueAndExpectationAndLeavesTheWorldAsItWas) {
    const Refusal& refusal = GetParam();
    Stage stage;
    const std::uint64_t hash = stage.world.state_hash();
    const Snapshot before = stage.world.save();
    bool thrown = false;
    try {
        refusal.call(stage);
    } catch (const Error& error) {
        thrown = true;
        EXPECT_EQ(error.code(), refusal.code);
        EXPECT_EQ(error.field(), refusal.field);
        EXPECT_EQ(error.value(), refusal.value);
        const std::string got = refusal.value.empty() ? "" : ", got " + refusal.value;
        EXPECT_EQ(std::string(error.what()), refusal.field + ": " + refusal.expected + got);
    }
    EXPECT_TRUE(thrown) << "row " << refusal.row << ", " << refusal.name << ": accepted";
    EXPECT_EQ(stage.world.state_hash(), hash);
    const Snapshot after = stage.world.save();
    EXPECT_TRUE(after.bytes == before.bytes) << "the refused call has changed something";
    EXPECT_EQ(after.definitions, before.definitions) << "the refused call has changed something";
}

// The test name: row, index, and the name of the call with only valid characters.
std::string test_name(const testing::TestParamInfo<Refusal>& info) {
    std::string name = "Row" + std::to_string(info.param.row) + "_" + std::to_string(info.index) + "_";
    for (const char* c = info.param.name; *c; ++c) name += *c == ' ' || *c == ':' ? '_' : *c;
    return name;
}

INSTANTIATE_TEST_SUITE_P(Positions, Refused, testing::ValuesIn(positions()), test_name);
INSTANTIATE_TEST_SUITE_P(Vectors, Refused, testing::ValuesIn(velocities_and_rotations()), test_name);
INSTANTIATE_TEST_SUITE_P(Masses, Refused, testing::ValuesIn(masses()), test_name);
INSTANTIATE_TEST_SUITE_P(Shapes, Refused, testing::ValuesIn(shapes()), test_name);
INSTANTIATE_TEST_SUITE_P(Materials, Refused, testing::ValuesIn(materials()), test_name);
INSTANTIATE_TEST_SUITE_P(Settings, Refused, testing::ValuesIn(settings_and_steps()), test_name);
INSTANTIATE_TEST_SUITE_P(WrongState, Refused, testing::ValuesIn(wrong_states()), test_name);

// Row 5, second half.
TEST(Accepted, RotationsOfAnyLengthAreNormalized) {
    World world;
    for (const float scale : {1e-6f, 0.5f, 3.0f, 1e6f}) {
        BodyDef def;
        def.rotation = Quat(0.6f * scale, 0.0f, 0.8f * scale, 0.0f);
        const Quat made = world.body(world.create_body(def)).rotation();
        EXPECT_NEAR(made.w, 0.6f, 1e-6f);
        EXPECT_NEAR(made.y, 0.8f, 1e-6f);
        Body body = world.body(world.create_body());
        body.set_rotation(def.rotation);
        EXPECT_NEAR(body.rotation().w, 0.6f, 1e-6f);
    }
}

// A refused call has no effect on the further course of a world.
TEST(Accepted, AWorldGoesOnAsIfARefusedCallHadNotBeen) {
    Stage plain, tried;
    for (const auto& rows : {positions(), velocities_and_rotations(), masses(), shapes(), materials(),
                             settings_and_steps(), wrong_states()})
        for (const Refusal& refusal : rows) EXPECT_THROW(refusal.call(tried), Error) << refusal.name;
    // Worlds are numbered, so handles differ; the motion does not.
    run(plain.world, 60);
    run(tried.world, 60);
    EXPECT_EQ(plain.world.state_hash(), tried.world.state_hash());
}

} // namespace
} // namespace cairn::test
