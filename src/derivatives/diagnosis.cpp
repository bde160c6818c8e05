#include "burnish/derivatives/diagnosis.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/decomposition.hpp"
#include "burnish/dynamics/placement.hpp"
#include "burnish/model/state.hpp"
#include "derivatives/contact_rows.hpp"

namespace burnish {
ContactRows contact_rows(const Model& model, ContactDynamics& dynamics,
                         const Eigen::Ref<const Eigen::VectorXd>& q) {
  const Eigen::VectorXd rest = Eigen::VectorXd::Zero(model.nv);
  const Status status = dynamics.forward(q, rest, rest);
  if (status > Status::SingularContacts) throw Error("diagnose: " + dynamics.explanation());
  const RowMatrix J = dynamics.jacobian();
  ContactRows rows{solve_positive_half(dynamics.mass_matrix(), J.transpose()).transpose(),
                   Eigen::VectorXd(J.rows())};
  Eigen::Index r = 0;
  for (int c = 0; c < dynamics.contacts().size(); ++c) {
    const CompiledContact& contact = dynamics.contacts().contacts()[c];
    const ContactForce force = dynamics.force(c);
    const Vec3<double> p = from_eigen(force.tool_position), origin = from_eigen(force.origin());
    for (const int d : contact.directions) {
      rows.relative_size[r] =
          row_size(contact, d, J.row(r).data(), 1) / attainable_row_size(contact, d, p, origin);
      ++r;
    }
  }
  return rows;
}

namespace {

/// Gram-Schmidt orthogonalization, row by row. Each basis vector is also stored as a combination of
/// rows of Y. The combination shows which rows of Y imply a redundant row.
struct OrthogonalRows {
  std::vector<Eigen::VectorXd> basis;         ///< Orthonormal vectors
  std::vector<Eigen::VectorXd> combinations;  ///< Coefficients of the rows of Y, per vector
  std::vector<double> uncertain;  ///< Relative rounding error of |vector|^2 before normalization

  /// Subtracts from a row its projection onto the basis. Returns the rounding error that the
  /// squared length of the remainder has when computed as a pivot (delassus.hpp).
  double reduce(Eigen::VectorXd& row, Eigen::VectorXd& combination) const {
    double rounding = pivot_rounding * row.squaredNorm();
    // Two passes make the row orthogonal up to rounding.
    for (int pass = 0; pass < 2; ++pass)
      for (std::size_t b = 0; b < basis.size(); ++b) {
        const double projection = basis[b].dot(row);
        if (pass == 0) rounding += projection * projection * uncertain[b];
        row -= projection * basis[b];
        combination -= projection * combinations[b];
      }
    return rounding;
  }
};

/// Returns the condition number of Y Y^T for scaled rows. A largest eigenvalue below 1 counts as 1.
double condition_of(const Eigen::MatrixXd& Y) {
  const Eigen::VectorXd values = symmetric_eigen(Y * Y.transpose()).values;
  return std::max(1.0, values.maxCoeff()) / values.minCoeff();
}

}  // namespace

ContactDiagnosis diagnose(const Model& model, const ContactSet& set,
                          const Eigen::Ref<const Eigen::VectorXd>& q,
                          const std::vector<int>& active, double tolerance) {
  check_configuration(model, q);
  ContactDynamics dynamics(model, set.specs());
  return diagnose_rows(set, contact_rows(model, dynamics, q), active, tolerance);
}

ContactDiagnosis diagnose_rows(const ContactSet& set, const ContactRows& rows,
                               const std::vector<int>& active, double tolerance) {
  const RowMatrix& Y = rows.Y;
  const std::vector<std::string> names = set.row_names();
  const double min_fraction = tolerance * tolerance;
  ContactDiagnosis result{{}, 1.0};
  OrthogonalRows done;
  std::vector<int> examined;
  int row = 0;
  for (int c = 0; c < set.size(); ++c) {
    const CompiledContact& contact = set.contacts()[c];
    const bool is_wanted =
        active.empty() || std::find(active.begin(), active.end(), c) != active.end();
    for (const int d : contact.directions) {
      const int r = row++;
      if (!is_wanted) continue;
      examined.push_back(r);
      const double squared_norm = Y.row(r).squaredNorm();
      const double min_pivot = min_fraction * squared_norm * (1.0 + 1.0 / rows.relative_size[r]);
      const bool immovable = !(squared_norm > min_pivot + pivot_rounding * squared_norm);
      Eigen::VectorXd rest = Y.row(r).transpose();
      Eigen::VectorXd combination = Eigen::VectorXd::Unit(Y.rows(), r);
      const double rounding = done.reduce(rest, combination);
      if (!immovable && rest.squaredNorm() > min_pivot + rounding) {
        done.basis.emplace_back(rest / rest.norm());
        done.uncertain.push_back(rounding / rest.squaredNorm());
        done.combinations.emplace_back(combination / rest.norm());
        continue;
      }
      RedundantRow found{contact.spec.name, std::string(direction_names[d]), r, immovable, {}};
      for (int other = 0; !immovable && other < r; ++other)
        if (std::abs(combination[other]) * Y.row(other).norm() > 1e-6 * std::sqrt(squared_norm))
          found.implied_by.push_back(names[other]);
      result.redundant.push_back(found);
    }
  }
  if (!result.redundant.empty()) {
    result.condition = std::numeric_limits<double>::infinity();
  } else if (!examined.empty()) {
    Eigen::MatrixXd unit(static_cast<Eigen::Index>(examined.size()), Y.cols());
    for (std::size_t i = 0; i < examined.size(); ++i)
      unit.row(static_cast<Eigen::Index>(i)) = Y.row(examined[i]).normalized();
    result.condition = condition_of(unit);
  }
  return result;
}

double condition_by_reach(const ContactSet& set, const ContactRows& rows) {
  if (rows.Y.rows() == 0) return 1.0;
  if (!diagnose_rows(set, rows, {}, independence_tolerance).redundant.empty())
    return std::numeric_limits<double>::infinity();
  Eigen::MatrixXd scaled = rows.Y;
  for (Eigen::Index r = 0; r < scaled.rows(); ++r)
    scaled.row(r) *= std::sqrt(std::min(1.0, rows.relative_size[r])) / scaled.row(r).norm();
  return condition_of(scaled);
}

std::string RedundantRow::text() const {
  std::string sentence = "contact '" + contact + "', direction " + direction + ": ";
  if (immovable) return sentence + "no joint moves it at this posture";
  sentence += "already held by ";
  for (std::size_t i = 0; i < implied_by.size(); ++i)
    sentence += (i == 0 ? "" : ", ") + implied_by[i];
  return sentence;
}

std::string ContactDiagnosis::text() const {
  if (redundant.empty()) return "the contacts are independent\n";
  std::string lines;
  for (const RedundantRow& row : redundant) lines += row.text() + "\n";
  return lines;
}

}  // namespace burnish
