// The rows of contacts at one configuration, as their independence is judged by.
#pragma once

#include "burnish/derivatives/contact_dynamics.hpp"
#include "burnish/derivatives/diagnosis.hpp"

namespace burnish {

struct ContactRows {
  RowMatrix Y;  ///< J L^-1 with M = L L^T, so that Y Y^T = J M^-1 J^T; rows x nv
  /// Per row: squared, which part of what the joints could do along it they do at this posture.
  Eigen::VectorXd part;
};

/// Of all contacts of `dynamics`, which must be active, at q (nq). Throws Error where M is
/// singular, naming the joint.
ContactRows contact_rows(const Model& model, ContactDynamics& dynamics,
                         const Eigen::Ref<const Eigen::VectorXd>& q);

/// diagnose() of rows known already.
ContactDiagnosis diagnose_rows(const ContactSet& set, const ContactRows& rows,
                               const std::vector<int>& active, double tolerance);

/// Condition of J M^-1 J^T with its rows scaled to the part that `part` says, so that it is large
/// also where the joints hardly move along a row; infinite when redundant, 1 without rows.
double condition_by_reach(const ContactSet& set, const ContactRows& rows);

}  // namespace burnish
