// The broad phase finds the pairs of shapes that may touch. It keeps a "fat" box, somewhat larger than the shape, for
// every shape, and the list of all pairs whose fat boxes overlap; a step in which no shape leaves its fat box costs
// nothing.
//
// Shapes are identified by a dense index chosen by the caller. Awake shapes are in a tree, each in a slot; fixed shapes
// have a tree of their own, planes are in a list, and every sleeping island has a small tree of its own, below a tree
// of all islands. Slots are re-sorted in kd order from time to time, and pairs are stored and traversed in slot order,
// so that shapes near in space are near in memory. All orders depend only on the sequence of calls.
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

// Receives the pairs that begin and end; implemented by the contact manager. Called from within BroadPhase::update; a
// sink must not call the broad phase.
struct PairSink {
    // The fat boxes of two shapes have begun to overlap; shape_a is awake. Either sets `contact` to an id of the sink's
    // choice below 0xffffffff and returns true, or returns false: the pair is filtered out, and not reported again for
    // as long as it lasts.
    virtual bool pair_found(std::uint32_t shape_a, std::uint32_t shape_b, std::uint32_t& contact) = 0;
    // A pair that was not filtered has ended. The shapes may be in either order, and may have been removed.
    virtual void pair_lost(std::uint32_t shape_a, std::uint32_t shape_b, std::uint32_t contact) = 0;

  protected:
    ~PairSink() = default;
};

// Receives all pairs when a snapshot is loaded. Implemented by the owner of the contacts; throws if no contact has that
// id.
struct PairReader {
    virtual void pair(std::uint32_t shape_a, std::uint32_t shape_b, std::uint32_t contact) = 0;

  protected:
    ~PairReader() = default;
};

// New bounds of a shape (BroadPhase::set_bounds).
struct NewBounds {
    std::uint32_t shape;
    DBounds tight;
    math::Vec3 displacement; // m, expected over the next step
};

class BroadPhase {
  public:
    enum class Mobility : std::uint8_t { fixed, awake };
    static constexpr std::uint32_t none = 0xffffffffu;

    // m: the fat box contains the tight bounds with this margin on every side, swept along the expected displacement.
    static constexpr double required_margin = 0.01;
    // The extra margin of a new fat box is the smaller of these: in m, and as a share of the shape's largest extent.
    static constexpr double fat_margin = 0.01, fat_fraction = 0.025;
    // An awake shape is large if its size is at least this many times the median size.
    static constexpr float large_ratio = 8.0f;
    // m: the origin of the trees moves when the median position of the awake shapes is farther from it than this.
    static constexpr double origin_distance = 4096.0;
    // The least number of steps between two sorts of the slots. They are sorted when as many boxes have changed as
    // there are slots.
    static constexpr std::uint32_t steps_between_sorts = 16;

    // `kernels` must outlive the broad phase.
    explicit BroadPhase(const BroadKernels& kernels) : kernels_(kernels) {}

    // --- Shapes. The index of a removed shape may be reused only after the next update. Queries see all changes at
    // once; pairs change at the next update. Bounds that are NaN count as unbounded.

