#include "viewer/stage.h"

#include "viewer/change_names.h"
#include "viewer/group_edit.h"

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <exception>
#include <new>
#include <utility>

namespace cairn::viewer {

namespace {

constexpr float pull_acceleration = 20.0f;            // m/s^2, toward the origin
constexpr float walk_speed = 3.0f, jump_speed = 4.5f; // m/s
constexpr double pick_distance = 1.0e8;               // m; rays of an orthographic camera begin far away
constexpr double newest_step_weight = 0.1;            // in the moving average of step times
constexpr double longest_advance = 1.0 / 30.0;        // s of real time spent on steps before the picture is updated

} // namespace

Stage::Stage(SceneLoader loader, const std::string& path, Savers savers)
    : loader_(std::move(loader)), scene_(loader_(path)), savers_(std::move(savers)) {
    take_scene(std::move(scene_), path);
}

void Stage::take_scene(LoadedScene scene, const std::string& path) {
    scene_ = std::move(scene);
    path_ = path;
    ++scene_serial_;
    clock_.set_time_step(scene_.time_step);
    if (scene_.is_paused) clock_.set_paused(true);
    order_.clear();
    for (const BodyId id : scene_.world.bodies())
        if (scene_.world.body(id).type() == BodyType::dynamic) order_.push_back(id);
    force_field_.reset();
    pull_field_.reset();
    force_ = Vec3(0.0f);
    frozen_ = false;
    select({});
    selected_before_grab_.clear();
    met_ = {};
    selected_joint_ = {};
    drag_joint_ = {}; // it was destroyed with its world
    grab_ = {grab_.serial, false, {}, {}, {}, {}};
    step_milliseconds_ = 0.0;
    timeline_.begin(scene_.world, std::exchange(scene_.run, {}), scene_.groups);
    held_.clear();
    other_.reset();
    slow_motion_.reset();
    impact_.reset();
    impact_partners_.clear();
    samples_.clear();
    seeking_.reset();
    is_backwards_ = false;
    refresh_layout();
    restart_panes();
}

void Stage::apply(const Command& command) {
    const Moment before = timeline_.now();
    const BodyId selected_before = selected_;
    const bool was_holding = grab_.holding;
    try {
        std::visit(*this, command);
    } catch (const std::bad_alloc&) {
        say("out of memory");
    } catch (const std::exception& error) {
        say(error.what());
    }
    const auto* released = std::get_if<command::ReleaseGrab>(&command);
    if (released && released->click && was_holding)
        timeline_.unname_change("drag"); // the drag was a click, which only selects
    else if (const auto change = change_of(command))
        timeline_.name_change(before, change->name, change->merge);
    settle_branch();
    if (!seeking_) take_others_along(longest_advance);
    if (selected_ != selected_before && solver_shown_.any()) refresh_motion();
}

int Stage::advance(double real_seconds) {
    hear_from_writer();
    if (seeking_) go_on_seeking();
    take_others_along(longest_advance); // they may still be seeking
    const int due = clock_.advance(real_seconds);
    const auto start = std::chrono::steady_clock::now();
    int taken = 0;
    while (taken < due) {
        step();
        ++taken;
        // If the simulation is slower than real time, due steps are dropped, so that the picture is updated every few
        // steps.
        if (std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() > longest_advance) break;
    }
    return taken;
}

void Stage::step() {
    const auto start = std::chrono::steady_clock::now();
    const bool is_live = !is_backwards_ && !timeline_.follows();
    try {
        if (is_backwards_)
            go_back();
        else if (is_live)
            live_step();
        else
            follow();
    } catch (const std::bad_alloc&) {
        clock_.set_paused(true);
        return say("out of memory: Delete resets the scene");
    } catch (const std::exception& error) {
        clock_.set_paused(true);
        return say(error.what());
    }
    clock_.count_step();
    end_slow_motion();
    take_others_along(longest_advance);
    if (!is_live) return;
    const double milliseconds =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    step_milliseconds_ = step_milliseconds_ == 0.0
                             ? milliseconds
                             : step_milliseconds_ + newest_step_weight * (milliseconds - step_milliseconds_);
}

void Stage::live_step() {
    if (frozen_) hold_still();
    if (grab_.holding) pull_grabbed();
    watch_energy();
    const auto start = std::chrono::steady_clock::now();
    scene_.world.step(float(clock_.time_step()));
    timeline_.after_step(scene_.world, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    settle_branch();
    report_broken();
    take_sample();
    previous_ = current_;
    refresh_motion();
}

StageState Stage::state() const {
    StageState state;
    state.scene_serial = scene_serial_;
    state.path = path_;
    state.title = scene_.title;
    state.hint = scene_.hint;
    state.scene_camera = scene_.camera;
    state.lighting = lighting_of(scene_.lights, scene_.camera.target);
    state.layout = layout_;
    state.previous = previous_;
    state.current = current_;
    state.statistics = scene_.world.statistics();
    state.step_milliseconds = step_milliseconds_;
    state.settings = scene_.world.settings();
    state.paused = clock_.paused();
    state.frozen = frozen_;
    state.pulled = pull_field_.has_value();
    state.fields = fields();
    state.force = force_;
    state.speed = clock_.speed();
    state.real_time_factor = clock_.real_time_factor();
    state.time_step = clock_.time_step();
    state.usual_substeps = scene_.world.usual_substeps(float(state.time_step));
    state.remainder = clock_.remainder();
    state.selected = selected_;
    state.selection = selection_;
    state.is_group = is_group_selected();
    state.selected_joint = selected_joint_;
    state.grab = grab_;
    state.message = message_;
    state.samples = samples_;
    state.inspected = read_facts(scene_.world, selected_, clock_.time_step());
    state.handled = selection_.size() > 1 ? facts_of_several(scene_.world, selection_) : state.inspected;
    state.timeline.first = timeline_.first_step();
    state.timeline.last = timeline_.last_step();
    state.timeline.now = seeking_.value_or(timeline_.now().step);
    state.timeline.marks = timeline_.marks();
    state.timeline.undoable = timeline_.undoable();
    state.timeline.redoable = timeline_.redoable();
    state.timeline.is_backwards = is_backwards_ && !clock_.paused();
    state.timeline.is_recording = timeline_.is_recording();
    state.timeline.verdict = timeline_.verdict();
    state.timeline.bytes = timeline_.bytes();
    if (other_) {
        state.other = {parted_at_, other_->picture(), {}};
        if (other_->is_at(timeline_.now().step))
            state.other->difference = difference(*layout_, *current_, other_->picture());
    }
    for (const Pane& pane : panes_) state.panes.push_back(pane.state(*layout_, *current_));
    state.impact = impact_;
    state.impact_partners = impact_partners_;
    if (!panes_.empty()) {
        state.energy = scene_.world.kinetic_energy() + scene_.world.potential_energy();
        state.panes_began = panes_start_->moment.step;
    }
    return state;
}

void Stage::operator()(const command::LoadScene& load) { take_scene(loader_(load.path), load.path); }

void Stage::operator()(const command::ResetScene&) { take_scene(loader_(path_), std::string(path_)); }

void Stage::operator()(const command::Spawn& spawn) {
    add_body(spawn.settings, spawner_.free_place(scene_.world, spawn.settings, spawn.position), Vec3(0.0f));
}

void Stage::operator()(const command::Shoot& shoot) {
    const Ray& ray = shoot.ray;
    const double ahead = double(2.0f * shoot.settings.size); // in front of the camera
    Vec3 velocity = ray.direction * shoot.settings.speed;
    const auto hit = scene_.world.cast_ray(ray.origin, ray.direction, pick_distance);
    if (const double far = hit ? double(hit->distance) - ahead : 0.0; far > 0.0) {
        const Vec3 aimed =
            velocity_to_reach(ray.direction * float(far), shoot.settings.speed, scene_.world.settings().gravity);
        if (glm::length(aimed) <= std::max(shoot.settings.speed, greatest_shot_speed)) velocity = aimed;
    }
    add_body(shoot.settings, ray.origin + Position(ray.direction) * ahead, velocity);
}

void Stage::add_body(const SpawnSettings& settings, const Position& position, const Vec3& velocity) {
    order_.push_back(spawner_.spawn(scene_.world, settings, position, velocity));
    refresh_layout();
}

void Stage::operator()(const command::RemoveLast&) {
    while (!order_.empty() && !scene_.world.is_valid(order_.back())) order_.pop_back();
    if (order_.empty()) return say("There is no body left to remove.");
    remove({order_.back()});
    order_.pop_back();
}

void Stage::operator()(const command::RemoveSelected&) {
    drop_gone_from_selection();
    if (selection_.empty()) return say("Select a body first, by clicking it.");
    remove(std::vector<BodyId>(selection_));
}

void Stage::remove(const std::vector<BodyId>& bodies) {
    for (const BodyId body : bodies) scene_.world.destroy_body(body);
    drop_gone_from_selection();
    if (grab_.holding && !scene_.world.is_valid(grab_.body)) {
        grab_.holding = false;
        say("The dragged body was removed.");
    }
    refresh_layout();
}

void Stage::operator()(const command::SetForce& force) {
    force_ = force.acceleration;
    if (walk(force_)) return;
    ForceField field;
    field.direction = force_;
    update_field(force_field_, field, force_ != Vec3(0.0f));
}

// Passes the force keys to the characters of the world, if there are any; else returns false.
bool Stage::walk(const Vec3& push) {
    bool walks = false;
    for (const BodyId id : scene_.world.bodies()) {
        Body body = scene_.world.body(id);
        if (!body.is_character()) continue;
        walks = true;
        const Vec3 level(push.x, 0.0f, push.z);
        const float length = glm::length(level);
        body.set_walk_velocity(length > 0.0f ? (walk_speed / length) * level : Vec3(0.0f));
        if (push.y > 0.0f) body.jump(jump_speed);
    }
    return walks;
}

void Stage::operator()(const command::SetPull& pull) {
    ForceField field;
    field.kind = ForceField::Kind::radial;
    field.strength = pull_acceleration;
    update_field(pull_field_, field, pull.on);
}

void Stage::update_field(std::optional<ForceFieldId>& id, const ForceField& field, bool on) {
    World& world = scene_.world;
    if (!on) {
        if (id) world.remove_force_field(*id);
        id.reset();
    } else if (id) {
        world.set_force_field(*id, field);
    } else {
        id = world.add_force_field(field);
        held_.push_back({*id, timeline_.now()});
    }
    // Wakes sleeping bodies, so that the change acts on them.
    for (const BodyId body : world.bodies())
        if (world.body(body).type() == BodyType::dynamic) world.body(body).wake();
}

void Stage::operator()(const command::SetFreeze& freeze) {
    frozen_ = freeze.on;
    if (frozen_) hold_still();
}

void Stage::hold_still() {
    for (const BodyId id : scene_.world.bodies()) {
        Body body = scene_.world.body(id);
        if (body.type() != BodyType::dynamic) continue;
        body.set_linear_velocity(Vec3(0.0f));
        body.set_angular_velocity(Vec3(0.0f));
    }
}

void Stage::operator()(const command::SetPaused& pause) { clock_.set_paused(pause.paused); }

void Stage::operator()(const command::TogglePause&) {
    clock_.set_paused(!clock_.paused());
    is_backwards_ = false;
}

void Stage::operator()(const command::SingleStep&) {
    is_backwards_ = false;
    clock_.request_step();
}

void Stage::operator()(const command::ChangeSpeed& change) { clock_.change_speed(change.doublings); }

void Stage::operator()(const command::SetSpeed& speed) { clock_.set_speed(speed.speed); }

void Stage::operator()(const command::SetSettings& settings) { scene_.world.set_settings(settings.settings); }

void Stage::operator()(const command::GrabBody& grab) {
    let_go();
    grab_ = {grab.serial, false, {}, {}, {}, {}};
    const auto hit = scene_.world.cast_ray(grab.ray.origin, grab.ray.direction, pick_distance);
    met_ = hit ? hit->body : BodyId{};
    selected_before_grab_ = selection_;
    if (!hit || scene_.world.body(hit->body).type() != BodyType::dynamic) return;
    select(hit->body);
    const Transform pose = scene_.world.body(hit->body).transform();
    grab_.holding = true;
    grab_.body = hit->body;
    grab_.start = grab_.target = hit->point;
    grab_.local_point = glm::conjugate(pose.rotation) * Vec3(hit->point - pose.position);
    drag_joint_ = scene_.world.create_joint(drag_joint(scene_.world, hit->body, grab_.local_point));
    held_.push_back({drag_joint_, timeline_.now()});
}

void Stage::operator()(const command::MoveGrab& move) {
    if (grab_.holding) grab_.target = move.target;
}

void Stage::operator()(const command::ReleaseGrab& release) {
    if (release.click)
        finish_click(release.adds);
    else if (release.framed && !grab_.body)
        add_to_selection(*release.framed);
    grab_.holding = false;
    let_go();
}

void Stage::let_go() {
    if (drag_joint_ && scene_.world.is_valid(drag_joint_)) scene_.world.destroy_joint(drag_joint_);
    drag_joint_ = {};
}

void Stage::operator()(const command::SelectNothing&) {
    select({});
    selected_joint_ = {};
}

void Stage::operator()(const command::Say& words) { say(words.text); }

void Stage::operator()(const command::ShowIslands& show) {
    with_islands_ = show.on;
    refresh_motion();
}

void Stage::operator()(const command::ShowSolver& show) {
    solver_shown_ = show.shown;
    refresh_motion();
}

void Stage::pull_grabbed() {
    if (!scene_.world.is_valid(drag_joint_)) {
        grab_.holding = false;
        return say("The dragged body was removed.");
    }
    pull_to(scene_.world, drag_joint_, grab_.target);
}

void Stage::say(std::string text) { message_ = {message_.serial + 1, std::move(text)}; }

void Stage::refresh_layout() {
    layout_ =
        std::make_shared<const WorldLayout>(read_layout(scene_.world, scene_.appearances, meshes_, scene_.visuals));
    refresh_joints();
    refresh_motion();
    previous_ = current_; // the bodies of the preceding step may not match
}

void Stage::refresh_motion() {
    WorldMotion motion = read_motion(scene_.world, *layout_, with_islands_, joints_);
    motion.solver = read_solver(scene_.world, solver_shown_, clock_.time_step(), selected_);
    current_ = std::make_shared<const WorldMotion>(std::move(motion));
}

} // namespace cairn::viewer
