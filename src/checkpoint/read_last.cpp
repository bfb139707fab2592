// Reads a checkpoint: all ranks agree on which one; then each rank reads some of the parts and broadcasts them.
#include "checkpoint/folder.h"

#include "files/checksum.h"

#include <cairn/error.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace cairn::checkpoint {

namespace fs = std::filesystem;

namespace {

using Tell = std::function<void(const std::string&)>;

[[noreturn]] void cannot_read(const fs::path& path, int error) {
    throw Error(ErrorCode::io, path.generic_string(), {}, std::string("cannot be read: ") + std::strerror(error));
}

// A file opened for reading.
class File {
  public:
    explicit File(fs::path path) : path_(std::move(path)), file_(::open(path_.c_str(), O_RDONLY | O_CLOEXEC)) {
        if (file_ < 0) cannot_read(path_, errno);
    }
    ~File() { ::close(file_); }
    File(const File&) = delete;
    File& operator=(const File&) = delete;

    std::uint64_t size() const {
        struct stat found {};
        if (::fstat(file_, &found) != 0) cannot_read(path_, errno);
        return static_cast<std::uint64_t>(found.st_size);
    }
    void read(std::span<std::byte> to) {
        while (!to.empty()) {
            const ssize_t got = ::read(file_, to.data(), to.size());
            if (got < 0 && errno == EINTR) continue;
            if (got < 0) cannot_read(path_, errno);
            if (got == 0)
                throw Error(ErrorCode::io, path_.generic_string(), {}, "has become shorter while it was read");
            to = to.subspan(static_cast<std::size_t>(got));
        }
    }

  private:
    fs::path path_;
    int file_;
};

// The ranks that read together, or this process alone.
class Readers {
  public:
    explicit Readers(Communicator* ranks) : ranks_(ranks) {}
    bool is_first() const { return !ranks_ || ranks_->rank() == 0; }
    // The rank that reads a part.
    int reader(std::size_t part) const {
        return ranks_ ? static_cast<int>(part % static_cast<std::size_t>(ranks_->size())) : 0;
    }
    bool reads(std::size_t part) const { return !ranks_ || reader(part) == ranks_->rank(); }
    bool any(bool here) const { return ranks_ ? ranks_->sum(here ? 1 : 0) > 0 : here; }
    void share(int from, std::span<std::byte> bytes) const {
        if (ranks_) ranks_->broadcast(from, bytes);
    }
    std::uint64_t share(std::uint64_t number) const {
        share(0, std::as_writable_bytes(std::span(&number, 1)));
        return number;
    }

  private:
    Communicator* ranks_;
};

// The text of an index that is complete and of this run; empty if it is not complete.
std::string index_text(const fs::path& place, const Identity& identity, const Tell& tell) {
    const fs::path path = place / "index.json";
    std::error_code ignored;
    if (!fs::exists(path, ignored)) {
        tell(place.generic_string() + ": was not finished: it has no index.json");
        return {};
    }
    try {
        File file(path);
        std::string text(file.size(), '\0');
        file.read(std::as_writable_bytes(std::span(text)));
        require_same(identity, read_index(text, path.generic_string()), path.generic_string());
        return text;
    } catch (const Error& error) {
        if (error.code() != ErrorCode::invalid_file && error.code() != ErrorCode::io) throw;
        tell(error.what());
        return {};
    }
}

// Reads this rank's parts and exchanges them. Nothing if a part is damaged on any rank.
std::optional<std::vector<std::byte>> read_parts(const Index& index, const fs::path& place, const Readers& readers,
                                                 const Tell& tell) {
    // Does `work` for this rank's parts; returns whether no rank has failed.
    const auto all_can = [&](const auto& work) {
        bool has_failed = false;
        for (std::size_t i = 0; i < index.parts.size() && !has_failed; ++i) {
            if (!readers.reads(i)) continue;
            try {
                work(i, place / index.parts[i].file);
            } catch (const Error& error) {
                tell(error.what());
                has_failed = true;
            }
        }
        return !readers.any(has_failed);
    };
    const bool have_their_sizes = all_can([&](std::size_t i, const fs::path& path) { // before memory is allocated
        if (const std::uint64_t size = File(path).size(); size != index.parts[i].bytes)
            throw Error(ErrorCode::invalid_file, path.generic_string() + ": size", std::to_string(size),
                        "must be " + std::to_string(index.parts[i].bytes) + " bytes");
    });
    if (!have_their_sizes) return std::nullopt;
    std::vector<std::uint64_t> offsets{0};
    for (const Part& part : index.parts) offsets.push_back(offsets.back() + part.bytes);
    std::vector<std::byte> bytes(offsets.back());
    const auto of_part = [&](std::size_t i) { return std::span(bytes).subspan(offsets[i], index.parts[i].bytes); };
    const bool are_whole = all_can([&](std::size_t i, const fs::path& path) {
        File(path).read(of_part(i));
        const auto found = of_part(i);
        const std::uint32_t crc = files::crc32({reinterpret_cast<const char*>(found.data()), found.size()});
        if (crc != index.parts[i].crc)
            throw Error(ErrorCode::invalid_file, path.generic_string() + ": checksum", hex(crc),
                        "is damaged: must be " + hex(index.parts[i].crc));
    });
    if (!are_whole) return std::nullopt;
    for (std::size_t i = 0; i < index.parts.size(); ++i) readers.share(readers.reader(i), of_part(i));
    return bytes;
}

} // namespace

std::optional<Checkpoint> read_last(const fs::path& folder, const Identity& identity, Communicator* ranks,
                                    const Tell& tell) {
    const Readers readers(ranks);
    const std::vector<std::uint64_t> steps = readers.is_first() ? steps_in(folder) : std::vector<std::uint64_t>{};
    const std::uint64_t count = readers.share(steps.size());
    for (std::uint64_t i = 0; i < count; ++i) {
        const std::uint64_t step = readers.share(readers.is_first() ? steps[i] : 0);
        const fs::path place = folder / ("step_" + std::to_string(step));
        std::string text = readers.is_first() ? index_text(place, identity, tell) : std::string();
        text.resize(readers.share(text.size()));
        if (text.empty()) continue;
        readers.share(0, std::as_writable_bytes(std::span(text)));
        const Index index = read_index(text, place.generic_string());
        const std::optional<std::vector<std::byte>> bytes = read_parts(index, place, readers, tell);
        if (!bytes) continue;
        Checkpoint checkpoint{index.moment, {}, place};
        auto at = bytes->begin();
        for (const std::uint64_t size : index.sections) {
            checkpoint.sections.emplace_back(at, at + static_cast<std::ptrdiff_t>(size));
            at += static_cast<std::ptrdiff_t>(size);
        }
        return checkpoint;
    }
    if (count == 0) return std::nullopt;
    throw Error(ErrorCode::invalid_file, folder.generic_string(), {},
                "has no whole checkpoint, of " + std::to_string(count) + " that were begun");
}

} // namespace cairn::checkpoint