    // A `kinematic` shape makes no pairs with fixed shapes, planes and other kinematic shapes, unless one of the two is
    // a trigger; ignored for fixed shapes.
    void add(std::uint32_t shape, const DBounds& tight, Mobility mobility, bool kinematic = false,
             bool trigger = false);
    // Adds a fixed half-space, solid below the plane through `point` with the unit `normal`; a sheet is only the plane
    // itself.
    void add_plane(std::uint32_t shape, math::DVec3 point, math::Vec3 normal, bool is_sheet = false,
                   bool trigger = false);
    void move_plane(std::uint32_t shape, math::DVec3 point, math::Vec3 normal);
    // Reserves storage for a shape that has no proxy (yet), so that its state can be queried.
    void make_room(std::uint32_t shape);
    // Removes a shape; its pairs are reported lost at the next update.
    void remove(std::uint32_t shape);
    // Updates the tight bounds of any shape except a plane. `displacement` is the motion expected over the next step,
    // m: pairs are found ahead of it.
    void set_bounds(std::uint32_t shape, const DBounds& tight, math::Vec3 displacement = {});
    // Like set_bounds, but always makes a new fat box: for a shape whose geometry has changed.
    void renew_bounds(std::uint32_t shape, const DBounds& tight, math::Vec3 displacement);
    // How far bounds and displacement together may change before set_bounds would make a new fat box, m; negative if it
    // would now. Thread-safe.
    double room(std::uint32_t shape, const DBounds& tight, math::Vec3 displacement) const {
        return fat_box_clearance(fat_[shape], tight, displacement);
    }
    // set_bounds for many shapes, each listed once, in any order, most of them awake. Uses all threads of the pool.
    void set_bounds(std::span<const NewBounds> all, ThreadPool& thread_pool);
    // Asks the sink again about all pairs of a shape, as its filter has changed: they are lost and found anew at the
    // next update.
    void refilter(std::uint32_t shape);
    bool contains(std::uint32_t shape) const {
        return shape < proxies_.size() && proxies_[shape].state != State::none &&
               proxies_[shape].state != State::removed;
    }

    // --- Sleeping. put_to_sleep turns awake shapes into one sleeping island. Pairs among shapes that do not move
    // (sleeping or fixed) are then neither traversed nor lost but kept, with their contacts, until one of the shapes
    // wakes: then they continue if the boxes still overlap, and are reported lost otherwise. `island_key` is a small
    // number of the caller's choice that no other sleeping island has.
    void put_to_sleep(std::uint32_t island_key, std::span<const std::uint32_t> shapes);
    void wake(std::uint32_t island_key);
    bool is_asleep(std::uint32_t island_key) const {
        return island_key < island_of_key_.size() && island_of_key_[island_key] != none;
    }

    // Finds the pairs that have begun or ended, and reports first all lost pairs, then all found ones, each in slot
    // order. Searches with all threads of the pool, if there is one.
    void update(PairSink& sink, ThreadPool* thread_pool = nullptr);
    // Whether to search everything as soon as anything has moved, instead of only what may have changed. The results
    // are the same.
    void set_search_all(bool all) { search_all_ = all; }

    // Calls f(shape_a, shape_b, contact) for all unfiltered pairs with an awake shape (shape_a), in slot order.
    template <class F> void for_each_pair(F&& f) const;
    // The contacts of these pairs, in the same order; `parts`: working memory.
    void list_contacts(std::vector<std::uint32_t>& contacts, std::vector<ListPart>& parts,
                       ThreadPool& thread_pool) const;
    // Calls f for the pairs kept for a sleeping island: those among its shapes, and those of its shapes with fixed
    // ones.
    template <class F> void for_each_sleeping_pair(std::uint32_t island_key, F&& f) const;

    // --- Queries: const and thread-safe. They report candidates by fat boxes: fixed, awake and sleeping shapes, and
    // planes.

    // Calls visit(shape) for all shapes whose fat boxes overlap the bounds.
    template <class F> void query_bounds(const DBounds& bounds, F&& visit) const;
    // Calls `new_max = visit(shape, max)` for shapes whose boxes the ray hits at a distance up to the current maximum,
    // roughly from near to far. A result of 0 or less ends the search.
    template <class F>
    void query_ray(math::DVec3 origin, math::DVec3 direction_unit, double max_distance, F&& visit) const;
    // Calls `new_max = visit(shape, max)` for shapes whose boxes the bounds hit when they are translated, up to the
    // fraction `max` of the translation, which is 1 at first; roughly in that order. A negative result ends the search.
    template <class F> void query_sweep(const DBounds& bounds, math::DVec3 translation, F&& visit) const;
    // Calls `new_max = visit(shape, max)` for shapes whose boxes are up to `max` from the point, roughly from near to
    // far. A negative result ends the search.
    template <class F> void query_near(math::DVec3 point, double max_distance, F&& visit) const;

    // The fat box of a shape that is not a plane, m.
    const DBounds& fat_bounds(std::uint32_t shape) const { return fat_[shape]; }

