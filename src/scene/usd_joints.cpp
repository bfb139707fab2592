// Joints of USD.
#include "scene/usd_stage.h"
#include "scene/xml_file.h"

#include <cairn/error.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace cairn::scene {

namespace {

constexpr const char* freedoms[] = {"transX", "transY", "transZ", "rotX", "rotY", "rotZ"};

float single(double value) { return static_cast<float>(std::clamp(value, -1e30, 1e30)); }

class UsdJointMaker {
  public:
    UsdJointMaker(const UsdStage& stage, const std::map<const UsdPrim*, BodyId>& bodies,
                  std::vector<std::string>& warnings, Scene& scene)
        : stage_(stage), bodies_(bodies), warnings_(warnings), scene_(scene) {}

    void add(const UsdPlace& place) {
        const UsdPrim& prim = *place.prim;
        for (const char* type : {"PhysicsRevoluteJoint", "PhysicsPrismaticJoint", "PhysicsSphericalJoint",
                                 "PhysicsFixedJoint", "PhysicsDistanceJoint", "PhysicsJoint"}) {
            stage_.know_type(type);
        }
        if (prim.type.substr(0, 7) != "Physics" || prim.type.find("Joint") == std::string::npos) return;
        stage_.value(prim, "physics:excludeFromArticulation");
        JointDef def;
        def.enabled = stage_.flag(prim, "physics:jointEnabled", true);
        def.name = prim.name;
        def.enable_collision = stage_.flag(prim, "physics:collisionEnabled", false);
        const double meters = stage_.meters();
        const auto strength = [&](const char* name, double unit) {
            const double most = stage_.number(prim, name, std::numeric_limits<double>::infinity());
            if (!(most > 0.0)) stage_.fail(prim, name, "must be > 0");
            return most < 1e30 ? static_cast<float>(most * unit) : std::numeric_limits<float>::infinity();
        };
        def.break_force = strength("physics:breakForce", meters);
        def.break_torque = strength("physics:breakTorque", meters * meters);
        const std::string axis = stage_.word(prim, "physics:axis", "X");
        if (axis != "X" && axis != "Y" && axis != "Z") stage_.fail(prim, "physics:axis", "must be X, Y or Z");
        const bool is_general = prim.type == "PhysicsJoint";
        glm::dvec3 along(0.0);
        along[is_general ? 0 : axis[0] - 'X'] = 1.0;
        const glm::dquat turn = turn_from_x(along);
        end(prim, "0", turn, def.body_a, def.frame_a);
        end(prim, "1", turn, def.body_b, def.frame_b);
        if (def.body_a == def.body_b || !(is_dynamic(def.body_a) || is_dynamic(def.body_b))) {
            const bool is_fixed = prim.type == "PhysicsFixedJoint";
            if (!is_fixed)
                warnings_.push_back(stage_.place(prim) +
                                    ": has no effect: it joins no bodies that can move relative to each other");
            return;
        }
        if (!make(prim, def)) return;
        try {
            scene_.world.create_joint(def);
        } catch (const Error& error) {
            throw Error(ErrorCode::invalid_file, stage_.place(prim), {}, error.what());
        }
    }

  private:
    bool is_dynamic(BodyId body) const {
        return !body.is_null() && scene_.world.body(body).type() == BodyType::dynamic;
    }

    void end(const UsdPrim& prim, const std::string& which, const glm::dquat& turn, BodyId& body, Transform& frame) {
        const std::string path = stage_.word(prim, "physics:body" + which);
        const UsdPlace* place = path.empty() ? nullptr : stage_.find(path);
        if (!path.empty() && place == nullptr) {
            throw Error(ErrorCode::invalid_file, stage_.place(prim) + ": physics:body" + which,
                        "<" + printable(path) + ">", "must be the path of a prim of this layer");
        }
        const Affine world = place == nullptr ? stage_.root() : place->world;
        const glm::dvec3 at = stage_.vector3(prim, "physics:localPos" + which, glm::dvec3(0.0));
        const NodeTransform parts = parts_of(world);
        Rigid there{world.linear * at + world.translation,
                    glm::normalize(parts.rotation * stage_.rotation(prim, "physics:localRot" + which) * turn)};
        const auto found = place == nullptr ? bodies_.end() : bodies_.find(place->body);
        if (place != nullptr && place->body != nullptr && found != bodies_.end()) {
            body = found->second;
            const Transform pose = scene_.world.body(body).transform();
            there = inverse({pose.position, glm::dquat(pose.rotation)}) * there;
        }
        frame = there.transform();
    }

