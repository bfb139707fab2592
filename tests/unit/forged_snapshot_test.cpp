// Modified snapshots with a matching checksum.
#include "core/archive.h"
#include "shapes/geometry.h"
#include "world/snapshot_header.h"
#include "world/state_archive.h"

#include <cairn/cairn.h>

#include <gtest/gtest.h>

#include <cstring>
#include <functional>
#include <limits>

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
    // The snapshot with its state modified: well-formed, with arbitrary values.
    Snapshot forge(const std::function<void(State&)>& change) const {
        State state;
        for (const Shape& shape : saved.definitions->shapes) state.shapes.geometry.push_back(make_geometry(shape, {}));
        state.joints.info.resize(2), state.joints.axes.resize(2);
        ArchiveReader reader(saved.bytes.data() + sizeof(SnapshotHeader), saved.bytes.size() - sizeof(SnapshotHeader));
        serialize_state(reader, state, [](StatePart) {});
        change(state);
        Snapshot forged = saved;
        forged.bytes.resize(sizeof(SnapshotHeader));
        ArchiveWriter writer(forged.bytes);
        serialize_state(writer, state, [](StatePart) {});
        return forged;
    }
    // Steps, queries, changes and removes: uses everything that a state's numbers may lead to.
    static void use_all_state(World& world) {
        for (int i = 0; i < 3; ++i) world.step(1.0f / 60);
        (void)world.contacts();
        (void)world.cast_ray({0, 10, 0}, {0, -1, 0}, 100);
        for (const BodyId body : world.bodies()) (void)world.joints(body), (void)world.body(body).shapes();
        for (const JointId joint : world.joints()) (void)world.joint_state(joint);
        for (const BodyId body : world.bodies()) {
            world.destroy_body(body);
            world.step(1.0f / 60);
        }
    }
    // Restores the snapshot into a world that has the same definitions. Returns whether it was rejected.
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

// Without the fix each of these snapshots was accepted, and the next step used the invalid value.
TEST_F(ForgedSnapshot, OfSoundStructureWithNumbersThatLeadNowhereIsRefused) {
    const std::function<void(State&)> changes[] = {
        [](State& s) { s.bodies.motion.pop_back(); },
        [](State& s) { s.bodies.counted.resize(1000); },
        [](State& s) { s.bodies.links[1].island = 1 << 20; },
        [](State& s) { s.bodies.links[1].first_shape = 1 << 20; },
        [](State& s) { s.bodies.links[1].next_in_island = 1; },
        [](State& s) { s.bodies.links[1].first_joint = 1 << 20; },
        [](State& s) { s.bodies.links[1].contact_count = 0; },
        [](State& s) { s.bodies.links[1].inner_radius = -1; },
        [](State& s) { s.bodies.pushed = {1 << 20}; },
        [](State& s) { s.bodies.motion[1].x.x = std::numeric_limits<double>::quiet_NaN(); },
        [](State& s) { s.shapes.links[1].body = -1; },
        [](State& s) { s.shapes.links[1].next = 1; },
        [](State& s) { s.shapes.links.clear(); },
        [](State& s) { s.islands.awake = {1 << 20}; },
        [](State& s) { s.islands.free = {0}; },
        [](State& s) { s.islands.falling_asleep = {1 << 20}; },
        [](State& s) { s.islands.sleep_requests = {1 << 20}; },
        [](State& s) { s.islands.all[std::size_t(s.bodies.links[1].island)].first_body = 1 << 20; },
        [](State& s) { s.islands.all[std::size_t(s.bodies.links[1].island)].body_count = 0; },
        [](State& s) { s.islands.all[std::size_t(s.bodies.links[1].island)].joint_count = 0; },
        [](State& s) { s.contacts.free = {1 << 20}; },
        [](State& s) { s.contacts.free = {0}; },
        [](State& s) { s.contacts.records.whole().clear(); },
        [](State& s) { s.contacts.info[0].body_b = 1 << 20; },
        [](State& s) { s.contacts.info[0].shape_a = 1 << 20; },
        [](State& s) { s.contacts.info[0].kind = PairKind::group; },
        [](State& s) { s.contacts.info[0].kind = PairKind(250); },
        [](State& s) { s.contacts.info[0].point_count = 200; },
        [](State& s) { s.contacts.info[0].color = 254; },
        [](State& s) { s.contacts.separation_budgets[0].body_a = 1 << 20; },
        [](State& s) { s.joints.info[0].body_a = 1 << 20; },
        [](State& s) { s.joints.info[0].next[0] = 0; },
        [](State& s) { s.joints.info[0].rules.axis_count = 255; },
        [](State& s) { s.joints.info[0].rules.turn_column = 255; },
        [](State& s) { s.joints.info[0].color = 200; },
        [](State& s) { s.joints.info.pop_back(); },
    };
    int number = 0;
    for (const auto& change : changes) {
        Snapshot forged = forge(change);
        EXPECT_TRUE(is_refused(forged)) << "change " << number;
        world.restore(before);
        ++number;
    }
    Snapshot same = forge([](State&) {});
    EXPECT_FALSE(is_refused(same));
    use_all_state(world);
}

TEST_F(ForgedSnapshot, SaysWhatWhichValueAndWhatWasExpected) {
    Snapshot forged = forge([](State& s) { s.contacts.info[0].body_b = 1234567; });
    fit_checksum(forged);
    try {
        world.restore(forged);
        FAIL() << "it was taken";
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(), "Snapshot.contacts[0].body: must be that of shape_b, and another one than body_a, "
                                   "got 1234567");
    }
}

TEST_F(ForgedSnapshot, WithAnyWordChangedIsRefusedOrLeadsNowhereElse) {
    int taken = 0;
    for (std::size_t at = sizeof(SnapshotHeader); at + 4 <= saved.bytes.size(); ++at) {
        Snapshot changed = saved;
        const std::uint32_t value = at % 3 == 0 ? 0xffffffffu : at % 3 == 1 ? 0x7fffffu : 1u;
        std::memcpy(&changed.bytes[at], &value, sizeof value);
        if (!is_refused(changed)) {
            ++taken;
            use_all_state(world);
        }
        world.restore(before);
    }
    EXPECT_GT(taken, 10);
}

} // namespace
} // namespace cairn
