// Text to number, the same in every locale.
#pragma once

#include <optional>
#include <string_view>

namespace burnish {

/// The number that is the whole of `text`, surrounding blanks aside; "inf" and "nan" are numbers.
std::optional<double> parse_number(std::string_view text);

}  // namespace burnish
