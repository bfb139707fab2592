/// \file script.h
/// Inputs from a file, for demonstrations and tests. One command per line; `#` begins a comment:
///
///     wait 0.5               do nothing for half a second
///     key Shift+Backspace    press and release a key
///     down KP4               press a key ...
///     up KP4                 ... and release it
///     cursor 640 360         move the cursor there, in pixels from the top left corner; over a panel it is the panel's
///     press Shift+left       hold a mouse button down (left, right or middle; with keys before it that are held) ...
///     release left           ... and let it go, with those keys
///     wheel -2               turn the wheel
///     drop bridge.glb        drop a file on the window
///     report state.json      write the viewer's state
///     picture frame.png      save a picture
///     window all.png         save a picture with the panels, as the window shows it
///     quit                   close the window
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace cairn::viewer {

struct ScriptLine {
    enum class Kind { wait, key, down, up, cursor, press, release, wheel, drop, report, picture, window, quit };
    Kind kind = Kind::wait;
    std::string word;        ///< Key, button or file.
    double x = 0.0, y = 0.0; ///< Seconds, pixels or wheel notches.
};

/// Throws `Error` (invalid_file) with the line number. `name` stands for the file in messages.
std::vector<ScriptLine> parse_script(std::string_view text, const std::string& name);
/// Throws `Error` (io, invalid_file).
std::vector<ScriptLine> load_script(const std::filesystem::path& path);

/// Returns the lines of a script when they are due.
class ScriptPlayer {
  public:
    explicit ScriptPlayer(std::vector<ScriptLine> lines = {}) : lines_(std::move(lines)) {}
    /// Advances time by that many seconds: returns the next line that is due, or null. Call again until null.
    const ScriptLine* next(double seconds);

  private:
    std::vector<ScriptLine> lines_;
    std::size_t place_ = 0;
    double waiting_ = 0.0;
};

} // namespace cairn::viewer
