// Selection of several bodies, and groups, which a click selects as a whole.
#include "viewer/group_edit.h"
#include "viewer/stage.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <iterator>
#include <limits>
#include <map>
#include <new>
#include <utility>

namespace cairn::viewer {

namespace {

bool contains(const std::vector<BodyId>& bodies, BodyId body) {
    return std::find(bodies.begin(), bodies.end(), body) != bodies.end();
}

// Extent of bodies along x; empty if any is infinite, such as a plane.
std::optional<double> width_of(const World& world, const std::vector<BodyId>& bodies) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const BodyId body : bodies)
        for (const ShapeId shape : world.body(body).shapes()) {
            const Bounds bounds = world.shape_bounds(shape);
            low = std::min(low, bounds.min.x), high = std::max(high, bounds.max.x);
        }
    if (low > high) return 0.0; // no shapes
    return std::isfinite(high - low) ? std::optional(high - low) : std::nullopt;
}

} // namespace

const std::vector<BodyId>* Stage::group_of(BodyId body) const {
    const Groups& groups = timeline_.groups();
    const auto group = std::find_if(groups.begin(), groups.end(),
                                    [&](const std::vector<BodyId>& known) { return contains(known, body); });
    return group == groups.end() ? nullptr : &*group;
}

// The existing bodies of a body's group. A removed member stays in its group, because undo may bring it back.
std::vector<BodyId> Stage::with_group(BodyId body) const {
    const std::vector<BodyId>* group = group_of(body);
    std::vector<BodyId> bodies = group ? *group : std::vector<BodyId>{body};
    std::erase_if(bodies, [this](BodyId id) { return !scene_.world.is_valid(id); });
    return bodies;
}

bool Stage::is_group_selected() const {
    if (selection_.size() < 2 || !group_of(selected_)) return false;
    const std::vector<BodyId> bodies = with_group(selected_);
    return std::is_permutation(bodies.begin(), bodies.end(), selection_.begin(), selection_.end());
}

void Stage::select(BodyId body) {
    selected_ = body && scene_.world.is_valid(body) ? body : BodyId{};
    selection_ = selected_ ? with_group(selected_) : std::vector<BodyId>{};
}

void Stage::select(std::vector<BodyId> bodies, BodyId first) {
    selection_ = std::move(bodies);
    selected_ = contains(selection_, first) ? first : selection_.empty() ? BodyId{} : selection_.back();
}

void Stage::toggle_selected(std::vector<BodyId> before, BodyId body) {
    const std::vector<BodyId> bodies = with_group(body);
    if (contains(before, body)) {
        std::erase_if(before, [&](BodyId id) { return contains(bodies, id); });
    } else {
        before.insert(before.end(), bodies.begin(), bodies.end());
    }
    select(std::move(before), body);
}

// Only finite bodies are selected, because a click on an infinite ground is not meant to select it. A second click on a
// selected body that does not move clears the selection, because there may be nothing else to click at.
void Stage::finish_click(bool adds) {
    const bool is_body = met_ && scene_.world.is_valid(met_) && width_of(scene_.world, {met_});
    if (adds && is_body)
        toggle_selected(selected_before_grab_, met_);
    else if (adds)
        select(selected_before_grab_, selected_);
    else if (!grab_.body && is_body && !(selection_.size() == 1 && selected_ == met_))
        select(met_), selected_joint_ = {};
    else if (!grab_.body)
        (*this)(command::SelectNothing{});
}

void Stage::add_to_selection(const std::vector<BodyId>& bodies) {
    std::vector<BodyId> all = selection_;
    BodyId last = selected_;
    for (const BodyId body : bodies) {
        if (!scene_.world.is_valid(body)) continue;
        for (const BodyId member : with_group(body))
            if (!contains(all, member)) all.push_back(member);
        last = body;
    }
    if (bodies.empty()) say("No body lies completely in the frame.");
    select(std::move(all), last);
}

// Called after time travel, and after bodies were removed.
void Stage::drop_gone_from_selection() {
    std::erase_if(selection_, [this](BodyId id) { return !scene_.world.is_valid(id); });
    select(std::move(selection_), selected_);
}

