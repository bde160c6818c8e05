// Sentences that explain a status, with the names of joints, rows and contacts that cause it.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "burnish/base/status.hpp"

namespace burnish {

/// Row that contradicts other rows.
struct UnmetRow {
  std::string name;     ///< Name of the row, such as "pad/z"
  double acceleration;  ///< Residual contact acceleration [m/s^2, rad/s^2]
};

/// Returns describe(status), followed by names. SingularMass: the `joints` that move no mass, each
/// once. SingularContacts: the dependent `rows` ("pad/z"), or the contacts `jammed`, whose tools
/// jam. NotConverged: the rows that contradict each other.
std::string explain(Status status, const std::vector<std::string>& joints,
                    const std::vector<std::string>& rows, const std::vector<std::string>& jammed,
                    const std::vector<UnmetRow>& unmet = {});

/// Returns "contact rows a/x (0.1 m/s^2) and b/x (-0.1 m/s^2)". Names at most twelve rows, those
/// with the largest accelerations first.
std::string contradicting(std::vector<UnmetRow> rows);

/// Returns the rows whose residual acceleration exceeds a millionth of the largest one. Smaller
/// accelerations are rounding errors.
std::vector<UnmetRow> unmet_rows(const std::vector<std::string>& names,
                                 std::span<const double> unmet);

}  // namespace burnish