    // A box of a tree, for debug drawing.
    struct Node {
        DBounds bounds;
        enum class Tree : std::uint8_t { fixed, awake, large, sleeping } tree;
        std::uint32_t depth, parent, shape; // parent: index in the list, or none; shape: none except for leaves
    };
    // The boxes of all trees in breadth-first order, down to the given depth, and at most max_count.
    std::vector<Node> nodes(std::uint32_t max_depth, std::size_t max_count) const;

    struct Counts {
        std::uint32_t awake, large, fixed, sleeping, islands, planes;
        std::uint32_t pairs, sleeping_pairs; // including filtered ones
        // Of the last update:
        std::uint32_t moved, leaves_searched, lost, found;
        std::uint32_t sorted; // whether the slots were put into a new order
    };
    Counts counts() const;
    std::size_t bytes() const;

    // Serializes all state that later results depend on. `archive` takes a reference to a vector of a trivially
    // copyable type, or to one such object, and saves or loads it. The kernels may be those of another instruction set
    // when loading.
    template <class Archive> void serialize(Archive& archive);

    // Validates a loaded snapshot: throws Error(invalid_file) unless all references in it are valid. `shapes`: greater
    // than any shape's index. If a pair could outlive its boxes, the next update searches everything.
    // (broad_phase_check.cpp)
    void check(std::size_t shapes, PairReader& reader);

    enum class State : std::uint8_t { none, fixed, plane, awake, sleeping, removed };
    State state_of(std::uint32_t shape) const { return shape < proxies_.size() ? proxies_[shape].state : State::none; }
    // The key of the island that a sleeping shape is in.
    std::uint32_t sleeping_key(std::uint32_t shape) const { return islands_[proxies_[shape].home].key; }

  private:
    struct Proxy {
        std::uint32_t place = 0; // slot in its tree; index in the list of planes
        std::uint32_t home = 0;  // awake: 0 or 1 (large); sleeping: its island
        State state = State::none;
        std::uint8_t crowd = 0, refilter = 0, moved = 0;
    };
    // Shapes that cannot be pushed (fixed and kinematic ones) make no pairs with others of the same crowd: triggers are
    // one crowd, all others the other.
    static constexpr std::uint8_t solids = 1, triggers = 2;
    static std::uint8_t immovable_group_of(bool trigger) { return trigger ? triggers : solids; }
    struct Plane {
        math::DVec3 point, normal;
        std::uint32_t shape = 0, is_sheet = 0;
    };
    // A box that has changed since the last update. Flags are cleared, and leaves marked, from this list.
    struct Change {
        TreeBox before;
        std::uint32_t shape, slot, home;
    };
    struct Island {
        std::uint32_t key, top_slot;
        std::uint32_t node_base, node_count; // all levels, leaves first, in island_nodes_
        std::uint32_t shape_base, shape_count;
        std::uint32_t alive_count, first_pair; // first_pair: of a linked list through kept_
        std::uint32_t removal;                 // a shape in one of its kept pairs may have been removed
    };
    // A pair of shapes that do not move, kept while they sleep.
    struct KeptPair {
        std::uint32_t shape_a, shape_b, contact, next;
    };
    struct EndedPair {
        std::uint32_t shape_a, shape_b, contact, matched;
    };
    struct FoundPair {
        std::uint32_t home, leaf, offset, shape_a, shape_b; // offset: of the entry among the leaf's entries
    };
    // Working memory of one searching thread.
    struct Search {
        std::vector<std::uint32_t> list[2]; // leaves that overlap the group: of its own tree, of the large one
        std::vector<float> list_bounds[2];
        std::vector<std::uint32_t> row_keys, hits, islands_hit;
        RowBuffer rows = {};
        TreeView fixed = {}, top = {};
        std::vector<MetLeaf> met;                    // leaves of shapes that are not awake; met_count are valid
        std::vector<const std::uint32_t*> met_items; // for each of them, the item of its first lane
        std::size_t met_count = 0;
        std::vector<std::uint64_t> others; // row << 32 | key
    };
    // Changed rows of leaves, in the order of the search.
    struct NewRows {
        struct Leaf {
            std::uint32_t leaf, begin; // begin: among `keys`
            std::uint32_t count[8];    // keys per row
        };
        std::vector<Leaf> leaves;
        std::vector<std::uint32_t> keys;
        std::uint32_t searched = 0;
    };

