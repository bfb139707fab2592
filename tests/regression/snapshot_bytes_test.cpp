// Snapshots of equal worlds are equal bytes. Without clearing, the padding of joint definitions, their empty optionals,
// events and statistics contained whatever memory held, as did the time that the last step took.
#include <cairn/cairn.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <new>
#include <type_traits>
#include <variant>
#include <vector>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace cairn {
namespace {

// While an object of this class exists, newly allocated memory is filled with the given byte (with glibc; 0 ends this).
class FilledMemory {
  public:
    explicit FilledMemory([[maybe_unused]] std::uint8_t fill) {
#ifdef __GLIBC__
        mallopt(M_PERTURB, fill ^ 0xff);
#endif
    }
    ~FilledMemory() {
#ifdef __GLIBC__
        mallopt(M_PERTURB, 0);
#endif
    }
    FilledMemory(const FilledMemory&) = delete;
    FilledMemory& operator=(const FilledMemory&) = delete;
};

// A value constructed in memory whose bytes were all `fill`.
template <class T> class On {
  public:
    explicit On(std::uint8_t fill) {
        std::memset(memory_, fill, sizeof memory_);
        value_ = new (memory_) T;
    }
    ~On() { value_->~T(); }
    On(const On&) = delete;
    On& operator=(const On&) = delete;
    T* operator->() { return value_; }
    T& operator*() { return *value_; }

  private:
    alignas(T) std::byte memory_[sizeof(T)];
    T* value_;
};

// Adds one joint of each type. Optional members are set in some of them, and empty in most.
template <std::size_t I = 0> void add_joints(World& world, std::uint8_t fill) {
    if constexpr (I < std::variant_size_v<Joint>) {
        BodyDef at;
        at.type = BodyType::dynamic;
        at.position = {3.0 * double(I), 5.0, 0.0};
        const BodyId a = world.create_body(at), b = world.create_body(at);
        world.add_shape(a, Sphere{0.4f});
        world.add_shape(b, Sphere{0.4f});
        On<JointDef> def(fill);
        def->body_a = a, def->body_b = b;
        On<std::variant_alternative_t<I, Joint>> joint(fill);
        using T = std::variant_alternative_t<I, Joint>;
        if constexpr (std::is_same_v<T, GeneralJoint>) {
            On<JointLimit> limit(fill);
            limit->axes = {true, true, true}, limit->min = 0.0f, limit->max = 0.0f;
            On<JointDrive> drive(fill);
            drive->kind = JointAxis::angular, drive->damping = 1.0f;
            joint->limits.push_back(*limit), joint->drives.push_back(*drive);
        }
        if constexpr (std::is_same_v<T, PulleyJoint>) joint->ground_a = joint->ground_b = {at.position.x, 9.0, 0.0};
        if constexpr (std::is_same_v<T, HingeJoint>) {
            On<JointRange> range(fill);
            range->lower = -1.0f, range->upper = 1.0f;
            On<JointMotor> motor(fill);
            motor->velocity = 0.5f;
            joint->angle.limits = *range, joint->angle.motor = *motor;
        }
        def->joint.template emplace<I>(*joint);
        world.create_joint(*def);
        add_joints<I + 1>(world, fill);
    }
}

// Saves a world after actions that leave events for the next step. The snapshots must not depend on `fill`.
Snapshot saved_on(std::uint8_t fill, World& world, const Snapshot& empty) {
    const FilledMemory memory(fill);
    world.restore(empty);
    On<BodyDef> ground(fill);
    ground->type = BodyType::static_;
    world.add_shape(world.create_body(*ground), Plane{}, *On<ShapeDef>(fill));
    On<ShapeDef> trigger(fill);
    trigger->is_trigger = true;
    world.add_shape(world.create_body(*ground), Box{{50.0f, 20.0f, 50.0f}}, *trigger);
    On<BodyDef> sleeper(fill);
    sleeper->position = {-5.0, 0.5, 0.0};
    world.add_shape(world.create_body(*sleeper), Box{{0.5f, 0.5f, 0.5f}}, *On<ShapeDef>(fill));
    add_joints(world, fill);
    for (int i = 0; i < 120; ++i) world.step(1.0f / 60);
    const std::vector<BodyId> bodies = world.bodies();
    EXPECT_FALSE(world.body(bodies[2]).is_awake());
    world.body(bodies[2]).wake();      // a sleep event
    world.destroy_body(bodies.back()); // events of a joint and of a trigger
    return world.save();
}

TEST(SnapshotBytes, OfEqualWorldsAreEqualWhateverMemoryHeld) {
    World world;
    const Snapshot empty = world.save();
    const Snapshot zeros = saved_on(0x00, world, empty), ones = saved_on(0xff, world, empty),
                   other = saved_on(0x5a, world, empty);
    EXPECT_TRUE(zeros.definitions->bytes == ones.definitions->bytes);
    EXPECT_TRUE(zeros.definitions->bytes == other.definitions->bytes);
    EXPECT_TRUE(zeros.bytes == ones.bytes);
    EXPECT_TRUE(zeros.bytes == other.bytes);
}

} // namespace
} // namespace cairn
