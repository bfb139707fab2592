#include "cli/what_if.h"

#include <cairn/error.h>

#include <charconv>
#include <cmath>

namespace cairn::cli {

namespace {

[[noreturn]] void refuse_change(const std::string& text, const std::string& expected) {
    throw Error(ErrorCode::invalid_value, "--what-if", "\"" + text + "\"", expected);
}

std::vector<float> numbers_of(const std::string& text, std::string_view list, std::size_t count) {
    std::vector<float> numbers;
    while (numbers.size() < count) {
        float number = 0.0f;
        const auto [stop, error] = std::from_chars(list.data(), list.data() + list.size(), number);
        if (error != std::errc() || !std::isfinite(number)) break;
        numbers.push_back(number);
        list.remove_prefix(static_cast<std::size_t>(stop - list.data()));
        if (list.empty() || list[0] != ',' || numbers.size() == count) break;
        list.remove_prefix(1);
    }
    if (numbers.size() != count || !list.empty())
        refuse_change(text, count == 1 ? "must have a number after ="
                                       : "must have three numbers after =, separated by commas");
    return numbers;
}

// Changes all materials of the world.
WhatIf change_of_materials(std::function<void(Material&)> change) {
    return {[change = std::move(change)](World& world) {
        for (const BodyId body : world.bodies())
            for (const ShapeId shape : world.body(body).shapes()) {
                Material material = world.shape_def(shape).material;
                change(material);
                world.set_material(shape, material);
            }
    }};
}

WhatIf change_of_settings(std::function<void(WorldDef&)> change) {
    return {[change = std::move(change)](World& world) {
        WorldDef settings = world.settings();
        change(settings);
        world.set_settings(settings);
    }};
}

} // namespace

std::vector<WhatIf> parse_what_if(std::span<const std::string> texts) {
    std::vector<WhatIf> changes;
    for (const std::string& text : texts) {
        const std::size_t equals = text.find('=');
        const std::string what = text.substr(0, equals);
        const std::string_view value =
            equals == std::string::npos ? std::string_view() : std::string_view(text).substr(equals + 1);
        if (what == "gravity") {
            const std::vector<float> v = numbers_of(text, value, 3);
            changes.push_back(change_of_settings([v](WorldDef& settings) { settings.gravity = {v[0], v[1], v[2]}; }));
        } else if (what == "substeps") {
            const float count = numbers_of(text, value, 1)[0];
            if (!(count >= 0 && count <= 256 && count == std::floor(count)))
                refuse_change(text, "must be a whole number from 0 to 256");
            changes.push_back(change_of_settings([count](WorldDef& settings) { settings.substeps = int(count); }));
        } else if (what == "friction") {
            const float friction = numbers_of(text, value, 1)[0];
            if (!(friction >= 0)) refuse_change(text, "must not be negative");
            changes.push_back(change_of_materials(
                [friction](Material& material) { material.static_friction = material.dynamic_friction = friction; }));
        } else if (what == "restitution") {
            const float restitution = numbers_of(text, value, 1)[0];
            if (!(restitution >= 0 && restitution <= 1)) refuse_change(text, "must be from 0 to 1");
            changes.push_back(
                change_of_materials([restitution](Material& material) { material.restitution = restitution; }));
        } else {
            refuse_change(text, "must be gravity=X,Y,Z, substeps=N, friction=F or restitution=R");
        }
    }
    return changes;
}

} // namespace cairn::cli
