// The broad phase: which shapes may touch. It keeps, for every shape, a "fat" box somewhat larger than the shape, and
// the list of all pairs whose fat boxes meet; a step that moves no shape out of its fat box costs nothing.
//
// Shapes are named by a dense index of the caller's. An awake shape sits in a slot of the tree of awake shapes, fixed
// ones in a tree of their own, planes in a list, and every sleeping island in a small tree of its own, under a tree
// of all islands. Slots are sorted in kd order now and then, and pairs are kept and walked in slot order, so that
// what is near in space is near in memory. All orders depend on the sequence of calls alone.
#pragma once

#include "bvh/slot_tree.h"
#include "bvh/tree.h"
#include "collision/broad_phase_rows.h"
#include "jobs/ordered_list.h"
#include "math/bounds.h"
#include "math/vec.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace cairn {

// Told of pairs that begin and end. Implemented by the contact manager. Calls come from within BroadPhase::update;
// the sink must not call the broad phase back.
struct PairSink {
    // The fat boxes of two shapes began to meet. shape_a is awake. Either sets `contact` to a number of its choice
    // below 0xffffffff and returns true, or returns false: the pair is filtered out, and not asked about again for
    // as long as it lasts.
    virtual bool pair_found(std::uint32_t shape_a, std::uint32_t shape_b, std::uint32_t& contact) = 0;
    // A pair that was not filtered has ended; the shapes may be in either order, and may have been removed.
    virtual void pair_lost(std::uint32_t shape_a, std::uint32_t shape_b, std::uint32_t contact) = 0;

  protected:
    ~PairSink() = default;
};

// Is shown all pairs that a snapshot has. Implemented by who knows the contacts; throws if there is none of that
// number.
struct PairReader {
    virtual void pair(std::uint32_t shape_a, std::uint32_t shape_b, std::uint32_t contact) = 0;

  protected:
    ~PairReader() = default;
};

// A shape and where it is now (BroadPhase::set_bounds).
struct NewBounds {
    std::uint32_t shape;
    DBounds tight;
    math::Vec3 displacement; // m, expected over the next step
};

class BroadPhase {
  public:
    enum class Mobility : std::uint8_t { fixed, awake };
    static constexpr std::uint32_t none = 0xffffffffu;

    // A fat box contains the tight bounds with this added on every side, m, swept along the expected displacement.
    static constexpr double required_margin = 0.01;
    // A new fat box adds the smaller of these to the required bounds: m, and in units of the largest extent.
    static constexpr double fat_margin = 0.01, fat_fraction = 0.025;
    // An awake shape is large when it is this many times the median size.
    static constexpr float large_ratio = 8.0f;
    // The origin of the trees moves when the middle of the awake shapes is farther from it, m.
    static constexpr double origin_distance = 4096.0;
    // Slots are sorted when as many boxes have changed as there are slots, but not more often than this, steps.
    static constexpr std::uint32_t steps_between_sorts = 16;

    // `kernels` must outlive it.
    explicit BroadPhase(const BroadKernels& kernels) : kernels_(kernels) {}

    // --- Shapes. A removed index may be used again only after the next update. Queries see all changes at once, pairs
    // change at the next update. Bounds that are not numbers count as boundless.

