// Each scene with joints does what it is meant to show, with limits on the joint errors meanwhile.
#include "scene/scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <string>
#include <variant>
#include <vector>

namespace {

using namespace cairn;
using scene::Scene;

using std::numbers::pi;

class JointScene : public testing::Test {
  protected:
    void load(const char* name) {
        scene_ = scene::load(std::string(CAIRN_TEST_SCENES "/") + name + ".gltf");
        EXPECT_TRUE(scene_.warnings.empty()) << scene_.warnings.front();
        EXPECT_TRUE(scene_.idle_joints.empty());
        joints_ = world().joints();
    }
    World& world() { return scene_.world; }
    double time_step() const { return double(scene_.info.time_step); }

    // Steps for that many seconds, and records the largest joint error, m.
    void run(
        double seconds, const std::function<void()>& watch = [] {}) {
        const int steps = int(std::lround(seconds / time_step()));
        for (int i = 0; i < steps; ++i) {
            world().step(scene_.info.time_step);
            worst_ = std::max(worst_, error_now());
            watch();
        }
    }
    double error_now() {
        double worst = 0;
        for (const JointId joint : joints_) {
            const double error = double(world().joint_state(joint).linear_error);
            worst = std::isfinite(error) ? std::max(worst, error) : INFINITY;
        }
        return worst;
    }
    Body body(const std::string& name) {
        const auto id = world().find_body(name);
        EXPECT_TRUE(id.has_value()) << name;
        return world().body(*id);
    }
    double position_of(const std::string& name, std::size_t axis = 0) {
        const auto id = world().find_joint(name);
        EXPECT_TRUE(id.has_value()) << name;
        return double(world().joint_state(*id).positions[axis]);
    }
    static double upright(const Body& body) { return double((body.rotation() * Vec3(0, 1, 0)).y); }

