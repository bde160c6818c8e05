#include "base/parse_number.hpp"

#include <charconv>

namespace burnish {

std::optional<double> parse_number(std::string_view text) {
  constexpr std::string_view blanks = " \t\r\n";
  const std::size_t begin = text.find_first_not_of(blanks);
  if (begin == std::string_view::npos) return std::nullopt;
  text = text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
  // from_chars does not accept a leading plus, and "+-1" must not become -1.
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  double value = 0.0;
  const char* const end = text.data() + text.size();
  const auto [stopped, status] = std::from_chars(text.data(), end, value);
  // A number out of the range of double is rejected, since it is probably a typing error.
  if (stopped != end || status != std::errc()) return std::nullopt;
  return value;
}

}  // namespace burnish
