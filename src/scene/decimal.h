// Decimal numbers of text files, read the same in every locale.
#pragma once

#include <optional>
#include <string_view>

namespace cairn::scene {

// The double nearest to the whole of `text`: digits with an optional sign, point and exponent. Nothing for anything
// else, and for what is beyond double's range.
std::optional<double> parse_decimal(std::string_view text);

} // namespace cairn::scene
