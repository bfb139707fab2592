// A state set aside, so that another one can be loaded in its place, and discarded again.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace cairn {

// An archive that exchanges what it is given with what it keeps, which at first is empty. This takes negligible time,
// as vectors are swapped as a whole, and reuses their memory the next time. It must be given the same objects, in the
// same order, each time.
class SetAside {
  public:
    static constexpr bool reading = false;
    // Only `make_room` may throw, if memory runs out, and it does not change what it is given.
    enum class Mode : std::uint8_t { make_room, exchange };

    void begin(Mode mode) { mode_ = mode, next_ = 0; }

    template <class T> void operator()(std::vector<T>& v) { take(v); }
    template <class T, class F> void predicted(std::vector<T>& v, const F&) { take(v); }
    template <class T, class F> void live_part(std::vector<T>& v, const F&) { take(v); }
    template <class T>
    requires std::is_trivially_copyable_v<T>
    void operator()(T& value) { take(value); }
    // For elements that are loaded only in part: the rest must be the same in both copies.
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
