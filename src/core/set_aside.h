// A state set aside, so that another one can be read in its place and given up again.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace cairn {

// An archive of its own kind: what it is given changes places with what it has kept, which at first is nothing. That
// takes no time worth mention, as vectors change hands whole, and keeps their memory for the next time. It is given the
// same, in the same order, each time.
class SetAside {
  public:
    static constexpr bool reading = false;
    // Only `make_room` may throw, for want of memory, and it changes nothing of what it is given.
    enum class Mode : std::uint8_t { make_room, exchange };

    void begin(Mode mode) { mode_ = mode, next_ = 0; }

    template <class T> void operator()(std::vector<T>& v) { take(v); }
    template <class T, class F> void foretold(std::vector<T>& v, const F&) { take(v); }
    template <class T, class F> void used_part(std::vector<T>& v, const F&) { take(v); }
    template <class T>
    requires std::is_trivially_copyable_v<T>
    void operator()(T& value) { take(value); }
    // Of elements that are read in part: what is not read is the same in either place.
    template <class T> void in_part(std::vector<T>& v) {
        std::vector<T>& other = take(v);
        if (mode_ == Mode::make_room) other = v;
    }

  private:
    struct Kept {
        virtual ~Kept() = default;
    };
    template <class T> struct KeptValue final : Kept { T value{}; };
    template <class T> T& take(T& value) {
        if (next_ == all_.size()) all_.push_back(std::make_unique<KeptValue<T>>());
        T& kept = static_cast<KeptValue<T>&>(*all_[next_++]).value;
        if (mode_ == Mode::exchange) std::swap(value, kept);
        return kept;
    }
    std::vector<std::unique_ptr<Kept>> all_;
    std::size_t next_ = 0;
    Mode mode_ = Mode::make_room;
};

} // namespace cairn
