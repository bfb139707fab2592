// Plots as SVG pictures, embedded or stand-alone.
#pragma once

#include "validation/validation.h"

#include <string>
#include <string_view>

namespace cairn::cli {

// A complete <svg> element with a white background. In doubly logarithmic plots, the legend of each curve states its
// fitted slope, if a straight line fits.
std::string svg_plot(const validation::Plot& plot);

// Escapes &, <, > and quotes for XML and HTML.
std::string escaped(std::string_view text);

} // namespace cairn::cli
