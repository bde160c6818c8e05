// Which contact rows cannot be held independently, by name.
#pragma once

#include <string>
#include <vector>

#include "burnish/contact/contact_set.hpp"

namespace burnish {

/// A row of the contact Jacobian that depends on rows before it.
/// @described derivatives @result
struct RedundantRow {
  std::string contact;                  ///< name of the contact
  std::string direction;                ///< "x" ... "rz" in its reference
  int row;                              ///< index among all rows of the set
  bool immovable;                       ///< no joint moves it at this posture, but for rounding
  std::vector<std::string> implied_by;  ///< "contact/direction" of the rows that already hold it
  /// "contact 'pad_b', direction z: already held by pad_a/z", or that no joint moves it.
  std::string text() const;
};

/// What diagnose() found: no redundant rows means that the contacts are independent.
/// @described derivatives @result
struct ContactDiagnosis {
  std::vector<RedundantRow> redundant;
  double condition;          ///< of J M^-1 J^T scaled to a unit diagonal; infinite when redundant
  std::string text() const;  ///< one line per row
};

/// Examines the contacts of `set` that `active` names (all if empty) at the configuration q (nq).
/// A row counts as redundant when no more than `tolerance` of it is left beside the rows before it:
/// of its own length in the metric M^-1, or of what the joints could move along it, the lengths of
/// the robot being what they are (row_size.hpp). With the default tolerance the contacts are
/// independent exactly where rigid ones (mu = 0) are no Status::SingularContacts. Throws Error for
/// a bad q.
ContactDiagnosis diagnose(const Model& model, const ContactSet& set,
                          const Eigen::Ref<const Eigen::VectorXd>& q,
                          const std::vector<int>& active = {},
                          double tolerance = independence_tolerance);

}  // namespace burnish
