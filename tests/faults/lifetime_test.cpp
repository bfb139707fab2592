// Invalid handles, and worlds that are gone: rows 42 to 48 of the list of faults.
#include "../api/test_world.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <functional>
#include <thread>
#include <type_traits>
#include <vector>

namespace cairn::test {
namespace {

// --- every call that takes a handle

struct Call {
    const char* name;
    std::function<void(World&, BodyId, ShapeId, ForceFieldId)> call;
    const char* field; // the handle type in the error message
};

template <class F> Call with_body(const char* name, F&& f) {
    return {name, [f](World& world, BodyId body, ShapeId, ForceFieldId) { f(world, body); }, "BodyId"};
}
template <class F> Call with_shape(const char* name, F&& f) {
    return {name, [f](World& world, BodyId, ShapeId shape, ForceFieldId) { f(world, shape); }, "ShapeId"};
}
template <class F> Call with_field(const char* name, F&& f) {
    return {name, [f](World& world, BodyId, ShapeId, ForceFieldId field) { f(world, field); }, "ForceFieldId"};
}

std::vector<Call> calls_with_handles() {
    return {
        with_body("body", [](World& w, BodyId b) { w.body(b); }),
        with_body("const body", [](const World& w, BodyId b) { w.body(b); }),
        with_body("destroy_body", [](World& w, BodyId b) { w.destroy_body(b); }),
        with_body("add_shape", [](World& w, BodyId b) { w.add_shape(b, Sphere{}); }),
        with_body("contacts", [](World& w, BodyId b) { w.contacts(b); }),
        with_body("read_transforms",
                  [](World& w, BodyId b) {
                      Transform out;
                      w.read_transforms({&b, 1}, {&out, 1});
                  }),
        with_shape("remove_shape", [](World& w, ShapeId s) { w.remove_shape(s); }),
        with_shape("body_of", [](World& w, ShapeId s) { w.body_of(s); }),
        with_shape("shape", [](World& w, ShapeId s) { w.shape(s); }),
        with_shape("shape_def", [](World& w, ShapeId s) { w.shape_def(s); }),
        with_shape("shape_transform", [](World& w, ShapeId s) { w.shape_transform(s); }),
        with_shape("shape_bounds", [](World& w, ShapeId s) { w.shape_bounds(s); }),
        with_shape("set_material", [](World& w, ShapeId s) { w.set_material(s, {}); }),
        with_field("set_force_field", [](World& w, ForceFieldId f) { w.set_force_field(f, {}); }),
        with_field("remove_force_field", [](World& w, ForceFieldId f) { w.remove_force_field(f); }),
    };
}

std::vector<std::pair<const char*, std::function<void(Body)>>> calls_of_body() {
    return {
        {"type", [](Body b) { b.type(); }},
        {"name", [](Body b) { b.name(); }},
        {"user_data", [](Body b) { b.user_data(); }},
        {"position", [](Body b) { b.position(); }},
        {"rotation", [](Body b) { b.rotation(); }},
        {"transform", [](Body b) { b.transform(); }},
        {"center_of_mass", [](Body b) { b.center_of_mass(); }},
        {"linear_velocity", [](Body b) { b.linear_velocity(); }},
        {"angular_velocity", [](Body b) { b.angular_velocity(); }},
        {"velocity_at", [](Body b) { b.velocity_at(Position(0.0)); }},
        {"mass", [](Body b) { b.mass(); }},
        {"mass_properties", [](Body b) { b.mass_properties(); }},
        {"world_inertia", [](Body b) { b.world_inertia(); }},
        {"angular_momentum", [](Body b) { b.angular_momentum(); }},
        {"kinetic_energy", [](Body b) { b.kinetic_energy(); }},
        {"gravity_scale", [](Body b) { b.gravity_scale(); }},
        {"linear_damping", [](Body b) { b.linear_damping(); }},
        {"angular_damping", [](Body b) { b.angular_damping(); }},
        {"is_awake", [](Body b) { b.is_awake(); }},
        {"shapes", [](Body b) { b.shapes(); }},
        {"set_transform", [](Body b) { b.set_transform(Position(0.0), Quat(1, 0, 0, 0)); }},
        {"set_position", [](Body b) { b.set_position(Position(0.0)); }},
        {"set_rotation", [](Body b) { b.set_rotation(Quat(1, 0, 0, 0)); }},
        {"set_linear_velocity", [](Body b) { b.set_linear_velocity(Vec3(0.0f)); }},
        {"set_angular_velocity", [](Body b) { b.set_angular_velocity(Vec3(0.0f)); }},
        {"move_to", [](Body b) { b.move_to({}, 1.0f); }},
        {"set_gravity_scale", [](Body b) { b.set_gravity_scale(1.0f); }},
        {"set_damping", [](Body b) { b.set_damping(0.0f, 0.0f); }},
        {"set_allow_sleep", [](Body b) { b.set_allow_sleep(true); }},
        {"set_type", [](Body b) { b.set_type(BodyType::static_); }},
        {"set_name", [](Body b) { b.set_name("x"); }},
        {"set_mass_properties", [](Body b) { b.set_mass_properties({}); }},
        {"set_mass_from_shapes", [](Body b) { b.set_mass_from_shapes(); }},
        {"wake", [](Body b) { b.wake(); }},
        {"add_force", [](Body b) { b.add_force(Vec3(1.0f)); }},
        {"add_force_at", [](Body b) { b.add_force_at(Vec3(1.0f), Position(0.0)); }},
        {"add_torque", [](Body b) { b.add_torque(Vec3(1.0f)); }},
        {"apply_impulse", [](Body b) { b.apply_impulse(Vec3(1.0f)); }},
        {"apply_impulse_at", [](Body b) { b.apply_impulse_at(Vec3(1.0f), Position(0.0)); }},
        {"apply_angular_impulse", [](Body b) { b.apply_angular_impulse(Vec3(1.0f)); }},
        {"set_character", [](Body b) { b.set_character({}); }},
        {"character_state", [](Body b) { b.character_state(); }},
    };
}

// Expects every call to refuse these handles of a body, a shape and a field, and to change nothing.
void expect_all_refuse(World& world, BodyId body, ShapeId shape, ForceFieldId field, const char* why) {
    const Snapshot before = world.save();
    EXPECT_FALSE(world.is_valid(body));
    EXPECT_FALSE(world.is_valid(shape));
    EXPECT_FALSE(world.is_valid(field));
    for (const Call& call : calls_with_handles()) {
        const std::string message = refusal([&] { call.call(world, body, shape, field); });
        EXPECT_EQ(message.rfind(std::string("invalid_handle | ") + call.field + " | " + call.field + ": " + why, 0), 0u)
            << call.name << ": " << message;
        EXPECT_NE(message.find(", got 0x"), std::string::npos) << call.name << ": " << message;
    }
    EXPECT_TRUE(world.save().bytes == before.bytes);
    EXPECT_EQ(world.save().definitions, before.definitions);
}

struct Stage {
    World world;
    BodyId body;
    ShapeId shape;
    ForceFieldId field;
    Stage() {
        add_ground(world);
        body = world.create_body(body_at({0.0, 0.5, 0.0}));
        shape = world.add_shape(body, Box{});
        field = world.add_force_field({});
        run(world, 5);
    }
    void remove_all() {
        world.destroy_body(body);
        world.remove_force_field(field);
    }
    // Creates the same objects again, in the slots of the removed ones if slots are reused.
    void add_again() {
        for (int i = 0; i < 3; ++i) {
            world.add_shape(world.create_body(body_at({0.0, 0.5 + i, 0.0})), Box{});
            world.add_force_field({});
        }
    }
};

TEST(Row42, StaleHandlesAreRefusedByEveryCall) {
    Stage stage;
    stage.remove_all();
    expect_all_refuse(stage.world, stage.body, stage.shape, stage.field, "is stale: the object was removed");
    stage.world.step(frame);
    expect_all_refuse(stage.world, stage.body, stage.shape, stage.field, "is stale: the object was removed");
    stage.add_again();
    stage.world.step(frame);
    expect_all_refuse(stage.world, stage.body, stage.shape, stage.field, "is stale: the object was removed");
}

TEST(Row42, StaleAccessorsAreRefusedByEveryCall) {
    Stage stage;
    const Body body = stage.world.body(stage.body);
    stage.remove_all();
    const auto expect_refusals = [&] {
        const Snapshot before = stage.world.save();
        for (const auto& [name, call] : calls_of_body()) {
            const std::string message = refusal([&call = call, &body] { call(body); });
            EXPECT_EQ(message.rfind("invalid_handle | BodyId | BodyId: is stale: the object was removed, got 0x", 0),
                      0u)
                << name << ": " << message;
        }
        EXPECT_TRUE(stage.world.save().bytes == before.bytes);
        EXPECT_EQ(stage.world.save().definitions, before.definitions);
    };
    expect_refusals();
    stage.world.step(frame);
    stage.add_again();
    expect_refusals();
    EXPECT_EQ(body.id(), stage.body) << "the handle itself can always be read";
}

TEST(Row42, ASlotIsReusedUnderAnotherHandle) {
    World world;
    std::vector<BodyId> former;
    bool reused = false;
    for (int i = 0; i < 2000; ++i) {
        const BodyId body = add_body(world, {}, Sphere{});
        for (const BodyId old : former) ASSERT_NE(old, body);
        if (!former.empty()) reused |= former.back().index() == body.index();
        former.push_back(body);
        world.destroy_body(body);
        world.step(frame);
        ASSERT_FALSE(world.is_valid(body));
    }
    EXPECT_TRUE(reused);
    EXPECT_LT(former.back().index(), 10u) << "slots of removed bodies are given out again";
}

TEST(Row42, TheNullHandleIsRefusedByEveryCall) {
    Stage stage;
    expect_all_refuse(stage.world, {}, {}, {}, "must not be null");
}

TEST(Row42, HandlesThatWereNeverGivenOutAreRefused) {
    Stage stage;
    const std::uint32_t world = stage.body.world();
    for (const std::uint32_t index : {99u, (1u << 28) - 1}) {
        expect_all_refuse(stage.world, BodyId::make(index, 1, world), ShapeId::make(index, 1, world),
                          ForceFieldId::make(index, 1, world), "is stale: the object was removed");
    }
    const std::uint32_t later = stage.body.generation() + 1;
    expect_all_refuse(stage.world, BodyId::make(stage.body.index(), later, world),
                      ShapeId::make(stage.shape.index(), later, world),
                      ForceFieldId::make(stage.field.index(), later, world), "is stale: the object was removed");
}

TEST(Row42, RefusedReadOfManyTransformsWritesNone) {
    Stage stage;
    const std::vector<BodyId> ids = {stage.body, BodyId{}};
    std::vector<Transform> out(2, {Position(7.0), Quat(1, 0, 0, 0)});
    EXPECT_THROW(stage.world.read_transforms(ids, out), Error);
    EXPECT_EQ(refusal([&] {
                  stage.world.read_transforms(ids, {out.data(), 1});
              }),
              "invalid_value | World::read_transforms out | World::read_transforms out: must have as many elements as "
              "ids (2), got 1");
    EXPECT_EQ(out[1].position, Position(7.0));
}

TEST(Row43, RemovingTwiceIsRefused) {
    Stage stage;
    stage.world.remove_shape(stage.shape);
    EXPECT_THROW(stage.world.remove_shape(stage.shape), Error);
    stage.remove_all();
    const std::uint64_t hash = stage.world.state_hash();
    EXPECT_THROW(stage.world.destroy_body(stage.body), Error);
    EXPECT_THROW(stage.world.remove_force_field(stage.field), Error);
    EXPECT_THROW(stage.world.remove_shape(stage.shape), Error);
    EXPECT_EQ(stage.world.state_hash(), hash);
    EXPECT_TRUE(stays_sane(stage.world, 10));
    EXPECT_EQ(stage.world.statistics().bodies, 1u);
    EXPECT_EQ(stage.world.statistics().shapes, 1u);
}

TEST(Row44, HandlesOfAnotherWorldAreRefusedByEveryCall) {
    Stage here, there;
    EXPECT_EQ(here.body.index(), there.body.index()) << "the same slots, so that only the world tells them apart";
    expect_all_refuse(here.world, there.body, there.shape, there.field, "must be of this world");
}

// --- row 45: there are no user callbacks inside a step or query. A user can only change the world while reading events

static_assert(std::is_trivially_copyable_v<ContactBegin> && std::is_trivially_copyable_v<ContactEnd> &&
              std::is_trivially_copyable_v<ContactHit> && std::is_trivially_copyable_v<SleepEvent> &&
              std::is_trivially_copyable_v<RayHit>);
static_assert(!std::is_polymorphic_v<World> && !std::is_polymorphic_v<Body> && !std::is_polymorphic_v<ForceField>);

TEST(Row45, WorldMayBeChangedWhileItsEventsAreRead) {
    World world;
    add_ground(world);
    std::vector<BodyId> crates;
    for (int i = 0; i < 8; ++i) crates.push_back(add_crate(world, {3.0 * i, 0.5, 0.0}));
    world.step(frame);
    ASSERT_EQ(world.contact_begins().size(), 8u);
    const auto begins = world.contact_begins();
    const std::vector<ContactBegin> copy(begins.begin(), begins.end());
    for (std::size_t i = 0; i < begins.size(); ++i) {
        const BodyId body = begins[i].body_a;
        ASSERT_TRUE(world.is_valid(body)) << "what was read before must still stand here";
        switch (i % 4) {
        case 0:
            world.destroy_body(body);
            break;
        case 1:
            world.body(body).set_type(BodyType::kinematic);
            break;
        case 2:
            world.remove_shape(begins[i].shape_a);
            break;
        case 3:
            add_crate(world, {3.0 * double(i), 5.0, 0.0});
            break;
        }
        world.cast_ray({0.0, 5.0, 0.0}, {0.0f, -1.0f, 0.0f}, 10.0);
    }
    EXPECT_EQ(world.contact_begins().size(), copy.size());
    for (std::size_t i = 0; i < copy.size(); ++i) EXPECT_EQ(world.contact_begins()[i].shape_a, copy[i].shape_a);
    EXPECT_TRUE(stays_sane(world, 60));
}

TEST(Row45, EventsOfAStepChangeInNoCallBetweenSteps) {
    World world;
    add_ground(world);
    std::vector<BodyId> crates;
    for (int i = 0; i < 8; ++i) crates.push_back(add_crate(world, {3.0 * i, 0.5, 0.0}));
    run(world, 10);
    ASSERT_EQ(world.contact_ends().size(), 0u);
    world.body(crates[0]).set_type(BodyType::kinematic);
    world.body(crates[1]).set_position({3.0, 50.0, 0.0});
    world.destroy_body(crates[2]);
    EXPECT_EQ(world.contact_begins().size(), 0u);
    EXPECT_EQ(world.contact_ends().size(), 0u) << "contacts end in the next step";
    world.step(frame);
    EXPECT_EQ(world.contact_ends().size(), 3u);
}

// --- row 48

// A step of a crowd takes much longer than its threads take to start, so the other thread's call comes during the step.
TEST(Row48, CallsFromAnotherThreadDuringAStepAreRefused) {
    World world(WorldDef{});
    for (int i = 0; i < 500; ++i) {
        BodyDef def;
        def.position = {1e-3 * i, 0, 0};
        world.add_shape(world.create_body(def), Sphere{});
    }
    const BodyId first = world.bodies().front();
    std::atomic<bool> begun = false, done = false;
    std::thread stepper([&] {
        begun = true;
        world.step(1.0f / 60);
        done = true;
    });
    while (!begun) std::this_thread::yield();
    std::this_thread::sleep_for(std::chrono::milliseconds(30));
    int refused = 0;
    const auto expect_refused = [&](const auto& call) {
        try {
            call();
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ErrorCode::wrong_state);
            EXPECT_NE(std::string(error.what()).find("while a step"), std::string::npos) << error.what();
            ++refused;
        }
    };
    EXPECT_FALSE(done) << "the step was too quick for this test";
    expect_refused([&] { world.create_body(); });
    expect_refused([&] { world.destroy_body(first); });
    expect_refused([&] { world.step(1.0f / 60); });
    expect_refused([&] { world.save(); });
    expect_refused([&] { world.set_settings({}); });
    EXPECT_EQ(refused, 5);
    stepper.join();
    EXPECT_EQ(world.bodies().size(), 500u);
    EXPECT_EQ(world.step_count(), 1u);
}

// --- row 46

TEST(Row46, HandlesOutliveTheirWorldAsPlainValues) {
    BodyId body;
    ShapeId shape;
    ForceFieldId field;
    {
        Stage stage;
        body = stage.body;
        shape = stage.shape;
        field = stage.field;
        EXPECT_TRUE(stage.world.is_valid(body));
    }
    EXPECT_FALSE(body.is_null());
    for (int i = 0; i < 100; ++i) {
        Stage other;
        ASSERT_FALSE(other.world.is_valid(body));
        ASSERT_FALSE(other.world.is_valid(shape));
        ASSERT_FALSE(other.world.is_valid(field));
    }
    Stage last;
    expect_all_refuse(last.world, body, shape, field, "must be of this world");
}

TEST(Row46, WorldsOutliveTheirPlacesByMoving) {
    Stage stage;
    const std::uint64_t hash = stage.world.state_hash();
    World moved = std::move(stage.world);
    EXPECT_TRUE(moved.is_valid(stage.body));
    EXPECT_EQ(moved.state_hash(), hash);
    World other;
    const BodyId gone = add_crate(other, {});
    other = std::move(moved);
    EXPECT_TRUE(other.is_valid(stage.body));
    EXPECT_FALSE(other.is_valid(gone));
    EXPECT_TRUE(stays_sane(other, 10));
}

// Without a check, each of these calls read through a null pointer.
TEST(Row46, WorldsThatWereMovedFromRefuseEveryCall) {
    Stage stage;
    Body body = stage.world.body(stage.body);
    World moved = std::move(stage.world);
    World& gone = stage.world; // NOLINT(bugprone-use-after-move): use after move is what is tested
    EXPECT_FALSE(gone.is_valid(stage.body) || gone.is_valid(stage.shape) || gone.is_valid(stage.field));
    EXPECT_FALSE(gone.is_valid(JointId{}));
    const std::vector<std::function<void()>> calls{
        [&] { gone.step(frame); },
        [&] { gone.create_body(); },
        [&] { gone.destroy_body(stage.body); },
        [&] { gone.add_shape(stage.body, Sphere{}); },
        [&] { gone.body(stage.body); },
        [&] { gone.bodies(); },
        [&] { gone.find_body("crate"); },
        [&] { gone.settings(); },
        [&] { gone.set_settings({}); },
        [&] { gone.threads(); },
        [&] { gone.set_threads(2); },
        [&] { gone.step_count(); },
        [&] { gone.time(); },
        [&] { gone.contact_begins(); },
        [&] { gone.contact_ends(); },
        [&] { gone.contact_hits(); },
        [&] { gone.trigger_events(); },
        [&] { gone.joint_events(); },
        [&] { gone.sleep_events(); },
        [&] { gone.contacts(); },
        [&] {
            gone.cast_ray({0.0, 5.0, 0.0}, {0.0f, -1.0f, 0.0f}, 10.0);
        },
        [&] { gone.overlap(Sphere{}, {}); },
        [&] {
            gone.closest_point({0.0, 0.0, 0.0}, 1.0);
        },
        [&] { gone.create_joint({}); },
        [&] { gone.statistics(); },
        [&] { gone.kinetic_energy(); },
        [&] { gone.state_hash(); },
        [&] { gone.save(); },
        [&] { gone.restore(moved.save()); },
        [&] { body.position(); },
        [&] {
            body.set_linear_velocity({1.0f, 0.0f, 0.0f});
        },
    };
    for (std::size_t i = 0; i < calls.size(); ++i) {
        EXPECT_EQ(refusal(calls[i]),
                  "wrong_state | World | World: was moved from, and may only be destroyed or assigned "
                  "to; use the world that it was moved to")
            << i;
    }
    gone = World();
    EXPECT_EQ(gone.bodies().size(), 0u);
    EXPECT_TRUE(stays_sane(moved, 10));
}

// When only steps freed slots, each body that was created and destroyed between steps took 610 bytes.
TEST(Row43, BodiesThatComeAndGoBetweenStepsTakeNoMoreMemory) {
    World world;
    add_ground(world);
    std::vector<BodyId> pile;
    for (int i = 0; i < 20; ++i) pile.push_back(add_crate(world, {2.0 * i, 0.5, 0.0}));
    run(world, 30);
    World other;
    other.restore(world.save());
    const std::size_t contacts = world.statistics().contacts;
    ASSERT_EQ(contacts, 20u);
    std::uint32_t greatest = 0;
    for (int i = 0; i < 100'000; ++i) {
        const BodyId body = add_crate(world, {2.0 * (i % 50), 5.0, 3.0 + i % 7});
        const ShapeId shape = world.body(body).shapes()[0];
        world.body(body).add_force({1.0f, 0.0f, 0.0f});
        greatest = std::max({greatest, body.index(), shape.index()});
        if (i % 3 == 0) world.remove_shape(shape);
        world.destroy_body(body);
        ASSERT_FALSE(world.is_valid(body));
    }
    EXPECT_LT(greatest, 2000u);
    for (int i = 0; i < 100'000; ++i) { // shapes of a body that remains
        const ShapeId shape = world.add_shape(pile[0], Sphere{0.1f});
        greatest = std::max(greatest, shape.index());
        world.remove_shape(shape);
    }
    EXPECT_LT(greatest, 2000u);
    EXPECT_TRUE(world.contact_begins().empty() && world.contact_ends().empty());
    for (int i = 0; i < 30; ++i) {
        world.step(frame);
        other.step(frame);
        ASSERT_TRUE(world.contact_begins().empty() && world.contact_ends().empty()) << "the contacts of others go on";
    }
    EXPECT_EQ(world.statistics().contacts, contacts);
    for (std::size_t i = 1; i < pile.size(); ++i)
        EXPECT_EQ(world.body(pile[i]).position(), other.body(pile[i]).position());
}

TEST(Row46, WorldsDestroyedInAnyOrderLeaveTheOthersAlone) {
    std::vector<World> worlds;
    std::vector<BodyId> bodies;
    for (int i = 0; i < 20; ++i) {
        worlds.emplace_back();
        add_ground(worlds.back());
        bodies.push_back(add_crate(worlds.back(), {0.0, 2.0, 0.0}));
    }
    for (int i = 0; i < 10; ++i) {
        worlds.erase(worlds.begin() + i);
        bodies.erase(bodies.begin() + i);
        for (std::size_t k = 0; k < worlds.size(); ++k) {
            worlds[k].step(frame);
            ASSERT_EQ(worlds[k].body(bodies[k]).position(), worlds[0].body(bodies[0]).position());
        }
    }
}

} // namespace
} // namespace cairn::test
