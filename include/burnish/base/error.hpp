// Error for bad input. Its messages name the object, the value found and the value required.
#pragma once

#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace burnish {

/// Exception for a specification, a file or an argument that cannot be used. Functions for use
/// inside a control loop return a Status for bad numbers. They throw Error only for wrong calls,
/// such as a call with an unknown index.
///
/// Each sentence of the message is one line of valid UTF-8. In text that is quoted from a file,
/// blanks replace control characters, and question marks replace invalid bytes. Text beyond 4000
/// bytes is cut off.
class Error : public std::runtime_error {
 public:
  explicit Error(const std::string& sentence);
  /// Creates an Error that lists at most 50 problems of the object with the name `origin`. For one
  /// problem, what() is "origin: problem". For several problems, what() is "origin: 3 problems: (1)
  /// problem (2) ...". If `origin` is empty, "origin: " is left out.
  Error(const std::string& origin, const std::vector<std::string>& problems);

  /// Returns one sentence per problem. If there is only one problem, its sentence equals what().
  const std::vector<std::string>& sentences() const noexcept { return *sentences_; }

 private:
  explicit Error(std::vector<std::string> sentences, const std::string& joined);
  std::shared_ptr<const std::vector<std::string>> sentences_;
};

/// Returns the entry of `known` that is closest to `name` by edit distance. Returns an empty string
/// if no entry is within 1 + name.size() / 3 edits, or if `name` is longer than 200 bytes.
std::string nearest_name(std::string_view name, const std::vector<std::string>& known);

/// Returns "; did you mean 'x'?" if nearest_name() finds a similar name x. Returns an empty string
/// if it finds none. If `name` was renamed after version 0.3 and the new name x is in `known`,
/// returns "; 'name' is now called 'x'" instead.
std::string did_you_mean(std::string_view name, const std::vector<std::string>& known);

}  // namespace burnish
