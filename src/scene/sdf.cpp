// Builds a world from an SDF file.
#include "scene/sdf.h"

#include "scene/gltf_file.h"
#include "scene/layers.h"
#include "scene/loaded_world.h"
#include "scene/nearby_files.h"
#include "scene/sdf_model.h"

#include <algorithm>
#include <numeric>
#include <set>

namespace cairn::scene {

namespace {

constexpr std::size_t max_models = 100000, max_links = 100000;
constexpr int max_nesting = 32;

class SdfReader {
  public:
    SdfReader(const std::optional<std::filesystem::path>& folder, const LoadOptions& options)
        : root_(folder ? std::optional(folder_on_disk(*folder)) : std::nullopt), options_(options), meshes_(root_) {
        model_.decomposes = options.decompose;
        model_.scopes.push_back({});
        model_.frames.push_back({});
    }

    Scene read(std::span<const std::byte> bytes, const std::string& name) {
        files_.push_back(std::make_unique<XmlFile>(bytes, name, "an SDF file"));
        const XmlElement root = files_[0]->root();
        const bool is_old = has_old_axes(root);
        Scene scene{loaded_world({}, options_), {}, {}, {}, {}};
        const std::vector<XmlElement> worlds = root.children("world");
        if (worlds.size() > 1) worlds[1].fail("must be the only world of the file");
        if (worlds.empty()) root.mark_read("model");
        const XmlElement& owner = worlds.empty() ? root : worlds[0];
        scene.info.title = owner.text_of("name");
        if (!worlds.empty()) read_world(worlds[0], scene);
        read_members(owner, 0, is_old, 0);
        if (worlds.empty() && model_.scopes.size() == 1) root.fail("must have a world or a model");
        if (scene.info.title.empty()) scene.info.title = std::filesystem::path(name).stem().generic_string();
        if (scene.info.title == "default" || worlds.empty()) scene.info.title = title_of_models(scene.info.title);
        for (const auto& [element, link] : link_elements_) read_sdf_link(element, link, root_, meshes_, model_);
        set_filters(scene);
        add_bodies(scene);
        scene.warnings = std::move(model_.warnings);
        std::set<std::string> lines; // a file may be included several times
        for (const auto& file : files_) {
            const auto line = file->unused();
            if (line && lines.insert(*line).second) scene.warnings.push_back(*line);
        }
        limit_warnings(scene.warnings);
        return scene;
    }

  private:
    static bool has_old_axes(const XmlElement& root) {
        const auto version = root.attribute("version");
        return version &&
               (version->text == "1.0" || version->text == "1.2" || version->text == "1.3" || version->text == "1.4");
    }

    std::string title_of_models(const std::string& otherwise) const {
        return model_.scopes.size() == 2
                   ? std::string(model_.scopes[1].prefix.substr(0, model_.scopes[1].prefix.size() - 2))
                   : otherwise;
    }

    static void read_world(const XmlElement& world, Scene& scene) {
        glm::dvec3 gravity(0.0, 0.0, -9.8);
        if (const auto text = world.child_text("gravity")) {
            gravity = text->vector3();
            for (int i = 0; i < 3; ++i) {
                if (!(gravity[i] >= -1e6 && gravity[i] <= 1e6)) text->fail("must be within 1000000 m/s2");
            }
        }
        WorldDef settings = scene.world.settings();
        settings.gravity = Vec3(upright.rotation * gravity);
        scene.world.set_settings(settings);
        if (const auto physics = world.child("physics")) {
            if (const auto step = physics->child_text("max_step_size")) {
                scene.info.time_step = static_cast<float>(step->number(0.0001, 1.0));
            }
        }
    }

    void add_frame(std::size_t scope, const XmlElement& element, SdfFrame frame) {
        const XmlText name = element.require("name");
        if (name.text.empty() || name.text.find("::") != std::string::npos) name.fail("must be a name without ::");
        const SdfPose pose = read_sdf_pose(element);
        frame.scope = scope;
        frame.pose = pose.pose;
        frame.relative_to = pose.relative_to;
        frame.place = element.place();
        if (!model_.scopes[scope].frames.insert({name.text, model_.frames.size()}).second) {
            element.fail("must not have the name of another link, joint, frame or model");
        }
        model_.frames.push_back(std::move(frame));
    }