    bool make(const UsdPrim& prim, JointDef& def) {
        const double meters = stage_.meters();
        if (prim.type == "PhysicsFixedJoint") {
            def.joint = FixedJoint{};
        } else if (prim.type == "PhysicsRevoluteJoint") {
            def.joint = HingeJoint{{range(prim, degree), motor(prim, "angular"), 0.0f}};
        } else if (prim.type == "PhysicsPrismaticJoint") {
            def.joint = SliderJoint{{range(prim, meters), motor(prim, "linear"), 0.0f}};
        } else if (prim.type == "PhysicsSphericalJoint") {
            const double first = stage_.number(prim, "physics:coneAngle0Limit", -1.0),
                         second = stage_.number(prim, "physics:coneAngle1Limit", -1.0);
            BallJoint ball;
            if (first >= 0.0 || second >= 0.0) {
                const double least = first < 0.0 ? second : second < 0.0 ? first : std::min(first, second);
                ball.cone_angle = single(std::min(least, 180.0) * degree);
                if (first != second) {
                    warnings_.push_back(stage_.place(prim) + ": has a circular cone, with the smaller of both angles");
                }
            }
            def.joint = ball;
        } else if (prim.type == "PhysicsDistanceJoint") {
            const double low = stage_.number(prim, "physics:minDistance", -1.0),
                         high = stage_.number(prim, "physics:maxDistance", -1.0);
            DistanceJoint distance;
            if (low >= 0.0 || high >= 0.0) {
                if (high >= 0.0 && low > high) stage_.fail(prim, "physics:minDistance", "must be at most maxDistance");
                distance.distance.limits = JointRange{
                    single(std::max(low, 0.0) * meters),
                    high >= 0.0 ? single(high * meters) : std::numeric_limits<float>::infinity(), std::nullopt};
            }
            def.joint = distance;
        } else if (prim.type == "PhysicsJoint") {
            def.joint = general(prim);
        } else {
            warnings_.push_back(stage_.place(prim) + ": has no effect: this type of joint is not supported");
            return false;
        }
        return true;
    }

    std::optional<JointRange> range(const UsdPrim& prim, double unit) const {
        const double infinity = std::numeric_limits<double>::infinity();
        const double low = stage_.number(prim, "physics:lowerLimit", -infinity),
                     high = stage_.number(prim, "physics:upperLimit", infinity);
        return range(prim, "physics:lowerLimit", low, high, unit);
    }

    std::optional<JointRange> range(const UsdPrim& prim, const std::string& name, double low, double high,
                                    double unit) const {
        constexpr double endless = 1e9;
        if (low < -endless && high > endless) return std::nullopt;
        if (!(low <= high)) stage_.fail(prim, name, "must be at most the upper bound");
        const float infinity = std::numeric_limits<float>::infinity();
        return JointRange{low < -endless ? -infinity : single(low * unit),
                          high > endless ? infinity : single(high * unit), std::nullopt};
    }

