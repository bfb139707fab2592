#include "viewer/fluid_drawing.h"

#include <array>
#include <cmath>

namespace cairn::viewer {

namespace {

const Vec3 water_color{0.03f, 0.22f, 0.42f}; // linear
constexpr double farthest = 1000;            // m

} // namespace

std::vector<FluidLayout> read_fluids(const World& world) {
    std::vector<FluidLayout> fluids;
    const glm::dvec3 gravity(world.settings().gravity);
    for (const ForceFieldId id : world.force_fields()) {
        const ForceField& field = world.force_field(id);
        if (field.kind != ForceField::Kind::fluid) continue;
        FluidLayout fluid{field.center, field.half_extents, {}};
        if (glm::length(gravity) > 0) fluid.up = -glm::normalize(gravity);
        fluids.push_back(fluid);
    }
    return fluids;
}

void draw_fluids(RenderFrame& frame, const WorldMotion& motion) {
    for (const FluidLayout& fluid : motion.fluids) {
        if (fluid.up == glm::dvec3(0)) continue; // without gravity there is no surface
        const glm::dvec3 size = glm::abs(fluid.up);
        const int vertical = size.y >= size.x && size.y >= size.z ? 1 : size.x >= size.z ? 0 : 2;
        const glm::dvec3 center = fluid.center - frame.origin;
        std::array<Vec3, 4> corners;
        for (int i = 0; i < 4; ++i) {
            glm::dvec3 p = center;
            for (const int k : {1, 2}) {
                const int axis = (vertical + k) % 3;
                const double half = double(fluid.half_extents[axis]), side = (i & k) != 0 ? 1 : -1;
                p[axis] = std::isfinite(half) ? center[axis] + side * half : side * farthest;
                p[vertical] -= fluid.up[axis] * (p[axis] - center[axis]) / fluid.up[vertical]; // horizontal
            }
            corners[std::size_t(i)] = Vec3(p);
        }
        frame.fluids.push_back({corners[0], corners[1], corners[3], water_color});
        frame.fluids.push_back({corners[0], corners[3], corners[2], water_color});
    }
}

} // namespace cairn::viewer
