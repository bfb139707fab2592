// The body tree of an MJCF model, and the initial poses that follow from its joints.
#include "scene/mass_sum.h"
#include "scene/mjcf_model.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace cairn::scene {

namespace {

constexpr std::size_t max_parts = 100000, max_geoms = 200000;
constexpr std::size_t max_joints_of_a_body = 6;

class TreeReader {
  public:
    TreeReader(bool fixed_base, MjcfAssets& assets, MjcfModel& model)
        : fixed_base_(fixed_base), assets_(assets), model_(model) {}

    void read(const XmlElement& root) {
        MjcfPart world;
        world.kind = MjcfPart::Kind::fixed;
        world.body.type = BodyType::static_;
        world.body.name = "world";
        world.body.place = root.place();
        model_.parts.push_back(std::move(world));
        model_.bodies.insert({"world", {}});
        for (const XmlElement& body : root.children("worldbody"))
            below(body, {0, {}, 0, "", has_mass_from_geoms(body)});
    }

  private:
    // The state of the traversal at an element.
    struct Place {
        std::size_t part;
        Rigid at; // in the frame of the part
        std::size_t default_class;
        std::string suffix; // appended to names inside replicas
        bool has_geom_mass;
    };

    bool has_mass_from_geoms(const XmlElement& body) const {
        using Way = MjcfSettings::InertiaFromGeoms;
        if (model_.settings.inertia_from_geoms != Way::where_absent) {
            return model_.settings.inertia_from_geoms == Way::always;
        }
        return !body.child("inertial");
    }

    std::size_t class_of(const XmlElement& element, std::size_t otherwise) const {
        const auto name = element.attribute("childclass");
        return name ? model_.defaults.find(*name) : otherwise;
    }

    // Reads all elements in a body, a frame or a replica.
    void below(const XmlElement& owner, const Place& place) {
        for (const char* tag : {"geom", "site", "body", "frame", "replicate", "inertial", "joint", "freejoint"}) {
            owner.mark_read(tag);
        }
        for (const XmlElement& child : owner.children()) {
            const std::string_view tag = child.tag();
            if (tag == "geom") {
                if (++geoms_ > max_geoms)
                    child.fail("must not raise the number of geoms above " + std::to_string(max_geoms));
                add_mjcf_geom(MjcfElement(child, model_.defaults, place.default_class), place.at, place.has_geom_mass,
                              place.suffix, model_.parts[place.part], assets_, model_);
            } else if (tag == "site") {
                const MjcfElement site(child, model_.defaults, place.default_class);
                const Rigid frame = place.at * mjcf_frame(site, model_.settings);
                if (!site.name().empty()) model_.sites.insert({site.name() + place.suffix, {place.part, frame}});
            } else if (tag == "body") {
                body(child, place);
            } else if (tag == "frame") {
                Place inside = place;
                inside.default_class = class_of(child, place.default_class);
                inside.at = place.at * mjcf_frame(MjcfElement(child, model_.defaults, 0), model_.settings);
                below(child, inside);
            } else if (tag == "replicate") {
                replicate(child, place);
            } else if (tag == "composite" || tag == "flexcomp" || tag == "attach" || tag == "plugin") {
                model_.is_whole = false;
            }
        }
    }

    void replicate(const XmlElement& element, const Place& place) {
        const long count = element.require("count").whole(1, static_cast<long>(max_parts));
        Rigid step;
        if (const auto text = element.attribute("offset")) step.position = text->vector3();
        if (const auto text = element.attribute("euler")) {
            glm::dvec3 angles = text->vector3();
            for (int i = 0; i < 3; ++i) angles[i] = model_.settings.angle(angles[i]);
            step.rotation = mjcf_euler(angles, model_.settings.euler);
        }
        const std::string separator = element.text_of("sep");
        const std::size_t digits = std::to_string(count - 1).size();
        Place inside = place;
        for (long i = 0; i < count; ++i) {
            std::string number = std::to_string(i);
            number.insert(0, digits - number.size(), '0');
            inside.suffix = separator + number + place.suffix;
            below(element, inside);
            inside.at = inside.at * step;
        }
        model_.is_whole = false; // other elements may refer to names of replicas in ways that are not supported
    }

