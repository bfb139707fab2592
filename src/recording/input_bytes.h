// Random access to the bytes of a file or of memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace cairn::recording {

class InputBytes {
  public:
    // Throws Error(io) if the file cannot be read, or is not a regular file.
    explicit InputBytes(const std::filesystem::path& path);
    // `name`: replaces the file name in messages.
    InputBytes(std::string bytes, std::string name);
    ~InputBytes();
    InputBytes(InputBytes&& other) noexcept;
    InputBytes& operator=(InputBytes&&) = delete;

    const std::string& name() const { return name_; }
    std::uint64_t size() const { return size_; }
    // The range must be within `size`; throws Error(io) if the file has become shorter.
    std::string read(std::uint64_t offset, std::uint64_t size) const;

  private:
    std::string name_;
    std::string bytes_;
    int file_ = -1; // -1: the bytes are in bytes_
    std::uint64_t size_ = 0;
};

} // namespace cairn::recording
