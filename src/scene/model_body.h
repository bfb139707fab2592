// Bodies of models on their way into a world: what readers of MJCF, SDF and USD have in common.
#pragma once

#include "scene/rigid.h"
#include "scene/scene.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace cairn::scene {

struct ModelMass {
    double mass = 0.0; // kg, > 0
    glm::dmat3 inertia{0.0};
    Rigid at; // of its center of mass and axes, in the body
};

struct ModelShape {
    Shape shape;
    Rigid at;                  // in the body
    std::vector<Hull> parts{}; // instead of the shape, if there are any
    Material material{};
    CollisionFilter filter{};
    Vec3 surface_velocity{0.0f, 0.0f, 0.0f};
    std::optional<Vec3> color{};
    std::string place; // in the file
    bool is_trigger = false;
};

struct ModelLook {
    std::shared_ptr<const Surface> surface;
    Rigid at;
    Vec3 color{1.0f, 1.0f, 1.0f};
    std::shared_ptr<const Texture> texture{}; // none: not covered
    std::shared_ptr<const Finish> finish{};   // none: smooth
};

struct ModelBody {
    std::string name, place; // in the file
    BodyType type = BodyType::dynamic;
    Rigid world;
    std::vector<ModelMass> masses; // of a dynamic body: at least one
    std::vector<ModelShape> shapes;
    std::vector<ModelLook> looks;                    // none: its shapes are its looks
    glm::dvec3 velocity{0.0}, angular_velocity{0.0}; // of its origin; in the world
    double gravity_scale = 1.0;
    double linear_damping = 0.0, angular_damping = 0.0; // 1/s
    bool may_sleep = true;
};

// Makes the body and all that is on it. Throws Error (invalid_file) naming the place in the file.
BodyId add_model_body(const ModelBody& body, Scene& scene);

// No more lines than anybody reads.
void limit_warnings(std::vector<std::string>& warnings);

} // namespace cairn::scene
