/// \file export.h
/// Files that the interface asks the window to write: it knows where to, and tells what came of it.
#pragma once

#include "viewer/chart.h"

#include <functional>
#include <string>

namespace cairn::viewer {

/// A chart as the text of an SVG picture.
using SvgOfChart = std::function<std::string(const Chart&)>;

struct Export {
    std::string name;      ///< Of the file, without its folder; where there is one already, a number is added.
    std::string extension; ///< With its point.
    std::string text;
};

} // namespace cairn::viewer