    double worst_ = 0;
    std::vector<JointId> joints_;
    Scene scene_{.world = World(), .info = {}, .force_fields = {}, .appearances = {}, .warnings = {}};
};

TEST_F(JointScene, RagdollsFallDownTheStepsAndKeepTheirLimbs) {
    load("25_ragdolls");
    ASSERT_EQ(joints_.size(), 200u);
    run(8);
    EXPECT_LT(worst_, 0.018);      // when the dolls land at 6 m/s
    EXPECT_LT(error_now(), 0.002); // 0.4 to 1.2 mm over ten starts that differ by 10 um
    int down = 0;
    for (int i = 1; i <= 20; ++i) down += body("chest " + std::to_string(i)).position().y < 2.4 ? 1 : 0;
    EXPECT_GE(down, 15);
    for (const BodyId id : world().bodies()) {
        const Body part = world().body(id);
        if (part.type() != BodyType::dynamic) continue;
        EXPECT_GT(part.position().y, 0.04) << part.name();
        EXPECT_LT(glm::length(part.linear_velocity()), 0.05f) << part.name();
    }
    for (const JointId id : joints_) {
        const JointDef& def = world().joint_def(id);
        const JointState state = world().joint_state(id);
        if (const auto* hinge = std::get_if<HingeJoint>(&def.joint)) {
            EXPECT_GT(state.positions[0], hinge->angle.limits->lower - 0.02f) << def.name;
            EXPECT_LT(state.positions[0], hinge->angle.limits->upper + 0.02f) << def.name;
        }
    }
}

TEST_F(JointScene, TheBridgeCarriesTheBall) {
    load("26_suspension_bridge");
    const Body ball = body("ball");
    double lowest = 10, lowest_plank = 10;
    run(15, [&] {
        if (ball.position().x < 7.2) lowest = std::min(lowest, ball.position().y);
        for (const int i : {6, 12, 13, 18})
            lowest_plank = std::min(lowest_plank, body("plank " + std::to_string(i)).position().y);
    });
    EXPECT_LT(worst_, 0.002);
    EXPECT_GT(lowest, 2.6 + 0.875 - 0.3); // the deck is at 2.6 m
    EXPECT_LT(lowest, 2.6 + 0.875 - 0.02);
    EXPECT_GT(lowest_plank, 2.53 - 0.3);
    // The ball comes to rest in the hollow on the other bank; nothing sways sideways.
    EXPECT_GT(ball.position().x, 8.4);
    EXPECT_LT(ball.position().x, 11.5);
    EXPECT_LT(std::fabs(ball.position().z), 0.2);
    EXPECT_LT(glm::length(ball.linear_velocity()), 0.1f);
}

TEST_F(JointScene, TheBallBreaksTheWallAndTheChainHolds) {
    load("27_ball_and_chain");
    std::map<BodyId, Position> start;
    for (const BodyId id : world().bodies())
        if (world().body(id).name().substr(0, 5) == "brick") start[id] = world().body(id).position();
    const auto moved = [&](double way) {
        return std::count_if(start.begin(), start.end(), [&](const auto& brick) {
            return glm::distance(world().body(brick.first).position(), brick.second) > way;
        });
    };
    run(1.2);
    EXPECT_EQ(moved(0.02), 0);
    EXPECT_LT(worst_, 0.0002); // 0.02 mm while swinging
    run(8.8);
    EXPECT_LT(worst_, 0.004); // when the ball hits the wall
    EXPECT_GE(moved(0.5), 18) << "of " << start.size();
    EXPECT_LT(glm::distance(body("ball").position(), Position(0, 8.2, 0)), 18 * 0.32 + 0.72 + 0.001);
}

TEST_F(JointScene, CarsDriveAroundOverBumps) {
    load("28_cars");
    std::array<double, 3> way{}, least{1, 1, 1};
    std::array<Position, 3> last;
    double low = 1, high = -1;
    const auto name = [](std::size_t i) { return "car " + std::to_string(i + 1); };
    for (std::size_t i = 0; i < 3; ++i) last[i] = body(name(i)).position();
    run(20, [&] {
        for (std::size_t i = 0; i < 3; ++i) {
            const Body car = body(name(i));
            way[i] += std::hypot(car.position().x - last[i].x, car.position().z - last[i].z);
            last[i] = car.position();
            least[i] = std::min(least[i], upright(car));
            EXPECT_LT(std::hypot(last[i].x, last[i].z), 10.5);
        }
        low = std::min(low, position_of("rear left 1")), high = std::max(high, position_of("rear left 1"));
    });
    EXPECT_LT(worst_, 0.002);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_GT(way[i], 50) << name(i);
        EXPECT_GT(least[i], 0.9) << name(i);
    }
    EXPECT_GT(high - low, 0.08); // the suspension works
}

TEST_F(JointScene, TheWalkerWalks) {
    load("29_walker");
    const Body walker = body("body");
    const Position start = walker.position();
    double low = 10, high = 0, least = 1;
    run(10, [&] {
        low = std::min(low, walker.position().y), high = std::max(high, walker.position().y);
        least = std::min(least, upright(walker));
    });
    EXPECT_LT(worst_, 0.005);
    EXPECT_GT(walker.position().x - start.x, 5.5);
    EXPECT_LT(std::fabs(walker.position().z), 1.0);
    EXPECT_GT(low, start.y - 0.05); // within the height variation of Jansen's linkage
    EXPECT_LT(high, start.y + 0.06);
    EXPECT_GT(least, 0.99);
}

TEST_F(JointScene, TheHandsOfTheClockKeepTwelveToOne) {
    load("30_clock");
    double minute = 0, hour = 0, last_minute = 0, last_hour = 0;
    // A hinge reports its angle modulo one turn; the change per step is small.
    const auto follow = [](double now, double& last, double& sum) {
        sum += std::remainder(now - last, 2 * pi);
        last = now;
    };
    run(36, [&] {
        follow(position_of("minute"), last_minute, minute);
        follow(position_of("hour"), last_hour, hour);
    });
    EXPECT_NEAR(minute, -6 * pi, 0.005);
    EXPECT_NEAR(12 * hour, minute, 0.005);
    EXPECT_LT(worst_, 0.0001);
}

