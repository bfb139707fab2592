// Converts links and joints to bodies and joints. Links that fixed joints connect are one body; parts are placed with
// all joints at 0, or as near to 0 as their limits allow.
#include "scene/urdf.h"

#include "scene/loaded_world.h"
#include "scene/mass_sum.h"
#include "scene/urdf_file.h"
#include "scene/urdf_joints.h"
#include "scene/urdf_overlaps.h"
#include "scene/urdf_shapes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace cairn::scene {

namespace {

// Mass, kg, of parts for which a file gives neither a mass nor shapes.
constexpr double blank_mass = 1.0;
// Inertia per mass, m2, below which an inertia counts as zero: that of a body of about a thousandth of a millimeter.
constexpr double negligible = 1e-12;

class RobotBuilder {
  public:
    RobotBuilder(const urdf::ModelInterface& model, std::string name,
                 const std::optional<std::filesystem::path>& folder, const LoadOptions& options)
        : model_(model), name_(std::move(name)), options_(options), scene_{loaded_world({}, options), {}, {}, {}, {}},
          shapes_(name_, folder, options.decompose, scene_) {}

    Scene build() {
        scene_.info.title = model_.getName();
        walk();
        for (RobotPart& part : parts_) add_body(part);
        disable_overlapping_collisions(name_, parts_, scene_);
        RobotJoints(name_, parts_, scene_).add();
        return std::move(scene_);
    }

  private:
    std::string place(const urdf::Link& link) const { return name_ + ": link \"" + link.name + "\""; }

    // Collects the parts, from the root down.
    void walk() {
        struct Open {
            urdf::LinkConstSharedPtr link;
            std::size_t part;
            Rigid in_part;
        };
        const urdf::LinkConstSharedPtr root = model_.getRoot();
        parts_.push_back({});
        parts_[0].world = upright;
        parts_[0].is_world = options_.fixed_base || root->name == "world";
        std::vector<Open> open{{root, 0, {}}};
        const RobotPose pose(model_, name_);
        while (!open.empty()) {
            const Open here = open.back();
            open.pop_back();
            parts_[here.part].links.push_back({here.link, here.in_part});
            // The last joint is pushed first, so that the first one is visited next.
            for (std::size_t i = here.link->child_joints.size(); i-- > 0;) {
                const urdf::JointSharedPtr joint = here.link->child_joints[i];
                const std::string at = name_ + ": joint \"" + joint->name + "\"";
                const Rigid frame = here.in_part * rigid(joint->parent_to_joint_origin_transform, at);
                const urdf::LinkConstSharedPtr child = model_.getLink(joint->child_link_name);
                const bool frees_the_base =
                    joint->type == urdf::Joint::FLOATING && here.part == 0 && root->name == "world";
                if (joint->type == urdf::Joint::FIXED || (frees_the_base && options_.fixed_base)) {
                    open.push_back({child, here.part, frame});
                    continue;
                }
                RobotPart part;
                part.joint = joint;
                part.parent = here.part;
                part.frame = frame;
                part.world = parts_[here.part].world * frame * pose.motion(*joint);
                open.push_back({child, parts_.size(), {}});
                parts_.push_back(std::move(part));
            }
        }
    }

