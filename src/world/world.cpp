// Bodies, shapes and force fields: creating, changing and removing them. Every argument is checked before anything
// changes.
#include "bodies/bodies.h"
#include "bodies/finalize.h"
#include "contacts/contact_update.h"
#include "contacts/pairs.h"
#include "contacts/prefetch.h"
#include "islands/islands.h"
#include "state/state.h"
#include "world/impl.h"
#include "world/validate.h"

#include <algorithm>
#include <atomic>
#include <system_error>
#include <thread>

namespace cairn {

namespace {

// Worlds are distinguished by a number from 1 to 65,535, which wraps around; zero belongs to no world.
std::uint32_t next_world_id() {
    static std::atomic<std::uint32_t> counter{0};
    return 1 + counter.fetch_add(1, std::memory_order_relaxed) % 0xffffu;
}

[[noreturn]] void refuse_handle(const char* field, std::uint64_t bits, const char* why) {
    char text[24];
    std::snprintf(text, sizeof text, "0x%llx", static_cast<unsigned long long>(bits));
    throw Error(ErrorCode::invalid_handle, field, text, why);
}

template <class Id> std::uint32_t checked_index(const char* field, Id id, const SlotPool<Id>& pool) {
    if (id.is_null()) refuse_handle(field, id.bits, "must not be null");
    if (id.world() != pool.world()) refuse_handle(field, id.bits, "must be of this world");
    if (!pool.is_live(id.index(), id.generation())) refuse_handle(field, id.bits, "is stale: the object was removed");
    return id.index();
}

void wake_all(State& s) {
    for (std::size_t i = 0; i < s.islands.all.size(); ++i)
        if (s.islands.all[i].in_use) wake_island(s.bodies, s.islands, s.events, std::int32_t(i));
}

} // namespace

World::Impl::Impl(const WorldDef& def) {
    validate(def);
    state.settings = def;
    state.set_world(next_world_id());
}

std::int32_t World::Impl::index_of(BodyId id) const {
    require_usable("BodyId");
    return std::int32_t(checked_index("BodyId", id, state.bodies.slots));
}
std::uint32_t World::Impl::index_of(ShapeId id) const {
    require_usable("ShapeId");
    return checked_index("ShapeId", id, state.shapes.slots);
}
std::uint32_t World::Impl::index_of(JointId id) const {
    require_usable("JointId");
    return checked_index("JointId", id, state.joints.slots);
}
std::uint32_t World::Impl::index_of(ForceFieldId id) const {
    require_usable("ForceFieldId");
    return checked_index("ForceFieldId", id, state.fields.slots);
}
void World::Impl::require_idle(const char* call) const {
    if (stepping)
        throw Error(ErrorCode::wrong_state, call, "", "not allowed while a step or a query of this world runs");
}
void World::Impl::require_usable(const char* call) const {
    if (failed_call)
        throw Error(ErrorCode::wrong_state, call, "",
                    std::string("refused: the world ran out of memory in ") + failed_call +
                        " and is incomplete. Restore a snapshot, or make a new world");
}

World::Owned::Owned(std::unique_ptr<Impl> impl) noexcept : impl_(std::move(impl)) {}
World::World(const WorldDef& def) : impl_(std::make_unique<Impl>(def)) {}
World::~World() = default;
World::World(World&&) noexcept = default;
World& World::operator=(World&&) noexcept = default;

void World::throw_moved_from() {
    throw Error(ErrorCode::wrong_state, "World", {},
                "was moved from, and may only be destroyed or assigned to; use the world that it was moved to");
}

const WorldDef& World::settings() const { return impl_->state.settings; }

void World::set_settings(const WorldDef& def) {
    Impl::Change change(*impl_, commands::world_set_settings, def);
    validate(def);
    State& s = impl_->state;
    const bool wakes = def.gravity != s.settings.gravity || (s.settings.enable_sleep && !def.enable_sleep);
    change.begin();
    s.settings = def;
    if (!wakes) return;
    wake_all(s);
    for (BodyLinks& body : s.bodies.links) body.quiet_time = 0;
}

void World::set_threads(int count) {
    Impl::Change change(*impl_, commands::world_set_threads, count);
    if (count < 1 || count > ThreadPool::max_threads)
        refuse("World::set_threads count", std::to_string(count), "must be 1 to 256");
    if (count == threads()) return;
    std::unique_ptr<ThreadPool> pool; // created before the change begins, so that a failure leaves the world as it was
    try {
        pool = std::make_unique<ThreadPool>(count);
    } catch (const std::system_error& error) {
        throw Error(ErrorCode::unsupported, "World::set_threads count", std::to_string(count),
                    std::string("the system has not so many threads left (") + error.what() + ")");
    }
    change.begin();
    impl_->step.thread_pool = std::move(pool);
}

int hardware_threads() noexcept {
    return std::clamp(int(std::thread::hardware_concurrency()), 1, ThreadPool::max_threads);
}

int World::threads() const { return impl_->step.thread_pool->threads(); }

void World::set_communicator(std::shared_ptr<Communicator> communicator) {
    impl_->require_idle("World::set_communicator");
    impl_->require_usable("World::set_communicator");
    if (communicator) {
        const int rank = communicator->rank(), size = communicator->size();
        if (size < 1) refuse("World::set_communicator size", std::to_string(size), "must be at least 1");
        if (rank < 0 || rank >= size)
            refuse("World::set_communicator rank", std::to_string(rank), "must be 0 to size - 1, " + to_text(size - 1));
    }
    const bool is_alone = !communicator || communicator->size() == 1;
    impl_->gather_records(); // from the previous communicator's ranks
    impl_->state.contacts.owners = {};
    impl_->communicator = is_alone ? nullptr : std::move(communicator);
}

BodyId World::create_body(const BodyDef& def) {
    Impl::Change change(*impl_, commands::world_create_body, def);
    validate(def);
    State& s = impl_->state;
    require_slot(s.bodies.slots, "World::create_body");
    change.begin();
    const std::size_t b = s.bodies.slots.create();
    make_room(s.bodies.motion, b), make_room(s.bodies.mass, b), make_room(s.bodies.settings, b),
        make_room(s.bodies.forces, b);
    make_room(s.bodies.links, b), make_room(s.bodies.counted, b), make_room(s.bodies.travel, b),
        make_room(s.bodies.ahead, b), make_room(s.bodies.boxes_until, b), make_room(impl_->names, b),
        make_room(impl_->user_data, b);
    s.bodies.links[b] = {};
    s.bodies.forces[b] = {};
    s.bodies.pushed.reserve(s.bodies.forces.capacity()); // so that adding to it never allocates
    s.bodies.counted[b] = {};
    s.bodies.travel[b] = s.bodies.ahead[b] = s.bodies.boxes_until[b] = 0;
    s.bodies.mass[b] = {};
    const BodyType type = def.enabled ? def.type : BodyType::static_;
    s.bodies.settings[b] = {def.gravity_scale, def.linear_damping, def.angular_damping, 0, type,
                            def.allow_sleep,   def.type,           def.enabled};
    const Quat q = checked_rotation("BodyDef.rotation", def.rotation);
    BodyMotion& motion = s.bodies.motion[b] = {};
    motion.x = to_math(def.position);
    motion.q = math::normalized(math::to_double(to_math(q)));
    motion.v = to_math(def.linear_velocity);
    motion.w = to_math(def.angular_velocity);
    if (def.type == BodyType::static_) s.bodies.motion[b].v = s.bodies.motion[b].w = {};
    if (clamp_velocity(s.settings, s.bodies.motion[b].v, s.bodies.motion[b].w)) ++s.clamped_speeds;
    impl_->names[b] = def.name;
    impl_->user_data[b] = def.user_data;

    const std::int32_t body = std::int32_t(b);
    BodyMass& mass = s.bodies.mass[b];
    if (def.mass_properties) {
        mass.follows_shapes = 0;
        set_mass(s.bodies, s.joints, body, *def.mass_properties);
        // The given velocity is that of the center of mass, wherever the center is.
        if (def.type != BodyType::static_) s.bodies.motion[b].v = to_math(def.linear_velocity);
        clamp_velocity(s.settings, s.bodies.motion[b].v, s.bodies.motion[b].w);
    } else {
        mass.has_given_mass = def.mass.has_value();
        s.bodies.settings[b].given_mass = def.mass.value_or(0.0f);
        refresh_mass(s.bodies, s.shapes, s.joints, body);
    }
    if (type == BodyType::dynamic) create_island(s.bodies, s.islands, body);
    if (type == BodyType::kinematic) s.bodies.kinematics.push_back(body);
    return s.bodies.id(body);
}

void World::destroy_body(BodyId id) {
    Impl::Change change(*impl_, commands::world_destroy_body, id);
    const std::int32_t b = impl_->index_of(id);
    State& s = impl_->state;
    change.begin();
    wake_around(s.bodies, s.shapes, s.islands, s.broad_phase, s.events, b);
    wake_body(s.bodies, s.islands, s.events, b);
    impl_->retire_joints_of(b);
    for (std::int32_t shape = s.bodies.links[b].first_shape; shape != none; shape = s.shapes.links[shape].next)
        retire_shape(s.shapes, s.broad_phase, s.characters, std::uint32_t(shape));
    if (s.bodies.links[b].island != none) remove_from_island(s.bodies, s.islands, b);
    std::erase_if(s.characters.all, [&](const Character& c) { return c.body == b; });
    std::erase(s.bodies.kinematics, b);
    s.bodies.slots.kill(std::uint32_t(b));
    s.bodies.dead.push_back(std::uint32_t(b));
    impl_->names[b].clear();
    reclaim_slots(s.bodies, s.shapes, s.contacts, s.islands, s.joints, s.broad_phase, s.events);
}

bool World::is_valid(BodyId id) const noexcept { return impl_ && impl_->state.bodies.slots.holds(id); }
bool World::is_valid(ShapeId id) const noexcept { return impl_ && impl_->state.shapes.slots.holds(id); }
bool World::is_valid(ForceFieldId id) const noexcept { return impl_ && impl_->state.fields.slots.holds(id); }

Body World::body(BodyId id) {
    impl_->index_of(id);
    return Body(*this, id);
}
const Body World::body(BodyId id) const {
    impl_->index_of(id);
    return Body(const_cast<World&>(*this), id); // a const Body has only const members
}

std::vector<BodyId> World::bodies() const {
    const State& s = impl_->intact("World::bodies");
    std::vector<BodyId> ids;
    ids.reserve(s.bodies.slots.live_count());
    for (std::uint32_t i = 0; i < s.bodies.slots.size(); ++i)
        if (s.bodies.slots.is_live(i)) ids.push_back(s.bodies.id(std::int32_t(i)));
    return ids;
}

std::optional<BodyId> World::find_body(std::string_view name) const {
    const State& s = impl_->intact("World::find_body");
    for (std::uint32_t i = 0; i < s.bodies.slots.size(); ++i)
        if (s.bodies.slots.is_live(i) && impl_->names[i] == name) return s.bodies.id(std::int32_t(i));
    return std::nullopt;
}

ForceFieldId World::add_force_field(const ForceField& field) {
    Impl::Change change(*impl_, commands::world_add_force_field, field);
    validate(field);
    State& s = impl_->state;
    require_slot(s.fields.slots, "World::add_force_field");
    const ForceField own(field); // `field` may refer to an element of this world's list, which grows
    change.begin();
    const std::uint32_t i = s.fields.slots.create();
    make_room(s.fields.all, i);
    s.fields.all[i] = own;
    wake_all(s);
    return s.fields.slots.id(i);
}

void World::set_force_field(ForceFieldId id, const ForceField& field) {
    Impl::Change change(*impl_, commands::world_set_force_field, id, field);
    const std::uint32_t i = impl_->index_of(id);
    validate(field);
    State& s = impl_->state;
    change.begin();
    s.fields.all[i] = field;
    wake_all(s);
}

void World::remove_force_field(ForceFieldId id) {
    Impl::Change change(*impl_, commands::world_remove_force_field, id);
    const std::uint32_t i = impl_->index_of(id);
    State& s = impl_->state;
    change.begin();
    s.fields.slots.kill(i);
    s.fields.slots.recycle(i);
    wake_all(s);
}

const ForceField& World::force_field(ForceFieldId id) const {
    const std::uint32_t i = impl_->index_of(id);
    return impl_->intact("World::force_field").fields.all[i];
}

std::vector<ForceFieldId> World::force_fields() const {
    const State& s = impl_->intact("World::force_fields");
    std::vector<ForceFieldId> all;
    for (std::uint32_t i = 0; i < s.fields.slots.size(); ++i)
        if (s.fields.slots.is_live(i)) all.push_back(s.fields.slots.id(i));
    return all;
}

std::uint64_t World::step_count() const { return impl_->state.steps; }
double World::time() const { return impl_->state.time; }
std::span<const ContactBegin> World::contact_begins() const { return impl_->state.events.begins; }
std::span<const ContactEnd> World::contact_ends() const { return impl_->state.events.ends.now; }
std::span<const ContactHit> World::contact_hits() const { return impl_->state.events.hits; }
std::span<const TriggerEvent> World::trigger_events() const { return impl_->state.events.triggers.now; }
std::span<const SleepEvent> World::sleep_events() const { return impl_->state.events.sleeps.now; }
std::string_view instruction_set() noexcept { return kernels().name; }

} // namespace cairn
