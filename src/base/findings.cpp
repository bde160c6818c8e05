#include "base/findings.hpp"

namespace burnish {
namespace {

std::string without(const std::string& origin, const std::string& sentence) {
  const std::string start = origin + ": ";
  return sentence.starts_with(start) ? sentence.substr(start.size()) : sentence;
}

}  // namespace

void Findings::warn(const std::string& what) {
  constexpr std::size_t max_warnings = 1000;
  if (warnings_.size() < max_warnings) warnings_.push_back(origin_ + ": " + what);
  if (warnings_.size() == max_warnings)
    warnings_.push_back(origin_ + ": more than 1000 warnings; further warnings are omitted");
}

void Findings::refuse_problems() const {
  if (has_problems()) throw Error(origin_, problems_);
}

std::string Findings::without_origin(const std::string& sentence) const {
  return without(origin_, sentence);
}

void refuse_warnings(const std::string& origin, const std::vector<std::string>& warnings) {
  if (warnings.empty()) return;
  std::vector<std::string> problems;
  for (const std::string& warning : warnings) {
    problems.push_back(without(origin, warning) + " (a warning; strict reading rejects warnings)");
  }
  throw Error(origin, problems);
}

}  // namespace burnish
