// Equality constraints of MJCF models, and the collision filters of their geoms.
#include "scene/layers.h"
#include "scene/mjcf_model.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

namespace cairn::scene {

namespace {

class ConstraintMaker {
  public:
    ConstraintMaker(MjcfModel& model, Scene& scene) : model_(model), scene_(scene) {}

    void equality(const XmlElement& child) {
        const MjcfElement element(child, model_.defaults, 0);
        const auto active = element.attribute("active");
        const bool is_active = !active || active->boolean();
        if (child.tag() == "joint") return tie_joints(element, is_active);
        const bool is_weld = child.tag() == "weld";
        const bool has_sites = element.attribute("site1") || element.attribute("site2");
        const MjcfAttached* a = end(element, has_sites ? "site1" : "body1", has_sites);
        const MjcfAttached* b = end(element, has_sites ? "site2" : "body2", has_sites);
        if (a == nullptr || b == nullptr) {
            model_.warnings.push_back(element.place() + ": has no effect: the joined elements are not supported");
            return;
        }
        Rigid in_a = a->at, in_b = b->at;
        if (!has_sites) {
            const Rigid drawn_a = model_.parts[a->part].drawn * a->at, drawn_b = model_.parts[b->part].drawn * b->at;
            const glm::dvec3 anchor = element.vector3("anchor", glm::dvec3(0.0));
            const Rigid there{anchor, {1.0, 0.0, 0.0, 0.0}};
            if (is_weld) { // the anchor is in the frame of body 2
                const std::optional<Rigid> given = relative_pose(element);
                in_a = in_a * (given ? *given : inverse(drawn_a) * drawn_b * there);
                in_b = in_b * there;
            } else {
                in_a = in_a * there;
                in_b = in_b * inverse(drawn_b) * drawn_a * there;
            }
        }
        JointDef def;
        if (is_weld) {
            def.joint = FixedJoint{};
        } else {
            def.joint = BallJoint{};
        }
        def.name = element.name();
        def.enabled = is_active;
        def.enable_collision = true; // an equality constraint does not disable collision between its bodies
        create(def, *a, in_a, *b, in_b, element);
    }

    void exclude(const XmlElement& child) {
        const MjcfElement element(child, model_.defaults, 0);
        const MjcfAttached* a = end(element, "body1", false);
        const MjcfAttached* b = end(element, "body2", false);
        if (a == nullptr || b == nullptr || a->part == b->part) return;
        const auto [low, high] = std::minmax(a->part, b->part);
        if (!excluded_.insert({low, high}).second) return;
        if (model_.parts[a->part].id.is_null() || model_.parts[b->part].id.is_null()) return; // without any shape
        JointDef def; // a joint without limits, whose only effect is to disable collision between the two bodies
        def.joint = GeneralJoint{};
        def.name = "exclude " + child.text_of("body1") + " " + child.text_of("body2");
        create(def, *a, a->at, *b, b->at, element);
    }

  private:
    const MjcfAttached* end(const MjcfElement& element, const char* attribute, bool is_site) const {
        const auto name = element.attribute(attribute);
        const auto& list = is_site ? model_.sites : model_.bodies;
        if (!name && std::string_view(attribute) == "body2") return &list.at("world");
        if (!name) element.fail(std::string("must have the attribute ") + attribute);
        const auto found = list.find(name->text);
        if (found != list.end()) return &found->second;
        if (model_.is_whole) name->fail(is_site ? "must be the name of a site" : "must be the name of a body");
        return nullptr;
    }

    // Returns the pose of the anchor of body 2 relative to body 1; nothing if the pose of the model file applies.
    static std::optional<Rigid> relative_pose(const MjcfElement& element) {
        const auto text = element.attribute("relpose");
        if (!text) return std::nullopt;
        std::vector<double> v = text->numbers(1, 7);
        v.resize(7, 0.0);
        const double length = std::sqrt(v[3] * v[3] + v[4] * v[4] + v[5] * v[5] + v[6] * v[6]);
        if (length == 0.0) return std::nullopt;
        if (!(length > 1e-6 && length < 1e6)) text->fail("must have a rotation that is not zero");
        for (int i = 0; i < 3; ++i) {
            if (!(std::fabs(v[static_cast<std::size_t>(i)]) <= 1e6)) text->fail("must be within 1000000 m");
        }
        return Rigid{{v[0], v[1], v[2]}, glm::dquat(v[3], v[4], v[5], v[6]) / length};
    }

