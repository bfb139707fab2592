/// \file export.h
/// Files that the interface asks the window to write: the window chooses the folder and reports the result.
#pragma once

#include "viewer/chart.h"

#include <functional>
#include <string>

namespace cairn::viewer {

/// Converts a chart to the text of an SVG picture.
using SvgOfChart = std::function<std::string(const Chart&)>;

struct Export {
    std::string name;      ///< File name without folder; a number is added if the file exists.
    std::string extension; ///< With its dot.
    std::string text;
};

} // namespace cairn::viewer
