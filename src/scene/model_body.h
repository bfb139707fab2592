// Bodies of models before they are added to a world; shared by the readers of MJCF, SDF and USD.
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
    Rigid at; // pose of its center of mass and axes in the frame of the body
};

struct ModelShape {
    Shape shape;
    Rigid at;                  // in the frame of the body
    std::vector<Hull> parts{}; // convex parts instead of the shape, if there are any
    Material material{};
    CollisionFilter filter{};
    Vec3 surface_velocity{0.0f, 0.0f, 0.0f};
    std::optional<Vec3> color{};
    std::string place; // in the file, for messages
    bool is_trigger = false;
};

struct ModelVisual {
    std::shared_ptr<const Surface> surface;
    Rigid at;
    Vec3 color{1.0f, 1.0f, 1.0f};
    std::shared_ptr<const Texture> texture{}; // none: no texture
    std::shared_ptr<const Finish> finish{};   // none: default finish, a rough dielectric
};

struct ModelBody {
    std::string name, place; // in the file
    BodyType type = BodyType::dynamic;
    Rigid world;
    std::vector<ModelMass> masses; // at least one for a dynamic body
    std::vector<ModelShape> shapes;
    std::vector<ModelVisual> looks;                  // none: the body is shown by its shapes
    glm::dvec3 velocity{0.0}, angular_velocity{0.0}; // of the origin of the body; in world axes
    double gravity_scale = 1.0;
    double linear_damping = 0.0, angular_damping = 0.0; // 1/s
    bool may_sleep = true;
};

// Adds the body with all its shapes and visual meshes. Throws Error (invalid_file) naming the place in the file.
BodyId add_model_body(const ModelBody& body, Scene& scene);

// Truncates the list of warnings to a readable length.
void limit_warnings(std::vector<std::string>& warnings);

} // namespace cairn::scene
