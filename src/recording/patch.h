// Binary patches: bytes as a zstd frame that has other bytes as its prefix, as made by `zstd --patch-from`. It also
// finds data that has moved, such as the contacts after one that was added or removed.
#pragma once

#include <memory>
#include <string>
#include <string_view>

namespace cairn::recording {

// Keeps its memory between calls.
class Patcher {
  public:
    Patcher();
    ~Patcher();
    Patcher(const Patcher&) = delete;
    Patcher& operator=(const Patcher&) = delete;
    // A patch from which `patched` restores `after`, given `before`, which may be empty.
    std::string patch(std::string_view before, std::string_view after);

  private:
    struct Context;
    std::unique_ptr<Context> context_;
};

// Throws Error(invalid_file), which names `where`, if the patch was not made from `before`.
std::string patched(std::string_view before, std::string_view patch, const std::string& where);

} // namespace cairn::recording
