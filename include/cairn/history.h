/// \file history.h
/// Undo and redo of the changes of a world.
#pragma once

#include <cairn/world.h>

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace cairn {

/// The undo history of one world: a list of named changes, each of any number of calls.
///
///     cairn::History history(world);
///     editor.drag(world, body);    // any number of calls
///     history.commit(world, "move");
///     world.body(body).set_linear_velocity(v);
///     history.commit(world, "push");
///     history.undo(world);         // back to before the push: the same bits
///     history.redo(world);
///
/// The history keeps the commands of each change, and a snapshot now and then. Undoing a change restores the last
/// snapshot before it and repeats the commands in between. Undo and redo are exact to the bit.
class History {
  public:
    /// Begins with the present state of the world, and becomes its command listener; so a world cannot be recorded and
    /// have a history at the same time. `bytes` is the approximate limit of memory for snapshots and commands, 64 MiB
    /// by default; beyond it the oldest changes are dropped and cannot be undone, but the last few always can. Throws
    /// `Error` as `World::set_command_listener` does.
    explicit History(World& world, std::size_t bytes = std::size_t{64} << 20);
    ~History();
    History(History&&) noexcept;
    History& operator=(History&&) noexcept;

    /// Makes all calls since the last commit one change with that name. Returns false, and does nothing, if there were
    /// none. Changes that had been undone cannot be redone after that. Throws `Error` (wrong_state) during a step.
    bool commit(World& world, std::string name);

    /// Names of the changes that can be undone; the one that `undo` takes back next is last.
    std::vector<std::string> undoable() const;
    /// Names of the changes that can be redone; the one that `redo` repeats next is last.
    std::vector<std::string> redoable() const;

    /// Takes back the last committed change, together with any calls since the last commit, which are lost. Returns
    /// false if there is no change to undo. `world` must be the world that the history was created with (or the object
    /// to which it was moved). Throws `Error` (wrong_state) during a step.
    bool undo(World& world);
    /// Repeats the change that was undone last. Returns false if there is none, or if the world was changed since.
    bool redo(World& world);

    std::size_t bytes() const; ///< Memory that the history uses, bytes.

  private:
    class Log;
    std::shared_ptr<Log> log_;
};

} // namespace cairn
