#include "solver/batch_lanes.h"

#include "core/room.h"
#include "jobs/ordered_list.h"
#include "solver/contact_order.h"
#include "solver/rank_border.h"

#include <algorithm>
#include <atomic>
#include <tuple>

namespace cairn {

namespace {

constexpr int contacts_per_chunk = 1024; // for threads
constexpr std::int32_t no_row = -1;      // row of a body that gets its row later

// Creates the row of body B for a contact with a moving surface.
std::int32_t conveyor_row(BatchScratch& scratch, std::uint32_t contact) {
    const std::int32_t row = std::int32_t(scratch.row_bodies.size());
    scratch.row_bodies.push_back(none);
    scratch.conveyor_rows.push_back({row, contact});
    return row;
}

// Sorted contacts, and for each key the end of its contacts.
struct ByKey {
    const SortedContact* contacts;
    const std::uint32_t* ends;
};

class LaneFiller {
  public:
    // `all`: the contacts of the batch; `own`: those of them that this process solves.
    LaneFiller(BatchScratch& scratch, ThreadPool* thread_pool, ByKey all, std::uint32_t all_begin, ByKey own,
               std::uint32_t own_begin)
        : scratch_(scratch), thread_pool_(thread_pool), all_(all), all_begin_(all_begin), own_(own),
          own_begin_(own_begin) {}

    void run() {
        scratch_.colors.clear();
        scratch_.conveyor_rows.clear();
        const std::uint32_t begin = own_begin_;
        lay_out_overflow();
        const std::uint32_t first = own_begin_; // first contact that has a color
        lay_out_colors();
        for (const bool four_points : {false, true}) open_lanes(four_points);
        fill_overflow(begin, first);
        fill(first, own_.ends[keys_per_batch - 1]);
        if (has_late_rows_) add_late_rows(first, own_.ends[keys_per_batch - 1]);
        make_room(scratch_.one_blocks, scratch_.one_lanes);
        make_room(scratch_.four_blocks, scratch_.four_lanes);
    }

  private:
    LaneLists& lanes_of(std::uint32_t key) { return has_one_point(key) ? scratch_.one_lanes : scratch_.four_lanes; }
    std::int32_t row_of(std::int32_t body) const { return body == none ? fixed_row : scratch_.row_of_body[body]; }
    template <class Block> static void make_room(std::vector<Block>& blocks, const LaneLists& lanes) {
        if (blocks.size() * 8 < lanes.record.size()) set_size_anew(blocks, lanes.record.size() / 8);
    }

    // Appends whole blocks for `count` lanes; the last block may have empty lanes.
    BlockRun add_run(bool four_points, std::size_t count) {
        std::size_t& lanes = lane_count_[four_points];
        const std::size_t first = lanes;
        lanes = (first + count + 7) & ~std::size_t(7);
        return {four_points, std::int32_t(first / 8), std::int32_t((lanes - first) / 8)};
    }

    // Sizes the lane lists once the number of lanes is known; all lanes are empty.
    void open_lanes(bool four_points) {
        LaneLists& lanes = four_points ? scratch_.four_lanes : scratch_.one_lanes;
        const std::size_t count = lane_count_[four_points];
        const auto open = [&](std::vector<std::int32_t>& list, std::int32_t value) {
            reserve_room(list, count);
            list.assign(count, value);
        };
        open(lanes.record, -1), open(lanes.row_a, fixed_row), open(lanes.row_b, fixed_row);
    }

    // An overflow contact may share bodies with the next one, so each is a run of its own.
    void lay_out_overflow() {
        for (std::uint32_t key = 0; key < keys_per_color; ++key)
            for (; all_begin_ < all_.ends[key]; ++all_begin_) {
                const bool is_here =
                    own_begin_ < own_.ends[key] && own_.contacts[own_begin_].id == all_.contacts[all_begin_].id;
                const bool four_points = !has_one_point(key);
                scratch_.colors.push_back(
                    {add_run(true, is_here && four_points), add_run(false, is_here && !four_points)});
                own_begin_ += is_here;
            }
    }
    void fill_overflow(std::uint32_t begin, std::uint32_t end) {
        std::size_t next[2] = {};
        for (std::uint32_t k = begin; k < end; ++k) {
            const SortedContact& c = own_.contacts[k];
            std::size_t& lane = next[has_one_point(c.key)];
            put(c, lane);
            if (has_late_row(lanes_of(c.key), lane)) add_late_row(c, lane);
            lane += 8;
        }
    }

    void lay_out_colors() {
        for (std::uint32_t key = keys_per_color; key < keys_per_batch; key += keys_per_color) {
            const std::uint32_t all_end = all_.ends[key + keys_per_color - 1];
            if (all_begin_ == all_end) continue;
            all_begin_ = all_end;
            std::size_t count[2] = {0, 0};
            for (std::uint32_t k = key; k < key + keys_per_color; ++k) {
                const bool four_points = !has_one_point(k);
                // Lane of the key's first contact, whose number is `own_begin_`.
                first_lane_[k] =
                    std::ptrdiff_t(lane_count_[four_points] + count[four_points]) - std::ptrdiff_t(own_begin_);
                count[four_points] += own_.ends[k] - own_begin_;
                own_begin_ = own_.ends[k];
            }
            scratch_.colors.push_back({add_run(true, count[1]), add_run(false, count[0])});
        }
    }

