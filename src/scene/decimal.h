// Parses decimal numbers of text files independently of the locale.
#pragma once

#include <optional>
#include <string_view>

namespace cairn::scene {

// Returns the double nearest to `text`, all of which must be one number: digits with an optional sign, point and
// exponent. Returns nothing for any other text, and for numbers beyond double's range.
std::optional<double> parse_decimal(std::string_view text);

} // namespace cairn::scene
