#include "contacts/shared_tests.h"

#include "bodies/motion_budget.h"
#include "contacts/contact_update.h"
#include "contacts/internal_edges.h"
#include "contacts/patches.h"
#include "contacts/record_owners.h"
#include "core/cache.h"

#include <algorithm>
#include <cstring>

namespace cairn {

namespace {

// The bytes that one rank broadcasts to all.
class Stream {
  public:
    template <class T> void put(const T& value) {
        if (bytes_.size() < next_ + sizeof value) bytes_.resize(2 * next_ + 4096);
        std::memcpy(bytes_.data() + next_, &value, sizeof value);
        next_ += sizeof value;
    }
    template <class T> T take() {
        T value;
        std::memcpy(&value, bytes_.data() + next_, sizeof value);
        next_ += sizeof value;
        return value;
    }
    void broadcast(int root, Communicator& ranks) {
        std::uint64_t size = next_; // of the root
        ranks.broadcast(root, std::as_writable_bytes(std::span(&size, 1)));
        bytes_.resize(std::size_t(size));
        if (size > 0) ranks.broadcast(root, bytes_);
        next_ = 0;
    }

  private:
    std::vector<std::byte> bytes_;
    std::size_t next_ = 0;
};

// Layout of the first byte sent for a contact, usually the only one: bits of its Outcome. The number of points follows,
// or that it is one of two round surfaces, and a flag: the pair was tested at the present poses, and may touch from now
// on.
constexpr std::uint8_t outcome_bits = 15, points_shift = 4, points_bits = 7, is_open = 128;
constexpr std::uint8_t one_of_round_surfaces = 5; // in place of the number of points, which is at most 4
static_assert(to_test <= outcome_bits);

// Sends test results from the rank that made them to the others. TestSender and TestReceiver visit pairs, patches and
// members in the same order.
class TestSender {
  public:
    TestSender(const NarrowInput& in, const FollowUpContext& context, Stream& stream, float dt)
        : in(in), s(context), stream_(stream), dt_(dt) {}

    void tell(std::uint32_t place) {
        const std::uint32_t id = s.narrow.candidates[place];
        tell_contact(id, s.narrow.outcomes[place]);
        if (s.narrow.outcomes[place] != tested_patches) return;
        for_each_patch(s.contacts, id,
                       [&](std::uint32_t patch) { tell_contact(patch, s.narrow.patch_outcomes[patch]); });
        tell_fresh(place, id);
    }

  private:
    void tell_contact(std::uint32_t id, std::uint8_t outcome) {
        const ContactInfo& c = s.contacts.info[id];
        const Travel until = s.contacts.separation_budgets[id].until;
        const bool is_of_now = c.placed_at == travel_of(in.bodies, c) && until == c.placed_at;
        const int points = c.point_count == 1 && c.is_round_touch ? one_of_round_surfaces : c.point_count;
        stream_.put(std::uint8_t(outcome | points << points_shift | (is_of_now ? is_open : 0)));
        if (!is_of_now) stream_.put(c.placed_at), stream_.put(until);
        if (outcome == begun) stream_.put(how_it_begins(s.contacts, id, dt_));
    }
    // Sends the new patches that the mesh contact will get in follow_up_group, as if they had contacts already.
    void tell_fresh(std::uint32_t place, std::uint32_t group) {
        const auto is_before = [](const FreshPatch& fresh, std::uint32_t place) { return fresh.place < place; };
        auto fresh = std::lower_bound(s.narrow.fresh.begin(), s.narrow.fresh.end(), place, is_before);
        for (; fresh != s.narrow.fresh.end() && fresh->place == place; ++fresh) {
            Contacts one;
            one.info.push_back(s.contacts.info[group]);
            one.info[0].kind = PairKind::patch, one.info[0].point_count = 0, one.info[0].touching = 0;
            one.info[0].surface_material = surface_material_of(fresh->manifold);
            one.separation_budgets.emplace_back();
            one.records.open(0, true);
            take_manifold(in.bodies, in.shapes, one, in.islands, 0, fresh->manifold,
                          fresh->is_ahead ? &fresh->touch : nullptr);
            stream_.put(true);
            stream_.put(fresh->is_ahead);
            stream_.put(one.info[0].point_count);
            stream_.put(one.info[0].surface_material);
            stream_.put(how_it_begins(one, 0, dt_));
        }
        stream_.put(false);
    }

    const NarrowInput& in;
    const FollowUpContext& s;
    Stream& stream_;
    const float dt_;
};

class TestReceiver {
  public:
    TestReceiver(const NarrowInput& in, const FollowUpContext& context) : in(in), s(context) {}

    void hear(std::uint32_t place, Stream& stream) {
        const std::uint32_t id = s.narrow.candidates[place];
        const std::uint8_t outcome = s.narrow.outcomes[place] = hear_contact(id, stream);
        if (outcome == may_be_in_free_flight) s.narrow.at_work.front().flights.add(place, nullptr, 0);
        if (outcome != tested_patches) return;
        for_each_patch(s.contacts, id,
                       [&](std::uint32_t patch) { s.narrow.patch_outcomes[patch] = hear_contact(patch, stream); });
        for (std::uint32_t order = 0; stream.take<bool>(); ++order) {
            FreshPatch fresh{place, order, {}, stream.take<bool>(), {}};
            fresh.manifold.count = stream.take<std::uint8_t>();
            fresh.manifold.features[0] = std::uint32_t{stream.take<std::uint16_t>()} << surface_material_bit;
            s.narrow.fresh.push_back(fresh);
            s.narrow.begun.push_back(stream.take<BegunContact>());
        }
    }

