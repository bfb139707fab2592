#include "sweep/store.h"

#include "sweep/numbers.h"

#include <algorithm>
#include <bit>
#include <cerrno>
#include <cstring>
#include <string>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

namespace cairn::sweep {

namespace {

constexpr std::uint64_t chunks_wanted = 4096, largest_chunk = 256;

[[noreturn]] void fail_with(const std::filesystem::path& path, const char* what, int error) {
    throw Error(ErrorCode::io, path.generic_string(), {}, std::string(what) + ": " + std::strerror(error));
}

// A file descriptor that is closed by its destructor.
class Descriptor {
  public:
    explicit Descriptor(int file) : file_(file) {}
    ~Descriptor() {
        if (file_ >= 0) ::close(file_);
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    int get() const { return file_; }

  private:
    int file_;
};

// Returns whether `size` bytes could be read.
bool read_at(int file, std::int64_t offset, void* to, std::size_t size, const std::filesystem::path& path) {
    char* at = static_cast<char*>(to);
    while (size > 0) {
        const ssize_t got = ::pread(file, at, size, offset);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) fail_with(path, "cannot be read", errno);
        if (got == 0) return false;
        at += got, offset += got, size -= static_cast<std::size_t>(got);
    }
    return true;
}

void write_whole(int file, const std::vector<char>& bytes, const std::filesystem::path& path) {
    for (std::size_t done = 0; done < bytes.size();) {
        const ssize_t sent = ::write(file, bytes.data() + done, bytes.size() - done);
        if (sent < 0 && errno == EINTR) continue;
        if (sent < 0) fail_with(path, "cannot be written", errno);
        done += static_cast<std::size_t>(sent);
    }
}

std::uint64_t checksum_of(std::uint64_t chunk, std::span<const double> numbers) {
    RowHash sum;
    for (const double number : numbers) sum.add(number);
    return hash_pair(sum.value(), chunk);
}

} // namespace

void RowHash::add(double number) {
    // FNV-1a over 64-bit words instead of bytes.
    hash_ = (hash_ ^ std::bit_cast<std::uint64_t>(number)) * 0x100000001b3u;
    hash_ ^= hash_ >> 29;
}

Chunks::Chunks(std::uint64_t all) : rows(all) {
    size = std::clamp<std::uint64_t>(rows / chunks_wanted, 1, largest_chunk);
    count = (rows + size - 1) / size;
}

Store::Store(const std::filesystem::path& folder, const Plan& plan, const Start& start)
    : folder_(folder / "shards"), chunks_(plan.design.rows()), numbers_(plan.numbers()),
      header_{{'c', 'a', 'i', 'r', 'n', 's', 'w', '1'}, start.fingerprint, chunks_.rows, chunks_.size, numbers_},
      places_(chunks_.count) {
    std::error_code error;
    std::filesystem::create_directories(folder_, error);
    if (error) {
        throw Error(ErrorCode::io, folder_.generic_string(), {}, "cannot be made: " + error.message());
    }
    if (::access(folder_.c_str(), W_OK | X_OK) != 0) fail_with(folder_, "cannot be written to", errno);
    look();
}

Store::~Store() {
    if (file_ >= 0) ::close(file_);
}

void Store::look() {
    std::fill(places_.begin(), places_.end(), Place{});
    shards_.clear();
    std::error_code error;
    std::vector<std::filesystem::path> found;
    for (auto entry = std::filesystem::directory_iterator(folder_, error); !error && entry != end(entry);
         entry.increment(error)) {
        if (entry->path().extension() == ".rows") found.push_back(entry->path());
    }
    if (error) throw Error(ErrorCode::io, folder_.generic_string(), {}, "cannot be read: " + error.message());
    std::sort(found.begin(), found.end());
    for (const std::filesystem::path& path : found) look_into(path);
}

void Store::look_into(const std::filesystem::path& path) {
    const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
    if (file.get() < 0) fail_with(path, "cannot be opened", errno);
    Header header;
    if (!read_at(file.get(), 0, &header, sizeof header, path)) return; // the writer was killed before it wrote anything
    if (std::memcmp(&header, &header_, sizeof header) != 0) {
        throw Error(
            ErrorCode::wrong_state, path.generic_string(), {},
            "is of another sweep: the plan, the scene or the program has changed. Choose another folder with --out");
    }
    shards_.push_back(path);
    std::vector<double> numbers;
    std::int64_t offset = sizeof header;
    for (Block block; read_at(file.get(), offset, &block, sizeof block, path);) {
        offset += static_cast<std::int64_t>(sizeof block);
        if (block.chunk >= chunks_.count) return;
        numbers.resize(static_cast<std::size_t>(chunks_.rows_in(block.chunk)) * numbers_);
        const std::size_t size = bytes_of(block.chunk);
        if (!read_at(file.get(), offset, numbers.data(), size, path)) return;
        if (checksum_of(block.chunk, numbers) != block.checksum) return;
        places_[block.chunk] = {static_cast<int>(shards_.size()) - 1, offset};
        offset += static_cast<std::int64_t>(size);
    }
}

bool Store::is_empty() const {
    return std::none_of(places_.begin(), places_.end(), [](const Place& place) { return place.shard >= 0; });
}

std::vector<std::uint64_t> Store::missing() const {
    std::vector<std::uint64_t> chunks;
    for (std::uint64_t i = 0; i < chunks_.count; ++i) {
        if (!has(i)) chunks.push_back(i);
    }
    return chunks;
}

void Store::open_shard() {
    for (int number = 0;; ++number) {
        own_ = folder_ / (std::to_string(number) + ".rows");
        file_ = ::open(own_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_APPEND | O_CLOEXEC, 0666);
        if (file_ >= 0) break;
        if (errno != EEXIST) fail_with(own_, "cannot be made", errno);
    }
    std::vector<char> bytes(sizeof header_);
    std::memcpy(bytes.data(), &header_, sizeof header_);
    write_whole(file_, bytes, own_);
}

void Store::append(std::uint64_t chunk, std::span<const double> numbers) {
    const Block block{chunk, checksum_of(chunk, numbers)};
    std::vector<char> bytes(sizeof block + numbers.size_bytes());
    std::memcpy(bytes.data(), &block, sizeof block);
    std::memcpy(bytes.data() + sizeof block, numbers.data(), numbers.size_bytes());
    const std::lock_guard<std::mutex> lock(mutex_);
    if (file_ < 0) open_shard();
    write_whole(file_, bytes, own_);
}

void Store::read(const std::function<void(std::uint64_t, std::span<const double>)>& take) const {
    std::vector<double> numbers;
    std::vector<std::unique_ptr<Descriptor>> files(shards_.size());
    for (std::uint64_t chunk = 0; chunk < chunks_.count; ++chunk) {
        const Place place = places_[chunk];
        if (place.shard < 0) continue;
        const auto shard = static_cast<std::size_t>(place.shard);
        const std::filesystem::path& path = shards_[shard];
        if (!files[shard]) {
            files[shard] = std::make_unique<Descriptor>(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
            if (files[shard]->get() < 0) fail_with(path, "cannot be opened", errno);
        }
        numbers.resize(static_cast<std::size_t>(chunks_.rows_in(chunk)) * numbers_);
        if (!read_at(files[shard]->get(), place.offset, numbers.data(), bytes_of(chunk), path)) {
            throw Error(ErrorCode::io, path.generic_string(), {}, "has become shorter");
        }
        for (std::uint64_t i = 0; i < chunks_.rows_in(chunk); ++i) {
            take(chunks_.first(chunk) + i, std::span<const double>(numbers).subspan(i * numbers_, numbers_));
        }
    }
}

} // namespace cairn::sweep
