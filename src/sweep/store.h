// Stores rows in files of whole chunks, which any number of processes write side by side in one folder.
#pragma once

#include "sweep/plan.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <mutex>
#include <span>
#include <vector>

namespace cairn::sweep {

// The division of rows into chunks: the unit that is handed out, written, and lost when a process is killed.
struct Chunks {
    explicit Chunks(std::uint64_t rows);
    std::uint64_t first(std::uint64_t chunk) const { return chunk * size; }
    std::uint64_t rows_in(std::uint64_t chunk) const { return chunk + 1 < count ? size : rows - first(chunk); }
    std::uint64_t rows = 0, size = 1, count = 0;
};

class Store {
  public:
    // Creates a folder `shards` in `folder`, if there is none. Throws Error: io; wrong_state, if shards of another
    // sweep are there.
    Store(const std::filesystem::path& folder, const Plan& plan, const Start& start);
    ~Store();
    Store(const Store&) = delete;
    Store& operator=(const Store&) = delete;

    const Chunks& chunks() const { return chunks_; }
    // Scans the shards for finished chunks. A chunk that is truncated at the end of a shard does not count. Throws
    // Error (io).
    void look();
    bool has(std::uint64_t chunk) const { return places_[chunk].shard >= 0; }
    bool is_empty() const; // whether no shard has any chunk
    std::vector<std::uint64_t> missing() const;

    // Appends a chunk to the shard of this store. Thread-safe. Throws Error (io).
    void append(std::uint64_t chunk, std::span<const double> numbers);

    // Reads all rows found by the last `look`, in order. Throws Error (io).
    void read(const std::function<void(std::uint64_t row, std::span<const double> numbers)>& take) const;

  private:
    struct Place {
        int shard = -1;
        std::int64_t offset = 0;
    };
    struct Header {
        char magic[8];
        std::uint64_t fingerprint, rows, chunk, numbers;
    };
    struct Block {
        std::uint64_t chunk, checksum;
    };
    void open_shard();
    void look_into(const std::filesystem::path& path);
    std::size_t bytes_of(std::uint64_t chunk) const {
        return static_cast<std::size_t>(chunks_.rows_in(chunk)) * numbers_ * sizeof(double);
    }

    std::filesystem::path folder_;
    Chunks chunks_;
    std::size_t numbers_;
    Header header_;
    std::vector<Place> places_;
    std::vector<std::filesystem::path> shards_;
    std::mutex mutex_;
    std::filesystem::path own_;
    int file_ = -1;
};

// A hash of numbers in their order, over their bits.
class RowHash {
  public:
    void add(double number);
    std::uint64_t value() const { return hash_; }

  private:
    std::uint64_t hash_ = 0xcbf29ce484222325u;
};

} // namespace cairn::sweep
