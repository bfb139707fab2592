// Pairs of shapes that may meet in a step, and when they do: movers with each other and with all other bodies.
#pragma once

#include "contacts/record_owners.h"
#include "impacts/assemblies.h"
#include "impacts/movers.h"

namespace cairn {

// State that the search for pairs reads. Only movers and the search's own working memory are modified.
struct SweptInput {
    const Bodies& bodies;
    const Shapes& shapes;
    const Contacts& contacts;
    const Islands& islands;
    const Joints& joints;
    const BroadPhase& broad_phase;
    const NarrowScratch& narrow;
    const std::vector<SortedContact>& solved;
    const std::vector<std::int32_t>&fast, &strayed; // of SolverScratch
    ThreadPool& thread_pool;
    Communicator* ranks;
};

class SweptPairs {
  public:
    SweptPairs(const SweptInput& input, SweepScratch& scratch, Movers& movers, Assemblies& assemblies);
    ~SweptPairs();
    SweptPairs(const SweptPairs&) = delete;
    SweptPairs& operator=(const SweptPairs&) = delete;

    // Lists the pairs in flight, and those pairs of the narrow phase whose bodies may pass each other; then all shapes
    // near the paths of bodies that are not where the broad phase expected them.
    void find();
    // Lists pairs with all shapes near the path of a redirected mover, from a time on.
    void find_near(std::int32_t mover, double from);

    SweptPair& operator[](std::int32_t k) { return pairs_[std::size_t(k)]; }
    std::int32_t count() const { return std::int32_t(pairs_.size()); }
    // Calls f(index of a pair) for all pairs of a mover.
    template <class F> void for_each_of(std::int32_t mover, F&& f) {
        for (std::int32_t k = movers_[mover].first_pair; k != none;) {
            const SweptPair& pair = (*this)[k];
            const std::int32_t next = pair.first == mover ? pair.next_of_first : pair.next_of_second;
            f(k);
            k = next;
        }
    }
    // Makes a body a mover, if it is none yet, and assigns all pairs with it to the mover.
    std::int32_t add_mover(std::int32_t body);
    // The time at which the two meet; up to the time `from` they are known to be apart.
    double time_of(SweptPair& pair, double from) const;

  private:
    void add(std::int32_t mover, std::uint32_t shape, std::uint32_t other, std::int32_t contact);
    void set_axis(SweptPair& pair, math::Vec3 normal) const;
    void ask_for_axes();
    void link(std::int32_t pair, std::int32_t mover);
    bool is_listed(std::int32_t mover, std::uint32_t shape, std::uint32_t other);
    bool may_pass(std::int32_t mover, std::int32_t body, const Geometry& other) const;
    bool stay_far_apart(SweptPair& pair, const RigidPath& a, const RigidPath& b, double from) const;
    bool may_collide(std::uint32_t a, std::uint32_t b) const; // by filters and joints
    bool note_trigger(std::uint32_t a, std::uint32_t b);      // whether one of them is a trigger
    bool are_joined(std::int32_t a, std::int32_t b);
    void find_struck(std::int32_t kinematic);
    std::int32_t known_contact(std::uint32_t a, std::uint32_t b);
    void list_known();
    void list_passing();
    void list_swept_bounds();
    void note_swept_bounds(const SweptBounds& swept); // of a redirected mover
    void find_near_strayed();
    void list_pairs_of(std::int32_t mover);
    void add_near(std::int32_t mover, std::uint32_t other);
    template <class F> void for_each_near(std::int32_t mover, const DBounds& bounds, F&& f) const;

    const SweptInput in;
    Movers& movers_;
    Assemblies& assemblies_;
    SweepScratch& scratch_;
    std::vector<SweptPair>& pairs_;
    std::vector<std::int32_t> without_axis_; // on several ranks: pairs whose normal the owner has not sent yet
};

} // namespace cairn