    // `kinematic` shapes make no pairs with fixed shapes, planes and other kinematic ones, unless one of the two is a
    // trigger; ignored for fixed shapes.
    void add(std::uint32_t shape, const DBounds& tight, Mobility mobility, bool kinematic = false,
             bool trigger = false);
    // A fixed half-space, solid below the plane through `point` with the unit `normal`; or the plane alone, a sheet.
    void add_plane(std::uint32_t shape, math::DVec3 point, math::Vec3 normal, bool is_sheet = false,
                   bool trigger = false);
    void move_plane(std::uint32_t shape, math::DVec3 point, math::Vec3 normal);
    // For a shape that is not in it, or not yet: it may be asked for.
    void make_room(std::uint32_t shape);
    // Its pairs are reported lost at the next update.
    void remove(std::uint32_t shape);
    // A shape of any kind but a plane has moved. `displacement` is the motion expected over the next step, m: the
    // pairs cover it.
    void set_bounds(std::uint32_t shape, const DBounds& tight, math::Vec3 displacement = {});
    // Likewise of one that has become another: its fat box fits these bounds, even if the old one contains them.
    void renew_bounds(std::uint32_t shape, const DBounds& tight, math::Vec3 displacement);
    // set_bounds would change nothing, as the fat box still contains them, until these bounds and the displacement have
    // changed by so much together, m; less than 0 if it would. May be asked from many threads.
    double room(std::uint32_t shape, const DBounds& tight, math::Vec3 displacement) const {
        return fat_room(fat_[shape], tight, displacement);
    }
    // The same for many shapes, each once, in any order, most of them awake. With all threads of the pool.
    void set_bounds(std::span<const NewBounds> all, ThreadPool& thread_pool);
    // Whatever the sink decides by has changed: all pairs of the shape are lost and found anew at the next update.
    void refilter(std::uint32_t shape);
    bool contains(std::uint32_t shape) const {
        return shape < proxies_.size() && proxies_[shape].state != State::none &&
               proxies_[shape].state != State::removed;
    }

    // --- Sleep. The shapes, all awake, go to sleep as one island. Pairs among what does not move any more (sleeping,
    // fixed) are then neither walked nor lost but kept, contact and all, until a shape of theirs wakes: then they go
    // on if the boxes still meet, and are reported lost otherwise. `island_key` is a small number of the caller's,
    // not in use by another sleeping island.
    void put_to_sleep(std::uint32_t island_key, std::span<const std::uint32_t> shapes);
    void wake(std::uint32_t island_key);
    bool is_asleep(std::uint32_t island_key) const {
        return island_key < island_of_key_.size() && island_of_key_[island_key] != none;
    }

    // Finds what begins and ends: first all lost pairs, then all found ones, each in slot order. Searches with all
    // threads of the pool, if there is one.
    void update(PairSink& sink, ThreadPool* thread_pool = nullptr);
    // Search everything whenever anything moved, instead of what may have changed. The results are the same.
    void set_search_all(bool all) { search_all_ = all; }

    // f(shape_a, shape_b, contact) for all pairs with an awake shape (shape_a) that the sink did not refuse, in slot
    // order.
    template <class F> void for_each_pair(F&& f) const;
    // Their contacts, in that order; `parts`: working memory.
    void list_contacts(std::vector<std::uint32_t>& contacts, std::vector<ListPart>& parts,
                       ThreadPool& thread_pool) const;
    // The same for the pairs that are kept for a sleeping island: those among its shapes, and of those with fixed ones.
    template <class F> void for_each_sleeping_pair(std::uint32_t island_key, F&& f) const;

    // --- Queries: const, safe from many threads at once. Candidates by fat boxes: fixed, awake, sleeping and planes.

    // visit(shape) for all shapes whose fat boxes meet the bounds.
    template <class F> void query_bounds(const DBounds& bounds, F&& visit) const;
    // `new_max = visit(shape, max)` for shapes whose boxes the ray meets at a distance up to the current maximum;
    // roughly from near to far. Returning 0 or less ends the search early.
    template <class F>
    void query_ray(math::DVec3 origin, math::DVec3 direction_unit, double max_distance, F&& visit) const;
    // `new_max = visit(shape, max)` for shapes whose boxes the bounds meet as they move by the translation, up to the
    // fraction `max` of it, which is 1 at first; roughly in that order. Less than 0 ends the search.
    template <class F> void query_sweep(const DBounds& bounds, math::DVec3 translation, F&& visit) const;
    // `new_max = visit(shape, max)` for shapes whose boxes are up to `max` from the point, roughly from near to far.
    // Less than 0 ends the search.
    template <class F> void query_near(math::DVec3 point, double max_distance, F&& visit) const;

