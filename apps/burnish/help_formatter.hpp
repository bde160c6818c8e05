// How --help looks.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace burnish::app {

/// The value's name without what CLI11 writes behind it: "N" of "N:POSITIVE".
std::string value_name(const CLI::Option& option);

/// CLI11's, with names of values alone ("N" where CLI11 writes "N:POSITIVE"), defaults in brackets
/// behind the description, and descriptions that end before column 100.
class HelpFormatter : public CLI::Formatter {
 public:
  std::string make_option_opts(const CLI::Option* option) const override;
  std::string make_option_desc(const CLI::Option* option) const override;
};

}  // namespace burnish::app
