// Plots as SVG pictures, for pages and on their own.
#pragma once

#include "validation/validation.h"

#include <string>
#include <string_view>

namespace cairn::cli {

// A complete <svg> element with a white ground. Where both axes are logarithmic, each curve's legend has the slope that
// fits it, if a straight line does.
std::string svg_plot(const validation::Plot& plot);

// With &, <, > and quotes replaced as XML and HTML ask for.
std::string escaped(std::string_view text);

} // namespace cairn::cli