    void body(const XmlElement& element, const Place& place) {
        Place here = place;
        here.default_class = class_of(element, place.default_class);
        const MjcfElement reader(element, model_.defaults, 0);
        const Rigid frame = place.at * mjcf_frame(reader, model_.settings);
        here.has_geom_mass = has_mass_from_geoms(element);
        std::vector<MjcfJoint> joints = read_joints(element, here);
        const auto mocap = element.attribute("mocap");
        const bool is_mocap = mocap && mocap->boolean();
        if (is_mocap && (!joints.empty() || place.part != 0)) {
            mocap->fail("must belong to bodies without joints directly in the world");
        }
        if (joints.empty() && !is_mocap) {
            here.at = frame;
        } else {
            here.at = {};
            here.part = model_.parts.size();
            if (here.part > max_parts)
                element.fail("must not raise the number of bodies above " + std::to_string(max_parts));
            add_part(element, frame, is_mocap, std::move(joints), place);
        }
        const std::string name = element.text_of("name");
        if (!name.empty() && !model_.bodies.insert({name + place.suffix, {here.part, here.at}}).second) {
            element.fail("must not have the name of another body");
        }
        if (const auto inertial = element.child("inertial"); inertial && !here.has_geom_mass) {
            read_inertial(*inertial, here);
        }
        below(element, here);
    }

    void add_part(const XmlElement& element, const Rigid& frame, bool is_mocap, std::vector<MjcfJoint> joints,
                  const Place& place) {
        MjcfPart part;
        part.kind = is_mocap ? MjcfPart::Kind::mocap : MjcfPart::Kind::moving;
        part.body.type = is_mocap ? BodyType::kinematic : BodyType::dynamic;
        if (fixed_base_ && !joints.empty() && joints[0].kind == MjcfJoint::Kind::free) {
            part.kind = MjcfPart::Kind::fixed;
            part.body.type = BodyType::static_;
        }
        part.body.name = element.text_of("name") + place.suffix;
        part.body.place = element.place();
        if (const auto factor = element.attribute("gravcomp"))
            part.body.gravity_scale = 1.0 - factor->number(-1e6, 1e6);
        part.parent = place.part;
        part.frame = frame;
        part.drawn = model_.parts[place.part].drawn * frame;
        for (MjcfJoint& joint : joints) {
            if (joint.kind == MjcfJoint::Kind::free && place.part != 0) {
                throw Error(ErrorCode::invalid_file, joint.place, {}, "must belong to a body directly in the world");
            }
            joint.part = model_.parts.size();
            joint.start_pose = part.drawn;
            part.joints.push_back(model_.joints.size());
            if (!joint.name.empty() && !model_.joint_names.insert({joint.name, model_.joints.size()}).second) {
                throw Error(ErrorCode::invalid_file, joint.place, {}, "must not have the name of another joint");
            }
            model_.joints.push_back(std::move(joint));
        }
        model_.parts.push_back(std::move(part));
    }

    std::vector<MjcfJoint> read_joints(const XmlElement& body, const Place& place) {
        std::vector<MjcfJoint> joints;
        for (const XmlElement& child : body.children()) {
            if (child.tag() != "joint" && child.tag() != "freejoint") continue;
            joints.push_back(read_joint(child, place));
            const bool is_free = joints.back().kind == MjcfJoint::Kind::free;
            if (joints.size() > (is_free || joints[0].kind == MjcfJoint::Kind::free ? 1 : max_joints_of_a_body)) {
                child.fail("must be the only free joint of a body, or one of at most 6 others");
            }
        }
        return joints;
    }

