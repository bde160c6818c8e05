// What reading a description comes upon: problems, which refuse it all at once, and what is odd but
// usable, which travels with the result as warnings.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "burnish/base/error.hpp"

namespace burnish {

class Findings {
 public:
  /// `origin` is what every sentence starts with: the file, or else the robot's name.
  explicit Findings(std::string origin) : origin_(std::move(origin)) {}

  void problem(const std::string& what) { problems_.push_back(what); }
  /// Of more than 1000 the rest is not kept, but for a sentence that there are more.
  void warn(const std::string& what);

  /// What another has found about the same.
  void add(const Findings& other) {
    problems_.insert(problems_.end(), other.problems_.begin(), other.problems_.end());
    warnings_.insert(warnings_.end(), other.warnings_.begin(), other.warnings_.end());
  }

  /// Notes the Error that `call` throws as a problem; false if it throws one.
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

  /// Notes the Error as a warning that says what becomes of it.
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
  /// Whether somebody will read another one: of many, the nearest known names are not looked up.
  bool are_few() const { return problems_.size() + warnings_.size() < 50; }
  /// Throws an Error that lists all problems, if there are any.
  void refuse_problems() const;

 private:
  std::string without_origin(const std::string& sentence) const;

  std::string origin_;
  std::vector<std::string> problems_, warnings_;
};

/// Throws an Error that lists the warnings, if there are any: for who wants nothing odd. `origin`
/// is what they are about, or empty.
void refuse_warnings(const std::string& origin, const std::vector<std::string>& warnings);

}  // namespace burnish
