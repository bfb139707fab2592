// Random calls of the API, legal and not, with what must hold after each step.
#include "test_world.h"

#include <algorithm>
#include <random>
#include <vector>

namespace cairn::test {
namespace {

class Caller {
  public:
    explicit Caller(unsigned seed)
        : random_(seed), ground_(add_ground(world_)), ground_shape_(world_.body(ground_).shapes()[0]) {}

    void call() {
        switch (pick(24)) {
        case 0:
        case 1:
        case 2:
        case 3:
            create();
            break;
        case 4:
            if (live_.size() > 3) destroy();
            break;
        case 5:
            mobile([&](Body b) { b.set_linear_velocity(vector(10.0f)); });
            break;
        case 6:
            mobile([&](Body b) { b.set_angular_velocity(vector(10.0f)); });
            break;
        case 7:
            body().set_position(place());
            break;
        case 8:
            body().set_transform(place(), Quat(1.0f, unit(), unit(), unit()));
            break;
        case 9:
            dynamic([&](Body b) { b.apply_impulse_at(vector(b.mass()), b.position() + 0.1); });
            break;
        case 10:
            dynamic([&](Body b) { b.add_force(vector(20 * b.mass())); });
            break;
        case 11:
            dynamic([&](Body b) { b.add_torque(vector(b.mass())); });
            break;
        case 12:
            add_shape();
            break;
        case 13:
            remove_shape();
            break;
        case 14:
            set_type();
            break;
        case 15:
            set_material();
            break;
        case 16:
            change_fields();
            break;
        case 17:
            change_settings();
            break;
        case 18:
            body().wake();
            break;
        case 19:
            dynamic([&](Body b) {
                b.set_mass_from_shapes(pick(2) ? std::optional<float>(1.0f + 50 * std::fabs(unit())) : std::nullopt);
            });
            break;
        case 20:
            query();
            break;
        case 21:
            save_and_restore();
            break;
        case 22:
            call_wrongly();
            break;
        case 23:
            kinematic([&](Body b) { b.move_to({place(), Quat(1.0f, unit(), unit(), unit())}, 0.5f); });
            break;
        }
    }

    testing::AssertionResult step() {
        world_.step(pick(10) ? frame : 1.0f / 120);
        if (const auto sane = is_sane(world_); !sane) return sane;
        std::vector<BodyId> expected = live_;
        std::sort(expected.begin(), expected.end(), [](BodyId a, BodyId b) { return a.index() < b.index(); });
        std::vector<BodyId> bodies = world_.bodies();
        bodies.erase(std::remove(bodies.begin(), bodies.end(), ground_), bodies.end());
        if (bodies != expected) return testing::AssertionFailure() << "bodies() is not what was made and not removed";
        for (const BodyId body : dead_)
            if (world_.is_valid(body)) return testing::AssertionFailure() << "a stale handle is valid";
        for (const Contact& contact : world_.contacts())
            if (!world_.is_valid(contact.shape_a) || !world_.is_valid(contact.body_b))
                return testing::AssertionFailure() << "a contact of what is gone";
        if (world_.statistics().shapes != shape_count()) return testing::AssertionFailure() << "number of shapes";
        return testing::AssertionSuccess();
    }

    const World& world() const { return world_; }

  private:
    int pick(int n) { return std::uniform_int_distribution<int>(0, n - 1)(random_); }
    float unit() { return std::uniform_real_distribution<float>(-1.0f, 1.0f)(random_); }
    Vec3 vector(float size) { return size * Vec3(unit(), unit(), unit()); }
    Position place() { return {3.0 * unit(), 3.0 + 3.0 * unit(), 3.0 * unit()}; }
    Shape shape() {
        const auto size = [&] { return 0.1f + 0.4f * std::fabs(unit()); };
        if (pick(2)) return Sphere{size()};
        return Box{{size(), size(), size()}};
    }
    Body body() {
        return live_.empty() ? world_.body(ground_) : world_.body(live_[std::size_t(pick(int(live_.size())))]);
    }
    template <class F> void dynamic(F&& f) {
        if (Body b = body(); b.type() == BodyType::dynamic) f(b);
    }
    template <class F> void mobile(F&& f) {
        if (Body b = body(); b.type() != BodyType::static_) f(b);
    }
    template <class F> void kinematic(F&& f) {
        if (Body b = body(); b.type() == BodyType::kinematic) f(b);
    }
    std::size_t shape_count() const {
        std::size_t count = 0;
        for (const BodyId b : world_.bodies()) count += world_.body(b).shapes().size();
        return count;
    }