    bool is_dynamic(std::size_t part) const { return model_.parts[part].kind == MjcfPart::Kind::moving; }

    void create(JointDef& def, const MjcfAttached& a, const Rigid& in_a, const MjcfAttached& b, const Rigid& in_b,
                const MjcfElement& element) {
        if (a.part == b.part || !(is_dynamic(a.part) || is_dynamic(b.part))) {
            model_.warnings.push_back(element.place() +
                                      ": has no effect: it joins no bodies that can move relative to each other");
            return;
        }
        const auto place = [&](const MjcfAttached& end, const Rigid& at, BodyId& body, Transform& frame) {
            const MjcfPart& part = model_.parts[end.part];
            body = part.id;
            frame = (part.id.is_null() ? part.body.world * at : at).transform();
        };
        place(a, in_a, def.body_a, def.frame_a);
        place(b, in_b, def.body_b, def.frame_b);
        try {
            scene_.world.create_joint(def);
        } catch (const Error& error) {
            throw Error(ErrorCode::invalid_file, element.place(), {}, error.what());
        }
    }

    // Couples a joint to another one, or locks it.
    void tie_joints(const MjcfElement& element, bool is_active) {
        const auto name = element.attribute("joint1"), other_name = element.attribute("joint2");
        if (!name) element.fail("must have the attribute joint1");
        const MjcfJoint* joint = model_.joint(*name);
        const MjcfJoint* other = other_name ? model_.joint(*other_name) : nullptr;
        const auto text = element.attribute("polycoef");
        std::vector<double> curve = text ? text->numbers(1, 5) : std::vector<double>{0.0, 1.0};
        curve.resize(5, 0.0);
        const auto without = [&](const char* why) {
            model_.warnings.push_back(element.place() + ": has no effect: " + why);
        };
        if (joint == nullptr || joint->id.is_null() || !joint->is_scalar()) {
            return without("its first joint is not a single hinge or slide");
        }
        const auto hold_it = [&] { // locks it by its limits, which cannot be disabled
            if (is_active) hold(*joint, joint->reference + curve[0]);
        };
        if (!other_name) return hold_it();
        if (other == nullptr || other->id.is_null()) return without("its second joint is not a single hinge");
        if (curve[2] != 0.0 || curve[3] != 0.0 || curve[4] != 0.0) return without("it is not linear");
        const double ratio = curve[1];
        if (ratio == 0.0) return hold_it();
        if (joint->kind != MjcfJoint::Kind::hinge || other->kind != MjcfJoint::Kind::hinge) {
            return without("gears hold between two hinges only");
        }
        const MjcfPart& part = model_.parts[joint->part];
        const MjcfPart& other_part = model_.parts[other->part];
        const bool stand = !is_dynamic(part.parent) && !is_dynamic(other_part.parent);
        const glm::dvec3 axis = part.frame.rotation * joint->axis, other_axis = other_part.frame.rotation * other->axis;
        const bool drops_out = part.parent == other_part.parent && glm::dot(axis, other_axis) * ratio > 0.9999 &&
                               std::fabs(std::fabs(ratio) - 1.0) < 1e-6;
        if (!stand && !drops_out) {
            return without("the bodies that carry the two joints can turn, and gears hold only between axles at rest");
        }
        JointDef def;
        def.name = element.name();
        def.body_a = other_part.id;
        def.body_b = part.id;
        def.frame_a.rotation = Quat(turn_from_x(other->axis));
        def.frame_b.rotation = Quat(turn_from_x(joint->axis));
        def.joint = GearJoint{static_cast<float>(-1.0 / ratio)};
        def.enable_collision = true;
        def.enabled = is_active;
        scene_.world.create_joint(def);
    }

    void hold(const MjcfJoint& joint, double at) {
        Joint made = scene_.world.joint_def(joint.id).joint;
        const JointRange range{static_cast<float>(at), static_cast<float>(at), std::nullopt};
        if (auto* hinge = std::get_if<HingeJoint>(&made)) hinge->angle.limits = range;
        if (auto* slider = std::get_if<SliderJoint>(&made)) slider->translation.limits = range;
        scene_.world.set_joint(joint.id, made);
    }

