#include "cli/shared_run.h"

#include <cairn/error.h>

#include <fmt/format.h>

#include <algorithm>

#include <sys/resource.h>
#if defined(__GLIBC__)
#include <malloc.h>
#endif

namespace cairn::cli {

namespace {

constexpr std::uint64_t steps_between_looks = 60;

double peak() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

double allocated() {
#if defined(__GLIBC__)
    const struct mallinfo2 now = mallinfo2();
    return static_cast<double>(now.uordblks) + static_cast<double>(now.hblkhd);
#else
    return peak(); // other C libraries do not report it
#endif
}

} // namespace

SharedRun::SharedRun(const Ranks& ranks, World& world)
    : communicator_(ranks.communicator()), rank_(ranks.rank()), start_(processor_seconds()) {
    world.set_communicator(communicator_);
}

SharedRun::Requests SharedRun::agree(Requests here) const {
    if (!communicator_) return here;
    constexpr std::uint64_t checkpoint = std::uint64_t{1} << 32; // exceeds any number of ranks
    const std::uint64_t sum = communicator_->sum((here.end ? 1 : 0) + (is_first() && here.checkpoint ? checkpoint : 0));
    return {sum % checkpoint != 0, sum >= checkpoint};
}

void SharedRun::compare(const World& world) const {
    if (!communicator_) return;
    const std::uint64_t here = world.state_hash();
    std::uint64_t first = here;
    communicator_->broadcast(0, std::as_writable_bytes(std::span(&first, 1)));
    if (here == first) return;
    const Statistics now = world.statistics();
    throw Error(ErrorCode::wrong_state, "state", fmt::format("{:016x}", here),
                fmt::format("after step {} is not that of rank 0, {:016x}: all ranks must run the same program on the "
                            "same scene with the same options",
                            now.steps, first));
}

void SharedRun::compare_now_and_then(const World& world, std::uint64_t step) const {
    if (step % steps_between_looks == 0) compare(world);
}

std::vector<RankReport> SharedRun::reports() const {
    const Traffic traffic = communicator_ ? communicator_->traffic() : Traffic{};
    const double computed = processor_seconds() - start_ - traffic.processor_seconds;
    const RankReport own{allocated(), peak(), traffic.seconds, computed, traffic.messages, traffic.bytes};
    if (!communicator_) return {own};
    std::vector<RankReport> all(static_cast<std::size_t>(communicator_->size()), own);
    for (int rank = 0; rank < communicator_->size(); ++rank) {
        RankReport& report = all[static_cast<std::size_t>(rank)];
        communicator_->broadcast(rank, std::as_writable_bytes(std::span(&report, 1)));
    }
    return all;
}

std::string describe(const std::vector<RankReport>& reports, std::uint64_t steps) {
    if (reports.size() == 1) return {};
    RankReport most;
    for (const RankReport& report : reports) {
        most.memory = std::max(most.memory, report.memory);
        most.waited = std::max(most.waited, report.waited);
        most.messages = std::max(most.messages, report.messages);
        most.bytes = std::max(most.bytes, report.bytes);
    }
    const double count = static_cast<double>(std::max<std::uint64_t>(steps, 1));
    return fmt::format(
        "{} ranks, at most {:.1f} MB each; a step at most {:.3f} ms in messages, {:.0f} of them, {:.1f} kB\n",
        reports.size(), 1e-6 * most.memory, 1e3 * most.waited / count, static_cast<double>(most.messages) / count,
        1e-3 * static_cast<double>(most.bytes) / count);
}

} // namespace cairn::cli
