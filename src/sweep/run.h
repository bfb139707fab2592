// Runs chunks of rows on the threads of this program.
#pragma once

#include "sweep/plan.h"
#include "sweep/store.h"

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace cairn::sweep {

// Hands out what is to be done, each once: to the threads of this program, or of many.
class Source {
  public:
    Source() = default;
    virtual ~Source() = default;
    Source(const Source&) = delete;
    Source& operator=(const Source&) = delete;

    // The place in the list of what is missing; from any thread. Too large: nothing is left.
    virtual std::uint64_t next() = 0;
    // Called now and then by the thread that called `run_chunks`.
    virtual void attend() {}
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

// Runs the rows of `chunks`. `goes_on` is asked some fifty times a second; once it says no, chunks that were begun are
// given up. Throws what a thread threw: Error (io, invalid_file), std::bad_alloc.
Count run_chunks(const Plan& plan, const Start& start, Store& store, const std::vector<std::uint64_t>& chunks,
                 int threads, Source& source, const std::function<bool(const Count&)>& goes_on);

} // namespace cairn::sweep