    // shapes (broad_phase.cpp)
    TreeBox to_box(const DBounds& bounds) const;   // relative to the origin, rounded outward, for any bounds
    TreeBox relative(const DBounds& bounds) const; // the same for bounds in order
    TreeRay to_ray(math::DVec3 origin, math::DVec3 direction, math::DVec3 half) const;
    template <std::size_t count, class Enter, class F>
    float query_trees(const SlotTree* const (&trees)[count], float max, Enter&& enter, F&& visit) const;
    template <class Enter, class F> void query_by_distance(float max, Enter&& enter, F&& visit) const;
    Proxy& make_proxy(std::uint32_t shape);
    void place_awake(std::uint32_t shape);
    void note_change(std::uint32_t shape, const TreeBox& before);
    void note_touched(const TreeBox& box) { touched_.push_back(box); }
    void write_box(std::uint32_t shape);
    static double fat_box_clearance(const DBounds& fat, const DBounds& tight, math::Vec3 displacement);
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
    std::uint32_t drop_immovable_groups(Search& own, int which, int home, std::uint32_t count,
                                        std::uint8_t crowd) const;
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

    // Sorting and reporting (broad_phase_update.cpp).
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
    SlotTree fixed_, top_; // items of top_: indices of islands
    std::vector<Plane> planes_;
    std::vector<Island> islands_;
    std::vector<std::uint32_t> free_islands_, island_of_key_;
    std::vector<Node8> island_nodes_;
    std::vector<std::uint32_t> island_shapes_;
    std::vector<KeptPair> kept_;
    std::uint32_t first_free_kept_ = none, first_cross_pair_ = none; // cross: between two different islands
    std::uint32_t dead_island_nodes_ = 0, dead_island_shapes_ = 0, kept_count_ = 0;
    std::vector<Change> changes_;        // since the last update
    std::vector<TreeBox> touched_;       // boxes of changed shapes that are not awake, or that slept or woke
    std::vector<std::uint32_t> removed_; // shapes removed since the last update
    std::vector<std::uint32_t> refiltered_;
    std::vector<EndedPair> returned_; // kept pairs of woken shapes
    std::uint32_t all_dirty_ = 0, transfers_ = 0, removals_ = 0, shape_count_ = 0, sleeping_count_ = 0;
    std::uint32_t steps_since_sort_ = 0;
    std::uint64_t moved_since_sort_ = 0;
    float large_size_ = largest_bound; // m: least size of a large awake shape
    std::uint32_t has_kinematic_ = 0;  // whether there is, or was, a kinematic shape
    Counts last_ = {};

    // --- Scratch, kept between calls only to reuse its memory.
    bool search_all_ = false, search_all_next_ = false;
    std::uint32_t small_count_ = 0;
    std::vector<std::uint8_t> dirty_[2], crowd_[2]; // by leaf; crowd_: the crowd that all of its shapes belong to
    KdOrder kd_;
    std::vector<EndedPair> ended_, flat_;
    std::vector<FoundPair> found_;
    std::vector<Search> searches_;  // by thread
    std::vector<NewRows> new_rows_; // by chunk of groups
    std::vector<std::uint32_t> order_, items_, shape_scratch_;
    std::vector<std::int32_t> moved_shapes_;  // in ascending order
    std::vector<std::uint64_t> shape_marks_;  // to sort moved_shapes_
    std::vector<std::uint32_t> new_of_shape_; // by shape: index of its new bounds
    std::vector<Change> new_changes_;
    std::vector<ListPart> parts_;
    std::vector<PairEntry> merged_;
    std::vector<float> sizes_;
    std::vector<TreeBox> boxes_;
    std::vector<Node8> node_scratch_;
};

} // namespace cairn

#include "collision/broad_phase_queries.h" // the templates above