    MjcfJoint read_joint(const XmlElement& child, const Place& place) {
        const MjcfElement element(child, model_.defaults, place.default_class);
        MjcfJoint joint;
        joint.name = element.name() + (element.name().empty() ? "" : place.suffix);
        joint.place = element.place();
        joint.kind = MjcfJoint::Kind::free;
        if (child.tag() == "freejoint") return joint;
        const auto type = element.attribute("type");
        joint.kind = type ? static_cast<MjcfJoint::Kind>(type->choice({"free", "ball", "hinge", "slide"}))
                          : MjcfJoint::Kind::hinge;
        if (joint.kind == MjcfJoint::Kind::free) return joint;
        const MjcfSettings& settings = model_.settings;
        joint.anchor = element.vector3("pos", glm::dvec3(0.0));
        if (const auto axis = element.attribute("axis")) joint.axis = unit_vector(axis->vector3(), *axis);
        const bool turns = joint.kind != MjcfJoint::Kind::slide;
        const auto coordinate = [&](double value) { return turns ? settings.angle(value) : value; };
        joint.reference = joint.start = coordinate(element.number("ref", 0.0, -1e6, 1e6));
        joint.rest = coordinate(element.number("springref", 0.0, -1e6, 1e6));
        if (element.is_on("limited", "range", settings.autolimits) && settings.limits) {
            const auto range = element.attribute("range");
            if (!range) element.fail("must have the attribute range where limited is true");
            const std::vector<double> bounds = range->numbers(2, 2);
            if (!(bounds[0] <= bounds[1]) || std::fabs(bounds[0]) > 1e9 || std::fabs(bounds[1]) > 1e9) {
                range->fail("must be two bounds, the lower first");
            }
            joint.range = {coordinate(bounds[0]), coordinate(bounds[1])};
        }
        if (element.is_on("actuatorfrclimited", "actuatorfrcrange", settings.autolimits)) {
            const auto range = element.attribute("actuatorfrcrange");
            if (!range) element.fail("must have the attribute actuatorfrcrange where actuatorfrclimited is true");
            const std::vector<double> bounds = range->numbers(2, 2);
            joint.effort = std::min(std::max(std::fabs(bounds[0]), std::fabs(bounds[1])), 1e30);
        }
        const auto first = [&](const char* name) { // newer files may have polynomial coefficients
            const auto text = element.attribute(name);
            if (!text) return 0.0;
            const std::vector<double> values = text->numbers(1, 10);
            if (!(values[0] >= 0.0)) text->fail("must be >= 0");
            return values[0];
        };
        if (settings.springs) joint.stiffness = first("stiffness");
        if (settings.dampers) joint.damping = first("damping");
        if (settings.friction) joint.friction = element.number("frictionloss", 0.0, 0.0, 1e30);
        joint.armature = element.number("armature", 0.0, 0.0, 1e12);
        return joint;
    }

    void read_inertial(const XmlElement& element, const Place& place) {
        const MjcfElement reader(element, model_.defaults, 0);
        const double mass = element.require("mass").number(0.0, 1e12);
        Rigid at = place.at * mjcf_frame(reader, model_.settings);
        glm::dmat3 inertia(0.0);
        const auto diagonal = element.attribute("diaginertia"), full = element.attribute("fullinertia");
        if (diagonal) {
            const glm::dvec3 d = diagonal->vector3();
            inertia = glm::dmat3(d.x, 0, 0, 0, d.y, 0, 0, 0, d.z);
        } else if (full) {
            const std::vector<double> f = full->numbers(6, 6);
            inertia = glm::dmat3(f[0], f[3], f[4], f[3], f[1], f[5], f[4], f[5], f[2]);
        }
        for (int i = 0; i < 9; ++i) {
            if (!(std::fabs(inertia[i / 3][i % 3]) <= 1e15)) element.fail("must have an inertia of at most 1e15 kg m2");
        }
        if (mass == 0.0) return;
        MjcfPart& part = model_.parts[place.part];
        if (diagonal || full) {
            const bool is_zero = inertia == glm::dmat3(0.0);
            if (!is_zero) inertia = valid_inertia(inertia, element.place(), model_.warnings);
        }
        part.body.masses.push_back({mass, inertia, at});
        part.own_mass += mass;
    }