    // The fat box of a shape, m. Not for planes.
    const DBounds& fat_bounds(std::uint32_t shape) const { return fat_[shape]; }

    // A box of a tree, for who draws it.
    struct Node {
        DBounds bounds;
        enum class Tree : std::uint8_t { fixed, awake, large, sleeping } tree;
        std::uint32_t depth, parent, shape; // parent: its place in the list, or none; shape: none but of a leaf
    };
    // By depth, down to the given one, and no more than that many.
    std::vector<Node> nodes(std::uint32_t max_depth, std::size_t max_count) const;

    struct Counts {
        std::uint32_t awake, large, fixed, sleeping, islands, planes;
        std::uint32_t pairs, sleeping_pairs; // with the filtered ones
        // of the last update:
        std::uint32_t moved, leaves_searched, lost, found;
        std::uint32_t sorted; // whether the slots were put into a new order
    };
    Counts counts() const;
    std::size_t bytes() const;

    // All state that later results depend on. `archive` takes a reference to a vector of a trivially copyable type or
    // to one such object, and saves or loads it. Load into a BroadPhase with the kernels of any instruction set.
    template <class Archive> void serialize(Archive& archive);

    // Of what was read from a snapshot: throws Error(invalid_file) unless all that it names is there. `shapes`: more
    // than any shape's index. Pairs that no change would end are looked for at the next update. (broad_phase_check.cpp)
    void check(std::size_t shapes, PairReader& reader);

    enum class State : std::uint8_t { none, fixed, plane, awake, sleeping, removed };
    State state_of(std::uint32_t shape) const { return shape < proxies_.size() ? proxies_[shape].state : State::none; }
    // Of a shape that sleeps.
    std::uint32_t sleeping_key(std::uint32_t shape) const { return islands_[proxies_[shape].home].key; }

  private:
    struct Proxy {
        std::uint32_t place = 0; // slot in its tree; index in the list of planes
        std::uint32_t home = 0;  // awake: 0 or 1 (large); sleeping: its island
        State state = State::none;
        std::uint8_t crowd = 0, refilter = 0, moved = 0;
    };
    // Shapes that nothing can push make no pairs with their like: triggers, and all others.
    static constexpr std::uint8_t solids = 1, triggers = 2;
    static std::uint8_t crowd_of(bool trigger) { return trigger ? triggers : solids; }
    struct Plane {
        math::DVec3 point, normal;
        std::uint32_t shape = 0, is_sheet = 0;
    };
    // A box that changed since the last update; flags are cleared and leaves marked from this list.
    struct Change {
        TreeBox before;
        std::uint32_t shape, slot, home;
    };
    struct Island {
        std::uint32_t key, top_slot;
        std::uint32_t node_base, node_count; // all levels, leaves first, in island_nodes_
        std::uint32_t shape_base, shape_count;
        std::uint32_t alive_count, first_pair; // of kept pairs, a list through kept_
        std::uint32_t removal;                 // a shape in one of its kept pairs may have been removed
    };
    // A pair of shapes that do not move.
    struct KeptPair {
        std::uint32_t shape_a, shape_b, contact, next;
    };
    struct EndedPair {
        std::uint32_t shape_a, shape_b, contact, matched;
    };
    struct FoundPair {
        std::uint32_t home, leaf, offset, shape_a, shape_b; // offset: of the entry in the leaf's chunk
    };
    // Working memory of one thread that searches.
    struct Search {
        std::vector<std::uint32_t> list[2]; // leaves that meet the group: of its own tree, of the large one
        std::vector<float> list_bounds[2];
        std::vector<std::uint32_t> row_keys, hits, islands_hit;
        RowBuffer rows = {};
        TreeView fixed = {}, top = {};
        std::vector<MetLeaf> met;                    // of what is not awake: the first met_count
        std::vector<const std::uint32_t*> met_items; // of the first lane of each
        std::size_t met_count = 0;
        std::vector<std::uint64_t> others; // row << 32 | key
    };
    // Rows that are not what they were, of leaves that were searched one after another.
    struct NewRows {
        struct Leaf {
            std::uint32_t leaf, begin; // begin: among `keys`
            std::uint32_t count[8];    // of them, by row
        };
        std::vector<Leaf> leaves;
        std::vector<std::uint32_t> keys;
        std::uint32_t searched = 0;
    };

