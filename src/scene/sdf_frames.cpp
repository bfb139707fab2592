// Frames of SDF files: reference frames and poses.
#include "scene/sdf_model.h"

#include <cairn/error.h>

#include <algorithm>
#include <cmath>
#include <system_error>

namespace cairn::scene {

namespace {

constexpr int deepest = 200; // maximum length of a chain of frames that refer to each other

[[noreturn]] void refuse_circle(const SdfFrame& frame) {
    throw Error(ErrorCode::invalid_file, frame.place, {},
                "must not refer to itself through other frames, or through more than 200");
}

} // namespace

std::size_t SdfModel::find(std::size_t scope, const XmlText& name) const {
    std::string rest = name.text;
    if (rest == "world" || rest == "__root__") return 0;
    for (;;) {
        const SdfScope& here = scopes[scope];
        if (rest == "__model__") return here.frame;
        const auto found = here.frames.find(rest);
        if (found != here.frames.end()) return found->second;
        const std::size_t colons = rest.find("::");
        const auto inner = colons == std::string::npos ? here.models.end() : here.models.find(rest.substr(0, colons));
        if (inner == here.models.end()) name.fail("must be the name of a link, joint, frame or model");
        scope = inner->second;
        rest = rest.substr(colons + 2);
    }
}

std::size_t SdfModel::base_of(const SdfFrame& frame) const {
    if (frame.relative_to) return find(frame.scope, *frame.relative_to);
    if (frame.attached_to) return find(frame.scope, *frame.attached_to);
    return frame.base;
}

Rigid SdfModel::in_model(std::size_t index, std::size_t model, int depth) const {
    if (index == model) return {};
    const SdfFrame& frame = frames[index];
    const std::size_t base = base_of(frame);
    if (depth > deepest) refuse_circle(frame);
    if (base == sdf_none) {
        throw Error(ErrorCode::invalid_file, frame.place, {}, "must be in the model whose placement frame it is");
    }
    return in_model(base, model, depth + 1) * frame.pose;
}

Rigid SdfModel::world(std::size_t index, int depth) const {
    const SdfFrame& frame = frames[index];
    const std::size_t base = base_of(frame);
    if (base == sdf_none) return frame.pose;
    if (depth > deepest) refuse_circle(frame);
    const Rigid there = world(base, depth + 1) * frame.pose;
    if (!frame.placement_frame) return there;
    return there * inverse(in_model(find(frame.model, *frame.placement_frame), index, 0));
}

std::size_t SdfModel::link_of(std::size_t index, int depth) const {
    const SdfFrame& frame = frames[index];
    if (depth > deepest) refuse_circle(frame);
    if (frame.link != sdf_none) return frame.link;
    if (frame.attached_to) return link_of(find(frame.scope, *frame.attached_to), depth + 1);
    if (frame.model != sdf_none) return scopes[frame.model].canonical;
    return frame.base == sdf_none ? sdf_none : link_of(frame.base, depth + 1);
}

SdfPose read_sdf_pose(const XmlElement& owner) {
    const auto element = owner.child("pose");
    if (!element) return {};
    SdfPose result;
    if (const auto name = element->attribute("relative_to"); name && !name->text.empty()) result.relative_to = *name;
    XmlText text = element->text();
    text.place = owner.place() + ": pose";
    if (text.text.empty()) return result;
    const auto format = element->attribute("rotation_format");
    const bool is_quaternion = format && format->choice({"euler_rpy", "quat_xyzw"}) == 1;
    const std::vector<double> v = is_quaternion ? text.numbers(7, 7) : text.numbers(6, 6);
    for (int i = 0; i < 3; ++i) {
        result.pose.position[i] = v[static_cast<std::size_t>(i)];
        if (!(std::fabs(result.pose.position[i]) <= 1e6)) text.fail("must be within 1000000 m");
    }
    if (is_quaternion) {
        const double length = std::sqrt(v[3] * v[3] + v[4] * v[4] + v[5] * v[5] + v[6] * v[6]);
        if (!(length > 1e-6 && length < 1e6)) text.fail("must have a rotation that is not zero");
        result.pose.rotation = glm::dquat(v[6], v[3], v[4], v[5]) / length;
        return result;
    }
    const auto degrees = element->attribute("degrees");
    const double unit = degrees && degrees->boolean() ? degree : 1.0;
    for (std::size_t i = 3; i < 6; ++i) {
        if (!(std::fabs(v[i]) <= 1e6)) text.fail("must have angles within 1000000");
    }
    result.pose.rotation = glm::normalize(turn_about({0, 0, 1}, v[5] * unit) * turn_about({0, 1, 0}, v[4] * unit) *
                                          turn_about({1, 0, 0}, v[3] * unit));
    return result;
}

std::string sdf_path(const std::string& uri, const std::string& folder, const std::filesystem::path& root) {
    const std::size_t colon = uri.find("://");
    const auto in = [](const std::string& a, const std::string& b) { return a.empty() ? b : a + "/" + b; };
    if (colon == std::string::npos) return in(folder, uri);
    const std::string scheme = uri.substr(0, colon), rest = uri.substr(colon + 3);
    if (scheme == "file") return in(folder, rest);
    if (scheme != "model" && scheme != "package") return {};
    const std::size_t slash = std::min(rest.find('/'), rest.size());
    const std::string name = rest.substr(0, slash), inner = rest.substr(std::min(slash + 1, rest.size()));
    if (name.empty() || name == "." || name == "..") return {};
    std::error_code code;
    // The folder of the file itself, or one of that name beside it, or one in the folder `models`.
    if (std::filesystem::path(folder).filename() == name) return inner.empty() ? folder : in(folder, inner);
    if (folder.empty() && root.filename() == name) return inner.empty() ? "." : inner;
    for (const std::string& place : {name, "models/" + name}) {
        if (std::filesystem::is_directory(root / place, code)) return inner.empty() ? place : place + "/" + inner;
    }
    return inner.empty() ? name : name + "/" + inner;
}

} // namespace cairn::scene
