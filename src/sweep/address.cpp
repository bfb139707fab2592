#include "sweep/address.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <utility>
#include <vector>

namespace cairn::sweep {

namespace {

// A part of a path between dots: a name, and an optional number in brackets.
struct Segment {
    std::string name;
    std::optional<std::size_t> number;
};

[[noreturn]] void refuse_path(const std::string& path, const std::string& why) {
    throw Error(ErrorCode::invalid_value, path, {}, why);
}

std::string some_of(const std::vector<std::string>& names) {
    std::string list;
    for (const std::string& name : names) {
        if (list.size() > 300) return list + ", ...";
        list += (list.empty() ? "" : ", ") + name;
    }
    return list.empty() ? "none" : list;
}

// Returns a name as it is written in a path.
std::string written_name(const std::string& name) {
    const bool is_plain =
        name.find_first_not_of("0123456789_abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ") == std::string::npos;
    return is_plain ? name : "'" + name + "'";
}

std::size_t number_in(const std::string& path, std::string_view text) {
    std::size_t number = 0;
    const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (text.empty() || error != std::errc() || stop != text.data() + text.size()) {
        refuse_path(path, "must have whole numbers in brackets");
    }
    return number;
}

std::vector<Segment> segments_of(const std::string& path) {
    std::vector<Segment> segments;
    std::size_t at = 0;
    for (bool more = true; more;) {
        Segment segment;
        if (at < path.size() && path[at] == '\'') {
            const std::size_t end = path.find('\'', at + 1);
            if (end == std::string::npos) refuse_path(path, "must have a closing '");
            segment.name = path.substr(at + 1, end - at - 1);
            at = end + 1;
        } else {
            const std::size_t end = std::min(path.find_first_of(".[", at), path.size());
            segment.name = path.substr(at, end - at);
            at = end;
        }
        if (at < path.size() && path[at] == '[') {
            const std::size_t end = path.find(']', at);
            if (end == std::string::npos) refuse_path(path, "must have a closing ]");
            segment.number = number_in(path, std::string_view(path).substr(at + 1, end - at - 1));
            at = end + 1;
        }
        if (segment.name.empty()) refuse_path(path, "must have a name before and after each dot");
        if (at < path.size() && path[at] != '.') refuse_path(path, "must have a dot between its names");
        more = at++ < path.size();
        segments.push_back(std::move(segment));
    }
    return segments;
}

class Finder {
  public:
    Finder(const World& world, const std::string& path) : world_(world), path_(path), segments_(segments_of(path)) {}

    Address find() {
        find_subject();
        const std::string name = next("the name of a property, such as " + some_of(property_names()));
        for (const std::span<const Property> list : lists_) {
            for (const Property& property : list) {
                if (property.name == name) address_.property = &property;
            }
        }
        if (address_.property == nullptr) {
            refuse_path(path_, "there is no property \"" + name + "\"; there are " + some_of(property_names()));
        }
        if (name == "touches") address_.subject.other = body_named(next_segment("the name of a body"));
        find_component();
        if (at_ < segments_.size()) {
            refuse_path(path_, "must end after \"" + segments_[at_ - 1].name + "\"");
        }
        return address_;
    }

  private:
    const Segment& next_segment(const std::string& what) {
        if (at_ >= segments_.size()) refuse_path(path_, "must continue with " + what);
        return segments_[at_++];
    }
    std::string next(const std::string& what) {
        const Segment& segment = next_segment(what);
        if (segment.number) refuse_path(path_, "must not have an index after \"" + segment.name + "\"");
        return segment.name;
    }

