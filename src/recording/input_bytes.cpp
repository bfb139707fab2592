#include "recording/input_bytes.h"

#include <cairn/error.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

namespace cairn::recording {

InputBytes::InputBytes(const std::filesystem::path& path) : name_(path.generic_string()) {
    file_ = open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK); // does not wait for a FIFO
    if (file_ < 0) throw Error(ErrorCode::io, name_, {}, std::string("cannot be read: ") + std::strerror(errno));
    struct stat status {};
    if (fstat(file_, &status) != 0 || !S_ISREG(status.st_mode)) {
        ::close(std::exchange(file_, -1));
        throw Error(ErrorCode::io, name_, {}, "must be a regular file: reading a recording needs random access");
    }
    size_ = std::uint64_t(status.st_size);
}

InputBytes::InputBytes(std::string bytes, std::string name)
    : name_(std::move(name)), bytes_(std::move(bytes)), size_(bytes_.size()) {}

InputBytes::~InputBytes() {
    if (file_ >= 0) ::close(file_);
}

InputBytes::InputBytes(InputBytes&& other) noexcept
    : name_(std::move(other.name_)), bytes_(std::move(other.bytes_)), file_(std::exchange(other.file_, -1)),
      size_(other.size_) {}

std::string InputBytes::read(std::uint64_t offset, std::uint64_t size) const {
    if (file_ < 0) return bytes_.substr(std::size_t(offset), std::size_t(size));
    std::string result(std::size_t(size), '\0');
    for (std::size_t done = 0; done < result.size();) {
        const ssize_t count =
            pread(file_, result.data() + done, result.size() - done, off_t(offset + std::uint64_t(done)));
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0)
            throw Error(ErrorCode::io, name_, {},
                        count < 0 ? std::string("cannot be read: ") + std::strerror(errno) : "has become shorter");
        done += std::size_t(count);
    }
    return result;
}

} // namespace cairn::recording
