#include "recording/keyframe_tree.h"

#include <algorithm>
#include <utility>

namespace cairn::recording {

namespace {

// s of a processor, roughly: what a step takes for each body, more if it is awake, and for each pair of shapes that it
// tests; and what it takes to keep a byte.
constexpr double for_a_body = 4e-8, for_an_awake_body = 1e-6, for_a_tested_pair = 5e-7, for_a_byte = 5e-9;
constexpr double greatest_share = 0.1;    // of the work that keeping states may be
constexpr std::uint64_t looked_after = 8; // steps: to count takes as long as a step that has nothing to do

double work_of_step(const Statistics& world) {
    return for_a_body * double(world.bodies) + for_an_awake_body * double(world.awake_bodies) +
           for_a_tested_pair * double(world.tested_pairs);
}

std::uint64_t parent_of(std::uint64_t number) { return number & (number - 1); }

} // namespace

bool KeyframeTree::is_due(const World& world) {
    if (budget_ == 0) return false;
    if (steps_++ % looked_after == 0) step_work_ = work_of_step(world.statistics());
    work_ += step_work_;
    return work_ - (kept_.empty() ? 0 : kept_.back().work) >= thinned_ * std::max(spacing_, cost_ / greatest_share);
}

KeyframeTree::Difference KeyframeTree::add(std::string state) {
    const std::uint64_t number = last_ + 1, parent = parent_of(number);
    while (!path_.empty() && path_.back().number > parent) path_.pop_back();
    Difference result{ids_ + 1, path_.empty() ? 0 : path_.back().id, {}};
    result.patch = patcher_.patch(path_.empty() ? std::string_view() : path_.back().state, state);
    cost_ = for_a_byte * double(state.size());
    path_.push_back({number, result.id, std::move(state)});
    kept_.push_back({number, work_, 0, 0});
    last_ = number, ids_ = result.id;
    return result;
}

std::vector<std::size_t> KeyframeTree::settle(std::size_t chunk, std::uint64_t bytes) {
    std::vector<std::size_t> gone;
    kept_.back().chunk = chunk, kept_.back().bytes = bytes;
    bytes_ += bytes;
    while (bytes_ > budget_) thin_out(gone);
    return gone;
}

void KeyframeTree::thin_out(std::vector<std::size_t>& gone) {
    std::erase_if(kept_, [&](const Kept& keyframe) {
        if (keyframe.number % 2 == 0) return false;
        gone.push_back(keyframe.chunk);
        bytes_ -= keyframe.bytes;
        return true;
    });
    for (Kept& keyframe : kept_) keyframe.number /= 2;
    std::erase_if(path_, [](const Ancestor& ancestor) { return ancestor.number % 2 != 0; });
    for (Ancestor& ancestor : path_) ancestor.number /= 2;
    last_ /= 2;
    thinned_ *= 2;
}

} // namespace cairn::recording
