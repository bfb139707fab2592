// Bytes of a file, or of memory, to be read anywhere.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace cairn::recording {

class InputBytes {
  public:
    // Throws Error(io) if it cannot be read, or is no regular file.
    explicit InputBytes(const std::filesystem::path& path);
    // `name`: stands for the file in messages.
    InputBytes(std::string bytes, std::string name);
    ~InputBytes();
    InputBytes(InputBytes&& other) noexcept;
    InputBytes& operator=(InputBytes&&) = delete;

    const std::string& name() const { return name_; }
    std::uint64_t size() const { return size_; }
    // All of it must be within `size`; throws Error(io) if it is not there any more.
    std::string read(std::uint64_t offset, std::uint64_t size) const;

  private:
    std::string name_;
    std::string bytes_;
    int file_ = -1; // none: bytes_
    std::uint64_t size_ = 0;
};

} // namespace cairn::recording