    void add_body(RobotPart& part) {
        bool has_shapes = false;
        for (const auto& [link, at] : part.links) has_shapes = has_shapes || !link->collision_array.empty();
        if (!part.is_world || has_shapes) {
            BodyDef def;
            def.type = part.is_world ? BodyType::static_ : BodyType::dynamic;
            def.position = part.world.position;
            def.rotation = Quat(part.world.rotation);
            def.name = part.links.front().link->name;
            if (!part.is_world) def.mass_properties = mass(part, has_shapes);
            part.body = scene_.world.create_body(def);
        }
        const std::size_t first = scene_.visuals.size();
        bool all_shown = true;
        // A part without an inertial needs all of its shapes, as they determine its mass.
        const bool may_lack_shapes = part.is_world || (!part.body.is_null() && has_inertial(part));
        for (const auto& [link, at] : part.links) {
            if (!part.body.is_null()) shapes_.add_shapes(*link, part.body, at, may_lack_shapes);
            if (!part.body.is_null() && link->name == "world" && part.is_world)
                part.scenery = scene_.world.body(part.body).shapes().size();
            const Rigid seen = part.body.is_null() ? part.world * at : at;
            all_shown = shapes_.add_visuals(*link, part.body, seen) && all_shown;
        }
        // An incomplete set of visuals would hide the rest of the body; its shapes show all of it.
        const bool is_left = !part.body.is_null() && !scene_.world.body(part.body).shapes().empty();
        if (!all_shown && is_left) scene_.visuals.resize(first);
    }

    static bool has_inertial(const RobotPart& part) {
        return std::any_of(part.links.begin(), part.links.end(), [](const RobotPart::Member& member) {
            return member.link->inertial && member.link->inertial->mass > 0.0;
        });
    }

    // Returns the mass properties; nothing if they follow from the shapes.
    std::optional<MassProperties> mass(const RobotPart& part, bool has_shapes) {
        MassSum sum;
        for (const auto& [link, at] : part.links) {
            if (link->inertial) add_mass(*link, at, sum);
        }
        const std::string where = place(*part.links.front().link);
        // The inertia is checked for the whole body, because links that only define a frame may have any inertia, or
        // none.
        if (sum.mass() > 0.0) {
            const std::string whole = where + (part.links.size() > 1 ? " and what is fixed to it" : ": inertial");
            if (sum.inertia_size() <= negligible * sum.mass()) {
                scene_.warnings.push_back(whole +
                                          " has an inertia of 0; the inertia of a ball of 0.1 m radius is used");
                sum.add_inertia(fallback_inertia(sum.mass()));
            }
            return sum.real_properties(whole, scene_.warnings);
        }
        if (has_shapes) {
            scene_.warnings.push_back(where +
                                      " has no inertial; its mass is computed from its collision shapes at 1000 kg/m3");
            return std::nullopt;
        }
        scene_.warnings.push_back(
            where + " has neither inertial nor collision; it is treated as a ball of 1 kg and 0.1 m radius");
        sum.add(blank_mass, fallback_inertia(blank_mass), {});
        return sum.properties();
    }

    void add_mass(const urdf::Link& link, const Rigid& at, MassSum& sum) {
        const urdf::Inertial& inertial = *link.inertial;
        const std::string where = place(link) + ": inertial";
        const double m = inertial.mass;
        if (!(m >= 0.0 && m <= 1e12)) {
            throw Error(ErrorCode::invalid_file, where + ": mass", std::to_string(m), "must be >= 0, and finite");
        }
        glm::dmat3 inertia(inertial.ixx, inertial.ixy, inertial.ixz, inertial.ixy, inertial.iyy, inertial.iyz,
                           inertial.ixz, inertial.iyz, inertial.izz);
        double size = 0.0;
        for (int i = 0; i < 9; ++i) size += std::fabs(inertia[i / 3][i % 3]);
        if (!(size <= 1e18)) throw Error(ErrorCode::invalid_file, where + ": inertia", {}, "must be finite");
        if (m == 0.0) return; // equivalent to no inertial
        sum.add(m, inertia, at * rigid(inertial.origin, where));
    }

    const urdf::ModelInterface& model_;
    std::string name_;
    LoadOptions options_;
    Scene scene_;
    RobotShapes shapes_;
    std::vector<RobotPart> parts_;
};

} // namespace

Scene load_urdf(std::span<const std::byte> bytes, const std::string& name,
                const std::optional<std::filesystem::path>& folder, const LoadOptions& options) {
    const urdf::ModelInterfaceSharedPtr model = parse_urdf(bytes, name);
    return RobotBuilder(*model, name, folder, options).build();
}

} // namespace cairn::scene
