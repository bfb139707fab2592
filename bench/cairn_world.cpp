#include "bench/cairn_world.h"

namespace cairn::bench {

namespace {

// Hulls and meshes that several parts share, created once.
struct SharedShapes {
    explicit SharedShapes(const Scene& scene) {
        for (const ConvexHull& hull : scene.hulls) hulls.emplace_back(hull.points);
        for (const SurfaceMesh& mesh : scene.meshes) meshes.emplace_back(mesh.vertices, mesh.indices);
    }
    std::vector<Hull> hulls;
    std::vector<Mesh> meshes;
};

Shape shape_of(const Part& part, const SharedShapes& shared) {
    switch (part.shape) {
    case PartShape::sphere:
        return Sphere{part.radius};
    case PartShape::box:
        break;
    case PartShape::capsule:
        return Capsule{part.half_height, part.radius, {}};
    case PartShape::cylinder:
        return Cylinder{part.half_height, part.radius, {}};
    case PartShape::hull:
        return shared.hulls[part.index];
    case PartShape::mesh:
        return shared.meshes[part.index];
    }
    return Box{part.half_extents};
}

// The face of a box whose normal is `normal`, an axis of the box. `center` is moved to the face.
Plane face_of(const Part& box, Vec3& center) {
    int axis = 0;
    while (box.inner_face[axis] == 0.0f) ++axis;
    const int next = (axis + 1) % 3, last = (axis + 2) % 3;
    Plane face;
    face.normal = box.inner_face;
    face.tangent = Vec3(0.0f);
    face.tangent[next] = 1.0f;
    face.half_extents = glm::vec2(box.half_extents[next], box.half_extents[last]);
    center += box.rotation * (box.inner_face * box.half_extents[axis]);
    return face;
}

Joint joint_of(const SceneJoint& joint) {
    if (joint.kind == JointKind::hinge) {
        HingeJoint hinge;
        if (joint.angle) hinge.angle.limits = JointRange{joint.angle->lower, joint.angle->upper, {}};
        return hinge;
    }
    BallJoint ball;
    if (joint.reach) {
        ball.cone_angle = joint.reach->swing;
        ball.twist = JointRange{-joint.reach->twist, joint.reach->twist, {}};
    }
    return ball;
}

void add_joint(const SceneJoint& joint, World& world, const std::vector<BodyId>& bodies) {
    JointDef def;
    def.body_a = bodies[joint.body_a];
    def.body_b = bodies[joint.body_b];
    def.frame_a = {Position(joint.anchor_a), joint.axes_a};
    def.frame_b = {Position(joint.anchor_b), joint.axes_b};
    def.joint = joint_of(joint);
    world.create_joint(def);
}

} // namespace

WorldDef world_settings(const Scene& scene) {
    WorldDef def;
    def.gravity = scene.gravity;
    def.enable_sleep = false;
    return def;
}

std::vector<BodyId> add_bodies(const Scene& scene, World& world, Walls walls) {
    const SharedShapes shared(scene);
    std::vector<BodyId> bodies;
    bodies.reserve(scene.bodies.size());
    for (const SceneBody& body : scene.bodies) {
        BodyDef def;
        def.type = body.motion == Motion::dynamic ? BodyType::dynamic
                   : body.motion == Motion::fixed ? BodyType::static_
                                                  : BodyType::kinematic;
        def.position = Position(body.position);
        def.rotation = body.rotation;
        def.linear_velocity = body.linear_velocity;
        def.angular_velocity = body.angular_velocity;
        bodies.push_back(world.create_body(def));
        for (std::size_t i = 0; i < body.part_count; ++i) {
            const Part& part = scene.parts[body.first_part + i];
            ShapeDef shape;
            shape.position = part.position;
            shape.rotation = part.rotation;
            shape.density = body.density;
            shape.material.static_friction = shape.material.dynamic_friction = scene.friction;
            shape.material.restitution = scene.restitution;
            if (!scene.collides) shape.filter.collides_with = 0;
            if (walls == Walls::rectangles && part.inner_face != Vec3(0.0f)) {
                const Plane face = face_of(part, shape.position);
                world.add_shape(bodies.back(), face, shape);
            } else {
                world.add_shape(bodies.back(), shape_of(part, shared), shape);
            }
        }
    }
    for (const SceneJoint& joint : scene.joints) add_joint(joint, world, bodies);
    return bodies;
}

} // namespace cairn::bench
