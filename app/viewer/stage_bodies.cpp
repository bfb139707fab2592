// What the inspector changes, and the scene as a file.
#include "viewer/stage.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

namespace cairn::viewer {

void Stage::operator()(const command::SelectBody& select) { this->select(select.body); }

void Stage::operator()(const command::EditBody& change) {
    if (!scene_.world.is_valid(change.body)) return say("The body is gone.");
    all_or_nothing([&] { edit_body(change.body, change.edit); });
    refresh_layout();
}

// A change that throws leaves nothing behind, neither in the world nor in how it looks.
void Stage::all_or_nothing(const std::function<void()>& change) {
    const std::size_t colors = scene_.appearances.size(), strings = scene_.strings.size();
    try {
        timeline_.attempt(scene_.world, change);
    } catch (...) {
        scene_.appearances.resize(colors);
        scene_.strings.resize(strings);
        throw;
    }
}

void Stage::edit_body(BodyId body, const BodyEdit& edit) {
    for (const auto& [old, replaced] : carry_out(scene_.world, body, edit)) {
        const auto look = std::find_if(scene_.appearances.begin(), scene_.appearances.end(),
                                       [id = old](const Appearance& known) { return known.shape == id; });
        if (look != scene_.appearances.end()) scene_.appearances.push_back({replaced, look->color});
    }
}

void Stage::operator()(const command::EndChange&) { timeline_.end_change(); }

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
    copy.groups = timeline_.groups();
    savers_.scene(save.path, copy);
    say("Saved " + save.path +
        (scene_.visuals.empty() ? "" : ", with what collides, but without the file's own meshes"));
}

} // namespace cairn::viewer
