#include "scene/usd_stage.h"

#include "scene/xml_file.h"

#include <cairn/error.h>

#include <algorithm>
#include <cmath>

namespace cairn::scene {

namespace {

constexpr double farthest_prim = 1e9; // maximum size of a number in a transform

Affine of_rotation(const glm::dquat& rotation) { return {glm::mat3_cast(rotation), glm::dvec3(0.0)}; }

Affine inverse_of(const Affine& map) {
    const glm::dmat3 back = glm::inverse(map.linear);
    return {back, -(back * map.translation)};
}

} // namespace

Affine inverse_of(const Rigid& frame) {
    const Rigid back = inverse(frame);
    return {glm::mat3_cast(back.rotation), back.position};
}

UsdStage::UsdStage(const UsdLayer& layer, std::string name) : layer_(layer), name_(std::move(name)) {
    const auto said = [&](const char* key) {
        const auto found = layer.metadata.find(key);
        return found == layer.metadata.end() ? nullptr : &found->second;
    };
    if (const UsdValue* meters = said("metersPerUnit")) {
        meters_ = meters->numbers.empty() ? 0.0 : meters->numbers[0];
        if (!(meters_ >= 1e-6 && meters_ <= 1e6)) {
            throw Error(ErrorCode::invalid_file, name_ + ":" + std::to_string(meters->line) + ": metersPerUnit",
                        std::to_string(meters_), "must be from 0.000001 to 1000000");
        }
    }
    const UsdValue* up = said("upAxis");
    const bool is_z_up = up != nullptr && !up->words.empty() && up->words[0] == "Z";
    root_.linear = glm::mat3_cast(is_z_up ? upright.rotation : glm::dquat(1.0, 0.0, 0.0, 0.0)) * meters_;
    UsdPlace above;
    above.world = root_;
    for (const UsdPrim& prim : layer.prims) visit(prim, above, root_);
}

void UsdStage::visit(const UsdPrim& prim, const UsdPlace& above, const Affine& world) {
    if (!prim.is_active || prim.kind != "def") return;
    UsdPlace here = above;
    bool resets = false;
    const Affine own = transform(prim, resets);
    here.prim = &prim;
    here.above = resets ? root_ : world;
    here.world = compose(here.above, own);
    for (int i = 0; i < 3; ++i) {
        const double reach = std::fabs(here.world.translation[i]) + std::fabs(here.world.linear[i][0]) +
                             std::fabs(here.world.linear[i][1]) + std::fabs(here.world.linear[i][2]);
        if (!(reach <= farthest_prim)) fail(prim, "xformOpOrder", "must not be too far from the origin or too large");
    }
    here.chain.push_back(&prim);
    here.is_seen = here.is_seen && word(prim, "visibility", "inherited") != "invisible" &&
                   word(prim, "purpose", "default") != "guide";
    if (has(prim, "PhysicsRigidBodyAPI") && flag(prim, "physics:rigidBodyEnabled", true)) here.body = &prim;
    if (prim.type.substr(0, 7) == "Physics" && prim.type != "PhysicsScene") here.is_seen = false;
    by_path_[prim.path] = places_.size();
    places_.push_back(here);
    for (const UsdPrim& child : prim.children) visit(child, here, here.world);
}

Affine UsdStage::transform(const UsdPrim& prim, bool& resets) const {
    Affine result;
    const UsdValue* order = value(prim, "xformOpOrder");
    if (order == nullptr) return result;
    for (const std::string& name : order->words) {
        if (name == "!resetXformStack!") {
            result = Affine();
            resets = true;
            continue;
        }
        constexpr std::string_view inverted = "!invert!";
        const bool is_inverted = name.substr(0, inverted.size()) == inverted;
        const Affine next = operation(prim, is_inverted ? name.substr(inverted.size()) : name);
        if (is_inverted && std::fabs(glm::determinant(next.linear)) < 1e-30) {
            fail(prim, "xformOpOrder", "must not invert a singular transform");
        }
        result = compose(result, is_inverted ? inverse_of(next) : next);
    }
    return result;
}

Affine UsdStage::operation(const UsdPrim& prim, const std::string& name) const {
    const UsdValue* found = value(prim, name);
    if (found == nullptr) return {}; // may have time samples only
    const std::vector<double>& v = found->numbers;
    for (const double each : v) {
        if (!(std::fabs(each) <= farthest_prim)) fail(prim, name, "must have numbers within 1e9");
    }
    const auto need = [&](std::size_t count) {
        if (v.size() != count) fail(prim, name, "must have " + std::to_string(count) + " numbers");
    };
    const std::string rest = name.substr(std::min<std::size_t>(name.size(), 8)); // after "xformOp:"
    const std::string kind = rest.substr(0, rest.find(':'));
    Affine result;
    if (kind == "translate") {
        need(3);
        result.translation = {v[0], v[1], v[2]};
    } else if (kind == "scale") {
        need(3);
        result = affine({v[0], v[1], v[2]});
    } else if (kind == "orient") {
        need(4);
        const double length = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2] + v[3] * v[3]);
        if (!(length > 1e-9)) fail(prim, name, "must be a rotation that is not zero");
        result = of_rotation(glm::dquat(v[0], v[1], v[2], v[3]) / length);
    } else if (kind == "transform") {
        need(16);
        result.linear = glm::dmat3({v[0], v[1], v[2]}, {v[4], v[5], v[6]}, {v[8], v[9], v[10]});
        result.translation = {v[12], v[13], v[14]};
    } else if (kind.substr(0, 6) == "rotate") {
        const std::string axes = kind.substr(6);
        need(axes.size() == 1 ? 1 : 3);
        glm::dquat turn(1.0, 0.0, 0.0, 0.0);
        for (const char letter : axes) { // the first axis is applied first
            if (letter < 'X' || letter > 'Z' || axes.size() > 3) fail(prim, name, "must be a known operation");
            glm::dvec3 axis(0.0);
            axis[letter - 'X'] = 1.0;
            turn = turn_about(axis, degree * v[axes.size() == 1 ? 0 : static_cast<std::size_t>(letter - 'X')]) * turn;
        }
        result = of_rotation(turn);
    } else {
        fail(prim, name, "must be a known operation");
    }
    return result;
}

