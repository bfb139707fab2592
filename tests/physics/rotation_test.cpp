// Torque-free rotation of bodies with three different moments of inertia (rows 5 and 6 of docs/validation.md).
#include "support.h"

namespace cairn_test {
namespace {

class FreeRotation : public EveryStep {
  protected:
    struct Result {
        std::vector<double> flips;          // times at which the spin about the middle axis changes its sign, s
        double momentum_error = 0;          // greatest, relative to the start
        double rotational_energy_error = 0; // likewise
    };

    Result watch(World& world, BodyId id, double seconds) {
        Result result;
        const glm::dvec3 momentum = world.body(id).angular_momentum();
        const double energy = rotational_energy(world.body(id));
        double last = 0, time = 0;
        for (int i = 0; i < steps_in(seconds); ++i) {
            const double before = spin_about_middle_axis(world.body(id));
            world.step(dt());
            time += double(dt());
            const double after = spin_about_middle_axis(world.body(id));
            if (before * after < 0) result.flips.push_back(last + double(dt()) * before / (before - after));
            last = time;
            const glm::dvec3 change = glm::dvec3(world.body(id).angular_momentum()) - momentum;
            result.momentum_error = std::max(result.momentum_error, glm::length(change) / glm::length(momentum));
            result.rotational_energy_error =
                std::max(result.rotational_energy_error, std::abs(rotational_energy(world.body(id)) / energy - 1));
        }
        return result;
    }

  private:
    static double rotational_energy(const Body& body) {
        return 0.5 * glm::dot(glm::dvec3(body.angular_momentum()), glm::dvec3(body.angular_velocity()));
    }
    static double spin_about_middle_axis(const Body& body) {
        return double((glm::conjugate(body.rotation()) * body.angular_velocity()).y);
    }
};
CAIRN_AT_EVERY_STEP(FreeRotation);

TEST_P(FreeRotation, TopFlipsWhenTheoryTellsAndKeepsMomentumAndEnergy) {
    World world{without_gravity()};
    BodyDef def;
    def.mass_properties = MassProperties{};
    def.mass_properties->inertia_diagonal = {1, 2, 3};
    def.angular_velocity = {0.01f, 1.0f, 0.01f};
    const Result result = watch(world, add_body(world, Sphere{}, def), 51);
    ASSERT_EQ(result.flips.size(), 3u);
    EXPECT_NEAR(result.flips[0] / 10.917, 1, 0.01);
    EXPECT_NEAR(result.flips[1] / 30.470, 1, 0.01);
    EXPECT_NEAR((result.flips[2] - result.flips[0]) / 39.1057, 1, 0.01);
    EXPECT_LE(result.momentum_error, 1e-4);
    EXPECT_LE(result.rotational_energy_error, 1e-4);
}

TEST_P(FreeRotation, ThrownBoxTumblesWhenTheoryTells) {
    World world;
    BodyDef def;
    def.mass = 10.0f;
    def.linear_velocity = {-2, 2, 8};
    def.angular_velocity = {0.1f, 5.0f, 0.1f};
    const BodyId box = add_body(world, Box{{0.05f, 0.2f, 0.45f}}, def);
    EXPECT_NEAR(world.kinetic_energy(), 368.54641, 1e-4);
    EXPECT_NEAR(double(glm::length(world.body(box).angular_momentum())), 3.41765, 1e-5);
    const Result result = watch(world, box, 10);
    ASSERT_GE(result.flips.size(), 3u);
    EXPECT_NEAR(result.flips[0] / 1.16596, 1, 0.01);
    EXPECT_NEAR(result.flips[1] / 4.19438, 1, 0.01);
    EXPECT_NEAR(result.flips[2] / 7.22280, 1, 0.01);
    EXPECT_LE(result.momentum_error, 1e-4);
}

} // namespace
} // namespace cairn_test
