/// \file command_palette.h
/// A searchable list of all commands.
#pragma once

#include "viewer/command_list.h"

#include <array>
#include <vector>

namespace cairn::viewer {

class CommandPalette {
  public:
    /// To be called between ImGui's NewFrame and Render. `column`: left edge of the view, which is `room` wide.
    void draw(Controller& controller, float scale, float column, float room);

  private:
    std::vector<NamedCommand> commands_; // filled while it is open
    std::array<char, 64> query_{};
    int chosen_ = 0;
    bool was_open_ = false;
};

} // namespace cairn::viewer
