#include "cli/ranks.h"

#include <cairn/error.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include <dlfcn.h>

namespace cairn::cli {

namespace {

// Whether Open MPI or another starter of MPI has started this process.
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

Ranks::Ranks() {
    if (!was_started_by_mpi()) return;
    std::error_code ignored;
    const std::filesystem::path folder = std::filesystem::read_symlink("/proc/self/exe", ignored).parent_path();
    void* library = nullptr;
    std::string why;
    for (const char* place : {"cairn_ranks.so", "../lib/cairn/cairn_ranks.so"}) {
        const std::filesystem::path path = folder / place;
        if (!std::filesystem::exists(path, ignored)) continue;
        library = dlopen(path.c_str(), RTLD_NOW | RTLD_GLOBAL); // Open MPI's parts find it by that
        if (library != nullptr) break;
        why = dlerror();
    }
    if (library == nullptr) {
        throw Error(ErrorCode::unsupported, "mpirun", {},
                    why.empty() ? "has started a program that was built without MPI: install libopenmpi-dev and "
                                  "openmpi-bin and build again, or use --shard I/N"
                                : "cannot be used: " + why);
    }
    look_up(library, "cairn_ranks_begin", mpi_.begin);
    look_up(library, "cairn_ranks_next", mpi_.next);
    look_up(library, "cairn_ranks_taken", mpi_.taken);
    look_up(library, "cairn_ranks_meet", mpi_.meet);
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

void Ranks::attend() {
    if (!has_mpi_) return;
    const std::lock_guard<std::mutex> lock(mutex_);
    taken_ = static_cast<std::uint64_t>(mpi_.taken());
}

void Ranks::meet() {
    if (has_mpi_) mpi_.meet();
}

void Ranks::abort_others(int code) {
    if (has_mpi_ && size_ > 1) mpi_.abort(code);
}

} // namespace cairn::cli
