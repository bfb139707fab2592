#include "viewer/commands.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace cairn::viewer {

void CommandQueue::push(Command command) {
    {
        const std::lock_guard lock(mutex_);
        commands_.push_back(std::move(command));
    }
    changed_.notify_one();
}

std::vector<Command> CommandQueue::take() {
    const std::lock_guard lock(mutex_);
    return std::exchange(commands_, {});
}

void CommandQueue::wait(double seconds) {
    constexpr double longest_wait = 3600.0; // s; condition variables do not accept infinity
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, std::chrono::duration<double>(std::clamp(seconds, 0.0, longest_wait)),
                      [this] { return !commands_.empty() || closed_; });
}

void CommandQueue::close() {
    {
        const std::lock_guard lock(mutex_);
        closed_ = true;
    }
    changed_.notify_all();
}

bool CommandQueue::closed() const {
    const std::lock_guard lock(mutex_);
    return closed_;
}

} // namespace cairn::viewer