  private:
    std::uint8_t hear_contact(std::uint32_t id, Stream& stream) {
        ContactInfo& c = s.contacts.info[id];
        Travel& until = s.contacts.separation_budgets[id].until;
        const auto head = stream.take<std::uint8_t>();
        const std::uint8_t outcome = head & outcome_bits;
        if ((head & is_open) != 0)
            c.placed_at = until = travel_of(in.bodies, c);
        else
            c.placed_at = stream.take<Travel>(), until = stream.take<Travel>();
        const std::uint8_t points = head >> points_shift & points_bits;
        if (points > 0) c.is_round_touch = points == one_of_round_surfaces;
        c.point_count = points == one_of_round_surfaces ? 1 : points;
        if (outcome == begun) s.narrow.begun.push_back(stream.take<BegunContact>());
        return outcome;
    }

    const NarrowInput& in;
    const FollowUpContext& s;
};

} // namespace

void leave_pairs_to_owners(const Contacts& contacts, NarrowScratch& narrow) {
    narrow.shared.clear();
    for (const std::uint32_t place : narrow.open)
        if (narrow.outcomes[place] >= to_test && owner_of(contacts, narrow.candidates[place]) != every_rank)
            narrow.shared.push_back(place);
    for (std::vector<std::uint32_t>& list : narrow.lists)
        std::erase_if(list, [&](std::uint32_t place) { return !contacts.records.has(narrow.candidates[place]); });
}

void exchange_tests(const NarrowInput& in, const FollowUpContext& s, std::span<const std::uint32_t> places, float dt) {
    NarrowScratch& narrow = s.narrow;
    narrow.begun.clear();
    narrow.next_begun = 0;
    if (places.empty()) return;
    std::vector<Stream> streams(std::size_t(s.ranks->size()));
    TestSender teller(in, s, streams[std::size_t(s.ranks->rank())], dt);
    for (const std::uint32_t place : places)
        if (s.contacts.records.has(narrow.candidates[place])) teller.tell(place);
    for (int root = 0; root < s.ranks->size(); ++root) streams[std::size_t(root)].broadcast(root, *s.ranks);
    TestReceiver hearer(in, s);
    for (std::size_t k = 0; k < places.size(); ++k) {
        if (k + contacts_ahead < places.size())
            prefetch(&s.contacts.info[narrow.candidates[places[k + contacts_ahead]]]);
        const std::uint32_t id = narrow.candidates[places[k]];
        if (!s.contacts.records.has(id)) hearer.hear(places[k], streams[std::size_t(owner_of(s.contacts, id))]);
    }
    std::sort(narrow.fresh.begin(), narrow.fresh.end(), comes_before);
}

void exchange_internal_edges(const Bodies& bodies, Contacts& contacts, NarrowScratch& narrow, Communicator& ranks) {
    for (std::vector<std::uint32_t>* list : {&narrow.dropped, &narrow.lifted})
        std::erase_if(*list, [&](std::uint32_t id) { return owner_of(contacts, id) == every_rank; });
    if (ranks.sum(narrow.dropped.size() + narrow.lifted.size()) == 0) return;
    for (int root = 0; root < ranks.size(); ++root) {
        Stream stream;
        if (root == ranks.rank()) {
            for (const std::uint32_t id : narrow.dropped) stream.put(true), stream.put(id);
            stream.put(false);
            for (const std::uint32_t id : narrow.lifted)
                stream.put(true), stream.put(id), stream.put(contacts.info[id].point_count);
            stream.put(false);
        }
        stream.broadcast(root, ranks);
        if (root == ranks.rank()) continue;
        while (stream.take<bool>()) drop_internal_edge(bodies, contacts, narrow, stream.take<std::uint32_t>());
        while (stream.take<bool>()) {
            const auto id = stream.take<std::uint32_t>();
            contacts.info[id].point_count = stream.take<std::uint8_t>();
            test_again(bodies, contacts, id);
        }
    }
}

const TouchPoint* exchange_touches(const Contacts& contacts, const SolverScratch& solver, NarrowScratch& narrow,
                                   Communicator& ranks) {
    narrow.touches.clear();
    for (std::size_t k = 0; k < narrow.changes.size(); ++k) {
        const std::uint32_t id = solver.of_batches[k].id;
        if (narrow.changes[k] != 0 && !contacts.info[id].touching) narrow.touches.push_back({id, {}, {}, {}});
    }
    exchange_of_owners(narrow.touches, ranks, [&](TouchPoint& touch) {
        const std::uint32_t id = touch.contact;
        if (contacts.records.has(id)) touch = touch_point_of(contacts, id);
        return owner_of(contacts, id);
    });
    return narrow.touches.data();
}

} // namespace cairn