    void create() {
        if (live_.size() > 60) return destroy();
        BodyDef def = body_at(place(), BodyType(pick(8) ? 2 : pick(3)));
        def.rotation = Quat(1.0f, unit(), unit(), unit());
        def.linear_velocity = vector(5.0f);
        def.allow_sleep = pick(5) != 0;
        const BodyId body = world_.create_body(def);
        live_.push_back(body);
        for (int i = pick(3); i >= 0; --i) add_shape_to(body);
    }
    void destroy() {
        const std::size_t i = std::size_t(pick(int(live_.size())));
        world_.destroy_body(live_[i]);
        dead_.push_back(live_[i]);
        live_.erase(live_.begin() + std::ptrdiff_t(i));
    }
    void add_shape_to(BodyId body) {
        ShapeDef def = shape_at(vector(0.3f));
        def.rotation = Quat(1.0f, unit(), unit(), unit());
        world_.add_shape(body, shape(), def);
    }
    void add_shape() {
        const Body b = body();
        if (b.shapes().size() < 6) add_shape_to(b.id());
    }
    void remove_shape() {
        const auto shapes = body().shapes();
        if (!shapes.empty() && shapes[0] != ground_shape_)
            world_.remove_shape(shapes[std::size_t(pick(int(shapes.size())))]);
    }
    void set_type() {
        Body b = body();
        if (b.id() == ground_) return;
        b.set_type(BodyType(pick(3)));
        if (b.type() == BodyType::kinematic) b.set_linear_velocity(vector(1.0f));
    }
    void set_material() {
        const auto shapes = body().shapes();
        if (shapes.empty()) return;
        Material material;
        material.static_friction = material.dynamic_friction = std::fabs(unit());
        material.restitution = 0.5f * std::fabs(unit());
        material.rolling_friction = material.torsional_friction = pick(2) ? 0.02f : 0.0f;
        world_.set_material(shapes[0], material);
    }
    void change_fields() {
        if (fields_.size() > 2) {
            world_.remove_force_field(fields_.back());
            fields_.pop_back();
            return;
        }
        ForceField field;
        field.kind = pick(2) ? ForceField::Kind::radial : ForceField::Kind::uniform;
        field.direction = vector(1.0f);
        field.strength = unit();
        field.exponent = float(pick(4) - 2);
        fields_.push_back(world_.add_force_field(field));
    }
    void change_settings() {
        WorldDef def;
        def.gravity = {unit(), -9.81f, unit()};
        def.substeps = 1 + pick(12);
        def.adaptive_substeps = pick(2) == 0;
        def.enable_sleep = pick(4) != 0;
        def.integrator = Integrator(pick(3));
        world_.set_settings(def);
    }
    void query() {
        (void)world_.cast_ray_all(place(), vector(1.0f) + Vec3(0.0f, 0.001f, 0.0f), 10.0);
        for (const ShapeId s : world_.overlap(shape(), {place(), Quat(1, 0, 0, 0)})) ASSERT_TRUE(world_.is_valid(s));
        const Position p = place();
        for (const ShapeId s : world_.overlap_bounds({p, p + 1.0})) ASSERT_TRUE(world_.is_valid(s));
    }
    void save_and_restore() {
        const std::uint64_t hash = world_.state_hash();
        const Snapshot snapshot = world_.save();
        if (pick(2)) world_ = World();
        world_.restore(snapshot);
        ASSERT_EQ(world_.state_hash(), hash);
    }
    void call_wrongly() {
        const std::uint64_t hash = world_.state_hash();
        EXPECT_THROW(world_.step(-1.0f), Error);
        EXPECT_THROW(body().set_position(Position(double(not_a_number))), Error);
        EXPECT_THROW(world_.add_shape(ground_, Sphere{-1.0f}), Error);
        if (!dead_.empty()) {
            EXPECT_THROW(world_.destroy_body(dead_[std::size_t(pick(int(dead_.size())))]), Error);
        }
        EXPECT_EQ(world_.state_hash(), hash);
    }

    std::mt19937 random_;
    World world_;
    BodyId ground_;
    ShapeId ground_shape_;
    std::vector<BodyId> live_, dead_;
    std::vector<ForceFieldId> fields_;
};

class RandomCalls : public testing::TestWithParam<unsigned> {};

TEST_P(RandomCalls, TenThousandLeaveTheWorldSane) {
    Caller caller(GetParam());
    for (int i = 0; i < 10000; ++i) {
        caller.call();
        if (testing::Test::HasFailure()) FAIL() << "call " << i;
        if (i % 5 == 0) {
            ASSERT_TRUE(caller.step()) << "call " << i;
        }
    }
    EXPECT_EQ(caller.world().step_count(), 2000u);
}

TEST_P(RandomCalls, SameCallsGiveTheSameWorld) {
    Caller first(GetParam()), second(GetParam());
    for (int i = 0; i < 2000; ++i) {
        first.call();
        second.call();
        if (i % 5) continue;
        ASSERT_TRUE(first.step());
        ASSERT_TRUE(second.step());
        ASSERT_EQ(first.world().state_hash(), second.world().state_hash()) << "call " << i;
    }
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomCalls, testing::Values(1u, 2u, 3u, 4u));

} // namespace
} // namespace cairn::test