TEST_F(JointScene, OneThingSetsOffTheNext) {
    load("31_chain_reaction");
    std::vector<std::string> order;
    const auto note = [&](const char* what, bool happened) {
        if (happened && std::find(order.begin(), order.end(), what) == order.end()) order.push_back(what);
    };
    run(10, [&] {
        note("first domino", upright(body("domino 1")) < 0.8);
        note("last domino", upright(body("domino 11")) < 0.8);
        note("second ball", body("second ball").position().y < 3.0);
        note("seesaw", position_of("seesaw") > 0.4);
        note("hammer", position_of("hammer") < -0.5);
        note("slide", position_of("slide") > 0.3);
        note("third ball", body("third ball").position().y < 1.6);
        note("flag", position_of("flag") > 2.19);
    });
    EXPECT_EQ(order, (std::vector<std::string>{"first domino", "last domino", "second ball", "seesaw", "hammer",
                                               "slide", "third ball", "flag"}));
    EXPECT_NEAR(position_of("flag"), 2.2, 0.002);
    EXPECT_NEAR(position_of("pan"), -1.1, 0.002);
    EXPECT_LT(std::fabs(body("third ball").position().x - body("pan").position().x), 0.2);
    EXPECT_LT(worst_, 0.003);
    for (const BodyId id : world().bodies()) {
        const Body part = world().body(id);
        if (part.type() != BodyType::dynamic) continue;
        EXPECT_LT(glm::length(part.linear_velocity()), 0.05f) << part.name();
    }
}

TEST_F(JointScene, TheRobotHoldsTheTrayLevel) {
    load("32_robot_arm");
    const Body tray = body("tray"), cone = body("cone");
    double least = 1, turned = 0, last = 0;
    run(12, [&] {
        least = std::min(least, upright(tray));
        turned += std::remainder(position_of("axis 1") - last, 2 * pi);
        last = position_of("axis 1");
        for (int axis = 2; axis <= 6; ++axis)
            EXPECT_LT(std::fabs(position_of("axis " + std::to_string(axis))), 0.006) << axis;
    });
    EXPECT_LT(worst_, 0.0001);
    EXPECT_NEAR(turned, 0.6 * 12 - 0.25, 0.15); // reaching its speed takes most of a second
    EXPECT_GT(least, std::cos(0.7 * pi / 180));
    const Position offset = cone.position() - tray.position();
    EXPECT_LT(std::hypot(offset.x, offset.z), 0.03);
    EXPECT_NEAR(offset.y, 0.465, 0.005);
    EXPECT_GT(upright(cone), 0.999);
}

// One ball in, one ball out: the outer balls swing as far as the first one was lifted, and the inner ones stay at rest.
TEST_F(JointScene, TheCradleSwingsOnItsStringsForAMinute) {
    load("11_newtons_cradle");
    EXPECT_EQ(scene_.joint_appearances.size(), 10u);
    run(50);
    std::array<double, 5> farthest{};
    run(10, [&] {
        for (int i = 0; i < 5; ++i) {
            double& most = farthest[std::size_t(i)];
            const double way = body("ball " + std::to_string(i + 1)).position().x - 0.5 * (i - 2);
            most = std::max(most, std::fabs(way));
        }
    });
    const double lifted = 1.3 * std::sin(40 * pi / 180);
    for (const int outer : {0, 4}) EXPECT_NEAR(farthest[std::size_t(outer)], lifted, 0.01 * lifted);
    for (const int inner : {1, 2, 3}) EXPECT_LT(farthest[std::size_t(inner)], 0.030);
}

} // namespace
