// Stacks, towers and heavy loads on light boxes, at the default settings (rows 20 and 22 of docs/validation.md).
#include "support.h"

namespace cairn_test {
namespace {

// Unit boxes of 1000 kg on the ground.
struct Stack {
    World world;
    std::vector<BodyId> boxes;
    std::vector<Position> start;

    explicit Stack(bool sleep = true) : world(sleep ? WorldDef{} : without_sleep()) { add_ground(world); }

    BodyId add(const Position& position, const Vec3& half_extents = {0.5f, 0.5f, 0.5f}, float density = 1000,
               const Quat& rotation = {1, 0, 0, 0}, const Material& material = {}) {
        BodyDef def;
        def.position = position;
        def.rotation = rotation;
        ShapeDef shape;
        shape.density = density;
        shape.material = material;
        const BodyId box = world.create_body(def);
        world.add_shape(box, Box{half_extents}, shape);
        boxes.push_back(box);
        start.push_back(position);
        return box;
    }
    void add_column(int count) {
        for (int i = 0; i < count; ++i) add({0, 0.5 + i, 0});
    }
    double sag(std::size_t i) { return start[i].y - world.body(boxes[i]).position().y; }
    double drift(std::size_t i) {
        const Position p = world.body(boxes[i]).position() - start[i];
        return std::hypot(p.x, p.z);
    }
    double greatest_sag() {
        double most = 0;
        for (std::size_t i = 0; i < boxes.size(); ++i) most = std::max(most, sag(i));
        return most;
    }
    double greatest_displacement(const std::vector<Position>& from) {
        double most = 0;
        for (std::size_t i = 0; i < boxes.size(); ++i)
            most = std::max(most, glm::length(world.body(boxes[i]).position() - from[i]));
        return most;
    }
    std::vector<Position> positions() {
        std::vector<Position> all;
        for (const BodyId box : boxes) all.push_back(world.body(box).position());
        return all;
    }
    // Runs, and gives the deepest overlap on the way.
    double run_for(double seconds, float dt) {
        double deepest = 0;
        for (int i = 0; i < int(std::lround(seconds / double(dt))); ++i) {
            world.step(dt);
            if (i % 10 == 0) deepest = std::max(deepest, deepest_overlap(world));
        }
        return std::max(deepest, deepest_overlap(world));
    }
};

class Standing : public EveryStep {
  protected:
    double seconds() const { return GetParam() == 60 ? 60 : GetParam() == 240 ? 15 : 5; }
};
CAIRN_AT_EVERY_STEP(Standing);

TEST_P(Standing, EachContactOfAStackCarriesWhatIsAboveIt) {
    constexpr int count = 10;
    Stack stack(false);
    stack.add_column(count);
    run(stack.world, dt(), steps_in(4));
    std::vector<double> force(count, 0.0); // under each box
    int contacts = 0;
    for (const Contact& contact : stack.world.contacts()) {
        std::size_t upper = 0; // the higher box of the two
        for (std::size_t i = 0; i < stack.boxes.size(); ++i)
            if (contact.body_a == stack.boxes[i] || contact.body_b == stack.boxes[i]) upper = i;
        force[upper] += normal_impulse(contact) / double(dt());
        ++contacts;
    }
    EXPECT_EQ(contacts, count);
    for (int k = 0; k < count; ++k) {
        const double expected = (count - k) * 1000 * gravity;
        EXPECT_NEAR(force[std::size_t(k)] / expected, 1, 0.01) << "under box " << k;
    }
}

TEST_P(Standing, TowerOfFortyStandsStraightAndHardlySags) {
    for (const bool sleep : {true, false}) {
        Stack tower(sleep);
        tower.add_column(40);
        tower.run_for(seconds(), dt());
        EXPECT_LT(tower.drift(39), 0.01) << "sleeping " << sleep;
        EXPECT_LT(tower.sag(39), 0.05) << "sleeping " << sleep;
    }
}

TEST_P(Standing, BoxAHundredTimesHeavierStandsOnAColumnOfFour) {
    for (const bool sleep : {true, false}) {
        Stack stack(sleep);
        stack.add_column(4);
        stack.add({0, 4.5, 0}, {0.5f, 0.5f, 0.5f}, 100 * 1000);
        EXPECT_LT(stack.run_for(seconds(), dt()), 0.01) << "sleeping " << sleep;
        EXPECT_LT(stack.drift(4), 0.01) << "sleeping " << sleep;
        EXPECT_LT(stack.sag(4), 0.05) << "sleeping " << sleep;
    }
}

TEST_P(Standing, BoxAThousandTimesHeavierStandsOnAColumnOfFour) {
    for (const bool sleep : {true, false}) {
        Stack stack(sleep);
        stack.add_column(4);
        stack.add({0, 4.5, 0}, {0.5f, 0.5f, 0.5f}, 1000 * 1000);
        EXPECT_LT(stack.run_for(seconds(), dt()), 0.05) << "sleeping " << sleep;
        EXPECT_LT(stack.drift(4), 0.02) << "sleeping " << sleep;
        EXPECT_LT(stack.sag(4), 0.2) << "sleeping " << sleep;
    }
}

TEST_P(Standing, BoxAHundredTimesHeavierStandsOnFourLegs) {
    for (const bool sleep : {true, false}) {
        Stack table(sleep);
        for (const double x : {-1.0, 1.0})
            for (const double z : {-1.0, 1.0}) table.add({x, 0.5, z});
        // 3 m x 1 m x 3 m
        table.add({0, 1.5, 0}, {1.5f, 0.5f, 1.5f}, 100 * 1000 / 9.0f);
        EXPECT_LT(table.run_for(seconds(), dt()), 0.01) << "sleeping " << sleep;
        EXPECT_LT(table.drift(4), 0.01) << "sleeping " << sleep;
        EXPECT_LT(table.sag(4), 0.02) << "sleeping " << sleep;
    }
}

// A minute as it is, and 20 s without sleep, which must not be what holds it up.
class Structures : public testing::TestWithParam<bool> {
  protected:
    bool sleep() const { return GetParam(); }
    void run_long(World& world) { run(world, 1.0f / 60, sleep() ? 3600 : 1200); }
};
INSTANTIATE_TEST_SUITE_P(Physics, Structures, testing::Bool(), [](const testing::TestParamInfo<bool>& info) {
    return std::string(info.param ? "WithSleep" : "WithoutSleep");
});

TEST(Pyramid, OfAHundredRowsStandsWithoutCreep) {
    Stack pyramid;
    for (int row = 0; row < 100; ++row)
        for (int i = 0; i < 100 - row; ++i) pyramid.add({i + 0.5 * row - 49.5, 0.5 + row, 0});
    ASSERT_EQ(pyramid.boxes.size(), 5050u);
    run(pyramid.world, 1.0f / 60, 480);
    const std::vector<Position> settled = pyramid.positions();
    run(pyramid.world, 1.0f / 60, 120);
    EXPECT_LT(pyramid.greatest_sag(), 0.2);
    EXPECT_LT(pyramid.drift(5049), 0.1);
    EXPECT_LT(pyramid.greatest_displacement(settled), 0.002); // in the last two seconds
}

TEST_P(Structures, HouseOfCardsStands) {
    const double length = 1, thickness = 0.02, tilt = radians(20), spacing = 1;
    const Vec3 card{float(thickness / 2), float(length / 2), 0.35f}, roof{0.499f, float(thickness / 2), 0.35f};
    const double rise = length / 2 * std::cos(tilt) + thickness / 2 * std::sin(tilt); // of a card's center
    const double reach = length / 2 * std::sin(tilt) + thickness / 2 * std::cos(tilt);
    const double floor = 2 * rise + thickness;
    const Material material = surface(0.6f);
    Stack house(sleep());
    auto lean = [&](double x, double y) { // two cards against each other
        house.add({x - reach, y + rise, 0}, card, 1000, glm::angleAxis(float(-tilt), Vec3(0, 0, 1)), material);
        house.add({x + reach, y + rise, 0}, card, 1000, glm::angleAxis(float(tilt), Vec3(0, 0, 1)), material);
    };
    for (int level = 0; level < 3; ++level)
        for (int i = 0; i < 3 - level; ++i) {
            const double x = spacing * (i - 0.5 * (2 - level));
            lean(x, level * floor);
            if (i > 0)
                house.add({x - spacing / 2, level * floor + 2 * rise + thickness / 2, 0}, roof, 1000, {1, 0, 0, 0},
                          material);
        }
    run_long(house.world);
    EXPECT_LT(house.greatest_displacement(house.start), 0.02);
}

TEST_P(Structures, CorbelledArchStands) {
    // Courses of bricks that reach out by 90 % of what balance allows, from both sides, with a beam over the gap.
    constexpr int courses = 6;
    Stack arch(sleep());
    double reach = 0; // of the course, from the lowest
    double x[courses];
    for (int i = 0; i < courses; ++i) {
        x[i] = reach;
        if (i + 1 < courses) reach += 0.9 * 0.5 / (courses - 1 - i);
    }
    const double gap = 0.4, half = reach + 0.5 + gap / 2; // the top bricks end at gap / 2 from the middle
    for (const double side : {-1.0, 1.0})
        for (int i = 0; i < courses; ++i) arch.add({side * (half - x[i]), 0.15 + 0.3 * i, 0}, {0.5f, 0.15f, 0.25f});
    run_long(arch.world);
    EXPECT_LT(arch.greatest_displacement(arch.start), 0.02);
}

TEST_P(Structures, JengaTowerStandsWithBlocksTakenOut) {
    Stack tower(sleep());
    const Vec3 along{0.75f, 0.15f, 0.25f}, across{0.25f, 0.15f, 0.75f};
    for (int layer = 0; layer < 18; ++layer)
        for (int i = -1; i <= 1; ++i) {
            if (layer % 3 == 1 && i == 0) continue;               // the middle one taken
            if (layer % 3 == 2 && layer < 17 && i == 1) continue; // one side taken
            const double y = 0.15 + 0.3 * layer;
            if (layer % 2 == 0)
                tower.add({0, y, 0.5 * i}, along);
            else
                tower.add({0.5 * i, y, 0}, across);
        }
    run_long(tower.world);
    EXPECT_LT(tower.greatest_displacement(tower.start), 0.03);
}

} // namespace
} // namespace cairn_test
