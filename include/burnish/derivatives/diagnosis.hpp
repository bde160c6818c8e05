// Diagnosis of contacts: finds contact constraints that depend on other contact constraints.
#pragma once

#include <string>
#include <vector>

#include "burnish/contact/contact_set.hpp"

namespace burnish {

/// Row of the contact Jacobian that depends linearly on the rows before it, or that is zero.
/// @described derivatives @result
struct RedundantRow {
  std::string contact;    ///< Name of the contact
  std::string direction;  ///< Direction in the contact's reference, "x" ... "rz"
  int row;                ///< Index among all rows of the contact set
  bool immovable;         ///< True if no joint moves the contact in this direction, up to rounding

  /// Rows that already imply this row, as "contact/direction"
  std::vector<std::string> implied_by;

  /// Returns a sentence such as "contact 'pad_b', direction z: already held by pad_a/z". If the row
  /// is immovable, the sentence says that no joint moves the contact in this direction.
  std::string text() const;
};

/// Contact rows that diagnose() found to depend on other rows. If there are none, the contacts are
/// independent.
/// @described derivatives @result
struct ContactDiagnosis {
  std::vector<RedundantRow> redundant;
  /// Condition number of J M^-1 J^T, scaled to a unit diagonal; infinite if a row is redundant
  double condition;
  std::string text() const;  ///< Returns one line per redundant row
};

/// Finds redundant contact rows at the configuration `q` (nq). `active` holds the indices in `set`
/// of the contacts to examine; if it is empty, all contacts are examined.
///
/// A row is redundant if its part orthogonal to the rows before it is too short, in the metric
/// M^-1. The length limit is `tolerance` times a combination of two lengths: the row's own length,
/// and the largest motion that the joints could produce along the row at any posture
/// (src/contact/row_size.hpp). With the default tolerance, a row is redundant exactly if
/// ContactDynamics with rigid contacts (mu = 0) returns Status::SingularContacts. Throws Error for
/// an invalid q or a singular mass matrix.
ContactDiagnosis diagnose(const Model& model, const ContactSet& set,
                          const Eigen::Ref<const Eigen::VectorXd>& q,
                          const std::vector<int>& active = {},
                          double tolerance = independence_tolerance);

}  // namespace burnish