    bool fixed_base_;
    MjcfAssets& assets_;
    MjcfModel& model_;
    std::size_t geoms_ = 0;
};

// Reads the numbers of a keyframe in order.
class Numbers {
  public:
    explicit Numbers(std::vector<double> values) : values_(std::move(values)) {}
    double next() { return values_[at_++]; }
    glm::dvec3 vector() {
        const double x = next(), y = next(), z = next();
        return {x, y, z};
    }
    glm::dquat turn(const XmlText& text) {
        const double w = next();
        const glm::dvec3 v = vector();
        const double length = std::sqrt(w * w + glm::dot(v, v));
        if (!(length > 1e-6 && length < 1e6)) text.fail("must have rotations that are not zero");
        return glm::dquat(w, v.x, v.y, v.z) / length;
    }

  private:
    std::vector<double> values_;
    std::size_t at_ = 0;
};

// Returns the values of a keyframe; nothing if it has none, or if their number does not match because parts of the
// model are not read.
std::optional<Numbers> key_numbers(const std::optional<XmlText>& text, std::size_t count, MjcfModel& model) {
    if (!text) return std::nullopt;
    const std::vector<double> values = text->numbers(0, 1000000);
    if (values.size() != count) {
        if (model.is_whole) text->fail("must have " + std::to_string(count) + " numbers, as the model has coordinates");
        model.warnings.push_back(text->place +
                                 ": has values for parts of the model that are not supported, and is left out");
        return std::nullopt;
    }
    for (const double value : values) {
        if (!(std::fabs(value) <= 1e6)) text->fail("must have numbers within 1000000");
    }
    return Numbers(values);
}

void read_key(const XmlElement& key, MjcfModel& model) {
    std::size_t coordinates = 0, rates = 0, mocaps = 0;
    for (const MjcfJoint& joint : model.joints) {
        const bool is_free = joint.kind == MjcfJoint::Kind::free, is_ball = joint.kind == MjcfJoint::Kind::ball;
        coordinates += is_free ? 7 : is_ball ? 4 : 1;
        rates += is_free ? 6 : is_ball ? 3 : 1;
    }
    for (const MjcfPart& part : model.parts) mocaps += part.kind == MjcfPart::Kind::mocap;
    const auto place = key.attribute("qpos"), speed = key.attribute("qvel"), at = key.attribute("mpos"),
               turned = key.attribute("mquat");
    if (auto numbers = key_numbers(place, coordinates, model)) {
        for (MjcfJoint& joint : model.joints) {
            if (joint.kind == MjcfJoint::Kind::free) joint.start_pose.position = numbers->vector();
            if (joint.kind == MjcfJoint::Kind::free) joint.start_pose.rotation = numbers->turn(*place);
            if (joint.kind == MjcfJoint::Kind::ball) joint.start_turn = numbers->turn(*place);
            if (joint.is_scalar()) joint.start = numbers->next();
        }
    }
    if (auto numbers = key_numbers(speed, rates, model)) {
        for (MjcfJoint& joint : model.joints) {
            if (joint.kind == MjcfJoint::Kind::free) joint.start_velocity = numbers->vector();
            if (!joint.is_scalar()) joint.start_spin = numbers->vector();
            if (joint.is_scalar()) joint.speed = numbers->next();
        }
    }
    auto positions = key_numbers(at, 3 * mocaps, model), turns = key_numbers(turned, 4 * mocaps, model);
    for (MjcfPart& part : model.parts) {
        if (part.kind != MjcfPart::Kind::mocap) continue;
        if (positions) part.frame.position = positions->vector();
        if (turns) part.frame.rotation = turns->turn(*turned);
    }
}

// A joint that begins beyond a rigid limit would be pushed back violently at once, so it starts at the limit.
void keep_in_ranges(MjcfModel& model) {
    std::string first;
    int count = 0;
    for (MjcfJoint& joint : model.joints) {
        if (!joint.is_scalar() || !joint.range) continue;
        const double kept = std::clamp(joint.start, joint.range->first, joint.range->second);
        if (kept == joint.start) continue;
        joint.start = kept;
        if (count++ == 0) first = joint.place;
    }
    if (count == 0) return;
    model.warnings.push_back(first + (count > 1 ? " and " + std::to_string(count - 1) + " more" : "") +
                             ": outside of its range at the start, and moved to the nearest end of the range");
}

// Computes the pose and velocities of a part from those of its parent and its joints.
void place_part(MjcfPart& part, const MjcfPart& parent, const MjcfModel& model) {
    Rigid frame = parent.body.world * part.frame; // the frame that the next joint moves, and its velocities
    glm::dvec3 w = parent.body.angular_velocity;
    glm::dvec3 v = parent.body.velocity + glm::cross(w, frame.position - parent.body.world.position);
    const auto move = [&](const Rigid& motion) { // moves the frame as part of a rigid body
        const Rigid next = frame * motion;
        v += glm::cross(w, next.position - frame.position);
        frame = next;
    };
    for (const std::size_t index : part.joints) {
        const MjcfJoint& joint = model.joints[index];
        if (joint.kind == MjcfJoint::Kind::free) {
            frame = upright * joint.start_pose;
            v = upright.rotation * joint.start_velocity;
            w = frame.rotation * joint.start_spin;
            continue;
        }
        const bool is_ball = joint.kind == MjcfJoint::Kind::ball;
        const Rigid there{joint.anchor, {1.0, 0.0, 0.0, 0.0}};
        const Rigid motion = is_ball ? there * Rigid{{0, 0, 0}, joint.start_turn} * inverse(there)
                                     : joint.motion(joint.start - joint.reference);
        move(motion);
        if (joint.kind == MjcfJoint::Kind::slide) {
            v += frame.rotation * (joint.axis * joint.speed);
            continue;
        }
        const glm::dvec3 spin = frame.rotation * (is_ball ? joint.start_spin : joint.axis * joint.speed);
        v -= glm::cross(spin, frame.rotation * joint.anchor);
        w += spin;
    }
    part.body.world = frame;
    part.body.velocity = v;
    part.body.angular_velocity = w;
}

} // namespace

