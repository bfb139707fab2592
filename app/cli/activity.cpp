#include "cli/activity.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <new>

namespace cairn::cli {

namespace {

constexpr std::size_t reserve_bytes = std::size_t{8} << 20;

std::array<char, 300> activity{"starting"};
std::atomic<std::uint64_t> count_done{0}, count_total{0};
std::atomic<void*> reserve{nullptr};
std::terminate_handler terminate_before = nullptr;

void give_reserve_free() {
    std::free(reserve.exchange(nullptr));
    throw std::bad_alloc();
}

// Terminate handler, reached when memory runs out during destruction (destroying a JSON document allocates), or on a
// thread whose exceptions nobody catches.
[[noreturn]] void end_after_terminate() {
    try {
        if (const std::exception_ptr error = std::current_exception()) std::rethrow_exception(error);
    } catch (const std::bad_alloc&) {
        report_out_of_memory();
        _exit(1);
    } catch (...) { // not out of memory: the default behavior
    }
    if (terminate_before != nullptr) terminate_before();
    std::abort();
}

} // namespace

void set_activity(std::string_view doing, std::string_view what) {
    count_total = 0;
    std::snprintf(activity.data(), activity.size(), "%.*s%s%.*s", static_cast<int>(doing.size()), doing.data(),
                  what.empty() ? "" : " ", static_cast<int>(std::min<std::size_t>(what.size(), 200)), what.data());
}

void set_activity_count(std::uint64_t done, std::uint64_t total) {
    count_done.store(done, std::memory_order_relaxed);
    count_total.store(total, std::memory_order_relaxed);
}

void prepare_for_out_of_memory() {
    reserve = std::malloc(reserve_bytes);
    std::set_new_handler(give_reserve_free);
    terminate_before = std::set_terminate(end_after_terminate);
}

void report_out_of_memory() noexcept {
    std::array<char, 500> line{};
    const std::uint64_t done = count_done, total = count_total;
    int length = std::snprintf(line.data(), line.size(), "cairn: out of memory while %s", activity.data());
    const auto rest = [&] { return line.size() - static_cast<std::size_t>(length); };
    if (total > 0) {
        length += std::snprintf(line.data() + length, rest(), ", after %llu of %llu steps",
                                static_cast<unsigned long long>(done), static_cast<unsigned long long>(total));
    }
    for (int i = 0; i < length; ++i) {
        if (static_cast<unsigned char>(line[static_cast<std::size_t>(i)]) < ' ')
            line[static_cast<std::size_t>(i)] = ' ';
    }
    length += std::snprintf(line.data() + length, rest(), "\n");
    const ssize_t written = write(STDERR_FILENO, line.data(), static_cast<std::size_t>(length));
    static_cast<void>(written); // a failure cannot be reported
}

} // namespace cairn::cli