    MjcfModel& model_;
    Scene& scene_;
    std::set<std::pair<std::size_t, std::size_t>> excluded_;
};

} // namespace

// Each combination of contype, conaffinity and contact pair becomes a layer; it collides with the layers that match it.
void set_mjcf_filters(const XmlElement& root, MjcfModel& model, Scene& scene) {
    std::map<std::string, MjcfGeom*> by_name;
    for (MjcfPart& part : model.parts) {
        for (MjcfGeom& geom : part.geoms) by_name[geom.name] = &geom;
    }
    std::map<const MjcfGeom*, std::size_t> in_pairs; // geoms in contact pairs, and their number
    std::set<std::pair<std::size_t, std::size_t>> pairs;
    std::vector<std::string> pair_places;
    for (const XmlElement& section : root.children("contact")) {
        for (const XmlElement& child : section.children("pair")) {
            const XmlText first = child.require("geom1"), second = child.require("geom2");
            const auto a = by_name.find(first.text), b = by_name.find(second.text);
            if (a == by_name.end() || b == by_name.end()) {
                if (model.is_whole) (a == by_name.end() ? first : second).fail("must be the name of a geom");
                continue;
            }
            if (!a->second->shape || !b->second->shape) {
                model.warnings.push_back(child.place() + ": has no effect: one of its geoms is only visual");
                continue;
            }
            const auto number = [&](const MjcfGeom* geom) {
                return in_pairs.insert({geom, in_pairs.size() + 1}).first->second;
            };
            const std::size_t i = number(a->second), j = number(b->second);
            pairs.insert(std::minmax(i, j));
        }
    }
    using Key = std::tuple<unsigned, unsigned, std::size_t>;
    std::map<Key, std::size_t> layers;
    std::vector<Key> keys;
    bool has_pairs = true;
    const auto key_of = [&](const MjcfGeom& geom) {
        const auto found = in_pairs.find(&geom);
        return Key{geom.contype, geom.conaffinity, has_pairs && found != in_pairs.end() ? found->second : 0};
    };
    for (int attempt = 0; attempt < 2; ++attempt) {
        layers.clear(), keys.clear();
        for (const MjcfPart& part : model.parts) {
            for (const MjcfGeom& geom : part.geoms) {
                if (geom.shape && layers.insert({key_of(geom), keys.size()}).second) keys.push_back(key_of(geom));
            }
        }
        if (keys.size() <= max_kinds) break;
        if (attempt == 1) root.fail("must have at most 63 different pairs of contype and conaffinity");
        model.warnings.push_back(root.place() + ": contact pairs have no effect: there are too many");
        has_pairs = false;
    }
    // Without filters all geoms collide.
    if (keys.size() <= 1 && (keys.empty() || (std::get<0>(keys[0]) & std::get<1>(keys[0])) != 0)) return;
    const auto meet = [&](const Key& a, const Key& b) {
        const auto [type_a, affinity_a, pair_a] = a;
        const auto [type_b, affinity_b, pair_b] = b;
        return (type_a & affinity_b) != 0 || (type_b & affinity_a) != 0 ||
               (pair_a != 0 && pair_b != 0 && pairs.count(std::minmax(pair_a, pair_b)) != 0);
    };
    const std::vector<CollisionFilter> filters = filters_of_kinds(keys, meet);
    for (const auto& [type, affinity, pair] : keys) {
        scene.collision_systems.push_back("contype " + std::to_string(type) + " conaffinity " +
                                          std::to_string(affinity) +
                                          (pair == 0 ? "" : " pair " + std::to_string(pair)));
    }
    for (MjcfPart& part : model.parts) {
        for (MjcfGeom& geom : part.geoms) {
            if (geom.shape) geom.shape->filter = filters[layers.at(key_of(geom))];
        }
    }
}

void add_mjcf_constraints(const XmlElement& root, MjcfModel& model, Scene& scene) {
    ConstraintMaker maker(model, scene);
    for (const XmlElement& section : root.children("equality")) {
        for (const char* tag : {"connect", "weld", "joint"}) section.mark_read(tag);
        for (const XmlElement& child : section.children()) {
            const std::string_view tag = child.tag();
            const bool is_known = tag == "connect" || tag == "weld" || tag == "joint";
            if (is_known && model.settings.equalities) maker.equality(child);
        }
    }
    for (const XmlElement& section : root.children("contact")) {
        for (const XmlElement& child : section.children("exclude")) maker.exclude(child);
    }
}

} // namespace cairn::scene
