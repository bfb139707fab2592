// The exact motion of elastic balls, the reference for Cairn, checked against known results.
#include "validation/billiards.h"

#include "bodies.h"

#include <gtest/gtest.h>

namespace cairn_test {
namespace {

using cairn::validation::BilliardBall;
using cairn::validation::Billiards;

TEST(Billiards, HeadOnAndObliqueAreThoseOfTheTextbook) {
    Billiards head_on({{{-1, 0, 0}, {2, 0, 0}}, {{0, 0, 0}, {0, 0, 0}}}, 0.1);
    ASSERT_TRUE(head_on.to_next_impact());
    EXPECT_NEAR(head_on.time(), 0.4, 1e-12);
    EXPECT_NEAR(head_on.balls()[0].velocity.x, 0, 1e-12);
    EXPECT_NEAR(head_on.balls()[1].velocity.x, 2, 1e-12);
    EXPECT_FALSE(head_on.to_next_impact());
    // The line of centers is at 30 degrees to the velocity.
    Billiards oblique({{{-1, 0.1, 0}, {1, 0, 0}}, {{0, 0, 0}, {0, 0, 0}}}, 0.1);
    ASSERT_TRUE(oblique.to_next_impact());
    const glm::dvec3 first = oblique.balls()[0].velocity, second = oblique.balls()[1].velocity;
    EXPECT_NEAR(glm::dot(first, second), 0, 1e-12);
    EXPECT_NEAR(second.y / second.x, -std::tan(radians(30)), 1e-12);
    EXPECT_NEAR(glm::length(second), std::cos(radians(30)), 1e-12);
}

TEST(Billiards, ARowHandsTheImpactOn) {
    std::vector<BilliardBall> row;
    for (int i = 0; i < 5; ++i) row.push_back({{0.3 * i, 0, 0}, {i == 0 ? 1.0 : 0.0, 0, 0}});
    Billiards cradle(row, 0.1);
    cradle.advance_to(0.39);
    EXPECT_EQ(cradle.impacts().size(), 3u);
    cradle.advance_to(2);
    EXPECT_EQ(cradle.impacts().size(), 4u);
    EXPECT_NEAR(cradle.balls()[4].velocity.x, 1, 1e-12);
    EXPECT_NEAR(cradle.balls()[4].position.x, 1.2 + 1.6, 1e-12);
    EXPECT_NEAR(cradle.balls()[0].position.x, 0.1, 1e-12);
}

TEST(Billiards, EnergyAndMomentumStayAndNothingOverlaps) {
    Random random(1);
    std::vector<BilliardBall> balls;
    for (int i = 0; i < 27; ++i) balls.push_back({0.3 * Position(i % 3, i / 3 % 3, i / 9), 3.0 * random.direction()});
    Billiards gas(balls, 0.1);
    const auto energy = [&] {
        double sum = 0;
        for (const BilliardBall& ball : gas.balls()) sum += glm::dot(ball.velocity, ball.velocity);
        return sum;
    };
    const double before = energy();
    glm::dvec3 change(0);
    for (int i = 0; i < 30 && gas.to_next_impact(); ++i)
        for (std::size_t a = 0; a < 27; ++a)
            for (std::size_t b = 0; b < a; ++b)
                EXPECT_GT(glm::length(gas.balls()[a].position - gas.balls()[b].position), 0.2 - 1e-12);
    for (std::size_t i = 0; i < 27; ++i) change += gas.balls()[i].velocity - balls[i].velocity;
    EXPECT_GT(gas.impacts().size(), 10u);
    EXPECT_NEAR(energy(), before, 1e-9 * before);
    EXPECT_LT(glm::length(change), 1e-9);
}

} // namespace
} // namespace cairn_test
