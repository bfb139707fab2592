// Runs chunks of rows on the threads of this process.
#pragma once

#include "sweep/plan.h"
#include "sweep/store.h"

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace cairn::sweep {

// Hands out chunks, each once: to the threads of this process, or of several.
class Source {
  public:
    Source() = default;
    virtual ~Source() = default;
    Source(const Source&) = delete;
    Source& operator=(const Source&) = delete;

    // Returns an index into the list of missing chunks; thread-safe. An index beyond its end means that none is left.
    virtual std::uint64_t next() = 0;
    // Called periodically by the thread that called `run_chunks`.
    virtual void poll() {}
};

class LocalSource : public Source {
  public:
    std::uint64_t next() override { return next_++; }

  private:
    std::atomic<std::uint64_t> next_{0};
};

struct Count {
    std::uint64_t rows = 0, failed = 0;
};

// Runs the rows of `chunks`. `goes_on` is called about fifty times a second; once it returns false, unfinished chunks
// are abandoned. Rethrows what a thread has thrown: Error (io, invalid_file), std::bad_alloc.
Count run_chunks(const Plan& plan, const Start& start, Store& store, const std::vector<std::uint64_t>& chunks,
                 int threads, Source& source, const std::function<bool(const Count&)>& goes_on);

} // namespace cairn::sweep
