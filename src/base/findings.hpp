// Problems and warnings that readers of robot descriptions collect. Problems make the description
// unusable and are thrown together. Warnings are returned with the result.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "burnish/base/error.hpp"

namespace burnish {

/// List of the problems and warnings about one description.
class Findings {
 public:
  /// `origin` begins every sentence: the name of the file, or the name of a robot that has no file.
  explicit Findings(std::string origin) : origin_(std::move(origin)) {}

  void problem(const std::string& what) { problems_.push_back(what); }
  /// Adds a warning. After 1000 warnings, a single sentence replaces all further ones.
  void warn(const std::string& what);

  /// Appends the problems and warnings of `other`.
  void add(const Findings& other) {
    problems_.insert(problems_.end(), other.problems_.begin(), other.problems_.end());
    warnings_.insert(warnings_.end(), other.warnings_.begin(), other.warnings_.end());
  }

  /// Calls `call`. If `call` throws an Error, records a problem and returns false.
  template <class Call>
  bool attempt(Call&& call) {
    try {
      std::forward<Call>(call)();
    } catch (const Error& error) {
      problem(without_origin(error.what()));
      return false;
    }
    return true;
  }

  /// Calls `call`. If `call` throws an Error, records a warning that ends with `consequence`.
  template <class Call>
  void attempt_or_warn(Call&& call, const std::string& consequence) {
    try {
      std::forward<Call>(call)();
    } catch (const Error& error) {
      warn(without_origin(error.what()) + consequence);
    }
  }

  const std::string& origin() const { return origin_; }
  const std::vector<std::string>& warnings() const { return warnings_; }
  bool has_problems() const { return !problems_.empty(); }
  /// Returns true if there are fewer than 50 problems and warnings. If there are more, readers do
  /// not search for similar names.
  bool are_few() const { return problems_.size() + warnings_.size() < 50; }
  /// Throws an Error that lists all problems, if there are any.
  void refuse_problems() const;

 private:
  std::string without_origin(const std::string& sentence) const;

  std::string origin_;
  std::vector<std::string> problems_, warnings_;
};

/// Throws an Error that lists `warnings`, if there are any. `origin` begins the sentence; it may be
/// empty.
void refuse_warnings(const std::string& origin, const std::vector<std::string>& warnings);

}  // namespace burnish