    void find_subject() {
        const Segment first = next_segment("a name");
        if (first.name == "world" && !first.number) {
            lists_ = {world_properties()};
            return;
        }
        const bool is_body = first.name == "bodies" && first.number;
        const bool is_joint = first.name == "joints" && first.number;
        if (is_joint || (!is_body && count(body_names(), first.name) == 0 && count(joint_names(), first.name) > 0)) {
            return find_joint(joint_named(first));
        }
        if (!is_body && count(joint_names(), first.name) > 0) {
            refuse_path(path_, "there are a body and a joint of that name: use bodies[N] or joints[N]");
        }
        address_.subject.body = body_named(first);
        lists_ = {body_properties(), shape_properties()};
        if (at_ < segments_.size() && segments_[at_].name == "shapes" && segments_[at_].number) {
            const std::vector<ShapeId> shapes = world_.body(address_.subject.body).shapes();
            address_.subject.shape = element(shapes, *segments_[at_++].number, "shapes");
            lists_ = {shape_properties()};
        }
    }

    void find_joint(JointId id) {
        address_.subject.joint = id;
        lists_ = {joint_properties()};
        if (at_ >= segments_.size()) return;
        if (const auto axis = axis_of(world_.joint_def(id).joint, segments_[at_].name)) {
            address_.subject.axis = *axis;
            ++at_;
        }
    }

    void find_component() {
        const std::string_view letters = address_.property->components;
        if (letters.empty()) return;
        std::vector<std::string> names;
        for (const char letter : letters) names.emplace_back(1, letter);
        const std::string letter = next("one of " + some_of(names));
        const std::size_t component = letter.size() == 1 ? letters.find(letter) : std::string_view::npos;
        if (component == std::string_view::npos) {
            refuse_path(path_, "has no \"" + letter + "\"; must end with one of " + some_of(names));
        }
        address_.component = component;
    }

    template <class Id> Id element(const std::vector<Id>& ids, std::size_t number, const char* what) const {
        if (number >= ids.size()) {
            refuse_path(path_, "there are " + std::to_string(ids.size()) + " " + what + ", numbered from 0");
        }
        return ids[number];
    }

    BodyId body_named(const Segment& segment) const {
        const std::vector<BodyId> ids = world_.bodies();
        if (segment.name == "bodies" && segment.number) return element(ids, *segment.number, "bodies");
        return ids[place_of(segment, body_names(), "body")];
    }
    JointId joint_named(const Segment& segment) const {
        const std::vector<JointId> ids = world_.joints();
        if (segment.name == "joints" && segment.number) return element(ids, *segment.number, "joints");
        return ids[place_of(segment, joint_names(), "joint")];
    }
    std::size_t place_of(const Segment& segment, const std::vector<std::string>& names, const char* what) const {
        if (segment.number) refuse_path(path_, "must not have an index after \"" + segment.name + "\"");
        if (const std::size_t times = count(names, segment.name); times > 1) {
            refuse_path(path_,
                        std::to_string(times) + " have the name \"" + segment.name + "\": use bodies[N] or joints[N]");
        }
        const auto found = std::find(names.begin(), names.end(), segment.name);
        if (found == names.end()) {
            std::vector<std::string> shown{"world"};
            for (const std::string& name : names) {
                if (!name.empty()) shown.push_back(written_name(name));
            }
            refuse_path(path_,
                        std::string("there is no ") + what + " \"" + segment.name + "\"; there are " + some_of(shown));
        }
        return static_cast<std::size_t>(found - names.begin());
    }
    static std::size_t count(const std::vector<std::string>& names, const std::string& name) {
        return static_cast<std::size_t>(std::count(names.begin(), names.end(), name));
    }
    std::vector<std::string> body_names() const {
        std::vector<std::string> names;
        for (const BodyId id : world_.bodies()) names.push_back(world_.body(id).name());
        return names;
    }
    std::vector<std::string> joint_names() const {
        std::vector<std::string> names;
        for (const JointId id : world_.joints()) names.push_back(world_.joint_def(id).name);
        return names;
    }
    std::vector<std::string> property_names() const {
        std::vector<std::string> names;
        for (const std::span<const Property> list : lists_) {
            for (const Property& property : list) names.emplace_back(property.name);
        }
        return names;
    }

    const World& world_;
    const std::string& path_;
    std::vector<Segment> segments_;
    std::size_t at_ = 0;
    std::vector<std::span<const Property>> lists_;
    Address address_;
};

} // namespace

Address find_address(const World& world, const std::string& path) { return Finder(world, path).find(); }

} // namespace cairn::sweep