Rigid MjcfJoint::motion(double by) const {
    if (by == 0.0 || !is_scalar()) return {};
    if (kind == Kind::slide) return {axis * by, {1.0, 0.0, 0.0, 0.0}};
    const glm::dquat turn = turn_about(axis, by);
    return {anchor - turn * anchor, turn};
}

const MjcfJoint* MjcfModel::joint(const XmlText& name) {
    const auto found = joint_names.find(name.text);
    if (found != joint_names.end()) return &joints[found->second];
    if (is_whole) name.fail("must be the name of a joint");
    return nullptr;
}

void read_mjcf_bodies(const XmlElement& root, bool fixed_base, MjcfAssets& assets, MjcfModel& model) {
    TreeReader(fixed_base, assets, model).read(root);
}

std::vector<double> place_mjcf_parts(const XmlElement& root, MjcfModel& model) {
    std::vector<double> control;
    bool is_first = true;
    for (const XmlElement& section : root.children("keyframe")) {
        for (const XmlElement& key : section.children("key")) {
            if (is_first) {
                read_key(key, model);
                if (const auto text = key.attribute("ctrl")) control = text->numbers(0, 1000000);
            }
            is_first = false;
        }
    }
    keep_in_ranges(model);
    model.parts[0].body.world = upright;
    for (std::size_t i = 1; i < model.parts.size(); ++i) {
        place_part(model.parts[i], model.parts[model.parts[i].parent], model);
    }
    return control;
}

} // namespace cairn::scene
