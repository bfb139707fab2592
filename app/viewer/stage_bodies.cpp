// What the inspector changes, and the scene as a file.
#include "viewer/stage.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

namespace cairn::viewer {

void Stage::operator()(const command::SelectBody& select) {
    selected_ = scene_.world.is_valid(select.body) ? select.body : BodyId{};
}

void Stage::operator()(const command::EditBody& change) {
    if (!scene_.world.is_valid(change.body)) return say("The body is gone.");
    for (const auto& [old, replaced] : carry_out(scene_.world, change.body, change.edit)) {
        const auto look = std::find_if(scene_.appearances.begin(), scene_.appearances.end(),
                                       [id = old](const Appearance& known) { return known.shape == id; });
        if (look != scene_.appearances.end()) scene_.appearances.push_back({replaced, look->color});
    }
    refresh_layout();
}

void Stage::operator()(const command::EndChange&) { timeline_.end_change(); }

// Beside the original, by its own width.
void Stage::operator()(const command::DuplicateSelected&) {
    World& world = scene_.world;
    if (!selected_ || !world.is_valid(selected_)) return say("Select a body first, by clicking it.");
    double width = 0.0;
    const std::vector<ShapeId> shapes = world.body(selected_).shapes();
    for (const ShapeId shape : shapes) {
        const Bounds bounds = world.shape_bounds(shape);
        if (!std::isfinite(bounds.max.x - bounds.min.x))
            return say("An infinite plane is enough: it is not duplicated.");
        width = std::max(width, bounds.max.x - bounds.min.x);
    }
    std::vector<ShapeId> copies;
    const BodyId copy = duplicate(world, selected_, {1.05 * width, 0.0, 0.0}, copies);
    for (std::size_t i = 0; i < copies.size(); ++i) {
        const auto original = std::find_if(scene_.appearances.begin(), scene_.appearances.end(),
                                           [&](const Appearance& known) { return known.shape == shapes[i]; });
        if (original != scene_.appearances.end()) scene_.appearances.push_back({copies[i], original->color});
    }
    order_.push_back(copy);
    selected_ = copy;
    refresh_layout();
}

void Stage::operator()(const command::SaveScene& save) {
    if (!savers_.scene) return say("This program cannot write scenes.");
    // A copy, without what the mouse and the keys hold at the moment.
    LoadedScene copy;
    copy.world.restore(scene_.world.save());
    end_held(copy.world, held_);
    copy.title = scene_.title;
    copy.hint = scene_.hint;
    copy.camera = save.camera;
    copy.time_step = float(clock_.time_step());
    copy.appearances = scene_.appearances;
    copy.strings = scene_.strings;
    copy.force_fields = scene_.force_fields;
    savers_.scene(save.path, copy);
    say("Saved " + save.path +
        (scene_.visuals.empty() ? "" : ", with what collides, but without the file's own meshes"));
}

} // namespace cairn::viewer
