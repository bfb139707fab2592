#include "checkpoint/folder.h"

#include "files/checksum.h"
#include "files/output_file.h"

#include <cairn/error.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <ctime>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

namespace cairn::checkpoint {

namespace fs = std::filesystem;

namespace {

constexpr const char* index_name = "index.json";
constexpr std::string_view step_prefix = "step_";
constexpr std::size_t piece = std::size_t{1} << 20; // bytes per write

fs::path place_of(const fs::path& folder, std::uint64_t step) {
    return folder / (std::string(step_prefix) + std::to_string(step));
}

std::string_view as_text(std::span<const std::byte> bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

[[noreturn]] void fail_with(const fs::path& path, const char* what, int error) {
    throw Error(ErrorCode::io, path.generic_string(), {}, std::string(what) + ": " + std::strerror(error));
}

void require(const fs::path& path, const char* what, const std::error_code& error) {
    if (error) throw Error(ErrorCode::io, path.generic_string(), {}, std::string(what) + ": " + error.message());
}

// Calls take(bytes) for the bytes `begin` to `end` of the concatenated sections.
template <class F>
void for_range(std::span<const std::span<const std::byte>> sections, std::uint64_t begin, std::uint64_t end,
               const F& take) {
    for (const std::span<const std::byte> section : sections) {
        const std::uint64_t from = std::min<std::uint64_t>(begin, section.size()),
                            to = std::min<std::uint64_t>(end, section.size());
        if (to > from) take(section.subspan(from, to - from));
        begin -= from, end -= to;
    }
}

Part write_part(const fs::path& place, const std::string& name, std::span<const std::span<const std::byte>> sections,
                std::uint64_t begin, std::uint64_t end) {
    Part part{name, end - begin, 0};
    files::OutputFile file(place / name);
    for_range(sections, begin, end, [&](std::span<const std::byte> bytes) {
        part.crc = files::crc32(as_text(bytes), part.crc);
        for (; !bytes.empty(); bytes = bytes.subspan(std::min(piece, bytes.size())))
            file.write(as_text(bytes.first(std::min(piece, bytes.size()))));
    });
    file.sync();
    file.close();
    return part;
}

} // namespace

std::vector<std::uint64_t> steps_in(const fs::path& folder) {
    std::vector<std::uint64_t> steps;
    std::error_code error;
    fs::directory_iterator entry(folder, error);
    std::error_code ignored;
    if (error == std::errc::no_such_file_or_directory) return steps;
    if (error == std::errc::not_a_directory && !fs::exists(folder, ignored))
        return steps; // the path leads below a file
    for (; !error && entry != fs::directory_iterator(); entry.increment(error)) {
        const std::string name = entry->path().filename().string();
        if (!name.starts_with(step_prefix)) continue;
        std::uint64_t step = 0;
        const char *begin = name.data() + step_prefix.size(), *end = name.data() + name.size();
        const auto read = std::from_chars(begin, end, step);
        if (read.ec == std::errc() && read.ptr == end && std::to_string(step) == begin) steps.push_back(step);
    }
    require(folder, "cannot be read", error);
    std::sort(steps.rbegin(), steps.rend());
    return steps;
}

Writer::Writer(fs::path folder, Identity identity, Communicator* ranks, int keep)
    : folder_(std::move(folder)), identity_(std::move(identity)), ranks_(ranks), rank_(ranks ? ranks->rank() : 0),
      size_(ranks ? ranks->size() : 1), keep_(keep) {
    if (is_first()) {
        std::error_code error;
        fs::create_directories(folder_, error);
        require(folder_, "cannot be made", error);
        lock_ = ::open(folder_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
        if (lock_ < 0) fail_with(folder_, "cannot be opened", errno);
        if (::flock(lock_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) { // not every file system has locks
            ::close(lock_);
            throw Error(ErrorCode::wrong_state, folder_.generic_string(), {},
                        "is being written to by another program: wait for its end, or choose another folder");
        }
    }
    if (ranks_) ranks_->sum(0); // wait until the folder exists
    if (::access(folder_.c_str(), W_OK | X_OK) != 0) {
        const int error = errno;
        if (lock_ >= 0) ::close(lock_);
        fail_with(folder_, "cannot be written to", error);
    }
}

Writer::~Writer() {
    if (lock_ >= 0) ::close(lock_);
}

void Writer::compare(std::span<const std::byte> section) const {
    if (!ranks_) return;
    std::array<std::byte, 64> here{};
    std::copy_n(section.begin(), std::min(here.size(), section.size()), here.begin());
    std::array<std::byte, 64> first = here;
    ranks_->broadcast(0, first);
    if (here != first)
        throw Error(ErrorCode::wrong_state, folder_.generic_string(), {},
                    "cannot get a checkpoint: the whole state here is not that of rank 0");
}

std::vector<Part> Writer::gather(const Part& own) const {
    std::vector<Part> parts(static_cast<std::size_t>(size_), own);
    if (!ranks_) return parts;
    struct Numbers {
        std::uint64_t bytes, crc;
    };
    std::vector<Numbers> all(parts.size(), {own.bytes, own.crc});
    const auto message = [&](int rank) {
        return std::as_writable_bytes(std::span(&all[static_cast<std::size_t>(rank)], 1));
    };
    if (!is_first()) {
        const Communicator::Outgoing out{0, message(rank_)};
        ranks_->exchange({&out, 1}, {});
        return {};
    }
    std::vector<Communicator::Incoming> in;
    for (int rank = 1; rank < size_; ++rank) in.push_back({rank, message(rank)});
    if (!in.empty()) ranks_->exchange({}, in);
    for (std::size_t i = 1; i < parts.size(); ++i)
        parts[i] = {"part_" + std::to_string(i), all[i].bytes, static_cast<std::uint32_t>(all[i].crc)};
    return parts;
}

void Writer::write(const Moment& moment, std::span<const std::span<const std::byte>> sections) {
    compare(sections.front());
    const fs::path place = place_of(folder_, moment.step);
    if (is_first()) {
        std::error_code error;
        fs::remove(place / index_name, error); // first, so that an incomplete rest is never taken for a checkpoint
        fs::remove_all(place, error);
        require(place, "cannot be removed", error);
        fs::create_directory(place, error);
        require(place, "cannot be made", error);
    }
    if (ranks_) ranks_->sum(0); // wait until the folder exists and is empty
    Index index{identity_, moment, {}, {}};
    std::uint64_t bytes = 0;
    for (const std::span<const std::byte> section : sections) {
        index.sections.push_back(section.size());
        bytes += section.size();
    }
    const auto cut = [&](int rank) {
        return bytes / static_cast<std::uint64_t>(size_) * static_cast<std::uint64_t>(rank) +
               std::min<std::uint64_t>(bytes % static_cast<std::uint64_t>(size_), static_cast<std::uint64_t>(rank));
    };
    const std::clock_t start = std::clock();
    const Part own = write_part(place, "part_" + std::to_string(rank_), sections, cut(rank_), cut(rank_ + 1));
    part_seconds_ += static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    index.parts = gather(own); // waits until all ranks have written their parts
    if (!is_first()) return;
    finish(index, place);
    remove_older(moment.step);
}

void Writer::finish(const Index& index, const fs::path& place) const {
    files::sync_folder(place); // the names of the parts must be durable before the index
    files::OutputFile file(place / index_name);
    file.write(to_text(index));
    file.sync();
    file.close();
    files::sync_folder(place);
    files::sync_folder(folder_);
}

void Writer::remove_older(std::uint64_t step) const {
    int kept = 0;
    for (const std::uint64_t other : steps_in(folder_)) {
        if (other > step) continue; // damaged, or this run would have started there
        const fs::path place = place_of(folder_, other);
        std::error_code error;
        if (fs::exists(place / index_name, error) && kept < keep_) {
            ++kept;
            continue;
        }
        fs::remove(place / index_name, error);
        fs::remove_all(place, error);
        require(place, "cannot be removed", error);
    }
}

} // namespace cairn::checkpoint
