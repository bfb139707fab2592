// Bytes as their difference from other bytes: a frame of zstd that has those as its prefix, as `zstd --patch-from`
// makes them. Also where things have moved within them, as contacts do that come and go.
#pragma once

#include <memory>
#include <string>
#include <string_view>

namespace cairn::recording {

// Its memory is kept from one to the next.
class Patcher {
  public:
    Patcher();
    ~Patcher();
    Patcher(const Patcher&) = delete;
    Patcher& operator=(const Patcher&) = delete;
    // What `patched` makes `after` of, together with `before`, which may be empty.
    std::string patch(std::string_view before, std::string_view after);

  private:
    struct Context;
    std::unique_ptr<Context> context_;
};

// Throws Error(invalid_file), which names `where`, if that was not made from `before`.
std::string patched(std::string_view before, std::string_view patch, const std::string& where);

} // namespace cairn::recording
