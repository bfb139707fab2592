#include "viewer/kept_states.h"

#include "recording/patch.h"

#include <condition_variable>
#include <deque>
#include <functional>
#include <iterator>
#include <limits>
#include <mutex>
#include <string_view>
#include <thread>
#include <utility>

namespace cairn::viewer {

namespace {

constexpr double least_between = 0.1; // s; compute time of steps between kept states: an acceptable wait when seeking
// Greatest share of the steps' compute time that saving states and computing their differences may take, mostly on the
// helper thread. With a smaller share, seeking in a scene with thousands of bodies would take longer than half a
// second.
constexpr double greatest_share = 0.125;

recording::WholeState shared_text(std::string text) {
    auto owner = std::make_shared<const std::string>(std::move(text));
    return {owner, *owner};
}

} // namespace

// The thread that computes differences, one after the other. Pending differences are dropped at its end.
class KeptStates::Helper {
  public:
    using Work = std::packaged_task<std::string(recording::Patcher&)>;
    Helper() : thread_([this] { run(); }) {}
    ~Helper() {
        {
            const std::lock_guard lock(mutex_);
            is_ending_ = true;
        }
        changed_.notify_one();
        thread_.join();
    }
    Helper(const Helper&) = delete;
    Helper& operator=(const Helper&) = delete;

    Patch patch(PatchChain before, recording::WholeState after) {
        Work work([from = std::move(before), to = std::move(after)](recording::Patcher& patcher) {
            return patcher.patch(from.end().bytes, to.bytes);
        });
        Patch result = work.get_future().share();
        {
            const std::lock_guard lock(mutex_);
            waiting_.push_back(std::move(work));
        }
        changed_.notify_one();
        return result;
    }

  private:
    void run() {
        recording::Patcher patcher;
        for (;;) {
            Work work;
            {
                std::unique_lock lock(mutex_);
                changed_.wait(lock, [&] { return is_ending_ || !waiting_.empty(); });
                if (is_ending_) return;
                work = std::move(waiting_.front());
                waiting_.pop_front();
            }
            work(patcher);
        }
    }

    std::mutex mutex_; // guards the next three members
    std::condition_variable changed_;
    std::deque<Work> waiting_;
    bool is_ending_ = false;
    std::thread thread_; // last: all other members must exist when it starts
};

KeptStates::KeptStates() : tree_(least_between, greatest_share, std::numeric_limits<std::size_t>::max()) {}

recording::WholeState KeptStates::PatchChain::end() const {
    recording::WholeState state = start;
    for (const Patch& patch : patches)
        state = shared_text(recording::patched(state.bytes, patch.get(), "a state of the timeline"));
    return state;
}

KeptStates::PatchChain KeptStates::patches_to(std::uint64_t step) const {
    PatchChain way;
    for (;;) {
        const Kept& kept = states_.at(step);
        if (const auto whole = tree_.in_memory(kept.id)) {
            way.start = *whole;
            break;
        }
        way.patches.insert(way.patches.begin(), kept.patch);
        if (kept.parent == step) break;
        step = kept.parent;
    }
    return way;
}

void KeptStates::keep(const World& world, std::uint64_t step) {
    settle();
    if (!helper_) helper_ = std::make_shared<Helper>();
    Snapshot snapshot = world.save();
    auto bytes = std::make_shared<const std::vector<std::byte>>(std::move(snapshot.bytes));
    const std::string_view text(reinterpret_cast<const char*>(bytes->data()), bytes->size());
    Kept kept{0, step, {}, bytes->size(), std::move(snapshot.definitions), world.state_digest()};
    const recording::WholeState whole{std::move(bytes), text};
    const auto difference = states_.empty() ? tree_.add_beginning(whole) : tree_.add(whole);
    kept.id = difference.id;
    PatchChain before;
    for (const auto& [at, other] : states_)
        if (other.id == difference.parent) kept.parent = at;
    if (difference.before)
        before.start = *difference.before;
    else if (kept.parent != step)
        before = patches_to(kept.parent);
    kept.patch = helper_->patch(std::move(before), whole);
    states_.insert_or_assign(step, std::move(kept));
    is_settled_ = false;
}

void KeptStates::settle() {
    if (is_settled_) return;
    is_settled_ = true;
    const auto last = std::prev(states_.end());
    try {
        tree_.settle(std::size_t(last->first), last->second.patch.get().size());
    } catch (...) {
        if (states_.size() > 1) {
            tree_.drop_after(std::prev(last)->second.id);
            states_.erase(last);
        }
        throw;
    }
}

std::uint64_t KeptStates::before(std::uint64_t step) const { return std::prev(states_.upper_bound(step))->first; }

Snapshot KeptStates::state(std::uint64_t step) const {
    const recording::WholeState whole = patches_to(step).end();
    const auto* const bytes = reinterpret_cast<const std::byte*>(whole.bytes.data());
    return {{bytes, bytes + whole.bytes.size()}, states_.at(step).definitions};
}

const StateDigest* KeptStates::digest(std::uint64_t step) const {
    const auto found = states_.find(step);
    return found == states_.end() ? nullptr : &found->second.digest;
}

void KeptStates::drop_after(std::uint64_t step) {
    if (last() <= step) return;
    settle();
    states_.erase(states_.upper_bound(step), states_.end());
    tree_.drop_after(states_.rbegin()->second.id);
}

void KeptStates::thin_out() {
    settle();
    for (const std::size_t gone : tree_.thin_out()) states_.erase(gone);
}

void KeptStates::drop_oldest() {
    settle();
    const std::uint64_t next = *tree_.next_beginning();
    const Patch alone = helper_->patch({}, patches_to(next).end());
    const std::vector<std::size_t> gone = tree_.begin_there(alone.get().size());
    Kept& kept = states_.at(next);
    kept.patch = alone;
    kept.parent = next;
    for (const std::size_t step : gone) states_.erase(step);
}

std::size_t KeptStates::bytes() const {
    std::size_t bytes = std::size_t(tree_.bytes()) + tree_.bytes_in_memory();
    const SnapshotDefinitions* counted = nullptr;
    for (const auto& [step, kept] : states_) {
        if (kept.definitions.get() != counted) bytes += kept.definitions->bytes.size();
        counted = kept.definitions.get();
    }
    return bytes;
}

} // namespace cairn::viewer
