// Fuzzes World::restore: a snapshot of a small world, changed as the bytes say, is refused and leaves the world as it
// was, or is the snapshot that it was before. The first byte chooses between that, bytes that are a snapshot as they
// stand, and a change whose checksum was made to fit: that may be taken, but what is refused has changed nothing.
#include "world/snapshot_header.h"

#include <cairn/cairn.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>

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
    world.step(1.0f / 60);
    return world;
}

// Three bytes each: where (of 65,536 parts of the whole), and what to change there; or where it ends.
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

// In place of the state of the same bodies.
void restore_forged(const Snapshot& saved, const std::uint8_t* data, std::size_t size) {
    Snapshot forged = saved;
    damage(forged.bytes, data, size);
    if (forged.bytes.size() < sizeof(SnapshotHeader)) return;
    fit_checksum(forged.bytes);
    static World world = small_world();
    world.restore(saved);
    world.step(1.0f / 60);
    const Snapshot before = world.save();
    try {
        world.restore(forged);
    } catch (const Error&) {
        if (world.save().bytes != before.bytes) fail("a refused snapshot has changed the world");
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const Snapshot saved = small_world().save();
    if (size == 0) return 0;
    if (data[0] == 'f') {
        restore_forged(saved, data + 1, size - 1);
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
