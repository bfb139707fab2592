// The storage of contact records, and their distribution to several ranks (docs/scale.md).
#pragma once

#include "core/room.h"
#include "kernels/solve/solver_data.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace cairn {

// The owner of bodies that belong to every rank: each rank tests their pairs and solves their contacts for itself.
inline constexpr std::int32_t every_rank = -1;

// For a world that several ranks step together: the rank that tests the pairs with a given body A, and has their
// contact records. All ranks have the same list.
struct BodyOwners {
    int rank = 0;                      // the number of this rank
    std::vector<std::int32_t> of_body; // bodies past the end of the list belong to every_rank

    std::int32_t operator[](std::int32_t body) const {
        return std::size_t(body) < of_body.size() ? of_body[std::size_t(body)] : every_rank;
    }
    bool has(std::int32_t body) const {
        const std::int32_t owner = (*this)[body];
        return owner == every_rank || owner == rank;
    }
};

// Contact records, indexed by contact. A whole list has a record at the index of each contact. A rank that has left the
// records of other owners to them has only its own, side by side.
class ContactRecords {
  public:
    bool is_whole() const { return is_whole_; }
    bool has(std::size_t contact) const { return is_whole_ || places_[contact] != absent; }
    std::size_t place_of(std::size_t contact) const { return is_whole_ ? contact : places_[contact]; }
    ContactRecord& operator[](std::size_t contact) { return list_[place_of(contact)]; }
    const ContactRecord& operator[](std::size_t contact) const { return list_[place_of(contact)]; }
    // Raw access, by place.
    ContactRecord* data() { return list_.data(); }
    std::size_t places() const { return list_.size(); }
    // All records; only if they are whole.
    std::vector<ContactRecord>& whole() { return list_; }
    const std::vector<ContactRecord>& whole() const { return list_; }

    // Creates an empty record for a contact. If the records are not whole, contacts of other owners get none.
    void open(std::size_t contact, bool is_own) {
        if (is_whole_) {
            if (contact >= list_.size()) set_size(list_, contact + 1);
            list_[contact] = {};
            return;
        }
        if (contact >= places_.size()) set_size(places_, contact + 1, absent);
        if (!is_own) return;
        if (free_.empty()) {
            places_[contact] = std::uint32_t(list_.size());
            push(list_, ContactRecord{});
        } else {
            places_[contact] = free_.back();
            free_.pop_back();
            list_[places_[contact]] = {};
        }
    }
    void drop(std::size_t contact) {
        if (is_whole_ || places_[contact] == absent) return;
        free_.push_back(places_[contact]);
        places_[contact] = absent;
    }

    // Keeps the records of those of `count` contacts for which stays(contact) is true, and releases the memory of the
    // others.
    template <class F> void keep(std::size_t count, F&& stays) {
        std::vector<std::uint32_t> places(count, absent);
        std::vector<ContactRecord> list;
        std::size_t kept = 0;
        for (std::size_t contact = 0; contact < count; ++contact) kept += has(contact) && stays(contact);
        reserve_room(list, kept);
        for (std::size_t contact = 0; contact < count; ++contact) {
            if (!has(contact) || !stays(contact)) continue;
            places[contact] = std::uint32_t(list.size());
            list.push_back((*this)[contact]);
        }
        list_ = std::move(list), places_ = std::move(places);
        free_ = {};
        is_whole_ = false;
    }
    bool is_sparse() const { return free_.size() > list_.size() / 2; }
    void make_whole(std::vector<ContactRecord>&& all) {
        list_ = std::move(all);
        places_ = {}, free_ = {};
        is_whole_ = true;
    }

  private:
    static constexpr std::uint32_t absent = ~std::uint32_t(0);
    bool is_whole_ = true;
    std::vector<ContactRecord> list_;
    std::vector<std::uint32_t> places_; // by contact: index into list_
    std::vector<std::uint32_t> free_;   // unused places in list_
};

} // namespace cairn
