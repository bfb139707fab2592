// Undo and redo: restores a kept state, then executes the commands after it again.
#include <cairn/history.h>

#include <deque>
#include <span>
#include <unordered_map>
#include <utility>

namespace cairn {

namespace {

// The number of commands between two kept states: the most that an undo may have to execute again.
constexpr std::size_t most_between_states = 64;

using Commands = std::vector<std::vector<std::byte>>;

std::size_t bytes_of(const Commands& commands) {
    std::size_t bytes = 0;
    for (const std::vector<std::byte>& command : commands) bytes += command.size() + sizeof command;
    return bytes;
}

const void* geometry_of(const Shape& shape) {
    if (const auto* hull = std::get_if<Hull>(&shape)) return hull->data().get();
    if (const auto* mesh = std::get_if<Mesh>(&shape)) return mesh->data().get();
    if (const auto* field = std::get_if<HeightField>(&shape)) return field->data().get();
    return nullptr;
}

} // namespace

class History::Log final : public CommandListener, public CommandSource {
  public:
    struct Change {
        std::string name;
        Commands commands;
        std::optional<Snapshot> before; // kept for some changes only
    };
    std::deque<Change> changes;
    std::size_t done = 0;              // number of changes that are not undone
    Commands pending;                  // commands since the last commit
    std::optional<Snapshot> last_kept; // the state before `pending`, if one is due there
    std::size_t since_kept = 0;        // number of commands since the last kept state
    std::size_t most_bytes = 0;
    bool is_going = false; // while commands of an undo or redo are executed, which are not the user's

    void on_command(std::span<const std::byte> command) override {
        if (!is_going) pending.emplace_back(command.begin(), command.end());
    }
    std::uint64_t number_of(const Shape& shape) override {
        const auto [found, is_new] = numbers_.try_emplace(geometry_of(shape), shapes_.size());
        if (is_new) shapes_.push_back(shape); // which keeps the geometry alive, and its address unique
        return found->second;
    }
    std::uint64_t number_of(const Snapshot& snapshot) override {
        if (is_going) return 0;
        snapshots_.push_back(snapshot);
        return snapshots_.size() - 1;
    }
    const Shape& shape(std::uint64_t number) override { return shapes_.at(std::size_t(number)); }
    const Snapshot& snapshot(std::uint64_t number) override { return snapshots_.at(std::size_t(number)); }

    // Restores the world to its state before the change `index`.
    void go_to(World& world, std::size_t index) {
        const Going going(is_going);
        std::size_t from = index;
        while (from == changes.size() || !changes[from].before) --from;
        world.restore(*changes[from].before);
        for (; from < index; ++from) run(world, changes[from].commands);
    }
    void go_on(World& world, const Commands& commands) {
        const Going going(is_going);
        run(world, commands);
    }

    std::size_t bytes() const {
        std::size_t sum = bytes_of(pending);
        const SnapshotDefinitions* counted = nullptr;
        for (const Change& change : changes) {
            sum += bytes_of(change.commands);
            if (!change.before) continue;
            sum += change.before->bytes.size();
            const SnapshotDefinitions* own = change.before->definitions.get();
            if (own != counted) sum += own->bytes.size();
            counted = own;
        }
        for (const Snapshot& s : snapshots_) sum += s.bytes.size();
        return sum;
    }
    // Discards the oldest changes, always up to the next change with a kept state.
    void keep_within_budget() {
        while (bytes() > most_bytes) {
            std::size_t next = 1;
            while (next < changes.size() && !changes[next].before) ++next;
            if (next >= changes.size() || next > done) return;
            changes.erase(changes.begin(), changes.begin() + std::ptrdiff_t(next));
            done -= next;
        }
    }

  private:
    struct Going {
        explicit Going(bool& flag) : flag_(flag) { flag_ = true; }
        ~Going() { flag_ = false; }
        bool& flag_;
    };
    void run(World& world, const Commands& commands) {
        for (const std::vector<std::byte>& command : commands) world.execute(command, *this);
    }

    std::deque<Shape> shapes_;
    std::unordered_map<const void*, std::uint64_t> numbers_;
    std::deque<Snapshot> snapshots_; // snapshots that the user restored
};

History::History(World& world, std::size_t bytes) : log_(std::make_shared<Log>()) {
    log_->most_bytes = bytes;
    log_->last_kept = world.save();
    log_->is_going = true; // the listener is first notified of the initial state, which is kept already
    world.set_command_listener(log_);
    log_->is_going = false;
}
History::~History() = default;
History::History(History&&) noexcept = default;
History& History::operator=(History&&) noexcept = default;

bool History::commit(World& world, std::string name) {
    Log& log = *log_;
    if (log.pending.empty()) return false;
    log.since_kept += log.pending.size();
    std::optional<Snapshot> next;
    if (log.since_kept >= most_between_states) next = world.save();
    // then the state before this change is the one before changes[done]
    const bool was_undone = log.done < log.changes.size();
    Log::Change change{std::move(name), std::move(log.pending),
                       was_undone ? std::move(log.changes[log.done].before) : std::move(log.last_kept)};
    log.changes.erase(log.changes.begin() + std::ptrdiff_t(log.done), log.changes.end());
    log.changes.push_back(std::move(change));
    log.pending.clear();
    log.last_kept = std::move(next);
    if (log.last_kept) log.since_kept = 0;
    ++log.done;
    log.keep_within_budget();
    return true;
}

std::vector<std::string> History::undoable() const {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < log_->done; ++i) names.push_back(log_->changes[i].name);
    return names;
}
std::vector<std::string> History::redoable() const {
    std::vector<std::string> names;
    for (std::size_t i = log_->changes.size(); i > log_->done; --i) names.push_back(log_->changes[i - 1].name);
    return names;
}

bool History::undo(World& world) {
    Log& log = *log_;
    if (log.done == 0) return false;
    log.go_to(world, log.done - 1);
    log.pending.clear();
    log.last_kept.reset();
    --log.done;
    return true;
}

bool History::redo(World& world) {
    Log& log = *log_;
    if (log.done == log.changes.size() || !log.pending.empty()) return false;
    log.go_on(world, log.changes[log.done].commands);
    ++log.done;
    return true;
}

std::size_t History::bytes() const { return log_->bytes(); }

} // namespace cairn
