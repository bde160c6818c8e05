// A status in one sentence, with the names of what is to blame.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "burnish/base/status.hpp"

namespace burnish {

/// A row whose contact acceleration other rows contradict, and what stays of it.
struct UnmetRow {
  std::string name;     ///< "pad/z"
  double acceleration;  ///< m/s^2 or rad/s^2
};

/// describe(status), which for a SingularMass names the joints that move no mass, each once, and
/// for SingularContacts the rows ("pad/z") that depend on those before them, or the contacts whose
/// tool jams. For NotConverged it names the rows that contradict each other.
std::string explain(Status status, const std::vector<std::string>& joints,
                    const std::vector<std::string>& rows, const std::vector<std::string>& jammed,
                    const std::vector<UnmetRow>& unmet = {});

/// "contact rows a/x (0.1 m/s^2) and b/x (-0.1 m/s^2)": the largest first, no more than twelve.
std::string contradicting(std::vector<UnmetRow> rows);

/// Of unmet accelerations by row, those that rounding does not make: rows below a millionth of the
/// largest take no part. Empty where all are zero.
std::vector<UnmetRow> unmet_rows(const std::vector<std::string>& names,
                                 std::span<const double> unmet);

}  // namespace burnish