const UsdPlace* UsdStage::find(const std::string& path) const {
    const auto found = by_path_.find(path);
    return found == by_path_.end() ? nullptr : &places_[found->second];
}

std::string UsdStage::place(const UsdPrim& prim) const {
    return name_ + ":" + std::to_string(prim.line) + ": " + (prim.type.empty() ? "" : printable(prim.type) + " ") +
           "<" + printable(prim.path, 200) + ">";
}

const UsdValue* UsdStage::value(const UsdPrim& prim, const std::string& name) const {
    asked_.insert(name);
    const auto found = prim.properties.find(name);
    return found == prim.properties.end() ? nullptr : &found->second;
}

void UsdStage::fail(const UsdPrim& prim, const std::string& property, const std::string& expected) const {
    std::string shown;
    if (const UsdValue* found = value(prim, property)) {
        for (const double number : found->numbers) {
            if (shown.size() < 80) shown += (shown.empty() ? "" : ", ") + std::to_string(number);
        }
    }
    throw Error(ErrorCode::invalid_file, place(prim) + ": " + printable(property), shown, expected);
}

double UsdStage::number(const UsdPrim& prim, const std::string& name, double otherwise) const {
    const UsdValue* found = value(prim, name);
    if (found == nullptr) return otherwise;
    if (found->numbers.size() != 1) fail(prim, name, "must be a number");
    return found->numbers[0];
}

double UsdStage::number(const UsdPrim& prim, const std::string& name, double otherwise, double least,
                        double most) const {
    const double result = number(prim, name, otherwise);
    if (!(result >= least && result <= most)) {
        fail(prim, name, "must be from " + std::to_string(least) + " to " + std::to_string(most));
    }
    return result;
}

bool UsdStage::flag(const UsdPrim& prim, const std::string& name, bool otherwise) const {
    return number(prim, name, otherwise ? 1.0 : 0.0) != 0.0;
}

std::string UsdStage::word(const UsdPrim& prim, const std::string& name, const std::string& otherwise) const {
    const UsdValue* found = value(prim, name);
    return found == nullptr || found->words.empty() ? otherwise : found->words[0];
}

glm::dvec3 UsdStage::vector3(const UsdPrim& prim, const std::string& name, const glm::dvec3& otherwise) const {
    const UsdValue* found = value(prim, name);
    if (found == nullptr) return otherwise;
    if (found->numbers.size() != 3) fail(prim, name, "must have 3 numbers");
    return {found->numbers[0], found->numbers[1], found->numbers[2]};
}

glm::dquat UsdStage::rotation(const UsdPrim& prim, const std::string& name) const {
    const UsdValue* found = value(prim, name);
    if (found == nullptr) return {1.0, 0.0, 0.0, 0.0};
    const std::vector<double>& v = found->numbers;
    if (v.size() != 4) fail(prim, name, "must have 4 numbers");
    const double square = v[0] * v[0] + v[1] * v[1] + v[2] * v[2] + v[3] * v[3];
    if (!(square < 1e12)) fail(prim, name, "must be a rotation");
    if (square < 1e-12) return {1.0, 0.0, 0.0, 0.0}; // a zero quaternion is commonly written for the identity
    return glm::dquat(v[0], v[1], v[2], v[3]) / std::sqrt(square);
}

bool UsdStage::has(const UsdPrim& prim, std::string_view schema) const {
    known_schemas_.insert(std::string(schema));
    return std::find(prim.schemas.begin(), prim.schemas.end(), schema) != prim.schemas.end();
}

std::optional<std::string> UsdStage::unused() const {
    constexpr std::size_t max_named = 40;
    std::map<std::string, int> names = layer_.left_out;
    const auto is_physical = [](const std::string& name) {
        for (const char* part : {"hysics", "hysx", "mjc", "Mjc"}) {
            if (name.find(part) != std::string::npos) return true;
        }
        return false;
    };
    for (const UsdPlace& place : places_) {
        for (const std::string& schema : place.prim->schemas) {
            if (is_physical(schema) && known_schemas_.count(schema) == 0) ++names[schema];
        }
        for (const auto& [name, value] : place.prim->properties) {
            if (is_physical(name) && asked_.count(name) == 0) ++names[name];
        }
        if (is_physical(place.prim->type) && known_types_.count(place.prim->type) == 0) ++names[place.prim->type];
    }
    if (names.empty()) return std::nullopt;
    std::string line;
    std::size_t count = 0;
    for (const auto& [name, times] : names) {
        if (++count > max_named) break;
        line += (line.empty() ? "" : ", ") + printable(name);
        if (times > 1) line += " (" + std::to_string(times) + ")";
    }
    return name_ + ": has no effect here: " + line + (count > max_named ? " and more" : "");
}

const UsdValue* inherited(const UsdStage& stage, const UsdPlace& place, const std::string& name) {
    for (std::size_t i = place.chain.size(); i-- > 0;) {
        if (const UsdValue* found = stage.value(*place.chain[i], name)) return found;
    }
    return nullptr;
}

} // namespace cairn::scene
