// A ring of the most recent states of a world.
#include "core/image_archive.h"
#include "world/impl.h"
#include "world/state_archive.h"
#include "world/validate.h"

#include <cairn/snapshot_ring.h>

#include <deque>

namespace cairn {

struct SnapshotRing::Ring {
    struct Frame {
        std::shared_ptr<const SnapshotDefinitions> definitions;
        StateDelta back; // from the image of the next frame to that of this one; empty for the newest
    };
    std::size_t capacity = 0;
    StateImage image;            // of the newest frame
    std::deque<Frame> frames;    // oldest first
    std::vector<std::byte> room; // scratch memory for writing deltas
};

SnapshotRing::SnapshotRing(std::size_t frames) : ring_(std::make_unique<Ring>()) {
    if (frames < 1) refuse("SnapshotRing frames", std::to_string(frames), "must be at least 1");
    ring_->capacity = frames;
}
SnapshotRing::~SnapshotRing() = default;
SnapshotRing::SnapshotRing(SnapshotRing&&) noexcept = default;
SnapshotRing& SnapshotRing::operator=(SnapshotRing&&) noexcept = default;

void SnapshotRing::push(const World& world) {
    World::Impl& impl = *world.impl_;
    impl.require_idle("SnapshotRing::push");
    impl.require_usable("SnapshotRing::push");
    Ring& ring = *ring_;
    try {
        impl.gather_records();
        std::shared_ptr<const SnapshotDefinitions> definitions = impl.definitions();
        if (ring.frames.size() == ring.capacity) ring.frames.pop_front();
        ImageWriter archive(ring.image, ring.room);
        serialize_state(archive, impl.state, [](StatePart) {}); // writing changes nothing in the state
        if (!ring.frames.empty()) ring.frames.back().back = archive.delta();
        ring.frames.push_back({std::move(definitions), {}});
    } catch (...) { // the image may be incomplete
        clear();
        throw;
    }
}

void SnapshotRing::restore(World& world, std::size_t back) {
    Ring& ring = *ring_;
    World::Impl& impl = *world.impl_;
    if (back >= ring.frames.size())
        refuse("SnapshotRing::restore back", std::to_string(back),
               "must be less than the number of states, " + std::to_string(ring.frames.size()));
    impl.require_idle("SnapshotRing::restore");
    impl.require_not_notifying("SnapshotRing::restore");
    const std::size_t left = ring.frames.size() - back;
    try {
        for (std::size_t i = ring.frames.size() - 1; i >= left; --i) apply_delta(ring.image, ring.frames[i - 1].back);
        ring.frames.erase(ring.frames.begin() + std::ptrdiff_t(left), ring.frames.end());
    } catch (...) {
        clear();
        throw;
    }
    world.restore_image(ring.image, ring.frames.back().definitions);
}

void SnapshotRing::clear() {
    ring_->frames.clear();
    ring_->image = {};
}

std::size_t SnapshotRing::size() const noexcept { return ring_->frames.size(); }
std::size_t SnapshotRing::capacity() const noexcept { return ring_->capacity; }

std::size_t SnapshotRing::bytes(std::size_t back) const {
    const Ring& ring = *ring_;
    if (back >= ring.frames.size())
        refuse("SnapshotRing::bytes back", std::to_string(back),
               "must be less than the number of states, " + std::to_string(ring.frames.size()));
    if (back > 0) return ring.frames[ring.frames.size() - 1 - back].back.size();
    std::size_t bytes = 0;
    for (const StateImage::Part& part : ring.image.parts) bytes += part.size;
    return bytes;
}

} // namespace cairn