    // shapes (broad_phase.cpp)
    TreeBox to_box(const DBounds& bounds) const;   // relative to the origin, rounded outward, whatever the bounds are
    TreeBox relative(const DBounds& bounds) const; // the same for bounds that are in order
    TreeRay to_ray(math::DVec3 origin, math::DVec3 direction, math::DVec3 half) const;
    template <std::size_t count, class Enter, class F>
    float query_trees(const SlotTree* const (&trees)[count], float max, Enter&& enter, F&& visit) const;
    template <class Enter, class F> void query_by_distance(float max, Enter&& enter, F&& visit) const;
    Proxy& make_proxy(std::uint32_t shape);
    void place_awake(std::uint32_t shape);
    void note_change(std::uint32_t shape, const TreeBox& before);
    void note_touched(const TreeBox& box) { touched_.push_back(box); }
    void write_box(std::uint32_t shape);
    static double fat_room(const DBounds& fat, const DBounds& tight, math::Vec3 displacement);
    static DBounds new_fat(const DBounds& tight, math::Vec3 displacement);
    void choose_first_origin(const DBounds& bounds);

    // islands (broad_phase_sleep.cpp)
    TreeView island_view(const Island& island) const;
    std::uint32_t new_island();
    TreeBox refit_island(const Island& island);
    void release_island(std::uint32_t index);
    void remove_sleeping(std::uint32_t shape);
    void write_sleeping_box(std::uint32_t shape, const TreeBox& box);
    void compact_islands();
    bool may_keep(std::uint32_t shape_a, std::uint32_t shape_b) const;
    void keep_pair(const EndedPair& pair);
    void release_kept(std::uint32_t& first, bool all);
    void flag_removal(const TreeBox& box);
    void collect_returned_pairs();

    // search (broad_phase_find.cpp)
    void mark_leaves();
    void mark_everywhere(int home, const TreeBox& before, const TreeBox& after);
    std::uint32_t list_leaves(Search& own, int which, const TreeView& tree, const TreeBox& box,
                              std::uint32_t first_leaf) const;
    static LeafList leaf_list(Search& own, int which);
    void list_met(Search& own, const Node8& leaf, const TreeBox& bounds, const TreeView& tree,
                  const std::uint32_t* items) const;
    template <class F> void for_each_met(Search& own, const Node8& leaf, const TreeBox& bounds, const F& f) const;
    void mark_crowds();
    std::uint32_t drop_crowds(Search& own, int which, int home, std::uint32_t count, std::uint8_t crowd) const;
    void search(int home, ThreadPool* thread_pool);
    void search_group(int home, std::uint32_t first, std::uint32_t end, Search& own, NewRows& found) const;
    void search_leaf(int home, std::uint32_t leaf, std::uint32_t own_count, std::uint32_t large_count, Search& own,
                     NewRows& found) const;
    void find_others(int home, std::uint32_t leaf, const TreeBox& bounds, Search& own) const;
    bool is_new(int home, const NewRows::Leaf& rows, const std::uint32_t* keys) const;
    void merge_leaf(int home, const NewRows::Leaf& rows, const std::uint32_t* key);

    // snapshots (broad_phase_check.cpp)
    struct Noticed;
    void check_proxies(std::size_t shapes) const;
    void check_trees() const;
    void check_islands() const;
    void check_changes() const;
    bool ends_or_goes_on(const Noticed& noticed, int home, std::uint32_t slot, std::uint32_t key) const;
    void check_rows(PairReader& reader);
    std::uint32_t check_kept(std::uint32_t island, std::uint32_t first, std::vector<std::uint8_t>& seen,
                             PairReader* reader) const;
    void check_kept(PairReader& reader) const;

