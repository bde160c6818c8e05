// What a bad input is answered with: one sentence that names what, what came and what was wanted.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace burnish {

/// A specification, a file or an argument that cannot be used. Thrown while things are set up,
/// never by a function that runs inside a control tick (those return a Status).
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The known name closest to `name` by edit distance, or an empty string when none is close.
std::string nearest_name(std::string_view name, const std::vector<std::string>& known);

/// "; did you mean 'x'?" for the nearest known name, or an empty string.
std::string did_you_mean(std::string_view name, const std::vector<std::string>& known);

}  // namespace burnish
