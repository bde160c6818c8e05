// Errors for bad input: one sentence that names the object, the value found and the value required.
#pragma once

#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace burnish {

/// Exception for a specification, a file or an argument that cannot be used. It is thrown during
/// setup only. Functions that run inside a control tick return a Status instead.
///
/// Each sentence of the message is one line of valid UTF-8, even if the sentence quotes a file.
/// Control characters are replaced by blanks, and invalid bytes by question marks. Text beyond 4000
/// bytes is cut off.
class Error : public std::runtime_error {
 public:
  explicit Error(const std::string& sentence);
  /// Creates an Error that lists all problems of one object, at most 50. what() is "origin:
  /// problem" for one problem and "origin: 3 problems: (1) problem (2) ..." for several. If
  /// `origin` is empty, what() begins without "origin: ".
  Error(const std::string& origin, const std::vector<std::string>& problems);

  /// Returns one sentence per problem, to print one per line. For a single problem, the sentence is
  /// what().
  const std::vector<std::string>& sentences() const noexcept { return *sentences_; }

 private:
  explicit Error(std::vector<std::string> sentences, const std::string& joined);
  std::shared_ptr<const std::vector<std::string>> sentences_;
};

/// Returns the entry of `known` that is closest to `name` by edit distance. Returns an empty string
/// if no entry is within 1 + name.size() / 3 edits, or if `name` is longer than 200 bytes.
std::string nearest_name(std::string_view name, const std::vector<std::string>& known);

/// Returns "; did you mean 'x'?", where x is the result of nearest_name(). Returns an empty string
/// if that result is empty.
std::string did_you_mean(std::string_view name, const std::vector<std::string>& known);

}  // namespace burnish
