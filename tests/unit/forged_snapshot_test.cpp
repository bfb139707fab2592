// Snapshots that were changed, and their checksum with them.
#include "world/snapshot_header.h"

#include <cairn/cairn.h>

#include <gtest/gtest.h>

#include <cstring>

namespace cairn {
namespace {

struct ForgedSnapshot : testing::Test {
    World world;
    Snapshot saved, before;
    void SetUp() override {
        BodyDef def;
        def.type = BodyType::static_;
        world.add_shape(world.create_body(def), Plane{});
        def.type = BodyType::dynamic;
        BodyId last;
        for (int i = 0; i < 4; ++i) {
            def.position = {0.1 * i, 0.5 + 1.1 * i, 0.0};
            const BodyId body = world.create_body(def);
            world.add_shape(body, Box{});
            if (i > 1) world.create_joint(world.joint_at(last, body, def.position, {0, 1, 0}, HingeJoint{}));
            last = body;
        }
        for (int i = 0; i < 30; ++i) world.step(1.0f / 60);
        saved = world.save();
        world.step(1.0f / 60);
        before = world.save();
    }
    void fit_checksum(Snapshot& snapshot) const {
        SnapshotHeader header;
        std::memcpy(&header, snapshot.bytes.data(), sizeof header);
        header.checksum = checksum_of(header, snapshot.bytes);
        std::memcpy(snapshot.bytes.data(), &header, sizeof header);
    }
    // In place: the world has the definitions of the snapshot. Whether it was refused.
    bool is_refused(Snapshot& forged) {
        fit_checksum(forged);
        try {
            world.restore(forged);
            return false;
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ErrorCode::invalid_file);
        }
        EXPECT_EQ(world.save().bytes, before.bytes) << "the world is as it was"; // throws if it refuses everything
        return true;
    }
};

TEST_F(ForgedSnapshot, CutOffAnywhereLeavesTheWorldAsItWas) {
    for (std::size_t size = sizeof(SnapshotHeader); size < saved.bytes.size(); ++size) {
        Snapshot cut{{saved.bytes.begin(), saved.bytes.begin() + std::ptrdiff_t(size)}, saved.definitions};
        ASSERT_TRUE(is_refused(cut)) << "cut to " << size << " of " << saved.bytes.size();
    }
    world.restore(saved);
    world.step(1.0f / 60);
    EXPECT_EQ(world.save().bytes, before.bytes);
}

TEST_F(ForgedSnapshot, WhatIsRefusedForAnyByteLeavesTheWorldAsItWas) {
    int refused = 0;
    for (std::size_t at = sizeof(SnapshotHeader); at < saved.bytes.size(); ++at) {
        Snapshot changed = saved;
        changed.bytes[at] ^= std::byte{0x55};
        refused += is_refused(changed);
        world.restore(before);
    }
    EXPECT_GT(refused, 100);
}

TEST_F(ForgedSnapshot, WithBytesBehindItsEndIsRefused) {
    Snapshot longer = saved;
    longer.bytes.resize(longer.bytes.size() + 8);
    EXPECT_TRUE(is_refused(longer));
    World other;
    const std::uint64_t empty = other.state_hash();
    EXPECT_THROW(other.restore(longer), Error);
    EXPECT_EQ(other.state_hash(), empty);
}

} // namespace
} // namespace cairn
