/// \file history.h
/// Undoing and redoing what was done to a world.
#pragma once

#include <cairn/world.h>

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace cairn {

/// What was done to one world, change by change, to be taken back and done again.
///
///     cairn::History history(world);
///     editor.drag(world, body);    // any number of calls
///     history.commit(world, "move");
///     world.body(body).set_linear_velocity(v);
///     history.commit(world, "push");
///     history.undo(world);         // back to before the push: the same bits
///     history.redo(world);
///
/// Of each change it keeps the commands, and now and then the whole state: taking back is going to the last state
/// before it and doing again what came between. Both are exact.
class History {
  public:
    /// Begins with the world as it is, and becomes its command listener: a world is recorded or has a history. `bytes`:
    /// about so much memory for states and commands; when there is more, the oldest changes can be undone no longer,
    /// but the last few always can. Throws `Error` as `World::set_command_listener` does.
    explicit History(World& world, std::size_t bytes = std::size_t{64} << 20);
    ~History();
    History(History&&) noexcept;
    History& operator=(History&&) noexcept;

    /// All that was done since the last commit becomes one change of that name. Nothing was: false. What had been
    /// undone can be redone no longer. Throws `Error` (wrong_state) during a step.
    bool commit(World& world, std::string name);

    std::vector<std::string> undoable() const; ///< Names of the changes that can be undone, the last one last.
    std::vector<std::string> redoable() const; ///< Those that can be redone, the next one last.

    /// Takes back the last change; first what was done since, which is lost. false: there is none. The world must be
    /// the one it was made with (or moved to). Throws `Error` (wrong_state) during a step.
    bool undo(World& world);
    /// Does again the change that was undone last. false: there is none, or something was done since.
    bool redo(World& world);

    std::size_t bytes() const; ///< That it takes.

  private:
    class Log;
    std::shared_ptr<Log> log_;
};

} // namespace cairn
