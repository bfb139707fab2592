// Impact of a box's corner (row 17 of docs/validation.md).
#include "support.h"

namespace cairn_test {
namespace {

class Impact : public EveryStep {};
CAIRN_AT_EVERY_STEP(Impact);

// The momentum, because it stays after the impact while the angular velocity of a turning box does not.
TEST_P(Impact, BoxCornerLeavesAPlaneByTheImpulseFormula) {
    // J = -(1 + e) n.v_p / (1/m + n.((I^-1 (r x n)) x r)), along n at the corner.
    const float restitution = 0.5f;
    World world{without_gravity()};
    add_ground(world, surface(0, restitution));
    BodyDef def;
    def.mass = 2.0f;
    def.rotation = glm::normalize(Quat(0.8f, 0.35f, 0.2f, -0.4f));
    def.linear_velocity = {0.3f, -2, 0.1f};
    const Vec3 half{0.5f, 0.3f, 0.2f};
    glm::dvec3 corner{0, 1, 0}; // the lowest, from the center
    for (int i = 0; i < 8; ++i) {
        const Vec3 local{i & 1 ? half.x : -half.x, i & 2 ? half.y : -half.y, i & 4 ? half.z : -half.z};
        const glm::dvec3 world_corner(def.rotation * local);
        if (world_corner.y < corner.y) corner = world_corner;
    }
    def.position = {0, 0.05 - corner.y, 0};
    const BodyId box = add_body(world, Box{half}, def, surface(0, restitution));
    const glm::dmat3 inverse = glm::inverse(glm::dmat3(world.body(box).world_inertia()));
    const glm::dvec3 n{0, 1, 0}, v0(def.linear_velocity);
    const glm::dvec3 turn = inverse * glm::cross(corner, n);
    const double impulse = -1.5 * v0.y / (1 / 2.0 + glm::dot(n, glm::cross(turn, corner)));
    for (int i = 0; i < 1000 && world.body(box).linear_velocity().y == -2; ++i) world.step(dt());
    const glm::dvec3 v(world.body(box).linear_velocity()), momentum(world.body(box).angular_momentum());
    const glm::dvec3 expected_momentum = impulse * glm::cross(corner, n);
    EXPECT_NEAR(v.y / (v0.y + impulse / 2), 1, 1e-5);
    EXPECT_NEAR(v.x, v0.x, 1e-6);
    EXPECT_NEAR(v.z, v0.z, 1e-6);
    EXPECT_LT(glm::length(momentum - expected_momentum) / glm::length(expected_momentum), 1e-5);
}

} // namespace
} // namespace cairn_test