    std::optional<JointMotor> motor(const UsdPrim& prim, const std::string& freedom) const {
        if (!stage_.has(prim, "PhysicsDriveAPI:" + freedom)) return std::nullopt;
        const std::string drive = "drive:" + freedom + ":physics:";
        const bool turns = freedom == "angular" || freedom.substr(0, 3) == "rot";
        const bool is_acceleration = stage_.word(prim, drive + "type", "force") == "acceleration";
        const double meters = stage_.meters();
        const double unit = turns ? degree : meters; // unit of a position
        const double force = turns ? meters * meters : meters;
        // A force drive's stiffness is force per unit of position; an acceleration drive's stiffness does not depend on
        // the unit of length.
        const double by_position = is_acceleration ? (turns ? 1.0 / degree : 1.0) : force / unit;
        JointMotor result;
        result.position = single(unit * bounded(prim, drive + "targetPosition"));
        result.velocity = single(unit * bounded(prim, drive + "targetVelocity"));
        JointSpring spring;
        spring.stiffness = single(by_position * stage_.number(prim, drive + "stiffness", 0.0, 0.0, 1e30));
        spring.damping = single(by_position * stage_.number(prim, drive + "damping", 0.0, 0.0, 1e30));
        spring.is_acceleration = is_acceleration;
        result.spring = spring;
        const double most = stage_.number(prim, drive + "maxForce", std::numeric_limits<double>::infinity());
        if (!(most >= 0.0)) stage_.fail(prim, drive + "maxForce", "must be >= 0");
        if (most < 1e30) result.max_force = single(most * force);
        return result;
    }
    double bounded(const UsdPrim& prim, const std::string& name) const {
        return stage_.number(prim, name, 0.0, -1e12, 1e12);
    }

    // A degree of freedom whose lower limit is above the upper one is locked.
    GeneralJoint general(const UsdPrim& prim) const {
        GeneralJoint made;
        JointLimit locked[2] = {{JointAxis::linear, {}, 0.0f, 0.0f, std::nullopt, 0.0f},
                                {JointAxis::angular, {}, 0.0f, 0.0f, std::nullopt, 0.0f}};
        for (int i = 0; i < 6; ++i) {
            const std::string freedom = freedoms[i], limit = "limit:" + freedom + ":physics:";
            const JointAxis kind = i < 3 ? JointAxis::linear : JointAxis::angular;
            const double unit = i < 3 ? stage_.meters() : degree;
            const std::size_t axis = static_cast<std::size_t>(i % 3);
            if (stage_.has(prim, "PhysicsLimitAPI:" + freedom)) {
                const double infinity = std::numeric_limits<double>::infinity();
                const double low = stage_.number(prim, limit + "low", -infinity),
                             high = stage_.number(prim, limit + "high", infinity);
                if (!(low < high)) {
                    locked[i / 3].axes[axis] = true;
                } else if (const auto bounds = range(prim, limit + "low", low, high, unit)) {
                    JointLimit one{kind, {}, std::nullopt, std::nullopt, std::nullopt, 0.0f};
                    one.axes[axis] = true;
                    if (std::isfinite(bounds->lower)) one.min = bounds->lower;
                    if (std::isfinite(bounds->upper)) one.max = bounds->upper;
                    made.limits.push_back(one);
                }
            }
            if (const auto drive = motor(prim, freedom)) {
                JointDrive one;
                one.kind = kind;
                one.axis = i % 3;
                one.is_acceleration = drive->spring->is_acceleration;
                one.stiffness = drive->spring->stiffness;
                one.damping = drive->spring->damping;
                one.position_target = drive->position;
                one.velocity_target = drive->velocity;
                if (std::isfinite(drive->max_force)) one.max_force = drive->max_force;
                made.drives.push_back(one);
            }
        }
        for (const JointLimit& each : locked) {
            if (each.axes[0] || each.axes[1] || each.axes[2]) made.limits.push_back(each);
        }
        return made;
    }

    const UsdStage& stage_;
    const std::map<const UsdPrim*, BodyId>& bodies_;
    std::vector<std::string>& warnings_;
    Scene& scene_;
};

} // namespace

void add_usd_joints(const UsdStage& stage, const std::map<const UsdPrim*, BodyId>& bodies,
                    std::vector<std::string>& warnings, Scene& scene) {
    UsdJointMaker maker(stage, bodies, warnings, scene);
    for (const UsdPlace& place : stage.places()) maker.add(place);
}

} // namespace cairn::scene
