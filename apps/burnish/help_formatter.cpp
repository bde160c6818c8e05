#include "help_formatter.hpp"

#include <sstream>

namespace burnish::app {

std::string value_name(const CLI::Option& option) {
  const std::string type = option.get_type_name();
  return type.substr(0, type.find(':'));
}

std::string HelpFormatter::make_option_opts(const CLI::Option* option) const {
  if (option->get_type_size_max() == 0) return "";
  std::string text;
  const std::string value = value_name(*option);
  if (!value.empty()) text += " " + value;
  if (option->get_expected_max() == CLI::detail::expected_max_vector_size) text += " ...";
  if (option->get_required()) text += " REQUIRED";
  return text;
}

std::string HelpFormatter::make_option_desc(const CLI::Option* option) const {
  std::string text = option->get_description();
  if (!option->get_default_str().empty()) text += " [" + option->get_default_str() + "]";
  const std::size_t width = 99 - get_column_width();
  std::istringstream words(text);
  std::string result;
  std::size_t column = 0;
  for (std::string word; words >> word;) {
    if (column > 0 && column + 1 + word.size() > width) {
      result += "\n";
      column = 0;
    }
    if (column > 0) result += " ";
    column += word.size() + (column > 0 ? 1 : 0);
    result += word;
  }
  return result;
}

}  // namespace burnish::app
