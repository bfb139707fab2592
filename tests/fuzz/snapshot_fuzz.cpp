// Fuzzes World::restore: a modified snapshot of a small world is rejected and leaves the world unchanged, or equals the
// original snapshot. The first byte selects between this, bytes that are used as a snapshot directly, and a
// modification with a matching checksum ('f': of the state, restored in place; 'n': of the state, in a new world; 'd':
// of the definitions). A snapshot with a matching checksum may be accepted, and then the world must continue without
// crashing; if it is rejected, nothing changes.
#include "world/snapshot_header.h"

#include <cairn/cairn.h>

#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>

namespace {

using namespace cairn;

World small_world() {
    World world;
    BodyDef def;
    def.type = BodyType::static_;
    world.add_shape(world.create_body(def), Plane{});
    def.type = BodyType::dynamic;
    BodyId last;
    for (int i = 0; i < 3; ++i) {
        def.position = {0, 0.5 + 1.1 * i, 0};
        const BodyId body = world.create_body(def);
        world.add_shape(body, Box{});
        if (i > 0) world.create_joint(world.joint_at(last, body, def.position, {0, 1, 0}, HingeJoint{}));
        last = body;
    }
    for (int i = 0; i < 2; ++i) { // one body that sleeps, and one on a mesh
        def.position = {20.0 * (i + 1), 0.5, 0};
        if (i == 1) {
            BodyDef ground;
            ground.type = BodyType::static_;
            ground.position = {40, -0.05, 0};
            const std::vector<Vec3> corners = {{-3, 0, -3}, {3, 0, -3}, {3, 0, 3}, {-3, 0, 3}};
            const std::vector<std::uint32_t> triangles = {0, 2, 1, 0, 3, 2};
            world.add_shape(world.create_body(ground), Mesh(corners, triangles));
        }
        world.add_shape(world.create_body(def), Box{});
    }
    for (int i = 0; i < 40; ++i) {
        if (i < 39) world.body(last).set_angular_velocity({0, 0.5f, 0}); // keeps it awake
        world.step(1.0f / 60);
    }
    world.destroy_body(world.create_body(def));
    return world;
}

// Uses every part of the state, wherever its values lead.
void use_all_state(World& world) {
    const std::vector<BodyId> bodies = world.bodies();
    for (int i = 0; i < 3; ++i) world.step(1.0f / 60);
    (void)world.contacts();
    (void)world.cast_ray({0, 10, 0}, {0, -1, 0}, 100);
    for (const BodyId body : bodies) {
        if (!world.is_valid(body)) continue;
        (void)world.joints(body), (void)world.body(body).shapes(), (void)world.body(body).position();
    }
    for (const JointId joint : world.joints()) (void)world.joint_state(joint);
    if (!bodies.empty() && world.body(bodies.back()).type() == BodyType::dynamic) world.body(bodies.back()).wake();
    if (bodies.size() > 1) world.destroy_body(bodies[1]);
    BodyDef def;
    def.position = {0, 3, 0};
    world.add_shape(world.create_body(def), Capsule{});
    for (int i = 0; i < 2; ++i) world.step(1.0f / 60);
    for (const BodyId body : world.bodies()) world.destroy_body(body);
    world.step(1.0f / 60);
}

// Each modification has three bytes: its position (in units of 1/65,536 of the whole), and the change; or the position
// at which the data are truncated.
void damage(std::vector<std::byte>& bytes, const std::uint8_t* data, std::size_t size) {
    for (; size >= 3 && !bytes.empty(); data += 3, size -= 3) {
        const std::size_t at = (std::size_t(data[0]) * 256 + data[1]) * bytes.size() / 65536;
        if (data[2] == 255)
            bytes.resize(at);
        else
            bytes[at] ^= std::byte(data[2]);
    }
}

[[noreturn]] void fail(const char* what) {
    std::fprintf(stderr, "%s\n", what);
    std::abort();
}

void fit_checksum(std::vector<std::byte>& bytes) {
    SnapshotHeader header;
    std::memcpy(&header, bytes.data(), sizeof header);
    header.checksum = checksum_of(header, bytes);
    std::memcpy(bytes.data(), &header, sizeof header);
}

void restore_forged(char which, const Snapshot& saved, const std::uint8_t* data, std::size_t size) {
    Snapshot forged = saved;
    if (which == 'd') {
        auto definitions = std::make_shared<SnapshotDefinitions>(*saved.definitions);
        damage(definitions->bytes, data, size);
        const std::uint64_t value = hash_of(definitions->bytes);
        std::memcpy(forged.bytes.data() + offsetof(SnapshotHeader, definitions), &value, sizeof value);
        forged.definitions = std::move(definitions);
    } else {
        damage(forged.bytes, data, size);
    }
    if (forged.bytes.size() < sizeof(SnapshotHeader)) return;
    fit_checksum(forged.bytes);
    World world;
    if (which == 'f') world.restore(saved);
    const Snapshot before = world.save();
    try {
        world.restore(forged);
    } catch (const Error&) {
        if (world.save().bytes != before.bytes) fail("a refused snapshot has changed the world");
        return;
    }
    use_all_state(world);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const Snapshot saved = small_world().save();
    if (size == 0) return 0;
    if (data[0] == 'f' || data[0] == 'n' || data[0] == 'd') {
        restore_forged(char(data[0]), saved, data + 1, size - 1);
        return 0;
    }
    Snapshot changed = saved;
    if (data[0] & 1) {
        damage(changed.bytes, data + 1, size - 1);
    } else {
        changed.bytes.resize(size - 1);
        if (size > 1) std::memcpy(changed.bytes.data(), data + 1, size - 1);
    }
    World world;
    world.create_body();
    const std::uint64_t before = world.state_hash();
    try {
        world.restore(changed);
        if (changed.bytes != saved.bytes) fail("a damaged snapshot was restored");
    } catch (const Error&) {
        if (changed.bytes == saved.bytes) fail("a whole snapshot was refused");
        if (world.state_hash() != before) fail("a refused snapshot has changed the world");
    }
    world.step(1.0f / 60);
    return 0;
}