    // Reads the models, links, joints and frames of a world or a model.
    void read_members(const XmlElement& owner, std::size_t scope, bool is_old, int depth) {
        if (depth > max_nesting) owner.fail("must be at most 32 models inside each other");
        const std::size_t base = model_.scopes[scope].frame;
        for (const XmlElement& link : scope == 0 ? std::vector<XmlElement>() : owner.children("link")) {
            if (model_.links.size() >= max_links) link.fail("must be one of at most 100000 links");
            SdfFrame frame;
            frame.base = base;
            frame.link = model_.links.size();
            SdfLink made;
            made.name = model_.scopes[scope].prefix + link.require("name").text;
            made.frame = model_.frames.size();
            made.scope = scope;
            made.place = link.place();
            made.is_static = model_.scopes[scope].is_static;
            add_frame(scope, link, std::move(frame));
            if (model_.scopes[scope].canonical == sdf_none) model_.scopes[scope].canonical = model_.links.size();
            link_elements_.push_back({link, model_.links.size()});
            model_.links.push_back(std::move(made));
        }
        for (const XmlElement& model : owner.children("model")) add_model(model, scope, is_old, depth, nullptr);
        for (const XmlElement& include : owner.children("include")) add_include(include, scope, depth);
        for (const XmlElement& frame_element : owner.children("frame")) {
            SdfFrame frame;
            frame.base = base;
            if (const auto name = frame_element.attribute("attached_to"); name && !name->text.empty()) {
                frame.attached_to = *name;
            }
            add_frame(scope, frame_element, std::move(frame));
        }
        for (const XmlElement& joint : owner.children("joint")) {
            SdfFrame frame;
            const auto child = joint.child_text("child");
            if (!child) joint.fail("must have the element child");
            frame.attached_to = *child;
            model_.joints.push_back({joint, model_.frames.size(), scope});
            add_frame(scope, joint, std::move(frame));
        }
        if (const auto name = scope == 0 ? std::nullopt : owner.attribute("canonical_link");
            name && !name->text.empty()) {
            model_.scopes[scope].canonical = model_.link_of(model_.find(scope, *name));
        }
    }

    // `include` is the element that included the model from another file; its values override the model's own.
    void add_model(const XmlElement& element, std::size_t parent, bool is_old, int depth, const XmlElement* include,
                   const std::string& folder = "") {
        if (model_.scopes.size() > max_models) element.fail("must be one of at most 100000 models");
        const auto given = include ? include->child_text("name") : std::nullopt;
        const std::string name = given && !given->text.empty() ? given->text : element.require("name").text;
        SdfScope scope;
        scope.parent = parent;
        scope.prefix = model_.scopes[parent].prefix + name + "::";
        scope.folder = include ? folder : model_.scopes[parent].folder;
        scope.frame = model_.frames.size();
        scope.has_old_axes = is_old;
        scope.is_static = model_.scopes[parent].is_static;
        const auto flag = [&](const char* tag, bool& value) {
            if (const auto text = element.child_text(tag)) value = text->boolean();
            const auto over = include ? include->child_text(tag) : std::nullopt;
            if (over) value = over->boolean();
        };
        bool is_static = false;
        flag("static", is_static);
        scope.is_static = scope.is_static || is_static;
        flag("self_collide", scope.collides_itself);
        const std::size_t index = model_.scopes.size();
        SdfFrame frame;
        const SdfPose own = read_sdf_pose(element);
        const SdfPose over = include && include->child("pose") ? read_sdf_pose(*include) : own;
        frame.scope = parent;
        frame.base = model_.scopes[parent].frame;
        frame.pose = over.pose;
        frame.relative_to = over.relative_to;
        frame.model = index;
        frame.place = element.place();
        const auto placed = include ? include->child_text("placement_frame") : element.attribute("placement_frame");
        if (placed && !placed->text.empty()) frame.placement_frame = *placed;
        if (!model_.scopes[parent].frames.insert({name, model_.frames.size()}).second) {
            (include ? *include : element).fail("must not have the name of another link, joint, frame or model");
        }
        model_.scopes[parent].models.insert({name, index});
        model_.frames.push_back(std::move(frame));
        model_.scopes.push_back(std::move(scope));
        read_members(element, index, is_old, depth + 1);
        if (model_.scopes[index].canonical == sdf_none) {
            for (const auto& [inner_name, inner] : model_.scopes[index].models) {
                if (model_.scopes[index].canonical == sdf_none) {
                    model_.scopes[index].canonical = model_.scopes[inner].canonical;
                }
            }
        }
        if (model_.scopes[parent].canonical == sdf_none && parent != 0) {
            model_.scopes[parent].canonical = model_.scopes[index].canonical;
        }
    }