void Stage::operator()(const command::GroupSelected&) {
    if (selection_.size() < 2)
        return say(
            "Select several bodies first: Shift+click adds a body, Shift+drag beside bodies adds all in a frame.");
    if (is_group_selected()) return say("The selected bodies are already a group.");
    Groups groups = timeline_.groups();
    for (std::vector<BodyId>& group : groups)
        std::erase_if(group, [this](BodyId id) { return contains(selection_, id); });
    std::erase_if(groups, [](const std::vector<BodyId>& group) { return group.size() < 2; });
    groups.push_back(selection_);
    timeline_.set_groups(std::move(groups));
    say("Grouped " + std::to_string(selection_.size()) + " bodies: a click on one selects them all.");
}

void Stage::operator()(const command::UngroupSelected&) {
    Groups groups = timeline_.groups();
    const std::size_t dissolved = std::erase_if(groups, [this](const std::vector<BodyId>& group) {
        return std::any_of(group.begin(), group.end(), [this](BodyId id) { return contains(selection_, id); });
    });
    if (dissolved == 0) return say("No group is selected.");
    timeline_.set_groups(std::move(groups));
    say("The group was ended.");
}

void Stage::operator()(const command::EditBodies& change) {
    BodyId at;
    try {
        all_or_nothing([&] {
            for (const auto& [body, edit] : change.edits)
                if (scene_.world.is_valid(at = body)) carry_out(scene_.world, body, edit);
        });
        refresh_layout();
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& error) {
        say("No body was changed, because " + label_of(at, scene_.world.body(at).name()) +
            " cannot be: " + error.what());
    }
}

// Copies bodies, and the joints between them. Returns the copies in the order of the originals.
std::vector<BodyId> Stage::copy_bodies(const std::vector<BodyId>& bodies, double shift) {
    World& world = scene_.world;
    std::map<BodyId, BodyId> copy_of;
    std::vector<BodyId> made;
    for (const BodyId body : bodies) {
        const std::vector<ShapeId> shapes = world.body(body).shapes();
        std::vector<ShapeId> copies;
        made.push_back(duplicate(world, body, {shift, 0.0, 0.0}, copies));
        copy_of.emplace(body, made.back());
        for (std::size_t i = 0; i < copies.size(); ++i) {
            const auto original = std::find_if(scene_.appearances.begin(), scene_.appearances.end(),
                                               [&](const Appearance& known) { return known.shape == shapes[i]; });
            if (original != scene_.appearances.end()) scene_.appearances.push_back({copies[i], original->color});
        }
    }
    for (const JointId joint : world.joints()) {
        JointDef def = world.joint_def(joint);
        const auto a = copy_of.find(def.body_a), b = copy_of.find(def.body_b);
        if (a == copy_of.end() || b == copy_of.end()) continue;
        def.body_a = a->second, def.body_b = b->second;
        const JointId copy = world.create_joint(def);
        const auto look = std::find_if(scene_.strings.begin(), scene_.strings.end(),
                                       [&](const JointAppearance& known) { return known.joint == joint; });
        if (look != scene_.strings.end()) scene_.strings.push_back({copy, look->color});
    }
    return made;
}

// Places the copies beside the originals, at a distance of their total width. Copies of a group form a group.
void Stage::operator()(const command::DuplicateSelected&) {
    drop_gone_from_selection();
    if (selection_.empty()) return say("Select a body first, by clicking it.");
    const std::optional<double> width = width_of(scene_.world, selection_);
    if (!width) return say("An infinite plane cannot be duplicated.");
    Groups groups = timeline_.groups();
    const bool is_group = group_of(selected_) != nullptr && selection_.size() > 1;
    const auto first = std::find(selection_.begin(), selection_.end(), selected_) - selection_.begin();
    std::vector<BodyId> made;
    all_or_nothing([&] {
        made = copy_bodies(selection_, 1.05 * *width);
        groups.push_back(made);
        if (is_group) timeline_.set_groups(std::move(groups));
    });
    order_.insert(order_.end(), made.begin(), made.end());
    select(made, made[std::size_t(first)]);
    refresh_layout();
}

} // namespace cairn::viewer
