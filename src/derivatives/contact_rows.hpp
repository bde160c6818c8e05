// Contact rows at one configuration, for tests of their independence.
#pragma once

#include "burnish/derivatives/contact_dynamics.hpp"
#include "burnish/derivatives/diagnosis.hpp"

namespace burnish {

/// Contact rows in the metric of M^-1.
struct ContactRows {
  RowMatrix Y;  ///< J L^-1 with M = L L^T, so that Y Y^T = J M^-1 J^T; rows x nv
  /// Squared length of each row, relative to its attainable squared length (row_size.hpp)
  Eigen::VectorXd relative_size;
};

/// Returns the rows of all contacts of `dynamics` at q (nq). All contacts must be active. If M is
/// singular, throws Error with the name of the joint.
ContactRows contact_rows(const Model& model, ContactDynamics& dynamics,
                         const Eigen::Ref<const Eigen::VectorXd>& q);

/// Runs diagnose() on given rows.
ContactDiagnosis diagnose_rows(const ContactSet& set, const ContactRows& rows,
                               const std::vector<int>& active, double tolerance);

/// Returns the condition number of J M^-1 J^T, with each row scaled to the length min(1,
/// sqrt(relative_size)). The condition number is large also if the joints hardly move along a row.
/// It is infinite for redundant rows, and 1 if there are no rows.
double condition_by_reach(const ContactSet& set, const ContactRows& rows);

}  // namespace burnish