    void add_include(const XmlElement& include, std::size_t scope, int depth) {
        const auto uri = include.child_text("uri");
        if (!uri) include.fail("must have the element uri");
        if (!root_) uri->fail("must not be there, as a model from memory cannot read other files");
        const auto left_out = [&](const std::string& why) {
            model_.warnings.push_back(uri->place + ": " + why + ", got \"" + printable(uri->text, 200) +
                                      "\" (the model is left out)");
        };
        const std::string path = sdf_path(uri->text, model_.scopes[scope].folder, *root_);
        if (path.empty()) return left_out("must name a model on this disk");
        std::string file = path;
        std::error_code code;
        const bool is_inside = nearby_file(path, *root_, *root_).verdict != NearbyFile::Verdict::outside;
        if (!is_inside) return left_out("must name a model in the file's folder or below it, also where links lead");
        if (std::filesystem::is_directory(*root_ / path, code)) file = path + "/" + file_in(path);
        const NearbyFile found = nearby_file(file, *root_, *root_);
        if (found.verdict == NearbyFile::Verdict::outside) return left_out("must not lead out of the file's folder");
        if (found.verdict != NearbyFile::Verdict::found) return left_out("there is no such model in the file's folder");
        if (std::count(open_.begin(), open_.end(), found.path) > 0) uri->fail("must not include itself");
        const std::vector<std::byte> bytes = read_file(found.path);
        bytes_ += bytes.size();
        if (bytes_ > max_bytes) uri->fail("must not raise the size of all included files above 64 MiB");
        const std::string name = found.path.lexically_relative(*root_).generic_string();
        if (root_tag(bytes) != "sdf") return left_out("must be an SDF file");
        files_.push_back(std::make_unique<XmlFile>(bytes, name, "an SDF file"));
        const XmlElement root = files_.back()->root();
        const auto model = root.child("model");
        if (!model) return left_out("must be a file with a model");
        open_.push_back(found.path);
        std::string folder = std::filesystem::path(name).parent_path().generic_string();
        add_model(*model, scope, has_old_axes(root), depth + 1, &include, folder);
        open_.pop_back();
    }

    // Returns the name of the model file according to model.config in the folder of a model.
    std::string file_in(const std::string& folder) {
        const NearbyFile config = nearby_file(folder + "/model.config", *root_, *root_);
        if (config.verdict != NearbyFile::Verdict::found) return "model.sdf";
        try {
            XmlFile file(read_file(config.path), folder + "/model.config", "a description of a model");
            std::string result;
            for (const XmlElement& sdf : file.root().children("sdf")) result = sdf.text().text;
            return result.empty() ? "model.sdf" : result;
        } catch (const Error&) {
            return "model.sdf";
        }
    }

    // Links of a model do not collide with each other by default, if there are several.
    void set_filters(Scene& scene) {
        // A bitmask, and the model whose links do not collide with each other.
        using Kind = std::pair<unsigned, std::size_t>;
        std::map<std::size_t, std::size_t> links_of;
        const auto whole = [&](std::size_t scope) { // the outermost model that contains this one
            while (model_.scopes[scope].parent != 0) scope = model_.scopes[scope].parent;
            return scope;
        };
        for (const SdfLink& link : model_.links) links_of[whole(link.scope)] += !link.body.shapes.empty();
        std::map<Kind, std::size_t> known;
        std::vector<Kind> kinds;
        bool parts_models = true;
        const auto kind_of = [&](const SdfLink& link, std::size_t shape) {
            const std::size_t scope = whole(link.scope);
            const bool is_apart =
                parts_models && !link.is_static && links_of[scope] > 1 && !model_.scopes[link.scope].collides_itself;
            return Kind{link.bitmasks[shape], is_apart ? scope : 0};
        };
        for (int attempt = 0; attempt < 2; ++attempt) {
            known.clear(), kinds.clear();
            for (const SdfLink& link : model_.links) {
                for (std::size_t i = 0; i < link.bitmasks.size(); ++i) {
                    if (known.insert({kind_of(link, i), kinds.size()}).second) kinds.push_back(kind_of(link, i));
                }
            }
            if (kinds.size() <= max_kinds) break;
            if (attempt == 1) files_[0]->root().fail("must have at most 63 different bitmasks");
            model_.warnings.push_back("there are so many models that each collides with itself");
            parts_models = false;
        }
        if (kinds.size() == 1 && kinds[0] == Kind{0xFFFF, 0}) return;
        const auto filters = filters_of_kinds(kinds, [](const Kind& a, const Kind& b) {
            return (a.first & b.first) != 0 && (a.second == 0 || a.second != b.second);
        });
        for (const auto& [bits, scope] : kinds) {
            scene.collision_systems.push_back("bits " + std::to_string(bits) +
                                              (scope == 0 ? "" : " of " + model_.scopes[scope].prefix));
        }
        for (SdfLink& link : model_.links) {
            for (std::size_t i = 0; i < link.bitmasks.size(); ++i) {
                link.body.shapes[i].filter = filters[known.at(kind_of(link, i))];
            }
        }
    }

