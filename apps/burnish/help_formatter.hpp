// Layout of the text that --help prints.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace burnish::app {

/// Returns the name of an option's value without the name of the check that CLI11 appends: "N" for
/// "N:POSITIVE".
std::string value_name(const CLI::Option& option);

/// CLI11's formatter with three changes: value names without checks, defaults in brackets after the
/// description, and lines of at most 100 columns.
class HelpFormatter : public CLI::Formatter {
 public:
  std::string make_option_opts(const CLI::Option* option) const override;
  std::string make_option_desc(const CLI::Option* option) const override;
};

}  // namespace burnish::app
