// Conversion of text to numbers, independent of the locale.
#pragma once

#include <optional>
#include <string_view>

namespace burnish {

/// Parses all of `text` as one number. Blanks around the number are allowed. "inf" and "nan" are
/// numbers.
std::optional<double> parse_number(std::string_view text);

}  // namespace burnish
