#include "cli/ranks.h"

#include "cli/activity.h"
#include "cli/outputs.h"

#include <cairn/error.h>

#include <chrono>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <filesystem>
#include <new>
#include <string>

#include <fmt/format.h>

#include <dlfcn.h>

namespace cairn::cli {

namespace {

// Whether Open MPI or another MPI launcher has started this process.
bool was_started_by_mpi() {
    for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "PMIX_RANK"}) {
        if (std::getenv(name) != nullptr) return true;
    }
    return false;
}

template <class F> void look_up(void* library, const char* name, F*& function) {
    function = reinterpret_cast<F*>(dlsym(library, name));
    if (function == nullptr) {
        throw Error(ErrorCode::unsupported, "cairn_ranks.so", {}, std::string("has no function ") + name);
    }
}

} // namespace

Ranks::Ranks(const char* otherwise) {
    if (!was_started_by_mpi()) return;
    std::error_code ignored;
    const std::filesystem::path folder = std::filesystem::read_symlink("/proc/self/exe", ignored).parent_path();
    void* library = nullptr;
    std::string why;
    for (const char* place : {"cairn_ranks.so", "../lib/cairn/cairn_ranks.so"}) {
        const std::filesystem::path path = folder / place;
        if (!std::filesystem::exists(path, ignored)) continue;
        library = dlopen(path.c_str(), RTLD_NOW | RTLD_GLOBAL); // RTLD_GLOBAL: the plugins of Open MPI need its symbols
        if (library != nullptr) break;
        why = dlerror();
    }
    if (library == nullptr) {
        throw Error(ErrorCode::unsupported, "mpirun", {},
                    why.empty() ? std::string("has started a program that was built without MPI: install "
                                              "libopenmpi-dev and openmpi-bin and build again, or ") +
                                      otherwise
                                : "cannot be used: " + why);
    }
    look_up(library, "cairn_ranks_begin", mpi_.begin);
    look_up(library, "cairn_ranks_next", mpi_.next);
    look_up(library, "cairn_ranks_taken", mpi_.taken);
    look_up(library, "cairn_ranks_meet", mpi_.meet);
    look_up(library, "cairn_ranks_exchange", mpi_.exchange);
    look_up(library, "cairn_ranks_broadcast", mpi_.broadcast);
    look_up(library, "cairn_ranks_sum", mpi_.sum);
    look_up(library, "cairn_ranks_end", mpi_.end);
    look_up(library, "cairn_ranks_abort", mpi_.abort);
    mpi_.begin(&rank_, &size_);
    has_mpi_ = true;
}

Ranks::~Ranks() {
    if (has_mpi_) mpi_.end();
}

std::uint64_t Ranks::next() {
    if (!has_mpi_) return alone_.next();
    const std::lock_guard<std::mutex> lock(mutex_);
    return static_cast<std::uint64_t>(mpi_.next());
}

void Ranks::poll() {
    if (!has_mpi_) return;
    const std::lock_guard<std::mutex> lock(mutex_);
    taken_ = static_cast<std::uint64_t>(mpi_.taken());
}

std::shared_ptr<CountingCommunicator> Ranks::communicator() const {
    if (size_ == 1) return nullptr;
    return std::make_shared<CountingCommunicator>(mpi_, rank_, size_);
}

void Ranks::meet() {
    if (has_mpi_) mpi_.meet();
}

int Ranks::run(const std::function<int()>& command) {
    if (size_ == 1) return command();
    try {
        return command();
    } catch (const std::bad_alloc&) {
        report_out_of_memory();
    } catch (const std::exception& error) {
        complain(fmt::format("rank {}: {}", rank_, error.what()));
    }
    mpi_.abort(1);
    return 1;
}

namespace {

// Adds its lifetime to the traffic's times.
class Watch {
  public:
    explicit Watch(Traffic& traffic) : traffic_(traffic) {}
    ~Watch() {
        traffic_.seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
        traffic_.processor_seconds += processor_seconds() - processor_start_;
    }
    Watch(const Watch&) = delete;
    Watch& operator=(const Watch&) = delete;

  private:
    Traffic& traffic_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    double processor_start_ = processor_seconds();
};

} // namespace

double processor_seconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

void CountingCommunicator::exchange(std::span<const Outgoing> out, std::span<const Incoming> in) {
    const Watch watch(traffic_);
    messages_.clear();
    for (const Outgoing& message : out) {
        // MPI takes sent data by pointer to const; this list holds sent and received data.
        messages_.push_back({message.rank, const_cast<std::byte*>(message.bytes.data()), message.bytes.size()});
        traffic_.bytes += message.bytes.size();
    }
    for (const Incoming& message : in) messages_.push_back({message.rank, message.bytes.data(), message.bytes.size()});
    traffic_.messages += out.size();
    mpi_.exchange(messages_.data(), static_cast<int>(out.size()), static_cast<int>(messages_.size()));
}

void CountingCommunicator::broadcast(int root, std::span<std::byte> bytes) {
    const Watch watch(traffic_);
    traffic_.messages += root == rank_;
    traffic_.bytes += root == rank_ ? bytes.size() : 0;
    mpi_.broadcast(root, bytes.data(), bytes.size());
}

std::uint64_t CountingCommunicator::sum(std::uint64_t number) {
    const Watch watch(traffic_);
    ++traffic_.messages;
    traffic_.bytes += sizeof number;
    return mpi_.sum(number);
}

} // namespace cairn::cli
