// Edits made by the inspector, and saving the scene to a file.
#include "viewer/stage.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

namespace cairn::viewer {

void Stage::operator()(const command::SelectBody& select) { this->select(select.body); }

void Stage::operator()(const command::EditBody& change) {
    if (!scene_.world.is_valid(change.body)) return say("The body no longer exists.");
    all_or_nothing([&] { carry_out(scene_.world, change.body, change.edit); });
    refresh_layout();
}

// Makes a change that, if it throws, leaves neither the world nor appearances modified.
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

// The world itself wakes sleeping bodies when a force field changes.
void Stage::operator()(const command::AddField& add) { scene_.world.add_force_field(add.field); }

void Stage::operator()(const command::SetField& set) {
    if (!scene_.world.is_valid(set.id)) return say("The force field no longer exists.");
    scene_.world.set_force_field(set.id, set.field);
}

void Stage::operator()(const command::RemoveField& remove) {
    if (scene_.world.is_valid(remove.id)) scene_.world.remove_force_field(remove.id);
}

std::vector<std::pair<ForceFieldId, ForceField>> Stage::fields() const {
    std::vector<std::pair<ForceFieldId, ForceField>> all;
    for (const ForceFieldId id : scene_.world.force_fields()) {
        const bool is_held = std::any_of(held_.begin(), held_.end(), [&](const Held& held) {
            const auto* field = std::get_if<ForceFieldId>(&held.id);
            return field && *field == id;
        });
        if (!is_held) all.emplace_back(id, scene_.world.force_field(id));
    }
    return all;
}

void Stage::operator()(const command::EndChange&) { timeline_.end_change(); }

void Stage::operator()(const command::SaveScene& save) {
    if (!savers_.scene) return say("This program cannot write scenes.");
    // A copy without the joints and force fields of held keys and drags.
    LoadedScene copy;
    copy.world.restore(scene_.world.save());
    end_held(copy.world, held_);
    copy.title = scene_.title;
    copy.hint = scene_.hint;
    copy.camera = save.camera;
    copy.lights = scene_.lights;
    copy.time_step = float(clock_.time_step());
    copy.appearances = scene_.appearances;
    copy.visuals = scene_.visuals;
    copy.strings = scene_.strings;
    copy.groups = timeline_.groups();
    savers_.scene(save.path, copy);
    say("Saved " + save.path);
}

} // namespace cairn::viewer