    // Returns for each link the first link of its body: fixed joints connect links to one body.
    std::vector<std::size_t> groups() const {
        std::vector<std::size_t> first(model_.links.size());
        std::iota(first.begin(), first.end(), std::size_t{0});
        const auto top = [&](std::size_t link) {
            while (first[link] != link) link = first[link];
            return link;
        };
        for (const SdfJoint& joint : model_.joints) {
            if (joint.element.text_of("type") != "fixed") continue;
            const auto end = [&](const char* which) {
                const auto name = joint.element.child_text(which);
                if (!name) joint.element.fail(std::string("must have the element ") + which);
                return model_.link_of(model_.find(joint.scope, *name));
            };
            const std::size_t a = end("parent"), b = end("child");
            if (a == sdf_none || b == sdf_none) continue;
            const std::size_t low = std::min(top(a), top(b)), high = std::max(top(a), top(b));
            first[high] = low;
        }
        for (std::size_t& link : first) link = top(link);
        return first;
    }

    // Returns the bodies that a fixed joint connects to the world; with a fixed base, also the first body of every
    // model.
    std::set<std::size_t> held(const std::vector<std::size_t>& group) const {
        std::set<std::size_t> result;
        for (const SdfJoint& joint : model_.joints) {
            if (joint.element.text_of("type") != "fixed") continue;
            const auto parent = joint.element.child_text("parent"), child = joint.element.child_text("child");
            const std::size_t a = model_.link_of(model_.find(joint.scope, *parent)),
                              b = model_.link_of(model_.find(joint.scope, *child));
            if ((a == sdf_none) != (b == sdf_none)) result.insert(group[a == sdf_none ? b : a]);
        }
        for (std::size_t i = 0; i < model_.links.size(); ++i) {
            if (model_.links[i].is_static) result.insert(group[i]);
        }
        if (options_.fixed_base) {
            for (const SdfScope& scope : model_.scopes) {
                const bool is_outer = &scope != &model_.scopes[0] && scope.parent == 0;
                if (is_outer && scope.canonical != sdf_none) result.insert(group[scope.canonical]);
            }
        }
        return result;
    }

    void add_bodies(Scene& scene) {
        const std::vector<std::size_t> group = groups();
        const std::set<std::size_t> still = held(group);
        SdfBodies bodies;
        bodies.body_of_link.assign(model_.links.size(), sdf_none);
        std::vector<ModelBody> made;
        for (std::size_t i = 0; i < model_.links.size(); ++i) {
            SdfLink& link = model_.links[i];
            const Rigid world = upright * model_.world(link.frame);
            if (group[i] == i) {
                bodies.body_of_link[i] = made.size();
                ModelBody body = std::move(link.body);
                body.name = link.name;
                body.place = link.place;
                body.world = world;
                body.type = still.count(i) != 0 ? BodyType::static_
                            : link.is_kinematic ? BodyType::kinematic
                                                : BodyType::dynamic;
                made.push_back(std::move(body));
                continue;
            }
            const std::size_t into = bodies.body_of_link[i] = bodies.body_of_link[group[i]];
            merge(link.body, inverse(made[into].world) * world, made[into]);
        }
        for (ModelBody& body : made) {
            bodies.worlds.push_back(body.world);
            bodies.ids.push_back(add_model_body(body, scene));
        }
        add_sdf_joints(model_, bodies, model_.warnings, scene);
    }

    // Merges a part into a body. A part without visuals is shown by its shapes, which the visuals of the other part
    // would hide: then the whole body is shown by its shapes.
    static void merge(ModelBody& part, const Rigid& at, ModelBody& into) {
        for (ModelMass& mass : part.masses) mass.at = at * mass.at, into.masses.push_back(mass);
        const bool hides = (into.looks.empty() && !into.shapes.empty()) || (part.looks.empty() && !part.shapes.empty());
        for (ModelShape& shape : part.shapes) shape.at = at * shape.at, into.shapes.push_back(shape);
        for (ModelVisual& look : part.looks) look.at = at * look.at, into.looks.push_back(look);
        if (hides) into.looks.clear();
    }

    static constexpr std::size_t max_bytes = std::size_t{64} << 20;
    std::optional<std::filesystem::path> root_;
    LoadOptions options_;
    ModelMeshes meshes_;
    SdfModel model_;
    std::vector<std::unique_ptr<XmlFile>> files_;
    std::vector<std::pair<XmlElement, std::size_t>> link_elements_;
    std::vector<std::filesystem::path> open_; // files of the includes that are being read
    std::size_t bytes_ = 0;
};

} // namespace

Scene load_sdf(std::span<const std::byte> bytes, const std::string& name,
               const std::optional<std::filesystem::path>& folder, const LoadOptions& options) {
    return SdfReader(folder, options).read(bytes, name);
}

} // namespace cairn::scene
