#include "derivatives/explanation.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "base/sentence.hpp"

namespace burnish {
namespace {

/// Returns true if the direction in the row's name begins with 'r', as in "pad/rx".
bool is_angular(const std::string& row) { return row[row.rfind('/') + 1] == 'r'; }

std::string with_amount(const UnmetRow& row) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", row.acceleration);
  return row.name + " (" + text + (is_angular(row.name) ? " rad/s^2)" : " m/s^2)");
}

}  // namespace

std::string contradicting(std::vector<UnmetRow> rows) {
  constexpr std::size_t max_names = 12;
  std::stable_sort(rows.begin(), rows.end(), [](const UnmetRow& a, const UnmetRow& b) {
    return std::abs(a.acceleration) > (1.0 + 1e-6) * std::abs(b.acceleration);
  });
  std::string text = "contact rows ";
  for (std::size_t i = 0; i < std::min(rows.size(), max_names); ++i)
    text += (i == 0 ? "" : i + 1 == rows.size() ? " and " : ", ") + with_amount(rows[i]);
  if (rows.size() <= max_names) return text;
  return text + " and " + std::to_string(rows.size() - max_names) + " more";
}

std::vector<UnmetRow> unmet_rows(const std::vector<std::string>& names,
                                 std::span<const double> unmet) {
  double largest = 0.0;
  for (const double x : unmet) largest = std::max(largest, std::abs(x));
  std::vector<UnmetRow> rows;
  for (std::size_t r = 0; r < unmet.size(); ++r)
    if (std::abs(unmet[r]) > 1e-6 * largest) rows.push_back({names[r], unmet[r]});
  return rows;
}

std::string explain(Status status, const std::vector<std::string>& joints,
                    const std::vector<std::string>& rows, const std::vector<std::string>& jammed,
                    const std::vector<UnmetRow>& unmet) {
  if (status == Status::NotConverged && !unmet.empty())
    return contradicting(unmet) +
           " contradict each other: no joint acceleration satisfies all of them (residuals in "
           "brackets). The forces are the least-squares solution, and neither more iterations nor "
           "another mu changes them; wanted contacts with equal targets, or fewer rows";
  if (status == Status::SingularMass && !joints.empty()) {
    std::vector<std::string> once = joints;
    once.erase(std::unique(once.begin(), once.end()), once.end());
    const bool one = once.size() == 1;
    return listed("joint", once) + (one ? " moves" : " move") + " no mass of " +
           (one ? "its" : "their") +
           " own at this posture, so that the mass matrix is not positive definite: give the " +
           (one ? "link a mass or the joint" : "links a mass or the joints") +
           " an armature, or lock the " + (one ? "joint" : "joints");
  }
  if (status == Status::SingularContacts && !rows.empty()) {
    const std::string them = rows.size() == 1 ? "it" : "them";
    return listed("contact row", rows) + (rows.size() == 1 ? " is" : " are") +
           " redundant or cannot be held: at this posture no joint moves along " + them +
           ", or earlier rows already hold " + them +
           "; diagnose() names these rows, and mu > 0 makes them solvable";
  }
  if (status == Status::SingularContacts && !jammed.empty())
    return listed("the tool of contact", jammed) + (jammed.size() == 1 ? " jams" : " jam") +
           ": at this posture and sliding direction, friction presses the tool against the surface "
           "at least as strongly as the normal force pushes it away; wanted less friction or "
           "another posture";
  return std::string(describe(status));
}

}  // namespace burnish
