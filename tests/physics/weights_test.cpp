// The estimated loads of contacts include all that acts on bodies: gravity, gravity scales and force fields.
#include "support.h"

#include "validation/random_starts.h"

#include <algorithm>
#include <functional>
#include <vector>

namespace cairn_test {
namespace {

struct Sinking {
    double fastest, depth; // m/s; m by which the top has sunk at the end
};

// Creates a tower along `up` and steps it for 2 s.
Sinking sinking_of_tower(int boxes, const glm::dvec3& up, const std::function<void(World&)>& pull, float scale) {
    World world(without_gravity());
    pull(world);
    const glm::dvec3 aside = glm::normalize(glm::cross(up, glm::dvec3(0.3, 0.5, 0.7)));
    const glm::dmat3 axes(aside, up, glm::cross(aside, up));
    BodyDef def;
    def.rotation = Quat(glm::quat_cast(axes));
    def.type = BodyType::static_;
    def.position = -0.5 * up;
    add_body(world, Box{{5, 0.5f, 5}}, def, surface(0.6f));
    def.type = BodyType::dynamic;
    def.gravity_scale = scale;
    std::vector<BodyId> ids;
    for (int i = 0; i < boxes; ++i) {
        def.position = (i + 0.5) * up;
        ids.push_back(add_body(world, Box{}, def, surface(0.6f)));
    }
    double fastest = 0;
    for (int step = 0; step < 120; ++step) {
        world.step(1.0f / 60);
        for (const BodyId id : ids) fastest = std::max(fastest, double(glm::length(world.body(id).linear_velocity())));
    }
    return {fastest, boxes - 0.5 - glm::dot(world.body(ids.back()).position(), up)};
}

// When the number of substeps followed the gravity of the world alone, towers in force fields sank into themselves by
// up to 11 cm at 0.7 m/s, as did those with large gravity scales.
TEST(Weights, OfTowersAreKnownWhateverPulls) {
    RandomStart random(77);
    for (const int boxes : {10, 20, 40})
        for (int i = 0; i < 4; ++i) {
            const glm::dvec3 up =
                glm::normalize(glm::dvec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(0.1, 1)));
            const auto gravity = [&](double g) {
                return [&up, g](World& world) {
                    WorldDef settings = world.settings();
                    settings.gravity = Vec3(-g * up);
                    world.set_settings(settings);
                };
            };
            const auto field = [&](bool is_radial) {
                return [&up, is_radial](World& world) {
                    ForceField pull;
                    pull.kind = is_radial ? ForceField::Kind::radial : ForceField::Kind::uniform;
                    pull.direction = Vec3(-9.81 * up);
                    pull.center = -500.0 * up;
                    pull.strength = 9.81f;
                    world.add_force_field(pull);
                };
            };
            const Sinking known = sinking_of_tower(boxes, up, gravity(9.81), 1);
            const Sinking others[] = {sinking_of_tower(boxes, up, field(false), 1),
                                      sinking_of_tower(boxes, up, field(true), 1),
                                      sinking_of_tower(boxes, up, gravity(9.81 / 4), 4)};
            for (const Sinking& other : others) {
                EXPECT_LT(other.fastest, 1.1 * known.fastest + 0.01) << boxes << ", " << &other - others;
                EXPECT_LT(other.depth, 1.1 * known.depth + 0.0005) << boxes << ", " << &other - others;
            }
        }
}

} // namespace
} // namespace cairn_test
