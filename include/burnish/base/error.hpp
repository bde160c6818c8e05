// What a bad input is answered with: one sentence that names what, what came and what was wanted.
#pragma once

#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace burnish {

/// A specification, a file or an argument that cannot be used. Thrown while things are set up,
/// never by a function that runs inside a control tick (those return a Status).
///
/// Whatever a file holds that is quoted in it, the sentence is one line of UTF-8: control
/// characters become blanks, bytes that are no text question marks, and what is far too long is
/// cut.
class Error : public std::runtime_error {
 public:
  explicit Error(const std::string& sentence);
  /// All that is wrong with one thing: what() is "origin: problem", or where there are several
  /// "origin: 3 problems: (1) problem (2) ...", without "origin: " if empty; of 50 at most.
  Error(const std::string& origin, const std::vector<std::string>& problems);

  /// One sentence for each problem, to be printed one a line; what() alone where there is one.
  const std::vector<std::string>& sentences() const noexcept { return *sentences_; }

 private:
  explicit Error(std::vector<std::string> sentences, const std::string& joined);
  std::shared_ptr<const std::vector<std::string>> sentences_;
};

/// The known name closest to `name` by edit distance, or an empty string when none is close.
std::string nearest_name(std::string_view name, const std::vector<std::string>& known);

/// "; did you mean 'x'?" for the nearest known name, or an empty string.
std::string did_you_mean(std::string_view name, const std::vector<std::string>& known);

}  // namespace burnish
