// Slots with generations, for versioned handles. A slot has three states: live; dead (its handles are stale, but the
// index is not reused yet, because something may still refer to it); free.
#pragma once

#include "core/sound.h"

#include <cairn/handle.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace cairn {

// `Id`: the handle type for the slots of this pool.
template <class Id> class SlotPool {
  public:
    static constexpr std::uint32_t max_slots = (1u << Handle<void>::index_bits) - 1;
    static constexpr std::uint32_t last_generation = (1u << Handle<void>::generation_bits) - 1;

    // Returns the index of a new live slot: the one freed last, or one past the end.
    std::uint32_t create() {
        ++live_count_;
        if (!free_.empty()) {
            const std::uint32_t index = free_.back();
            free_.pop_back();
            live_[index] = 1;
            return index;
        }
        generations_.push_back(1);
        live_.push_back(1);
        return std::uint32_t(generations_.size() - 1);
    }

    // Makes a slot dead, and handles to it stale.
    void kill(std::uint32_t index) {
        live_[index] = 0;
        --live_count_;
    }

    // Frees a dead slot for reuse, under its next generation. A slot that has used up its generations is retired, so
    // that no handle ever refers to two objects.
    void recycle(std::uint32_t index) {
        if (generations_[index] == last_generation) return;
        ++generations_[index];
        free_.push_back(index);
    }

    bool is_live(std::uint32_t index) const noexcept { return index < live_.size() && live_[index]; }
    bool is_live(std::uint32_t index, std::uint32_t generation) const noexcept {
        return is_live(index) && generations_[index] == generation;
    }
    bool holds(Id id) const noexcept { return id.world() == world_ && is_live(id.index(), id.generation()); }
    Id id(std::uint32_t index) const noexcept { return Id::make(index, generations_[index], world_); }
    std::uint32_t world() const noexcept { return world_; }
    void set_world(std::uint32_t world) noexcept { world_ = world; } // the world's number in handles
    std::size_t live_count() const noexcept { return live_count_; }
    std::size_t size() const noexcept { return generations_.size(); } // live, dead and free
    bool full() const noexcept { return free_.empty() && generations_.size() >= max_slots; }

    // Excludes the world's number, which is the same for all pools.
    template <class Archive> void serialize(Archive& archive) {
        archive(generations_);
        archive(live_);
        archive(free_);
        archive(live_count_);
    }

    // Validates a loaded pool: throws Error(invalid_file) unless each slot is in one state. `dead`: the dead slots,
    // except those that have used up their generations.
    void check(const char* name, const std::vector<std::uint32_t>& dead) const {
        require_sound(world_ > 0 && world_ <= 0xffff, {name, 0, "world"}, world_, "must be 1 to 65535");
        require_count(name, live_.size(), generations_.size());
        std::vector<std::uint8_t> state(generations_.size());
        std::size_t live = 0;
        for (std::size_t i = 0; i < state.size(); ++i) {
            require_sound(generations_[i] > 0 && generations_[i] <= last_generation, {name, i, "generation"},
                          generations_[i], "must be 1 to 1048575");
            require_sound(live_[i] <= 1, {name, i, "live"}, live_[i], "must be 0 or 1");
            live += state[i] = live_[i];
        }
        require_count(name, live_count_, live);
        for (const auto* list : {&free_, &dead})
            for (std::size_t k = 0; k < list->size(); ++k) {
                const std::uint32_t slot = (*list)[k];
                require_sound(slot < state.size() && !state[slot], {name, k, list == &free_ ? "free" : "dead"}, slot,
                              "must be a slot that is not live, and not be listed twice");
                state[slot] = 1;
            }
    }

  private:
    std::uint32_t world_ = 0;
    std::vector<std::uint32_t> generations_;
    std::vector<std::uint8_t> live_;
    std::vector<std::uint32_t> free_;
    std::uint64_t live_count_ = 0;
};

} // namespace cairn