    void put(const SortedContact& c, std::size_t lane) {
        LaneLists& lanes = lanes_of(c.key);
        lanes.record[lane] = std::int32_t(c.id);
        lanes.row_a[lane] = row_of(c.body_a);
        lanes.row_b[lane] = c.is_conveyor ? no_row : row_of(c.body_b);
    }
    std::size_t lane_of(std::uint32_t number) const {
        return std::size_t(std::ptrdiff_t(number) + first_lane_[own_.contacts[number].key]);
    }
    void fill(std::uint32_t begin, std::uint32_t end) {
        std::atomic<bool> has_late_rows = false;
        const int count = int(end - begin);
        for_chunks(thread_pool_, count, contacts_per_chunk, [&](int from, int to, int) {
            bool any = false;
            for (std::uint32_t k = begin + std::uint32_t(from); k < begin + std::uint32_t(to); ++k) {
                const SortedContact& c = own_.contacts[k];
                const std::size_t lane = lane_of(k);
                put(c, lane);
                any |= has_late_row(lanes_of(c.key), lane);
            }
            if (any) has_late_rows = true;
        });
        has_late_rows_ = has_late_rows;
    }

    static bool has_late_row(const LaneLists& lanes, std::size_t lane) { return lanes.row_b[lane] == no_row; }
    void add_late_row(const SortedContact& c, std::size_t lane) {
        lanes_of(c.key).row_b[lane] = c.is_conveyor ? conveyor_row(scratch_, c.id) : row_of_body(scratch_, c.body_b);
    }
    void add_late_rows(std::uint32_t begin, std::uint32_t end) {
        for (std::uint32_t k = begin; k < end; ++k) {
            const SortedContact& c = own_.contacts[k];
            const std::size_t lane = lane_of(k);
            if (has_late_row(lanes_of(c.key), lane)) add_late_row(c, lane);
        }
    }

    BatchScratch& scratch_;
    ThreadPool* const thread_pool_;
    const ByKey all_;
    std::uint32_t all_begin_;
    const ByKey own_;
    std::uint32_t own_begin_;
    std::size_t lane_count_[2] = {};            // with one contact point, with four
    std::ptrdiff_t first_lane_[keys_per_batch]; // by key, for keys that occur: offset from contact number to lane
    bool has_late_rows_ = false;
};

} // namespace

void sort_contacts(SolverScratch& solver, const IslandBatch& batch, BatchScratch& scratch, ThreadPool* thread_pool) {
    const SortedContact* const first = solver.of_batches.data() + batch.first_contact;
    std::uint32_t* const ends =
        solver.key_ends.data() + std::size_t(&batch - solver.batches.data()) * std::size_t(keys_per_batch);
    sort_in_order(
        thread_pool, batch.contact_count, contacts_per_chunk, keys_per_batch, std::uint32_t(batch.first_contact), ends,
        scratch.key_counts, [&](int k) { return std::size_t(first[k].key); },
        [&](int k, std::uint32_t place) { solver.sorted[place] = first[k]; });
    // Overflow contacts are solved one at a time, and their order so far depends on the whole world.
    const auto comes_before = [](const SortedContact& a, const SortedContact& b) {
        return std::tie(a.body_a, a.body_b, a.id) < std::tie(b.body_a, b.body_b, b.id);
    };
    std::uint32_t begin = std::uint32_t(batch.first_contact);
    for (std::uint32_t key = 0; key < keys_per_color; begin = ends[key++])
        std::sort(solver.sorted.begin() + begin, solver.sorted.begin() + ends[key], comes_before);
}

void fill_lanes(const SolverScratch& solver, const IslandBatch& batch, BatchScratch& scratch, ThreadPool* thread_pool) {
    const std::size_t number = std::size_t(&batch - solver.batches.data());
    const ByKey all{solver.sorted.data(), solver.key_ends.data() + number * keys_per_batch};
    const auto begin = std::uint32_t(batch.first_contact);
    if (!scratch.border) {
        LaneFiller(scratch, thread_pool, all, begin, all, begin).run();
        return;
    }
    std::vector<SortedContact>& own = scratch.own_contacts;
    std::uint32_t ends[keys_per_batch];
    own.clear();
    std::uint32_t k = begin;
    for (std::size_t key = 0; key < keys_per_batch; ++key) {
        for (; k < all.ends[key]; ++k)
            if (is_own(*scratch.border->cut, all.contacts[k].body_a)) own.push_back(all.contacts[k]);
        ends[key] = std::uint32_t(own.size());
    }
    LaneFiller(scratch, thread_pool, all, begin, {own.data(), ends}, 0).run();
}

} // namespace cairn