    // order and report (broad_phase_update.cpp)
    void sort_if_due();
    void sort_fixed();
    void sort_awake();
    static float size_of(const TreeBox& box);
    static float median(std::vector<float>& values);
    float size_limit();
    bool origin_is_far(math::DVec3& wanted);
    void rebase(math::DVec3 origin);
    void flatten_rows();
    void unflatten_rows();
    void report(PairSink& sink);
    void match_transfers();

    std::uint32_t partner_shape(std::uint32_t key) const {
        if (key & other_key) return key & ~other_key;
        return key & large_key ? awake_[1].item(key & ~large_key) : awake_[0].item(key);
    }
    bool slot_alive(std::uint32_t key) const {
        return key & large_key ? awake_[1].alive(key & ~large_key) : awake_[0].alive(key);
    }
    bool crosses(const Plane& plane, const TreeBox& box) const;
    static bool passes(const Plane& plane, math::DVec3 center, math::DVec3 half, math::DVec3 way);

    const BroadKernels& kernels_;

    // --- state
    math::DVec3 origin_;
    std::vector<Proxy> proxies_; // by shape
    std::vector<DBounds> fat_;   // by shape
    SlotTree awake_[2];          // [1]: large ones
    PairRows rows_[2];
    SlotTree fixed_, top_; // items of top_: islands
    std::vector<Plane> planes_;
    std::vector<Island> islands_;
    std::vector<std::uint32_t> free_islands_, island_of_key_;
    std::vector<Node8> island_nodes_;
    std::vector<std::uint32_t> island_shapes_;
    std::vector<KeptPair> kept_;
    std::uint32_t first_free_kept_ = none, first_cross_pair_ = none; // cross: of two different islands
    std::uint32_t dead_island_nodes_ = 0, dead_island_shapes_ = 0, kept_count_ = 0;
    std::vector<Change> changes_;        // since the last update
    std::vector<TreeBox> touched_;       // boxes of shapes that changed and are not awake, or changed sides
    std::vector<std::uint32_t> removed_; // shapes, since the last update
    std::vector<std::uint32_t> refiltered_;
    std::vector<EndedPair> returned_; // kept pairs of woken shapes
    std::uint32_t all_dirty_ = 0, transfers_ = 0, removals_ = 0, shape_count_ = 0, sleeping_count_ = 0;
    std::uint32_t steps_since_sort_ = 0;
    std::uint64_t moved_since_sort_ = 0;
    float large_size_ = largest_bound; // from here on an awake shape is large, m
    std::uint32_t has_kinematic_ = 0;  // or had
    Counts last_ = {};

    // --- scratch: kept between calls for its memory only
    bool search_all_ = false, search_all_next_ = false;
    std::uint32_t small_count_ = 0;
    std::vector<std::uint8_t> dirty_[2], crowd_[2]; // by leaf; crowd_: what all of its shapes belong to
    KdOrder kd_;
    std::vector<EndedPair> ended_, flat_;
    std::vector<FoundPair> found_;
    std::vector<Search> searches_;  // by thread
    std::vector<NewRows> new_rows_; // by chunk of groups
    std::vector<std::uint32_t> order_, items_, shape_scratch_;
    std::vector<std::int32_t> moved_shapes_;  // in ascending order
    std::vector<std::uint64_t> shape_marks_;  // to sort them
    std::vector<std::uint32_t> new_of_shape_; // by shape: its new bounds among all
    std::vector<Change> new_changes_;
    std::vector<ListPart> parts_;
    std::vector<PairEntry> merged_;
    std::vector<float> sizes_;
    std::vector<TreeBox> boxes_;
    std::vector<Node8> node_scratch_;
};

} // namespace cairn

#include "collision/broad_phase_queries.h" // the templates above
