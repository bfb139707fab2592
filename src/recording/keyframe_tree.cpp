#include "recording/keyframe_tree.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace cairn::recording {

namespace {

// Estimated processor time, s: of a step per body, additionally per awake body, per tested pair of shapes, and per pair
// tested by a sweep.
constexpr double for_a_body = 4e-8, for_an_awake_body = 8e-7, for_a_tested_pair = 4e-7, for_a_swept_pair = 7e-7;
// Estimated processor time to keep a state, s per byte.
constexpr double for_a_byte = 5e-9;
constexpr std::uint64_t looked_after = 8; // Steps between two estimates: counting takes as long as an idle step.

double work_of_step(const Statistics& world) {
    return for_a_body * double(world.bodies) + for_an_awake_body * double(world.awake_bodies) +
           for_a_tested_pair * double(world.tested_pairs) + for_a_swept_pair * double(world.swept_pairs);
}

std::uint64_t parent_of(std::uint64_t number) { return number & (number - 1); }

bool is_ancestor_or_self(std::uint64_t ancestor, std::uint64_t number) {
    while (number > ancestor) number = parent_of(number);
    return number == ancestor;
}

} // namespace

bool KeyframeTree::is_due(const World& world) {
    if (budget_ == 0) return false;
    if (steps_++ % looked_after == 0) step_work_ = work_of_step(world.statistics());
    work_ += step_work_;
    return work_ - (kept_.empty() ? 0 : kept_.back().work) >= usual_work();
}

KeyframeTree::Difference KeyframeTree::add(WholeState state) { return add(last_ + 1, std::move(state)); }
KeyframeTree::Difference KeyframeTree::add_beginning(WholeState state) { return add(0, std::move(state)); }

KeyframeTree::Difference KeyframeTree::add(std::uint64_t number, WholeState state) {
    Difference result{ids_ + 1, 0, {}, state};
    const std::uint64_t parent = number == 0 ? 0 : parent_of(number);
    if (!kept_.empty() && parent >= kept_.front().number)
        result.parent = kept_[std::size_t(parent - kept_.front().number)].id;
    while (!path_.empty() && path_.back().number > parent) path_.pop_back();
    if (!path_.empty() && path_.back().number == parent) result.before = path_.back().state;
    cost_ = for_a_byte * double(state.bytes.size());
    kept_.push_back({number, result.id, work_, 0, 0});
    path_.push_back({number, result.id, std::move(state)});
    last_ = number, ids_ = result.id;
    return result;
}

std::vector<std::size_t> KeyframeTree::settle(std::size_t place, std::uint64_t bytes) {
    std::vector<std::size_t> gone;
    kept_.back().place = place, kept_.back().bytes = bytes;
    bytes_ += bytes;
    while (bytes_ > budget_) {
        const std::vector<std::size_t> more = thin_out();
        gone.insert(gone.end(), more.begin(), more.end());
    }
    return gone;
}

std::vector<std::size_t> KeyframeTree::thin_out() {
    std::vector<std::size_t> gone;
    std::erase_if(kept_, [&](const Kept& keyframe) {
        if (keyframe.number % 2 == 0) return false;
        gone.push_back(keyframe.place);
        bytes_ -= keyframe.bytes;
        return true;
    });
    for (Kept& keyframe : kept_) keyframe.number /= 2;
    std::erase_if(path_, [](const InMemory& state) { return state.number % 2 != 0; });
    for (InMemory& state : path_) state.number /= 2;
    last_ /= 2;
    thinned_ *= 2;
    return gone;
}

std::optional<std::size_t> KeyframeTree::next_beginning() const {
    if (last_ == 0) return std::nullopt;
    return kept_[std::size_t(std::bit_floor(last_) - kept_.front().number)].place;
}

std::vector<std::size_t> KeyframeTree::begin_there(std::uint64_t bytes) {
    std::vector<std::size_t> gone;
    const std::uint64_t first = std::bit_floor(last_);
    std::erase_if(kept_, [&](const Kept& keyframe) {
        if (keyframe.number >= first) return false;
        gone.push_back(keyframe.place);
        bytes_ -= keyframe.bytes;
        return true;
    });
    for (Kept& keyframe : kept_) keyframe.number -= first;
    bytes_ = bytes_ - kept_.front().bytes + bytes;
    kept_.front().bytes = bytes;
    std::erase_if(path_, [&](const InMemory& state) { return state.number < first; });
    for (InMemory& state : path_) state.number -= first;
    last_ -= first;
    return gone;
}

void KeyframeTree::drop_after(std::uint64_t id) {
    while (kept_.back().id > id) {
        bytes_ -= kept_.back().bytes;
        kept_.pop_back();
    }
    last_ = kept_.back().number;
    work_ = kept_.back().work;
    std::erase_if(path_, [&](const InMemory& state) { return !is_ancestor_or_self(state.number, last_); });
}

std::optional<WholeState> KeyframeTree::in_memory(std::uint64_t id) const {
    for (const InMemory& state : path_)
        if (state.id == id) return state.state;
    return std::nullopt;
}

std::size_t KeyframeTree::bytes_in_memory() const {
    std::size_t bytes = 0;
    for (const InMemory& state : path_) bytes += state.state.bytes.size();
    return bytes;
}

} // namespace cairn::recording
